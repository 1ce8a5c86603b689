"""Is a part program free of faults, and which moves does it make?"""
