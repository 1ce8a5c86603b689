"""Fits of axis models to measured signals, with covariances."""
