"""``contourlab demo``: the first minute with contourlab."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli.output import conclude, wants_progress

__all__ = ["demo"]


def demo(
    out: Annotated[Path, typer.Option(help="Folder for the results; made if it is not there.")] = Path("results/demo"),
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON alone on standard output.")] = False,
) -> int:
    """Run a shipped part on a shipped machine under several controllers, and compare them."""
    from contourlab.session.demo import run_demo

    outcome = run_demo(out, progress=wants_progress(as_json))
    return conclude(outcome, as_json)
