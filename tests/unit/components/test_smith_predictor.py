"""The Smith predictor: the delay that remains in the loop's poles and in runs."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from component_rig import make, run_alone
from refusals import refuses
from scipy.signal import cont2discrete

import contourlab as cl
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.components.contract import Component
from contourlab.components.controller.pid import PID, SpeedPID
from contourlab.components.predictor.smith import SmithPredictor
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.errors import ParameterError

T = 1e-3
G, ZETA, WN = 0.8, 1.1, 150.0
LAGGING = {"dc_gain": G, "damping_ratio": ZETA, "natural_frequency": WN}
SERVO: Any = SpeedPID(**LAGGING, time_constant=0.01)


def axis(delay: float, name: str = "x", **more: Any) -> cl.Axis:
    drive = make("drive", "delayed-saturation", delay=delay) if delay else make("drive", "saturation")
    return cl.Axis(name, make("plant", "second-order-integrator", **LAGGING), drive=drive, **more)


def servo(predictor: Component | None = None, controller: Component = SERVO) -> cl.AxisController:
    return cl.AxisController(controller, FilteredDifference(bandwidth=2000.0), predictor=predictor)


def smith(delay: float, **changed: float) -> SmithPredictor:
    return SmithPredictor(**{**LAGGING, "delay": delay, **changed})


@pytest.mark.parametrize("zeta", [0.0, 0.3, 1.0, 1.1, 4.0])
@pytest.mark.parametrize("delay", [0.0, 0.4e-3, 1e-3, 7e-3, 15.3e-3])
def test_the_correction_is_the_model_without_delay_less_the_delayed_model(delay: float, zeta: float) -> None:
    """Two copies of the held model of another library, one delayed, for random commands."""
    n = 300
    commands = np.cumsum(np.random.default_rng(1).normal(size=n)) * 0.1
    a = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, -WN * WN, -2.0 * zeta * WN]])
    model = cont2discrete((a, np.array([[0.0], [0.0], [G * WN * WN]]), np.eye(1, 3), np.zeros((1, 1))), T)
    whole = math.floor(delay / T + 1e-9)
    part = delay / T - whole
    past = np.concatenate([np.zeros(whole + 1), commands])
    late = (1.0 - part) * past[1 : n + 1] + part * past[:n]
    wanted, early, delayed = np.empty(n), np.zeros((3, 1)), np.zeros((3, 1))
    for k in range(n):
        # Until now the previous command was held.
        early = model[0] @ early + model[1] * commands[k]
        delayed = model[0] @ delayed + model[1] * late[k]
        wanted[k] = (early - delayed)[0, 0]
    found = run_alone(smith(delay, damping_ratio=zeta), {"applied": commands, "position": np.full(n, 0.3)}, period=T)["position"] - 0.3
    assert found == pytest.approx(wanted, abs=1e-11 * max(1.0, np.abs(wanted).max()))


@pytest.mark.parametrize("delay", [1e-3, 5e-3, 15e-3, 15.3e-3])
def test_the_loop_has_the_poles_of_the_loop_without_delay(delay: float) -> None:
    """Plus those of the model's own velocity, exp(s T) with s^2 + 2 zeta w s + w^2 = 0; all others end within the delay.

    The zeros of a delay form a chain. Eigenvalues find it to 1e-16^(1/n) only, and it disturbs a pole p by 1e-16 p^-n. This test therefore
    uses poles above 0.6; the response in the test below includes them all.
    """
    bare = sampled_loop(axis(0.0), servo(), T)
    made = sampled_loop(axis(delay), servo(smith(delay)), T)
    assert bare.stable and made.stable
    own = np.exp(np.roots([1.0, 2.0 * ZETA * WN, WN * WN]) * T)
    wanted = np.concatenate([bare.poles[np.abs(bare.poles) > 0.6], own])
    found = made.poles[np.abs(made.poles) > 0.6]
    assert found.size == wanted.size
    assert np.sort_complex(found) == pytest.approx(np.sort_complex(wanted), abs=1e-8)


@pytest.mark.parametrize("delay", [1e-3, 5e-3, 15e-3, 15.3e-3, 120e-3])
def test_the_response_is_the_one_without_delay_only_later(delay: float) -> None:
    w = np.geomspace(1.0, math.pi / T, 50)
    z, whole = np.exp(1j * w * T), math.floor(delay / T + 1e-9)
    part = delay / T - whole
    bare = sampled_loop(axis(0.0), servo(), T).response(w).closed_loop
    made = sampled_loop(axis(delay), servo(smith(delay)), T).response(w).closed_loop
    assert made == pytest.approx(bare * z**-whole * (1.0 - part + part / z), rel=1e-8)


def test_an_observer_sees_the_loop_without_delay_too() -> None:
    w = np.geomspace(1.0, math.pi / T, 50)
    observer = make("observer", "disturbance-observer", bandwidth=30.0, model_gain=40.0, model_damping=50.0)
    plain = replace(servo(controller=PID(proportional_gain=20.0)), observer=observer)
    bare = sampled_loop(axis(0.0), plain, T)
    made = sampled_loop(axis(8e-3), replace(plain, predictor=smith(8e-3)), T)
    assert bare.stable and made.stable
    late = np.exp(-8j * w * T)
    assert made.response(w).closed_loop == pytest.approx(bare.response(w).closed_loop * late, rel=1e-8)


def test_a_velocity_without_prediction_is_refused() -> None:
    with refuses(ParameterError, "predicted", name="velocity", value='"true"'):
        cl.AxisController(SERVO, predictor=smith(15e-3))


def test_lanes_may_have_different_delays() -> None:
    reference = cl.uniform(cl.contour("circle", radius=0.02), 2.0, 1, T)
    predicted = cl.Controller(dict.fromkeys("xy", servo(smith(3e-3))))
    delays = [0.4e-3, 3e-3, 15.3e-3]
    varied = {
        f"{owner}.{part}.delay": delays
        for axis in "xy"
        for owner, part in ((f"axes.{axis}", "drive"), (f"controller.axes.{axis}", "predictor"))
    }
    batch = cl.simulate_batch(machine(3e-3), predicted, reference, varied, keep=("axis_position",)).signals["axis_position"]
    for lane, delay in enumerate(delays):
        alone = cl.Controller(dict.fromkeys("xy", servo(smith(delay))))
        single = cl.simulate(machine(delay), alone, reference)["axis_position"]
        assert batch[:, :, lane] == pytest.approx(single, abs=1e-12)


def test_without_the_predictor_the_delay_makes_the_loop_unstable() -> None:
    assert not sampled_loop(axis(15e-3), servo(), T).stable


def machine(delay: float, **more: Any) -> cl.Machine:
    return cl.Machine("stage", tuple(axis(delay, name, **more) for name in "xy"), T)


@pytest.mark.parametrize("ticks", [1, 15])
def test_the_axis_moves_as_without_delay_only_later(ticks: int) -> None:
    """To rounding, from the first tick on."""
    reference = cl.uniform(cl.contour("circle", radius=0.02), 2.0, 1, T)
    bare = cl.simulate(machine(0.0), cl.Controller(dict.fromkeys("xy", servo())), reference)["axis_position"]
    predicted = cl.Controller(dict.fromkeys("xy", servo(smith(ticks * T))))
    late = cl.simulate(machine(ticks * T), predicted, reference)["axis_position"]
    assert late[ticks:] == pytest.approx(bare[:-ticks], abs=1e-12)
    assert late[:ticks] == pytest.approx(np.broadcast_to(bare[0], (ticks, 2)), abs=1e-12)


def test_a_steady_load_moves_the_axis_by_what_the_docstring_says() -> None:
    """The command -L holds a load L: the integral brings the predicted position to the reference; the axis is G tau L off."""
    load, delay = 0.01, 15e-3
    controller = PID(proportional_gain=20.0, integral_gain=100.0)
    reference = cl.uniform(cl.contour("circle", radius=1e-9), 1.0, 4, T)
    loaded = machine(delay, disturbance=make("disturbance", "constant", force=load))
    found = cl.simulate(loaded, cl.Controller(dict.fromkeys("xy", servo(smith(delay), controller))), reference)
    left = (found["axis_position"] - found["reference"])[-1]
    assert left == pytest.approx([G * delay * load] * 2, rel=1e-3)


def test_a_wrong_delay_costs_margin() -> None:
    """The distance from -1 shrinks as the predictor's delay departs from the axis's, either way."""
    away = [sampled_loop(axis(15e-3), servo(smith(delay)), T).margins().modulus for delay in (13e-3, 14e-3, 15e-3, 16e-3, 17e-3)]
    assert away[0] < away[1] < away[2] > away[3] > away[4]
