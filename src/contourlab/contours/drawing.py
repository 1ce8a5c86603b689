"""The contents of a drawing: shapes, their curves, chains of entities that meet end to end, what is left out, and the choice of one chain.

An affine map keeps the kind of a shape; then the shapes become curves.
"""

from __future__ import annotations

import math
import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path as File
from typing import TypeAlias

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.errors import GeometryError, UnitError, refuse
from contourlab.geometry import Arc, BSpline, Curve, EllipticalArc, Line, Nurbs, Path, backwards, with_ends
from contourlab.geometry.nurbs import cut_where_curvature_jumps, inner_knots, split_at
from contourlab.units import to_si

ROUND = 1e-12
"""Largest relative difference of the half-diameters of a circle."""
SAME_KNOT = 1e-10
"""Knots closer than this, relative to their range, are one rounded knot."""
CORNER = 1e-6
"""Jump of the tangent [rad] that divides a curve."""
STRAIGHT = 1e-10
"""Largest distance of the control points of a line from it, relative to its length."""
NUDGE = 1e-6
"""Largest shift [m] of a control point that coincides with the end of its curve."""


@dataclass(frozen=True, eq=False)
class LineShape:
    """From one point to another, each (n_axis,)."""

    start: Array
    end: Array

    def mapped(self, matrix: Array, offset: Array) -> LineShape:
        """Return the image under p -> matrix p + offset; a matrix (2, 3) projects."""
        return LineShape(matrix @ self.start + offset, matrix @ self.end + offset)

    def extent(self) -> tuple[Array, Array]:
        """Return lower and upper bounds of the coordinates."""
        return np.minimum(self.start, self.end), np.maximum(self.start, self.end)

    def curves(self) -> list[Curve]:
        """Return the curves, end to end."""
        return [Line(self.start, self.end)]


@dataclass(frozen=True, eq=False)
class ConicShape:
    """c + p cos t + q sin t, t from `start` to `end`, which may fall."""

    centre: Array
    p: Array
    q: Array
    start: float
    end: float

    def mapped(self, matrix: Array, offset: Array) -> ConicShape:
        """Return the image under p -> matrix p + offset."""
        return replace(self, centre=matrix @ self.centre + offset, p=matrix @ self.p, q=matrix @ self.q)

    def extent(self) -> tuple[Array, Array]:
        """Return bounds of the coordinates, those of the full ellipse."""
        reach = np.hypot(self.p, self.q)
        return self.centre - reach, self.centre + reach

    def curves(self) -> list[Curve]:
        """Return the curve: an arc where the shape is circular."""
        a, b = float(np.linalg.norm(self.p)), float(np.linalg.norm(self.q))
        if abs(a - b) <= ROUND * a and abs(float(self.p @ self.q)) <= ROUND * a * b:
            return [self._arc(0.5 * (a + b))]
        if self.end > self.start:
            return [EllipticalArc(self.centre, self.p, self.q, self.start, self.end)]
        return [EllipticalArc(self.centre, self.p, -self.q, -self.start, -self.end)]

    def _arc(self, radius: float) -> Arc:
        sweep = self.end - self.start
        if self.centre.size == 2:  # in the axes of the plane
            spoke = self.p * math.cos(self.start) + self.q * math.sin(self.start)
            sense = math.copysign(1.0, self.p[0] * self.q[1] - self.p[1] * self.q[0])
            return Arc(self.centre, radius, math.atan2(spoke[1], spoke[0]), sense * sweep)
        return Arc(self.centre, radius, self.start, sweep, self.p / radius, self.q / radius)


@dataclass(frozen=True, eq=False)
class SplineShape:
    """A B-spline: control points (n, n_axis), knots (n + degree + 1,), and weights (n,) if it is rational."""

    degree: int
    points: Array
    knots: Array
    weights: Array | None = None

    @classmethod
    def bezier(cls, *points: Array) -> SplineShape:
        """Return a Bezier curve from two or more control points."""
        n = len(points)
        return cls(n - 1, np.array(points), np.repeat([0.0, 1.0], n))

    def mapped(self, matrix: Array, offset: Array) -> SplineShape:
        """Return the image under p -> matrix p + offset."""
        return replace(self, points=self.points @ matrix.T + offset)

    def extent(self) -> tuple[Array, Array]:
        """Return bounds of the coordinates, those of the control points."""
        return self.points.min(axis=0), self.points.max(axis=0)

    def curves(self) -> list[Curve]:
        """Return the curves, cut at corners."""
        return spline_curves(self.degree, self.points, self.knots, self.weights)


