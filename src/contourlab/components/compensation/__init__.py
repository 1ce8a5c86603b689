"""Backlash compensation: additions to the reference or the command at reversals."""
