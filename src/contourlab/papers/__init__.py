"""Reproductions of papers: one folder each, with the analysis and pictures that only it needs."""
