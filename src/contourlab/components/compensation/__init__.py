"""Backlash compensation: what is added to the reference or the command where the axis reverses."""
