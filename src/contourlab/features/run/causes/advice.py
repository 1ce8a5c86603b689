"""The single change of controller or feed that reduces the largest error most; each is simulated."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import replace

import numpy as np

from contourlab.components.compensation.backlash_inverse import BacklashInverse
from contourlab.components.compensation.backlash_offset import BacklashOffset
from contourlab.components.coupling.modified_reference import ModifiedReference
from contourlab.components.estimator.newton import Newton
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.errors import ContourlabError
from contourlab.feed import Reference
from contourlab.findings import Finding, finding
from contourlab.loop import Axis, AxisController, Controller, Machine, simulate
from contourlab.metrics import evaluation_window, judge


def advice(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    worst: float,
    slower: Callable[[float], Reference] | None = None,
    seed: int = 0,
    closer: Mapping[str, Callable[[], Reference]] | None = None,
) -> Finding:
    """Return the change that helps most, or that none does.

    Parameters
    ----------
    machine, controller, reference
        Of the run.
    worst : float [m]
        Largest part error of the run.
    slower : callable, optional
        Returns the reference at a scaled feed.
    seed : int
        Of the run.
    closer : mapping, optional
        Ways to plan closer to the programmed path, by name; they may take longer.
    """
    trials: list[tuple[float, str, float]] = []

    def attempt(change: str, trial: Controller, ref: Reference) -> None:
        judged = judge(simulate(machine, trial, ref, seed=seed, signals=("tool_position", "reference", "arc_length")), ref)
        (start, stop), _ = evaluation_window(ref, judged.n_sample)
        trials.append((float(np.abs(judged["part_error"][start:stop]).max()), change, ref.duration))

    for change, trial in candidates(machine, controller):
        with suppress(ContourlabError):  # the loop may diverge
            attempt(change, trial, reference)
    if slower is not None:
        with suppress(ContourlabError):  # laps at another frequency may not end on a sample
            attempt("taking the feed down by a fifth", controller, slower(0.8))
    for change, planned in (closer or {}).items():
        with suppress(ContourlabError):  # the route may be impossible to plan
            attempt(change, controller, planned())
    # Less than a hundredth is no help.
    if not trials or min(trials)[0] > 0.99 * worst:
        return finding("CL204")
    best, change, duration = min(trials)
    return finding("CL203", change=change, before=worst, after=best, time_before=reference.duration, time_after=duration)


def candidates(machine: Machine, controller: Controller) -> list[tuple[str, Controller]]:
    """Return single changes of the controller that a person would try, by name."""

    def every(change: Callable[[str, AxisController], AxisController]) -> Controller:
        return replace(controller, axes={name: change(name, part) for name, part in controller.axes.items()})

    changes = [
        ("raising the poles of the position loops by a quarter", every(lambda name, part: _faster(machine, name, part, 1.25))),
        ("lowering the poles of the position loops by a fifth", every(lambda name, part: _faster(machine, name, part, 0.8))),
        ("matching the feedforward model to the loop", every(lambda name, part: _own_model(machine, name, part))),
    ]
    if all(part.observer is None for part in controller.axes.values()):
        changes.append(("adding a disturbance observer", every(lambda name, part: _observed(machine, name, part))))
    else:
        changes.append(("raising the observer's bandwidth by half", every(_faster_observer)))
    if controller.coupling is None and len(machine.axes) > 1:
        changes.append(("coupling the axes by a modified reference", replace(controller, estimator=Newton(), coupling=ModifiedReference())))
    changes.append(("compensating the backlash by an offset on reversal", every(lambda name, part: _compensated(machine, name, part))))
    return [(change, changed) for change, changed in changes if changed != controller]


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
    """Return gain and damping of the model that the loop sees: the observer's, or without an observer the loaded plant's."""
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
    """Add an offset where the loop is closed over the motor and no part compensates the backlash."""
    axis = machine.axis(name)
    lost_motion = lost_motion_of(axis)
    aware = part.compensation is not None or any("backlash_gap" in law.parameters for law in part.controllers.values())
    if not lost_motion > 0.0 or part.feedback != "motor" or aware:
        return part
    return replace(part, compensation=offset_of(axis, lost_motion)[0])


def _model_of(machine: Machine, name: str) -> tuple[float, float]:
    """Return acceleration per command and damping of an axis with the axes that it carries."""
    return machine.loaded_plant(name).rigid_model()


def lost_motion_of(axis: Axis) -> float:
    """Return the lost motion of an axis [m]: its free travel plus twice the wind-up of the shaft under friction; 0 without a gap."""
    if not isinstance(axis.plant, TwoInertia) or not axis.plant.widest_gap > 0.0:
        return 0.0
    friction = float(axis.friction.values().get("coulomb", 0.0))
    return axis.plant.widest_gap + 2.0 * friction / float(axis.plant.constants().stiffness_value)


def offset_of(axis: Axis, lost_motion: float) -> tuple[BacklashOffset, BacklashInverse]:
    """Return offset and inverse for a lost motion [m]: half of it accelerating, half braking, at the limit of the axis."""
    most = axis.limits.acceleration
    acceleration = most if math.isfinite(most) else 1.0
    speed = math.sqrt(acceleration * lost_motion)
    offset = BacklashOffset(backlash_gap=lost_motion, backlash_velocity=speed, backlash_acceleration=acceleration)
    return offset, BacklashInverse(backlash_gap=lost_motion, jump_velocity=speed)
