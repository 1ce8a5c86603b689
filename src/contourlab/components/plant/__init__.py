"""Plants: what the drive moves."""
