"""Does the controller still hold when an axis is swapped, and which gains must move with the axis?"""
