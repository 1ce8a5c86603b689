"""Machines with one imperfection taken away; each function returns the machine itself where there is nothing to take away."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

from contourlab.components.compensation.quadrant_pulses import QuadrantPulses
from contourlab.components.contract import Component
from contourlab.components.feedforward.inverse_dynamics import FrictionFeedforward
from contourlab.components.filter.biquad import Notch
from contourlab.components.friction.laws import NoFriction
from contourlab.components.ideal import IdealSensor
from contourlab.components.plant.two_sided import TwoSided
from contourlab.loop.axis_parts import AxisError
from contourlab.loop.machine import Axis, AxisController, Controller, Machine


def perfect_geometry(machine: Machine) -> Machine:
    """Return the machine without lead error, squareness and repeatability."""
    if not machine.squareness and not any(a.error.position.size or a.error.repeatability for a in machine.axes):
        return machine
    return replace(machine, axes=tuple(replace(a, error=AxisError()) for a in machine.axes), squareness={})


def perfect_sensing(machine: Machine) -> Machine:
    """Return the machine with ideal encoders."""
    return _with_axes(machine, lambda axis: replace(axis, sensor=IdealSensor(), motor_sensor=IdealSensor()))


def undisturbed(machine: Machine) -> Machine:
    """Return the machine without external loads."""
    return _with_axes(machine, lambda axis: replace(axis, disturbance=None))


def without_friction(machine: Machine, controller: Controller) -> tuple[Machine, Controller]:
    """Return the machine without friction, under a controller that compensates none."""
    smooth = _with_axes(machine, lambda axis: replace(axis, friction=NoFriction(), motor_friction=NoFriction()))
    return smooth, controller if smooth is machine else _with_loops(controller, _uncompensated)


def _uncompensated(loop: AxisController) -> AxisController:
    """Take away the parts that do nothing but compensate friction."""
    feedforward = None if isinstance(loop.feedforward, FrictionFeedforward) else loop.feedforward
    compensation = None if isinstance(loop.compensation, QuadrantPulses) else loop.compensation
    return replace(loop, feedforward=feedforward, compensation=compensation)


def without_backlash(machine: Machine, controller: Controller) -> tuple[Machine, Controller]:
    """Return the machine without free travel between motors and loads, under a controller that assumes none."""
    tight = _with_axes(machine, lambda axis: replace(axis, plant=axis.plant.linear()))
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
    stiff = _with_axes(machine, lambda axis: _stiff(axis, machine.servo_period))
    return stiff, controller if stiff is machine else _with_loops(controller, _without_notches)


def _stiff(axis: Axis, period: float) -> Axis:
    if not isinstance(axis.plant, TwoSided):
        return axis
    plant = axis.plant.stiffened(0.5 / period)
    return replace(axis, plant=plant, substeps=max(axis.substeps, plant.fewest_substeps(period)[0]))


def _without_notches(loop: AxisController) -> AxisController:
    return replace(loop, filters=tuple((label, part) for label, part in loop.filters if not isinstance(part, Notch)))


def without_links(machine: Machine, controller: Controller) -> tuple[Machine, Controller]:
    """Return the controller in one piece: base and axes without a network between."""
    return machine, _with_loops(controller, lambda loop: replace(loop, link=None))


def unlimited(machine: Machine) -> Machine:
    """Return the machine with drives that have no limit."""
    return _with_axes(machine, lambda axis: replace(axis, drive=_without_limit(axis.drive)))


def _without_limit(drive: Component) -> Component:
    known = drive.parameters.get("limit")
    if known is None:
        return drive
    # Infinity is a value only where it is the default.
    free: Component = drive.replace(limit=math.inf if known.default == math.inf else min(known.maximum, 1e300))
    return free


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
