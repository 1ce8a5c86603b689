"""Orders and leading terms of the local estimators, which see the path only at the reference, against exact foot points."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from numpy.typing import NDArray
from refusals import refuses

from contourlab.components.contract import Component
from contourlab.components.registry import component
from contourlab.engine.step import record
from contourlab.errors import ParameterError
from contourlab.geometry import Line, Path, contour
from contourlab.geometry.view import PathView, view_of
from contourlab.primitives import Clock

Array = NDArray[np.float64]
INPUTS = record(("position", "arc_length"))
ANY_AXES = ("tangent", "osculating-circle", "taylor")
LOCAL = (*ANY_AXES, "koren-lo")
ORDERS = {"tangent": 2.0, "koren-lo": 3.0, "osculating-circle": 3.0, "taylor": 3.0}


def estimates(part: Component, view: PathView, points: Array, references: Array) -> dict[str, Array]:
    """Return the estimate for each point (n, n_axis), each with its own arc length of the reference; newton starts there."""
    step = part.path_step(view, points.shape[1])  # type: ignore[attr-defined]
    tables = {name: np.ravel(table).tolist() for name, table in view.tables.items()}
    par = step.par_type(**part.block(1e-3), **view.parameters, **tables)
    state = record(tuple(port.name for port in step.states))
    rows = []
    for point, s in zip(points.tolist(), references.tolist(), strict=True):
        x = state(*[s] * step.n_state)
        rows.append(step.function(par, x, INPUTS(tuple(point), s), Clock(0.0, 0.0, 1e-3))[1])
    return {port.name: np.array([row[i] for row in rows]) for i, port in enumerate(step.outputs)}


def made(kind: str, direction: Array | None = None) -> Component:
    part = component("estimator", kind)
    return part() if direction is None else part(direction=direction.tolist())


def slope(lags: Array, errors: list[float]) -> float:
    """Return the exponent with which the error grows with the lag."""
    return float(np.polyfit(np.log(lags), np.log(errors), 1)[0])


ELLIPSE = contour("ellipse", a=0.04, b=0.02)


# --- plane paths, by the judge's foot point ------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("kind", "largest"),
    [("tangent", 5.0e-5), ("koren-lo", 1.1e-6), ("osculating-circle", 1.1e-6), ("taylor", 1.1e-6)],
)
@pytest.mark.parametrize("error", [20e-6, -20e-6])
def test_largest_error_on_an_ellipse_of_40_by_20_mm(kind: str, largest: float, error: float) -> None:
    """20 um off an ellipse with half axes of 40 and 20 mm, 1 mm behind; the figures have two digits."""
    foot = np.linspace(0.0, ELLIPSE.length, 600, endpoint=False)
    points = ELLIPSE.position(foot) + error * ELLIPSE.normal(foot)
    exact = ELLIPSE.foot_point(points, foot, 5e-3).signed
    found = estimates(made(kind), view_of(ELLIPSE, tolerance=1e-13, pieces=2048), points, foot + 1e-3)
    gap = np.abs(found["contour_error_estimate"] - exact).max()
    assert gap == pytest.approx(largest, abs=0.05 * 10.0 ** math.floor(math.log10(largest)))


@pytest.mark.parametrize("kind", LOCAL)
@pytest.mark.parametrize("name", ["ellipse", "butterfly", "lemniscate"])
def test_orders_on_plane_paths(kind: str, name: str) -> None:
    """1 um off the path and behind by a lag; the butterfly between two knots, where its curvature changes."""
    path = ELLIPSE if name == "ellipse" else contour(name)
    low, high = (0.2, 0.21) if name == "butterfly" else (0.1, 0.2)
    foot = np.linspace(low, high, 25) * path.length
    points = path.position(foot) + 1e-6 * path.normal(foot)
    lags = np.geomspace(0.15e-3, 0.6e-3, 4)
    exact = path.foot_point(points, foot, 2e-3).signed
    view = view_of(path, tolerance=1e-13)
    errors = []
    for lag in lags:
        found = estimates(made(kind), view, points, foot + lag)["contour_error_estimate"]
        errors.append(float(np.abs(found - exact).max()))
    assert slope(lags, errors) == pytest.approx(ORDERS[kind], abs=0.12)


@pytest.mark.parametrize("kind", LOCAL)
def test_leading_terms_of_the_lag(kind: str) -> None:
    """On the path: L^2 k/2 to the left of the tangent where the path turns left; L^3 k'/6 for the others, the reference being ahead."""
    s, lag = np.linspace(0.02, 0.03, 7), 1e-4
    found = estimates(made(kind), view_of(ELLIPSE, tolerance=1e-13, pieces=2048), ELLIPSE.position(s - lag), s)["contour_error_estimate"]
    expected = 0.5 * lag**2 * ELLIPSE.curvature(s) if kind == "tangent" else -(lag**3) / 6.0 * ELLIPSE.curvature_derivative(s)
    assert found == pytest.approx(expected, rel=0.03)


