"""summary.json: one object per scheme, in SI; the schema is documented in docs/summary-schema.md."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from contourlab import __version__
from contourlab.app.json_values import json_values
from contourlab.errors import DivergenceError
from contourlab.features.learn import LearningRun
from contourlab.features.run.compare import Outcome
from contourlab.features.run.trust import told_of
from contourlab.feed.verify import LimitReport
from contourlab.loop.switches import Switches, SwitchKind
from contourlab.metrics import reversal_figures
from contourlab.metrics.circles import pairs
from contourlab.report.page_tables import nearest

SCHEMA = "contourlab-summary/1"
LISTED = 100
"""Switches that are listed one by one."""


def summary_of(
    name: str, outcomes: Sequence[Outcome], command: str, runaways: Mapping[str, DivergenceError] | None = None
) -> dict[str, Any]:
    """Return the summary of a session: plain values, no number that JSON cannot hold.

    Parameters
    ----------
    name : str
        Of the scenario.
    outcomes : sequence of Outcome
    command : str
        What was run.
    runaways : mapping of str to DivergenceError, optional
        Schemes that ran away: only their status is told, and the whole has not passed.
    """
    lost = runaways or {}
    verdicts = [outcome.verdict for outcome in outcomes if outcome.verdict is not None]
    found: dict[str, Any] = {
        "schema": SCHEMA,
        "version": __version__,
        "name": name,
        "command": command,
        "notes": list(outcomes[0].case.notes) if outcomes else [],
        "passed": False if lost else all(v.passed for v in verdicts) if verdicts else None,
        "schemes": {outcome.name: _scheme(outcome) for outcome in outcomes}
        | {name: {"status": {"ok": False, "sample": e.sample, "axis": e.axis, "reason": str(e)}} for name, e in lost.items()},
    }
    told: dict[str, Any] = json_values(found)
    return told


def _scheme(outcome: Outcome) -> dict[str, Any]:
    result, case = outcome.result, outcome.case
    return {
        "machine": case.machine.name,
        "axes": list(result.axes),
        "servo_period": result.servo_period,
        "seed": case.seed,
        "n_sample": result.n_sample,
        "path_digest": outcome.reference.path.digest,
        "status": asdict(result.status),
        "metrics": outcome.metrics.as_dict(),
        "verdict": asdict(outcome.verdict) if outcome.verdict else None,
        "circles": [{"name": c.name, "clockwise": c.clockwise, "radius": c.radius, **c.figures()} for c in outcome.circles],
        "circles_both_ways": {name: asdict(both) for name, both in pairs(outcome.circles).items()},
        "reversals": [asdict(spike) for spike in outcome.spikes],
        "reversal_figures": [asdict(figures) for figures in reversal_figures(outcome.spikes)],
        "switches": _switches(outcome.switches) if outcome.switches is not None else None,
        "margins": {axis: asdict(bode.margins) for axis, bode in outcome.bode.items()},
        "limits": _limits(outcome.limits, result.axes) if outcome.limits else None,
        "learning": _learning(outcome.learning) if outcome.learning else None,
        "warnings": list(outcome.warnings),
        "tick": outcome.tick,
        "trust": told_of(outcome),
    }


def _learning(run: LearningRun) -> dict[str, Any]:
    """Return how learning went, with the figures of each trial."""
    return {
        "status": run.status,
        "reason": run.reason,
        "best_trial": run.best,
        "gain": run.gain,
        "trials": [asdict(trial) for trial in run.trials],
        "split": asdict(run.split) if run.split else None,
    }


def _switches(switches: Switches) -> dict[str, Any]:
    """Return how often and why controllers were switched, and the first switches one by one."""
    counts = switches.counts()
    columns = (switches.kind, switches.sample, switches.time, switches.arc_length, switches.line)
    first = zip(*(column[:LISTED].tolist() for column in columns), strict=True)
    return {
        "axes": {
            axis: {
                "count": sum(count for kind, count in counts.items() if kind.axis == axis),
                "first": switches.first[axis],
                "active": {name: held * switches.servo_period for name, held in switches.active[axis].items()},
                "kinds": [
                    {"from": kind.before, "to": kind.after, "reason": kind.reason, "count": count}
                    for kind, count in counts.items()
                    if kind.axis == axis
                ],
            }
            for axis in switches.axes
        },
        "listed": [_switch(switches.kinds[kind], *place) for kind, *place in first],
        "left_out": max(len(switches) - LISTED, 0),
    }


def _switch(kind: SwitchKind, sample: int, time: float, along: float, line: int) -> dict[str, Any]:
    words = {"axis": kind.axis, "from": kind.before, "to": kind.after, "reason": kind.reason}
    return {"time": time, "sample": sample, **words, "arc_length": along, "line": line}


def _limits(report: LimitReport, axes: Sequence[str]) -> dict[str, Any]:
    """Return the axis that comes nearest to its limit, for each kind of limit; None where there was nothing of the kind."""
    found: dict[str, Any] = {}
    for kind in ("velocity", "acceleration", "jerk", "curvature_step", "kink"):
        worst = nearest(getattr(report, kind))
        found[kind] = worst and {
            "axis": axes[worst.axis],
            "value": worst.value,
            "limit": worst.limit,
            "ratio": worst.ratio,
            "time": worst.time,
            "line": worst.source_line,
        }
    return found
