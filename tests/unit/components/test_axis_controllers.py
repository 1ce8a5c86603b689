"""Controllers of one axis against closed forms of their loops, filters of another library, and their behaviour at a limit."""

from __future__ import annotations

import cmath
import math
from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, behind_a_drive, make, run_alone
from each import each
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.signal import bilinear, lfilter

from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.components.conformance import check_component
from contourlab.components.contract import Component
from contourlab.components.controller.cascade import Cascade
from contourlab.components.controller.lead_lag import LeadLag
from contourlab.components.controller.pid import PID, SpeedPID
from contourlab.components.controller.state_feedback import StateFeedback
from contourlab.components.registry import components
from contourlab.errors import ParameterError
from contourlab.loop.machine import Axis, AxisController
from contourlab.papers.ghaffari.axis_response import axis_response

W = np.geomspace(0.5, 2000.0, 40)
G, ZETA, WN, TA = 0.8, 1.1, 150.0, 0.01
LAGGING = {"dc_gain": G, "damping_ratio": ZETA, "natural_frequency": WN}
CONTROLLERS = [kind for kind in components() if kind.family == "controller"]


def rigid(gain: float, damping: float = 0.0) -> Axis:
    return Axis("x", make("plant", "rigid-axis", gain=gain, damping=damping))


def lagging() -> Axis:
    return Axis("x", make("plant", "second-order-integrator", **LAGGING))


# --- all controllers -------------------------------------------------------------------------------------------------------------------


def _variants() -> list[Any]:
    """Return every controller with every option value that its example does not use."""
    found = []
    for kind in CONTROLLERS:
        part = kind(**kind.example)
        for name, parameter in kind.parameters.items():
            words = [word for word in parameter.choices if word != getattr(part, name)]
            found += [pytest.param(kind, {name: word}, id=f"{kind.kind}-{word}") for word in words]
    return found


@pytest.mark.parametrize(("kind", "words"), _variants())
def test_a_controller_keeps_the_contract_with_every_option(kind: Any, words: dict[str, str]) -> None:
    """Finite, resumable, and consistent with its linear model where the options leave it linear."""

    class Variant(kind):  # type: ignore[misc]
        """A controller with other options."""

        example = {**kind.example, **words}
        # Ports that act under other options only; the example shows that each acts under its own.
        without_effect = tuple(kind.parameters)

        def linearize(self) -> Any:
            return None if self.values().get("anti_windup") == "back-calculation" else super().linearize()

    check_component(Variant, jit=False)


@each("kind", [kind for kind in CONTROLLERS if kind.command_unit != "m"])
def test_feedforward_is_added_and_the_disturbance_estimate_subtracted(kind: type[Component]) -> None:
    rng = np.random.default_rng(1)
    part = kind(**kind.example)
    part = part.replace(**{name: math.inf for name in ("command_limit",) if name in part.parameters})
    part = part.replace(**{name: "none" for name in ("anti_windup",) if name in part.parameters})
    fed = {port.name: rng.normal(size=30) for port in part.inputs if port.name not in ("feedforward", "disturbance_estimate")}
    extra = {"feedforward": rng.normal(size=30), "disturbance_estimate": rng.normal(size=30)}
    change = run_alone(part, {**fed, **extra})["command"] - run_alone(part, fed)["command"]
    assert change == pytest.approx(extra["feedforward"] - extra["disturbance_estimate"], abs=1e-8)


@each("kind", [kind for kind in CONTROLLERS if kind.kind != "relay"])  # a relay knows no rest
def test_an_axis_at_rest_gets_zero_command_or_its_position_at_any_position(kind: type[Component]) -> None:
    part, still = kind(**kind.example), np.full(20, 0.3)
    places = ("reference", "position", "motor_position", "load_position")
    fed = {port.name: still for port in part.inputs if port.name in places}
    out = run_alone(part, fed, initial=part.at_rest(0.3)[0])["command"]
    assert (out == (0.3 if kind.command_unit == "m" else 0.0)).all()