@pytest.mark.parametrize("clockwise", [0.0, 1.0])
@pytest.mark.parametrize("error", [0.0, 3e-3, -3e-3])
def test_closed_forms_on_a_circle(clockwise: float, error: float) -> None:
    """Behind by the angle phi: osculating circle eps; Koren-Lo eps -+ eps^2/(2 rho); tangent rho - (rho - eps) cos phi, left turning."""
    radius, angle = 0.02, np.array([0.0, 0.1, 0.4, 1.2])
    circle = contour("circle", radius=radius, clockwise=clockwise)
    turn = -1.0 if clockwise else 1.0
    foot = np.full(4, 0.031)
    points = circle.position(foot) + error * circle.normal(foot)
    found = {kind: estimates(made(kind), view_of(circle), points, foot + radius * angle)["contour_error_estimate"] for kind in LOCAL}
    assert found["osculating-circle"] == pytest.approx(np.full(4, error), abs=1e-17)
    assert found["koren-lo"] == pytest.approx(np.full(4, error - turn * error**2 / (2.0 * radius)), abs=1e-17)
    inward = radius - turn * error
    assert found["tangent"] == pytest.approx(turn * (radius - inward * np.cos(angle)), abs=1e-17)
    if error == 0.0:
        parabola = 0.5 * radius * (1.0 - np.cos(angle)) ** 2 / np.sqrt(1.0 + np.sin(angle) ** 2)
        assert found["taylor"] == pytest.approx(turn * parabola, abs=1e-17)


# --- in space ------------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ANY_AXES)
def test_orders_on_a_helix(kind: str) -> None:
    """0.1 mm off a helix, in rotating directions normal to it."""
    path = contour("helix", radius=0.02, pitch=0.03)
    foot = np.linspace(0.2, 0.6, 12) * path.length
    tangent, inward = path.tangent(foot), path.derivatives(foot, 2)[2] / path.curvature(foot)[:, None]
    angle = np.linspace(0.3, 1.2, 12)[:, None]
    points = path.position(foot) + 1e-4 * (np.cos(angle) * inward + np.sin(angle) * np.cross(tangent, inward))
    exact = path.foot_point(points, foot, 5e-3).distance
    lags, errors = np.geomspace(0.1e-3, 0.4e-3, 4), []
    for lag in lags:
        found = estimates(made(kind), view_of(path, tolerance=1e-13), points, foot + lag)["contour_error_estimate"]
        errors.append(float(np.abs(found - exact).max()))
    assert slope(lags, errors) == pytest.approx(ORDERS[kind], abs=0.15)


@pytest.mark.parametrize("kind", ["osculating-circle", "taylor"])
def test_only_torsion_matters_on_a_helix(kind: str) -> None:
    """A helix has constant curvature and leaves its osculating plane by L^3 k tau/6."""
    radius, rise = 0.02, 0.03 / (2.0 * math.pi)
    path = contour("helix", radius=radius, pitch=0.03)
    lag, s = 3e-4, np.array([0.1])
    found = estimates(made(kind), view_of(path, tolerance=1e-15), path.position(s - lag), s)["contour_error_estimate"]
    square = radius**2 + rise**2
    assert found[0] == pytest.approx(lag**3 / 6.0 * radius * rise / square**2, rel=1e-2)


SIZE, RATE = np.array([0.04, 0.03, 0.02, 0.01, 0.015]), np.array([1.0, 2.0, 3.0, 4.0, 5.0])
PHASE = np.array([0.0, 0.5, 1.0, 0.3, 2.0])


def on_lissajous(par: Any, u: float) -> Any:
    """Evaluate five axes by their phase, each a sine of its own frequency; the speed is uneven."""
    angle = RATE * u + PHASE
    rows = (SIZE * np.sin(angle), SIZE * RATE * np.cos(angle), -SIZE * RATE**2 * np.sin(angle))
    return tuple(tuple(row.tolist()) for row in rows)


