"""Quintic curves by arc length: lengths and places against adaptive quadrature and closed forms, single and in thousands."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import quad
from scipy.interpolate import BPoly

from contourlab.errors import GeometryError
from contourlab.geometry import Curve, Path
from contourlab.geometry.blend import Blend, Blends, blends, parameter, quintic_bezier

Array = NDArray[np.float64]


def corner(turn: float, b: float = 0.6, c: float = 0.3, size: float = 1e-3, place: float = 0.0) -> Array:
    """Control points (6, 2) of a blend between two lines that meet at an angle."""
    t, u = np.array([1.0, 0.0]), np.array([math.cos(turn), math.sin(turn)])
    return size * np.array([-t, -b * t, -c * t, c * u, b * u, u]) + place


def scattered(n: int, n_axis: int, seed: int = 1) -> Array:
    """Control points (n, 6, n_axis) that advance with random deviations."""
    rng = np.random.default_rng(seed)
    points = 0.1 * rng.normal(size=(n, 6, n_axis))
    points[:, :, 0] += np.arange(6)
    return 1e-3 * points


def length_by_quadrature(points: Array, low: float = 0.0, high: float = 1.0) -> float:
    """Return the length of a Bezier curve between two parameters, by another library's polynomials and adaptive quadrature."""
    slope = BPoly(points[:, None, :], [0.0, 1.0]).derivative()
    return float(quad(lambda u: float(np.linalg.norm(slope(u))), low, high, epsabs=0.0, epsrel=1e-13, limit=200)[0])


def test_coefficients_are_those_of_the_bezier_curve() -> None:
    points = scattered(4, 3)
    u = np.linspace(0.0, 1.0, 23)
    found = np.einsum("nkj,uk->nuj", quintic_bezier(points), u[:, None] ** np.arange(6))
    expected = [BPoly(p[:, None, :], [0.0, 1.0])(u) for p in points]
    np.testing.assert_allclose(found, expected, rtol=0, atol=2e-17)


@pytest.mark.parametrize("n_axis", [1, 2, 3])
def test_lengths_are_those_of_adaptive_quadrature(n_axis: int) -> None:
    points = scattered(12, n_axis)
    if n_axis == 1:
        points = np.sort(points, axis=1)  # on a line it must not turn back
    made, owner = blends(quintic_bezier(points))
    total = np.bincount(owner, [blend.length for blend in made])
    np.testing.assert_allclose(total, [length_by_quadrature(p) for p in points], rtol=1e-12)


def test_the_length_of_a_parabola_is_known() -> None:
    # (x, x^2) from 0 to a has the length (2 a w + asinh 2 a)/4 with w = sqrt(1 + 4 a^2); as powers of u: x = a u, y = a^2 u^2.
    for a in (0.1, 0.5, 1.0, 2.0):
        coefficients = np.zeros((6, 2))
        coefficients[1, 0], coefficients[2, 1] = a, a * a
        w = math.sqrt(1.0 + 4.0 * a * a)
        parabola = Path(blends([coefficients])[0])
        assert parabola.length == pytest.approx((2.0 * a * w + math.asinh(2.0 * a)) / 4.0, rel=1e-13)
        np.testing.assert_allclose(parabola.position([0.0, parabola.length]), [(0.0, 0.0), (a, a * a)], rtol=0, atol=2e-15)
        # Its curvature at the vertex is 2, at the end 2/w^3; the tangent there is (1, 2 a)/w.
        at = parabola.derivatives([0.0, parabola.length])
        np.testing.assert_allclose(at[1], [(1.0, 0.0), (1.0 / w, 2.0 * a / w)], rtol=0, atol=1e-12)
        np.testing.assert_allclose(np.linalg.norm(at[2], axis=1), [2.0, 2.0 / w**3], rtol=1e-10)


def test_arc_length_is_accurate_to_1e_12() -> None:
    corners = [corner(t, b, c, size) for t in (0.01, 1.0, 2.2, 2.9) for b, c in ((0.6, 0.3), (0.8, 0.5)) for size in (1e-6, 1.0)]
    points = np.concatenate([scattered(40, 2), 3.0 * scattered(40, 2, 2), corners])
    made, owner = blends(quintic_bezier(points))
    # Half of these are uneven enough to be divided, so the requested accuracy decides.
    assert 20 < np.count_nonzero(np.bincount(owner) > 1) < 80
    nodes, weights = np.polynomial.legendre.leggauss(20)
    for blend in made:
        s = blend.length * np.array([0.0, 1e-4, 0.06, 0.12, 0.2, 0.25, 0.33, 0.5, 0.62, 0.73, 0.97, 1.0 - 1e-6, 1.0])
        u = np.array([parameter(float(at), blend.borders, blend.inverse) for at in s])
        # The length up to u, by a rule of 20 points on each of 64 parts.
        border = u[:, None] * np.linspace(0.0, 1.0, 65)
        x = 0.5 * (border[:, 1:, None] + border[:, :-1, None] + np.diff(border, axis=1)[:, :, None] * nodes)
        slope = [np.polynomial.Polynomial(blend.coefficients[:, j]).deriv()(x) for j in range(2)]
        measured = (np.hypot(*slope) @ weights * 0.5 * np.diff(border, axis=1)).sum(axis=1)
        np.testing.assert_allclose(measured, s, rtol=0, atol=2e-12 * blend.length)
    total = np.bincount(owner, [blend.length for blend in made])
    np.testing.assert_allclose(total, [length_by_quadrature(p) for p in points], rtol=1e-12)


