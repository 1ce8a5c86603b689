"""Which parameters does the contour error depend on: one at a time, by small changes, and all at once?"""
