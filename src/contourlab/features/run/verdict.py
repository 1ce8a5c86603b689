"""The verdict against a tolerance: pass or fail, the worst place, its causes, and the single change that helps most."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from contourlab.features.run.causes.advice import advice
from contourlab.features.run.causes.causes import causes
from contourlab.feed import Reference
from contourlab.findings import finding
from contourlab.loop import Controller, Machine
from contourlab.metrics import evaluation_window
from contourlab.metrics.figures import left_out
from contourlab.report.judgement import Verdict, Worst
from contourlab.result import Result


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
    seed: int = 0,
) -> Verdict:
    """Return the verdict on a judged run.

    Parameters
    ----------
    machine, controller, reference
    judged : Result
        The run, with the judge's signals.
    tolerance : float [m], > 0
        Largest part error that passes.
    lines : tuple of str
        Source text of the program.
    slower : callable, optional
        Returns the reference at a scaled feed, for the advice.
    closer : callable, optional
        Returns ways to plan closer to the programmed path, by name; tried where planning is the largest cause.
    explain : bool
        Whether to find causes and advice (about ten more runs).
    seed : int
        Of the run.
    """
    window, _ = evaluation_window(reference, judged.n_sample)
    sample = window[0] + int(np.argmax(np.abs(judged["part_error"][slice(*window)])))
    worst = _place(judged, reference, sample, lines)
    skipped = _skipped(judged, reference, window, tolerance)
    within = worst.value <= tolerance
    findings = [finding("CL201", length=skipped)] if skipped else []
    # The error of a tool that skips part of the path says nothing about causes.
    if not explain or (skipped and within):
        return Verdict(bool(within) and not skipped, tolerance, worst, (), skipped, tuple(findings))
    ranked, diverging = causes(machine, controller, reference, judged, sample, seed)
    # A quarter of the tolerance for the corners leaves the rest to the servo.
    plans = closer(0.25 * tolerance) if closer is not None and ranked and ranked[0].name == "planning" else None
    if diverging:
        findings.append(finding("CL202", causes=diverging))
    findings.append(advice(machine, controller, reference, worst.value, slower, seed, plans))
    return Verdict(bool(within) and not skipped, tolerance, worst, ranked, skipped, tuple(findings))


def _skipped(judged: Result, reference: Reference, window: tuple[int, int], tolerance: float) -> float:
    longest, at_end = left_out(judged, reference, window)
    asked = reference.programmed_arc_length(judged["arc_length"][slice(*window)])
    step = 3.0 * float(np.abs(np.diff(asked)).max(initial=0.0))
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
