"""Simulation of the EMPS along the log: a mass with friction under two nested loops.

The controller is nu = k_v (k_p (q_r - q) - v) with v = (q_k - q_(k-2))/(2 T), and saturates at 10 V. Between ticks the force is held; the
solution, sliding or sticking, is exact. This loop can do what the engine cannot: start in the state of the log, reproduce the published
solver with its chattering friction, and use friction by direction. `simulate_in_engine` runs all other cases in the engine; both agree.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from contourlab.analysis.identification.filtered_motion import FilteredMotion
from contourlab.analysis.identification.inverse_dynamics import InverseDynamicsFit
from contourlab.arrays import Array
from contourlab.components.disturbance.loads import TableLoad
from contourlab.components.drive.saturation import DelayedSaturation
from contourlab.components.ideal import IdealSensor
from contourlab.errors import ParameterError
from contourlab.feed import Reference
from contourlab.geometry import Line, Path
from contourlab.loop import Axis, Machine, simulate
from contourlab.papers.emps.log import EmpsLog
from contourlab.scenario import load_axis, load_controller

Advance = Callable[["EmpsAxis", float, float, float, float, float], tuple[float, float]]

LIMIT = 10.0
"""Saturation of the controller [V]."""
SUBSTEPS = 10
"""Steps of the published solver within a servo period."""


@dataclass(frozen=True)
class EmpsAxis:
    """A mass with friction by direction: M a = force - offset - friction(v).

    Attributes
    ----------
    mass, offset : float [kg, N]
    viscous, coulomb : (float, float) [N s/m, N]
        For forward and backward motion.
    """

    mass: float
    viscous: tuple[float, float]
    coulomb: tuple[float, float]
    offset: float = 0.0

    def acceleration(self, force: float, velocity: float) -> float:
        """Return the acceleration [m/s^2] under a force [N]; zero at rest up to Coulomb friction."""
        push = force - self.offset
        if velocity == 0.0 and -self.coulomb[1] <= push <= self.coulomb[0]:
            return 0.0
        way, side = _way(velocity if velocity != 0.0 else push)
        return (push - way * self.coulomb[side] - self.viscous[side] * velocity) / self.mass


@dataclass(frozen=True, eq=False)
class EmpsRun:
    """A simulated run, at the ticks.

    Attributes
    ----------
    time, position, velocity : ndarray (n,) [s, m, m/s]
    acceleration : ndarray (n,) [m/s^2]
        Acceleration right after the tick.
    force : ndarray (n,) [N]
        Force of the drive.
    """

    time: Array
    position: Array
    velocity: Array
    acceleration: Array
    force: Array


def axis_of(fit: InverseDynamicsFit) -> EmpsAxis:
    """Return the axis with identified parameters."""
    if fit.settings.friction == "asymmetric":
        return EmpsAxis(fit["M"], (fit["Fv+"], fit["Fv-"]), (fit["Fc+"], fit["Fc-"]))
    return EmpsAxis(fit["M"], (fit["Fv"],) * 2, (fit["Fc"],) * 2, fit["offset"])


def simulate_emps(log: EmpsLog, axis: EmpsAxis, *, delay: int = 0) -> EmpsRun:
    """Simulate an axis along the reference of a log, from the state in which the log starts.

    Parameters
    ----------
    delay : int, 0 or 1 [servo periods]
        Delay from the controller to the drive.
    """
    period = log.period
    # The first two voltages give the controller's state before the record.
    asked = log.position_gain * (log.reference[:2] - log.position[:2]) - (log.voltage[:2] - log.pulses[:2]) / log.velocity_gain
    earlier, last = (float(q - 2.0 * period * v) for q, v in zip(log.position[:2], asked, strict=True))
    start = float(log.position[0]), float(log.position[1] - last) / (2.0 * period)
    ticks = period * np.arange(log.time.size, dtype=np.float64)
    return _looped(log, axis, ticks, log.reference, log.pulses, delay, (last, earlier), start, advance)


def simulate_as_published(log: EmpsLog, axis: EmpsAxis) -> EmpsRun:
    """Simulate an axis like the published model: from rest, one tick of delay, with the published clock and solver.

    The clock is one difference of the logged time, t_10 - t_9. It is off by about 1e-5 and drifts against the log. Ten Runge-Kutta steps
    per tick do not locate reversals, so friction chatters at rest.
    """
    period = float(log.time[9] - log.time[8])
    ticks = period * np.arange(log.time.size, dtype=np.float64)
    reference, pulses = (np.interp(ticks, log.time, values) for values in (log.reference, log.pulses))
    return _looped(log, axis, ticks, reference, pulses, 1, (0.0, 0.0), (0.0, 0.0), _chatter)


def _looped(
    log: EmpsLog,
    axis: EmpsAxis,
    ticks: Array,
    reference: Array,
    pulses: Array,
    delay: int,
    before: tuple[float, float],
    start: tuple[float, float],
    plant: Advance,
) -> EmpsRun:
    """Run the loop; `before` has the positions one and two ticks before the first tick, `start` its position and velocity."""
    period = float(ticks[1])
    (last, earlier), (p, v), waiting = before, start, 0.0
    rows = np.empty((ticks.size, 4))
    added = np.diff(pulses, append=pulses[-1])
    for k, (asked, pulse, rise) in enumerate(zip(reference.tolist(), pulses.tolist(), added.tolist(), strict=True)):
        command = log.velocity_gain * (log.position_gain * (asked - p) - (p - earlier) / (2.0 * period))
        earlier, last = last, p
        if delay:
            command, waiting = waiting, command
        force = log.drive_gain * (min(max(command, -LIMIT), LIMIT) + pulse)
        rows[k] = p, v, axis.acceleration(force, v), force
        p, v = plant(axis, p, v, force, log.drive_gain * rise, period)
    return EmpsRun(ticks, *np.ascontiguousarray(rows.T))


def advance(axis: EmpsAxis, p: float, v: float, force: float, rise: float, period: float) -> tuple[float, float]:
    """Return position [m] and velocity [m/s] a period [s] later under a held force [N]: exact, with sticking; `rise` is ignored."""
    push, left = force - axis.offset, period
    while left > 0.0:
        if v == 0.0 and -axis.coulomb[1] <= push <= axis.coulomb[0]:
            return p, 0.0
        way, side = _way(v if v != 0.0 else push)
        drive, rate = (push - way * axis.coulomb[side]) / axis.mass, axis.viscous[side] / axis.mass
        reach = _reversal(v, drive, rate)
        span = min(left, reach)
        p, v = _slide(p, v, drive, rate, span)
        if reach <= left:
            v = 0.0
        left -= span
    return p, v


def _slide(p: float, v: float, drive: float, rate: float, span: float) -> tuple[float, float]:
    """Return position and velocity after integrating v' = drive - rate v over a time."""
    if abs(rate * span) < 1e-12:
        return p + (v + 0.5 * drive * span) * span, v + drive * span
    faded = -math.expm1(-rate * span)
    return p + drive / rate * span + (v - drive / rate) * faded / rate, v + (drive / rate - v) * faded


