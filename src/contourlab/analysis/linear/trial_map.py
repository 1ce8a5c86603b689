"""A whole trial as a linear map, with the turning normal: forwards, transposed, and its monodromy matrix.

The samples are cut into segments that run in parallel, first from rest, then from their true start. The transition matrix of each segment
is computed once. A trial of 30 000 samples costs a few hundred small matrix products.
"""

from __future__ import annotations

import math
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.linear.coupled_loop import CoupledLoop, normal_basis
from contourlab.arrays import Array
from contourlab.errors import ParameterError


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
        after = s @ made.a.T + added @ made.pushed.T + shift @ made.referred.T + error @ made.coupling_in.T
        return after, position, command

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
