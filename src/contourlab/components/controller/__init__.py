"""Controllers of one axis."""
