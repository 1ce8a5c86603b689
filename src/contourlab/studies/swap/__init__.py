"""Does a controller still hold when an axis is swapped, and which of its numbers would have to move with the axis?"""
