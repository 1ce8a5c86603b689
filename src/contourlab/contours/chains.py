"""Join the entities of a drawing that meet end to end, and make paths of them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.errors import GeometryError
from contourlab.geometry import Curve, Line, Path, backwards, with_ends

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
    if isinstance(curve, Line):
        return np.asarray(curve.end if s else curve.start)
    return np.asarray(curve.derivatives([s], 0)[0, 0])


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
        twin = next((j for j in seen[key] if _coincide(strand, strands[j], tolerance)), None)
        if twin is not None:
            left_out.append(f"{strand.what}: left out, because it lies on {strands[twin].what}")
            continue
        seen[key].append(i)
        kept.append(i)
    return kept, left_out


def _coincide(a: Strand, b: Strand, tolerance: float) -> bool:
    return abs(a.length - b.length) <= 2.0 * tolerance and float(np.linalg.norm(a.middle() - b.middle())) <= 2.0 * tolerance


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
