"""Integral sliding mode and super-twisting against their laws, closed forms, and the disturbance observer."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, Array, make, run_alone
from hypothesis import given
from hypothesis import strategies as st
from one_axis import A_HAT, B_HAT, W_D, axis, controller, observer
from scipy.linalg import expm

from contourlab.analysis.linear.sampled_loop import lane_loops, sampled_loop
from contourlab.components.contract import Component
from contourlab.errors import ComponentError

A, B = 0.8, 12.0
VELOCITY, APPLIED = 0.01 * np.random.default_rng(3).normal(size=(2, 300)).cumsum(axis=1)


def integral_sliding(**values: Any) -> Component:
    made: Component = make("observer", "integral-sliding", **{"model_gain": A, "model_damping": B, **values})
    return made


def super_twisting(rate: float) -> Component:
    made: Component = make("observer", "super-twisting", model_gain=A, model_damping=B, disturbance_rate=rate)
    return made


def seen(part: Component, disturbance: Array, period: float = PERIOD, jit: bool = True) -> Array:
    """Return the estimate (n_tick,) on an axis held at rest: the commands that hold it are the disturbance, each seen a tick late."""
    fed = {"velocity": np.zeros(len(disturbance)), "applied": -np.append(0.0, disturbance[:-1])}
    return run_alone(part, fed, period=period, jit=jit)["disturbance_estimate"]


# --- integral sliding mode -----------------------------------------------------------------------------------------------------------


def test_inside_the_layer_it_is_the_disturbance_observer_without_its_filter() -> None:
    model = {"bandwidth": 150.0, "model_gain": A, "model_damping": B}
    expected = run_alone(
        make("observer", "disturbance-observer", filter_bandwidth=1e9, **model), {"velocity": VELOCITY, "applied": APPLIED}
    )
    most = np.abs(expected["disturbance_estimate"]).max()
    for limit in (math.inf, 1.01 * most):
        found = run_alone(integral_sliding(bandwidth=150.0, limit=limit), {"velocity": VELOCITY, "applied": APPLIED})
        assert found["disturbance_estimate"] == pytest.approx(expected["disturbance_estimate"], abs=1e-5 * most)


def test_it_is_the_law_of_utkin_and_shi_inside_the_layer_and_beyond() -> None:
    """s = (v - z)/a, z' = a (u + d_hat) - b v, d_hat = M sat(s/phi), with z by Euler; M/phi = w_d/(1 + w_d T)."""
    limit, bandwidth = 1.0, 150.0
    found = run_alone(integral_sliding(bandwidth=bandwidth, limit=limit), {"velocity": VELOCITY, "applied": APPLIED})
    z, estimate, expected = 0.0, 0.0, []
    for v, u in zip(VELOCITY, APPLIED, strict=True):
        z += PERIOD * (A * (u + estimate) - B * v)
        estimate = min(max((v - z) / A * bandwidth / (1.0 + bandwidth * PERIOD), -limit), limit)
        expected.append(estimate)
    assert found["disturbance_estimate"] == pytest.approx(np.array(expected), abs=1e-12)
    assert 0.1 < np.mean(np.abs(expected) == limit) < 0.9


def test_a_relay_sees_a_disturbance_one_tick_late_and_remembers_what_was_beyond_its_limit() -> None:
    """w_d -> inf: d_hat(k) = d(k - 1). Of d = 3 M for 20 ticks it owes 2 M each, and pays M each: 40 ticks."""
    relay, wave = integral_sliding(bandwidth=1e12, limit=0.1), 0.09 * np.sin(np.arange(200.0))
    assert seen(relay, wave)[1:] == pytest.approx(wave[:-1], abs=1e-9)
    found = seen(relay, np.repeat([0.3, 0.0], [20, 80]))
    assert found[1:61] == pytest.approx(np.full(60, 0.1), abs=1e-9)
    assert found[62:] == pytest.approx(np.zeros(38), abs=1e-8)


def test_margins_are_those_inside_the_layer() -> None:
    expected = sampled_loop(axis(), controller(seen=observer(filter_bandwidth=1e9)), PERIOD).margins()
    part = integral_sliding(bandwidth=W_D, model_gain=A_HAT, model_damping=B_HAT, limit=0.01)
    found = sampled_loop(axis(), controller(seen=part), PERIOD).margins()
    assert (found.modulus, found.gain) == (pytest.approx(expected.modulus, rel=1e-5), pytest.approx(expected.gain, rel=1e-5))
    limits = {"controller.axes.x.observer.limit": np.array([0.01, 0.02]), "axes.x.drive.limit": np.array([0.1, 0.2])}
    varied = lane_loops(axis(), controller(seen=part), PERIOD, 0.0, limits).margins()
    assert varied.modulus == pytest.approx(np.full(2, expected.modulus), rel=0.01)


