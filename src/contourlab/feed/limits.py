"""Velocity, acceleration and jerk limits of the axes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Flags
from contourlab.errors import FeedError, ParameterError

RANGES = {"velocity": (1e-6, 1e6), "acceleration": (1e-6, 1e9), "jerk": (1e-6, 1e12)}
"""Smallest and largest limit [m/s, m/s^2, m/s^3]: machines are far inside, and beyond it planning overflows or never ends."""


def _checked(name: str, value: ArrayLike, unit: str, *, finite: bool) -> Array:
    """Return `value` as a read-only vector of valid limits."""
    array = np.array(value, dtype=np.float64, ndmin=1)
    if array.ndim != 1:
        raise ParameterError(name, array.tolist(), "one number per axis", unit)
    low, high = RANGES[name]
    if not bool(np.all((array >= low) & (array <= high) | (np.isposinf(array) & (not finite)))):
        raise ParameterError(name, array.tolist(), f"{low:g} to {high:g}" + ("" if finite else ", or inf for no limit"), unit)
    array.flags.writeable = False
    return array


@dataclass(frozen=True, eq=False)
class AxisLimits:
    """Limits of each axis; a single number applies to all axes.

    Parameters
    ----------
    velocity : array_like (n_axis,) [m/s], 1e-6 to 1e6
        Also the rate of rapid moves.
    acceleration : array_like (n_axis,) [m/s^2], 1e-6 to 1e9, inf for no limit
    jerk : array_like (n_axis,) [m/s^3], 1e-6 to 1e12, inf for no limit

    Raises
    ------
    ParameterError
        If a limit is out of its range or not a number, or if the lengths differ.

    >>> AxisLimits([0.5, 0.5], 2.0, 40.0).jerk
    array([40., 40.])
    """

    velocity: Array
    acceleration: Array
    jerk: Array

    def __init__(self, velocity: ArrayLike, acceleration: ArrayLike, jerk: ArrayLike = np.inf) -> None:
        parts = {
            "velocity": _checked("velocity", velocity, "m/s", finite=True),
            "acceleration": _checked("acceleration", acceleration, "m/s^2", finite=False),
            "jerk": _checked("jerk", jerk, "m/s^3", finite=False),
        }
        size = max(part.size for part in parts.values())
        for name, part in parts.items():
            if part.size not in (1, size):
                raise ParameterError(name, part.tolist(), f"of length 1 or {size}, like the other limits")
            object.__setattr__(self, name, np.broadcast_to(part, (size,)))

    @property
    def n_axis(self) -> int:
        """Number of axes."""
        return int(self.velocity.size)

    @property
    def unbounded(self) -> Flags:
        """Which axes have neither an acceleration nor a jerk limit (n_axis,)."""
        return np.isinf(self.acceleration) & np.isinf(self.jerk)

    def for_axes(self, n_axis: int) -> AxisLimits:
        """Return the limits for `n_axis` axes; limits of a single axis apply to all.

        Raises
        ------
        FeedError
            If the limits have a different number of axes.
        """
        if self.n_axis == n_axis:
            return self
        if self.n_axis != 1:
            raise FeedError(f"limits for {self.n_axis} axes, the path has {n_axis}: give one limit per axis")
        return AxisLimits(*(np.repeat(part, n_axis) for part in (self.velocity, self.acceleration, self.jerk)))
