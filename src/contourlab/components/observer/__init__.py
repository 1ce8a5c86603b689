"""Observers: estimates of what disturbs an axis."""
