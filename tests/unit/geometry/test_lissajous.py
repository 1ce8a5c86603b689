"""The Lissajous figure in any number of axes: its form and length, and all path functions in 2, 3 and 5 axes."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

from contourlab.feed import AxisLimits, limit_report, plan, route_from_path, uniform
from contourlab.geometry import Path, contour

AXES = (2, 3, 5)


def speed(u: float, axes: int, amplitude: float, lowest: int, phase: float) -> float:
    """|dr/du| of x_j = A sin((k + j) u + j phase), written out axis by axis."""
    return amplitude * math.sqrt(sum(((lowest + j) * math.cos((lowest + j) * u + j * phase)) ** 2 for j in range(axes)))


@pytest.mark.parametrize("axes", [*AXES, 9])
@pytest.mark.parametrize(("lowest", "phase"), [(1, math.pi / 3.0), (1, 0.0), (3, 2.0)])
def test_length_and_position_by_another_quadrature(axes: int, lowest: int, phase: float) -> None:
    path = contour("lissajous", axes=axes, amplitude=0.03, lowest=lowest, phase=phase)
    shape = (axes, 0.03, lowest, phase)

    def length(u: float) -> float:
        cuts = np.linspace(0.0, u, 33)
        return sum(quad(speed, a, b, shape, epsabs=0, epsrel=1e-13)[0] for a, b in pairwise(cuts))

    assert path.length == pytest.approx(length(2.0 * math.pi), rel=1e-12)
    for u in (0.3, 2.9, 6.0):
        wanted = [0.03 * math.sin((lowest + j) * u + j * phase) for j in range(axes)]
        np.testing.assert_allclose(path.position(length(u))[0], wanted, rtol=0, atol=1e-13)


@given(
    axes=st.integers(2, 9),
    lowest=st.integers(1, 6),
    phase=st.floats(-10.0, 10.0),
    place=st.floats(0.0, 1.0),
)
@pytest.mark.slow
def test_it_is_closed_smooth_and_by_arc_length(axes: int, lowest: int, phase: float, place: float) -> None:
    if abs(math.cos(lowest * phase)) < 0.1:
        return
    path = contour("lissajous", axes=axes, lowest=lowest, phase=phase)
    assert path.closed and path.n_axis == axes and path.corners.size == 0
    first, tangent, bend, _ = path.derivatives(np.array([0.0, path.length - 1e-12, place * path.length]))
    np.testing.assert_allclose(first[0], first[1], rtol=0, atol=2e-12)
    np.testing.assert_allclose(tangent[0], tangent[1], rtol=0, atol=1e-6)
    np.testing.assert_allclose(np.linalg.norm(tangent, axis=1), 1.0, rtol=0, atol=1e-13)
    # By arc length a curve's second derivative is normal to its tangent.
    np.testing.assert_allclose((tangent * bend).sum(axis=1), 0.0, rtol=0, atol=1e-9 * max(np.abs(bend).max(), 1.0))


def test_each_axis_makes_its_own_number_of_cycles() -> None:
    path = contour("lissajous", axes=5, lowest=2, phase=0.3)
    along = path.derivatives(np.linspace(0.0, path.length, 20_000, endpoint=False), 1)[1]
    turned = (np.signbit(along) != np.signbit(np.roll(along, 1, axis=0))).sum(axis=0)
    assert turned.tolist() == [4, 6, 8, 10, 12]


def test_two_axes_at_phase_zero_are_an_eight_of_known_area() -> None:
    # x = A sin u, y = A sin 2u: the right lobe encloses the integral of y dx from 0 to pi in magnitude, 4 A^2/3.
    path = contour("lissajous", axes=2, amplitude=0.02, phase=0)
    s = (np.arange(8000) + 0.5) / 8000 * 0.5 * path.length
    r, t = path.derivatives(s, 1)
    area = abs(np.mean(r[:, 1] * t[:, 0]) * 0.5 * path.length)
    assert area == pytest.approx(4.0 / 3.0 * 0.02**2, rel=1e-6)


@pytest.mark.parametrize("axes", AXES)
def test_foot_points_and_the_table(axes: int) -> None:
    path = contour("lissajous", axes=axes)
    s = np.linspace(0.0, path.length, 200, endpoint=False)
    rng = np.random.default_rng(axes)
    r, tangent = path.derivatives(s, 1)
    aside = rng.standard_normal(r.shape)
    aside -= (aside * tangent).sum(axis=1, keepdims=True) * tangent
    aside *= 50e-6 / np.linalg.norm(aside, axis=1, keepdims=True)
    found = path.foot_point(r + aside, s + 1e-3, np.full(len(s), 3e-3))
    np.testing.assert_allclose(found.distance, 50e-6, rtol=1e-9)
    np.testing.assert_allclose(found.position, r, rtol=0, atol=1e-11)
    assert np.isnan(found.signed).all() == (axes > 2)
    table = path.table(1e-10)
    np.testing.assert_allclose(table.evaluate(s)[0], r, rtol=0, atol=1e-10)


@pytest.mark.parametrize("axes", AXES)
def test_motion_along_it(axes: int) -> None:
    path = contour("lissajous", axes=axes, amplitude=0.01)
    laps = uniform(path, 0.5, 2, 1e-3)
    assert laps.n_axis == axes and laps.laps == ((0, 2000), (2000, 4000))
    once, again = laps.block(0, 2000), laps.block(2000, 4000)
    np.testing.assert_allclose(again.position, once.position, rtol=0, atol=1e-12)
    # Constant speed, so the motion of each axis is the derivative of its position.
    np.testing.assert_allclose(np.linalg.norm(once.velocity, axis=1), 0.5 * path.length, rtol=1e-12)
    within = AxisLimits(0.1, 1.0, 40.0)
    planned = plan(route_from_path(path, 0.05), within, 1e-3)
    assert limit_report(planned, within).ok()
    ends = planned.block(planned.n_sample - 1, planned.n_sample).position[0]
    np.testing.assert_allclose(ends, path.position(path.length)[0], rtol=0, atol=1e-12)


def test_equal_parameters_give_the_same_path() -> None:
    first: Path = contour("lissajous", axes=3)
    assert first.digest == contour("lissajous", axes=3, amplitude=0.02, lowest=1, phase=math.pi / 3.0).digest
    others = [contour("lissajous", **{name: value}) for name, value in (("axes", 4), ("lowest", 2), ("phase", 0.1), ("amplitude", 0.03))]
    assert len({path.digest for path in (first, *others)}) == 5
