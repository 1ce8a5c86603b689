"""Poles, frequency response and margins of the sampled loop of one axis.

The schedule of the servo loop is built for the axis alone and cut where the command leaves the controller and where the observer's estimate
enters the controller. Each cut becomes an input. Every response then follows from one linear map, which has the node order, one-tick
delays, sampled filters, hold and drive delay of a run.

`sampled_loop` and its exact margins take milliseconds for one loop, too long for ten thousand candidates. For searches `lane_loops` returns
all variants of one axis at once: their rough margins, or whether they stay stable with the command multiplied by a factor or shifted in
phase.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.linear.margins import Margins, RoughMargins, frequency_grid, margins, rough_margins
from contourlab.analysis.linear.tick_map import (
    DelayForm,
    Probe,
    TickMap,
    lane_matrices,
    lane_probes,
    live_states,
    poles_of,
    poles_of_each,
    proved_stable,
    tick_map,
)
from contourlab.arrays import Array, Complex, Flags, Index
from contourlab.components.contract import Component
from contourlab.engine.step import Node, Port, Schedule
from contourlab.engine.translate.tick_loop import VECTOR
from contourlab.errors import ComponentError, ParameterError
from contourlab.geometry import Line, Path
from contourlab.loop.feeding import EXTERNALS
from contourlab.loop.judging import WATCH
from contourlab.loop.machine import Axis, AxisController, Controller, Machine
from contourlab.loop.parameters import parameters_of
from contourlab.loop.simulate import jit_enabled
from contourlab.loop.template import build


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


ALONG = Path([Line((0.0,), (1.0,))])
"""Any path: a single axis has no estimator."""
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
        return np.minimum(np.geomspace(min(2.0 * math.pi * 0.1, 1e-4 * self.nyquist), self.nyquist, n), self.nyquist)

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
        return frequency_grid(self.servo_period, np.concatenate([self.poles, poles_of(self.a)]), self._cut.longest)


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
    return loop_of(machine, made, tick_map(cut_open(whole_schedule(machine, made), axis.name)))


def bare_axis(axis: Axis, controller: AxisController, servo_period: float, carried_mass: float = 0.0) -> tuple[Machine, Controller]:
    """Return a machine of one axis and its controller, without nonlinear parts; parameters as in `sampled_loop`."""
    ahead = controller.feedforward
    # Feedforward is not part of the loop; if linear, it is part of the response to the reference.
    ahead = ahead if ahead is not None and ahead.linearize() is not None else None
    linear = replace(linear_controller(controller), feedforward=ahead, link=None)
    return Machine("axis", (linear_axis(axis, carried_mass),), servo_period), Controller({axis.name: linear})


def whole_schedule(machine: Machine, controller: Controller, columns: Mapping[str, Array] | None = None) -> Schedule:
    """Return the schedule of a bare axis; with `columns`, for variants."""
    return build(machine, controller, ALONG, np.zeros(1), overrides=columns).schedule


def cut_open(whole: Schedule, name: str) -> Schedule:
    """Return the schedule of a bare axis with its loop cut open.

    Raises
    ------
    ComponentError
        If a delay is longer than `LONGEST` ticks.
    """
    if sum(node.ring_length for node in whole.nodes) > LONGEST:
        raise ComponentError(f"axis {name}: a delay of more than {LONGEST} servo periods is too long for the analysis")
    # The command is cut after the controller, the estimate before it, and a load input is added.
    cuts = {"controller": {"disturbance_estimate": INPUTS[1]}, "plant": {"load": INPUTS[-1]}}
    nodes = []
    for node in _running(whole):
        wires = {port: wire for port, wire in cuts.get(node.name.rpartition(".")[2], {}).items() if port in node.wires}
        wires |= {port: INPUTS[0] for port, wire in node.wires.items() if wire == f"{name}.controller.command"}
        nodes.append(replace(node, wires={**node.wires, **wires}))
    externals = (*whole.externals, *(Port(signal.removeprefix("in.")) for signal in (*INPUTS[:2], INPUTS[-1])))
    return Schedule(tuple(nodes), externals, whole.period, len(nodes) - 1)


def _running(whole: Schedule) -> list[Node]:
    """Return the nodes of a schedule that act on the run."""
    return [node for node in whole.nodes if node.name != WATCH]


def loop_of(machine: Machine, controller: Controller, opened: TickMap) -> SampledLoop:
    """Return the loop of a bare axis from the map of its open schedule."""
    name, state = machine.axis_names[0], np.zeros((2, len(opened.a)))
    state[[0, 1], [opened.row(f"{name}.plant.position"), opened.row(f"{name}.plant.velocity")]] = 1.0
    inputs = opened.b[:, [opened.column(signal) for signal in INPUTS]]
    return SampledLoop(machine.servo_period, opened.a, inputs, _sent(name, controller, opened), state)


def _sent(name: str, controller: Controller, opened: TickMap) -> Array:
    """Return the rows (2, n) of command and estimate."""
    c = np.zeros((2, len(opened.a)))
    c[0, opened.row(f"{name}.controller.command")] = 1.0
    if controller.axes[name].observer is not None:
        c[1, opened.row(f"{name}.observer.disturbance_estimate")] = 1.0
    return c


def linear_axis(axis: Axis, carried_mass: float) -> Axis:
    """Return the axis alone, without nonlinear parts.

    Raises
    ------
    ComponentError
        If its plant takes positions.
    """
    if axis.plant.takes_position:
        raise ComponentError(f"axis {axis.name}: a {axis.plant.kind} takes positions: the control closes no loop, so there are no margins")
    plant, drive = axis.plant.loaded(carried_mass).linear(), without_limit(axis.drive)
    return Axis(axis.name, plant, drive=drive, limits=axis.limits, substeps=axis.substeps)


def linear_controller(controller: AxisController) -> AxisController:
    """Return the controller of an axis without nonlinear parts; under a supervisor the first one, which is for contact."""
    law, observer = without_limit(controller.controller).linear(), controller.observer and without_limit(controller.observer)
    return replace(controller, controller=law, observer=observer, others=(), gap_observer=None, compensation=None, supervisor=None)


LIMITS = ("limit", "command_limit")
"""Names of limits, which no linear model has."""


def without_limit(part: Component) -> Component:
    """Return a component without its limit, and without anti-windup: the drive never saturates here."""
    free: dict[str, Any] = {}
    for name, parameter in part.parameters.items():
        if name in LIMITS and parameter.default == math.inf:
            free[name] = math.inf
        elif name == "anti_windup" and "none" in parameter.choices:
            free[name] = "none"
    return part.replace(**free) if free else part


GRID = np.exp(1j * np.pi * np.geomspace(1e-4, 1.0, 200))
"""Where `LaneLoops.margins` computes the loop gain, in the z plane: up to the Nyquist frequency."""


MOST_FORMS = 8
"""Most forms of the open loop of an axis whose machine code is kept."""


class LaneLoops:
    """Open loops x(k + 1) = A x(k) + B u(k), y(k) = C x(k + 1), one for each variant, between the signals at the cuts.

    Attributes
    ----------
    a : ndarray (n_variant, n, n)
    b : ndarray (n_variant, n, 2)
        Command that enters the filters and the drive, estimate that enters the controller.
    c : ndarray (n_variant, 2, n)
    """

    def __init__(self, a: Array, b: Array, c: Array) -> None:
        self.a, self.b, self.c = a, b, c

    def __getitem__(self, variants: Index) -> LaneLoops:
        """Return the loops of some variants."""
        return LaneLoops(self.a[variants], self.b[variants], self.c[variants])

    def units(self) -> Array:
        """Return units of the states (n_variant, n) in which rows and columns of A of the closed loops are about as large."""
        units, size = np.ones(self.a.shape[:2]), np.abs(self.a + self.b @ (self.c @ self.a))
        for _ in range(2):
            with np.errstate(divide="ignore", invalid="ignore"):
                ratio = np.sqrt(size.sum(axis=2) / size.sum(axis=1))
            ratio[~((ratio > 0.0) & np.isfinite(ratio))] = 1.0
            size, units = size * ratio[:, None, :] / ratio[:, :, None], units * ratio
        return units

    def closed(self, factor: complex) -> tuple[Any, Any]:
        """Return A of the closed loops with the command multiplied by a factor, and I - C B (n_variant, 2, 2), what passes at once."""
        b = self.b * (np.array([factor, 1.0]).real if np.isreal(factor) else np.array([factor, 1.0]))
        direct = np.eye(2) - self.c @ b
        return self.a + b @ np.linalg.solve(direct, self.c @ self.a), direct

    def radius(self, factor: complex) -> Array:
        """Return the largest magnitude of the closed loop's poles (n_variant,) with the command multiplied by a factor.

        A complex factor of magnitude 1 acts as a lag at positive frequencies and as a lead at negative ones, or the reverse: the loop is
        stable only if it tolerates both.
        """
        return np.asarray(np.abs(poles_of_each(self.closed(factor)[0])).max(axis=1, initial=0.0))

    def margins(self) -> RoughMargins:
        """Return the margins by linear interpolation on a frequency grid, accurate to a few tenths of a decibel and of a degree.

        Good enough to guide a search; check its result with `SampledLoop.margins`.
        """
        # 1 + L is the ratio of two characteristic polynomials: with the command closed, and opened.
        (closed, through), (opened, bare) = ((poles_of_each(a), np.linalg.det(direct)) for a, direct in map(self.closed, (1.0, 0.0)))
        above, below = (np.ones((len(closed), GRID.size), dtype=complex) for _ in range(2))
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):  # loops that are not finite
            for zero, pole in zip(closed.T, opened.T, strict=True):
                above *= GRID - zero[:, None]
                below *= GRID - pole[:, None]
            gain = (through / bare)[:, None] * above / below - 1.0
            return rough_margins(gain, np.abs(closed).max(axis=1, initial=0.0) < 1.0)


def margin_factors(gain: float, phase: float) -> tuple[complex, ...]:
    """Return the factors under which a loop with these margins is stable.

    Parameters
    ----------
    gain : float, >= 1
        Gain margin as a factor.
    phase : float [rad], >= 0

    Notes
    -----
    Only the ends of each range are tested: compute exact margins for the result of a search. A gain of 1 or a phase of 0 adds no factor.
    """
    return (1.0, *((gain,) if gain > 1.0 else ()), *((complex(np.exp(-1j * phase)),) if phase > 0.0 else ()))


def unstable_by(loops: LaneLoops, factors: Sequence[complex]) -> Array:
    """Return how far (n_variant,) the largest pole over some factors lies outside the unit circle.

    Where all are stable, the result is negative; it is -1 where that is proved without the poles.
    """
    excess, read = np.full(len(loops.a), -1.0), np.flatnonzero(loops.a.any(axis=(0, 1)))  # outputs, which no state reads, have no pole
    with np.errstate(invalid="ignore", over="ignore"):  # loops that are not finite
        units, closed = loops.units()[:, read], [loops.closed(factor)[0] for factor in factors]
        scale = units[:, None, :] / units[:, :, None]
        proofs = [proved_stable(a[:, read[:, None], read] * scale) for a in closed]
    for a, proved in zip(closed, proofs, strict=True):
        left = np.flatnonzero(~proved)
        if left.size:
            excess[left] = np.maximum(excess[left], np.abs(poles_of_each(a[left])).max(axis=1, initial=0.0) - 1.0)
    return excess


def lane_loops(
    axis: Axis, controller: AxisController, servo_period: float, carried_mass: float, overrides: Mapping[str, Array]
) -> LaneLoops:
    """Return the open loops of one axis for many sets of parameters.

    Parameters
    ----------
    axis, controller, servo_period, carried_mass
        As in `contourlab.analysis.linear.sampled_loop.sampled_loop`.
    overrides : mapping of str to ndarray (n_variant,)
        Values [SI] by dotted names; names outside the loop of this axis are ignored.

    Raises
    ------
    ComponentError
        If a step is not linear, or a delay is too long for the analysis.
    """
    return AxisLanes(axis, controller, servo_period, carried_mass)(overrides)


class AxisLanes:
    """The open loop of one axis, prepared for many sets of parameters; arguments as of `sampled_loop`.

    A search asks for the same parameters again and again: the schedule is cut and its machine code is looked up only once.
    """

    def __init__(self, axis: Axis, controller: AxisController, servo_period: float, carried_mass: float) -> None:
        self.machine, self.bare = bare_axis(axis, controller, servo_period, carried_mass)
        self._known = parameters_of(self.machine, self.bare)
        self._probes: dict[tuple[object, ...], list[Probe]] = {}

    def __call__(self, overrides: Mapping[str, Array]) -> LaneLoops:
        """Return the open loops, as `lane_loops` does."""
        n = len(next(iter(overrides.values()), (0.0,)))
        # The loop of one axis has no estimator of the coupling, and no limits.
        free = [name for name in overrides if name in self._known and name.rpartition(".")[2] not in LIMITS]
        used = {name: np.asarray(overrides[name], dtype=float) for name in free}
        whole, jit, different = whole_schedule(self.machine, self.bare, used), jit_enabled(), n if used else 1
        form = (-(-different // VECTOR), jit, *used, *(node.ring_length for node in whole.nodes))
        probes = self._probes.pop(form, None)  # no other thread takes them meanwhile
        if probes is None:
            probes = lane_probes(cut_open(whole, self.machine.axis_names[0]), different, jit)
        else:
            for probe in probes:
                probe.take(_running(whole))
        schedule = probes[0].group.schedule
        a, b = lane_matrices(probes, different, [schedule.row(signal) for signal in INPUTS[:2]])
        if len(self._probes) >= MOST_FORMS:
            self._probes.clear()
        self._probes[form] = probes
        c = _sent(self.machine.axis_names[0], self.bare, TickMap(a[0], b[0], schedule))
        moved = np.asarray((a != np.eye(a.shape[1])).any(axis=0))
        driven: Flags = np.asarray((b != 0.0).any(axis=(0, 2)))
        read: Flags = np.asarray(c.any(axis=0))
        kept = np.flatnonzero((moved.any(axis=1) | driven) & (moved.any(axis=0) | read))
        # A cut signal enters at the tick in which it leaves: keep a command even if no past state drives it.
        kept = kept[live_states((a[:, kept][:, :, kept] != 0.0).any(axis=0), driven[kept], read[kept])]
        shapes = (n, kept.size, kept.size), (n, kept.size, 2), (n, 2, kept.size)
        return LaneLoops(*map(np.broadcast_to, (a[:, kept][:, :, kept], b[:, kept], c[:, kept]), shapes))
