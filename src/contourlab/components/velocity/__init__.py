"""The velocity that the controller sees."""
