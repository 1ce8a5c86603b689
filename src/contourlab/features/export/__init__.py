"""``contourlab export``: the controller of an axis as code for a control."""
