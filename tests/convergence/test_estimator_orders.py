"""Convergence orders of the Newton contour-error estimator. Each point is built from its foot point, so the exact answer is known."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from contourlab.components.estimator.newton import Newton
from contourlab.engine.step import record
from contourlab.geometry import Line, Path, contour
from contourlab.geometry.foot_point import foot_point
from contourlab.geometry.view import PathView, view_of
from contourlab.primitives import Clock

Array = NDArray[np.float64]
FOOT, INPUTS = record(("foot",)), record(("position", "arc_length"))


def estimates(view: PathView, points: Array, starts: Array, **parameters: Any) -> tuple[Array, Array]:
    """Return estimate (n,) and foot point (n,) after one tick; each point (n, n_axis) has its own start on the path."""
    part = Newton(**{"start": "warm", "window": 1.0, **parameters})
    step = part.path_step(view, points.shape[1])
    tables = {name: np.ravel(table).tolist() for name, table in view.tables.items()}
    par = step.par_type(**part.block(1e-3), **view.parameters, **tables)
    found = [
        step.function(par, FOOT(start), INPUTS(tuple(point), start), Clock(0.0, 0.0, 1e-3))[1]
        for point, start in zip(points.tolist(), starts.tolist(), strict=True)
    ]
    return np.array([out[2] for out in found]), np.array([out[3] for out in found])


def slope(lags: Array, errors: list[float]) -> float:
    """Return the exponent with which the error grows with the lag."""
    return float(np.polyfit(np.log(lags), np.log(errors), 1)[0])


# --- an ellipse by its angle: the figures of the brief -------------------------------------------------------------------------------

A, B = 0.04, 0.02


def on_ellipse(par: Any, t: float) -> Any:
    """Evaluate an ellipse by its angle. Its speed is uneven: Newton's method does not need a path by arc length."""
    c, s = math.cos(t), math.sin(t)
    return (A * c, B * s), (-A * s, B * c), (-A * c, -B * s)


def angle_ahead(t: Array, lag: float, n: int = 100) -> Array:
    """Return the angles that lie an arc length ahead (Runge-Kutta on dt/ds = 1/|r'|)."""
    h = lag / n

    def rate(at: Array) -> Array:
        return 1.0 / np.hypot(A * np.sin(at), B * np.cos(at))

    for _ in range(n):
        k1 = rate(t)
        k2 = rate(t + 0.5 * h * k1)
        k3 = rate(t + 0.5 * h * k2)
        t = t + h / 6.0 * (k1 + 2.0 * (k2 + k3) + rate(t + h * k3))
    return t


def left_of_ellipse(t: Array, error: float) -> Array:
    """Return points at a distance to the left of an ellipse, with foot points at the given angles."""
    slopes = np.column_stack([-A * np.sin(t), B * np.cos(t)])
    normal = np.column_stack([-slopes[:, 1], slopes[:, 0]]) / np.hypot(*slopes.T)[:, None]
    return np.column_stack([A * np.cos(t), B * np.sin(t)]) + error * normal


@pytest.mark.parametrize(("iterations", "largest"), [(1, 7.8e-8), (2, 4.0e-13)])
def test_largest_error_on_an_ellipse_of_40_by_20_mm(iterations: int, largest: float) -> None:
    """20 um off an ellipse with half axes of 40 and 20 mm, 1 mm behind: 7.8e-5 and 4e-10 mm after one and two iterations."""
    t = np.linspace(0.0, 2.0 * math.pi, 1500, endpoint=False)
    found, _ = estimates(PathView(on_ellipse, {}, {}), left_of_ellipse(t, 20e-6), angle_ahead(t, 1e-3), iterations=iterations)
    assert np.abs(found - 20e-6).max() == pytest.approx(largest, rel=0.02)


def test_three_iterations_reach_the_last_digits() -> None:
    t = np.linspace(0.0, 2.0 * math.pi, 1500, endpoint=False)
    found, _ = estimates(PathView(on_ellipse, {}, {}), left_of_ellipse(t, 20e-6), angle_ahead(t, 1e-3), iterations=3)
    # Coordinates of 0.04 m are rounded to 7e-18 m; a difference adds up a few roundings.
    assert np.abs(found - 20e-6).max() < 3e-17


@pytest.mark.parametrize(("iterations", "low", "order"), [(1, 0.1e-3, 4.0), (2, 0.5e-3, 8.0)])
def test_each_iteration_squares_the_foot_error(iterations: int, low: float, order: float) -> None:
    """Newton's method and the projection at the foot point both have order two: the error grows as the lag to the power 2^(n + 1)."""
    t = np.linspace(0.1, 1.4, 40)
    lags = np.geomspace(low, 2.0 * low, 4)
    errors = []
    for lag in lags:
        found, _ = estimates(PathView(on_ellipse, {}, {}), left_of_ellipse(t, 20e-6), angle_ahead(t, float(lag)), iterations=iterations)
        errors.append(float(np.abs(found - 20e-6).max()))
    assert slope(lags, errors) == pytest.approx(order, rel=0.03)


