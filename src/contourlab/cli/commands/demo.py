"""``contourlab demo``: the first minute with contourlab."""

from __future__ import annotations

from pathlib import Path

from contourlab.cli import options as shared
from contourlab.cli.output import conclude, wants_progress


def demo(
    out: shared.Out = Path("results/demo"),
    as_json: shared.Json = False,
    interval: shared.WithInterval = None,
) -> int:
    """Run a shipped part on a shipped machine under several controllers, and compare them."""
    from contourlab.features.run.demo import run_demo

    outcome = run_demo(out, progress=wants_progress(as_json), interval=interval)
    return conclude(outcome, as_json)