def _reversal(v: float, drive: float, rate: float) -> float:
    """Return the time after which v' = drive - rate v passes zero; infinite if never."""
    if v == 0.0 or drive == 0.0 or (v > 0.0) == (drive > 0.0) or rate * v / drive >= 1.0:
        return math.inf
    return -v / drive if rate == 0.0 else math.log1p(-rate * v / drive) / rate


def _chatter(axis: EmpsAxis, p: float, v: float, force: float, rise: float, period: float) -> tuple[float, float]:
    """Return position and velocity a period later by Runge-Kutta steps with sign(v) friction; pulses act as ramps."""
    h = period / SUBSTEPS
    (forward, backward), (up, down) = axis.viscous, axis.coulomb

    def slope(velocity: float, share: float) -> float:
        resisting = up + forward * velocity if velocity > 0.0 else backward * velocity - down if velocity < 0.0 else 0.0
        return (force + rise * share - axis.offset - resisting) / axis.mass

    for i in range(SUBSTEPS):
        at, middle, after = i / SUBSTEPS, (i + 0.5) / SUBSTEPS, (i + 1) / SUBSTEPS
        k1 = slope(v, at)
        k2 = slope(v + 0.5 * h * k1, middle)
        k3 = slope(v + 0.5 * h * k2, middle)
        k4 = slope(v + h * k3, after)
        p += h * v + h * h / 6.0 * (k1 + k2 + k3)
        v += h / 6.0 * (k1 + 2.0 * (k2 + k3) + k4)
    return p, v


