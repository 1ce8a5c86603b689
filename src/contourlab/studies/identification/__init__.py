"""Models of an axis found from measured logs: one study a file, from signals to figures, pictures and the tables of an axis file."""