# --- super-twisting ------------------------------------------------------------------------------------------------------------------


def longest(rate: float, jump: float) -> float:
    """Return a bound on the time to d_hat = d after a jump, under the worst disturbance.

    In r = sqrt(s) and y = d - w, with the time scaled by r, r' = (y - k_1 r)/2 and y' = -(k_2 -+ L) r: linear while s > 0. The widest way
    around has k_2 - L while s rises and k_2 + L while it falls; it returns to s = 0 with y = -q times the jump. Since abs(y') >= k_2 - L,
    the half turns take at most (1 + q)(1 + q + q^2 + ...) jump/(k_2 - L).
    """

    def matrix(fall: float) -> Array:
        return np.array([[-0.75, 0.5], [-fall, 0.0]])  # L = 1

    def until(state: Array, fall: float, done: Any) -> Array:
        little = expm(1e-4 * matrix(fall))
        while not done(state):
            state = little @ state
        return state

    top = until(np.array([1e-9, 1.0]), 0.1, lambda state: state[1] < 1.5 * state[0])
    q = -until(top, 2.1, lambda state: state[0] < 0.0)[1]
    return float((1.0 + q) / (1.0 - q) * jump / (0.1 * rate))


def worst(rate: float, jump: float, time: float, fine: float) -> Array:
    """Return the disturbance that leads the continuous law the widest way around, by explicit Euler."""
    s, w, d, found = 0.0, 0.0, jump, []
    for _ in range(round(time / fine)):
        found.append(d)
        slope = d - w - 1.5 * math.sqrt(rate * abs(s)) * math.copysign(1.0, s)
        w += fine * 1.1 * rate * math.copysign(1.0, s)
        s += fine * slope
        d += fine * rate * math.copysign(1.0, slope)
    return np.array(found)


@pytest.mark.parametrize(("rate", "jump"), [(5.0, 0.05), (2.0, -0.06)])
def test_it_converges_in_finite_time_within_the_bound_under_the_worst_disturbance(rate: float, jump: float) -> None:
    bound = longest(rate, abs(jump))
    assert bound == pytest.approx(33.2 * abs(jump) / rate, rel=0.01)
    disturbance = worst(rate, jump, bound, PERIOD / 20.0)[::20]
    off = np.abs(seen(super_twisting(rate), disturbance)[1:] - disturbance[:-1])
    settled = int(np.flatnonzero(off > rate * PERIOD)[-1])
    assert 0.05 * bound < settled * PERIOD < bound - 0.01


@given(slopes=st.lists(st.floats(-1.0, 1.0), min_size=20, max_size=60), jump=st.floats(0.0, 0.02))
def test_after_that_it_rejects_every_lipschitz_disturbance_but_for_one_tick(slopes: list[float], jump: float) -> None:
    """d_hat(k) = d(k - 1): without a jump from the start."""
    rate = 20.0
    wait = 0 if jump == 0.0 else math.ceil(34.0 * jump / rate / PERIOD)
    disturbance = jump + rate * PERIOD * np.cumsum([*np.zeros(wait), *slopes])
    found = seen(super_twisting(rate), disturbance, jit=False)
    assert found[wait + 1 :] == pytest.approx(disturbance[wait:-1], abs=1e-9)


def test_what_is_left_falls_with_the_tick() -> None:
    """L T at most, and nothing at a steady disturbance: no chatter."""
    rate, left = 5.0, []
    for period in (2e-3, 1e-3, 5e-4, 2.5e-4):
        t = period * np.arange(round(0.5 / period))
        wave = rate / 40.0 * np.sin(40.0 * t)
        left.append(np.abs(seen(super_twisting(rate), wave, period) - wave)[2:].max())
        steady = seen(super_twisting(rate), np.full(len(t), 0.01), period)
        assert np.abs(steady[round(0.2 / period) :] - 0.01).max() < 1e-12
    assert left == pytest.approx(rate * np.array([2e-3, 1e-3, 5e-4, 2.5e-4]), rel=0.01)


def test_there_are_no_margins() -> None:
    assert super_twisting(5.0).linearize() is None
    with pytest.raises(ComponentError, match=r"x\.observer"):
        sampled_loop(axis(), controller(seen=super_twisting(5.0)), PERIOD)
