"""Integrators of plants with friction, contact and lag."""
