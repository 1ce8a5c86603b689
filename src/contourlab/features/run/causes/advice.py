"""The changes of controller and planning that reduce the largest part error most; each is simulated."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np

from contourlab.errors import ContourlabError
from contourlab.features.run.causes.causes import Rerun
from contourlab.features.run.causes.remedies import remedies
from contourlab.feed import Reference
from contourlab.findings import Finding, finding
from contourlab.loop import Controller, Machine, simulate
from contourlab.metrics import judge, judged_part
from contourlab.result import Result
from contourlab.threads import in_threads

MOST_CHANGES = 3
"""Changes on top of each other."""
HELPS = 0.99
"""A change helps if it leaves less than this share of the error."""
WIDTH = 2
"""The best so many combinations are changed further: the best change alone may hide a better pair."""


@dataclass(frozen=True, eq=False)
class Trial:
    """What ran: the changes made, the controller, the reference, and the largest part error [m]."""

    changes: tuple[str, ...]
    controller: Controller
    reference: Reference
    worst: float


def judged_run(machine: Machine, controller: Controller, reference: Reference, rerun: Rerun = simulate) -> tuple[Result, int]:
    """Run and judge, keeping few signals; return the result and the sample of the largest part error."""
    run = rerun(machine, controller, reference, signals=("tool_position", "reference", "arc_length", "reference_velocity"))
    judged = judge(run, reference)
    samples = judged_part(judged, reference).samples
    return judged, int(samples[np.abs(judged["part_error"][samples]).argmax()])


def advice(
    machine: Machine,
    start: Trial,
    tolerance: float,
    plans: Mapping[str, Callable[[], Reference]] | None = None,
    rerun: Rerun = simulate,
    closer: Mapping[str, Callable[[], Reference]] | None = None,
) -> Trial:
    """Return the run after the changes that help most, at most three besides a closer plan; the start itself if none helps.

    Parameters
    ----------
    machine : Machine
    start : Trial
        The run to improve.
    tolerance : float [m]
        A further change is tried only if more is left.
    plans : mapping, optional
        Other ways to plan, by name.
    rerun : callable, optional
        `contourlab.loop.simulate` with the options of the run.
    closer : mapping, optional
        Ways to plan of which one comes first, because the present plan takes much of the tolerance.
    """
    frontier = [start]
    if closer:
        frontier = sorted(_trials(machine, start, closer, {}, rerun), key=_worst)[:WIDTH] or frontier
    best, planned = min(frontier, key=_worst), [trial.reference for trial in frontier]
    for _ in range(MOST_CHANGES):
        if best.worst <= tolerance:
            break
        tried: list[Trial] = []
        for before in frontier:
            # A motion is planned anew only once.
            ways = plans or {} if any(before.reference is one for one in planned) else {}
            trials = _trials(machine, before, ways, dict(remedies(machine, before.controller)), rerun)
            tried += [trial for trial in trials if trial.worst < HELPS * before.worst]
        if not tried:
            break
        frontier = sorted(tried, key=_worst)[:WIDTH]
        best = min(best, frontier[0], key=_worst)
    return best if best.worst < start.worst else start


def _worst(trial: Trial) -> float:
    return trial.worst


def _trials(
    machine: Machine, before: Trial, plans: Mapping[str, Callable[[], Reference]], controllers: Mapping[str, Controller], rerun: Rerun
) -> list[Trial]:
    """Run each change on top of those made before; leave out those that diverge or cannot be planned."""

    def attempt(change: tuple[str, Controller, Callable[[], Reference]]) -> Trial | None:
        name, controller, plan = change
        with suppress(ContourlabError):
            reference = plan()
            judged, sample = judged_run(machine, controller, reference, rerun)
            return Trial((*before.changes, name), controller, reference, float(abs(judged["part_error"][sample])))
        return None

    changes = [(name, before.controller, plan) for name, plan in plans.items()]
    changes += [(name, changed, lambda: before.reference) for name, changed in controllers.items()]
    return [trial for trial in in_threads(attempt, changes) if trial is not None]


def proposal(start: Trial, best: Trial) -> Finding:
    """Return the finding that proposes the changes."""
    times: dict[str, Any] = {"time_before": start.reference.duration, "time_after": best.reference.duration}
    return finding("CL203", change=", then ".join(best.changes), before=start.worst, after=best.worst, **times)
