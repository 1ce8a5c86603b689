"""Fit splines through points, or smoothing splines within a tolerance, with or without given end tangents."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from contourlab.arrays import Array, Flags
from contourlab.geometry import BSpline, Curve, Line

Ends = tuple[Array | None, Array | None]
DEGREE = 5
ALONG = 2e-7
"""Largest angle [rad] between a chord and a tangent that permits a line."""
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)
BLOCK = 4096
"""Chords per pass, which limits the memory."""
_INSIDE = np.linspace(0.0, 1.0, 9)[1:-1]


@dataclass(frozen=True, eq=False)
class FittedSpline:
    """A spline along points, or a line between two.

    Attributes
    ----------
    points, knots : ndarray
        Control points and knots; for a line its ends, and no knots.
    at : ndarray (n,)
        Parameter of each point.
    deviation : float [m]
        Largest distance of a point from the curve at that parameter.
    """

    degree: int
    points: Array
    knots: Array
    at: Array
    deviation: float

    @cached_property
    def curve(self) -> Curve:
        """The curve by arc length; raises a GeometryError for a cusp."""
        if not self.knots.size:
            return Line(self.points[0], self.points[1])
        return BSpline(self.degree, self.points, self.knots)

    def values(self, chords: slice, parts: Array, order: int = 0) -> Array:
        """Return positions, or derivatives by the parameter, at fractions of the chords' intervals (n_chord, n_part, n_axis)."""
        from scipy.interpolate import BSpline as ScipySpline

        at = self.at[chords.start : chords.stop + 1]
        u = np.clip(at[:-1, None] + parts * np.diff(at)[:, None], self.at[0], self.at[-1])
        spline = ScipySpline.construct_fast(self.knots, self.points, self.degree)
        return np.asarray(spline(u, nu=order))

    def strays(self, points: Array) -> tuple[Array, Flags]:
        """Return the largest distance of the curve from each chord (n - 1,) [m], and whether it runs against the chord anywhere."""
        n = len(points) - 1
        away, against = np.zeros(n), np.zeros(n, dtype=bool)
        if not self.knots.size:
            return away, against
        for first in range(0, n, BLOCK):
            part = slice(first, min(first + BLOCK, n))
            ends = points[first : first + BLOCK + 1, None]
            chords = np.diff(ends, axis=0)
            inside = self.values(part, _INSIDE) - ends[:-1]
            along = np.clip((inside * chords).sum(axis=2) / (chords * chords).sum(axis=2), 0.0, 1.0)
            away[part] = np.linalg.norm(inside - along[:, :, None] * chords, axis=2).max(axis=1)
            against[part] = ((self.values(part, _INSIDE, 1) * chords).sum(axis=2) <= 0.0).any(axis=1)
        return away, against


def interpolated(points: Array, ends: Ends, periodic: bool = False) -> FittedSpline:
    """Fit a spline through points.

    Parameters
    ----------
    points : ndarray (n, n_axis) [m]
    ends : pair of ndarray (n_axis,) or None
        Unit tangents at the first and last point; None for a free end.
    periodic : bool
        Whether the curve closes smoothly; the last point is the first.

    Notes
    -----
    Chord length as parameter limits a quintic to fourth order; the arc lengths of a preliminary cubic spline give sixth order.

    References
    ----------
    M. S. Floater and T. Surazhsky, "Parameterization for curve interpolation", Studies in Computational Mathematics 12, 2006.
    """
    if len(points) == 2:
        chord = points[1] - points[0]
        chord = chord / np.linalg.norm(chord)
        if all(end is None or np.linalg.norm(end - chord) < ALONG for end in ends):
            return FittedSpline(1, points, np.empty(0), np.array([0.0, 1.0]), 0.0)
    at = _arc_lengths(points, ends, periodic)
    return _measured(*_spline(points, at, ends, periodic), points, at)


def disagreement(points: Array, periodic: bool) -> Array:
    """Return the difference of a quintic and a cubic spline through the points at each chord (n - 1,), relative to their bulge.

    Both agree if the points are dense enough for their curve; otherwise they oscillate differently.
    """
    from scipy.interpolate import CubicSpline

    free = (None, None)
    quintic = interpolated(points, free, periodic)
    if not quintic.knots.size:
        return np.zeros(1)
    by_chord = _chords(points)
    cubic = CubicSpline(by_chord, points, bc_type="periodic" if periodic else "not-a-knot")
    direction = np.diff(points, axis=0) / np.diff(by_chord)[:, None]
    gap, bulge = np.zeros(len(direction)), np.zeros(len(direction))
    for part in (0.25, 0.5, 0.75):
        sharp = quintic.values(slice(0, len(direction)), np.array([part]))[:, 0]
        soft = cubic(by_chord[:-1] + part * np.diff(by_chord))
        a, b = (_across(spline - points[:-1], direction) for spline in (sharp, soft))
        gap = np.maximum(gap, np.linalg.norm(a - b, axis=1))
        bulge = np.maximum(bulge, np.linalg.norm(a, axis=1))
    return np.divide(gap, bulge, out=np.ones_like(gap), where=bulge > 0.0)


