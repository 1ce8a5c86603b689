"""Couplings: feedback of the estimated contour error."""
