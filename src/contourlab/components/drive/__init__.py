"""Drives: limits and delay between command and plant."""
