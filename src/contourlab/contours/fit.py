"""Fit curves through or near points: splines, straight lines, and corners where the points turn sharply."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.contours.polygon import Polygon
from contourlab.contours.spline_fit import FittedSpline, disagreement, interpolated, smoothed
from contourlab.errors import GeometryError
from contourlab.geometry import BSpline, Curve, Path
from contourlab.geometry.nurbs import split_at

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
        """Return first and last point of each spline; past the start of a closed polygon the numbers continue."""
        order = sorted(self.marks)
        if not order:
            return [(0, self.n)]
        return list(pairwise([*order, order[0] + self.n] if self.polygon.closed else order))

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
            raise GeometryError(self._refusal(first, last, bulge))
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

    def _refusal(self, first: int, last: int, bulge: float) -> str:
        a, b = self.place(first % self.n), self.place(last % self.n if self.polygon.closed else last)
        return (
            f"between {a} and {b} no curve follows the points: it would leave their chord by {1e6 * bulge:.3g} um. "
            "Add points, reduce corner_angle, or raise the tolerance for noisy points"
        )

    def curves(self) -> list[Curve]:
        """Return the curves in order from the first point."""
        if not self.polygon.closed or self.spans[0][0] == 0:
            return [spline.curve for spline in self.splines]
        # The path starts within the last span: cut it there.
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
