"""Machine code for other packages.

`kernel` marks a plain function that runs in machine code; `compile` (Numba) and `llvm` make it; `store` keeps it on disk, keyed on its
sources.
"""
