"""Fit curves through or near points: splines, straight lines, and corners where the points turn sharply.

The polygon of the points shows corners, straight stretches, tangents and the largest bulge of a curve. Splines pass through the points, or
are smooth within a tolerance, with or without given end tangents.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from itertools import chain, pairwise
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from contourlab.arrays import Array, Flags, Index
from contourlab.errors import GeometryError, refuse
from contourlab.geometry import BSpline, Curve, Line, Path
from contourlab.geometry.curve import angle_between
from contourlab.geometry.nurbs import split_at

Kind = TypeVar("Kind", np.float64, np.bool_)
LONG = 4.0
"""Least ratio of a long chord to its neighbour."""
LONGER = 2.0
"""Least ratio of a chord that may be straight because the bend beside it clearly ends there."""
INLINE = 1e-3
"""Largest turn [rad] within a straight stretch of several chords."""
NOISE = 50.0
"""Least length of a straight stretch, in tolerances; shorter chords may be noise."""
TINY = 1e-300
NEIGHBOURS = 4
"""Points on the finer side whose turns give the bend there."""
MARGIN = 1.5
"""Largest bulge of a curve, relative to the arc with the same turns at its ends."""
STEEP = math.radians(45.0)
"""Where the polygon turns by less, the curve must not run against its chord."""


class Polygon:
    """Points and the chords between them.

    Parameters
    ----------
    points : ndarray (n, n_axis) [m]
        Neighbours differ; in a closed polygon the last is the first.
    corner_angle : float [rad]
        Larger turns are corners, whose two sides are independent.
    tolerance : float [m]
        Error of the points.

    Attributes
    ----------
    length, direction : ndarray (n - 1,), (n - 1, n_axis)
        Length and direction of the chords; chord i runs from point i to i + 1.
    turn : ndarray (n,) [rad]
        Turn of the polygon at each point; 0 at the ends of an open one and at corners.
    corners : list of int
        In a closed polygon 0 is its first and last point.
    """

    def __init__(self, points: Array, closed: bool, corner_angle: float, tolerance: float) -> None:
        self.points, self.closed, self.tolerance = points, closed, tolerance
        chords = np.diff(points, axis=0)
        self.length = np.linalg.norm(chords, axis=1)
        self.direction = chords / self.length[:, None]
        before, after = self._sides(self.direction)
        self.turn = angle_between(before, after)
        if not closed:
            self.turn[[0, -1]] = 0.0
        sharp = self.turn > corner_angle
        self.corners = [int(i) for i in np.flatnonzero(sharp[:-1])]
        self.turn[sharp] = 0.0
        self._shut = sharp
        if not closed:
            self._shut[[0, -1]] = True
        self._look()

    def _sides(self, of_chords: Array) -> tuple[Array, Array]:
        """Return values of the chords before and after each point; at the ends of an open polygon, that of the other end."""
        return np.concatenate([of_chords[-1:], of_chords]), np.concatenate([of_chords, of_chords[:1]])

    def _shifted(self, of_points: NDArray[Kind], by: int) -> NDArray[Kind]:
        """Return the values of the points `by` places on, around a closed polygon; 0 or False past the ends of an open one."""
        if self.closed:
            rolled = np.roll(of_points[:-1], -by, axis=0)
            return np.asarray(np.concatenate([rolled, rolled[:1]]))
        n, shifted = len(of_points), np.zeros_like(of_points)
        shifted[max(-by, 0) : max(n - by, 0)] = of_points[max(by, 0) : max(n + by, 0)]
        return shifted

    def _look(self) -> None:
        """Set the tangents at each point from the three points before it, and after it, and the bends of both sides."""
        before, after = self._sides(self.direction)
        h_before, h_after = self._sides(self.length)
        n, least = len(self.points), np.minimum(h_before, h_after)
        self._tangents: list[Array] = []
        self._bends: list[Array] = []
        for by, near, h in ((-1, before, h_before), (1, after, h_after)):
            far, h_far = self._shifted(near, by), self._shifted(h, by)
            angle = self._shifted(self.turn, by)
            known = ~self._shifted(self._shut, by) & (h_far > 0.0)
            share = np.divide(h, h + h_far, out=np.zeros(n), where=known)
            self._tangents.append(_turned_on(far, near, np.where(known, angle, 0.0), share))
            bend, open_ = np.where(known, 0.0, self.turn), np.ones(n, dtype=bool)
            for k in range(1, NEIGHBOURS + 1):
                open_ &= ~self._shifted(self._shut, k * by)
                turn = self._shifted(self.turn, k * by) * np.minimum(1.0, h / np.maximum(self._shifted(least, k * by), TINY))
                bend = np.where(open_, np.maximum(bend, turn), bend)
            self._bends.append(bend)
        # Angles between a chord and the tangents of the finer side at its start and end.
        self._off_start = angle_between(self._tangents[0][:-1], self.direction)
        self._off_end = angle_between(self._tangents[1][1:], self.direction)

    def _finer(self) -> tuple[Array, Array]:
        """Return the ratios of each chord to the ones before and after it; 0 across corners and ends."""
        before, after = self._sides(self.length)
        low = np.where(self._shut[:-1], 0.0, self.length / before[:-1])
        return low, np.where(self._shut[1:], 0.0, self.length / after[1:])

    def straights(self) -> list[tuple[int, int]]:
        """Return the straight stretches as pairs of chords (first, last); across the start of a closed polygon last < first.

        A stretch is one long chord, or several in line, beside much shorter chords whose bend ends where it starts: their tangent there is
        that of the stretch, within the uncertainty of the bend. If their arc continued along the long chord, the tangent would differ by
        half the ratio of lengths times the turn between their points.
        """
        low, high = self._finer()
        start = (low >= LONGER) & (self._off_start <= _leeway(low) * self._bends[0][:-1] + 1e-6)
        end = (high >= LONGER) & (self._off_end <= _leeway(high) * self._bends[1][1:] + 1e-6)
        long = self.length >= NOISE * self.tolerance
        noisy = self.tolerance / np.minimum(*self._sides(self.length))
        inline = (self.turn <= INLINE + 4.0 * noisy) & (noisy * NOISE <= 1.0) & ~self._shut
        n = len(self.length)
        inline[1:] &= ~end
        # A stretch runs from its start over points in line to the first that is not, or where it ends.
        halts = np.flatnonzero(~inline)
        stretches: list[tuple[int, int]] = []
        reached = 0
        for i in np.flatnonzero((start | self._shut[:-1]) & long).tolist():
            k = int(np.searchsorted(halts, i + 1))
            if i < reached or not halts.size:
                continue
            last = int(halts[k]) if k < halts.size else int(halts[0]) + n
            chord = (last - 1) % n
            if (end[chord] or self._shut[chord + 1]) and (start[i] or end[chord]) and long[chord] and last - i <= n:
                stretches.append((i, chord))
                reached = last
        return stretches

    def jumps(self) -> list[tuple[int, int]]:
        """Return where a chord is much longer than its neighbour, as pairs (point, number of the long chord)."""
        low, high = self._finer()
        before, after = self._sides(self.length)
        sure = NOISE * self.tolerance
        starts = [(int(i), int(i)) for i in np.flatnonzero((low >= LONG) & (before[:-1] >= sure))]
        return starts + [(int(i) + 1, int(i)) for i in np.flatnonzero((high >= LONG) & (after[1:] >= sure))]

    def span(self, first: int, last: int) -> Array:
        """Return the points from `first` to `last`; past the start of a closed polygon the numbers continue."""
        points, n = self.points, len(self.length)
        return points[first : last + 1] if last <= n else np.concatenate([points[first:-1], points[: last - n + 1]])

    def tangent(self, i: int) -> Array:
        """Return the tangent at a point between chords: of a much finer side if there is one, else of an arc through three points."""
        before, after = (i - 1) % len(self.length), i % len(self.length)
        ratio = self.length[after] / self.length[before]
        if ratio >= LONG and self._off_start[after] <= self.turn[i]:
            return np.asarray(self._tangents[0][i])
        if ratio <= 1.0 / LONG and self._off_end[before] <= self.turn[i]:
            return np.asarray(self._tangents[1][i])
        mean = self.length[after] * self.direction[before] + self.length[before] * self.direction[after]
        return np.asarray(mean / np.linalg.norm(mean))

    def bulges(self) -> tuple[Array, Flags]:
        """Return the largest distance [m] of a curve from each chord (n - 1,), and where it must not run against the chord.

        An arc that turns by a over a chord of length c leaves it by c a / 8. Half of a turn at a point belongs to the chord if its
        neighbour is equally long, all of it if the chord is much longer. The weight of turns halves with each point in between.
        """
        low, high = self._finer()
        start = np.where(low >= LONG, np.minimum(self.turn[:-1], self._off_start + 0.25 * self._bends[0][:-1]), self.turn[:-1])
        end = np.where(high >= LONG, np.minimum(self.turn[1:], self._off_end + 0.25 * self._bends[1][1:]), self.turn[1:])
        own = self.length * np.maximum(start, end)
        before, after = self._sides(self.length)
        turn = self._spread(self.turn)
        size = self._spread(self.turn * np.maximum(before, after))
        far = np.minimum(self.length * np.maximum(turn[:-1], turn[1:]), np.maximum(size[:-1], size[1:])) * 0.5
        # For a long chord `own` already holds the turns at its ends.
        far = np.where((low >= LONG) | (high >= LONG), 0.0, far)
        return 0.25 * MARGIN * np.maximum(own, far) + 1e-6 * self.length + 1e-10, np.maximum(turn[:-1], turn[1:]) < STEEP

    def _spread(self, of_points: Array) -> Array:
        """Return the largest value near each point; its weight halves with each point in between."""
        spread = of_points
        for step in (1, 2, 4, 8, 16):
            spread = np.maximum(spread, 0.5**step * np.maximum(self._shifted(spread, step), self._shifted(spread, -step)))
        return spread


def _leeway(ratio: Array) -> Array:
    """Return the permitted angle between a straight stretch and the tangent of the finer side, in turns of that side."""
    return np.where(ratio < LONG, 0.15 * ratio, np.minimum(ratio / 3.0, 3.0))


def _turned_on(a: Array, b: Array, angle: Array, share: Array) -> Array:
    """Return b rotated further from a, in their plane, by a fraction of the angle between them."""
    small = np.sin(angle) < 1e-9
    size = np.where(small, 1.0, np.sin(angle))
    back = np.where(small, 0.0, np.sin(share * angle) / size)
    on = np.where(small, 1.0, np.sin((1.0 + share) * angle) / size)
    return np.asarray(on[:, None] * b - back[:, None] * a)


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
        return BSpline(self.degree, self.points, self.knots) if self.knots.size else Line(*self.points)

    def values(self, chords: slice, parts: Array, order: int = 0) -> Array:
        """Return positions, or derivatives by the parameter, at fractions of the chords' intervals (n_chord, n_part, n_axis)."""
        from scipy.interpolate import BSpline as ScipySpline

        at = self.at[chords.start : chords.stop + 1]
        u = np.clip(at[:-1, None] + parts * np.diff(at)[:, None], self.at[0], self.at[-1])
        return np.asarray(ScipySpline.construct_fast(self.knots, self.points, self.degree)(u, nu=order))

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

    quintic = interpolated(points, (None, None), periodic)
    if not quintic.knots.size:
        return np.zeros(1)
    by_chord = _chords(points)
    cubic = CubicSpline(by_chord, points, bc_type="periodic" if periodic else "not-a-knot")
    direction = np.diff(points, axis=0) / np.diff(by_chord)[:, None]
    gap, bulge = np.zeros(len(direction)), np.zeros(len(direction))
    for part in (0.25, 0.5, 0.75):
        sharp = quintic.values(slice(0, len(direction)), np.array([part]))[:, 0]
        soft = cubic(by_chord[:-1] + part * np.diff(by_chord))
        away = (spline - points[:-1] for spline in (sharp, soft))
        a, b = (vectors - np.einsum("ij,ij->i", vectors, direction)[:, None] * direction for vectors in away)
        gap = np.maximum(gap, np.linalg.norm(a - b, axis=1))
        bulge = np.maximum(bulge, np.linalg.norm(a, axis=1))
    return np.divide(gap, bulge, out=np.ones_like(gap), where=bulge > 0.0)


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
    # Knots at the points, except next to the ends ("not a knot"), in the number that the end conditions require.
    first, inner = (degree + 1) // 2 - len(low), len(at) + len(low) + len(high) - degree - 1
    between = at[first : first + inner] if inner > 0 else at[:0]
    knots = np.concatenate([np.full(degree + 1, at[0]), between, np.full(degree + 1, at[-1])])
    conditions: Any = (low or None, high or None)
    spline = make_interp_spline(at, points, k=degree, t=knots, bc_type=conditions)
    # Remove rounding at the ends, which other curves join.
    return degree, _pinned(np.concatenate([points[:1], spline.c[1:-1], points[-1:]]), ends), knots


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


