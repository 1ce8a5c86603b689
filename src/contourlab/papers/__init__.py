"""Reproductions of papers: one folder each, with its own analysis and pictures."""
