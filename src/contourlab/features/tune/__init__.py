"""Calibration: the gains that minimise the contour error within margins and drive limits."""
