"""The types of what the commands print with ``--json``."""

from __future__ import annotations

from pathlib import Path
from typing import Any


def results() -> dict[str, Any]:
    """Return the type of the result of each command that has ``--json``."""
    from contourlab.features.analyse.command import Analysis
    from contourlab.features.backlash.command import BacklashOutcome
    from contourlab.features.check.canon import Canon
    from contourlab.features.check.program_check import Checked
    from contourlab.features.circle.command import CircleTest
    from contourlab.features.commission.command import Commissioned
    from contourlab.features.components.description import ComponentDescription
    from contourlab.features.export.command import Exported
    from contourlab.features.identify.result import Identification
    from contourlab.features.interpolate.command import Interpolated
    from contourlab.features.limits.command import LimitTest
    from contourlab.features.link.result import LinkResult
    from contourlab.features.machines.command import Shipped
    from contourlab.features.measure.command import MeasuredRuns
    from contourlab.features.notch.command import Notched
    from contourlab.features.precompensate.result import Precompensated
    from contourlab.features.refine.command import Refinement
    from contourlab.features.run.command import Runs
    from contourlab.features.run.demo import Demonstration
    from contourlab.features.sensitivity.command import Sensitivity
    from contourlab.features.swap.report import SwapResult
    from contourlab.features.sweep.command import Search, SweepSummary
    from contourlab.features.sweep.query import Export
    from contourlab.features.sweep.report import SweepReport
    from contourlab.features.tune.command import Calibration
    from contourlab.findings import Entry
    from contourlab.papers.rows import Row

    return {
        "analyse": Analysis,
        "backlash": BacklashOutcome,
        "canon": Canon,
        "check": Checked,
        "circle": CircleTest,
        "commission": Commissioned,
        "compare": Runs | MeasuredRuns,
        "components": tuple[ComponentDescription, ...],
        "demo": Demonstration,
        "explain": tuple[Entry, ...],
        "export": Exported,
        "identify": Identification,
        "interpolate": Interpolated,
        "learn": Runs,
        "limits": LimitTest,
        "link": LinkResult,
        "machines": Shipped | tuple[Shipped, ...] | tuple[Path, ...],
        "measure": MeasuredRuns,
        "notch": Notched,
        "precompensate": Precompensated,
        "refine": Refinement,
        "reproduce": tuple[Row, ...],
        "run": Runs,
        "sensitivity": Sensitivity,
        "swap": SwapResult,
        "sweep": SweepSummary | SweepReport | Search | Export | Runs | tuple[dict[str, Any], ...],
        "tune": Calibration,
    }
