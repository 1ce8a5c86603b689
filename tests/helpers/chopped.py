"""Random curves chopped into short lines and arcs, with corners, narrow slots and rounded coordinates; and checks that share no code.

python tests/helpers/chopped.py FIRST AFTER     # checks the routes of these seeds
"""

from __future__ import annotations

import math
import sys

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from contourlab.feed import AxisLimits, Route, blended, limit_report, plan
from contourlab.geometry import Arc, Curve, Line, Path

Array = NDArray[np.float64]
_LONGEST = 6000.0  # of a program, in tolerances


def _stretch(rng: np.random.Generator, tolerance: float, heading: float) -> tuple[Array, float]:
    """Return points (n, 2) after (0, 0) along a slot, corner, line of many points, wave or arc, and the heading after."""
    kind, chord = rng.integers(6), tolerance * 10.0 ** rng.uniform(-0.7, 2.0)
    if kind == 0:  # a narrow slot, there and back, in many points or few
        depth, width, n = chord * rng.uniform(2.0, 6.0), tolerance * 10.0 ** rng.uniform(-0.5, 1.0), int(rng.integers(1, 6))
        x = np.linspace(0.0, depth, n + 1)
        local = np.concatenate([np.column_stack([x[1:], 0.0 * x[1:]]), np.column_stack([x[::-1], 0.0 * x + width])])
        after = heading + math.pi * rng.integers(2)
    elif kind == 1:
        local, after = np.array([[chord * rng.uniform(0.5, 5.0), 0.0]]), heading + rng.uniform(-3.0, 3.0)
    elif kind == 2:
        n = int(rng.integers(2, 30))
        local, after = np.column_stack([chord * np.cumsum(rng.uniform(0.2, 1.8, n)), np.zeros(n)]), heading + rng.choice([0.0, 1.0, -2.0])
    elif kind == 3:  # a wave
        n, length = int(rng.integers(8, 60)), chord * rng.uniform(6.0, 30.0)
        x = chord * np.arange(1, n + 1)
        local, after = np.column_stack([x, 0.1 * length * (np.cos(x / length * 6.0) - 1.0)]), heading
    else:
        radius, sweep = chord * 10.0 ** rng.uniform(0.0, 2.0), rng.uniform(0.2, 6.0) * rng.choice([-1.0, 1.0])
        n = int(np.clip(abs(sweep) * radius / chord, 2, 60))
        angle = sweep * np.cumsum(rng.uniform(0.3, 1.0, n) if kind == 4 else np.ones(n))
        angle *= sweep / angle[-1]
        local, after = radius * np.column_stack([np.sin(np.abs(angle)), np.sign(sweep) * (1.0 - np.cos(angle))]), heading + sweep
    c, s = math.cos(heading), math.sin(heading)
    return local @ np.array([[c, s], [-s, c]]), after


def chopped(seed: int) -> Route:
    """Return a random route: a tolerance of 1 to 100 um, up to some hundred curves, coordinates in whole 0.1 um."""
    rng = np.random.default_rng(seed)
    tolerance, heading = 10.0 ** rng.uniform(-6.0, -4.0), rng.uniform(0.0, 6.0)
    points = [np.zeros((1, 2))]
    for _ in range(int(rng.integers(1, 8))):
        more, heading = _stretch(rng, tolerance, heading)
        points.append(points[-1][-1] + more)
    flat = np.concatenate(points)
    flat = flat[np.cumsum(np.linalg.norm(np.diff(flat, axis=0, prepend=flat[:1]), axis=1)) < _LONGEST * tolerance]
    if rng.uniform() < 0.5:  # in space, on a slope or a waved surface
        flat = np.column_stack([flat, 0.3 * flat[:, 0] + 20.0 * tolerance * np.sin(flat[:, 1] / (100.0 * tolerance))])
    flat = np.round(flat + rng.uniform(-0.1, 0.1, flat.shape[1]), 7)
    flat = flat[np.append(True, np.any(np.diff(flat, axis=0) != 0.0, axis=1))]
    curves: list[Curve] = list(Line.many(flat[:-1], flat[1:])) if len(flat) > 1 else [Line(np.zeros(2), np.full(2, tolerance))]
    if flat.shape[1] == 2 and rng.uniform() < 0.3:  # short arcs in place of some lines
        for k in np.flatnonzero(rng.uniform(size=len(curves)) < 0.4).tolist():
            (a, b), bulge = (flat[k], flat[k + 1]), rng.uniform(-0.15, 0.15)
            side = np.array([a[1] - b[1], b[0] - a[0]])
            centre = 0.5 * (a + b) + 0.25 * side * (1.0 / bulge - bulge)
            start, sweep = math.atan2(*(a - centre)[::-1]), 4.0 * math.atan(bulge)
            curves[k] = Arc(centre, float(np.hypot(*(a - centre))), start, sweep)
    n = len(curves)
    feedrate = np.full(n, 10.0 ** rng.uniform(-2.5, -0.8))
    if rng.uniform() < 0.2:
        feedrate *= rng.choice([1.0, 0.7], n)
    stop = rng.uniform(size=n) < (0.02 if rng.uniform() < 0.3 else 0.0)
    return Route(
        Path(curves), feedrate, False, np.where(stop, 0.01, 0.0), np.arange(1, n + 1), corner_tolerance=tolerance, merge_tolerance=tolerance
    )