Shape: TypeAlias = LineShape | ConicShape | SplineShape


# --- splines of files: merge rounded knots, cut at corners, replace straight ones by lines ---------------------------------------------


def spline_curves(degree: int, points: Array, knots: Array, weights: Array | None) -> list[Curve]:
    """Return the curves of a spline, end to end.

    Parameters
    ----------
    degree : int, >= 1
    points : ndarray (n, n_axis) [m]
    knots : ndarray (n + degree + 1,)
    weights : ndarray (n,) or None
        None, or all equal, for a polynomial spline.

    Raises
    ------
    GeometryError
        If the data do not fit together, or the curve has a gap or a cusp.
    """
    if len(knots) != len(points) + degree + 1 or len(points) <= degree:
        raise GeometryError(f"degree {degree} with {len(points)} control points needs {len(points) + degree + 1} knots, not {len(knots)}")
    if weights is not None and (len(weights) != len(points) or not (weights > 0.0).all()):
        raise GeometryError("give one weight > 0 for each control point")
    if weights is not None and np.ptp(weights) <= 1e-14 * weights.max():
        weights = None
    t = _settled(knots)
    if _is_straight(points):
        ends = points[[0, -1]]
        if not _starts_and_ends_at_points(degree, t):
            whole = BSpline(degree, points, t) if weights is None else Nurbs(degree, points, t, weights)
            ends = whole.raw(np.array([whole.first, whole.last]), 0)[0]
        return [Line(*ends)]
    lifted = points if weights is None else np.column_stack([points * weights[:, None], weights])
    lifted, t = _without_gaps(degree, lifted, t)
    inner, count = inner_knots(degree, t)
    # At a knot of multiplicity `degree` or more the tangent may jump.
    pieces = split_at(degree, lifted, t, inner[count >= degree])
    curves = [_curve(degree, c, k, weights is not None) for c, k in _smoothly_joined(degree, pieces, weights is not None)]
    return [piece for curve in curves for piece in (cut_where_curvature_jumps(curve) if isinstance(curve, BSpline | Nurbs) else [curve])]


def _settled(knots: Array) -> Array:
    """Return the knots; make those equal that differ only by rounding."""
    t = np.array(knots, dtype=float)
    if not np.isfinite(t).all() or np.any(np.diff(t) < -SAME_KNOT * max(np.ptp(t), 1e-300)):
        raise GeometryError("knots must be finite and must not decrease")
    for i in range(1, t.size):
        if t[i] - t[i - 1] <= SAME_KNOT * (t[-1] - t[0]):
            t[i] = t[i - 1]
    return t


def _without_gaps(degree: int, points: Array, t: Array) -> tuple[Array, Array]:
    """Merge control points that coincide at a knot whose multiplicity exceeds the degree."""
    inner, count = inner_knots(degree, t)
    for u in inner[count > degree]:
        k = int(np.searchsorted(t, u))
        if np.count_nonzero(t == u) > degree + 1 or np.abs(points[k] - points[k - 1]).max() > 1e-9 * np.ptp(points, axis=0).max():
            raise GeometryError(f"the spline has a gap at parameter {u:.9g}")
        points, t = np.delete(points, k, axis=0), np.delete(t, k)
    return points, t


def _is_straight(points: Array) -> bool:
    """Return whether all control points lie on one line, in order."""
    chord = points[-1] - points[0]
    size = float(np.linalg.norm(chord))
    if size == 0.0:
        return False
    along = (points - points[0]) @ (chord / size)
    away = np.linalg.norm(points - points[0] - along[:, None] * (chord / size), axis=1)
    return bool(away.max() <= STRAIGHT * size and np.all(np.diff(along) >= -STRAIGHT * size))


