"""Paths of many curves: one call per kind of curve, with the same results as single curves."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import GeometryError
from contourlab.geometry import Arc, BSpline, Curve, Line, Path
from contourlab.geometry.blend import Blend, quintic_bezier

Array = NDArray[np.float64]


class Wave(Curve):
    """A kind of curve unknown to the path: a straight line that counts its evaluations."""

    n_axis = 2
    asked = 0
    calls = 0

    def __init__(self, start: float) -> None:
        self.begin, self.length = start, 1.0

    def derivatives(self, s: ArrayLike, order: int = 3) -> Array:
        along = np.atleast_1d(np.asarray(s, dtype=float))
        Wave.asked, Wave.calls = Wave.asked + along.size, Wave.calls + 1
        found = np.zeros((order + 1, along.size, 2))
        found[0, :, 0] = self.begin + along
        if order:
            found[1, :, 0] = 1.0
        return found

    def describe(self) -> tuple[object, ...]:
        return ("wave", self.begin)


def of_all_kinds(times: int = 3) -> Path:
    """Return line, arc, spline and blend, repeatedly, each beginning where the previous one ended."""
    curves: list[Curve] = []
    net = np.array([(0.03, 0.02), (0.02, 0.04), (0.0, 0.03), (-0.01, 0.05)])
    for at in np.outer(np.arange(times), (0.03, 0.12)):
        arc = Arc(at + np.array((0.03, 0.01)), 0.01, -math.pi / 2, math.pi)
        spline = BSpline(3, at + net, [0, 0, 0, 0, 1, 1, 1, 1])
        points = at + np.array([(-0.01, 0.05), (-0.02, 0.07), (-0.02, 0.09), (-0.01, 0.11), (0.01, 0.12), (0.03, 0.12)])
        curves += [Line(at, at + np.array((0.03, 0.0))), arc, spline, Blend(quintic_bezier([points])[0])]
    return Path(curves)


def test_a_path_agrees_with_its_curves() -> None:
    path = of_all_kinds()
    rng = np.random.default_rng(2)
    index = rng.integers(0, len(path.curves), 500)
    along = rng.uniform(0.0, 1.0, 500) * np.diff(path.breaks)[index]
    found = path.at(index, along, 3)
    for i in range(500):
        # A single curve adds up in another order.
        np.testing.assert_allclose(found[:, i], path.curves[index[i]].derivatives(along[i])[:, 0], rtol=1e-13, atol=1e-10)
        np.testing.assert_allclose(found[:2, i], path.curves[index[i]].derivatives(along[i], 1)[:, 0], rtol=1e-15, atol=1e-15)


def test_every_curve_is_of_one_kind_and_keeps_its_number() -> None:
    path = of_all_kinds()
    numbers = np.concatenate([curves for _, curves in path.kinds])
    np.testing.assert_array_equal(np.sort(numbers), np.arange(12))
    for each, curves in path.kinds:
        assert len({type(path.curves[i]) for i in curves}) == 1
        np.testing.assert_array_equal(each.length, [path.curves[i].length for i in curves])
    asked = np.array([5, 0, 5, 11, 3])
    seen = np.full(5, -1)
    for each, on, slot in path.kind_of(asked):
        assert (seen[on] == -1).all()
        seen[on] = [next(i for i, c in enumerate(path.curves) if c.describe() == each.curve(k).describe()) for k in slot]
    np.testing.assert_array_equal(seen, asked)


@pytest.mark.parametrize("n", [50, 100, 200, 400])
def test_a_kind_without_array_support_is_called_once_per_curve(n: int) -> None:
    path = Path([Wave(float(i)) for i in range(n)])
    Wave.asked = Wave.calls = 0
    s = np.random.default_rng(1).permutation(np.linspace(0.0, n, 10 * n, endpoint=False))
    np.testing.assert_array_equal(path.position(s)[:, 0], s)
    assert (Wave.asked, Wave.calls) == (10 * n, n)
    Wave.asked = Wave.calls = 0
    path.position([0.5, 3.5, 0.6])
    assert (Wave.asked, Wave.calls) == (3, 2)


def test_many_lines_equal_single_lines() -> None:
    points = np.random.default_rng(3).normal(size=(40, 3))
    many = Line.many(points[:-1], points[1:])
    for one, (a, b) in zip(many, pairwise(points), strict=True):
        alone = Line(a, b)
        assert one.describe() == alone.describe()
        assert one.length == pytest.approx(alone.length, rel=3e-16)
        np.testing.assert_allclose(one.direction, alone.direction, rtol=0, atol=3e-16)
    assert Line.many(np.zeros((0, 2)), np.zeros((0, 2))) == []


@pytest.mark.parametrize(
    ("end", "said"),
    [([(1.0, 0.0), (0.0, 0.0)], "zero length"), ([(1.0, 0.0), (math.inf, 0.0)], "finite coordinates"), ([(1.0, 0.0)], "shape")],
)
def test_many_lines_refuse_what_a_single_line_refuses(end: Any, said: str) -> None:
    with pytest.raises(GeometryError, match=said):
        Line.many([(0.0, 0.0), (0.0, 0.0)], end)


@pytest.mark.parametrize("rise", [0.0, 0.007])
def test_a_part_of_an_arc_lies_on_it(rise: float) -> None:
    arc = Arc((0.1, 0.2, 0.3), 0.02, 0.4, -5.0, rise=(0.0, 0.0, rise))
    part = arc.part(0.25 * arc.length, 0.7 * arc.length)
    assert part.length == pytest.approx(0.45 * arc.length, rel=1e-14)
    s = np.linspace(0.0, part.length, 31)
    for order, scale in enumerate((1.0, 1.0, 50.0, 2500.0)):
        np.testing.assert_allclose(part.derivatives(s)[order], arc.derivatives(0.25 * arc.length + s)[order], rtol=0, atol=1e-14 * scale)


def test_every_point_may_have_its_own_window() -> None:
    # Two strands 1 mm apart: a point near the second one finds it only if the window reaches that far.
    path = Path([Line((0.0, 0.0), (0.1, 0.0)), Line((0.1, 0.0), (0.1, 0.001)), Line((0.1, 0.001), (0.0, 0.001))])
    points = np.array([(0.05, 0.0009)] * 2)
    found = path.foot_point(points, [0.05, 0.05], [0.01, 0.2])
    np.testing.assert_allclose(found.distance, [0.0009, 0.0001], rtol=1e-12)
    np.testing.assert_allclose(found.arc_length, [0.05, 0.151], rtol=1e-12)
    for wrong in ([0.01], [0.01, 0.0], [0.01, math.nan], -1.0):
        with pytest.raises(GeometryError, match="window"):
            path.foot_point(points, [0.05, 0.05], wrong)


def test_a_micron_blend_between_metre_long_lines() -> None:
    t = 1e-6
    blend = Blend(
        quintic_bezier([np.array([(1.0 - t, 0), (1.0 - 0.6 * t, 0), (1.0 - 0.3 * t, 0), (1.0, 0.3 * t), (1.0, 0.6 * t), (1.0, t)])])[0]
    )
    path = Path([Line((0.0, 0.0), (1.0 - t, 0.0)), blend, Line((1.0, t), (1.0, 1.0))])
    table = path.table(1e-10)
    assert len(table.cell) < 10_000
    s = np.concatenate([np.linspace(0.0, path.length, 999), path.breaks[1] + np.linspace(0.0, blend.length, 500)])
    np.testing.assert_allclose(table.evaluate(s, 0)[0], path.position(s), rtol=0, atol=1.1e-10)
    # The foot of a point off the path, by a tenth of the smallest radius, is its origin.
    off = 0.1 * blend.smallest_radius()
    found = path.foot_point(path.position(s) + off * path.normal(s), s, 1e-3)
    np.testing.assert_allclose(found.signed, off, rtol=0, atol=1e-15)
    np.testing.assert_allclose(found.arc_length, s, rtol=0, atol=1e-11)
