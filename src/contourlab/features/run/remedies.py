"""Changes of a controller that a person would try: faster loops, another control law, feedforward, observer, coupling, compensation."""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from functools import partial

from contourlab.components.compensation.backlash import BacklashInverse, BacklashOffset
from contourlab.components.controller.cascade import Cascade
from contourlab.components.coupling.laws import ModifiedReference
from contourlab.components.estimator.newton import Newton
from contourlab.components.feedforward.laws import FrictionFeedforward
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.errors import ContourlabError
from contourlab.loop import Axis, AxisController, Controller, Machine
from contourlab.scenario.build import model_of
from contourlab.study.guards import Bounds, Guards, designed, fastest_speed

SHARPEST = 3.0
"""Bandwidth of a velocity filter, times the servo period, that costs a servo loop little phase."""
Change = Callable[[Machine, str, AxisController], AxisController]


def remedies(machine: Machine, controller: Controller) -> list[tuple[str, Controller]]:
    """Return single changes of the controller, by name; none that changes nothing."""
    observed = any(part.observer is not None for part in controller.axes.values())
    of_axes: dict[str, Change] = {
        "raising the poles of the position loops by a quarter": partial(_faster, 1.25),
        "lowering the poles of the position loops by a fifth": partial(_faster, 0.8),
        "P-PI cascades alone, with feedforward, as fast as 6 dB and 30 degrees allow": _cascaded,
        "matching the feedforward model to the loop": _own_model,
        "raising the observer's bandwidth by half" if observed else "adding a disturbance observer": partial(_observed, observed),
        "compensating the friction by feedforward": _friction_fed_forward,
        "compensating the backlash by an offset on reversal": _compensated,
    }
    changes = []
    for name, change in of_axes.items():
        with suppress(ContourlabError):  # no linear model, or the law does not fit
            axes = {axis: change(machine, axis, part) for axis, part in controller.axes.items()}
            changes.append((name, Controller(axes) if change is _cascaded else replace(controller, axes=axes)))
    if controller.coupling is None and len(machine.axes) > 1 and not any(axis.plant.takes_position for axis in machine.axes):
        coupled = replace(controller, estimator=Newton(), coupling=ModifiedReference())
        changes.append(("coupling the axes by a modified reference", coupled))
    bounds, kept = Bounds(), Guards(machine, controller).exact({})

    def keeps_margins(changed: Controller) -> bool:
        """Tell whether each axis has 6 dB and 30 degrees, or at least its margins of before; without a linear model it counts as good."""
        after = Guards(machine, changed).exact({})
        return all(bounds.missing(margins) <= (bounds.missing(kept[axis]) if axis in kept else 0.0) for axis, margins in after.items())

    return [(name, changed) for name, changed in changes if changed != controller and keeps_margins(changed)]


def _faster(factor: float, machine: Machine, name: str, part: AxisController) -> AxisController:
    """Scale the poles of s^3 + (b + a K_V) s^2 + a K_P s + a K_P K_I by a factor; of a cascade all three."""
    own = part.controller.values()
    if not {"position_gain", "velocity_gain"} <= set(own):
        return part
    gain, damping = model_of(machine, machine.axis(name), part.observer)
    changed = {"velocity_gain": max((factor * (damping + gain * own["velocity_gain"]) - damping) / gain, 0.0)}
    if isinstance(part.controller, Cascade):
        changed |= {"position_gain": factor * own["position_gain"], "integral_time": own["integral_time"] / factor}
    elif "integral_gain" in own:
        changed |= {"position_gain": factor**2 * own["position_gain"], "integral_gain": factor * own["integral_gain"]}
    else:
        return part
    return replace(part, controller=part.controller.replace(**changed))


