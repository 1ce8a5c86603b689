"""Machine code for other packages.

`store` keeps machine code on disk, keyed on its sources. `compile` compiles a plain function through it. Both import Numba, so a package
that needs a kernel imports them late.
"""
