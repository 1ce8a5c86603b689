"""Predictors: the position of an axis after a transport delay."""
