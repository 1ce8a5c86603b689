"""Which gains make the contour error least, within margins and drive limits?"""
