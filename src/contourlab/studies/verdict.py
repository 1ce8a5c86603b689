"""The verdict against a tolerance: pass or fail, the worst place, its causes, and the one change that helps most.

The causes are worked out, not guessed. The same reference is run again with one imperfection after another taken away, and each cause is
what the signed error at the worst place changes by when its own is taken away:

1. *geometry*: the machine's error map; 2. *quantisation*: ideal encoders; 3. *reversal*: no friction, no disturbance; 4. *saturation*:
drives
without limit; 5. *servo mismatch*: every axis a copy of one of them, averaged over the choice; 6. *lag*: what is left; and *planning*: the
planned path's own distance from the programmed one. The sum is the error itself, by construction.

The advice is measured as well: each candidate change is simulated over the whole motion, and the one with the smallest largest error is
named with its figure.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from contourlab.components.coupling.modified_reference import ModifiedReference
from contourlab.components.estimator.newton import Newton
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.errors import ContourlabError
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine, simulate
from contourlab.metrics import judge
from contourlab.result import Result
from contourlab.studies import idealise

Array = NDArray[np.float64]

__all__ = ["Cause", "Verdict", "Worst", "verdict"]


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
class Cause:
    """One cause of the error at the worst place: its signed contribution [m], and its share of all contributions' magnitudes."""

    name: str
    contribution: float
    share: float


@dataclass(frozen=True, slots=True)
class Verdict:
    """Pass or fail against a tolerance [m], with the worst place, its causes (largest first) and the best single change."""

    passed: bool
    tolerance: float
    worst: Worst
    causes: tuple[Cause, ...]
    advice: str