def _cascaded(machine: Machine, name: str, part: AxisController) -> AxisController:
    """Replace the law by a cascade with the fastest poles that keep the margins."""
    if part.others:
        return part
    axis, velocity = machine.axis(name), part.velocity
    law = part.controller if isinstance(part.controller, Cascade) else Cascade(position_gain=1.0, velocity_gain=1.0)
    if isinstance(velocity, FilteredDifference):
        velocity = velocity.replace(bandwidth=max(velocity.bandwidth, SHARPEST / machine.servo_period))
        law = law.replace(balance_bandwidth=velocity.bandwidth)
    trial = replace(part, observer=None, velocity=velocity, controller=law)
    gains = designed(trial.controller, fastest_speed(machine, axis, trial, Bounds()), model_of(machine, axis, trial.observer), name)
    return replace(trial, controller=trial.controller.replace(**gains))


def _own_model(machine: Machine, name: str, part: AxisController) -> AxisController:
    gain, damping = model_of(machine, machine.axis(name), part.observer)
    if isinstance(part.controller, Cascade):
        return replace(part, controller=part.controller.replace(velocity_feedforward=1.0, acceleration_feedforward=1.0 / gain))
    if "model_gain" not in part.controller.parameters:
        return part
    return replace(part, controller=part.controller.replace(model_gain=gain, model_damping=damping))


def _observed(any_observed: bool, machine: Machine, name: str, part: AxisController) -> AxisController:
    """Make the observer faster; add one where no axis has any."""
    if not any_observed:
        gain, damping = machine.loaded_plant(name).rigid_model()
        return replace(part, observer=DisturbanceObserver(model_gain=gain, model_damping=damping))
    if part.observer is None or "bandwidth" not in part.observer.values():
        return part
    return replace(part, observer=part.observer.replace(bandwidth=1.5 * part.observer.values()["bandwidth"]))


def _friction_fed_forward(machine: Machine, name: str, part: AxisController) -> AxisController:
    """Feed the axis' own friction forward, its change of sign spread over the speed gained in a servo period."""
    axis = machine.axis(name)
    both = [law.values() for law in (axis.friction, axis.motor_friction)]
    coulomb, breakaway = (sum(float(friction.get(key, 0.0)) for friction in both) for key in ("coulomb", "breakaway"))
    if part.feedforward is not None or not coulomb or not part.controller.takes("feedforward"):
        return part
    law = FrictionFeedforward(
        coulomb=coulomb,
        breakaway=max(breakaway, coulomb),
        stribeck_velocity=next((float(friction["stribeck_velocity"]) for friction in both if "stribeck_velocity" in friction), 1e-3),
        smoothing_velocity=min(axis.limits.acceleration, 1.0) * machine.servo_period,
        force_constant=axis.plant.force_per_command,
    )
    return replace(part, feedforward=law)


def _compensated(machine: Machine, name: str, part: AxisController) -> AxisController:
    """Add an offset for a play that the loop does not see, where no part compensates one."""
    axis = machine.axis(name)
    lost_motion = axis.error.backlash + (lost_motion_of(axis) if part.feedback == "motor" else 0.0)
    aware = part.compensation is not None or any("backlash_gap" in law.parameters for law in part.controllers.values())
    if not lost_motion > 0.0 or aware:
        return part
    return replace(part, compensation=offset_of(axis, lost_motion)[0])


def lost_motion_of(axis: Axis) -> float:
    """Return the lost motion of an axis [m]: its free travel plus twice the wind-up of the shaft under friction; 0 without a gap."""
    if not isinstance(axis.plant, TwoInertia) or not axis.plant.widest_gap > 0.0:
        return 0.0
    friction = float(axis.friction.values().get("coulomb", 0.0))
    return axis.plant.widest_gap + 2.0 * friction / float(axis.plant.constants().stiffness_value)


def offset_of(axis: Axis, lost_motion: float) -> tuple[BacklashOffset, BacklashInverse]:
    """Return offset and inverse for a lost motion [m]: half of it accelerating, half braking, at the limit of the axis."""
    acceleration = axis.limits.acceleration if math.isfinite(axis.limits.acceleration) else 1.0
    speed = math.sqrt(acceleration * lost_motion)
    offset = BacklashOffset(backlash_gap=lost_motion, backlash_velocity=speed, backlash_acceleration=acceleration)
    return offset, BacklashInverse(backlash_gap=lost_motion, jump_velocity=speed)
