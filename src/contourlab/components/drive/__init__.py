"""Drives: what stands between a command and the plant: limits and delay."""
