"""Services that features share: folders of results, checkpoints, progress, JSON."""
