"""Friction laws of plants."""