INTEGRALS: list[Any] = [
    PID(proportional_gain=0.0, integral_gain=500.0, tracking_time=0.005),
    Cascade(position_gain=1.0, velocity_gain=5.0, integral_time=0.01, tracking_time=0.005),
    StateFeedback(position_gain=0.0, integral_gain=500.0, tracking_time=0.005),
    LeadLag(gain=5.0, lead_time=0.01, lag_time=0.01, integral_rate=100.0, tracking_time=0.005),
]
"""All integrals rise by 500 per second at an error of 1; two controllers also have a proportional gain of 5."""


@pytest.mark.parametrize("part", INTEGRALS, ids=lambda part: part.kind)
def test_back_calculation_settles_where_leak_equals_integration(part: Any) -> None:
    """At rest, dt K_I e = (1 - exp(-dt/T_t)) (u - limit)."""
    command = behind_a_drive(part.replace(anti_windup="back-calculation"), np.ones(200), 7.0)
    surplus = PERIOD * 500.0 / (1.0 - math.exp(-PERIOD / 0.005))
    assert command[-1] - 7.0 == pytest.approx(surplus, rel=1e-9)


@pytest.mark.parametrize("part", INTEGRALS, ids=lambda part: part.kind)
def test_a_held_integral_exceeds_the_limit_by_one_tick_at_most(part: Any) -> None:
    """It learns of the limit one tick late and leaves the limit at the first error of opposite sign."""
    error = np.concatenate([np.ones(200), -np.ones(40)])
    held, free = (behind_a_drive(part.replace(anti_windup=word), error, 7.0) for word in ("hold", "none"))
    assert 7.0 < held[:200].max() <= 7.0 + 2.0 * 500.0 * PERIOD + 1e-9
    assert np.abs(held[204]) < 7.0 < free[204]


@pytest.mark.parametrize("part", INTEGRALS, ids=lambda part: part.kind)
@pytest.mark.parametrize("word", ["hold", "back-calculation"])
def test_a_limit_is_left_without_a_bump(part: Any, word: str) -> None:
    """Per tick, the command moves by at most its proportional part and one step of the integral with its leak."""
    error = np.cos(np.arange(400) * 0.03)
    command = behind_a_drive(part.replace(anti_windup=word), error, 7.0)
    proportional = 5.0 * np.abs(np.diff(error)).max()
    most = PERIOD * 500.0
    assert np.abs(np.diff(command)).max() <= proportional + most + 1e-9


@pytest.mark.parametrize("kind", [PID, Cascade])
def test_the_command_limit_acts_like_the_limit_of_a_drive(kind: type[Component]) -> None:
    values = (
        {"proportional_gain": 2.0, "integral_gain": 300.0}
        if kind is PID
        else {"position_gain": 1.0, "velocity_gain": 2.0, "integral_time": 0.01}
    )
    error = np.sin(np.arange(300) * 0.05)
    own = behind_a_drive(kind(**values, command_limit=3.0), error, math.inf)
    of_drive = behind_a_drive(kind(**values), error, 3.0)
    assert own == pytest.approx(np.clip(of_drive, -3.0, 3.0), abs=1e-12)


# --- PID -----------------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("on", ["error", "measurement"])
def test_a_pid_is_the_sum_of_three_filters(on: str) -> None:
    rng = np.random.default_rng(2)
    r, p = rng.normal(size=(2, 60))
    part = PID(
        proportional_gain=30.0, integral_gain=700.0, derivative_gain=0.4, derivative_bandwidth=900.0, derivative_on=on, reference_weight=0.6
    )
    weight = 900.0 * PERIOD / (1.0 + 900.0 * PERIOD)
    slope = lfilter([weight / PERIOD, -weight / PERIOD], [1.0, weight - 1.0], r - p if on == "error" else -p)
    wanted = 30.0 * (0.6 * r - p) + lfilter([700.0 * PERIOD], [1.0, -1.0], r - p) + 0.4 * slope
    assert run_alone(part.replace(anti_windup="none"), {"reference": r, "position": p})["command"] == pytest.approx(wanted, rel=1e-10)


@pytest.mark.parametrize("weight", [0.0, 0.5, 1.0])
def test_weights_move_the_zeros_and_leave_the_loop(weight: float) -> None:
    """On 1/s^2 a PID has the loop (K_D s^2 + K_P s + K_I)/s^3; b K_P s appears in the response to the reference alone."""
    part = PID(proportional_gain=900.0, integral_gain=3000.0, reference_weight=weight, derivative_gain=50.0, derivative_bandwidth=500.0)
    s = 1j * W
    d = 50.0 * 500.0 * s / (s + 500.0)
    found = axis_response(rigid(1.0), AxisController(part), W)
    assert found.loop_gain == pytest.approx((900.0 + 3000.0 / s + d) / s**2, rel=1e-9)
    assert found.closed_loop == pytest.approx((weight * 900.0 + 3000.0 / s + d) / s**2 / (1.0 + found.loop_gain), rel=1e-9)


