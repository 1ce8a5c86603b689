"""What each model of `identify` asks of its logs and options."""
