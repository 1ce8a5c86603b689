"""Where an axis will be once a delay has passed."""
