"""Ghaffari & Ulsoy: component swapping modularity for distributed precision contouring."""
