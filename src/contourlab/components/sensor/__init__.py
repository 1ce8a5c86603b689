"""Sensors: the measured position of an axis."""
