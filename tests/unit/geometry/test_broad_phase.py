"""Candidate curves for the closest point: fewer than all in the window, and always including the right one."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from numpy.typing import NDArray

from contourlab.geometry import Arc, BSpline, Curve, Line, Path
from contourlab.geometry.blend import blends, quintic_bezier
from contourlab.geometry.foot_point import FootPoint, searched

Array = NDArray[np.float64]


def polygon(points: Array, closed: bool) -> Path:
    joints = [*points, points[0]] if closed else points
    return Path([Line(tuple(a), tuple(b)) for a, b in pairwise(joints)], closed=closed)


def walk(n_axis: int, closed: bool, n: int = 60) -> Path:
    rng = np.random.default_rng(n_axis + 10 * closed)
    return polygon(0.003 * np.cumsum(rng.normal(size=(n, n_axis)), axis=0), closed)


def beads() -> Path:
    """Return consecutive half circles, left and right: segments far longer than wide."""
    return Path([Arc((0.002 * i, 0.0), 0.001, np.pi, np.pi * (-1) ** i) for i in range(40)])


def wavy() -> Path:
    """Return splines with lines between, each curve as long as ten of the walk's."""
    curves: list[Curve] = []
    for i in range(12):
        x = 0.03 * i
        points = np.array([(x, 0.0), (x + 0.01, 0.02), (x + 0.01, -0.02), (x + 0.02, 0.0)])
        curves.append(BSpline(3, points, [0, 0, 0, 0, 1, 1, 1, 1]))
        curves.append(Line((x + 0.02, 0.0), (x + 0.03, 0.0)))
    return Path(curves)


def rounded() -> Path:
    """Return lines with blends at sharp corners, smaller than the distance of most points."""
    joints = 0.003 * np.cumsum(np.random.default_rng(4).normal(size=(40, 2)), axis=0)
    way = np.diff(joints, axis=0) / np.linalg.norm(np.diff(joints, axis=0), axis=1)[:, None]
    thirds = 1e-4 * np.arange(1.0, 4.0)[:, None]
    shapes = [[*(at - thirds * came)[::-1], *(at + thirds * goes)] for at, came, goes in zip(joints[1:-1], way, way[1:], strict=False)]
    made, curves = blends(quintic_bezier(shapes)), [Line(joints[0], shapes[0][0])]
    for i, shape in enumerate(shapes):
        curves += [blend for blend, owner in zip(*made, strict=True) if owner == i]
        curves.append(Line(shape[-1], shapes[i + 1][0] if i + 1 < len(shapes) else joints[-1]))
    return Path(curves)


PATHS = {
    "blends": rounded(),
    "plane": walk(2, False),
    "closed": walk(2, True),
    "space": walk(3, False),
    "closed in space": walk(3, True),
    "arcs": beads(),
    "splines and lines": wavy(),
}


def spread(path: Path, n: int = 400) -> tuple[Array, Array]:
    rng = np.random.default_rng(5)
    laps = 3.0 if path.closed else 1.0
    around = rng.uniform(-laps if path.closed else 0.0, laps, n) * path.length
    off = 0.004 * rng.normal(size=(n, path.n_axis)) * rng.uniform(0.0, 1.0, (n, 1)) ** 4
    return path.position(around) + off, around


def of_all_curves(path: Path, points: Array, around: Array, window: float) -> Array:
    """Return the distances (n,) of the points from the whole path within the window, each curve searched on its own."""
    least = np.full(around.size, np.inf)
    reach = min(window, 0.5 * path.length) if path.closed else window
    for lap in range(-4, 5) if path.closed else (0,):
        for curve, offset in zip(path.curves, lap * path.length + path.breaks[:-1], strict=True):
            low, high = (np.clip(end - offset, 0.0, curve.length) for end in (around - reach, around + reach))
            here = np.flatnonzero(high > low)
            if here.size:
                alone = Path([curve]).foot_point(points[here], 0.5 * (low + high)[here], 0.5 * (high - low)[here])
                least[here] = np.minimum(least[here], alone.distance)
    return least