def _across(vectors: Array, direction: Array) -> Array:
    return np.asarray(vectors - np.einsum("ij,ij->i", vectors, direction)[:, None] * direction)


def _measured(degree: int, coefficients: Array, knots: Array, points: Array, at: Array) -> FittedSpline:
    from scipy.interpolate import BSpline as ScipySpline

    away = np.linalg.norm(ScipySpline.construct_fast(knots, coefficients, degree)(at) - points, axis=1)
    return FittedSpline(degree, coefficients, knots, at, float(away.max()))


def _chords(points: Array) -> Array:
    return np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])


def _spline(points: Array, at: Array, ends: Ends, periodic: bool) -> tuple[int, Array, Array]:
    from scipy.interpolate import make_interp_spline

    if periodic:
        degree = DEGREE if len(points) > DEGREE + 1 else 3
        spline = make_interp_spline(at, points, k=degree, bc_type="periodic")
        return degree, spline.c, spline.t
    low, high = (() if end is None else [(1, end)] for end in ends)
    degree = min(DEGREE, len(points) + len(low) + len(high) - 1)
    knots = _knots(at, degree, len(low), len(high))
    conditions: Any = (low or None, high or None)
    spline = make_interp_spline(at, points, k=degree, t=knots, bc_type=conditions)
    # Remove rounding at the ends, which other curves join.
    coefficients = np.concatenate([points[:1], spline.c[1:-1], points[-1:]])
    return degree, _pinned(coefficients, ends), knots


def _knots(at: Array, degree: int, low: int, high: int) -> Array:
    """Return knots at the points, except next to the ends ("not a knot"), in the number that the end conditions require."""
    edge = [np.full(degree + 1, at[0]), np.full(degree + 1, at[-1])]
    inner = len(at) + low + high - degree - 1
    first = (degree + 1) // 2 - low
    return np.concatenate([edge[0], at[first : first + inner] if inner > 0 else at[:0], edge[1]])


def _pinned(coefficients: Array, ends: Ends) -> Array:
    """Align the first and last leg of the control polygon with the end tangents."""
    for end, root, leg in ((ends[0], 0, 1), (ends[1], -1, -2)):
        if end is not None and len(coefficients) > 3:
            size = np.dot(coefficients[leg] - coefficients[root], end)
            coefficients[leg] = coefficients[root] + size * end
    return coefficients


def _arc_lengths(points: Array, ends: Ends, periodic: bool) -> Array:
    """Return the arc lengths of the points along a cubic spline through them."""
    from scipy.interpolate import CubicSpline

    chords = _chords(points)
    conditions: Any = "periodic" if periodic else tuple("not-a-knot" if end is None else (1, end) for end in ends)
    cubic = CubicSpline(chords, points, bc_type=conditions)
    half = 0.5 * np.diff(chords)
    speed = np.zeros(len(half))
    for node, weight in zip(_NODES, _WEIGHTS, strict=True):
        speed += weight * np.linalg.norm(cubic(chords[:-1] + half + half * node, nu=1), axis=1)
    return np.concatenate([[0.0], np.cumsum(half * speed)])


def smoothed(points: Array, tolerance: float, ends: Ends, periodic: bool) -> FittedSpline | None:
    """Return the smoothest spline within the tolerance [m] of the points among several trials; None if there is none."""
    from scipy.interpolate import splprep  # its successor make_splprep supports closed curves only in the newest versions

    if len(points) <= DEGREE + 1:
        return None
    at = _chords(points)
    weights = np.ones(len(points))
    if not periodic:
        weights[[0, -1]] = 100.0  # the ends are corrected below
    budget = len(points) * tolerance**2
    for halving in range(24):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # the distance is checked below
            (knots, rows, _), _ = splprep(list(points.T), w=weights, u=at, k=DEGREE, s=budget * 0.5**halving, per=periodic)
        coefficients, knots = np.array(rows).T, np.asarray(knots)
        if not periodic:
            coefficients[[0, -1]] = points[[0, -1]]
            coefficients = _pinned(coefficients, ends)
        spline = _measured(DEGREE, coefficients, knots, points, at)
        if spline.deviation <= tolerance:
            return spline
    return None
