"""Correct a part program by the contour error that repeats."""
