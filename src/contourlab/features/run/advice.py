"""The one change of a controller, or of the feed, that makes the largest error smallest: tried, not guessed."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import replace

import numpy as np

from contourlab.components.coupling.modified_reference import ModifiedReference
from contourlab.components.estimator.newton import Newton
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.errors import ContourlabError
from contourlab.features.run.compensate import lost_motion_of, offset_of, wants_offset
from contourlab.feed import Reference
from contourlab.loop import AxisController, Controller, Machine, simulate
from contourlab.metrics import evaluation_window, judge


def advice(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    worst: float,
    slower: Callable[[float], Reference] | None = None,
    seed: int = 0,
    closer: Mapping[str, Callable[[], Reference]] | None = None,
) -> str:
    """Return the change that helps most, with its figure, in words.

    Parameters
    ----------
    machine, controller, reference
        What was run.
    worst : float [m]
        Largest part error of that run.
    slower : callable, optional
        Returns the reference at a feed scaled by its argument.
    seed : int
        The seed of the run.
    closer : mapping, optional
        Ways of planning closer to the programmed path, in words and made; they may take longer, which is said.
    """
    trials: list[tuple[float, str]] = []

    def attempt(words: str, trial: Controller, ref: Reference) -> None:
        try:
            judged = judge(simulate(machine, trial, ref, seed=seed, signals=("tool_position", "reference", "arc_length")), ref)
        except ContourlabError:
            return  # a change that makes the loop run away is no advice
        (start, stop), _ = evaluation_window(ref, judged.n_sample)
        trials.append((float(np.abs(judged["part_error"][start:stop]).max()), words))

    for words, trial in candidates(machine, controller):
        attempt(words, trial, reference)
    if slower is not None:
        with suppress(ContourlabError):  # laps at another frequency may not end on a sample
            attempt("taking the feed down by a fifth", controller, slower(0.8))
    for words, made in (closer or {}).items():
        with suppress(ContourlabError):  # a route that cannot be planned is no advice
            planned = made()
            attempt(f"{words}, {planned.duration:.4g} s in all instead of {reference.duration:.4g} s,", controller, planned)
    best = min(trials, default=None)
    # Less than a hundredth is no help.
    if best is None or best[0] > 0.99 * worst:
        return "no single change that was tried makes it smaller"
    return f"{best[1]} brings the largest error from {worst * 1e6:.3g} um to {best[0] * 1e6:.3g} um"


def candidates(machine: Machine, controller: Controller) -> list[tuple[str, Controller]]:
    """Return single changes of the controller that a person would try, in words and made."""

    def every(change: Callable[[str, AxisController], AxisController]) -> Controller:
        return replace(controller, axes={name: change(name, part) for name, part in controller.axes.items()})

    found = [
        ("raising the poles of the position loops by a quarter", every(lambda name, part: _faster(machine, name, part, 1.25))),
        ("lowering the poles of the position loops by a fifth", every(lambda name, part: _faster(machine, name, part, 0.8))),
        ("feeding forward the model that the loop really follows", every(lambda name, part: _own_model(machine, name, part))),
    ]
    if all(part.observer is None for part in controller.axes.values()):
        found.append(("adding a disturbance observer", every(lambda name, part: _observed(machine, name, part))))
    else:
        found.append(("raising the observer's bandwidth by half", every(_faster_observer)))
    if controller.coupling is None and len(machine.axes) > 1:
        coupled = replace(controller, estimator=Newton(), coupling=ModifiedReference())
        found.append(("coupling the axes by a modified reference", coupled))
    compensated = every(lambda name, part: _compensated(machine, name, part))
    found.append(("compensating the backlash by an offset on reversal", compensated))
    # A change that changes nothing is not worth a run.
    return [(words, changed) for words, changed in found if changed != controller]


def _faster(machine: Machine, name: str, part: AxisController, factor: float) -> AxisController:
    """Scale the poles of s^3 + (b + a K_V) s^2 + a K_P s + a K_P K_I by a factor."""
    own = part.controller.values()
    if not {"position_gain", "velocity_gain", "integral_gain"} <= set(own):
        return part
    gain, damping = _seen_model(machine, name, part)
    faster = part.controller.replace(
        velocity_gain=max((factor * (damping + gain * own["velocity_gain"]) - damping) / gain, 0.0),
        position_gain=factor**2 * own["position_gain"],
        integral_gain=factor * own["integral_gain"],
    )
    return replace(part, controller=faster)


def _own_model(machine: Machine, name: str, part: AxisController) -> AxisController:
    if "model_gain" not in part.controller.parameters:
        return part
    gain, damping = _seen_model(machine, name, part)
    return replace(part, controller=part.controller.replace(model_gain=gain, model_damping=damping))


def _seen_model(machine: Machine, name: str, part: AxisController) -> tuple[float, float]:
    """With an observer the loop follows the observer's model; without, the plant with all that stands on it."""
    seen = part.observer.values() if part.observer is not None else {}
    return (seen["model_gain"], seen["model_damping"]) if "model_gain" in seen else _model_of(machine, name)


def _observed(machine: Machine, name: str, part: AxisController) -> AxisController:
    gain, damping = _model_of(machine, name)
    return replace(part, observer=DisturbanceObserver(model_gain=gain, model_damping=damping))


def _faster_observer(name: str, part: AxisController) -> AxisController:
    bandwidth = part.observer.values().get("bandwidth") if part.observer is not None else None
    if part.observer is None or bandwidth is None:
        return part
    return replace(part, observer=part.observer.replace(bandwidth=1.5 * bandwidth))


def _compensated(machine: Machine, name: str, part: AxisController) -> AxisController:
    axis = machine.axis(name)
    return replace(part, compensation=offset_of(axis, lost_motion_of(axis))[0]) if wants_offset(axis, part) else part


def _model_of(machine: Machine, name: str) -> tuple[float, float]:
    """Return acceleration per command and decay of an axis with all that stands on it."""
    return machine.loaded_plant(name).rigid_model()
