"""Couplings: what is done with the contour error that an estimator finds."""
