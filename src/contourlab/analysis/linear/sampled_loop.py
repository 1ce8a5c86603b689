"""Poles, frequency response and margins of the sampled loop of one axis.

The schedule of the servo loop is built for the axis alone and cut where the command leaves the controller and where the observer's estimate
enters the controller. Each cut becomes an input. Every response then follows from one linear map, which has the node order, one-tick
delays, sampled filters, hold and drive delay of a run.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.linear.margins import Margins, frequency_grid, margins
from contourlab.analysis.linear.tick_map import DelayForm, TickMap, poles_of, tick_map
from contourlab.arrays import Array, Complex
from contourlab.components.contract import Component
from contourlab.engine.schedule import Schedule
from contourlab.engine.step import Port
from contourlab.errors import ComponentError, ParameterError
from contourlab.geometry import Line, Path
from contourlab.loop.judging import WATCH
from contourlab.loop.machine import Axis, AxisController, Controller, Machine
from contourlab.loop.template import EXTERNALS, build


@dataclass(frozen=True, eq=False)
class AxisResponse:
    """Complex responses (n_frequency,) of one axis; for a sampled loop, between samples.

    Attributes
    ----------
    frequency : ndarray [rad/s]
    closed_loop : ndarray
        Position over reference, feedforward included.
    modified : ndarray
        Position over the modified reference alone, which acts on position and integral, without feedforward of its derivatives.
    loop_gain : ndarray
        The loop opened at the command, sign such that -1 is the critical point.
    compliance : ndarray [m per force unit]
        Position over load; in a sampled loop the load is held over the servo period.
    compensated : ndarray [m/s per command unit]
        Velocity over the command before the observer's correction: the plant that the position loop sees.
    """

    frequency: Array
    closed_loop: Complex
    modified: Complex
    loop_gain: Complex
    compliance: Complex
    compensated: Complex


LONGEST = 1000
"""Longest delay [ticks]; beyond it the poles take longer to compute than a run."""
INPUTS = ("in.command", "in.disturbance_estimate", *(f"in.{name}" for name in EXTERNALS), "in.load")


@dataclass(frozen=True, eq=False)
class SampledLoop:
    """The open loop, x(k + 1) = A x(k) + B u(k), y(k) = C x(k + 1).

    Attributes
    ----------
    servo_period : float [s]
    a : ndarray (n, n)
    b : ndarray (n, 6)
        Inputs: command that enters the filters and the drive, estimate that enters the controller, reference, its velocity and
        acceleration, load.
    c : ndarray (2, n)
        Outputs: the controller's command, the observer's estimate (zero without an observer). They close the loop at the first two inputs.
    state : ndarray (2, n)
        Position and velocity at tick k, from x(k).
    """

    servo_period: float
    a: Array
    b: Array
    c: Array
    state: Array

    @property
    def nyquist(self) -> float:
        """Half of the sampling frequency [rad/s]."""
        return math.pi / self.servo_period

    @cached_property
    def closed(self) -> tuple[Array, Array]:
        """A (n, n) and B (n, 4) of the closed loop, whose inputs are the reference, its derivatives, and the load."""
        cut, free = self.b[:, :2], self.b[:, 2:]
        # The outputs of the controllers enter at the same tick.
        gain = cut @ np.linalg.solve(np.eye(2) - self.c @ cut, self.c)
        return self.a + gain @ self.a, free + gain @ free

    @cached_property
    def poles(self) -> Complex:
        """Poles of the closed loop in the z plane, without states that only store a value or that nothing reads."""
        return poles_of(self.closed[0])

    @property
    def stable(self) -> bool:
        """Whether all poles lie inside the unit circle."""
        return bool(np.abs(self.poles).max(initial=0.0) < 1.0)

    def frequencies(self, n: int = 300) -> Array:
        """Return frequencies (n,) [rad/s] for a plot, from 0.1 Hz or 1e-4 of Nyquist, the lower of the two, up to the Nyquist frequency."""
        low = min(2.0 * math.pi * 0.1, 1e-4 * self.nyquist)
        return np.minimum(np.geomspace(low, self.nyquist, n), self.nyquist)

    def margins(self) -> Margins:
        """Return the margins of the loop opened at the drive, up to the Nyquist frequency."""
        return margins(self.loop_gain, self._grid(), stable=self.stable)

    def loop_gain(self, frequency: ArrayLike) -> Complex:
        """Return the loop opened at the drive (n,), sign such that -1 is the critical point.

        Parameters
        ----------
        frequency : array_like (n,) [rad/s]
            Above 0 and up to the Nyquist frequency.

        Raises
        ------
        ParameterError
            If a frequency is out of range.
        """
        return _gain(self._opened(checked_frequency(frequency, self.nyquist)))

    def response(self, frequency: ArrayLike) -> AxisResponse:
        """Return the responses of the axis at frequencies (n,) [rad/s] above 0 and up to the Nyquist frequency.

        Raises
        ------
        ParameterError
            If a frequency is out of range.
        """
        w = checked_frequency(frequency, self.nyquist)
        opened, driven = self._opened(w), self._driven(np.exp(1j * w * self.servo_period))[:, 0]
        return AxisResponse(
            frequency=w,
            closed_loop=driven[:, 0] + 1j * w * driven[:, 1] - w * w * driven[:, 2],
            modified=driven[:, 0],
            loop_gain=_gain(opened),
            compliance=driven[:, 3],
            compensated=opened[:, 3, 0] / (1.0 - opened[:, 0, 1] * opened[:, 1, 0]),
        )

    @cached_property
    def _driven(self) -> DelayForm:
        """Closed-loop responses of position to the reference, its derivatives, and the load."""
        return DelayForm(*self.closed, self.state[:1])

    @cached_property
    def _cut(self) -> DelayForm:
        return DelayForm(self.a, self.b[:, :2], np.vstack([self.c, self.state]))

    def _opened(self, w: Array) -> Complex:
        """Return command, estimate, position and velocity over the two cut inputs: (n, 4, 2)."""
        z = np.exp(1j * w * self.servo_period)
        response = self._cut(z)
        # The outputs of the controllers at tick k are in x(k + 1).
        response[:, :2] *= z[:, None, None]
        return response

    def _grid(self) -> Array:
        poles = np.concatenate([self.poles, poles_of(self.a)])
        return frequency_grid(self.servo_period, poles, self._cut.longest)


def checked_frequency(frequency: ArrayLike, nyquist: float) -> Array:
    """Return frequencies (n,) [rad/s]; raise `ParameterError` unless all are above 0 and up to the Nyquist frequency."""
    w = np.atleast_1d(np.asarray(frequency, dtype=float))
    if not ((w > 0.0) & (w <= nyquist * (1.0 + 1e-9))).all():
        raise ParameterError("frequency", "an array", f"> 0 and up to the Nyquist frequency, {nyquist:g}", "rad/s")
    return w


def _gain(opened: Complex) -> Complex:
    """Return the loop gain: the command is cut, the estimate is not."""
    return np.asarray(-(opened[:, 0, 0] + opened[:, 0, 1] * opened[:, 1, 0]))


def sampled_loop(axis: Axis, controller: AxisController, servo_period: float, carried_mass: float = 0.0) -> SampledLoop:
    """Return the sampled loop of an axis, without friction, disturbance, quantisation and limits.

    The axis is alone: no cross-coupling, no reaction between axes that carry each other, and no link between base and axis (see
    `contourlab.analysis.linear.divided_loop`).

    Parameters
    ----------
    servo_period : float [s], > 0
    carried_mass : float [kg]
        Mass of the axes that this one carries.

    Raises
    ------
    ComponentError
        If a component is not linear, or a delay is longer than `LONGEST` ticks.
    """
    machine, made = bare_axis(axis, controller, servo_period, carried_mass)
    return loop_of(machine, made, tick_map(opened_schedule(machine, made)))


def bare_axis(axis: Axis, controller: AxisController, servo_period: float, carried_mass: float = 0.0) -> tuple[Machine, Controller]:
    """Return a machine of one axis and its controller, without nonlinear parts; parameters as in `sampled_loop`."""
    ahead = controller.feedforward
    # Feedforward is not part of the loop; if linear, it is part of the response to the reference.
    ahead = ahead if ahead is not None and ahead.linearize() is not None else None
    # Under a supervisor the loop is that of the first controller, which is for contact.
    nonlinear = dict.fromkeys(("gap_observer", "compensation", "supervisor", "link"))
    made = replace(controller, controller=without_limits(controller.controller).linear(), feedforward=ahead, others=(), **nonlinear)  # type: ignore[arg-type]
    return Machine("axis", (linear_axis(axis, carried_mass),), servo_period), Controller({axis.name: made})


def opened_schedule(machine: Machine, controller: Controller, columns: Mapping[str, Array] | None = None) -> Schedule:
    """Return the schedule of a bare axis with its loop cut open; with `columns`, for variants.

    Raises
    ------
    ComponentError
        If a delay is longer than `LONGEST` ticks.
    """
    name = machine.axis_names[0]
    whole = build(machine, controller, Path([Line((0.0,), (1.0,))]), np.zeros(1), overrides=columns).schedule
    if sum(node.ring_length for node in whole.nodes) > LONGEST:
        raise ComponentError(f"axis {name}: a delay of more than {LONGEST} servo periods is too long for the analysis")
    return _opened(name, whole)


def loop_of(machine: Machine, controller: Controller, opened: TickMap) -> SampledLoop:
    """Return the loop of a bare axis from the map of its open schedule."""
    name = machine.axis_names[0]
    c, state = np.zeros((2, len(opened.a))), np.zeros((2, len(opened.a)))
    c[0, opened.row(f"{name}.controller.command")] = 1.0
    if controller.axes[name].observer is not None:
        c[1, opened.row(f"{name}.observer.disturbance_estimate")] = 1.0
    state[[0, 1], [opened.row(f"{name}.plant.position"), opened.row(f"{name}.plant.velocity")]] = 1.0
    return SampledLoop(machine.servo_period, opened.a, opened.b[:, [opened.column(signal) for signal in INPUTS]], c, state)


def _opened(name: str, whole: Schedule) -> Schedule:
    """Cut the command after the controller and the estimate before it, and add a load input."""
    cuts = {"controller": {"disturbance_estimate": INPUTS[1]}, "plant": {"load": INPUTS[-1]}}
    nodes = []
    for node in whole.nodes:
        wires = {port: wire for port, wire in cuts.get(node.name.rpartition(".")[2], {}).items() if port in node.wires}
        wires |= {port: INPUTS[0] for port, wire in node.wires.items() if wire == f"{name}.controller.command"}
        if node.name != WATCH:
            nodes.append(replace(node, wires={**node.wires, **wires}))
    externals = (*whole.externals, *(Port(signal.removeprefix("in.")) for signal in (*INPUTS[:2], INPUTS[-1])))
    return Schedule(tuple(nodes), externals, whole.period, len(nodes) - 1)


def linear_axis(axis: Axis, carried_mass: float) -> Axis:
    """Return the axis alone, without nonlinear parts."""
    drive, limit = axis.drive, axis.drive.parameters.get("limit")
    if limit is not None and limit.default == math.inf:
        drive = drive.replace(limit=math.inf)
    plant = axis.plant.loaded(carried_mass).linear()
    return Axis(axis.name, plant, drive=drive, limits=axis.limits, substeps=axis.substeps)


def without_limits(controller: Component) -> Component:
    """Return the controller without its own limit and without anti-windup: the drive never saturates here."""
    known = controller.parameters
    free: dict[str, Any] = {}
    if "anti_windup" in known and "none" in known["anti_windup"].choices:
        free["anti_windup"] = "none"
    if "command_limit" in known and known["command_limit"].default == math.inf:
        free["command_limit"] = math.inf
    return controller.replace(**free) if free else controller
