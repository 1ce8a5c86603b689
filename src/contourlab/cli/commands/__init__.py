"""The commands, one file each: parse, call, print. Functions import heavy libraries where they use them."""