def _starts_and_ends_at_points(degree: int, t: Array) -> bool:
    return bool(t[0] == t[degree] and t[-1] == t[-degree - 1])


def _smoothly_joined(degree: int, pieces: list[tuple[Array, Array]], rational: bool) -> list[tuple[Array, Array]]:
    """Rejoin pieces that meet without a corner."""
    joined = pieces[:1]
    for points, t in pieces[1:]:
        before, knots = joined[-1]
        turn = _direction(points[:2], rational) - _direction(before[-2:], rational)
        if np.linalg.norm(turn) > CORNER:
            joined.append((points, t))
        else:
            joined[-1] = np.concatenate([before, points[1:]]), np.concatenate([knots[:-1], t[degree + 1 :]])
    return joined


def _direction(pair: Array, rational: bool) -> Array:
    a, b = (pair[:, :-1] / pair[:, -1:]) if rational else pair
    size = float(np.linalg.norm(b - a))
    return np.asarray((b - a) / size) if size > 0.0 else np.full(a.shape, np.nan)


def _curve(degree: int, points: Array, t: Array, rational: bool) -> Curve:
    plain, weights = (points[:, :-1] / points[:, -1:], points[:, -1]) if rational else (points, None)
    if _is_straight(plain) and _starts_and_ends_at_points(degree, t):
        return Line(plain[0], plain[-1])
    if degree > 1 and _starts_and_ends_at_points(degree, t):
        plain = _without_cusp(_without_cusp(plain)[::-1])[::-1]
    return BSpline(degree, plain, t) if weights is None else Nurbs(degree, plain, t, weights)


def _without_cusp(points: Array) -> Array:
    """Move a second control point that coincides with the first towards the third, by up to a micrometre.

    The curve moves by less than half of that. Drawing programs write such points for unused handles.
    """
    size = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    leg = points[2] - points[0] if len(points) > 2 else np.zeros(1)
    length = float(np.linalg.norm(leg))
    if length == 0.0 or float(np.linalg.norm(points[1] - points[0])) > 1e-6 * size:
        return points
    moved = points.copy()
    moved[1] = points[0] + leg * (min(NUDGE, 0.5 * length) / length)
    return moved


CLOSE = 2e-10
"""Gaps up to this size [m] stay; a path accepts 1e-9 m."""
FURTHEST = 5.0
"""Largest closed gap, in tolerances; closed entities of up to two tolerances may be missing there."""


@dataclass(frozen=True, eq=False)
class Strand:
    """The curves of one entity of a drawing, end to end.

    Attributes
    ----------
    what : str
        Name in messages: ``LINE #2F``.
    """

    curves: tuple[Curve, ...]
    what: str = ""
    layer: str = ""

    @cached_property
    def ends(self) -> Array:
        """Start and end point: (2, n_axis)."""
        first, last = self.curves[0], self.curves[-1]
        return np.array([_end(first, 0.0), _end(last, last.length)])

    @property
    def length(self) -> float:
        """Length of all curves [m]."""
        return float(sum(curve.length for curve in self.curves))

    def turned(self) -> Strand:
        """Return the strand from its end to its start."""
        return Strand(tuple(backwards(curve) for curve in reversed(self.curves)), self.what, self.layer)

    def middle(self) -> Array:
        """Return the position at half its length, the same from either end."""
        along = 0.5 * self.length
        for curve in self.curves:
            if along <= curve.length:
                return np.asarray(curve.position([along])[0])
            along -= curve.length
        return np.asarray(self.ends[1])


def _end(curve: Curve, s: float) -> Array:
    return np.asarray(curve.end if s else curve.start) if isinstance(curve, Line) else np.asarray(curve.derivatives([s], 0)[0, 0])


