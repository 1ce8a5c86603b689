"""Shahin, ElMaraghy & ElBeheiry: feed drives with backlash, and the supervisor that switches their controllers."""
