"""Observers: estimate the disturbance on an axis."""
