"""From axis positions to the tool: lead error, repeatability and squareness, which no encoder sees."""

from __future__ import annotations

import hashlib

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ParameterError
from contourlab.loop.machine import Machine
from contourlab.primitives import normal


def check_seed(seed: object, name: str = "seed") -> None:
    """Raise ParameterError unless a seed, or the number of a trial, is a whole number >= 0."""
    if not isinstance(seed, int | np.integer) or seed < 0:
        raise ParameterError(name, repr(seed), "a whole number >= 0")


def stream_of(seed: int, *words: object) -> float:
    """Return the number of a noise stream, below 2**48, from a seed and its use (variant, trial, axis, signal)."""
    return float(int.from_bytes(hashlib.sha256("/".join(map(str, (seed, *words))).encode()).digest()[:6], "big"))


class ToolPosition:
    """Convert blocks of true axis positions, in order, to tool positions; the direction of motion is kept between blocks."""

    def __init__(self, machine: Machine, seed: int, trial: int = 0) -> None:
        check_seed(trial, "trial")
        self.machine = machine
        self._streams = [stream_of(seed, axis.name, "repeatability", *((trial,) if trial else ())) for axis in machine.axes]
        self._direction = np.zeros(len(machine.axes))
        self._reversals = np.zeros(len(machine.axes), dtype=int)
        names = machine.axis_names
        self._shear = [(names.index(a), names.index(b), angle) for (a, b), angle in machine.squareness.items() if angle]

    @property
    def exact(self) -> bool:
        """Whether the tool position equals the axis positions."""
        return not self._shear and not any(axis.error.position.size or axis.error.repeatability for axis in self.machine.axes)

    def of(self, position: Array, velocity: Array) -> Array:
        """Return tool positions (n_sample, n_axis) [m] from axis positions and velocities."""
        if self.exact:
            return position
        tool = position.copy()
        for j, axis in enumerate(self.machine.axes):
            if axis.error.position.size:
                tool[:, j] += np.interp(position[:, j], axis.error.position, axis.error.lead_error)
            if axis.error.repeatability:
                tool[:, j] += self._approach_offset(j, velocity[:, j], axis.error.repeatability / 4.0)
        for j, i, angle in self._shear:
            tool[:, j] += angle * position[:, i]
        return tool

    def _approach_offset(self, j: int, velocity: Array, deviation: float) -> Array:
        direction = np.sign(velocity)
        # At rest the last direction of motion holds.
        last = np.maximum.accumulate(np.where(direction != 0.0, np.arange(1, len(direction) + 1), 0))
        direction = np.where(last > 0, direction[np.maximum(last - 1, 0)], self._direction[j])
        before = np.concatenate([[self._direction[j]], direction[:-1]])
        count = self._reversals[j] + np.cumsum((direction != before) & (before != 0.0))
        self._direction[j], self._reversals[j] = direction[-1], count[-1]
        numbers, index = np.unique(count, return_inverse=True)
        drawn = np.array([normal(self._streams[j], float(n)) for n in numbers])
        return np.asarray(deviation * drawn[index])
