"""On-line estimators of the contour error."""
