"""Disturbances: forces on an axis that are not friction."""