SAME_PLACE = 1e-9
"""Largest distance [m] between the ends of a closed contour."""
DOUBT = 0.3
"""Least difference of a quintic and a cubic spline, relative to their bulge, that makes both unreliable."""
ROUNDS = 12
"""Divisions of splines that leave their polygon, before they are divided at every point."""


@dataclass(frozen=True, eq=False)
class PointFit:
    """A path along points.

    Attributes
    ----------
    deviation : float [m]
        Largest distance of a point from the curve, at the parameter of the point; rounding only if the curve passes through the points.
    bulge : float [m]
        Largest distance of the curve from the chord between two points.
    n_straight : int
        Straight stretches: chords much longer than their neighbours, kept as lines tangent to the splines beside them.
    n_divided : int
        Points at which a spline was divided, with continuous tangent but not curvature, because it left its polygon too far.
    """

    path: Path
    n_point: int
    n_corner: int
    deviation: float
    smoothed: bool
    bulge: float = 0.0
    n_straight: int = 0
    n_divided: int = 0

    @property
    def note(self) -> str:
        """A summary in one line."""
        how = f"smoothed by up to {1e6 * self.deviation:.3g} um" if self.smoothed else "interpolated"
        parts = [f"{self.n_point} points", how, f"curve within {1e6 * self.bulge:.3g} um of the chords", f"{self.n_corner} corners"]
        if self.n_straight:
            parts.append(f"{self.n_straight} straight segments")
        if self.n_divided:
            parts.append(f"splines divided at {self.n_divided} points to follow the polygon")
        return ", ".join([*parts, "closed" if self.path.closed else "open"])


