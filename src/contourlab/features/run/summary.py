"""summary.json: one object per scheme, in SI; docs/summary-schema.md describes it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from contourlab import __version__
from contourlab.app.json_values import json_values
from contourlab.errors import DivergenceError
from contourlab.features.run.outcome import Outcome
from contourlab.feed.verify import LimitReport
from contourlab.loop.switches import Switches
from contourlab.metrics import reversal_figures
from contourlab.metrics.circles import pairs
from contourlab.report.page_tables import nearest

SCHEMA = "contourlab-summary/1"
LISTED = 100
"""Switches that are listed one by one."""


def summary_of(
    name: str, outcomes: Sequence[Outcome], command: str, diverged: Mapping[str, DivergenceError] | None = None
) -> dict[str, Any]:
    """Return the summary of a session as JSON values.

    Parameters
    ----------
    name : str
        Of the scenario.
    outcomes : sequence of Outcome
    command : str
        What was run.
    diverged : mapping of str to DivergenceError, optional
        Schemes that diverged: the summary has their status only, and has not passed.
    """
    lost = diverged or {}
    verdicts = [outcome.verdict for outcome in outcomes if outcome.verdict is not None]
    summary: dict[str, Any] = json_values({
        "schema": SCHEMA,
        "version": __version__,
        "name": name,
        "command": command,
        "notes": outcomes[0].case.notes if outcomes else (),
        "passed": False if lost else all(v.passed for v in verdicts) if verdicts else None,
        "schemes": {outcome.name: _scheme(outcome) for outcome in outcomes}
        | {name: {"status": {"ok": False, "sample": e.sample, "axis": e.axis, "reason": str(e)}} for name, e in lost.items()},
    })  # fmt: skip
    return summary


def _scheme(outcome: Outcome) -> dict[str, Any]:
    result, case, learning = outcome.result, outcome.case, outcome.learning
    return {
        "machine": case.machine.name,
        "axes": result.axes,
        "servo_period": result.servo_period,
        "seed": case.seed,
        "n_sample": result.n_sample,
        "path_digest": outcome.reference.path.digest,
        "status": result.status,
        "metrics": outcome.metrics.as_dict(),
        "verdict": outcome.verdict,
        "circles": [{"name": c.name, "clockwise": c.clockwise, "radius": c.radius, **c.figures()} for c in outcome.circles],
        "circles_both_ways": pairs(outcome.circles),
        "reversals": outcome.spikes,
        "reversal_figures": reversal_figures(outcome.spikes),
        "switches": _switches(outcome.switches) if outcome.switches is not None else None,
        "margins": {axis: bode.margins for axis, bode in outcome.bode.items()},
        "limits": _limits(outcome.limits, result.axes) if outcome.limits else None,
        "learning": learning
        and {
            "status": learning.status,
            "reason": learning.reason,
            "best_trial": learning.best,
            "gain": learning.gain,
            "trials": learning.trials,
            "split": learning.split,
        },
        "warnings": [finding.text for finding in outcome.findings if finding.entry.severity == "warning"],
        "findings": outcome.findings,
        "tick": outcome.tick,
        "trust": outcome.trust,
    }


def _switches(switches: Switches) -> dict[str, Any]:
    """Return how often and why controllers were switched, and the first switches one by one."""
    kinds = [{"axis": kind.axis, "from": kind.before, "to": kind.after, "reason": kind.reason} for kind in switches.kinds]
    counts = {axis: [] for axis in switches.axes}  # type: dict[str, list[dict[str, Any]]]
    for kind, count in switches.counts().items():
        counts[kind.axis].append({"from": kind.before, "to": kind.after, "reason": kind.reason, "count": count})
    columns = (switches.kind, switches.time, switches.sample, switches.arc_length, switches.line)
    first = zip(*(column[:LISTED].tolist() for column in columns), strict=True)
    return {
        "axes": {
            axis: {
                "count": sum(kind["count"] for kind in counts[axis]),
                "first": switches.first[axis],
                "active": {name: held * switches.servo_period for name, held in switches.active[axis].items()},
                "kinds": counts[axis],
            }
            for axis in switches.axes
        },
        "listed": [
            {"time": time, "sample": sample, **kinds[kind], "arc_length": along, "line": line} for kind, time, sample, along, line in first
        ],
        "left_out": max(len(switches) - LISTED, 0),
    }


def _limits(report: LimitReport, axes: Sequence[str]) -> dict[str, Any]:
    """Return for each kind of limit the axis that comes nearest to it; None where the motion has nothing of the kind."""
    limits: dict[str, Any] = {}
    for kind in ("velocity", "acceleration", "jerk", "curvature_step", "kink"):
        worst = nearest(getattr(report, kind))
        if worst is not None:
            values = {name: getattr(worst, name) for name in ("value", "limit", "ratio", "time")}
            worst_values = {"axis": axes[worst.axis], **values, "line": worst.source_line}
        limits[kind] = None if worst is None else worst_values
    return limits
