"""The backlash of each axis, and the best compensation."""
