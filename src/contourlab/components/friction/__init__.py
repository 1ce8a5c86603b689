"""Frictions: what resists the motion of a plant."""
