"""Supervisors: which of an axis' controllers is active."""
