"""The verdict against a tolerance: pass or fail, the worst place, its causes, and the changes that help most."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from operator import attrgetter
from typing import Any

import numpy as np

from contourlab.errors import ContourlabError
from contourlab.features.run.causes import WOULD_HELP, Rerun, causes
from contourlab.features.run.lost_steps import lost_steps
from contourlab.features.run.record import simulate_stored
from contourlab.features.run.remedies import remedies
from contourlab.feed import Reference
from contourlab.feed.reference import Judged
from contourlab.findings import finding
from contourlab.loop import Controller, Machine
from contourlab.loop.simulate import diverged
from contourlab.metrics.figures import blocks_of, judged_part, largest, left_out
from contourlab.metrics.judge import judge
from contourlab.rendering.judgement import FEED, Change, Verdict, Worst
from contourlab.result import Result
from contourlab.threads import in_threads

SHARE, LARGE = 0.25, 0.5
"""Share of the tolerance for planning that leaves the rest to the servo loops, and share above which a closer plan comes first."""
MOST_CHANGES = 3
"""Changes on top of each other."""
HELPS = 0.99
"""A change helps if it leaves less than this share of the error."""
WIDTH = 2
"""The best so many combinations are changed further: the best change alone may hide a better pair."""


def verdict(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    judged: Result,
    tolerance: float,
    *,
    lines: tuple[str, ...] = (),
    slower: Callable[[float], Reference] | None = None,
    closer: Callable[[float], Mapping[str, Callable[[], Reference]]] | None = None,
    explain: bool = True,
    rerun: Rerun = simulate_stored,
) -> Verdict:
    """Return the verdict on a judged run.

    Parameters
    ----------
    machine : Machine
    controller : Controller
    reference : Reference
    judged : Result
        The run, with the judge's signals.
    tolerance : float [m], > 0
        Largest part error that passes.
    lines : tuple of str
        Source text of the program.
    slower : callable, optional
        Returns the reference at a scaled feed, for the advice.
    closer : callable, optional
        Returns ways to plan closer to the programmed path, by name; tried where planning takes a notable part of the tolerance.
    explain : bool
        Whether to find the causes (about ten more runs), and advice where the verdict fails (about twenty).
    rerun : callable, optional
        `simulate_stored` with the options of the run.

    Returns
    -------
    Verdict
    """
    plain, lost = unexplained(reference, judged, tolerance, lines), lost_steps(machine, reference, judged)
    if lost:  # the error says nothing else
        return replace(plain, passed=False, findings=(*lost, *plain.findings))
    sample, findings = plain.worst.sample, list(plain.findings)
    # The error of a tool that skips part of the path says nothing about causes.
    if not explain or (plain.left_out and plain.worst.value <= tolerance):
        return plain
    planned = _planned(reference, judged)[0]
    ranked, diverging = causes(machine, controller, reference, judged, sample, rerun)
    if diverging:
        findings.append(finding("CL202", causes=diverging))
    if plain.passed:
        return replace(plain, causes=ranked, findings=tuple(findings))
    plans: dict[str, Callable[[], Reference]] = {} if slower is None else {FEED: partial(slower, 0.8)}
    near = closer(SHARE * tolerance) if closer is not None and planned > SHARE * tolerance else {}
    start = Trial((), controller, reference, plain.worst.value)
    if planned > LARGE * tolerance:
        best, tried = advice(machine, start, tolerance, plans, rerun, near)
    else:
        best, tried = advice(machine, start, tolerance, {**plans, **near}, rerun)
    if best is not start:
        times: dict[str, Any] = {"time_before": start.reference.duration, "time_after": best.reference.duration}
        findings.append(finding("CL203", change=", then ".join(best.changes), before=start.worst, after=best.worst, **times))
    if best.worst > tolerance:
        last = machine, best.controller, best.reference
        left = ranked if best is start else causes(*last, *judged_run(*last, rerun), rerun)[0]
        cause = max(left, key=lambda one: one.contribution)
        findings.append(finding("CL204", tolerance=tolerance, cause=cause.name, left=cause.contribution, help=WOULD_HELP[cause.name]))
    proposed = None if best.controller is controller else best.controller
    changes = tuple(Change(trial.changes[0], trial.worst, trial.reference.duration - reference.duration) for trial in tried)
    return replace(plain, causes=ranked, findings=tuple(findings), proposed=proposed, changes=changes)


def unexplained(reference: Reference, judged: Result, tolerance: float, lines: tuple[str, ...] = (), *, is_whole: bool = True) -> Verdict:
    """Return the verdict on a judged run without causes and advice; arguments as for `verdict`.

    Only a whole run tells what the tool skips: one that lags has not arrived where a log, or a cut of it, ends.
    """
    part = judged_part(judged, reference)
    worst = _place(judged, reference, largest(judged, "part_error", part)[1], lines)
    longest, at_end = left_out(judged, reference, part)
    *others, (start, stop) = part.ranges
    step = 0.0
    for cut in blocks_of(Judged((*others, (start, stop - 1)), part.basis)):
        asked = reference.programmed_arc_length(judged["arc_length"][cut[0] : cut[-1] + 2])
        step = max(step, 3.0 * float(np.abs(np.diff(asked))[cut - cut[0]].max()))
    # At a sharp corner a tool within the tolerance may skip several times as much, but not at the end.
    skipped = longest if longest > max(10.0 * tolerance, step) else at_end if at_end > max(2.0 * tolerance, step) else 0.0
    planned, line = _planned(reference, judged)
    skipped = skipped if is_whole else 0.0
    findings = [finding("CL201", length=skipped)] if skipped else []
    if planned > tolerance:
        findings.append(finding("CL208", deviation=planned, line=line, tolerance=tolerance))
    return Verdict(worst.value <= tolerance and not skipped, tolerance, worst, (), skipped, tuple(findings))


def _planned(reference: Reference, judged: Result) -> tuple[float, int]:
    """Return the largest planning deviation [m] of the judged samples, and its program line."""
    off, sample = largest(judged, "planning_deviation", judged_part(judged, reference))
    return off, int(reference.source_line(judged["arc_length"][sample][None])[0])


def _place(judged: Result, reference: Reference, sample: int, lines: tuple[str, ...]) -> Worst:
    along = float(judged["arc_length"][sample])
    line = int(reference.source_line(np.array([along]))[0])
    text = lines[line - 1].strip() if 0 < line <= len(lines) else ""
    position = tuple(float(v) for v in judged["tool_position"][sample])
    return Worst(float(abs(judged["part_error"][sample])), sample, sample * judged.servo_period, position, along, line, text)


@dataclass(frozen=True, eq=False)
class Trial:
    """What ran: the changes made, the controller, the reference, and the largest part error [m]."""

    changes: tuple[str, ...]
    controller: Controller
    reference: Reference
    worst: float


def judged_run(machine: Machine, controller: Controller, reference: Reference, rerun: Rerun = simulate_stored) -> tuple[Result, int]:
    """Run and judge, keeping few signals; return the result and the sample of the largest part error."""
    run = rerun(machine, controller, reference, signals=("tool_position", "reference", "arc_length", "reference_velocity"))
    if not run.status.ok:
        raise diverged(run)
    motion = run.motion or reference  # where the loop decides the progress, what it has followed
    judged = judge(run, motion)
    return judged, largest(judged, "part_error", judged_part(judged, motion))[1]


def advice(
    machine: Machine,
    start: Trial,
    tolerance: float,
    plans: Mapping[str, Callable[[], Reference]] | None = None,
    rerun: Rerun = simulate_stored,
    closer: Mapping[str, Callable[[], Reference]] | None = None,
) -> tuple[Trial, list[Trial]]:
    """Return the run after the changes that help most, at most three besides a closer plan, and the runs after one change that help.

    The first is the start itself if none helps; the others begin with the best.

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
        `simulate_stored` with the options of the run.
    closer : mapping, optional
        Ways to plan of which one comes first, because the present plan takes much of the tolerance.
    """
    frontier = [start]
    if closer:
        frontier = sorted(_trials(machine, start, closer, {}, rerun), key=attrgetter("worst"))[:WIDTH] or frontier
    best, planned = min(frontier, key=attrgetter("worst")), [trial.reference for trial in frontier]
    alone = [trial for trial in frontier if trial.worst < HELPS * start.worst]
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
        alone += [trial for trial in tried if len(trial.changes) == 1]
        frontier = sorted(tried, key=attrgetter("worst"))[:WIDTH]
        best = min(best, frontier[0], key=attrgetter("worst"))
    return best if best.worst < start.worst else start, sorted(alone, key=attrgetter("worst"))


def _trials(
    machine: Machine, before: Trial, plans: Mapping[str, Callable[[], Reference]], controllers: Mapping[str, Controller], rerun: Rerun
) -> list[Trial]:
    """Run each change on top of those made before; leave out those that diverge or cannot be planned."""

    def attempt(change: tuple[str, Controller, Callable[[], Reference]]) -> Trial | None:
        name, controller, plan = change
        with suppress(ContourlabError):
            reference = plan()
            judged, sample = judged_run(machine, controller, reference, rerun)
            return Trial((*before.changes, name), controller, judged.motion or reference, float(abs(judged["part_error"][sample])))
        return None

    changes = [(name, before.controller, plan) for name, plan in plans.items()]
    changes += [(name, changed, lambda: before.reference) for name, changed in controllers.items()]
    return [trial for trial in in_threads(attempt, changes) if trial is not None]
