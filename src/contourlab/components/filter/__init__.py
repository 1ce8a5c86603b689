"""Filters of an axis' command, between its controller and its drive."""
