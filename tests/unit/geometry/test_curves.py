"""Curves against their closed forms: points, derivatives by arc length, curvature, lengths."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from each import each
from numpy.typing import NDArray
from scipy.integrate import quad
from scipy.special import ellipe, gamma

from contourlab.errors import GeometryError
from contourlab.geometry import Arc, BSpline, Curve, Line, Nurbs, Path
from contourlab.geometry.parametric import Ellipse, Lemniscate, Parametric, Star

Array = NDArray[np.float64]
LEMNISCATE_CONSTANT = gamma(0.25) ** 2 / (2.0 * math.sqrt(2.0 * math.pi))


class Bernoulli(Parametric):
    """Bernoulli's lemniscate of half-width a, as a user would add it; `first` and `last` select a part."""

    n_axis = 2

    def __init__(self, a: float) -> None:
        self.a, self.first, self.last = a, 0.0, 2.0 * math.pi
        self.measure()

    def raw(self, u: Array, order: int) -> Array:
        # z(u) = a cos u / (1 + i sin u) in the complex plane; its derivatives by the quotient rule.
        num = [np.cos(u), -np.sin(u), -np.cos(u), np.sin(u)]
        den = [1.0 + 1j * np.sin(u), 1j * np.cos(u), -1j * np.sin(u), -1j * np.cos(u)]
        z: list[NDArray[np.complex128]] = []
        for k in range(order + 1):
            z.append((num[k] - sum(math.comb(k, i) * den[i] * z[k - i] for i in range(1, k + 1))) / den[0])
        return self.a * np.array([np.column_stack([row.real, row.imag]) for row in z])

    def describe(self) -> tuple[object, ...]:
        return ("bernoulli", self.a)


CURVES: dict[str, Callable[[], Curve]] = {
    "line": lambda: Line((0.1, -0.2), (0.4, 0.2)),
    "line in space": lambda: Line((0.0, 0.0, 1.0), (1.0, 2.0, 3.0)),
    "arc": lambda: Arc((0.01, 0.02), 0.03, 0.4, 2.0),
    "clockwise arc": lambda: Arc((0.01, 0.02), 0.03, 0.4, -7.0),
    "helix": lambda: Arc((0.0, 0.0, 0.1), 0.02, 0.3, 9.0, rise=(0.0, 0.0, -0.05)),
    "ellipse": lambda: Ellipse(0.04, 0.02),
    "thin ellipse": lambda: Ellipse(0.01, 0.05),
    "lemniscate": lambda: Lemniscate(0.04),
    "star": lambda: Star(0.03, 5, 0.3),
    "bspline": lambda: BSpline(4, [(0, 0), (1, 2), (3, 1), (4, -1), (6, 0), (7, 3)], [0, 0, 0, 0, 0, 1.5, 2, 2, 2, 2, 2]),
    "nurbs in space": lambda: Nurbs(
        3, [(0, 0, 0), (1, 2, 1), (3, 1, -1), (4, -1, 0), (5, 0, 2)], [0, 0, 0, 0, 0.6, 1, 1, 1, 1], [1, 2, 0.5, 3, 1]
    ),
    "stranger's": lambda: Bernoulli(0.05),
}


@pytest.fixture(params=CURVES, ids=str)
def curve(request: pytest.FixtureRequest) -> Curve:
    return CURVES[request.param]()


def test_every_curve_has_unit_speed_by_arc_length(curve: Curve) -> None:
    s = np.linspace(0.0, curve.length, 501)
    _, first, second, third = curve.derivatives(s)
    np.testing.assert_allclose(np.linalg.norm(first, axis=1), 1.0, rtol=0, atol=4e-14)
    # Derivatives of |r'|^2 = 1: r'.r'' = 0 and r'.r''' = -|r''|^2.
    bend = np.linalg.norm(second, axis=1)
    np.testing.assert_allclose(np.einsum("ij,ij->i", first, second), 0.0, atol=1e-12 * max(bend.max(), 1e-9))
    size = np.linalg.norm(third, axis=1).max() + 1e-9
    np.testing.assert_allclose(np.einsum("ij,ij->i", first, third), -(bend**2), rtol=0, atol=1e-11 * size)


