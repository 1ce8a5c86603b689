"""The verdict against a tolerance: pass or fail, the worst place, its causes, and the one change that helps most."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from contourlab.features.run.advice import advice
from contourlab.features.run.causes import Cause, causes
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine
from contourlab.metrics import evaluation_window
from contourlab.metrics.figures import left_out
from contourlab.result import Result


@dataclass(frozen=True, slots=True)
class Worst:
    """Where the part error is largest: value [m], sample, time [s], position [m], arc length [m], source line (0 if none)."""

    value: float
    sample: int
    time: float
    position: tuple[float, ...]
    arc_length: float
    line: int
    text: str


@dataclass(frozen=True, slots=True)
class Verdict:
    """Pass or fail against a tolerance, with the worst place, its causes and the best single change.

    Attributes
    ----------
    passed : bool
        Whether the largest part error is within the tolerance, and the tool came along the whole path: the longest piece left out is within
        ten tolerances, the one at the end within two; or within three of the reference's steps where these are longer.
    tolerance : float [m]
    worst : Worst
    causes : tuple of Cause
        Largest first.
    advice : str
    untold : tuple of str
        Causes that could not be told apart, as the loop runs away without them.
    left_out : float [m]
        The longest piece of the path that the tool never came to, where it is too long to pass; else 0.
    """

    passed: bool
    tolerance: float
    worst: Worst
    causes: tuple[Cause, ...]
    advice: str
    untold: tuple[str, ...] = ()
    left_out: float = 0.0


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
        What was run.
    judged : Result
        The run, with the judge's signals.
    tolerance : float [m], > 0
        Largest part error that passes.
    lines : tuple of str
        Source text of the program.
    slower : callable, optional
        Returns the reference at a feed scaled by its argument, for the advice.
    closer : callable, optional
        Returns ways of planning closer to the programmed path, in words and made; tried where planning is the largest cause.
    explain : bool
        Whether causes and advice are worked out (about ten runs more).
    seed : int
        The seed of the run.
    """
    window, _ = evaluation_window(reference, judged.n_sample)
    sample = window[0] + int(np.argmax(np.abs(judged["part_error"][slice(*window)])))
    worst = _place(judged, reference, sample, lines)
    missed = _missed(judged, reference, window, tolerance)
    passed = bool(worst.value <= tolerance) and not missed
    # Small errors of a tool that did not come along have no causes worth telling.
    if not explain or (missed and worst.value <= tolerance):
        return Verdict(passed, tolerance, worst, (), "", left_out=missed)
    found, untold = causes(machine, controller, reference, judged, sample, seed)
    # A quarter of the tolerance for the corners leaves the rest to the servo.
    other = closer(0.25 * tolerance) if closer is not None and found and found[0].name == "planning" else None
    best = advice(machine, controller, reference, worst.value, slower, seed, other)
    return Verdict(passed, tolerance, worst, found, best, untold, missed)


def _missed(judged: Result, reference: Reference, window: tuple[int, int], tolerance: float) -> float:
    longest, at_end = left_out(judged, reference, window)
    asked = reference.programmed_arc_length(judged["arc_length"][slice(*window)])
    step = 3.0 * float(np.abs(np.diff(asked)).max(initial=0.0))
    # A tool within the tolerance may cut off several times as much at a sharp corner, but not at the end.
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