def _places(path: Path, spacing: float, most: int) -> Array:
    """Return arc lengths along a path at most a spacing apart or `most` on a curve, ends of curves included."""
    count = np.clip(np.ceil(np.diff(path.breaks) / spacing), 1, most).astype(int)
    places = [b + (e - b) * np.arange(n) / n for b, e, n in zip(path.breaks[:-1], path.breaks[1:], count, strict=True)]
    return np.append(np.concatenate(places), path.length)


def _distances(points: Array, path: Path, spacing: float, enough: float) -> Array:
    """Return distances (n,) of points (n, n_axis) from a path by brute force; of those nearer than `enough`, an upper bound."""
    place = _places(path, spacing, 10_000)
    tree = cKDTree(path.position(place))
    found = tree.query(points)[0]
    for i in np.flatnonzero(found > enough).tolist():
        near = np.array(tree.query_ball_point(points[i], found[i] + spacing))
        low, high = place[np.maximum(near - 1, 0)], place[np.minimum(near + 1, len(place) - 1)]
        found[i] = np.linalg.norm(path.position(np.linspace(low, high, 401).ravel()) - points[i], axis=1).min()
    return np.asarray(found)


def _walk(path: Path, step: float) -> Array:
    return np.asarray(path.position(np.linspace(0.0, path.length, 2 + int(path.length / step))))


def in_order(first: Path, second: Path, distance: float) -> bool:
    """Return whether two walkers on two paths can stay within a distance, never going back (the discrete Frechet distance)."""
    step = 0.5 * distance
    a, b = _walk(first, step), _walk(second, step)
    low, reached = 0, np.ones(1, dtype=bool)  # the places of the second walker that a row allows, from `low` on
    for k, place in enumerate(a):
        wide = reached.size + 16
        while True:
            near = np.linalg.norm(b[low : low + wide] - place, axis=1) <= distance + step
            number, before = np.arange(near.size), np.append(reached, np.zeros(near.size))[: near.size] != 0.0
            enter = near & (before | np.append(False, before[:-1])) if k else near & (number == 0)
            # From where it may enter, on along all that is near.
            now = np.maximum.accumulate(np.where(enter, number, -1)) > np.maximum.accumulate(np.where(near, -1, number))
            if not now[-1] or low + wide >= len(b):
                break
            wide *= 2
        if not now.any():
            return False
        first, last = np.flatnonzero(now)[[0, -1]]
        low, reached = low + int(first), now[first : last + 1]
    return low + reached.size == len(b)


def excess(planned: Path, programmed: Path, tolerance: float) -> float:
    """Return the largest distance of either path from the other, in tolerances; inf if they do not follow each other in order."""
    most = 0.0
    for here, there, dense in ((planned, programmed, 24), (programmed, planned, 6)):
        points = here.position(_places(here, 0.1 * tolerance, dense))
        most = max(most, float(_distances(points, there, 0.1 * tolerance, 0.99 * tolerance).max()) / tolerance)
    return most if in_order(planned, programmed, tolerance) else math.inf


def check(seed: int) -> None:
    """Plan a random route within random limits, and check the plan: distance and order, velocity, acceleration, jerk, stops."""
    given, rng = chopped(seed), np.random.default_rng(seed)
    n_axis, tolerance = given.path.n_axis, float(given.corner_tolerance[0])
    limits = AxisLimits(*(tuple(10.0 ** rng.uniform(low, high, n_axis)) for low, high in ((-1.3, -0.5), (-0.5, 1.0), (1.0, 3.0))))
    found = blended(given, limits)
    assert excess(found.path, given.path, tolerance) <= 1.0 + 1e-6
    ends = [path.position([0.0, path.length]) for path in (found.path, given.path)]
    np.testing.assert_allclose(ends[0], ends[1], rtol=0.0, atol=1e-14)
    np.testing.assert_array_equal(found.dwell[found.dwell > 0.0], given.dwell[given.dwell > 0.0])
    assert limit_report(plan(found, limits, 2e-4), limits).ok()  # samples of 1 ms miss peaks


if __name__ == "__main__":
    failed = []
    for number in range(*map(int, sys.argv[1:3])):
        try:
            check(number)
        except Exception as error:  # the other seeds are checked too
            failed.append(number)
            sys.stdout.write(f"{number} {error!r}\n")
    sys.stdout.write(f"seeds {sys.argv[1]} to {sys.argv[2]}: {len(failed)} failed\n")
    sys.exit(bool(failed))
