"""Stability margins of the loops, and convergence of learning."""
