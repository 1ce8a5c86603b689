"""Sensors: what the controller sees of an axis' position."""
