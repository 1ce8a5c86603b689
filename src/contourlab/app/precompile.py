"""Compile the kernels of planner, sampler and judge, which every run needs; `make` calls it, so that the first run need not.

Without it they are compiled when first used, in about four seconds.
"""

from __future__ import annotations


def precompile() -> None:
    """Compile what does not depend on the machine; a second call finds it in the cache."""
    from contourlab.engine import sampler
    from contourlab.feed import scurve, smooth
    from contourlab.geometry import blend, broad_phase, table, thinning

    sampler.compiled_kernels()
    scurve.compiled_kernels()
    smooth.compiled_kernels()
    blend.compiled_kernel()
    broad_phase.compiled_kernel()
    table.compiled_kernel()
    thinning.compiled_kernel()


if __name__ == "__main__":
    precompile()
