"""Compile the kernels of planner, sampler, judge and linear models, so that a first run or study need not; `make` calls it.

Without it they are compiled when first used, in about twelve seconds.
"""

from __future__ import annotations


def precompile() -> None:
    """Compile what does not depend on the machine; a second call finds it in the cache."""
    from contourlab.analysis.linear import tick_map  # noqa: F401  importing a module lists its kernels
    from contourlab.engine import sampler
    from contourlab.feed import planner  # noqa: F401
    from contourlab.geometry import clearance, foot_point, table, thinning  # noqa: F401
    from contourlab.native.kernel import KERNELS

    sampler.compiled_kernels()
    for kernel in KERNELS:
        kernel.compiled  # noqa: B018  compiled when first read


if __name__ == "__main__":
    precompile()
