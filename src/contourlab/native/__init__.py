"""Machine code for the rooms above.

`store` keeps machine code on disk, keyed on its sources. `compile` compiles a plain function through it. Only these two import Numba, so
that a room that needs a kernel imports them late.
"""
