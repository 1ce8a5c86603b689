"""The EMPS in contourlab's own engine: the axis and the controller of the machines library along the reference of a log."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from contourlab.components.drive.saturation import DelayedSaturation
from contourlab.components.ideal import IdealSensor
from contourlab.errors import ParameterError
from contourlab.feed import Reference
from contourlab.geometry import Line, Path
from contourlab.loop import Axis, Learned, Machine, simulate
from contourlab.papers.emps.log import EmpsLog
from contourlab.papers.emps.simulation import LIMIT, EmpsAxis, EmpsRun
from contourlab.scenario import load_axis, load_controller


def simulate_in_engine(log: EmpsLog, axis: EmpsAxis, *, delay: int = 0) -> EmpsRun:
    """Drive an axis along the reference of a log, from rest at its first sample.

    Parameters
    ----------
    log : EmpsLog
        Has gains, reference and pulses; these are added to the command as what an earlier trial has learned would be.
    axis : EmpsAxis
        With friction alike in both directions.
    delay : int, 0 or 1 [servo periods]
        From the controller to the drive.

    Raises
    ------
    ParameterError
        If the friction differs by direction.
    """
    machine = Machine("EMPS", (_axis(log, axis, delay),), log.period)
    controller = load_controller("builtin:emps/controller", machine)
    mine = controller.axes["x"]
    gains = mine.controller.replace(position_gain=log.position_gain, velocity_gain=log.velocity_gain)
    controller = replace(controller, axes={"x": replace(mine, controller=gains)})
    path = Path([Line(np.array([log.reference.min()]), np.array([log.reference.max()]))])
    reference = Reference.from_samples(log.reference[:, None], log.period, path)
    found = simulate(machine, controller, reference, learned=Learned(command=log.pulses[:, None]))
    position, velocity, applied = (found[name][:, 0] for name in ("axis_position", "axis_velocity", "applied_command"))
    force = log.drive_gain * applied
    acceleration = np.array([axis.acceleration(push, v) for push, v in zip(force.tolist(), velocity.tolist(), strict=True)])
    return EmpsRun(found.time, position, velocity, acceleration, force)


def _axis(log: EmpsLog, axis: EmpsAxis, delay: int) -> Axis:
    """Return the library's axis with other figures, and no encoder: the published model has none."""
    for name, (forward, backward) in (("viscous", axis.viscous), ("coulomb", axis.coulomb)):
        if forward != backward:
            raise ParameterError(name, f"{forward:g} forwards, {backward:g} backwards", "alike in both directions")
    held = load_axis("builtin:emps/axis")
    assert held.disturbance is not None  # the file's own
    return replace(
        held,
        plant=held.plant.replace(mass=axis.mass, damping=axis.viscous[0], force_constant=log.drive_gain),
        friction=held.friction.replace(coulomb=axis.coulomb[0]),
        disturbance=held.disturbance.replace(force=-axis.offset),
        drive=DelayedSaturation(limit=LIMIT, delay=delay * log.period) if delay else held.drive.replace(limit=LIMIT),
        sensor=IdealSensor(),
    )
