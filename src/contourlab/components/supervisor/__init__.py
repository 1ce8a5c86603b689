"""Supervisors: choose the active controller of an axis."""