def fit_points(
    points: Array, tolerance: float | None, corner_angle: float, place: Callable[[int], str] = lambda i: f"point {i + 1}"
) -> PointFit:
    """Fit a path to points: quintic splines, C4 between corners and straight stretches.

    A spline that leaves a chord further than the turns of the polygon explain is divided.

    Parameters
    ----------
    points : ndarray (n, n_axis) [m], n >= 2
        Neighbours differ; closed if the last is the first.
    tolerance : float [m] or None
        Largest distance of a point from a smoothing spline; None to pass through the points.
    corner_angle : float [rad], > 0, < pi
        Larger turns of the polygon are corners, at which splines end.
    place : callable
        Returns the name of a point, by its number from 0, for messages.

    Raises
    ------
    GeometryError
        If tolerance or angle are out of range, the spline has a cusp, or no spline keeps to the polygon.

    Notes
    -----
    `contourlab.contours.fit` defines straight stretches and the largest bulge; `contourlab.contours.fit` fits the splines.
    """
    if tolerance is not None and not (0.0 < tolerance < math.inf):
        raise GeometryError(f"tolerance = {tolerance!r} m: must be > 0 and finite")
    refuse(not 0.0 < corner_angle < math.pi, GeometryError, f"corner_angle = {math.degrees(corner_angle):g} deg: must be > 0 and < 180 deg")
    n = len(points)
    closed = n > 2 and float(np.linalg.norm(points[-1] - points[0])) <= SAME_PLACE
    if closed:
        points = np.concatenate([points[:-1], points[:1]])
    polygon = Polygon(points, closed, corner_angle, tolerance or 0.0)
    marks, n_straight = _marks(polygon)
    known = len(marks)
    fitting = _Fitting(polygon, tolerance, marks, place)
    fitting.run()
    return PointFit(
        path=Path(fitting.curves(), closed),
        n_point=n,
        n_corner=len(polygon.corners),
        deviation=max(spline.deviation for spline in fitting.splines),
        smoothed=tolerance is not None,
        bulge=fitting.bulge,
        n_straight=n_straight,
        n_divided=len(fitting.marks) - known,
    )


