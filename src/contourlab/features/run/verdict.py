"""The verdict against a tolerance: pass or fail, the worst place, its causes, and the changes that help most."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial

import numpy as np

from contourlab.features.run.causes.advice import Trial, advice, judged_run, proposal
from contourlab.features.run.causes.causes import WOULD_HELP, Rerun, causes
from contourlab.feed import Reference
from contourlab.findings import finding
from contourlab.loop import Controller, Machine, simulate
from contourlab.metrics import judged_part
from contourlab.metrics.figures import left_out
from contourlab.rendering.judgement import Verdict, Worst
from contourlab.result import Result

SHARE, LARGE = 0.25, 0.5
"""Share of the tolerance for planning that leaves the rest to the servo loops, and share above which a closer plan comes first."""


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
    rerun: Rerun = simulate,
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
        Whether to find causes and advice (about thirty more runs).
    rerun : callable, optional
        `contourlab.loop.simulate` with the options of the run.

    Returns
    -------
    Verdict
    """
    plain = unexplained(reference, judged, tolerance, lines)
    sample, findings = plain.worst.sample, list(plain.findings)
    # The error of a tool that skips part of the path says nothing about causes.
    if not explain or (plain.left_out and plain.worst.value <= tolerance):
        return plain
    planned = _planned(reference, judged)[0]
    ranked, diverging = causes(machine, controller, reference, judged, sample, rerun)
    if diverging:
        findings.append(finding("CL202", causes=diverging))
    plans: dict[str, Callable[[], Reference]] = {} if slower is None else {"taking the feed down by a fifth": partial(slower, 0.8)}
    near = closer(SHARE * tolerance) if closer is not None and planned > SHARE * tolerance else {}
    start = Trial((), controller, reference, plain.worst.value)
    if planned > LARGE * tolerance:
        best = advice(machine, start, tolerance, plans, rerun, near)
    else:
        best = advice(machine, start, tolerance, {**plans, **near}, rerun)
    if best is not start:
        findings.append(proposal(start, best))
    if best.worst > tolerance:
        last = machine, best.controller, best.reference
        left = ranked if best is start else causes(*last, *judged_run(*last, rerun), rerun)[0]
        cause = max(left, key=lambda one: one.contribution)
        findings.append(finding("CL204", tolerance=tolerance, cause=cause.name, left=cause.contribution, help=WOULD_HELP[cause.name]))
    proposed = None if best.controller is controller else best.controller
    return replace(plain, causes=ranked, findings=tuple(findings), proposed=proposed)


def unexplained(reference: Reference, judged: Result, tolerance: float, lines: tuple[str, ...] = ()) -> Verdict:
    """Return the verdict on a judged run without causes and advice; arguments as for `verdict`."""
    samples = judged_part(judged, reference).samples
    worst = _place(judged, reference, int(samples[np.argmax(np.abs(judged["part_error"][samples]))]), lines)
    skipped = _skipped(judged, reference, tolerance)
    planned, line = _planned(reference, judged)
    findings = [finding("CL201", length=skipped)] if skipped else []
    if planned > tolerance:
        findings.append(finding("CL208", deviation=planned, line=line, tolerance=tolerance))
    return Verdict(worst.value <= tolerance and not skipped, tolerance, worst, (), skipped, tuple(findings))


def _planned(reference: Reference, judged: Result) -> tuple[float, int]:
    """Return the largest planning deviation [m] of the judged samples, and its program line."""
    samples = judged_part(judged, reference).samples
    off = np.abs(judged["planning_deviation"][samples])
    line = reference.source_line(judged["arc_length"][samples[off.argmax()]][None])[0]
    return float(off.max()), int(line)


def _skipped(judged: Result, reference: Reference, tolerance: float) -> float:
    part = judged_part(judged, reference)
    longest, at_end = left_out(judged, reference, part)
    asked = np.abs(np.diff(reference.programmed_arc_length(judged["arc_length"])))
    step = 3.0 * float(asked[part.samples[:-1]].max(initial=0.0))
    # At a sharp corner a tool within the tolerance may skip several times as much, but not at the end.
    if longest > max(10.0 * tolerance, step):
        return longest
    return at_end if at_end > max(2.0 * tolerance, step) else 0.0


def _place(judged: Result, reference: Reference, sample: int, lines: tuple[str, ...]) -> Worst:
    along = float(judged["arc_length"][sample])
    line = int(reference.source_line(np.array([along]))[0])
    text = lines[line - 1].strip() if 0 < line <= len(lines) else ""
    position = tuple(float(v) for v in judged["tool_position"][sample])
    value = float(abs(judged["part_error"][sample]))
    return Worst(value, sample, sample * judged.servo_period, position, along, line, text)