@dataclass(frozen=True, eq=False)
class Chain:
    """Strands end to end.

    Attributes
    ----------
    strands : tuple of (Strand, bool)
        In order of travel, and whether each runs backwards.
    tolerance : float [m]
        Largest gap between ends that meet; `FURTHEST` times as much is closed.
    """

    strands: tuple[tuple[Strand, bool], ...]
    closed: bool
    tolerance: float

    @property
    def length(self) -> float:
        """Length without gaps [m]."""
        return float(sum(strand.length for strand, _ in self.strands))

    @property
    def start(self) -> Array:
        """Start point (n_axis,)."""
        strand, turned = self.strands[0]
        return np.asarray(strand.ends[1 if turned else 0])

    @property
    def layers(self) -> tuple[str, ...]:
        """Layers in the order of travel."""
        return tuple(dict.fromkeys(strand.layer for strand, _ in self.strands))

    @cached_property
    def path(self) -> Path:
        """The chain as a path, with its gaps closed."""
        curves = [curve for strand, turned in self.strands for curve in (strand.turned() if turned else strand).curves]
        return Path(_joined(curves, self.closed, self.tolerance), self.closed)

    def backwards(self) -> Chain:
        """Return the chain from its end to its start; a closed chain keeps its starting point."""
        return Chain(tuple((strand, not turned) for strand, turned in reversed(self.strands)), self.closed, self.tolerance)


def chains_of(strands: Sequence[Strand], tolerance: float) -> tuple[list[Chain], list[str]]:
    """Join strands to chains, in the order of their first strands.

    Parameters
    ----------
    tolerance : float [m], > 0
        Largest gap between ends that meet.

    Returns
    -------
    list of Chain
        Each runs in the direction of its first strand in the drawing; a closed one starts there. Chains end where more than two ends meet.
    list of str
        Omitted strands: up to two tolerances long with ends that meet, or on top of another.
    """
    if not strands:
        return [], []
    node = _nodes(np.array([end for strand in strands for end in strand.ends]), tolerance).reshape(-1, 2)
    kept, left_out = _without_doubles(strands, node, tolerance)
    meet: defaultdict[int, list[tuple[int, int]]] = defaultdict(list)
    for i in kept:
        for end in (0, 1):
            meet[int(node[i, end])].append((i, end))
    used: set[int] = set()
    chains = []
    for i in kept:
        if i in used:
            continue
        used.add(i)
        ahead = _follow(i, 1, node, meet, used)
        behind = [(j, 1 - end) for j, end in reversed(_follow(i, 0, node, meet, used))]
        # Each strand, and the end at which it is entered.
        run = [*behind, (i, 0), *ahead]
        closed = node[run[0][0], run[0][1]] == node[run[-1][0], 1 - run[-1][1]]
        chains.append(Chain(tuple((strands[j], entered == 1) for j, entered in run), bool(closed), tolerance))
    return chains, left_out


def _follow(i: int, end: int, node: Index, meet: dict[int, list[tuple[int, int]]], used: set[int]) -> list[tuple[int, int]]:
    """Return the strands that follow one end of strand i, each with the end at which it is entered."""
    run: list[tuple[int, int]] = []
    while len(here := meet[int(node[i, end])]) == 2:
        j, entered = here[1] if here[0] == (i, end) else here[0]
        if j in used:
            break
        used.add(j)
        run.append((j, entered))
        i, end = j, 1 - entered
    return run


