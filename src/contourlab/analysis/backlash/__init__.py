"""Loops with backlash: limit cycles, exact simulation and periodic orbits."""
