"""Metrics: figures of a run from positions and the path alone, without knowledge of the controller."""