def _way(velocity: float) -> tuple[float, int]:
    """Return the sign of the motion and the index of its friction."""
    return (1.0, 0) if velocity > 0.0 else (-1.0, 1)


def simulate_in_engine(log: EmpsLog, axis: EmpsAxis, *, delay: int = 0) -> EmpsRun:
    """Simulate an axis in the engine along the reference of a log, from rest at its first sample.

    Parameters
    ----------
    log : EmpsLog
        As in the published model, pulses act behind the drive: neither delayed nor limited.
    axis : EmpsAxis
        With equal friction in both directions.
    delay : int, 0 or 1 [servo periods]
        Delay from the controller to the drive.

    Raises
    ------
    ParameterError
        If friction depends on the direction.
    """
    machine = Machine("EMPS", (_library_axis(log, axis, delay),), log.period)
    controller = load_controller("builtin:emps/controller", machine)
    servo = controller.axes["x"]
    gains = servo.controller.replace(position_gain=log.position_gain, velocity_gain=log.velocity_gain)
    controller = replace(controller, axes={"x": replace(servo, controller=gains)})
    path = Path([Line(np.array([log.reference.min()]), np.array([log.reference.max()]))])
    reference = Reference.from_samples(log.reference[:, None], log.period, path)
    result = simulate(machine, controller, reference)
    position, velocity, applied = (result[name][:, 0] for name in ("axis_position", "axis_velocity", "applied_command"))
    force = log.drive_gain * (applied + log.pulses)
    acceleration = np.array([axis.acceleration(push, v) for push, v in zip(force.tolist(), velocity.tolist(), strict=True)])
    return EmpsRun(result.time, position, velocity, acceleration, force)


def _library_axis(log: EmpsLog, axis: EmpsAxis, delay: int) -> Axis:
    """Return the shipped axis with identified parameters and without an encoder, as in the published model."""
    for name, (forward, backward) in (("viscous", axis.viscous), ("coulomb", axis.coulomb)):
        if forward != backward:
            raise ParameterError(name, f"{forward:g} forwards, {backward:g} backwards", "equal in both directions")
    held = load_axis("builtin:emps/axis")
    behind_drive = log.drive_gain * log.pulses - axis.offset
    return replace(
        held,
        plant=held.plant.replace(mass=axis.mass, damping=axis.viscous[0], force_constant=log.drive_gain),
        friction=held.friction.replace(coulomb=axis.coulomb[0]),
        disturbance=TableLoad(time_step=log.period, forces=tuple(behind_drive.tolist())),
        drive=DelayedSaturation(limit=LIMIT, delay=delay * log.period) if delay else held.drive.replace(limit=LIMIT),
        sensor=IdealSensor(),
    )


def percent_errors(log: EmpsLog, measured: FilteredMotion, run: EmpsRun, dropped: int) -> dict[str, float]:
    """Return 100 |measured - simulated|/|measured| of position, velocity, acceleration and force.

    `measured` is the motion of the log after the low-pass of the identification; the first `dropped` samples do not count.
    """
    pairs = {
        "position": (measured.position, run.position),
        "velocity": (measured.velocity, run.velocity),
        "acceleration": (measured.acceleration, run.acceleration),
        "force": (log.force, run.force),
    }
    return {
        name: 100.0 * float(np.linalg.norm((logged - simulated)[dropped:]) / np.linalg.norm(logged[dropped:]))
        for name, (logged, simulated) in pairs.items()
    }
