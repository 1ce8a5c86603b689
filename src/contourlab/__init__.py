"""contourlab: precision contouring of multi-axis machines."""