def test_derivatives_agree_with_differences() -> None:
    for blend in blends(quintic_bezier(scattered(5, 3)))[0]:
        s = np.linspace(0.1, 0.9, 9) * blend.length
        h = 1e-3 * blend.length
        at = [blend.derivatives(s + k * h) for k in (-2, -1, 1, 2)]
        exact = blend.derivatives(s)
        for order in range(3):
            # Fourth-order central differences: the error falls as h^4 and is far below the tolerance.
            slope = (at[0][order] - 8.0 * at[1][order] + 8.0 * at[2][order] - at[3][order]) / (12.0 * h)
            scale = np.abs(exact[order + 1]).max()
            np.testing.assert_allclose(slope, exact[order + 1], rtol=0, atol=1e-6 * scale)
        np.testing.assert_allclose(np.linalg.norm(exact[1], axis=1), 1.0, rtol=1e-14)


def test_thousands_at_once_equal_single_curves() -> None:
    points = scattered(200, 3)
    made, owner = blends(quintic_bezier(points))
    np.testing.assert_array_equal(np.unique(owner), np.arange(200))
    together = Blends(made)
    rng = np.random.default_rng(7)
    slot = rng.integers(0, len(made), 1000)
    along = rng.uniform(0.0, 1.0, 1000) * together.length[slot]
    found = together.derivatives(slot, along, 3)
    for i in range(0, 1000, 97):
        alone = Blend(made[slot[i]].coefficients)
        np.testing.assert_allclose(found[:, :, i], alone.derivatives(along[i])[:, 0], rtol=1e-11, atol=1e-12)


def test_sub_nanometre_accuracy_far_from_the_origin() -> None:
    # The shape is stored as differences: the blend's tangent and curvature do not depend on its position.
    near, far = (blends(quintic_bezier([corner(1.2, size=1e-6, place=place)]))[0][0] for place in (0.0, 1.0))
    assert far.length == pytest.approx(near.length, rel=1e-9)
    s = np.linspace(0.0, near.length, 11)
    np.testing.assert_allclose(far.derivatives(s, 1)[1], near.derivatives(s, 1)[1], rtol=0, atol=1e-8)
    np.testing.assert_allclose(far.position(s) - 1.0, near.position(s), rtol=0, atol=3e-16)


def test_an_uneven_curve_is_divided_and_its_parts_join_smoothly() -> None:
    sharp = corner(math.radians(179.9), 0.995, 0.99)
    made, owner = blends(quintic_bezier([corner(1.0), sharp, corner(0.5)]))
    assert np.bincount(owner).tolist()[0] == 1
    assert np.bincount(owner).tolist()[2] == 1
    parts = [blend for blend, i in zip(made, owner, strict=True) if i == 1]
    assert len(parts) > 1
    path = Path(parts)
    assert path.corners.size == 0
    assert path.length == pytest.approx(length_by_quadrature(sharp), rel=1e-12)
    for before, after in pairwise(parts):
        end, begin = before.derivatives(before.length)[:, 0], after.derivatives(0.0)[:, 0]
        np.testing.assert_allclose(end[0], begin[0], rtol=0, atol=1e-17)
        np.testing.assert_allclose(end[2], begin[2], rtol=1e-8)
    with pytest.raises(GeometryError, match="uneven"):
        Blend(quintic_bezier([sharp])[0])


@pytest.mark.parametrize(
    ("points", "said"),
    [
        (np.zeros((6, 2)), "blend 1 .*length"),
        (np.full((6, 2), math.nan), "blend 1 .*finite"),
        (np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 0.0), (-1.0, 0.0), (-1.0, 0.0), (1.0, 0.0)]), "blend 1 .*cusp"),
    ],
)
def test_an_invalid_curve_is_refused_with_its_number(points: Array, said: str) -> None:
    with pytest.raises(GeometryError, match=said):
        blends(np.stack([quintic_bezier([corner(1.0)])[0], quintic_bezier(points[None])[0]]))


def test_wrong_shapes_are_refused() -> None:
    with pytest.raises(GeometryError, match=r"\(5, 2\).*\(6, n_axis\)"):
        Blend(np.ones((5, 2)))
    with pytest.raises(GeometryError, match=r"\(6, 2\).*\(n, 6, n_axis\)"):
        blends(np.ones((6, 2)))
    assert blends(np.ones((0, 6, 2)))[0] == []


def test_the_smallest_radius_agrees_with_dense_samples() -> None:
    blend: Curve = Blend(quintic_bezier([corner(1.0)])[0])
    bend = np.linalg.norm(blend.derivatives(np.linspace(0.0, blend.length, 20001), 2)[2], axis=1).max()
    assert blend.smallest_radius() == pytest.approx(1.0 / bend, rel=2e-3)


def test_the_digest_distinguishes_blends() -> None:
    one, other = Blend(quintic_bezier([corner(1.0)])[0]), Blend(quintic_bezier([corner(1.0 + 1e-12)])[0])
    assert Path([one]).digest != Path([other]).digest
    assert Path([one]).digest == Path([Blend(one.coefficients)]).digest
