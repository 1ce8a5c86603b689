"""Zero-phase filters of real loops: zero phase, the gain of the uncancelled part, and confirmation by a run."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import contourlab as cl
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.analysis.linear.zpetc import zero_phase_filter, zpetc_design
from contourlab.components.controller.cascade import Cascade
from contourlab.components.controller.lead_lag import LeadLag
from contourlab.components.controller.pid import PID
from contourlab.components.controller.position import PositionController
from contourlab.components.controller.state_feedback import StateFeedback
from contourlab.components.drive.saturation import DelayedSaturation, Saturation
from contourlab.components.feedforward.laws import ZPETC
from contourlab.components.ideal import TrueVelocity
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.components.plant.lagged_mass import SecondOrderIntegrator
from contourlab.components.plant.plant import RigidAxis
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.errors import ComponentError

T = 1e-3
RIGID = RigidAxis(gain=0.9, damping=10.0)
LAGGING = SecondOrderIntegrator(dc_gain=0.8, damping_ratio=1.1, natural_frequency=150.0)
SEEN = FilteredDifference(bandwidth=800.0)
LAG: dict[str, Any] = {"velocity_feedforward": 0.0, "acceleration_feedforward": 0.0}
TUNED: dict[str, Any] = {**Cascade.tune(200.0, 1.0, 0.9, 10.0), **LAG}
SLOW: dict[str, Any] = {**Cascade.tune(70.0, 1.0, 0.9, 10.0), **LAG}
IPV = PositionController(**PositionController.place(50.0, 0.7, 70.0, 0.9, 10.0), structure="ipv")
PLACED = StateFeedback(**StateFeedback.place_rigid([-60.0 + 60.0j, -60.0 - 60.0j], 0.9, 10.0), following="position")
FULL: dict[str, Any] = {"proportional_gain": 15.0, "integral_gain": 20.0, "derivative_gain": 0.1, "derivative_bandwidth": 500.0}

LOOPS = [
    pytest.param(RIGID, 0.0, cl.AxisController(Cascade(**TUNED), TrueVelocity()), id="cascade"),
    pytest.param(RIGID, 2e-3, cl.AxisController(Cascade(**SLOW), SEEN), id="cascade-late"),
    pytest.param(RIGID, 0.0, cl.AxisController(LeadLag(**LeadLag.design(math.radians(60.0), 120.0, 0.9, 10.0))), id="lead-lag"),
    pytest.param(RIGID, 0.0, cl.AxisController(IPV, SEEN, DisturbanceObserver(model_gain=0.9, model_damping=10.0)), id="observer"),
    pytest.param(RIGID, 0.0, cl.AxisController(PLACED, TrueVelocity()), id="placed"),
    pytest.param(LAGGING, 15e-3, cl.AxisController(PID(proportional_gain=15.0)), id="late-15"),
    pytest.param(LAGGING, 15e-3, cl.AxisController(PID(**FULL)), id="late-15-pid"),
    pytest.param(LAGGING, 60e-3, cl.AxisController(PID(proportional_gain=5.0)), id="late-60"),
    pytest.param(LAGGING, 15.3e-3, cl.AxisController(PID(proportional_gain=15.0)), id="late-15.3"),
    pytest.param(LAGGING, 3.7e-3, cl.AxisController(PID(proportional_gain=20.0, integral_gain=30.0)), id="late-3.7"),
]


def response(made: ZPETC, angle: np.ndarray) -> np.ndarray:
    """Return F at z = exp(i angle)."""
    z = np.exp(1j * angle)
    return z**made.lead * np.polyval(made.numerator[::-1], 1.0 / z) / np.polyval(made.denominator[::-1], 1.0 / z)


def axis(plant: Any, delay: float, name: str = "x") -> cl.Axis:
    return cl.Axis(name, plant, drive=DelayedSaturation(delay=delay) if delay else Saturation())


@pytest.mark.parametrize(("plant", "delay", "servo"), LOOPS)
def test_the_phase_is_zero_at_every_frequency(plant: Any, delay: float, servo: cl.AxisController) -> None:
    """F G is real and positive over the whole range, up to the rounding of F's coefficients, and 1 at rest to second order."""
    loop = sampled_loop(axis(plant, delay), servo, T)
    made = zpetc_design(loop)
    w = np.concatenate([loop.frequencies(200), np.linspace(1.0, loop.nyquist, 200)])
    product = response(made, w * T) * loop.response(w).modified
    rounding = 10.0 * 2.2e-16 * np.abs(made.numerator).sum() / abs(sum(made.numerator))
    assert np.abs(product.imag).max() < rounding
    assert product.real.min() > -rounding
    assert product[0].real == pytest.approx(1.0, abs=max(rounding, 1e-4))


@pytest.mark.parametrize(("plant", "delay", "servo"), LOOPS)
def test_the_filter_looks_ahead_by_the_delay_of_the_loop(plant: Any, delay: float, servo: cl.AxisController) -> None:
    """The whole ticks of the drive's delay, one for the hold, and one for each mirrored zero."""
    made = zpetc_design(sampled_loop(axis(plant, delay), servo, T))
    assert made.lead >= math.floor(delay / T + 1e-9) + 1
    assert made.ahead(T) == made.lead


