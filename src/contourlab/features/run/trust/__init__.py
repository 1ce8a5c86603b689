"""How far can the figures be trusted: sources of the numbers, and the interval that their deviations imply."""
