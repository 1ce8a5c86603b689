"""Feedforward: additions to an axis' reference or command, from the reference alone."""
