"""Quadrature signals of an encoder: correction, tracking and interpolation."""
