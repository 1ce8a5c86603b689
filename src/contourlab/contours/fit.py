"""Splines through points and near points, with corners where the points turn sharply."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import GeometryError
from contourlab.geometry import BSpline, Curve, Line, Path, with_ends
from contourlab.geometry.spline_cut import split_at

__all__ = ["PointFit", "fit_points"]

Array = NDArray[np.float64]
DEGREE = 5
SAME_PLACE = 1e-9
"""Ends [m] that make a closed contour."""
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)


@dataclass(frozen=True, eq=False)
class PointFit:
    """A path along points.

    Attributes
    ----------
    path : Path
    n_point : int
    n_corner : int
    deviation : float [m]
        Largest distance of a point from the curve, at the parameter that the point has; 0 but for rounding where the curve passes
        through.
    smoothed : bool
    """

    path: Path
    n_point: int
    n_corner: int
    deviation: float
    smoothed: bool

    @property
    def note(self) -> str:
        """What was done, in a line."""
        how = f"at most {1e6 * self.deviation:.3g} um from the curve" if self.smoothed else "on the curve"
        return f"{self.n_point} points, {how}, {self.n_corner} corners, {'closed' if self.path.closed else 'open'}"


def fit_points(points: Array, tolerance: float | None, corner_angle: float) -> PointFit:
    """Return the path along points: quintic splines, C4 between corners, over their arc length.

    Parameters
    ----------
    points : ndarray (n, n_axis) [m]
        Two or more, no two in a row alike; closed where the last is the first.
    tolerance : float [m] or None
        None to pass through them; else the largest distance of a point from a smoothing spline.
    corner_angle : float [rad], > 0, < pi
        A turn of the polygon by more than this is a corner: the spline ends there and another begins.

    Raises
    ------
    GeometryError
        If tolerance or angle are out of range, or the spline stands still somewhere.

    Notes
    -----
    Chord length as a parameter would hold a quintic to fourth order; the arc lengths of a first cubic spline are its parameter here, which
    gives the sixth. M. S. Floater and T. Surazhsky, "Parameterization for curve interpolation", Studies in Computational Mathematics 12,
    2006.
    """
    if tolerance is not None and not (0.0 < tolerance < math.inf):
        raise GeometryError(f"tolerance = {tolerance!r} m: must be > 0 and finite")
    if not 0.0 < corner_angle < math.pi:
        raise GeometryError(f"corner_angle = {math.degrees(corner_angle):g} deg: must be > 0 and < 180 deg")
    n = len(points)
    closed = n > 2 and float(np.linalg.norm(points[-1] - points[0])) <= SAME_PLACE
    if closed:
        points = np.concatenate([points[:-1], points[:1]])
    corners = _corners(points, closed, corner_angle)
    curves, deviation = _closed(points, corners, tolerance) if closed else _open(points, corners, tolerance)
    return PointFit(Path(curves, closed), n, len(corners), deviation, tolerance is not None)


def _corners(points: Array, closed: bool, angle: float) -> list[int]:
    chords = np.diff(points, axis=0)
    chords /= np.linalg.norm(chords, axis=1)[:, None]
    before = np.roll(chords, 1, axis=0)
    # atan2 of half-angle lengths: as good at small turns as at half a turn.
    turn = 2.0 * np.arctan2(np.linalg.norm(chords - before, axis=1), np.linalg.norm(chords + before, axis=1))
    found = np.flatnonzero(turn > angle)
    return [int(i) for i in found if i > 0 or closed]


@dataclass(frozen=True, eq=False)
class _Laid:
    """A curve along points, the parameter that each point has, and the largest distance of a point from there."""

    curve: Curve
    at: Array
    far: float


def _open(points: Array, corners: list[int], tolerance: float | None) -> tuple[list[Curve], float]:
    marks = [0, *corners, len(points) - 1]
    found = [_laid(points[a : b + 1], tolerance) for a, b in pairwise(marks)]
    return [one.curve for one in found], max(one.far for one in found)


def _closed(points: Array, corners: list[int], tolerance: float | None) -> tuple[list[Curve], float]:
    if not corners:
        whole = _laid(points, tolerance, periodic=True)
        return [whole.curve], whole.far
    if corners[0] == 0:
        return _open(points, corners[1:], tolerance)
    # The path starts within a stretch: one is laid from the last corner over the start to the first, and cut at the start.
    first, last = corners[0], corners[-1]
    whole = _laid(np.concatenate([points[last:-1], points[: first + 1]]), tolerance)
    head, tail = _cut(whole.curve, whole.at[len(points) - 1 - last])
    if first == last:
        return [tail, head], whole.far
    curves, far = _open(points[first : last + 1], [c - first for c in corners[1:-1]], tolerance)
    return [tail, *curves, head], max(far, whole.far)


def _cut(curve: Curve, u: float) -> tuple[Curve, Curve]:
    assert isinstance(curve, BSpline)  # three points or more lie on it
    (p, s), (q, t) = split_at(curve.degree, curve.points, curve.knots, np.array([u]))
    return BSpline(curve.degree, p, s), BSpline(curve.degree, q, t)


def _laid(points: Array, tolerance: float | None, *, periodic: bool = False) -> _Laid:
    """Lay a curve from the first point to the last."""
    n = len(points)
    if n == 2:
        return _Laid(Line(points[0], points[1]), np.array([0.0, 1.0]), 0.0)
    if tolerance is not None and n > DEGREE + 1:
        found = _smoothed(points, tolerance, periodic)
        if found is not None:
            return found
    at = _arc_lengths(points, periodic)
    curve = _interpolated(points, at, _degree(n, DEGREE, periodic), periodic)
    return _measured(curve, points, at)


def _measured(curve: BSpline, points: Array, at: Array) -> _Laid:
    away = np.linalg.norm(curve.raw(np.clip(at, curve.first, curve.last), 0)[0] - points, axis=1)
    return _Laid(curve, at, float(away.max()))


def _degree(n: int, wanted: int, periodic: bool) -> int:
    """Return the degree that n points allow; on a closed curve the last is the first once more."""
    if not periodic:
        return min(wanted, n - 1)
    return wanted if n > wanted + 1 else 3


def _chords(points: Array) -> Array:
    return np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])


def _interpolated(points: Array, at: Array, degree: int, periodic: bool) -> BSpline:
    from scipy.interpolate import make_interp_spline

    made = make_interp_spline(at, points, k=degree, bc_type="periodic" if periodic else None)
    curve = BSpline(degree, made.c, made.t)
    if not periodic:
        # The linear system leaves rounding in the ends, which other curves join.
        return BSpline(degree, np.concatenate([points[:1], made.c[1:-1], points[-1:]]), made.t)
    return curve


def _arc_lengths(points: Array, periodic: bool) -> Array:
    """Return the arc lengths of the points along a cubic spline through them."""
    from scipy.interpolate import make_interp_spline

    chords = _chords(points)
    cubic = make_interp_spline(chords, points, k=_degree(len(points), 3, periodic), bc_type="periodic" if periodic else None)
    half = 0.5 * np.diff(chords)
    speed = np.linalg.norm(cubic((chords[:-1] + half)[:, None] + half[:, None] * _NODES, nu=1), axis=2)
    return np.concatenate([[0.0], np.cumsum(half * (speed @ _WEIGHTS))])


def _smoothed(points: Array, tolerance: float, periodic: bool) -> _Laid | None:
    """Return the smoothest of a row of splines that stays within the tolerance; None where only an interpolating one does."""
    from scipy.interpolate import splprep  # make_splprep, its successor, knows closed curves only in the newest versions

    at = _chords(points)
    weights = np.ones(len(points))
    if not periodic:
        weights[[0, -1]] = 100.0  # the ends are points of the path: what is left of their distance is taken out below
    budget = len(points) * tolerance**2
    for halving in range(24):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # it says that it came no closer: what it came to is measured here
            (knots, coefficients, _), _ = splprep(list(points.T), w=weights, u=at, k=DEGREE, s=budget * 0.5**halving, per=periodic)
        curve = BSpline(DEGREE, np.array(coefficients).T, knots)
        if not periodic:
            pinned = with_ends(curve, points[0], points[-1])
            assert isinstance(pinned, BSpline)
            curve = pinned
        found = _measured(curve, points, at)
        if found.far <= tolerance:
            return found
    return None