@pytest.mark.parametrize("name", PATHS)
@pytest.mark.parametrize("part", [0.02, 0.3, 2.0])
def test_the_closest_point_is_that_of_all_curves(name: str, part: float) -> None:
    path = PATHS[name]
    points, around = spread(path)
    found = path.foot_point(points, around, part * path.length)
    np.testing.assert_allclose(found.distance, of_all_curves(path, points, around, part * path.length), rtol=0.0, atol=1e-12 * path.length)
    np.testing.assert_allclose(found.position, path.position(found.arc_length), rtol=0.0, atol=1e-12 * path.length)
    reach = min(part, 0.5) * path.length if path.closed else part * path.length
    assert (np.abs(found.arc_length - around) <= reach + 1e-12).all()


def driven(path: Path, n: int = 3000) -> tuple[Array, Array]:
    """Return a tool along a path: it stops, creeps, races and turns back, 10 um off or exactly on the path."""
    rng = np.random.default_rng(11)
    pace = 1e-5 * np.repeat(rng.choice([0.0, 0.02, 1.0, 1.0, 3.0, 30.0, -1.0], n // 50), 50)
    around = 0.3 * path.length + np.cumsum(pace)
    off = np.repeat(rng.choice([0.0, 1.0, 1.0], n // 50), 50)[:, None] * np.sin(0.02 * np.arange(n)[:, None] + np.arange(path.n_axis))
    return path.position(around) + 1e-5 * off, around


def retraced() -> Path:
    """Return lines there and back: some are as far from a point as others but for rounding, and those as far as others again."""
    i = np.arange(240)
    return polygon(np.column_stack([1e-3 * (i % 2), 3e-18 * np.random.default_rng(1).integers(0, 5, 240)]), False)


@pytest.mark.parametrize("name", [*PATHS, "retraced"])
def test_what_a_sample_finds_does_not_depend_on_those_before(name: str) -> None:
    path = retraced() if name == "retraced" else PATHS[name]
    points, around = driven(path)
    whole = path.foot_point(points, around, 5e-3)
    for start in (0, 7, 500, 1041, 2222):
        cut = path.foot_point(points[start : start + 600], around[start : start + 600], 5e-3)
        for values, same in zip(whole, cut, strict=True):
            np.testing.assert_array_equal(values[start : start + 600], same)
    alone = np.array([path.foot_point(points[i], around[i], 5e-3).arc_length[0] for i in range(0, 3000, 10)])
    np.testing.assert_allclose(whole.arc_length[::10], alone, rtol=0.0, atol=1e-12)


def searched_leaves(path: Path, points: Array, around: Array, window: float) -> float:
    """Return the mean number of curves that are searched for a point."""
    n = around.size
    room = FootPoint(np.empty(n), np.empty(points.shape), np.empty(n), np.empty(n))
    return searched(path, points, around, np.full(n, window), room) / n


def test_few_of_thousands_of_curves_remain() -> None:
    angle = np.linspace(0.0, 40.0 * np.pi, 20_000)
    path = polygon(0.05 * np.column_stack([np.cos(angle), np.sin(1.1 * angle)]), False)
    around = np.linspace(0.1, 0.9, 500) * path.length
    assert searched_leaves(path, path.position(around) + 1e-5, around, 0.2 * path.length) < 20.0


def test_from_the_centre_of_a_wheel_all_spokes_are_searched() -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, 1000, endpoint=False)
    path = polygon(0.05 * np.column_stack([np.cos(angle), np.sin(angle)]), True)
    assert searched_leaves(path, np.zeros((3, 2)), np.full(3, 0.1), 0.499 * path.length) >= 997


@pytest.mark.parametrize("kind", ["lines", "splines"])
def test_from_the_centre_of_a_wheel_the_progress_decides(kind: str) -> None:
    """Among hundreds of places at the same distance."""
    n = 300 if kind == "lines" else 60
    angle = np.linspace(0.0, 2.0 * np.pi, n, endpoint=False)
    rim = 0.05 * np.column_stack([np.cos(angle), np.sin(angle)])
    if kind == "lines":
        path = polygon(rim, True)
    else:
        middle = 0.05 / np.cos(np.pi / n) * np.column_stack([np.cos(angle + np.pi / n), np.sin(angle + np.pi / n)])
        parts = zip(rim, middle, np.roll(rim, -1, axis=0), strict=True)
        path = Path([BSpline(2, part, [0, 0, 0, 1, 1, 1]) for part in parts], closed=True)
    around = np.linspace(0.0, 1.0, 7) * path.length
    found = path.foot_point(np.zeros((7, 2)), around, 0.499 * path.length)
    assert np.abs(found.arc_length - around).max() <= path.length / n
    np.testing.assert_allclose(found.distance, 0.05, rtol=1e-4)


def test_the_middle_of_a_symmetric_blend_is_the_foot_of_its_corner() -> None:
    """There two pieces of the table meet, and the closest point lies on neither side for certain."""
    rng = np.random.default_rng(9)
    for _ in range(80):
        corner, turn, size = rng.uniform(-1.0, 1.0, 2), rng.uniform(0.05, 3.1), 10.0 ** rng.uniform(-7.0, -2.0)
        first = rng.uniform(0.0, 2.0 * np.pi)
        came, goes = ([np.cos(angle), np.sin(angle)] for angle in (first, first + turn))
        before, after = ([corner + sign * size * k / 3.0 * np.array(way) for k in (1, 2, 3)] for sign, way in ((-1.0, came), (1.0, goes)))
        blend = blends(quintic_bezier([[*before[::-1], *after]]))[0]
        path = Path([Line(before[2] - 0.01 * np.array(came), before[2]), *blend, Line(after[2], after[2] + 0.01 * np.array(goes))])
        middle = path.position(0.5 * path.length)[0]
        points = corner + (middle - corner) * rng.uniform(-3.0, 0.5, (20, 1))
        found = path.foot_point(points, np.full(20, 0.4 * path.length), path.length)
        np.testing.assert_allclose(found.distance, np.linalg.norm(points - middle, axis=1), rtol=1e-9, atol=1e-15)


def test_a_tiny_closed_path_has_a_foot_for_every_point() -> None:
    """The window of a search is wider than such a path by its slack."""
    for size in (1e-9, 1e-10, 1e-12):
        path = polygon(size * np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]), True)
        around = np.linspace(0.0, 1.0, 2000) * path.length
        assert path.foot_point(path.position(around), around, 0.02 * path.length).distance.max() < 1e-9


def test_rounding_of_a_long_way_hides_no_curve() -> None:
    path = Path([Line((0.0, 0.0), (1.0, 0.3))])
    far = 1e4 * np.where(np.arange(4000) % 2 == 0, 1.0, -1.0)[:, None] * [0.6, 0.8]
    points = np.vstack([far, 0.01 * np.random.default_rng(0).normal(size=(200, 2)).repeat(20, axis=0)])
    way = np.array([1.0, 0.3])
    ends = np.clip(points @ way / (way @ way), 0.0, 1.0)[:, None] * way
    found = path.foot_point(points, np.full(len(points), 0.3), path.length)
    np.testing.assert_allclose(found.distance, np.linalg.norm(points - ends, axis=1), rtol=1e-12, atol=1e-12)


def test_a_long_line_beside_a_hatch_searches_few_leaves() -> None:
    hatch = [(x, 0.1 + 1e-4 * row) for row in range(40) for x in np.linspace(0.0, 0.1, 200)[:: 1 - 2 * (row % 2)]]
    path = polygon(np.array([(-0.5, 0.0995), (0.3, 0.0995), *hatch]), False)
    for step in (1e-3, 1e-2, 0.1):
        around = np.abs((np.arange(2000) * step / 0.8 + 1.0) % 2.0 - 1.0) * 0.8
        assert searched_leaves(path, path.position(around) + 1e-5, around, path.length) < 3.0
