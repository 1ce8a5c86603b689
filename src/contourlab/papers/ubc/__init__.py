"""Two measured contouring runs of an XY table, compared with simulations."""
