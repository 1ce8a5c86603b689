"""The command's entry: an interrupt is one line even while modules are still being read."""

from __future__ import annotations

import sys
from typing import NoReturn

__all__ = ["run"]


def run() -> NoReturn:
    """Run the command line and leave the process with its exit code."""
    try:
        from contourlab.cli.main import main

        code = main()
    except KeyboardInterrupt:
        print("contourlab: interrupted", file=sys.stderr)
        code = 130
    sys.exit(code)


if __name__ == "__main__":
    run()
