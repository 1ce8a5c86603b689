"""The position controller: placed poles, printed gains, exact following, and the integral at the limit."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, Array, behind_a_drive, make, run_alone
from hypothesis import given
from hypothesis import strategies as st

import contourlab as cl
from contourlab.components.controller.position import PositionController
from contourlab.errors import ParameterError


def closed_loop(part: PositionController, gain: float, damping: float) -> Array:
    """Return the matrix of an ideal axis under the controller, states p, v and the integral."""
    model, plant = part.linearize(), make("plant", "rigid-axis", gain=gain, damping=damping).linearize()
    p, v = (model.inputs.index(name) for name in ("position", "velocity"))
    matrix = np.zeros((3, 3))
    matrix[:2, :2] = plant.a + plant.b[:, :1] @ model.d[:, [p, v]]
    matrix[:2, 2:] = plant.b[:, :1] @ model.c
    matrix[2, :2], matrix[2, 2:] = model.b[0, [p, v]], model.a[0]
    return matrix


@given(
    wn=st.floats(1.0, 200.0),
    zeta=st.floats(0.2, 2.0),
    alpha=st.floats(1.0, 200.0),
    gain=st.floats(0.01, 100.0),
    part=st.floats(0.0, 1.0),
    structure=st.sampled_from(["feedforward", "ipv"]),
)
def test_the_loop_has_the_placed_poles(wn: float, zeta: float, alpha: float, gain: float, part: float, structure: str) -> None:
    """The characteristic polynomial of the loop is (s^2 + 2 zeta w_n s + w_n^2)(s + alpha), in both structures."""
    damping = part * (alpha + 2.0 * zeta * wn)
    controller = PositionController(**PositionController.place(wn, zeta, alpha, gain, damping), structure=structure)
    found = np.poly(closed_loop(controller, gain, damping))
    wanted = np.polymul([1.0, 2.0 * zeta * wn, wn * wn], [1.0, alpha])
    scale = max(wn, alpha) ** np.arange(4)
    assert found / scale == pytest.approx(wanted / scale, abs=1e-9)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"natural_frequency": 0.0}, "natural_frequency = 0: must be > 0"),
        ({"damping": -0.7}, "damping = -0.7: must be > 0"),
        ({"pole": math.nan}, "pole = nan: must be > 0 and finite"),
        ({"model_gain": math.inf}, "model_gain = inf: must be > 0 and finite"),
        ({"model_damping": 71.0}, r"model_damping = 71 1/s: must be <= pole \+ 2 damping natural_frequency = 70"),
    ],
)
def test_impossible_placements_are_refused(change: dict[str, float], said: str) -> None:
    asked = {"natural_frequency": 25.0, "damping": 0.7, "pole": 35.0, "model_gain": 0.9, "model_damping": 20.0}
    with pytest.raises(ParameterError, match=said):
        PositionController.place(**{**asked, **change})


def test_an_ideal_axis_follows_up_to_the_sampling_error() -> None:
    """Eq (15) makes P/R' = 1; the rest comes from the held command and vanishes with the period."""
    gain, damping, errors = 0.873, 19.7, []
    part = make("controller", "position", **PositionController.place(25.0, 0.7, 35.0, gain, damping))
    for period in (1e-3, 5e-4, 2.5e-4):
        axes = tuple(cl.Axis(name, make("plant", "rigid-axis", gain=gain, damping=damping)) for name in "xy")
        controller = cl.Controller(dict.fromkeys("xy", cl.AxisController(part, make("velocity", "true"))))
        reference = cl.uniform(cl.contour("circle", radius=0.02), 1.0, 3, period)
        result = cl.simulate(cl.Machine("ideal", axes, period), controller, reference)
        last = slice(2 * result.n_sample // 3, None)
        errors.append(np.abs(result["reference"] - result["axis_position"])[last].max())
    assert errors[0] < 0.02 * 0.01
    assert np.log2([errors[0] / errors[1], errors[1] / errors[2]]) == pytest.approx([1.0, 1.0], abs=0.1)


GAINS: dict[str, Any] = {"velocity_gain": 100.0, "position_gain": 4000.0, "integral_gain": 12.0, "model_gain": 0.9, "model_damping": 30.0}


def test_the_command_is_equation_15() -> None:
    part = make("controller", "position", **GAINS, anti_windup="none")
    rng = np.random.default_rng(1)
    fed = {port.name: rng.normal(size=40) for port in part.inputs}
    command = np.empty(40)
    integral = 0.0
    for k in range(40):
        r, p = fed["reference"][k], fed["position"][k]
        integral += PERIOD * (r - p)
        command[k] = 100.0 * (fed["reference_velocity"][k] - fed["velocity"][k]) + 4000.0 * (r - p) + 4000.0 * 12.0 * integral
        command[k] += (fed["reference_acceleration"][k] + 30.0 * fed["reference_velocity"][k]) / 0.9 - fed["disturbance_estimate"][k]
        command[k] += fed["feedforward"][k]
    assert run_alone(part, fed)["command"] == pytest.approx(command, rel=1e-12)


def test_without_feedforward_the_reference_adds_nothing() -> None:
    part = make("controller", "position", velocity_gain=100.0, position_gain=4000.0)
    out = run_alone(part, {"reference_acceleration": np.full(3, 50.0), "reference_velocity": np.zeros(3)})["command"]
    assert not out.any()


def test_an_ipv_loop_at_rest_away_from_zero_gives_zero_command() -> None:
    part = make("controller", "position", **{**GAINS, "structure": "ipv"})
    still = np.full(20, 0.3)
    out = run_alone(part, {"reference": still, "position": still}, initial=part.at_rest(0.3)[0])["command"]
    assert not out.any()


@pytest.mark.parametrize("way", [-1.0, 1.0])
def test_the_integral_waits_while_the_drive_is_at_its_limit(way: float) -> None:
    """It ignores errors that drive further into the limit and integrates errors that lead out of it."""
    error = way * np.concatenate([np.full(20, 1e-3), np.full(5, -0.25e-3)])
    part = make("controller", "position", position_gain=4000.0, integral_gain=12.0)
    hold, windup = (behind_a_drive(part.replace(anti_windup=kind), error, 2.0) for kind in ("hold", "none"))
    rate = 4000.0 * 12.0 * PERIOD
    # The first tick does not know of the limit yet; then the integral stays constant until the error changes sign.
    held = way * np.concatenate([np.full(20, 1e-3), 1e-3 - 0.25e-3 * np.arange(1, 6)])
    assert hold - 4000.0 * error == pytest.approx(rate * held, abs=1e-9)
    assert windup - 4000.0 * error == pytest.approx(rate * np.cumsum(error), abs=1e-9)
