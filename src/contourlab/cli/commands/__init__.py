"""The commands, one file each: parse, call, print. Functions import heavy libraries locally."""