@pytest.mark.parametrize(("kind", "order"), [*((kind, ORDERS[kind]) for kind in ANY_AXES), ("newton", 4.0)])
def test_orders_in_five_axes(kind: str, order: float) -> None:
    """0.1 mm off a Lissajous figure in five axes; each point is built from its foot point, so that is known."""
    foot = np.linspace(0.0, 2.0 * math.pi, 40, endpoint=False)
    rng = np.random.default_rng(3)
    rows = np.array([on_lissajous(None, u) for u in foot])
    tangent = rows[:, 1] / np.linalg.norm(rows[:, 1], axis=1)[:, None]
    away = rng.standard_normal((40, 5))
    away -= (away * tangent).sum(axis=1)[:, None] * tangent
    points = rows[:, 0] + 1e-4 * away / np.linalg.norm(away, axis=1)[:, None]
    part = component("estimator", kind)(**({"iterations": 1, "start": "warm", "window": 1.0} if kind == "newton" else {}))
    lags = np.geomspace(0.005, 0.02, 4)
    errors = []
    for lag in lags:
        found = estimates(part, PathView(on_lissajous, {}, {}), points, foot + lag)["contour_error_estimate"]
        errors.append(float(np.abs(found - 1e-4).max()))
    assert slope(lags, errors) == pytest.approx(order, abs=0.2)


# --- what holds for each -------------------------------------------------------------------------------------------------------------


@given(
    n=st.integers(2, 6),
    numbers=st.lists(st.floats(-0.1, 0.1), min_size=18, max_size=18),
    lag=st.floats(-0.01, 0.01),
)
def test_all_are_exact_on_lines(n: int, numbers: list[float], lag: float) -> None:
    """In any number of axes, however far the tool is off and behind."""
    begin, end, point = np.reshape(numbers, (3, 6))[:, :n]
    length = float(np.linalg.norm(end - begin))
    assume(length >= 0.05)
    along = (end - begin) / length
    middle = 0.5 * (begin + end)
    gap = middle - point
    exact = gap - (gap @ along) * along
    view = view_of(Path([Line(tuple(begin), tuple(end))]))
    for kind in (*ANY_AXES, "newton", "constant-gain", *(["koren-lo"] if n == 2 else [])):
        found = estimates(made(kind, 3.0 * along if kind == "constant-gain" else None), view, point[None], np.array([0.5 * length + lag]))
        assert found["error_vector"][0] == pytest.approx(exact, abs=3e-15), kind
        size = float(found["contour_error_estimate"][0])
        left = along[1] * exact[0] - along[0] * exact[1] if n == 2 else np.linalg.norm(exact)
        assert size == pytest.approx(left, abs=3e-15), kind


@pytest.mark.parametrize("kind", [*LOCAL, "newton", "constant-gain"])
@pytest.mark.parametrize("name", ["ellipse", "helix"])
def test_the_vector_is_normal_to_a_unit_tangent_and_leads_to_the_foot(kind: str, name: str) -> None:
    path = contour(name)
    if kind == "koren-lo" and path.n_axis != 2:
        return
    rng = np.random.default_rng(8)
    s = rng.uniform(0.2, 0.7, 50) * path.length
    points = path.position(s) + 3e-3 * rng.standard_normal((50, path.n_axis))
    part = made(kind, np.arange(1.0, path.n_axis + 1.0) if kind == "constant-gain" else None)
    found = estimates(part, view_of(path), points, s + rng.uniform(-2e-3, 2e-3, 50))
    assert np.linalg.norm(found["tangent"], axis=1) == pytest.approx(np.ones(50), abs=1e-14)
    assert (found["tangent"] * found["error_vector"]).sum(axis=1) == pytest.approx(np.zeros(50), abs=1e-16)
    if kind != "newton":
        assert found["foot_position"] == pytest.approx(points + found["error_vector"], abs=1e-17)
    if path.n_axis == 2:
        assert (found["tangent"] * path.tangent(s)).sum(axis=1).min() > 0.0
        exact = path.foot_point(points, s, 0.02).signed
        large = np.abs(exact) > 1e-3
        assert kind == "constant-gain" or (np.sign(found["contour_error_estimate"]) == np.sign(exact))[large].all()