def _nodes(points: Array, tolerance: float) -> Index:
    """Return a number for each point, equal for points that meet."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import cKDTree

    places, which = np.unique(points, axis=0, return_inverse=True)
    pairs = cKDTree(places).query_pairs(tolerance, output_type="ndarray")
    graph = coo_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(len(places), len(places)))
    return np.asarray(connected_components(graph, directed=False)[1][which.ravel()])


def _without_doubles(strands: Sequence[Strand], node: Index, tolerance: float) -> tuple[list[int], list[str]]:
    kept: list[int] = []
    left_out: list[str] = []
    seen: defaultdict[tuple[int, int], list[int]] = defaultdict(list)
    for i, strand in enumerate(strands):
        key = (int(node[i].min()), int(node[i].max()))
        if key[0] == key[1] and strand.length <= 2.0 * tolerance:
            left_out.append(f"{strand.what}: left out, because its ends meet and it is at most two tolerances long")
            continue
        near = (j for j in seen[key] if abs(strand.length - strands[j].length) <= 2.0 * tolerance)
        twin = next((j for j in near if float(np.linalg.norm(strand.middle() - strands[j].middle())) <= 2.0 * tolerance), None)
        if twin is not None:
            left_out.append(f"{strand.what}: left out, because it lies on {strands[twin].what}")
            continue
        seen[key].append(i)
        kept.append(i)
    return kept, left_out


def _joined(curves: list[Curve], closed: bool, tolerance: float) -> list[Curve]:
    """Return the curves with their ends moved together; a short line closes the gap where an end cannot be moved."""
    n = len(curves)
    ends = np.array([[_end(curve, 0.0), _end(curve, curve.length)] for curve in curves])
    wanted = ends.copy()
    joints = [(i, (i + 1) % n) for i in range(n if closed else n - 1)]
    gaps = {i: float(np.linalg.norm(ends[i, 1] - ends[j, 0])) for i, j in joints}
    if max(gaps.values(), default=0.0) <= CLOSE:
        return curves
    for i, j in joints:
        if gaps[i] > FURTHEST * tolerance:  # within one entity
            raise GeometryError(f"there is a gap of {1e3 * gaps[i]:.3g} mm at {ends[i, 1].tolist()} m: close it in the drawing")
        if gaps[i] > CLOSE:
            # Where a line meets an arc or a spline, only the line moves.
            share = {(True, False): 0.0, (False, True): 1.0}.get((isinstance(curves[i], Line), isinstance(curves[j], Line)), 0.5)
            wanted[i, 1] = wanted[j, 0] = ends[j, 0] + share * (ends[i, 1] - ends[j, 0])
    moved = [_moved(curve, ends[i], wanted[i]) for i, curve in enumerate(curves)]
    joined: list[Curve] = []
    for i, curve in enumerate(moved):
        joined.append(curve)
        if i in gaps:
            a, b = _end(curve, curve.length), _end(moved[(i + 1) % n], 0.0)
            if float(np.linalg.norm(b - a)) > CLOSE:
                joined.append(Line(a, b))
    return joined


def _moved(curve: Curve, ends: Array, wanted: Array) -> Curve:
    """Return the curve with its ends moved; itself if that is not possible."""
    if np.array_equal(ends, wanted):
        return curve
    try:
        return with_ends(curve, *wanted)
    except GeometryError:
        return curve


TOLERANCE = 1e-6
"""Default largest gap [m] between ends that meet."""
OUTERMOST = 1e9
"""Larger coordinates [m] are mistakes."""
LISTED = 20


@dataclass(frozen=True)
class LeftOut:
    """An entity that is not part of any contour.

    Attributes
    ----------
    kind : str
        Name in the file: ``TEXT``.
    """

    kind: str
    layer: str = ""
    why: str = ""


@dataclass(frozen=True, eq=False)
class Drawing:
    """The contours of a drawing.

    Attributes
    ----------
    chains : tuple of Chain
        In the order of the file.
    left_out : tuple of LeftOut
        Entities without a contour, such as texts.
    notes : tuple of str
        Omitted duplicates and very short entities.
    layers : tuple of str
        Layers of all entities; empty if the format has none.
    """

    file: File
    chains: tuple[Chain, ...]
    left_out: tuple[LeftOut, ...] = ()
    notes: tuple[str, ...] = ()
    layers: tuple[str, ...] = ()

    def refuse_left_out(self, ignore: Sequence[str]) -> None:
        """Raise a GeometryError for entities without a contour, unless their kind is in `ignore`."""
        ignored = {kind.upper() for kind in ignore}
        counts = Counter((item.kind, item.layer, item.why) for item in self.left_out if item.kind.upper() not in ignored)
        if not counts:
            return
        listed = [
            f"{n} {kind}{f' on layer {layer}' if layer else ''}{f' ({why})' if why else ''}" for (kind, layer, why), n in counts.items()
        ]
        kinds = ", ".join(f'"{kind}"' for kind in dict.fromkeys(kind for kind, _, _ in counts))
        choice = "choose a layer without them, or " if self.layers else ""
        raise GeometryError(f"{self.file}: contains {_some(listed)}, which are not contours: {choice}write ignore = [{kinds}]")

    def chosen(self, chain: int | None = None) -> Chain:
        """Return the only chain, or the one with a number, counted from 1.

        Raises
        ------
        GeometryError
            If the number does not exist, or there are several chains and none is chosen; lists them.
        """
        if not self.chains:
            layers = f"; its layers are {', '.join(self.layers)}" if self.layers else ""
            notes = f"; notes: {_some(self.notes)}" if self.notes else ""
            raise GeometryError(f"{self.file}: contains no contour{layers}{notes}")
        number = 1 if chain is None and len(self.chains) == 1 else chain
        if number is not None and 1 <= number <= len(self.chains):
            return self.chains[number - 1]
        if chain is not None:
            raise GeometryError(f"{self.file}: chain = {chain} does not exist: {self._listed()}")
        layer = ', layer = "..."' if len(self.layers) > 1 else ""
        raise GeometryError(f"{self.file}: {self._listed()}; write for example chain = 1{layer}, or a tolerance above the gaps")

    def _listed(self) -> str:
        rows = []
        for number, chain in enumerate(self.chains, 1):
            place = ", ".join(f"{1e3 * x:.6g}" for x in chain.start)
            layers = f", layer {' and '.join(chain.layers)}" if any(chain.layers) else ""
            rows.append(f"{number}: {'closed' if chain.closed else 'open'}, {1e3 * chain.length:.6g} mm long, from ({place}) mm{layers}")
        return f"{'there is 1 chain' if len(rows) == 1 else f'there are {len(rows)} separate chains'}: {_some(rows)}"


def _some(rows: Sequence[str]) -> str:
    return "; ".join(rows[:LISTED]) + (f"; and {len(rows) - LISTED} more" if len(rows) > LISTED else "")


def strand_of(shapes: Iterable[Shape], file: File, what: str, layer: str = "") -> Strand:
    """Return the curves of an entity.

    Raises
    ------
    GeometryError
        If its data do not define curves, or reach too far; names the entity.
    """
    try:
        shapes = list(shapes)
        reach = max((float(np.abs(bound).max()) for shape in shapes for bound in shape.extent()), default=0.0)
        refuse(not reach <= OUTERMOST, GeometryError, f"reaches {reach:.3g} m from the origin, more than {OUTERMOST:g} m: check the unit")
        return Strand(tuple(curve for shape in shapes for curve in shape.curves()), what, layer)
    except GeometryError as error:
        raise GeometryError(f"{file}: {what}{f' on layer {layer}' if layer else ''}: {error}") from error


def drawing_of(
    file: File,
    strands: Sequence[Strand],
    tolerance: float | None,
    left_out: Sequence[LeftOut],
    notes: Sequence[str],
    layers: Sequence[str] = (),
) -> Drawing:
    """Create a drawing from strands.

    Raises
    ------
    GeometryError
        If the tolerance is out of range.
    """
    gap = TOLERANCE if tolerance is None else tolerance
    refuse(not (0.0 < gap < math.inf), GeometryError, f"tolerance = {tolerance!r} m: must be > 0 and finite")
    chains, dropped = chains_of(strands, gap)
    return Drawing(file, tuple(chains), tuple(left_out), (*notes, *dropped), tuple(layers))


def unit_size(unit: str) -> float:
    """Return the size of a unit of length [m].

    Raises
    ------
    UnitError
        If it is not a unit of length.

    >>> unit_size("inch")
    0.0254
    """
    size = 0.0
    if re.fullmatch(r"[A-Za-zµμ_]{1,30}", unit):
        try:
            size = to_si(f"1 {unit}", "m")
        except UnitError as error:
            raise UnitError(f'unit = "{unit}": {error}') from error
        except Exception:  # the unit parser may raise anything
            size = 0.0
    refuse(not (size > 0.0 and math.isfinite(size)), UnitError, f'{unit!r} is not a unit of length: write for example "mm" or "inch"')
    return size