# --- the PID of eq (8) ---------------------------------------------------------------------------------------------------------------


def speed_pid(**more: Any) -> SpeedPID:
    return SpeedPID(**LAGGING, time_constant=TA, **more)


def test_the_loop_on_the_speed_error_is_a_first_order_lag() -> None:
    """1/(1 + T_a s), up to the filter of the acceleration: the difference halves as its bandwidth doubles."""
    wanted = 1.0 / (1.0 + 1j * W * TA)
    missing = []
    for bandwidth in (2e5, 4e5, 8e5):
        found = axis_response(lagging(), AxisController(speed_pid(acceleration_bandwidth=bandwidth)), W).closed_loop
        missing.append(np.abs(found - wanted).max())
    assert missing[0] < W.max() / 2e5
    assert np.array(missing[:-1]) / missing[1:] == pytest.approx([2.0, 2.0], rel=0.02)


def test_the_sampled_loop_converges_to_that_lag_to_first_order() -> None:
    w = np.geomspace(0.5, 500.0, 30)
    gaps = []
    for period in (1e-3, 5e-4, 2.5e-4, 1.25e-4):
        loop = sampled_loop(lagging(), AxisController(speed_pid()), period)
        assert loop.stable
        gaps.append(np.abs(loop.response(w).closed_loop - 1.0 / (1.0 + 1j * w * TA)).max())
    assert np.log2(np.array(gaps[:-1]) / gaps[1:]) == pytest.approx([1.0, 1.0, 1.0], abs=0.15)
    assert gaps[-1] < 0.01


@pytest.mark.parametrize("period", [1e-3, 1e-4])
def test_it_lags_by_the_time_constant_at_any_period(period: float) -> None:
    """At a steady speed v the command v/G is K_I e, so the lag is v T_a: 1 - T(s) = T_a s at low frequencies."""
    w = 1e-3
    found = sampled_loop(lagging(), AxisController(speed_pid()), period).response([w]).closed_loop[0]
    assert (1.0 - found) / (1j * w) == pytest.approx(TA, rel=1e-4)


def test_read_as_a_position_pid_it_has_no_damping() -> None:
    found = axis_response(lagging(), AxisController(speed_pid(structure="position")), W)
    assert found.loop_gain == pytest.approx(1.0 / (TA * (1j * W) ** 2), rel=1e-9)
    assert not sampled_loop(lagging(), AxisController(speed_pid(structure="position")), 1e-3).stable


# --- cascade -------------------------------------------------------------------------------------------------------------------------


@given(bandwidth=st.floats(20.0, 500.0), zeta=st.floats(0.5, 2.0), gain=st.floats(0.01, 100.0), part=st.floats(0.0, 0.9))
@settings(max_examples=40, deadline=None)
def test_a_tuned_velocity_loop_has_the_requested_poles(bandwidth: float, zeta: float, gain: float, part: float) -> None:
    damping = part * 2.0 * zeta * bandwidth
    made = Cascade(**Cascade.tune(bandwidth, zeta, gain, damping, position_gain=10.0)).replace(position_gain=0.0)
    s = 1j * W
    found = axis_response(rigid(gain, damping), AxisController(made), W).loop_gain
    # The numerator of 1 + L, with L over s (s + b), is the polynomial of the closed loop.
    assert (1.0 + found) * s * (s + damping) == pytest.approx(s * s + 2.0 * zeta * bandwidth * s + bandwidth**2, rel=1e-8)


def test_with_both_feedforwards_an_undamped_axis_follows_exactly() -> None:
    found = axis_response(rigid(0.7), AxisController(Cascade(**Cascade.tune(200.0, 0.9, 0.7))), W).closed_loop
    assert found == pytest.approx(np.ones(W.size), abs=1e-10)


