"""Machines with one imperfection taken away; each function returns the machine itself where there is nothing to take away."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

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
    return _with_parts(machine, sensor=IdealSensor(), motor_sensor=IdealSensor())


def undisturbed(machine: Machine) -> Machine:
    """Return the machine without external loads."""
    return _with_parts(machine, disturbance=None)


def without_friction(machine: Machine, controller: Controller) -> tuple[Machine, Controller]:
    """Return the machine without friction, under a controller that compensates none."""
    smooth = _with_parts(machine, friction=NoFriction(), motor_friction=NoFriction())
    if smooth is machine:
        return machine, controller
    axes = {name: _uncompensated(mine) for name, mine in controller.axes.items()}
    return smooth, controller if axes == controller.axes else replace(controller, axes=axes)


def _uncompensated(loop: AxisController) -> AxisController:
    """Take away the parts that do nothing but compensate friction."""
    feedforward = None if isinstance(loop.feedforward, FrictionFeedforward) else loop.feedforward
    compensation = None if isinstance(loop.compensation, QuadrantPulses) else loop.compensation
    return replace(loop, feedforward=feedforward, compensation=compensation)


def _with_parts(machine: Machine, **parts: Any) -> Machine:
    if all(getattr(axis, slot) == part for axis in machine.axes for slot, part in parts.items()):
        return machine
    return replace(machine, axes=tuple(replace(axis, **parts) for axis in machine.axes))


def without_backlash(machine: Machine, controller: Controller) -> tuple[Machine, Controller]:
    """Return the machine without free travel between motors and loads, under a controller that assumes none."""
    if all(a.plant.linear() == a.plant for a in machine.axes):
        return machine, controller
    tight = replace(machine, axes=tuple(replace(a, plant=a.plant.linear()) for a in machine.axes))
    return tight, replace(controller, axes={name: _unaware(mine) for name, mine in controller.axes.items()})


def _unaware(loop: AxisController) -> AxisController:
    """Set the gap that the parts of a controller assume to zero; observers and supervisors of the gap stay."""

    def unaware(part: Component) -> Component:
        return part.replace(backlash_gap=0.0) if "backlash_gap" in part.parameters else part

    compensation = None if loop.compensation is None else unaware(loop.compensation)
    others = tuple((label, unaware(part)) for label, part in loop.others)
    return replace(loop, controller=unaware(loop.controller), compensation=compensation, others=others)


def without_compliance(machine: Machine, controller: Controller) -> tuple[Machine, Controller]:
    """Return the machine with shafts that resonate at half of the servo frequency or above, under a controller without notch filters."""
    axes = tuple(_stiff(axis, machine.servo_period) for axis in machine.axes)
    if axes == machine.axes:
        return machine, controller
    stiff = replace(machine, axes=axes)
    return stiff, replace(controller, axes={name: _without_notches(mine) for name, mine in controller.axes.items()})


def _stiff(axis: Axis, period: float) -> Axis:
    if not isinstance(axis.plant, TwoSided):
        return axis
    plant = axis.plant.stiffened(0.5 / period)
    return replace(axis, plant=plant, substeps=max(axis.substeps, plant.fewest_substeps(period)[0]))


def _without_notches(loop: AxisController) -> AxisController:
    return replace(loop, filters=tuple((label, part) for label, part in loop.filters if not isinstance(part, Notch)))


def without_links(machine: Machine, controller: Controller) -> tuple[Machine, Controller]:
    """Return the controller in one piece: base and axes without a network between."""
    if all(mine.link is None for mine in controller.axes.values()):
        return machine, controller
    return machine, replace(controller, axes={name: replace(mine, link=None) for name, mine in controller.axes.items()})


def unlimited(machine: Machine) -> Machine:
    """Return the machine with drives that have no limit."""
    if all(getattr(a.drive, "limit", math.inf) == math.inf for a in machine.axes):
        return machine
    return replace(machine, axes=tuple(replace(a, drive=_without_limit(a.drive)) for a in machine.axes))


def _without_limit(drive: Component) -> Component:
    known = drive.parameters.get("limit")
    if known is None:
        return drive
    # Infinity is a value only where it is the default.
    free: Component = drive.replace(limit=math.inf if known.default == math.inf else min(known.maximum, 1e300))
    return free


def same_axes(machine: Machine, controller: Controller, name: str) -> tuple[Machine, Controller]:
    """Return machine and controller with every axis replaced by a copy of one of them, carried mass included."""
    model, mine = machine.axis(name), controller.axes[name]
    alone = replace(model, plant=machine.loaded_plant(name), mounted_on="", alignment=0.0, stage_mass=0.0)
    axes = tuple(replace(alone, name=a.name, limits=a.limits) for a in machine.axes)
    return replace(machine, axes=axes), replace(controller, axes={a.name: mine for a in machine.axes})
