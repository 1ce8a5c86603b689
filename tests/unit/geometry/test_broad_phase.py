"""Candidate curves for the closest point: fewer than all in the window, and always including the right one."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from numpy.typing import NDArray

from contourlab.geometry import Arc, BSpline, Curve, Line, Path
from contourlab.geometry.foot_point import curves_in_reach

Array = NDArray[np.float64]


def polygon(points: Array, closed: bool) -> Path:
    joints = [*points, points[0]] if closed else points
    return Path([Line(tuple(a), tuple(b)) for a, b in pairwise(joints)], closed=closed)


def walk(n_axis: int, closed: bool, n: int = 300) -> Path:
    rng = np.random.default_rng(n_axis + 10 * closed)
    return polygon(0.003 * np.cumsum(rng.normal(size=(n, n_axis)), axis=0), closed)


def beads() -> Path:
    """Return consecutive half circles, left and right: segments far longer than wide."""
    return Path([Arc((0.002 * i, 0.0), 0.001, np.pi, np.pi * (-1) ** i) for i in range(80)])


def wavy() -> Path:
    """Return splines with lines between, each curve as long as ten of the walk's."""
    curves: list[Curve] = []
    for i in range(20):
        x = 0.03 * i
        points = np.array([(x, 0.0), (x + 0.01, 0.02), (x + 0.01, -0.02), (x + 0.02, 0.0)])
        curves.append(BSpline(3, points, [0, 0, 0, 0, 1, 1, 1, 1]))
        curves.append(Line((x + 0.02, 0.0), (x + 0.03, 0.0)))
    return Path(curves)


PATHS = {
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


@pytest.mark.parametrize("name", PATHS)
@pytest.mark.parametrize("part", [0.02, 0.3, 2.0])
def test_the_closest_point_is_that_of_all_curves(name: str, part: float, monkeypatch: pytest.MonkeyPatch) -> None:
    path = PATHS[name]
    points, around = spread(path)
    monkeypatch.setattr("contourlab.geometry.foot_point._FEW", np.inf)
    wanted = path.foot_point(points, around, part * path.length)
    monkeypatch.setattr("contourlab.geometry.foot_point._FEW", 0)
    found = path.foot_point(points, around, part * path.length)
    for one, other in zip(found, wanted, strict=True):
        np.testing.assert_allclose(one, other, rtol=0.0, atol=1e-12 * path.length)


@pytest.mark.parametrize("name", PATHS)
def test_pairs_are_in_the_order_of_the_path_and_within_the_window(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    path = PATHS[name]
    points, around = spread(path)
    monkeypatch.setattr("contourlab.geometry.foot_point._FEW", 0)
    window = np.full(around.size, 0.3 * path.length)
    sample, curve, lap, low, high = curves_in_reach(path, points, around, window)
    assert np.array_equal(np.unique(sample), np.arange(around.size))
    along = lap * len(path.curves) + curve
    same = np.diff(sample) == 0
    assert (np.diff(sample) >= 0).all() and (np.diff(along)[same] > 0).all()
    offset = lap * path.length + path.breaks[curve]
    first, last = offset + low - around[sample], offset + high - around[sample]
    assert (first >= -window[sample] - 1e-12).all() and (last <= window[sample] + 1e-12).all()


def test_few_of_thousands_of_curves_remain() -> None:
    angle = np.linspace(0.0, 40.0 * np.pi, 20_000)
    path = polygon(0.05 * np.column_stack([np.cos(angle), np.sin(1.1 * angle)]), False)
    around = np.linspace(0.1, 0.9, 500) * path.length
    points = path.position(around) + 1e-5
    sample, *_ = curves_in_reach(path, points, around, np.full(500, 0.2 * path.length))
    assert np.bincount(sample).mean() < 10.0


def test_from_the_centre_of_a_wheel_all_spokes_are_kept() -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, 1000, endpoint=False)
    path = polygon(0.05 * np.column_stack([np.cos(angle), np.sin(angle)]), True)
    sample, curve, *_ = curves_in_reach(path, np.zeros((3, 2)), np.full(3, 0.1), np.full(3, 0.499 * path.length))
    assert len(np.unique(curve[sample == 1])) >= 997
