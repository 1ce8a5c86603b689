"""The parameters that the contour error depends on: one at a time, by small changes, and all at once."""