def test_the_length_is_the_extrapolated_sum_of_many_chords(curve: Curve) -> None:
    chords = []
    for n in (2000, 4000, 8000):
        points = curve.position(np.linspace(0.0, curve.length, n + 1))
        chords.append(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    # The sum is too short by c/n^2 + d/n^4: Romberg's table has three rows.
    once = [(4.0 * b - a) / 3.0 for a, b in ((chords[0], chords[1]), (chords[1], chords[2]))]
    assert (16.0 * once[1] - once[0]) / 15.0 == pytest.approx(curve.length, rel=1e-11)


def test_all_orders_agree_and_scalars_are_accepted(curve: Curve) -> None:
    s = np.linspace(0.0, curve.length, 17)
    whole = curve.derivatives(s, 3)
    assert whole.shape == (4, 17, curve.n_axis)
    for order in range(3):
        np.testing.assert_allclose(curve.derivatives(s, order), whole[: order + 1], rtol=1e-13, atol=1e-15)
    np.testing.assert_array_equal(curve.position(0.3 * curve.length), curve.position([0.3 * curve.length]))


def test_a_path_of_one_curve_is_that_curve(curve: Curve) -> None:
    s = np.linspace(0.0, curve.length, 33)
    np.testing.assert_allclose(Path([curve]).derivatives(s), curve.derivatives(s), rtol=1e-14, atol=1e-15)


def test_a_line() -> None:
    line = Line((1.0, 2.0), (4.0, 6.0))
    assert line.length == 5.0
    np.testing.assert_allclose(
        line.derivatives([0.0, 2.5, 5.0]), [[(1, 2), (2.5, 4), (4, 6)], [(0.6, 0.8)] * 3, [(0, 0)] * 3, [(0, 0)] * 3]
    )


@pytest.mark.parametrize("sweep", [1.3, -1.3, 11.0])
def test_an_arc(sweep: float) -> None:
    arc = Arc((0.2, -0.1), 0.5, 0.7, sweep)
    assert arc.length == pytest.approx(0.5 * abs(sweep), rel=1e-15)
    angle = 0.7 + sweep * np.linspace(0.0, 1.0, 9)
    spoke = np.column_stack([np.cos(angle), np.sin(angle)])
    s = np.linspace(0.0, arc.length, 9)
    np.testing.assert_allclose(arc.position(s), np.array([0.2, -0.1]) + 0.5 * spoke, rtol=0, atol=1e-14)
    path = Path([arc])
    np.testing.assert_allclose(path.curvature(s), math.copysign(2.0, sweep), rtol=1e-13)
    np.testing.assert_allclose(path.curvature_derivative(s), 0.0, atol=1e-13)
    np.testing.assert_allclose(path.normal(s), -spoke * math.copysign(1.0, sweep), rtol=0, atol=1e-14)


def test_a_helix() -> None:
    radius, sweep, rise = 0.02, 4.0 * math.pi, 0.03
    helix = Arc((0.0, 0.0, 0.0), radius, 0.0, sweep, rise=(0.0, 0.0, rise))
    assert helix.length == pytest.approx(math.hypot(radius * sweep, rise), rel=1e-15)
    path, s = Path([helix]), np.linspace(0.0, helix.length, 25)
    pitch = rise / sweep
    np.testing.assert_allclose(path.curvature(s), radius / (radius**2 + pitch**2), rtol=1e-12)
    assert path.curves[0].smallest_radius() == pytest.approx((radius**2 + pitch**2) / radius, rel=1e-13)
    _, t, n, d = path.derivatives(s)
    torsion = np.einsum("ij,ij->i", np.cross(t, n), d) / np.einsum("ij,ij->i", n, n)
    np.testing.assert_allclose(torsion, pitch / (radius**2 + pitch**2), rtol=1e-11)
    np.testing.assert_allclose(path.position([0.0, helix.length])[:, 2], [0.0, rise], atol=1e-16)
    np.testing.assert_allclose(path.curvature_derivative(s), 0.0, atol=1e-9)


def test_an_arc_lies_in_the_plane_of_its_axes() -> None:
    u, v = np.array([0.0, 0.6, 0.8]), np.array([1.0, 0.0, 0.0])
    arc = Arc((1.0, 2.0, 3.0), 2.0, 0.0, math.pi / 2, u=u, v=v)
    np.testing.assert_allclose(arc.position([0.0, arc.length]), [np.array([1, 2, 3]) + 2 * u, np.array([1, 2, 3]) + 2 * v], atol=1e-15)


@pytest.mark.parametrize("sweep", [math.pi / 2, -3 * math.pi / 2, 5 * math.pi / 2])
def test_an_arc_through_rounded_ends_joins_them_exactly(sweep: float) -> None:
    start, end, centre = np.array([0.0201237, 0.01]), np.array([0.0100002, 0.0200999]), (0.01, 0.01)
    arc = Arc.through(start, end, centre, sweep)
    np.testing.assert_allclose(arc.position([0.0, arc.length]), [start, end], rtol=0, atol=1e-15)
    assert arc.sweep == pytest.approx(sweep, abs=0.01)
    # The centre moves by no more than the difference of the two radii over the sine of half a right angle.
    gap = abs(np.linalg.norm(start - centre) - np.linalg.norm(end - centre))
    assert np.linalg.norm(arc.centre - centre) < 2.0 * gap


def test_a_full_circle_and_a_helix_through_points() -> None:
    circle = Arc.through((0.03, 0.0), (0.03, 0.0), (0.01, 0.0), -2.0 * math.pi)
    assert circle.length == pytest.approx(2.0 * math.pi * 0.02, rel=1e-15)
    np.testing.assert_allclose(circle.position(circle.length / 4), [(0.01, -0.02)], atol=1e-16)
    helix = Arc.through((0.03, 0.0, 0.001), (0.03, 0.0, 0.005), (0.01, 0.0, 0.001), 6.0 * math.pi)
    assert helix.length == pytest.approx(math.hypot(6.0 * math.pi * 0.02, 0.004), rel=1e-14)
    np.testing.assert_allclose(helix.position([0.0, helix.length]), [(0.03, 0.0, 0.001), (0.03, 0.0, 0.005)], atol=1e-15)


@pytest.mark.parametrize("end", [(0.0200004, 0.0), (0.0200004, 1e-7), (0.0199, -1e-5)])
def test_a_circle_that_misses_its_start_is_refused_and_not_changed(end: tuple[float, float]) -> None:
    # The only circles through both ends have centres far from the given one.
    with pytest.raises(GeometryError, match=r"-360 degrees.*0\.02"):
        Arc.through((0.02, 0.0), end, (0.01, 0.0), -2.0 * math.pi)
    # Ends slightly apart along the circle are fine: their radii are equal.
    angle = 1e-5
    near = (0.01 + 0.01 * math.cos(angle), 0.01 * math.sin(angle))
    arc = Arc.through((0.02, 0.0), near, (0.01, 0.0), -2.0 * math.pi)
    assert arc.length == pytest.approx(0.01 * (2.0 * math.pi - angle), rel=1e-9)
    # So is an end that is rounded to four decimals of an inch.
    inch = Arc.through((0.0254, 2.54e-6), (0.0254, 0.0), (0.0, 0.0), -2.0 * math.pi - 1e-4)
    np.testing.assert_allclose(inch.position([0.0, inch.length]), [(0.0254, 2.54e-6), (0.0254, 0.0)], rtol=0, atol=1e-15)
    assert inch.length == pytest.approx(0.0254 * (2.0 * math.pi + 1e-4), rel=1e-4)
    assert np.linalg.norm(inch.centre) < 2.54e-6


@pytest.mark.parametrize(("a", "b"), [(0.04, 0.02), (0.02, 0.04), (1.0, 1.0), (1.0, 1e-3), (3e-6, 1e-6), (40.0, 7.0)])
def test_an_ellipse_against_the_elliptic_integral(a: float, b: float) -> None:
    ellipse, big = Ellipse(a, b), max(a, b)
    assert ellipse.length == pytest.approx(4.0 * big * ellipe(1.0 - (min(a, b) / big) ** 2), rel=1e-13)
    np.testing.assert_allclose(
        ellipse.position(np.array([0, 0.25, 0.5, 0.75]) * ellipse.length), [(a, 0), (0, b), (-a, 0), (0, -b)], rtol=0, atol=1e-13 * big
    )


def test_the_curvature_of_an_ellipse_follows_the_textbook() -> None:
    a, b = 0.04, 0.02
    ellipse = Ellipse(a, b)
    path, s = Path([ellipse], closed=True), np.linspace(0.0, ellipse.length, 97)
    x, y = path.position(s).T
    np.testing.assert_allclose((x / a) ** 2 + (y / b) ** 2, 1.0, rtol=0, atol=1e-14)
    # With g = (b cos u)^2 + (a sin u)^2: kappa = ab / g^(3/2), dkappa/ds = -3 ab (a^2 - b^2) sin u cos u / g^3.
    g = (b * x / a) ** 2 + (a * y / b) ** 2
    np.testing.assert_allclose(path.curvature(s), a * b / g**1.5, rtol=1e-12)
    slope = -3.0 * a * b * (a**2 - b**2) * (x / a) * (y / b) / g**3
    np.testing.assert_allclose(path.curvature_derivative(s), slope, rtol=0, atol=1e-11 * np.abs(slope).max())
    # The centres of curvature lie on the evolute, (a x)^(2/3) + (b y)^(2/3) = (a^2 - b^2)^(2/3).
    centre = path.position(s) + path.normal(s) / path.curvature(s)[:, None]
    astroid = np.cbrt(a * centre[:, 0]) ** 2 + np.cbrt(b * centre[:, 1]) ** 2
    np.testing.assert_allclose(astroid, np.cbrt(a**2 - b**2) ** 2, rtol=1e-9)


def test_the_lemniscate_of_gerono() -> None:
    a = 0.04
    curve = Lemniscate(a)
    length, _ = quad(lambda u: math.hypot(math.cos(u), math.cos(2.0 * u)), 0.0, math.pi / 2, epsabs=0, epsrel=1e-13)
    assert curve.length == pytest.approx(4.0 * a * length, rel=1e-13)
    path, s = Path([curve], closed=True), np.linspace(0.0, curve.length, 101)
    x, y = path.position(s).T
    np.testing.assert_allclose(x**4, (x**2 - y**2) * a**2, rtol=0, atol=1e-14 * a**4)
    # It passes the origin at both ends and half-way, at +-45 degrees; there it is straight.
    at = np.array([0.0, 0.5, 1.0]) * curve.length
    np.testing.assert_allclose(path.position(at), 0.0, atol=1e-15)
    root = math.sqrt(0.5)
    np.testing.assert_allclose(path.tangent(at[:2]), [(root, root), (-root, root)], atol=1e-13)
    np.testing.assert_allclose(path.curvature(at), 0.0, atol=1e-9)


def test_the_lemniscate_of_bernoulli_has_the_length_of_its_constant() -> None:
    assert pytest.approx(2.622057554292119, rel=1e-15) == LEMNISCATE_CONSTANT
    a = 0.05
    curve = Bernoulli(a)
    assert curve.length == pytest.approx(2.0 * a * LEMNISCATE_CONSTANT, rel=1e-13)
    # Its curvature is 3 rho / a^2, where rho is the distance from the origin.
    s = np.linspace(0.0, curve.length, 101)
    path = Path([curve], closed=True)
    np.testing.assert_allclose(np.abs(path.curvature(s)), 3.0 * np.linalg.norm(path.position(s), axis=1) / a**2, rtol=0, atol=1e-9)


def test_a_star() -> None:
    radius, lobes, depth = 0.03, 5, 0.3
    curve = Star(radius, lobes, depth)
    x, y = curve.position(np.linspace(0.0, curve.length, 203)).T
    angle = np.arctan2(y, x)
    np.testing.assert_allclose(np.hypot(x, y), radius * (1.0 + depth * np.cos(lobes * angle)), rtol=1e-12)

    def speed(u: float) -> float:
        return math.hypot(1.0 + depth * math.cos(lobes * u), depth * lobes * math.sin(lobes * u))

    part, _ = quad(speed, 0.0, math.pi / lobes, epsabs=0, epsrel=1e-13)
    assert curve.length == pytest.approx(2.0 * lobes * radius * part, rel=1e-13)
    # A polar curve: kappa = (rho^2 + 2 rho'^2 - rho rho'') / (rho^2 + rho'^2)^(3/2); sharpest in the valleys.
    deep, bend = 1.0 - depth, depth * lobes**2
    at_valley = (deep**2 - deep * bend) / deep**3 / radius
    assert Path([curve]).curvature(curve.length / (2 * lobes))[0] == pytest.approx(at_valley, rel=1e-11)
    assert curve.smallest_radius() == pytest.approx(1.0 / abs(at_valley), rel=1e-3)


NAN, INF = math.nan, math.inf


@each(
    "make, message",
    [
        (lambda: Line((1.0, 2.0), (1.0, 2.0)), r"zero length.*\[1\.0, 2\.0\]"),
        (lambda: Line((1.0, NAN), (1.0, 2.0)), "start = .*finite"),
        (lambda: Line((1.0, 0.0), (INF, 2.0)), "end = .*finite"),
        (lambda: Line((1.0, 0.0), (1.0, 2.0, 3.0)), "start has 2.*end has 3"),
        (lambda: Line("ab", (1.0, 2.0)), "start = 'ab'"),
        (lambda: Arc((0, 0), 0.0, 0, 1), r"radius = 0.0: must be > 0"),
        (lambda: Arc((0, 0), NAN, 0, 1), r"radius = nan: must be > 0"),
        (lambda: Arc((0, 0), 1.0, 0, 0.0), r"sweep = 0\.0: "),
        (lambda: Arc((0, 0), 1.0, NAN, 1.0), "start_angle = nan: "),
        (lambda: Arc((0, NAN), 1.0, 0.0, 1.0), r"centre = .*finite"),
        (lambda: Arc((0,), 1.0, 0.0, 1.0), "coordinates"),
        (lambda: Arc((0, 0, 0), 1.0, 0.0, 1.0, u=(1, 0), v=(0, 1)), r"u has 2.*centre has 3"),
        (lambda: Arc((0, 0), 1.0, 0.0, 1.0, u=(1.0 + 1e-6, 0), v=(0, 1)), r"orthonormal"),
        (lambda: Arc((0, 0, 0), 1.0, 0.0, 1.0, rise=(0, 1e-3, 1)), "rise"),
        (lambda: Ellipse(-1.0, 1.0), r"a = -1.0: must be > 0"),
        (lambda: Ellipse(1.0, NAN), r"b = nan: must be > 0"),
        (lambda: Lemniscate(0.0), r"a = 0.0: must be > 0"),
        (lambda: Star(1.0, 2.5, 0.1), r"2.5 lobes.*whole number"),
        (lambda: Star(1.0, NAN, 0.1), r"whole number"),
        (lambda: Star(1.0, 5, 1.0), r"depth from 0 to below 1"),
        (lambda: Star(INF, 5, 0.5), r"radius = inf"),
    ],
)
def test_invalid_curves_are_refused_with_a_reason(make: Callable[[], Curve], message: str) -> None:
    with pytest.raises(GeometryError, match=message):
        make()