# --- by arc length -------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("iterations", [1, 2, 3])
@pytest.mark.parametrize("error", [0.0, 2e-3, -2e-3])
def test_on_a_circle_the_foot_error_is_known(iterations: int, error: float) -> None:
    """An iteration maps the angle phi to phi - tan(phi) at any distance; the projection leaves (rho - eps)(1 - cos phi)."""
    radius, lags = 0.02, np.array([2e-3, 5e-3, 8e-3])
    circle = contour("circle", radius=radius)
    foot = np.full(3, 0.013)
    points = circle.position(foot) + error * circle.normal(foot)
    found, feet = estimates(view_of(circle), points, foot + lags, iterations=iterations)
    angle = lags / radius
    for _ in range(iterations):
        angle = angle - np.tan(angle)
    assert feet - foot == pytest.approx(radius * angle, rel=1e-9, abs=1e-17)
    assert found - error == pytest.approx((radius - error) * (1.0 - np.cos(angle)), rel=1e-6, abs=3e-17)


@pytest.mark.parametrize(("iterations", "low", "high", "order"), [(1, 0.5e-3, 4e-3, 6.0), (2, 6e-3, 10e-3, 18.0)])
def test_orders_on_a_circle(iterations: int, low: float, high: float, order: float) -> None:
    """By arc length, Newton's method has order three for points on the path: L^3/(3 rho^2) in the foot, so L^6 and L^18 in the error."""
    radius = 0.02
    circle = contour("circle", radius=radius)
    lags = np.geomspace(low, high, 5)
    foot = np.full(5, 0.05)
    found, feet = estimates(view_of(circle), circle.position(foot), foot + lags, iterations=iterations)
    assert slope(lags, np.abs(found).tolist()) == pytest.approx(order, rel=0.05)
    if iterations == 1:
        assert slope(lags, np.abs(feet - foot).tolist()) == pytest.approx(3.0, abs=0.05)
        assert abs(feet[0] - foot[0]) == pytest.approx(low**3 / (3.0 * radius**2), rel=1e-3)


@pytest.mark.parametrize("error", [0.0, 20e-6, -20e-6])
def test_an_ellipse_by_arc_length_has_the_circles_leading_error(error: float) -> None:
    """At the sharpest place, rho = b^2/a = 10 mm: foot error L^3/(3 rho^2) = 3.3 um at 1 mm, contour error its square over 2 rho."""
    path = contour("ellipse", a=A, b=B)
    view = view_of(path, tolerance=1e-13, pieces=2048)
    foot = np.linspace(0.0, path.length, 200, endpoint=False)
    points = path.position(foot) + error * path.normal(foot)
    found, feet = estimates(view, points, foot + 1e-3, iterations=1)
    rho = B * B / A
    assert np.abs(feet - foot).max() == pytest.approx(1e-9 / (3.0 * rho**2), rel=0.01)
    assert np.abs(found - error).max() == pytest.approx((1e-9 / (3.0 * rho**2)) ** 2 / (2.0 * rho), rel=0.01)
    twice, _ = estimates(view, points, foot + 1e-3, iterations=2)
    assert np.abs(twice - error).max() < 3e-17


@pytest.mark.parametrize("name", ["ellipse", "lemniscate"])
def test_three_iterations_agree_with_the_exact_foot_point(name: str) -> None:
    """The judge's search and the estimator share no code. Points lie on both sides of the path, starts ahead and behind."""
    path = contour(name)
    rng = np.random.default_rng(5)
    around = rng.uniform(0.0, path.length, 150)
    points = path.position(around) + 50e-6 * rng.standard_normal((150, 2))
    exact = foot_point(path, points, around, 2e-3)
    found, feet = estimates(view_of(path, tolerance=1e-13), points, around + rng.choice([-1e-3, 1e-3], 150), iterations=3)
    assert np.abs(found - exact.signed).max() < 1e-12
    assert np.abs(feet - exact.arc_length).max() < 1e-9


@pytest.mark.parametrize(("start", "foot", "error"), [("both", 0.012, 5e-6), ("warm", 0.009995, 2e-3)])
def test_starting_from_both_places_finds_the_branch_beyond_a_corner(start: str, foot: float, error: float) -> None:
    """A warm start alone stays on the leg before the corner, 2 mm away; a start at the reference finds the near leg."""
    view = view_of(Path([Line((0.0, 0.0), (0.01, 0.0)), Line((0.01, 0.0), (0.01, 0.01))]))
    part = Newton(window=5e-3, start=start)
    step = part.path_step(view, 2)
    tables = {name: np.ravel(table).tolist() for name, table in view.tables.items()}
    par = step.par_type(**part.block(1e-3), **view.parameters, **tables)
    inside = INPUTS((0.01 - 5e-6, 0.002), 0.0121)
    _, out = step.function(par, FOOT(0.0099), inside, Clock(0.0, 0.0, 1e-3))
    assert out[3] == pytest.approx(foot, abs=1e-12)
    # Inside the corner is to the left of both legs.
    assert out[2] == pytest.approx(error, abs=1e-12)
