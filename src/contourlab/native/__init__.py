"""Machine code for other packages.

`kernel` marks a plain function that runs in machine code; `compile` makes it, with Numba; `store` keeps it on disk, keyed on its sources.
"""