def test_zeros_of_the_hold_are_those_of_sampling() -> None:
    """For 1/s^3 with a hold: -2 - sqrt 3 and its inverse (Astrom, Hagander & Sternby 1984), for T small against the lag."""
    period = 1e-4
    made = zpetc_design(sampled_loop(axis(LAGGING, 0.0), cl.AxisController(PID(proportional_gain=15.0)), period))
    inner = -2.0 + math.sqrt(3.0)
    assert np.abs(np.roots(made.denominator) - inner).min() < 0.01
    # The outer zero is mirrored: F contains its inverse.
    assert np.abs(np.roots(made.numerator) - inner).min() < 0.01


def test_a_run_confirms_the_gain_and_the_zero_phase() -> None:
    """On a circle each axis follows the reference times the gain, in phase: the error is radial, (1 - gain) R."""
    radius, frequency, delay = 0.02, 4.0, 5e-3
    servo = cl.AxisController(PID(proportional_gain=20.0), TrueVelocity())
    made = zpetc_design(sampled_loop(axis(LAGGING, delay), servo, T))
    reference = cl.uniform(cl.contour("circle", radius=radius), frequency, 8, T)
    errors = []
    for part in (None, made):
        axes = tuple(axis(LAGGING, delay, name) for name in "xy")
        mine = cl.AxisController(servo.controller, servo.velocity, feedforward=part)
        found = cl.simulate(cl.Machine("led", axes, T), cl.Controller(dict.fromkeys("xy", mine)), reference)
        # The last ticks lack the reference beyond the end.
        last = slice(6 * found.n_sample // 8, found.n_sample - 2 * int(made.lead))
        away = found["axis_position"][last] - found["reference"][last]
        around = found["reference"][last] - found["reference"].mean(axis=0)
        errors.append((away, around))
    turn = np.array([2.0 * math.pi * frequency])
    loop = sampled_loop(axis(LAGGING, delay), servo, T)
    left = float(1.0 - (response(made, turn * T) * loop.response(turn).modified)[0].real)
    away, around = errors[1]
    assert away == pytest.approx(-left * around, abs=2e-7 * radius)
    assert np.abs(errors[0][0]).max() > 0.5 * radius


# --- polynomials ---------------------------------------------------------------------------------------------------------------------

inside = st.complex_numbers(max_magnitude=0.7, allow_nan=False, allow_infinity=False)
anywhere = st.complex_numbers(min_magnitude=0.0, max_magnitude=3.0, allow_nan=False, allow_infinity=False)


def pairs(points: list[complex]) -> np.ndarray:
    return np.real(np.poly([root for point in points for root in (point, point.conjugate())])) if points else np.ones(1)


@settings(max_examples=100, deadline=None)
@given(st.lists(inside, max_size=2), st.lists(anywhere, max_size=2), st.integers(0, 20), st.floats(0.1, 0.99))
def test_the_phase_is_zero_for_any_loop(poles: list[complex], zeros: list[complex], delay: int, radius: float) -> None:
    a, b = pairs(poles), pairs(zeros)
    # Zeros near 1, and cancelled zeros near the circle, cost digits: within these bounds six of sixteen, (2.4/0.4)^4 (1.7/0.3)^4.
    assume(all(abs(1.0 - zero) > 0.4 and (abs(abs(zero) - 1.0) > 0.1 or zero.real <= 0.0) for zero in zeros))
    b = b * (a.sum() / b.sum())
    made = zero_phase_filter(b, a, delay, radius=radius)
    angle = np.linspace(0.0, math.pi, 50)
    z = np.exp(1j * angle)
    loop = z ** -float(delay) * np.polyval(b[::-1], 1.0 / z) / np.polyval(a[::-1], 1.0 / z)
    product = response(made, angle) * loop
    assert np.abs(product.imag).max() < 1e-8 * np.abs(product).max()
    assert product.real.min() > -1e-8 * np.abs(product).max()
    assert product[0] == pytest.approx(1.0, abs=1e-9)
    cancelled = np.roots(made.denominator)
    assert ((np.abs(cancelled) < 1.0) & ((cancelled.real > -1e-12) | (np.abs(cancelled) <= radius * (1.0 + 1e-6)))).all()


def test_the_filter_of_a_loop_by_hand() -> None:
    """G = z^-1 (1 + 2 z^-1) 0.1/(1 - 0.7 z^-1), zero at -2: F = (1 - 0.7 z^-1)(1 + 2 z) z/0.9, from Tomizuka's eq by hand."""
    made = zero_phase_filter([0.1, 0.2], [1.0, -0.7], 1)
    assert made.lead == 2
    assert made.numerator == pytest.approx(np.array([2.0, 1.0 - 1.4, -0.7]) / 0.9, rel=1e-12)
    assert made.denominator == pytest.approx([1.0])


# --- refusals ------------------------------------------------------------------------------------------------------------------------


def test_derivative_feedforward_is_refused() -> None:
    servo = cl.AxisController(Cascade(**{**TUNED, "velocity_feedforward": 1.0}), TrueVelocity())
    with pytest.raises(ComponentError, match="acceleration"):
        zpetc_design(sampled_loop(axis(RIGID, 0.0), servo, T))


def test_an_unstable_loop_is_refused() -> None:
    with pytest.raises(ComponentError, match="unstable"):
        zpetc_design(sampled_loop(axis(LAGGING, 15e-3), cl.AxisController(PID(proportional_gain=500.0)), T))


def test_impossible_polynomials_are_refused() -> None:
    with pytest.raises(ComponentError, match="at rest"):
        zero_phase_filter([0.1], [1.0, -0.7])
    with pytest.raises(ComponentError, match="9 zeros"):
        zero_phase_filter(np.poly(np.full(9, 0.5)) * 0.3 / 0.5**9, [1.0, -0.7])
