"""What is added to the reference or the command of an axis, from the reference alone."""
