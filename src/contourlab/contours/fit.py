"""Curves through points and near points: splines, straight stretches, and corners where the points turn sharply."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from contourlab.contours.polygon import Polygon
from contourlab.contours.spline_fit import FittedSpline, disagreement, interpolated, smoothed
from contourlab.errors import GeometryError
from contourlab.geometry import BSpline, Curve, Path
from contourlab.geometry.nurbs import split_at

Array = NDArray[np.float64]
SAME_PLACE = 1e-9
"""Ends [m] that make a closed contour."""
DOUBT = 0.3
"""Where a quintic and a cubic spline through the points differ by this much of their bulge, neither is to be trusted."""
ROUNDS = 12
"""How often splines are divided where they leave their polygon, before they are divided at each point."""


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
    bulge : float [m]
        Largest distance of the curve, between two points, from the chord that joins them.
    n_straight : int
        Straight stretches: chords much longer than the spacing next to them, kept as lines that the splines next to them are tangent to.
    n_divided : int
        Points at which a spline was divided, with a common tangent but not a common curvature, as it would have left its polygon further
        than the polygon's turns explain.
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
        how = f"at most {1e6 * self.deviation:.3g} um from the curve" if self.smoothed else "on the curve"
        parts = [f"{self.n_point} points", how, f"at most {1e6 * self.bulge:.3g} um from their chords between them"]
        parts.append(f"{self.n_corner} corners")
        if self.n_straight:
            parts.append(f"{self.n_straight} straight stretches")
        if self.n_divided:
            parts.append(f"splines divided at {self.n_divided} points to keep to the polygon")
        return ", ".join([*parts, "closed" if self.path.closed else "open"])


def fit_points(
    points: Array, tolerance: float | None, corner_angle: float, place: Callable[[int], str] = lambda i: f"point {i + 1}"
) -> PointFit:
    """Return the path along points: quintic splines, C4 between corners and straight stretches, over their arc length.

    Between two points the curve leaves their chord by no more than the turns of the polygon at its ends explain; a spline that would do so
    is divided.

    Parameters
    ----------
    points : ndarray (n, n_axis) [m]
        Two or more, no two in a row alike; closed where the last is the first.
    tolerance : float [m] or None
        None to pass through them; else the largest distance of a point from a smoothing spline.
    corner_angle : float [rad], > 0, < pi
        A turn of the polygon by more than this is a corner: the spline ends there and another begins.
    place : callable
        Names a point, by its number from 0, in messages.

    Raises
    ------
    GeometryError
        If tolerance or angle are out of range, the spline has a cusp, or no spline keeps to the polygon.

    Notes
    -----
    `contourlab.contours.polygon` defines straight stretches and the largest bulge; `contourlab.contours.spline_fit` fits the splines.
    """
    if tolerance is not None and not (0.0 < tolerance < math.inf):
        raise GeometryError(f"tolerance = {tolerance!r} m: must be > 0 and finite")
    if not 0.0 < corner_angle < math.pi:
        raise GeometryError(f"corner_angle = {math.degrees(corner_angle):g} deg: must be > 0 and < 180 deg")
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
    """Return the points where splines end, with their tangents there, and how many straight stretches there are."""
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
    """Return the straight stretches, and the points where spacing jumps, except where a single spline is reliable.

    Points of a smooth curve, however unevenly spaced, are better served by one spline.
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
    sound = [(a, b) for a, b in straights if (doubt[np.arange(a, b + 1 if b >= a else b + 1 + n) % n] > DOUBT).any()]
    return sound, [point for point, chord in jumps if doubt[chord] > DOUBT]


class _Fitting:
    """Splines between marks: points where a spline ends, with the tangent it has there, or None where it is free.

    The splines begin at the first mark. Only splines that leave their polygon are divided and fitted again.
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
            self.spans = self._spans()
            self.kept = {span: self.kept[span] for span in self.spans if span in self.kept}
            loose = [self._fit_span(span, everywhere=turn >= ROUNDS) for span in self.spans if span not in self.kept]
            loose = [points for points in loose if points]
            if not loose:
                break
            for points in loose:
                for i in points:
                    self.marks.setdefault(i, self.polygon.tangent(i))
        self.splines = [self.kept[span][0] for span in self.spans]
        self.bulge = max(self.kept[span][1] for span in self.spans)

    def _spans(self) -> list[tuple[int, int]]:
        """Return first and last point of each spline; past the start of a closed polygon the numbers go on."""
        order = sorted(self.marks)
        if not order:
            return [(0, self.n)]
        return list(pairwise([*order, order[0] + self.n] if self.polygon.closed else order))

    def _fit_span(self, span: tuple[int, int], everywhere: bool) -> list[int]:
        """Fit the spline of a span and keep it if it is good; else return the points at which to divide it."""
        first, last = span
        points = self.polygon.span(first, last)
        periodic = not self.marks
        ends = (None, None) if periodic else (self.marks[first], self.marks[last % self.n if self.polygon.closed else last])
        found = smoothed(points, self.tolerance, ends, periodic) if self.tolerance is not None and last - first > 1 else None
        if found is not None and self._stray_chords(found, points, first)[0].size:
            found = None
        if found is None:
            found = interpolated(points, ends, periodic)
        loose, bulge = self._stray_chords(found, points, first)
        try:
            if not loose.size and found.curve:
                self.kept[span] = found, bulge
                return []
        except GeometryError:  # a cusp: splines stray from all points
            loose = np.arange(first, last)
        if last - first == 1:
            raise GeometryError(self._refusal(first, last, bulge))
        inner = range(first + 1, last) if everywhere else sorted({*loose.tolist(), *(loose + 1).tolist()})
        if periodic:
            return [i % self.n for i in inner]
        # A span of two chords or more has a point inside at one end of each of its chords.
        return [i % self.n if self.polygon.closed else i for i in inner if first < i < last]

    def _stray_chords(self, found: FittedSpline, points: Array, first: int) -> tuple[NDArray[np.int64], float]:
        """Return the chords that a curve leaves too far, by the numbers of their first points, and the farthest it leaves any."""
        away, against = found.strays(points)
        chord = (first + np.arange(len(away))) % self.n
        bad = away > self.bounds[chord] + 2.0 * (self.tolerance or 0.0)
        if self.tolerance is None:
            bad |= against & self.forward[chord]
        return first + np.flatnonzero(bad), float(away.max())

    def _refusal(self, first: int, last: int, bulge: float) -> str:
        a, b = self.place(first % self.n), self.place(last % self.n if self.polygon.closed else last)
        return (
            f"between {a} and {b} no curve keeps to the points: it would leave their chord by {1e6 * bulge:.3g} um. "
            "Denser points, a smaller corner_angle, or a larger tolerance for points that are noisy would help"
        )

    def curves(self) -> list[Curve]:
        """Return the curves in their order from the first point."""
        if not self.polygon.closed or self.spans[0][0] == 0:
            return [spline.curve for spline in self.splines]
        # The path starts within the last span, which is cut there.
        *others, last = self.splines
        start = self.n - self.spans[-1][0]
        if start == len(last.at) - 1:
            return [last.curve, *(spline.curve for spline in others)]
        head, tail = _cut(last.curve, float(last.at[start]))
        return [tail, *(spline.curve for spline in others), head]


def _cut(curve: Curve, u: float) -> tuple[Curve, Curve]:
    assert isinstance(curve, BSpline)  # three points or more lie on it
    (p, s), (q, t) = split_at(curve.degree, curve.points, curve.knots, np.array([u]))
    return BSpline(curve.degree, p, s), BSpline(curve.degree, q, t)
