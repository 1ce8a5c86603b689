"""Velocity from what the sensor gives."""