def _marks(polygon: Polygon) -> tuple[dict[int, Array | None], int]:
    """Return the points where splines end, with their tangents, and the number of straight stretches."""
    straights, jumps = _breaks(polygon)
    n = len(polygon.length)
    wrap = n if polygon.closed else n + 1
    marks: dict[int, Array | None] = {point % wrap: polygon.tangent(point) for point in jumps}
    for first, last in straights:
        marks[first], marks[(last + 1) % wrap] = polygon.direction[first], polygon.direction[last]
    marks |= dict.fromkeys(polygon.corners)
    if not polygon.closed:
        marks |= {0: None, n: None}
    return marks, len(straights)


def _breaks(polygon: Polygon) -> tuple[list[tuple[int, int]], list[int]]:
    """Return the straight stretches, and the points where the spacing jumps, except where a single spline is reliable.

    A single spline fits points of a smooth curve better, however unevenly they are spaced.
    """
    straights, jumps = polygon.straights(), polygon.jumps()
    n, corners = len(polygon.length), polygon.corners
    doubt = np.full(n, np.inf)
    ends = [*corners, corners[0] + n] if polygon.closed and corners else [0, *corners, n]
    doubtful = np.zeros(n, dtype=bool)
    doubtful[[chord for _, chord in (*straights, *jumps)]] = True
    for first, last in pairwise(ends):
        chords = np.arange(first, last) % n
        if doubtful[chords].any():
            doubt[chords] = disagreement(polygon.span(first, last), polygon.closed and not corners)
    confirmed = [(a, b) for a, b in straights if (doubt[np.arange(a, b + 1 if b >= a else b + 1 + n) % n] > DOUBT).any()]
    return confirmed, [point for point, chord in jumps if doubt[chord] > DOUBT]


