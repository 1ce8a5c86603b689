"""What the error at one place is made of: take away one imperfection after another.

The same reference is run again with ever fewer imperfections. The contribution of a cause is the change of the error at that place, along
the direction of the error, when the cause is taken away:

1. *network*: no links between base and axes; 2. *geometry*: no error map; 3. *quantisation*: ideal encoders, counts without steps; 4.
*saturation*: drives without limit; 5. *disturbance*: no external load; 6. *backlash*: no free travel, and controllers that assume none;
7. *compliance*: stiff shafts, which friction does not wind up, and no notch filters; 8. *friction*: no friction; 9. *servo mismatch*:
every axis a copy of one of them, averaged over the choice; 10. *lag*: a tool that is at the reference, so that overshoot counts as lag;
11. *planning*: the rest, the distance of the planned path from the programmed one.

The error that friction causes is called *reversal* after an axis has reversed, *breakaway* after it has started from rest, else *friction*.

The contributions add up to the error. A step after which the loop diverges is left out and named; its part stays in the next step. The
order matters where effects interact, and is therefore fixed.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TypeAlias

import numpy as np

from contourlab.arrays import BLOCK, Array
from contourlab.components.compensation.backlash import QuadrantPulses
from contourlab.components.contract import Component
from contourlab.components.drive.saturation import Saturation
from contourlab.components.feedforward.laws import FrictionFeedforward
from contourlab.components.filter.biquad import Notch
from contourlab.components.friction.laws import NoFriction
from contourlab.components.ideal import IdealSensor
from contourlab.components.plant.two_sided import TwoSided
from contourlab.features.run.record import simulate_stored
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine
from contourlab.loop.machine import Axis, AxisController, AxisError
from contourlab.metrics.judge import judge
from contourlab.rendering.judgement import Cause
from contourlab.result import Result, Signal

Rerun: TypeAlias = Callable[..., Result]
Step: TypeAlias = Callable[[Machine, Controller], tuple[Machine, Controller]]


def _of_machine(take_away: Callable[[Machine], Machine]) -> Step:
    return lambda machine, controller: (take_away(machine), controller)


# --- machines with one imperfection taken away; the machine itself where there is nothing to take away ---


def perfect_geometry(machine: Machine) -> Machine:
    """Return the machine without lead error, squareness and repeatability."""
    if not machine.squareness and not any(a.error.position.size or a.error.repeatability for a in machine.axes):
        return machine
    return replace(machine, axes=tuple(replace(a, error=AxisError(backlash=a.error.backlash)) for a in machine.axes), squareness={})


def perfect_sensing(machine: Machine) -> Machine:
    """Return the machine with ideal encoders, and step counts without steps."""

    def exact(axis: Axis) -> Axis:
        plant = axis.plant.linear() if axis.plant.takes_position else axis.plant
        return replace(axis, plant=plant, sensor=IdealSensor(), motor_sensor=IdealSensor())

    return _with_axes(machine, exact)


def undisturbed(machine: Machine) -> Machine:
    """Return the machine without external loads."""
    return _with_axes(machine, lambda axis: replace(axis, disturbance=None))


def without_friction(machine: Machine, controller: Controller) -> tuple[Machine, Controller]:
    """Return the machine without friction, under a controller that compensates none."""

    def uncompensated(loop: AxisController) -> AxisController:
        feedforward = None if isinstance(loop.feedforward, FrictionFeedforward) else loop.feedforward
        compensation = None if isinstance(loop.compensation, QuadrantPulses) else loop.compensation
        return replace(loop, feedforward=feedforward, compensation=compensation)

    smooth = _with_axes(machine, lambda axis: replace(axis, friction=NoFriction(), motor_friction=NoFriction()))
    return smooth, controller if smooth is machine else _with_loops(controller, uncompensated)


def without_backlash(machine: Machine, controller: Controller) -> tuple[Machine, Controller]:
    """Return the machine without free travel between motors and loads or behind encoders, under a controller that assumes none."""
    tight = _with_axes(machine, lambda axis: axis if axis.plant.takes_position else replace(axis, plant=axis.plant.linear()))
    if any(axis.error.backlash for axis in machine.axes):
        tight = replace(tight, axes=tuple(replace(axis, error=replace(axis.error, backlash=0.0)) for axis in tight.axes))
    return tight, controller if tight is machine else _with_loops(controller, _unaware)


def _unaware(loop: AxisController) -> AxisController:
    """Set the gap that the parts of a controller assume to zero; observers and supervisors of the gap stay."""

    def unaware(part: Component) -> Component:
        return part.replace(backlash_gap=0.0) if "backlash_gap" in part.parameters else part

    compensation = None if loop.compensation is None else unaware(loop.compensation)
    others = tuple((label, unaware(part)) for label, part in loop.others)
    return replace(loop, controller=unaware(loop.controller), compensation=compensation, others=others)


def without_compliance(machine: Machine, controller: Controller) -> tuple[Machine, Controller]:
    """Return the machine with shafts that resonate at half of the servo frequency or above, under a controller without notch filters."""

    def stiffened(axis: Axis) -> Axis:
        if not isinstance(axis.plant, TwoSided):
            return axis
        plant = axis.plant.stiffened(0.5 / machine.servo_period)
        return replace(axis, plant=plant, substeps=max(axis.substeps, plant.fewest_substeps(machine.servo_period)[0]))

    def without_notches(loop: AxisController) -> AxisController:
        return replace(loop, filters=tuple((label, part) for label, part in loop.filters if not isinstance(part, Notch)))

    stiff = _with_axes(machine, stiffened)
    return stiff, controller if stiff is machine else _with_loops(controller, without_notches)


def without_links(machine: Machine, controller: Controller) -> tuple[Machine, Controller]:
    """Return the controller in one piece: base and axes without a network between."""
    return machine, _with_loops(controller, lambda loop: replace(loop, link=None))


def unlimited(machine: Machine) -> Machine:
    """Return the machine with drives that have no limit."""

    def freed(axis: Axis) -> Axis:
        if axis.plant.takes_position:
            return replace(axis, drive=Saturation())
        known = axis.drive.parameters.get("limit")
        if known is None:
            return axis
        # Infinity is a value only where it is the default.
        return replace(axis, drive=axis.drive.replace(limit=math.inf if known.default == math.inf else min(known.maximum, 1e300)))

    return _with_axes(machine, freed)


def _with_axes(machine: Machine, change: Callable[[Axis], Axis]) -> Machine:
    axes = tuple(map(change, machine.axes))
    return machine if axes == machine.axes else replace(machine, axes=axes)


def _with_loops(controller: Controller, change: Callable[[AxisController], AxisController]) -> Controller:
    axes = {name: change(loop) for name, loop in controller.axes.items()}
    return controller if axes == controller.axes else replace(controller, axes=axes)


def same_axes(machine: Machine, controller: Controller, name: str) -> tuple[Machine, Controller]:
    """Return machine and controller with every axis replaced by a copy of one of them, carried mass included."""
    model, mine = machine.axis(name), controller.axes[name]
    alone = replace(model, plant=machine.loaded_plant(name), mounted_on="", alignment=0.0, stage_mass=0.0)
    axes = tuple(replace(alone, name=a.name, limits=a.limits) for a in machine.axes)
    return replace(machine, axes=axes), replace(controller, axes={a.name: mine for a in machine.axes})


# --- what is left of the error ---

FRICTION = "friction"
SOON = 0.25
"""Longest time from a reversal or a start to the error that friction then causes [s]."""
_STEPS: tuple[tuple[str, Step], ...] = (
    ("network", without_links),
    ("geometry", _of_machine(perfect_geometry)),
    ("quantisation", _of_machine(perfect_sensing)),
    ("saturation", _of_machine(unlimited)),
    ("disturbance", _of_machine(undisturbed)),
    ("backlash", without_backlash),
    ("compliance", without_compliance),
    (FRICTION, without_friction),
)
WOULD_HELP = {
    "network": "a faster link between base and axes",
    "geometry": "compensation of the error map",
    "quantisation": "a finer encoder, or finer steps",
    "saturation": "a stronger drive, or lower acceleration",
    "disturbance": "a stiffer loop, or a smaller load",
    "backlash": "less free travel, or feedback from the load",
    "reversal": "less friction, or a stiffer loop",
    "breakaway": "less friction, or a stiffer loop",
    FRICTION: "less friction, or a stiffer loop",
    "compliance": "a stiffer axis, feedback from the load, or lower jerk",
    "servo mismatch": "equal gains on all axes",
    "lag": "feedforward, or a lower feed",
    "planning": "a smaller corner tolerance",
}
"""What reduces each cause."""


@dataclass(frozen=True)
class Place:
    """A sample of a run, and the direction of the error there."""

    reference: Reference
    judged: Result
    sample: int
    rerun: Rerun = simulate_stored

    @cached_property
    def off(self) -> Array:
        """The error (n_axis,) [m]."""
        foot = self.reference.programmed.position(self.judged["foot_arc_length"][self.sample : self.sample + 1])[0]
        return np.asarray(self.judged["tool_position"][self.sample] - foot)

    @cached_property
    def size(self) -> float:
        return float(np.linalg.norm(self.off))

    def after(self, machine: Machine, controller: Controller) -> float:
        """Return the error of another machine's run along this direction; NaN if the run ends before."""
        signals = ("tool_position", "reference", "arc_length")
        run = self.rerun(machine, controller, self.reference, signals=signals, stop=self.sample + 1)
        return self.of(run.window(self.sample, self.sample + 1)) if run.n_sample > self.sample else float("nan")

    def at(self, position: Array) -> float:
        """Return the error along this direction of a tool at another position (n_axis,) [m]."""
        here = self.judged.window(self.sample, self.sample + 1)
        return self.of(here.with_signals(tool_position=Signal(position[None], ("sample", "axis"), "m")))

    def of(self, here: Result) -> float:
        """Return the error along this direction of another run, of this sample alone."""
        judged = judge(here, self.reference)
        off = judged["tool_position"][0] - self.reference.programmed.position(judged["foot_arc_length"])[0]
        return float(off @ (self.off / (self.size or 1.0)))


