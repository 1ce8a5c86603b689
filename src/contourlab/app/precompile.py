"""Compile the kernels of planner, sampler, judge and linear models, so that a first run or study need not; `make` calls it.

What takes Numba seconds is kept in the package itself, for wheels too: LLVM turns it into machine code in a second. Without it kernels are
compiled when first used, in about twelve seconds.
"""

from __future__ import annotations

import shutil
import zlib


def precompile(*, keep: bool = False) -> None:
    """Compile what does not depend on the machine; a second call finds it in the cache. `keep` renews what the package has."""
    from contourlab.analysis.linear import tick_map  # noqa: F401  importing a module lists its kernels
    from contourlab.engine import sampler  # noqa: F401
    from contourlab.feed import planner  # noqa: F401
    from contourlab.geometry import clearance, foot_point, table, thinning  # noqa: F401
    from contourlab.native.kernel import KEPT, KERNELS

    found = {kernel.key: kernel.lowered for kernel in KERNELS} if keep else {}
    if keep:
        shutil.rmtree(KEPT, ignore_errors=True)
        KEPT.mkdir()
    for key, code in found.items():
        (KEPT / key).write_bytes(zlib.compress(code, 9))
    for kernel in KERNELS:
        kernel.compiled  # noqa: B018  compiled when first read


if __name__ == "__main__":
    precompile(keep=True)
