"""Entry of the command: an interrupt prints one line, even during imports."""

from __future__ import annotations

import os
import sys
from typing import NoReturn

LINEAR_ALGEBRA = ("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")
"""Environment variables from which NumPy's linear algebra libraries read their number of threads, once, when loaded."""


def run() -> NoReturn:
    """Run the command line and leave the process with its exit code.

    Linear algebra uses one thread by default. More threads slow small matrices down, and rounding would depend on their number.
    """
    for name in LINEAR_ALGEBRA:
        os.environ.setdefault(name, "1")
    try:
        from contourlab.cli.main import main

        code = main()
    except KeyboardInterrupt:
        print("contourlab: interrupted: no result is kept", file=sys.stderr)
        code = 130
    sys.exit(code)


if __name__ == "__main__":
    run()