def at_start(judged: Result, sample: int) -> str:
    """Return whether an axis has lately reversed or started from rest."""
    first = max(sample - round(SOON / judged.servo_period), 0)
    if "reference_velocity" not in judged:
        return FRICTION
    latest, name = -1, FRICTION
    for velocity in judged["reference_velocity"].T:
        begin = first  # from the last motion before
        while begin and not velocity[begin:first].any():
            begin = max(begin - BLOCK, 0)
        moving = begin + np.flatnonzero(velocity[begin : sample + 1])
        sign = np.sign(velocity[moving])
        fresh = np.flatnonzero(np.concatenate([[True], (sign[1:] != sign[:-1]) | (np.diff(moving) > 1)])[: moving.size])
        if fresh.size and moving[fresh[-1]] > max(latest, first - 1):
            latest, last = int(moving[fresh[-1]]), int(fresh[-1])
            name = "reversal" if last and sign[last] != sign[last - 1] else "breakaway"
    return name


def causes(
    machine: Machine, controller: Controller, reference: Reference, judged: Result, sample: int, rerun: Rerun = simulate_stored
) -> tuple[tuple[Cause, ...], tuple[str, ...]]:
    """Return the causes of the part error at a sample, largest first, and the names of those after which the loop diverges.

    `judged` is the run with the judge's signals, `rerun` is `simulate_stored` with its options. The contributions add up to the error.
    """
    place = Place(reference, judged, sample, rerun)
    contributions: list[tuple[str, float]] = []
    diverging: list[str] = []
    left, kept = place.size, machine
    for name, take_away in _STEPS:
        better, driven = take_away(kept, controller)
        same = better is kept and driven is controller
        if same and name in ("network", "backlash", "compliance"):
            continue  # few machines have any
        now = left if same else place.after(better, driven)
        if np.isnan(now):
            diverging.append(name)
            continue
        contributions.append((at_start(judged, sample) if name == FRICTION and not same else name, left - now))
        left, kept, controller = now, better, driven
    copies = np.array([place.after(*same_axes(kept, controller, axis.name)) for axis in machine.axes])
    if np.isfinite(copies).any():
        contributions.append(("servo mismatch", left - float(np.nanmean(copies))))
        left = float(np.nanmean(copies))
    else:
        diverging.append("servo mismatch")
    planning = place.at(judged["reference"][sample])
    return ranked([*contributions, ("lag", left - planning), ("planning", planning)]), tuple(diverging)


def ranked(contributions: Sequence[tuple[str, float]]) -> tuple[Cause, ...]:
    """Return causes by name and contribution [m], the largest first."""
    total = sum(abs(value) for _, value in contributions) or 1.0
    causes = (Cause(name, float(value), float(abs(value) / total)) for name, value in contributions)
    return tuple(sorted(causes, key=lambda cause: -cause.share))
