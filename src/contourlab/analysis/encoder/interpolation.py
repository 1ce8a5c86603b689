"""Interpolation of corrected quadrature signals to counts finer than a period: zero crossings of sinusoids of higher order.

References
----------
E. Ulu, N. Gecer Ulu, M. Cakmakci, "Development and validation of an adaptive method to generate high-resolution quadrature encoder
signals", Journal of Dynamic Systems, Measurement, and Control 136 (2014).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Flags, Index
from contourlab.errors import ParameterError

ENTRIES = 64
"""Table entries per order: the interpolated sinusoids have an error of 1/(8 ENTRIES^2) = 3e-5."""
HIGHEST = 100_000


def interpolation_order(pitch: float, resolution: float) -> int:
    """Return the order n of the sinusoids whose zero crossings are a resolution apart: pitch = 4 n resolution.

    Parameters
    ----------
    pitch : float [m], > 0
        Travel of one period of the signals: 4 um for a scale with a resolution of 1 um after the usual fourfold count.
    resolution : float [m], > 0

    Raises
    ------
    ParameterError
        If the pitch is not four times a whole number of resolutions; the message names the nearest valid resolutions.

    >>> interpolation_order(4e-6, 25e-9), interpolation_order(4e-6, 10e-9)
    (40, 100)
    """
    for name, value in (("pitch", pitch), ("resolution", resolution)):
        if not 0.0 < value < float("inf"):
            raise ParameterError(name, f"{value:g}", "> 0 and finite", "m")
    exact = pitch / (4.0 * resolution)
    order = round(exact) if exact < 2.0 * HIGHEST else 0
    if not 1 <= order <= HIGHEST or abs(exact - order) > 1e-6 * order:
        near = sorted({pitch / (4.0 * n) for n in (np.floor(exact), np.ceil(exact)) if 1 <= n <= HIGHEST})
        nearest = " or ".join(f"{value:.9g}" for value in near) or f"from {pitch / (4.0 * HIGHEST):.6g} to {0.25 * pitch:.6g}"
        raise ParameterError(
            "resolution", f"{resolution:g} m", f"a pitch of {pitch:g} m over four times a whole number, such as {nearest}", "m"
        )
    return order


@dataclass(frozen=True, eq=False)
class Counts:
    """A position in counts.

    Parameters
    ----------
    counts : ndarray of int (n,)
        The first lies within half a pitch of zero.
    missed : ndarray of bool (n,)
        Samples at which whole pitches may be lost.
    """

    counts: Index
    missed: Flags


class SinusoidTable:
    """Sinusoids of a higher order from two signals, by quadrant and ratio: no arctangent, no sine.

    The smaller magnitude of the two signals over the larger is the tangent of an angle between 0 and 45 degrees. A table over this ratio
    holds cos(n phi) and sin(n phi) of that octant, and the number of preceding zero crossings. The octant follows from the signs of the
    signals and from which one is larger. The amplitude cancels in the ratio.

    Parameters
    ----------
    order : int, 1 to 100 000
        n. A pitch has 4 n counts.
    entries : int, optional
        Intervals of the table; 64 n by default.

    Notes
    -----
    sin(n phi) = sin(phi) U_{n-1}(cos phi) with the Chebyshev polynomials of the second kind: the signal of higher order depends only on
    the two measured signals, so a table can hold it.
    """

    def __init__(self, order: int, entries: int | None = None) -> None:
        if not 1 <= order <= HIGHEST:
            raise ParameterError("order", order, f"1 to {HIGHEST}")
        self.order = int(order)
        self.entries = max(ENTRIES * self.order, 1024) if entries is None else int(entries)
        if self.entries < 4 * self.order:
            raise ParameterError("entries", self.entries, f"at least four for each order, {4 * self.order}")
        angle = np.arctan(np.arange(self.entries + 2) / self.entries)
        self._cosine, self._sine = np.cos(self.order * angle), np.sin(self.order * angle)
        self._turns = angle / (2.0 * np.pi)
        self._crossings = np.rint(self.order * angle * (2.0 / np.pi)).astype(np.int64)

    def sinusoids(self, u1: ArrayLike, u2: ArrayLike) -> tuple[Array, Array]:
        """Return cos(n phi) and sin(n phi) (n,) of corrected signals (n,) with phi = arctan(u2/u1)."""
        first, second = (np.asarray(u, dtype=np.float64) for u in (u1, u2))
        i, part, beyond = self._place(first, second)
        cosine, sine = ((1.0 - part) * t[i] + part * t[i + 1] for t in (self._cosine, self._sine))
        # Beyond 45 degrees, phi = 90 degrees - angle; for u1 < 0, 180 degrees - phi; for u2 < 0, -phi.
        turned_cosine, turned_sine = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[self.order % 4]
        c = np.where(beyond, turned_cosine * cosine + turned_sine * sine, cosine)
        s = np.where(beyond, turned_sine * cosine - turned_cosine * sine, sine)
        half = -1.0 if self.order % 2 else 1.0
        behind = first < 0.0
        c, s = np.where(behind, half * c, c), np.where(behind, -half * s, s)
        return c, np.where(second < 0.0, -s, s)

    def in_period(self, u1: ArrayLike, u2: ArrayLike) -> Index:
        """Return the count (n,) within the period, -2 n to 2 n: round(4 n phi/(2 pi)) for phi from -pi to pi.

        The table gives the count to within one. The sum and difference of the sinusoids of higher order cross zero half-way between two
        counts; their signs select the count.
        """
        first, second = (np.asarray(u, dtype=np.float64) for u in (u1, u2))
        i, _, beyond = self._place(first, second)
        coarse = self._crossings[i]
        coarse = np.where(beyond, self.order - coarse, coarse)
        coarse = np.where(first < 0.0, 2 * self.order - coarse, coarse)
        coarse = np.where(second < 0.0, -coarse, coarse)
        fine = quadrant(*self.sinusoids(first, second))
        return np.asarray(coarse + (fine - coarse + 1) % 4 - 1, dtype=np.int64)

    def turns(self, u1: ArrayLike, u2: ArrayLike) -> Array:
        """Return the angle (n,) in turns, -1/2 to 1/2, to 1e-5 of a count."""
        first, second = (np.asarray(u, dtype=np.float64) for u in (u1, u2))
        i, part, beyond = self._place(first, second)
        angle = (1.0 - part) * self._turns[i] + part * self._turns[i + 1]
        angle = np.where(beyond, 0.25 - angle, angle)
        angle = np.where(first < 0.0, 0.5 - angle, angle)
        return np.where(second < 0.0, -angle, angle)

    def count(self, u1: ArrayLike, u2: ArrayLike) -> Counts:
        """Count corrected signals (n,): within the period by the table, across periods by the shorter way round."""
        periods, missed = period_count(self.turns(u1, u2))
        return Counts(self.in_period(u1, u2) + 4 * self.order * periods, missed)

    def _place(self, first: Array, second: Array) -> tuple[Index, Array, Flags]:
        along, across = np.abs(first), np.abs(second)
        ratio = self.entries * np.minimum(along, across) / np.maximum(np.maximum(along, across), np.finfo(float).tiny)
        i = ratio.astype(np.int64)
        return i, ratio - i, across > along


def quadrant(cosine: Array, sine: Array) -> Index:
    """Return the quadrant of the sinusoids, 0 to 3, each centred on an axis."""
    up, right = sine + cosine > 0.0, cosine - sine > 0.0
    return np.where(up, np.where(right, 0, 1), np.where(right, 3, 2)).astype(np.int64)


def period_count(turns: ArrayLike) -> tuple[Index, Flags]:
    """Count whole periods, taking the shorter way round from one sample to the next.

    Parameters
    ----------
    turns : array_like (n,)
        Angle of the signals, -1/2 to 1/2.

    Returns
    -------
    periods : ndarray of int (n,)
        From 0 at the first sample.
    missed : ndarray of bool (n,)
        Samples at which whole periods may have been lost.

    Notes
    -----
    Correct while the axis moves less than half a pitch per sample. A faster axis seems to move the other way. Only the sample at which it
    becomes too fast is detected, by a jump of the apparent speed by more than half a pitch per sample. An axis that is too fast from the
    start is not detected.
    """
    angle = np.asarray(turns, dtype=np.float64)
    step = np.diff(angle, prepend=angle[:1])
    back = np.rint(step)
    return np.cumsum(-back).astype(np.int64), np.abs(np.diff(step - back, prepend=0.0)) > 0.5