def verdict(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    judged: Result,
    tolerance: float,
    *,
    lines: tuple[str, ...] = (),
    slower: Callable[[float], Reference] | None = None,
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
    explain : bool
        Whether causes and advice are worked out (about ten runs more).
    seed : int
        The seed of the run.
    """
    window = _window(reference)
    error = judged["part_error"]
    magnitude = np.abs(error)
    sample = window.start + int(np.argmax(magnitude[window]))
    worst = _place(judged, reference, sample, lines)
    passed = bool(worst.value <= tolerance)
    if not explain:
        return Verdict(passed, tolerance, worst, (), "")
    causes = _causes(machine, controller, reference, judged, sample, seed)
    advice = _advice(machine, controller, reference, worst.value, slower, seed)
    return Verdict(passed, tolerance, worst, causes, advice)


def _window(reference: Reference) -> slice:
    start, stop = reference.laps[-1] if reference.laps else (0, reference.n_sample)
    return slice(start, stop)


def _place(judged: Result, reference: Reference, sample: int, lines: tuple[str, ...]) -> Worst:
    along = float(judged["arc_length"][sample])
    line = int(reference.source_line(np.array([along]))[0])
    text = lines[line - 1].strip() if 0 < line <= len(lines) else ""
    position = tuple(float(v) for v in judged["tool_position"][sample])
    value = float(abs(judged["part_error"][sample]))
    return Worst(value, sample, sample * judged.servo_period, position, along, line, text)


def _signed_error(machine: Machine, controller: Controller, reference: Reference, sample: int, seed: int, direction: Array) -> float:
    """Return the part error at a sample, along the direction in which the original run was off; NaN if the run does not get there."""
    signals = ("tool_position", "reference", "arc_length")
    run = simulate(machine, controller, reference, seed=seed, on_failure="return", signals=signals)
    if run.n_sample <= sample:
        return float("nan")
    one = judge(run.window(sample, sample + 1), reference)
    return float((one["tool_position"][0] - reference.programmed.position(one["foot_arc_length"])[0]) @ direction)


def _causes(machine: Machine, controller: Controller, reference: Reference, judged: Result, sample: int, seed: int) -> tuple[Cause, ...]:
    foot = reference.programmed.position(judged["foot_arc_length"][sample : sample + 1])[0]
    off = judged["tool_position"][sample] - foot
    size = float(np.linalg.norm(off))
    direction = off / size if size > 0.0 else np.zeros_like(off)
    steps: list[tuple[str, float]] = []
    left, m = size, machine

    def take_away(name: str, better: Machine) -> None:
        nonlocal left, m
        now = left if better is m else _signed_error(better, controller, reference, sample, seed, direction)
        steps.append((name, left - now))
        left, m = now, better

    take_away("geometry", idealise.perfect_geometry(m))
    take_away("quantisation", idealise.perfect_sensing(m))
    take_away("reversal", idealise.without_friction(m))
    take_away("saturation", idealise.unlimited(m))
    copies = [_signed_error(*idealise.same_axes(m, controller, a.name), reference, sample, seed, direction) for a in machine.axes]
    lag = float(np.mean(copies))
    planning = float(judged["planning_deviation"][sample])
    steps += [("servo mismatch", left - lag), ("lag", lag - planning), ("planning", planning)]
    total = sum(abs(value) for _, value in steps) or 1.0
    causes = [Cause(name, float(value), float(abs(value) / total)) for name, value in steps]
    return tuple(sorted(causes, key=lambda cause: -cause.share))


def _candidates(machine: Machine, controller: Controller) -> list[tuple[str, Controller]]:
    """Return single changes of the controller that a person would try."""
    found: list[tuple[str, Controller]] = []

    def every(change: Callable[[str], object]) -> Controller:
        return replace(controller, axes={name: change(name) for name in controller.axes})  # type: ignore[misc]

    def gains(factor: float) -> Controller:
        def raise_gains(name: str) -> object:
            part = controller.axes[name]
            c = part.controller
            if "position_gain" not in c.parameters:
                return part
            gained = c.replace(position_gain=factor * c.position_gain, velocity_gain=factor * c.velocity_gain)  # type: ignore[attr-defined]
            return replace(part, controller=gained)

        return every(raise_gains)

    def own_model(name: str) -> object:
        part = controller.axes[name]
        c = part.controller
        if "model_gain" not in c.parameters:
            return part
        model = _model_of(machine, name) if part.observer is None else (part.observer.model_gain, part.observer.model_damping)  # type: ignore[attr-defined]
        return replace(part, controller=c.replace(model_gain=model[0], model_damping=model[1]))

    found += [
        ("raising the position and velocity gains by a quarter", gains(1.25)),
        ("lowering the position and velocity gains by a fifth", gains(0.8)),
    ]
    found.append(("feeding forward the model that the loop really follows", every(own_model)))
    if all(part.observer is None for part in controller.axes.values()):

        def observed(name: str) -> object:
            gain, damping = _model_of(machine, name)
            return replace(controller.axes[name], observer=DisturbanceObserver(model_gain=gain, model_damping=damping))

        found.append(("adding a disturbance observer", every(observed)))
    else:

        def faster(name: str) -> object:
            part = controller.axes[name]
            o = part.observer
            return part if o is None else replace(part, observer=o.replace(bandwidth=1.5 * o.bandwidth))  # type: ignore[attr-defined]

        found.append(("raising the observer's bandwidth by half", every(faster)))
    if controller.coupling is None and len(machine.axes) > 1:
        found.append(
            (
                "coupling the axes by a modified reference",
                replace(controller, estimator=Newton(), coupling=ModifiedReference()),
            )
        )
    return found


def _model_of(machine: Machine, name: str) -> tuple[float, float]:
    """Return acceleration per command and decay of an axis' plant."""
    model = machine.axis(name).plant.linearize()
    return float(model.b[1, 0]), float(-model.a[1, 1])


def _advice(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    worst: float,
    slower: Callable[[float], Reference] | None,
    seed: int,
) -> str:
    trials: list[tuple[float, str]] = []

    def attempt(words: str, trial: Controller, ref: Reference) -> None:
        try:
            judged = judge(simulate(machine, trial, ref, seed=seed, signals=("tool_position", "reference", "arc_length")), ref)
        except ContourlabError:
            return  # a change that makes the loop run away is no advice
        trials.append((float(np.abs(judged["part_error"][_window(ref)]).max()), words))

    for words, trial in _candidates(machine, controller):
        attempt(words, trial, reference)
    if slower is not None:
        attempt("taking the feed down by a fifth", controller, slower(0.8))
    best = min(trials, default=None)
    if best is None or best[0] >= worst:
        return "no single change that was tried makes it smaller"
    return f"{best[1]} brings the largest error from {worst * 1e6:.3g} um to {best[0] * 1e6:.3g} um"
