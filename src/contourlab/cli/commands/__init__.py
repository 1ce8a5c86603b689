"""The commands, one file each: arguments, one call, what is printed. Heavy imports stand inside the functions."""
