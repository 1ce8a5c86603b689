"""Linear model of the axes and their coupling for small errors around the reference, computed from the steps that run.

Each axis forms a closed loop with its controller. Its inputs are additions to its command (cross-coupling correction, learned table) and
shifts of its reference. The coupling is linearised for an error in one direction.

`TrialMap` is a whole trial, with the turning normal. The samples are cut into segments that run in parallel, first from rest, then from
their true start. The transition matrix of each segment is computed once. A trial of 30 000 samples costs a few hundred small matrix
products.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.linear.sampled_loop import SampledLoop, checked_frequency, sampled_loop, without_limit
from contourlab.analysis.linear.tick_map import DelayForm, Probe, live_states, poles_of
from contourlab.arrays import Array, Complex, Index
from contourlab.components.contract import Component, response_of
from contourlab.engine.step import Node, Schedule
from contourlab.errors import ComponentError, ParameterError
from contourlab.loop.machine import Controller, Machine

NEGLIGIBLE = 1e-13
"""Share of its largest value below which an impulse response has decayed."""
LOOK = 512
"""Samples for which it must stay that small."""


@dataclass(frozen=True, eq=False)
class AxisLink:
    """The closed loop of one axis: x(k + 1) = A x(k) + b v(k) + r m(k), where v is added to its command and m to its reference.

    Attributes
    ----------
    a : ndarray (n, n)
    b, r : ndarray (n,)
        Inputs of v and m.
    position : ndarray (n,)
        Position at tick k from x(k).
    command : ndarray (n + 2,)
        Command at tick k from x(k), v(k), m(k), v included.
    """

    loop: SampledLoop
    a: Array
    b: Array
    r: Array
    position: Array
    command: Array

    def form(self, frequency: ArrayLike) -> Complex:
        """Return the responses (n, 2, 2) of position and command to an added command and a shift of the reference."""
        response = self._form(np.exp(1j * checked_frequency(frequency, self.loop.nyquist) * self.loop.servo_period))
        response[:, 1] += self.command[-2:]
        return np.asarray(response)

    @cached_property
    def _form(self) -> DelayForm:
        return DelayForm(self.a, np.column_stack([self.b, self.r]), np.vstack([self.position, self.command[:-2]]))


@dataclass(frozen=True, eq=False)
class CouplingModel:
    """A coupling, linearised for an error in one direction.

    Attributes
    ----------
    f, g, h, d : ndarray (m, m), (m,), (m,), float
        q(k + 1) = F q + g eps, correction = h q + d eps: from the contour error eps, along the normal from the tool to the path, to the
        correction along the same normal. All zero for a coupling without correction.
    weight : float
        lambda, the share of the position along the path that the modified reference discards; 0 without a modified reference.
    servo_period : float [s]
    """

    f: Array
    g: Array
    h: Array
    d: float
    weight: float
    servo_period: float

    def __call__(self, frequency: ArrayLike) -> Complex:
        """Return C_cc (n,) at frequencies (n,) [rad/s]."""
        z = np.exp(1j * np.atleast_1d(np.asarray(frequency, dtype=float)) * self.servo_period)
        return np.asarray(response_of(self.f, self.g[:, None], self.h[None, :], self.d, z)[:, 0, 0])


@dataclass(frozen=True, eq=False)
class LoopMatrices:
    """One tick with the coupling removed; the states are those of the axes, then those of the coupling.

    Attributes
    ----------
    n_axis_state : int
        States of the axes.
    a : ndarray (n, n)
    pushed, referred : ndarray (n, n_axis)
        Inputs added to the commands, and to the references.
    position, command : ndarray (n_axis, n)
    command_pushed, command_referred : ndarray (n_axis,)
        Direct feedthrough of these inputs to the commands.
    coupling_in, coupling_out : ndarray (n, n_normal), (n_normal, n)
        From contour errors to the coupling's states, and from these states to corrections.
    """

    n_axis_state: int
    a: Array
    pushed: Array
    referred: Array
    position: Array
    command: Array
    command_pushed: Array
    command_referred: Array
    coupling_in: Array
    coupling_out: Array


@dataclass(frozen=True, eq=False)
class CoupledLoop:
    """The axes of a machine with the coupling between them.

    Attributes
    ----------
    servo_period : float [s]
    """

    names: tuple[str, ...]
    axes: tuple[AxisLink, ...]
    coupling: CouplingModel
    servo_period: float

    @property
    def nyquist(self) -> float:
        """Half of the sampling frequency [rad/s]."""
        return float(np.pi / self.servo_period)

    def frequencies(self, n: int = 300) -> Array:
        """Return frequencies (n,) [rad/s] for a plot, up to the Nyquist frequency."""
        return self.axes[0].loop.frequencies(n)

    def matrices(self, n_normal: int) -> LoopMatrices:
        """Return the matrices of one tick with the coupling removed, for `n_normal` normals at each point of the path."""
        eye = np.eye(n_normal)
        f, g, h = (np.kron(part, eye) for part in (self.coupling.f, self.coupling.g[:, None], self.coupling.h[None, :]))
        n, m = sum(len(axis.a) for axis in self.axes), len(f)
        entering = [axis.b[:, None] for axis in self.axes], [axis.r[:, None] for axis in self.axes]
        pushed, referred = (np.pad(_diagonal(columns), ((0, m), (0, 0))) for columns in entering)
        leaving = [axis.position[None] for axis in self.axes], [axis.command[None, :-2] for axis in self.axes]
        position, command = (np.pad(_diagonal(rows), ((0, 0), (0, m))) for rows in leaving)
        direct = np.array([axis.command[-2:] for axis in self.axes])
        ends: list[Array] = [np.pad(g, ((n, 0), (0, 0))), np.pad(h, ((0, 0), (n, 0)))]
        a = _diagonal([*(axis.a for axis in self.axes), np.asarray(f, dtype=float)])
        return LoopMatrices(n, a, pushed, referred, position, command, direct[:, 0], direct[:, 1], *ends)

    def matrix(self, normals: Array) -> Array:
        """Return the matrix of a tick for constant normals (n_axis, n_normal); the states are those of `matrices`."""
        made = self.matrices(normals.shape[1])
        a, n = made.a, made.n_axis_state
        pushed, referred, positions, in_, out = (
            np.ascontiguousarray(part)
            for part in (made.pushed[:n], made.referred[:n], made.position[:, :n], made.coupling_in[n:], made.coupling_out[:, n:])
        )
        across, along = normals @ normals.T, np.eye(len(normals)) - normals @ normals.T
        a[:n, :n] += -self.coupling.d * pushed @ across @ positions + self.coupling.weight * referred @ along @ positions
        a[:n, n:] = pushed @ normals @ out
        a[n:, :n] = -in_ @ normals.T @ positions
        return a

    def poles(self, normals: Array) -> Complex:
        """Return the poles of the machine for constant normals (n_axis, n_normal)."""
        return poles_of(self.matrix(normals))


def _diagonal(blocks: Sequence[Array]) -> Array:
    """Return a matrix with blocks along its diagonal, and zeros elsewhere."""
    made, row, column = np.zeros(np.sum([block.shape for block in blocks], axis=0)), 0, 0
    for block in blocks:
        made[row : row + block.shape[0], column : column + block.shape[1]] = block
        row, column = row + block.shape[0], column + block.shape[1]
    return made


def coupled_loop(machine: Machine, controller: Controller) -> CoupledLoop:
    """Return the linear model of a machine for small errors, without friction, disturbance, quantisation, limits and feedforward.

    Reactions between axes that carry each other are left out.

    Raises
    ------
    ComponentError
        If a component is not linear, or the analysis does not know the kind of coupling.
    """
    period = machine.servo_period
    links = tuple(axis_link(machine, controller, name) for name in machine.axis_names)
    return CoupledLoop(machine.axis_names, links, coupling_model(controller.coupling, period), period)


def axis_link(machine: Machine, controller: Controller, name: str) -> AxisLink:
    """Return the closed loop of one axis, without feedforward, which is not part of the loop."""
    alone = replace(controller.axes[name], feedforward=None)
    return link_of(sampled_loop(machine.axis(name), alone, machine.servo_period, machine.carried_mass(name)))


def link_of(loop: SampledLoop) -> AxisLink:
    """Close a sampled loop; the inputs are additions to its command and reference."""
    cut, c = loop.b[:, :2], loop.c
    # The controller's command and additions enter the drive at the same tick.
    inner = np.linalg.inv(np.eye(2) - c @ cut)
    closed, driven = loop.closed
    pushed, referred = cut @ inner[:, 0], driven[:, 0]
    through = c[0] @ closed
    kept = _live(closed, np.column_stack([pushed, referred]), np.vstack([loop.state[0], through]))
    # The command includes the addition.
    direct = np.array([c[0] @ pushed + 1.0, c[0] @ referred])
    return AxisLink(
        loop, closed[np.ix_(kept, kept)], pushed[kept], referred[kept], loop.state[0, kept], np.concatenate([through[kept], direct])
    )


def impulse_responses(axes: Sequence[AxisLink], n_sample: int, target: str) -> Array:
    """Return the position of each axis alone after a unit impulse at sample 0, added to its command or reference.

    Parameters
    ----------
    axes : sequence of AxisLink
        The response of an unstable axis has all `n_sample` samples.
    n_sample : int
        Largest number of samples.
    target : {"command", "reference"}

    Returns
    -------
    ndarray (m, n_axis) [m per command unit, or m/m]
        m <= n_sample; later values are below 1e-13 of the largest.
    """
    responses = [_impulse_response(axis, n_sample, target) for axis in axes]
    longest = max(len(response) for response in responses)
    return np.column_stack([np.pad(response, (0, longest - len(response))) for response in responses])


def _impulse_response(axis: AxisLink, n_sample: int, target: str) -> Array:
    response, state = np.zeros(n_sample), axis.b if target == "command" else axis.r
    largest = 0.0
    for k in range(1, n_sample):
        response[k] = axis.position @ state
        state = axis.a @ state
        # Check many samples: one alone may be near zero, and a long delay may precede the response.
        if k % LOOK == 0:
            last = float(np.abs(response[k - LOOK : k + 1]).max())
            largest = max(largest, last)
            if largest > 0.0 and last <= NEGLIGIBLE * largest:
                return response[: k + 1]
    return response


def _live(a: Array, b: Array, c: Array) -> Index:
    """Return the states that inputs reach and outputs read, without states that only keep their value."""
    return live_states((a != 0.0) & ~np.eye(len(a), dtype=bool), (b != 0.0).any(axis=1), (c != 0.0).any(axis=0))


def coupling_model(coupling: Component | None, servo_period: float) -> CouplingModel:
    """Return the model of a coupling for an error in one constant direction; it does not depend on the number of axes.

    Parameters
    ----------
    coupling : Component or None
        Of the family coupling; None gives a model of zeros.
    servo_period : float [s], > 0

    Raises
    ------
    ComponentError
        If it is not linear in the error, or has a form that this analysis does not cover.
    """
    if coupling is None:
        return CouplingModel(np.zeros((0, 0)), np.zeros(0), np.zeros(0), 0.0, 0.0, servo_period)
    feeding = [name for name in ("velocity", "disturbance_estimate") if coupling.takes(name)] + ["rate"] * coupling.gives("rate")
    if feeding:
        raise ComponentError(f"coupling {coupling.kind} feeds back by its port {feeding[0]}, which this analysis does not cover")
    probe = _CouplingProbe(coupling, servo_period)
    m, size = len(probe.own), len(probe.own) + 2
    matrix = np.column_stack([probe(unit) for unit in np.eye(size)])
    point = np.random.default_rng(1).normal(size=size)
    if not np.allclose(probe(point), matrix @ point, rtol=1e-9, atol=1e-9 * float(np.abs(matrix).max(initial=0.0))):
        raise ComponentError(f"coupling {coupling.kind} is not linear in the contour error, so it has no frequency response")
    # Rows: next states, correction across, correction along, shift across, shift along; columns: states, position across, position along.
    across, along = -matrix[:, m], matrix[:, m + 1]
    # Allowed: a correction across from the error across, and a shift along from the position along. All else must be zero.
    form = np.zeros(matrix.shape, dtype=bool)
    form[: m + 1, : m + 1] = form[m + 3, m + 1] = True
    form[:m, m + 1] = (matrix[:, :m] == 0.0).all(axis=0)
    if np.abs(matrix[~form]).max() > 1e-9 * float(np.abs(matrix).max()):
        raise ComponentError(f"coupling {coupling.kind} neither corrects along the normal nor weights the error along the path")
    kept = _live(matrix[:m, :m], across[:m, None], matrix[m : m + 1, :m])
    f, g, h = matrix[np.ix_(kept, kept)], across[kept], matrix[m, kept]
    return CouplingModel(f, g, h, float(across[m]), float(along[m + 3]), servo_period)


class _CouplingProbe:
    """Run one tick of a coupling in the plane, on a path along the first axis, from any state and tool position."""

    def __init__(self, coupling: Component, servo_period: float) -> None:
        part = without_limit(coupling)
        step = part.make_step(2)
        node = Node("coupling", step, {port.name: f"in.{port.name}" for port in step.inputs}, part.block(servo_period), part.table_values())
        self.probe = Probe(Schedule((node,), step.inputs, servo_period, 1))
        # The first tick sets the direction; the state that stores it is not part of the loop.
        self.own = [i for i, name in enumerate(name for port in step.states for name in [port.name] * port.rows) if name != "tangent"]
        self.rest = self._tick(np.zeros(self.probe.size), 0.0, 0.0)
        self.offset = self._seen(self._tick(self.rest, 0.0, 0.0))

    def __call__(self, at: Array) -> Array:
        state = self.rest.copy()
        state[self.own] += at[:-2]
        return self._seen(self._tick(state, float(at[-2]), float(at[-1]))) - self.offset

    def _seen(self, after: Array) -> Array:
        """Return the own states, and correction and shift, each across and along."""
        schedule, outputs = self.probe.group.schedule, np.zeros((2, 2))
        signals = after[-schedule.n_row :]
        for pair, port in zip(outputs, ("correction", "modified_reference"), strict=True):
            if any(port == known.name for known in schedule.nodes[0].step.outputs):
                row = schedule.row(f"coupling.{port}")
                pair[:] = signals[row + 1], signals[row]
        return np.concatenate([after[self.own], *outputs])

    def _tick(self, state: Array, across: float, along: float) -> Array:
        offered: dict[str, list[float]] = {
            "position": [along, across],
            "foot_position": [along, 0.0],
            "error_vector": [0.0, -across],
            "contour_error_estimate": [across],
            "tangent": [1.0, 0.0],
        }
        inputs = np.concatenate([offered.get(port.name, [0.0] * port.rows) for port in self.probe.group.schedule.externals])
        return self.probe.after(state, inputs)[:, 0]


def normal_basis(tangent: ArrayLike) -> Array:
    """Return unit vectors (n_axis, n_axis - 1) at right angles to a direction and to each other; in the plane the left normal.

    >>> normal_basis([1.0, 0.0]).T
    array([[-0.,  1.]])
    """
    t = np.asarray(tangent, dtype=float)
    t = t / np.linalg.norm(t)
    if t.size == 2:
        return np.array([[-t[1]], [t[0]]])
    return np.asarray(np.linalg.svd(t[None, :])[2][1:].T)


def normal_frames(tangents: ArrayLike) -> Array:
    """Return unit normals (n_sample, n_axis, n_axis - 1), each rotated as little as possible from the one before.

    Parameters
    ----------
    tangents : array_like (n_sample, n_axis)
        Of length 1. In the plane the frame is the left normal itself.
    """
    t = np.asarray(tangents, dtype=float)
    if t.shape[1] == 2:
        return np.stack([-t[:, 1], t[:, 0]], axis=1)[:, :, None]
    frames = np.empty((len(t), t.shape[1], t.shape[1] - 1))
    if t.shape[1] == 1:
        return frames
    frames[0] = normal_basis(t[0])
    for k in range(1, len(t)):
        total = 1.0 + float(t[k - 1] @ t[k])
        turn = (t[k - 1] + t[k]) / total if total > 1e-6 else t[k]
        frames[k] = frames[k - 1] - np.outer(turn, t[k] @ frames[k - 1])
    return frames


class TrialMap:
    """Effect of a table on a trial, for small errors: u (n_sample, n_axis) -> tracking error and feedback command.

    Parameters
    ----------
    tangents : ndarray (n_sample, n_axis)
        Direction of the path at each sample.
    target : str
        ``"command"`` or ``"reference"``: the signal that the table is added to.
    """

    def __init__(self, loop: CoupledLoop, tangents: ArrayLike, target: str = "command") -> None:
        t = np.asarray(tangents, dtype=float)
        if t.ndim != 2 or t.shape[1] != len(loop.axes) or not len(t) or not np.allclose(np.linalg.norm(t, axis=1), 1.0, atol=1e-9):
            raise ParameterError("tangents", f"of shape {t.shape}", f"unit vectors, (n_sample, {len(loop.axes)})")
        self.loop, self.target, self.n_sample, self.n_axis = loop, target, len(t), t.shape[1]
        frames = normal_frames(t)
        self._made = loop.matrices(frames.shape[2])
        self.length = max(16, math.isqrt(self.n_sample) // 2)
        self._turned = frames[0].T @ frames[-1]
        spare = -self.n_sample % self.length
        self._frames = self._cut(np.concatenate([frames, np.repeat(frames[-1:], spare, axis=0)]))
        self._along = self._cut(np.concatenate([t, np.repeat(t[-1:], spare, axis=0)]))

    def forward(self, u: Array) -> tuple[Array, Array]:
        """Return the effect of a table (n_sample, n_axis) on tracking error and feedback command, each (n_sample, n_axis)."""
        given = self._padded(u)
        shape = given.shape
        rest = np.zeros((shape[1], len(self._made.a)))
        end = self._run(rest, given)
        start = rest.copy()
        for b in range(1, shape[1]):
            start[b] = self._passages[b - 1] @ start[b - 1] + end[b - 1]
        position, command = (np.empty(shape), np.empty(shape))
        self._run(start, given, (position, command))
        fed = command - given if self.target == "command" else command
        return -self._joined(position), self._joined(fed)

    def transposed(self, of_error: Array, of_feedback: Array) -> Array:
        """Return the transpose of `forward`: from weights on both results to one table."""
        position, command = -self._padded(of_error), self._padded(of_feedback)
        count = position.shape[1]
        rest = np.zeros((count, len(self._made.a)))
        begin = self._run_back(rest, position, command)
        last = rest.copy()
        for b in range(count - 2, -1, -1):
            last[b] = self._passages[b + 1].T @ last[b + 1] + begin[b + 1]
        table = np.empty(position.shape)
        self._run_back(last, position, command, table)
        return self._joined(table - command) if self.target == "command" else self._joined(table)

    def monodromy(self) -> Array:
        """Return the transition matrix of the whole trial, in the frame of its start."""
        n = len(self._made.a)
        total = np.eye(n)
        full = self.n_sample // self.length
        for b in range(full):
            total = self._passages[b] @ total
        for k in range(self.n_sample - full * self.length):
            total = self._tick(total.T, np.zeros((n, self.n_axis)), self._frames[k, full][None], self._along[k, full][None])[0].T
        first = n - self._made.coupling_in.shape[1] * len(self.loop.coupling.f)
        total[first:] = np.kron(np.eye(len(self.loop.coupling.f)), self._turned) @ total[first:]
        return total

    @cached_property
    def _passages(self) -> Array:
        """Transition matrices of the segments: (n_segment, n, n)."""
        n, count = len(self._made.a), self._frames.shape[1]
        state = np.tile(np.eye(n), (count, 1))
        none = np.zeros((count * n, self.n_axis))
        for k in range(self.length):
            state = self._tick(state, none, np.repeat(self._frames[k], n, axis=0), np.repeat(self._along[k], n, axis=0))[0]
        return np.ascontiguousarray(state.reshape(count, n, n).transpose(0, 2, 1))

    def _tick(self, s: Array, u: Array, frame: Array, along: Array) -> tuple[Array, Array, Array]:
        """Return the next states (m, n), positions and commands (m, n_axis)."""
        made, coupling = self._made, self.loop.coupling
        position = s @ made.position.T
        error = -(frame * position[:, :, None]).sum(axis=1)
        added = (frame * (s @ made.coupling_out.T + coupling.d * error)[:, None, :]).sum(axis=2)
        shift = coupling.weight * along * (along * position).sum(axis=1, keepdims=True)
        added, shift = (added + u, shift) if self.target == "command" else (added, shift + u)
        command = s @ made.command.T + added * made.command_pushed + shift * made.command_referred
        return s @ made.a.T + added @ made.pushed.T + shift @ made.referred.T + error @ made.coupling_in.T, position, command

    def _tick_back(self, z: Array, w: tuple[Array, Array], frame: Array, along: Array) -> tuple[Array, Array]:
        """Return the transpose of `_tick`, on the states (m, n) and on the table (m, n_axis)."""
        made, coupling = self._made, self.loop.coupling
        added = z @ made.pushed + w[1] * made.command_pushed
        shift = z @ made.referred + w[1] * made.command_referred
        across = (frame * added[:, :, None]).sum(axis=1)
        error = z @ made.coupling_in + coupling.d * across
        position = w[0] - (frame * error[:, None, :]).sum(axis=2)
        position = position + coupling.weight * along * (along * shift).sum(axis=1, keepdims=True)
        before = z @ made.a + w[1] @ made.command + position @ made.position + across @ made.coupling_out
        return before, added if self.target == "command" else shift

    def _run(self, state: Array, given: Array, out: tuple[Array, Array] | None = None) -> Array:
        for k in range(self.length):
            state, position, command = self._tick(state, given[k], self._frames[k], self._along[k])
            if out is not None:
                out[0][k], out[1][k] = position, command
        return state

    def _run_back(self, state: Array, position: Array, command: Array, out: Array | None = None) -> Array:
        for k in range(self.length - 1, -1, -1):
            state, fallen = self._tick_back(state, (position[k], command[k]), self._frames[k], self._along[k])
            if out is not None:
                out[k] = fallen
        return state

    def _padded(self, values: Array) -> Array:
        whole = np.zeros((-(-self.n_sample // self.length) * self.length, self.n_axis))
        whole[: self.n_sample] = values
        return self._cut(whole)

    def _cut(self, values: Array) -> Array:
        """Return values as (sample of a segment, segment, ...)."""
        return np.ascontiguousarray(values.reshape(-1, self.length, *values.shape[1:]).swapaxes(0, 1))

    def _joined(self, values: Array) -> Array:
        return values.swapaxes(0, 1).reshape(-1, self.n_axis)[: self.n_sample]
