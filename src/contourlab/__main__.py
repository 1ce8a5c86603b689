"""The command's entry: an interrupt is one line even while modules are still being read."""

from __future__ import annotations

import os
import sys
from typing import NoReturn

LINEAR_ALGEBRA = ("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")
"""Where the libraries under NumPy read how many threads to take, once, when they are loaded."""


def run() -> NoReturn:
    """Run the command line and leave the process with its exit code.

    Linear algebra has one thread, unless the environment says otherwise: with more, small matrices wait for them, and sums are rounded by
    their number.
    """
    for name in LINEAR_ALGEBRA:
        os.environ.setdefault(name, "1")
    try:
        from contourlab.cli.main import main

        code = main()
    except KeyboardInterrupt:
        print("contourlab: interrupted", file=sys.stderr)
        code = 130
    sys.exit(code)


if __name__ == "__main__":
    run()
