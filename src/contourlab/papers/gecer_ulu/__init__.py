"""Gecer Ulu, Ulu & Cakmakci: learning cross-coupled control."""
