"""Two measured contouring runs of an XY table beside their simulation."""