def test_without_feedforward_it_lags_by_the_position_gain() -> None:
    made = Cascade(**{**Cascade.tune(200.0, 0.9, 0.7), "velocity_feedforward": 0.0, "acceleration_feedforward": 0.0})
    found = axis_response(rigid(0.7), AxisController(made), [1e-3]).closed_loop[0]
    assert (1.0 - found) / 1e-3j == pytest.approx(1.0 / made.position_gain, rel=1e-4)


@pytest.mark.parametrize(
    "change", [{"bandwidth": 0.0}, {"damping": -1.0}, {"model_gain": math.inf}, {"model_damping": 400.0}, {"position_gain": 0.0}]
)
def test_a_cascade_that_cannot_be_tuned_is_refused(change: dict[str, float]) -> None:
    with pytest.raises(ParameterError, match=next(iter(change))):
        Cascade.tune(**{"bandwidth": 100.0, "damping": 1.0, "model_gain": 1.0, "model_damping": 5.0, **change})


# --- lead-lag ------------------------------------------------------------------------------------------------------------------------


def test_a_lead_lag_is_the_tustin_filter() -> None:
    error = np.random.default_rng(3).normal(size=80)
    k, a, b, ki = 40.0, 0.02, 0.003, 25.0
    above, below = bilinear(k * np.polymul([a, 1.0], [1.0, ki]), np.polymul([b, 1.0], [1.0, 0.0]), 1.0 / PERIOD)
    part = LeadLag(gain=k, lead_time=a, lag_time=b, integral_rate=ki, anti_windup="none")
    assert run_alone(part, {"reference": error, "position": 0.0 * error})["command"] == pytest.approx(
        lfilter(above, below, error), rel=1e-9
    )


@given(
    margin=st.floats(35.0, 65.0),
    crossover=st.floats(20.0, 300.0),
    gain=st.floats(0.01, 100.0),
    part=st.floats(0.0, 0.5),
    delay=st.floats(0.0, 5e-4),
)
@settings(max_examples=40, deadline=None)
def test_a_designed_lead_has_its_margin_at_its_crossover(margin: float, crossover: float, gain: float, part: float, delay: float) -> None:
    damping = part * crossover
    made = LeadLag(**LeadLag.design(math.radians(margin), crossover, gain, damping, delay=delay))
    axis = rigid(gain, damping)
    found = axis_response(axis, AxisController(made), [crossover]).loop_gain[0] * cmath.exp(-1j * crossover * delay)
    assert abs(found) == pytest.approx(1.0, rel=1e-9)
    assert cmath.phase(-found) == pytest.approx(math.radians(margin), abs=1e-9)


def test_a_design_that_ignores_the_integral_loses_its_phase() -> None:
    """UBC MECH 467: 60 degrees at 20 Hz for the lead, k_i a tenth; the whole loop has atan(0.1) less."""
    crossover = 2.0 * math.pi * 20.0
    made = LeadLag(**LeadLag.design(math.radians(60.0), crossover, 1.8, 20.0, integral_counted=False))
    found = axis_response(rigid(1.8, 20.0), AxisController(made), [crossover]).loop_gain[0]
    assert cmath.phase(-found) == pytest.approx(math.radians(60.0) - math.atan(0.1), abs=1e-9)
    assert abs(found) == pytest.approx(math.hypot(1.0, 0.1), rel=1e-9)


def test_the_sampled_loop_has_the_margin_if_half_a_period_is_counted() -> None:
    """The hold equals half a period of delay up to the second order of the period; so does Tustin's rule."""
    gaps = []
    for period in (2.5e-4, 1.25e-4, 6.25e-5):
        made = LeadLag(**LeadLag.design(math.radians(60.0), 125.0, 1.8, 20.0, delay=0.5 * period))
        found = sampled_loop(rigid(1.8, 20.0), AxisController(made), period).margins()
        gaps.append(abs(found.phase - math.radians(60.0)))
    assert gaps[0] < math.radians(0.05)
    assert np.log2(np.array(gaps[:-1]) / gaps[1:]) == pytest.approx([2.0, 2.0], abs=0.1)


