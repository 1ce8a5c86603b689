"""Estimators and cross-coupling in the servo loop, against equivalent loops and the judge."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, Array, make
from scipy.interpolate import make_interp_spline

import contourlab as cl
from contourlab.feed import AxisLimits, Route, plan
from contourlab.geometry import BSpline, Line, Path

GAINS = {"velocity_gain": 70.0, "position_gain": 2800.0, "integral_gain": 0.0}
LOADS = (0.2, -0.35, 0.1, 0.4, -0.15)


def stage(n_axis: int, gains: tuple[float, ...] | None = None) -> cl.Machine:
    """Return axes with equal or different gains, each with a constant load."""
    axes = []
    for j, name in enumerate("xyzuv"[:n_axis]):
        plant = make("plant", "rigid-axis", gain=gains[j] if gains else 1.0, damping=6.0)
        axes.append(cl.Axis(name, plant, disturbance=make("disturbance", "constant", force=LOADS[j])))
    return cl.Machine("stage", tuple(axes), PERIOD)


def control(n_axis: int, estimator: Any = None, coupling: Any = None, **gains: float) -> cl.Controller:
    part = make("controller", "position", **{**GAINS, **gains})
    return cl.Controller(dict.fromkeys("xyzuv"[:n_axis], cl.AxisController(part, make("velocity", "true"))), estimator, coupling)


def along(path: Path, feedrate: float = 0.05) -> cl.Reference:
    return plan(Route(path, feedrate, False, 0.0, 0), AxisLimits(1.0, 5.0, 100.0), PERIOD)


def off_the_path(result: cl.Result, normal: Array) -> Array:
    """Return the tracking error in a direction (n,)."""
    return np.asarray((result["reference"] - result["axis_position"]) @ normal)


def lissajous(n_axis: int) -> Path:
    """Return a smooth closed figure: each axis follows a sine of its own frequency."""
    u = np.linspace(0.0, 2.0 * math.pi, 61)
    points = 0.02 * np.column_stack([np.sin((1.0 + j) * u + 0.6 * j) / (1.0 + 0.5 * j) for j in range(n_axis)])
    points[-1] = points[0]
    spline = make_interp_spline(u, points, 5, bc_type="periodic")
    return Path([BSpline(5, spline.c, spline.t)], closed=True)


@pytest.mark.parametrize("n_axis", [2, 3, 5])
@pytest.mark.parametrize("kind", ["cross-coupled", "cross-coupled-filter"])
def test_with_equal_axes_a_gain_acts_across_the_path_only(n_axis: int, kind: str) -> None:
    """On a line, K on the contour error adds K to the position gain across it and nothing along it, at each tick."""
    end = np.array([0.03, 0.04, -0.02, 0.05, 0.01])[:n_axis]
    direction = end / np.linalg.norm(end)
    normal = np.eye(n_axis)[1] - direction[1] * direction
    reference = along(Path([Line((0.0,) * n_axis, tuple(end))]))
    gain = {"gain": 1500.0} if kind == "cross-coupled" else {"gain": 500.0, "numerator": [3.0], "denominator": [1.0]}
    coupled = cl.simulate(stage(n_axis), control(n_axis, make("estimator", "tangent"), make("coupling", kind, **gain)), reference)
    stiff = cl.simulate(stage(n_axis), control(n_axis, position_gain=4300.0), reference)
    plain = cl.simulate(stage(n_axis), control(n_axis), reference)
    assert off_the_path(coupled, normal) == pytest.approx(off_the_path(stiff, normal), abs=1e-14)
    assert off_the_path(coupled, direction) == pytest.approx(off_the_path(plain, direction), abs=1e-14)
    assert np.abs(off_the_path(coupled, normal) - off_the_path(plain, normal)).max() > 1e-5


@pytest.mark.parametrize("n_axis", [2, 5])
def test_a_share_of_the_axis_pid_scales_its_loop_across_the_path(n_axis: int) -> None:
    """C_cc = kappa C_fb with integral and filtered derivative: eps as with (1 + kappa) C_fb, that is eps_u/(1 + kappa T)."""
    kappa, gains = 0.7, {"proportional_gain": 900.0, "integral_gain": 9000.0, "derivative_gain": 40.0, "derivative_bandwidth": 600.0}
    end = np.array([0.03, 0.04, -0.02, 0.05, 0.01])[:n_axis]
    direction = end / np.linalg.norm(end)
    normal = np.eye(n_axis)[0] - direction[0] * direction
    reference = along(Path([Line((0.0,) * n_axis, tuple(end))]))

    def axes(factor: float, *parts: Any) -> cl.Result:
        rest = gains | {name: factor * gains[name] for name in ("proportional_gain", "integral_gain", "derivative_gain")}
        servo = cl.AxisController(make("controller", "pid", **rest), make("velocity", "true"))
        return cl.simulate(stage(n_axis), cl.Controller(dict.fromkeys("xyzuv"[:n_axis], servo), *parts), reference)

    shares = {"integral_rate": 10.0, "derivative_time": 40.0 / 900.0, "derivative_filter": 1.0 / 600.0}
    coupled = axes(1.0, make("estimator", "tangent"), make("coupling", "cross-coupled", gain=kappa * 900.0, **shares))
    assert off_the_path(coupled, normal) == pytest.approx(off_the_path(axes(1.0 + kappa), normal), abs=1e-13)
    assert off_the_path(coupled, direction) == pytest.approx(off_the_path(axes(1.0), direction), abs=1e-13)
    assert np.abs(off_the_path(coupled, normal) - off_the_path(axes(1.0), normal)).max() > 1e-5


def test_an_integral_of_the_contour_error_removes_constant_loads_across_the_path() -> None:
    """Along the path only the position gain holds the load: d/K_P."""
    direction, normal = np.array([0.8, 0.6]), np.array([-0.6, 0.8])
    reference = along(Path([Line((0.0, 0.0), (0.08, 0.06))]), 0.02)
    held = {"kind": "cross-coupled", "gain": 1500.0, "integral_rate": 20.0}
    result = cl.simulate(stage(2), control(2, make("estimator", "tangent"), make("coupling", **held)), reference)
    load = np.array(LOADS[:2])
    late = slice(reference.n_sample // 2, reference.n_sample // 2 + 500)
    assert np.abs(off_the_path(result, normal)[late]).max() < 1e-9
    middle = cl.simulate(stage(2), control(2), reference)
    assert off_the_path(middle, normal)[late] == pytest.approx(np.full(500, -(load @ normal) / 2800.0), rel=1e-6)
    assert off_the_path(result, direction)[late] == pytest.approx(off_the_path(middle, direction)[late], abs=1e-12)


@pytest.mark.parametrize("kind", ["tangent", "koren-lo", "osculating-circle", "newton"])
def test_on_line_estimates_differ_from_the_judge_by_their_closed_form_error(kind: str) -> None:
    """On a circle, left turning, with unequal axes and a lag of phi rho: closed forms at each tick."""
    radius = 0.02
    reference = cl.uniform(cl.contour("circle", radius=radius), 0.25, 1, PERIOD)
    result = cl.judge(cl.simulate(stage(2, (1.0, 0.7)), control(2, make("estimator", kind)), reference), reference)
    exact, found = result["contour_error"][500:], result["contour_error_estimate"][500:]
    place, tool = (np.unwrap(np.arctan2(p[500:, 1], p[500:, 0])) for p in (result["reference"], result["axis_position"]))
    assert np.abs(exact).max() > 1e-4
    expected = {
        "tangent": radius - (radius - exact) * np.cos(place - tool),
        "koren-lo": exact - exact**2 / (2.0 * radius),
    }.get(kind, exact)
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=1e-16)


@pytest.mark.parametrize("n_axis", [2, 3, 5])
@pytest.mark.slow
def test_coupling_reduces_the_contour_error_with_any_estimator_and_number_of_axes(n_axis: int) -> None:
    reference = cl.uniform(lissajous(n_axis), 0.2, 1, PERIOD)
    machine = stage(n_axis, (1.0, 0.7, 1.2, 0.9, 0.8)[:n_axis])

    def rms(estimator: Any, coupling: Any) -> float:
        result = cl.judge(cl.simulate(machine, control(n_axis, estimator, coupling), reference), reference)
        return float(np.sqrt(np.mean(result["contour_error"][1000:] ** 2)))

    alone = rms(None, None)
    part = make("coupling", "cross-coupled", gain=8000.0, integral_rate=5.0)
    kinds = {2: ("tangent", "koren-lo", "taylor", "newton"), 3: ("tangent", "osculating-circle", "taylor"), 5: ("tangent", "newton")}[
        n_axis
    ]
    found = {kind: rms(make("estimator", kind), part) for kind in kinds}
    assert max(found.values()) < 0.7 * alone, (alone, found)
