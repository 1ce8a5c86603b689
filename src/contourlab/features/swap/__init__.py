"""Swapped axes: whether one controller holds, and which gains must move with the axis."""
