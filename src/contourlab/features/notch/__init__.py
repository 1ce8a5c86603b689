"""A notch filter for the structural resonance of each axis that needs one."""