@pytest.mark.parametrize(
    ("change", "name"),
    [
        ({"phase_margin": math.radians(100.0)}, "phase_margin"),
        ({"model_damping": 1e6}, "phase_margin"),
        ({"crossover": 0.0}, "crossover"),
        ({"delay": -1.0}, "delay"),
    ],
)
def test_a_lead_that_cannot_be_made_is_refused(change: dict[str, float], name: str) -> None:
    with pytest.raises(ParameterError, match=name):
        LeadLag.design(**{"phase_margin": 0.5, "crossover": 100.0, "model_gain": 1.0, **change})  # type: ignore[arg-type]


# --- state feedback ------------------------------------------------------------------------------------------------------------------

pairs = st.tuples(st.floats(10.0, 200.0), st.floats(0.3, 1.5)).map(lambda p: np.roots([1.0, 2.0 * p[0] * p[1], p[0] ** 2]).tolist())


@given(pair=pairs, extra=st.none() | st.floats(10.0, 200.0), gain=st.floats(0.01, 100.0), damping=st.floats(0.0, 50.0))
@settings(max_examples=40, deadline=None)
def test_a_rigid_axis_has_the_placed_poles(pair: list[complex], extra: float | None, gain: float, damping: float) -> None:
    poles = pair if extra is None else [*pair, -extra]
    part = StateFeedback(**StateFeedback.place_rigid(poles, gain, damping))
    s = 1j * W
    found = axis_response(rigid(gain, damping), AxisController(part), W)
    below = s * (s + damping) * (1.0 if extra is None else s)
    wanted = np.prod([s - pole for pole in poles], axis=0)
    assert (1.0 + found.loop_gain) * below == pytest.approx(wanted, rel=1e-8, abs=1e-8 * np.abs(wanted).min())
    assert found.closed_loop == pytest.approx(np.ones(W.size), abs=1e-8)


def test_on_the_position_alone_it_is_the_second_order_lag() -> None:
    """w^2/(s^2 + 2 zeta w s + w^2): at 20 Hz and 0.7 it lags by 2 zeta/w = 11.1 ms at any speed."""
    w, zeta, s = 2.0 * math.pi * 20.0, 0.7, 1j * W
    placed = StateFeedback.place_rigid(np.roots([1.0, 2.0 * zeta * w, w * w]).tolist(), 1.8, 20.0)
    part = StateFeedback(**placed, following="position")
    found = axis_response(rigid(1.8, 20.0), AxisController(part), W).closed_loop
    assert found == pytest.approx(w * w / (s * s + 2.0 * zeta * w * s + w * w), rel=1e-9)


@pytest.mark.parametrize("poles", [[-40.0, -30.0 + 30.0j, -30.0 - 30.0j], [-25.0, -60.0, -30.0 + 30.0j, -30.0 - 30.0j]])
def test_a_third_order_axis_converges_to_the_placed_poles(poles: list[complex]) -> None:
    """Sampled loop: the slowest poles converge to the placed ones, and position to the reference, to first order in the period."""
    part = StateFeedback(**StateFeedback.place_second_order(poles, G, ZETA, WN))
    away, behind = [], []
    w = np.geomspace(0.5, 300.0, 20)
    for period in (2e-4, 1e-4, 5e-5):
        loop = sampled_loop(lagging(), AxisController(part), period)
        found = np.log(loop.poles[np.abs(loop.poles) > 0.5]) / period
        away.append(max(np.abs(found - pole).min() for pole in poles))
        behind.append(np.abs(loop.response(w).closed_loop - 1.0).max())
    assert np.log2(np.array(away[:-1]) / away[1:]) == pytest.approx([1.0, 1.0], abs=0.15)
    assert np.log2(np.array(behind[:-1]) / behind[1:]) == pytest.approx([1.0, 1.0], abs=0.15)
    assert away[-1] < 0.5
    # The jerk by a difference and the hold each add half a period of delay.
    assert behind[-1] < 2.0 * w[-1] * 5e-5


@pytest.mark.parametrize(
    ("poles", "said"),
    [
        ([-30.0], "poles = a list of 1: .* 2, or of 3"),
        ([-30.0, 1.0], "negative"),
        ([-30.0 + 5.0j, -30.0 + 5.0j], "conjugate pairs"),
        ([-30.0, math.nan], "finite"),
    ],
)
def test_poles_that_cannot_be_placed_are_refused(poles: list[complex], said: str) -> None:
    with pytest.raises(ParameterError, match=said):
        StateFeedback.place_rigid(poles, 1.0)