@given(place=st.floats(0.0, 0.19), off=st.floats(-5e-3, 5e-3), lag=st.floats(-5e-3, 5e-3), gain=st.floats(0.1, 1e4))
def test_koren_and_los_correction_is_reproduced(place: float, off: float, lag: float, gain: float) -> None:
    """Their formulas, with tangent angle and signed radius, equal a gain on the error vector."""
    r, t = ELLIPSE.position(np.array([place]))[0], ELLIPSE.tangent(np.array([place]))[0]
    point = r + off * np.array([-t[1], t[0]]) - lag * t
    ex, ey = r - point
    theta, rho = math.atan2(t[1], t[0]), 1.0 / float(ELLIPSE.curvature(np.array([place]))[0])
    cx, cy = math.sin(theta) - ex / (2.0 * rho), math.cos(theta) + ey / (2.0 * rho)
    eps = -cx * ex + cy * ey
    found = estimates(made("koren-lo"), view_of(ELLIPSE, tolerance=1e-13, pieces=2048), point[None], np.array([place]))
    assert gain * found["error_vector"][0] == pytest.approx([-cx * gain * eps, cy * gain * eps], abs=1e-9 * gain * (abs(eps) + 1e-6))
    assert found["contour_error_estimate"][0] == pytest.approx(-eps, abs=1e-11)


def test_a_straight_is_the_limit_of_its_arcs() -> None:
    """Nothing jumps at zero curvature, nor where the direction to the centre is dropped."""
    gap, lag = 2e-3, 5e-3
    for kind in (*LOCAL, "newton"):
        for curvature in (1e-6, 2e-12, 1e-12, 1e-13, 1e-30, 1e-200, 0.0):

            def on_arc(par: Any, s: float, k: float = curvature) -> Any:
                return (s, 0.5 * k * s * s), (1.0, k * s), (0.0, k)

            found = estimates(made(kind), PathView(on_arc, {}, {}), np.array([[-lag, gap]]), np.zeros(1))
            assert found["contour_error_estimate"][0] == pytest.approx(gap, abs=curvature * 1e-4 + 1e-17), (kind, curvature)


@pytest.mark.parametrize("kind", LOCAL)
def test_at_the_centre_of_curvature_the_answer_is_finite(kind: str) -> None:
    circle = contour("circle", radius=0.02)
    found = estimates(made(kind), view_of(circle), np.array([[0.0, 0.0], [-0.04, 0.0], [-0.02, 0.0]]), np.zeros(3))
    assert all(np.isfinite(values).all() for values in found.values())
    assert np.linalg.norm(found["tangent"], axis=1) == pytest.approx(np.ones(3), abs=1e-6)


def test_the_estimators_say_for_how_many_axes_they_are_valid() -> None:
    with refuses(ParameterError, "koren-lo.* 3 .* 2;", name="controller.estimator"):
        made("koren-lo").path_step(view_of(contour("helix")), 3)  # type: ignore[attr-defined]
    with refuses(ParameterError, "3 numbers", name="constant-gain.direction", value=[1.0, 0.0]):
        made("constant-gain", np.array([1.0, 0.0])).path_step(view_of(contour("helix")), 3)  # type: ignore[attr-defined]
    with refuses(ParameterError, "vector", name="constant-gain.direction", value=[0.0, 0.0]):
        made("constant-gain", np.zeros(2))
    with refuses(ParameterError, "3 axes", name="constant-gain.angle", value="0.1"):
        component("estimator", "constant-gain")(direction=[1.0, 0.0, 0.0], angle=0.1)


def test_a_constant_gain_at_an_angle() -> None:
    """Koren's line at 30 degrees, there and back: eps = -e_x sin th + e_y cos th, and the sign changes with the direction of travel."""
    there, back = Line((0.0, 0.0), (0.04, 0.03)), Line((0.04, 0.03), (0.0, 0.0))
    part = component("estimator", "constant-gain")(direction=[2.0, 0.0], angle=math.radians(30.0))
    for line, sense in ((there, 1.0), (back, -1.0)):
        path = Path([line])
        point = np.array([[0.011, 0.017]])
        ex, ey = (path.position(np.array([0.02])) - point)[0]
        found = estimates(part, view_of(path), point, np.array([0.02]))
        eps = -ex * math.sin(math.radians(30.0)) + ey * math.cos(math.radians(30.0))
        assert found["contour_error_estimate"][0] == pytest.approx(-sense * eps, abs=1e-17)
        assert found["error_vector"][0] == pytest.approx([-0.5 * eps, math.cos(math.radians(30.0)) * eps], abs=1e-17)
