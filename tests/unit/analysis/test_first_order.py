"""A first-order axis is identified from simulated records, with valid deviations; unidentifiable parameters are reported."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray

from contourlab.analysis.identification.first_order import (
    closed_loop_position,
    delayed,
    first_order_motion,
    identify_closed_loop,
    identify_first_order,
)
from contourlab.errors import ParameterError

Array = NDArray[np.float64]
PERIOD, N = 1e-3, 6000
A, B, FRICTION = 1.695, 10.1, 0.055
TIME = PERIOD * np.arange(N)


def levels(seed: int = 0, hold: int = 100, size: float = 0.6, n: int = N) -> Array:
    return np.repeat(np.random.default_rng(seed).uniform(-size, size, n // hold), hold)


def measured(u: Array, noise: float = 0.0, count: float = 0.0, seed: int = 1, friction: float = FRICTION) -> Array:
    place = A * first_order_motion(u, PERIOD, B, friction, friction)[1] + noise * np.random.default_rng(seed).normal(size=u.size)
    return np.round(place / count) * count if count else place


def test_a_step_without_friction_is_the_closed_form() -> None:
    v, p = first_order_motion(np.ones(500), PERIOD, B)
    t = PERIOD * np.arange(500)
    np.testing.assert_allclose(v, -np.expm1(-B * t) / B, rtol=1e-12, atol=1e-15)
    np.testing.assert_allclose(p, (t + np.expm1(-B * t) / B) / B, rtol=1e-9, atol=1e-15)


def test_without_damping_it_is_a_parabola() -> None:
    v, p = first_order_motion(np.full(300, 0.5), PERIOD, 0.0, 0.1, 0.2)
    t = PERIOD * np.arange(300)
    np.testing.assert_allclose(v, 0.4 * t, rtol=1e-12)
    np.testing.assert_allclose(p, 0.2 * t**2, rtol=1e-9, atol=1e-15)


def test_stopping_is_found_within_the_sample() -> None:
    """A pulse, then nothing: friction alone stops the axis at a closed-form time and place, between two samples."""
    u = np.r_[np.full(40, 1.0), np.zeros(400)]
    v, p = first_order_motion(u, PERIOD, B, 0.3, 0.3)
    speed = 0.7 * -math.expm1(-B * 0.04) / B
    stop = math.log1p(B * speed / 0.3) / B
    way = (speed - 0.3 * stop) / B
    assert np.flatnonzero(v == 0.0)[1] == 40 + math.ceil(stop / PERIOD)
    assert p[-1] - p[40] == pytest.approx(way, rel=1e-10)
    assert not v[60 + int(stop / PERIOD) :].any()


def test_motion_with_friction_agrees_with_fine_steps() -> None:
    u = levels(hold=30, n=900)
    v, p = first_order_motion(u, PERIOD, B, 0.1, 0.2)
    fine, speed, place = 400, 0.0, 0.0
    for k in range(899):
        for _ in range(fine):
            way = np.sign(speed) or (1.0 if u[k] > 0.1 else -1.0 if u[k] < -0.2 else 0.0)
            push = 0.0 if way == 0.0 else u[k] - (0.1 if way > 0 else -0.2) - B * speed
            after = speed + push * PERIOD / fine
            after = 0.0 if speed * after < 0.0 else after
            place, speed = place + 0.5 * (speed + after) * PERIOD / fine, after
        assert abs(v[k + 1] - speed) < 2e-5
    assert place == pytest.approx(p[-1], abs=1e-4 * np.ptp(p))


def test_a_fractional_delay_interpolates_its_neighbours() -> None:
    u = levels()
    np.testing.assert_array_equal(delayed(u, 3.0)[3:], u[:-3])
    np.testing.assert_allclose(delayed(u, 3.25), 0.75 * delayed(u, 3.0) + 0.25 * delayed(u, 4.0), atol=1e-15)


@pytest.mark.parametrize(
    "u", [levels(), 0.4 * np.sign(np.sin(2.0 * math.pi * 0.9 * TIME)) + 0.1 * np.sign(np.sin(2.0 * math.pi * 0.21 * TIME))]
)
def test_an_axis_is_identified(u: Array) -> None:
    fit = identify_first_order(TIME, u, measured(u, count=0.125e-6))
    assert (fit["a"], fit["b"], fit["friction"]) == pytest.approx((A, B, FRICTION), rel=2e-3)
    assert fit["offset"] == pytest.approx(0.0, abs=1e-4) and "delay" not in fit.names
    assert fit.usable and fit.fit > 99.0


def test_delay_offset_and_initial_velocity_are_identified() -> None:
    u = levels()
    whole = np.r_[np.full(500, 0.5), u]
    place = A * first_order_motion(delayed(whole, 4.5) - 0.03, PERIOD, B, FRICTION, FRICTION)[1]
    fit = identify_first_order(TIME, u, place[500:] - place[500])
    assert fit["delay"] == pytest.approx(4.5 * PERIOD, abs=0.15 * PERIOD)
    assert fit["offset"] == pytest.approx(0.03, abs=2e-3) and fit["start"] > 0.0
    assert (fit["a"], fit["b"]) == pytest.approx((A, B), rel=1e-2)


@pytest.mark.slow
def test_the_output_error_fit_is_unbiased_by_noise_and_its_deviations_hold() -> None:
    """Over 25 noisy records the mean lies within its deviation of the truth; an equation-error fit is off by far more."""
    u = levels(n=3000)
    time = TIME[:3000]
    fits = [identify_first_order(time, u, measured(u, 2e-5, seed=seed)) for seed in range(25)]
    b = np.array([fit["b"] for fit in fits])
    deviation = float(np.mean([fit.deviation("b") for fit in fits]))
    assert abs(b.mean() - B) < 4.0 * b.std() / math.sqrt(b.size)
    assert 0.5 < b.std() / deviation < 1.5
    equation = []
    for seed in range(10):
        v = np.diff(measured(u, 2e-5, seed=seed)[::5]) / (5 * PERIOD)
        rows = np.column_stack([v[1:-1], u[::5][1 : v.size - 1], -np.sign(v[1:-1])])
        equation.append(-np.linalg.lstsq(rows, (v[2:] - v[:-2]) / (10 * PERIOD), rcond=None)[0][0])
    assert abs(np.mean(equation) - B) > 20.0 * abs(b.mean() - B)


def test_faults_of_a_record_are_reported() -> None:
    u = levels()
    place = measured(u)
    for arguments, said in (
        ((TIME, u, -place), "other way"),
        ((TIME, np.full(N, 0.3), place), "throughout"),
        ((TIME, u, np.zeros(N)), "moves"),
        ((TIME[:20], u[:20], place[:20]), "at least"),
        ((TIME, u, np.where(TIME > 3.0, np.nan, place)), "finite"),
        ((TIME**1.1, u, place), "evenly"),
        ((TIME, u[:-1], place), "long as"),
    ):
        with pytest.raises(ParameterError, match=said):
            identify_first_order(*arguments)


def test_a_resonance_or_noise_is_not_fitted_silently() -> None:
    u = levels()
    noise = np.cumsum(np.random.default_rng(4).normal(size=N)) * 1e-5
    try:
        fit = identify_first_order(TIME, u, noise)
    except ParameterError:
        return
    assert not fit.usable and fit.findings


GAINS = (4000.0, 100.0)


def test_the_closed_loop_is_eq_18() -> None:
    """The step response of its denominator: poles by the quadratic formula, at the samples."""
    a, b = 0.873, 19.7
    reference = np.r_[np.zeros(10), np.full(490, 1e-3)]
    place = closed_loop_position(reference, PERIOD, a, b, *GAINS)
    poles = np.roots([1.0, b + a * GAINS[1], a * GAINS[0]]).astype(complex)
    t = PERIOD * np.arange(490)
    step = 1.0 + (poles[1] * np.exp(poles[0] * t) - poles[0] * np.exp(poles[1] * t)) / (poles[0] - poles[1])
    np.testing.assert_allclose(place[10:], 1e-3 * step.real, atol=1e-15)


def test_a_loop_with_known_gains_is_identified() -> None:
    reference = levels(3, 200, 1e-4)
    place = closed_loop_position(reference, PERIOD, 0.873, 19.7, *GAINS)
    noisy = np.round((place + 2e-7 * np.random.default_rng(0).normal(size=N)) / 0.125e-6) * 0.125e-6
    fit = identify_closed_loop(TIME, reference, noisy, *GAINS)
    for name, true in (("a", 0.873), ("b", 19.7)):
        assert fit[name] == pytest.approx(true, rel=3e-2)
        assert abs(fit[name] - true) < 4.0 * fit.deviation(name)
    assert fit.fit > 99.0 and fit.usable and not fit.findings


def test_a_slow_reference_does_not_identify_the_loop() -> None:
    reference = 0.02 * (1.0 - np.cos(2.0 * math.pi * 0.05 * TIME))
    noise = 2e-5 * np.random.default_rng(0).normal(size=N)
    fit = identify_closed_loop(TIME, reference, closed_loop_position(reference, PERIOD, 0.873, 19.7, *GAINS) + noise, *GAINS)
    assert fit.findings
    with pytest.raises(ParameterError, match="position_gain"):
        identify_closed_loop(TIME, reference, reference, 0.0, 100.0)
    with pytest.raises(ParameterError, match="throughout"):
        identify_closed_loop(TIME, np.zeros(N), np.zeros(N), *GAINS)
