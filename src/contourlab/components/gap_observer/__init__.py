"""Observers of the backlash gap from the motor side."""