class _Fitting:
    """Splines between marks. A mark is a point where splines end, with their tangent there or None.

    Only splines that leave their polygon are divided and fitted again.
    """

    def __init__(self, polygon: Polygon, tolerance: float | None, marks: dict[int, Array | None], place: Callable[[int], str]) -> None:
        self.polygon, self.tolerance, self.marks, self.place = polygon, tolerance, marks, place
        self.bounds, self.forward = polygon.bulges()
        self.n = len(polygon.length)
        self.kept: dict[tuple[int, int], tuple[FittedSpline, float]] = {}
        self.splines: list[FittedSpline] = []
        self.spans: list[tuple[int, int]] = []
        self.bulge = 0.0

    def run(self) -> None:
        """Fit splines and divide them until all keep to the polygon."""
        for turn in range(ROUNDS + 2):
            # First and last point of each spline; past the start of a closed polygon the numbers continue.
            order = sorted(self.marks)
            ends = [*order, order[0] + self.n] if order and self.polygon.closed else order
            self.spans = list(pairwise(ends)) if order else [(0, self.n)]
            self.kept = {span: self.kept[span] for span in self.spans if span in self.kept}
            divided = [self._fit_span(span, everywhere=turn >= ROUNDS) for span in self.spans if span not in self.kept]
            loose = list(chain.from_iterable(divided))
            if not loose:
                break
            for i in loose:
                self.marks.setdefault(i, self.polygon.tangent(i))
        self.splines = [self.kept[span][0] for span in self.spans]
        self.bulge = max(self.kept[span][1] for span in self.spans)

    def _fit_span(self, span: tuple[int, int], everywhere: bool) -> list[int]:
        """Fit the spline of a span and store it if it is good; else return the points at which to divide it."""
        first, last = span
        points = self.polygon.span(first, last)
        periodic = not self.marks
        ends = (None, None) if periodic else (self.marks[first], self.marks[last % self.n if self.polygon.closed else last])
        spline = smoothed(points, self.tolerance, ends, periodic) if self.tolerance is not None and last - first > 1 else None
        if spline is None or self._stray_chords(spline, points, first)[0].size:
            spline = interpolated(points, ends, periodic)
        loose, bulge = self._stray_chords(spline, points, first)
        try:
            if not loose.size and spline.curve:
                self.kept[span] = spline, bulge
                return []
        except GeometryError:  # a cusp: divide everywhere
            loose = np.arange(first, last)
        if last - first == 1:
            a, b = self.place(first % self.n), self.place(last % self.n if self.polygon.closed else last)
            raise GeometryError(
                f"between {a} and {b} no curve follows the points: it would leave their chord by {1e6 * bulge:.3g} um. "
                "Add points, reduce corner_angle, or raise the tolerance for noisy points"
            )
        inner = range(first + 1, last) if everywhere else sorted({*loose.tolist(), *(loose + 1).tolist()})
        if periodic:
            return [i % self.n for i in inner]
        # In a span of two chords or more, each chord has an inner point.
        return [i % self.n if self.polygon.closed else i for i in inner if first < i < last]

    def _stray_chords(self, spline: FittedSpline, points: Array, first: int) -> tuple[Index, float]:
        """Return the chords that a spline leaves too far, by their first points, and its largest distance from any."""
        away, against = spline.strays(points)
        chord = (first + np.arange(len(away))) % self.n
        bad = away > self.bounds[chord] + 2.0 * (self.tolerance or 0.0)
        if self.tolerance is None:
            bad |= against & self.forward[chord]
        return first + np.flatnonzero(bad), float(away.max())

    def curves(self) -> list[Curve]:
        """Return the curves in order from the first point."""
        if not self.polygon.closed or self.spans[0][0] == 0:
            return [spline.curve for spline in self.splines]
        # The path starts within the last span: cut it there.
        *others, last = self.splines
        start = self.n - self.spans[-1][0]
        if start == len(last.at) - 1:
            return [last.curve, *(spline.curve for spline in others)]
        head, tail = (BSpline(last.degree, *part) for part in split_at(last.degree, last.points, last.knots, last.at[[start]]))
        return [tail, *(spline.curve for spline in others), head]
