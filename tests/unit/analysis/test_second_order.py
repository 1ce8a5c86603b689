"""Closed forms of the axis of second order against eq (5) of Gecer Ulu et al. and an independent solver."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import signal

from contourlab.analysis.second_order import held_response, impulse_response, position_step, velocity_step

RATIOS = [0.02, 0.5, 0.999999, 1.0, 1.000001, 1.1, 20.0]


@given(zeta=st.floats(1.001, 20.0), wn=st.floats(1.0, 1e4), at=st.floats(1e-3, 10.0))
def test_an_impulse_gives_equation_5(zeta: float, wn: float, at: float) -> None:
    t, root = at / wn, math.sqrt(zeta**2 - 1.0)
    slow, fast = (math.exp(-(zeta - way * root) * wn * t) for way in (1.0, -1.0))
    exact = wn / (2.0 * root) * (slow - fast)
    assert float(impulse_response(t, zeta, wn)) == pytest.approx(exact, rel=1e-9, abs=1e-11 * wn)


@pytest.mark.parametrize("zeta", RATIOS)
def test_steps_are_those_of_the_transfer_function(zeta: float) -> None:
    wn, t = 150.0, np.linspace(0.0, 0.2, 300)
    for power, found in ((0, velocity_step(t, zeta, wn)), (1, position_step(t, zeta, wn))):
        bottom = np.polymul([1.0, 2.0 * zeta * wn, wn * wn], [1.0] + [0.0] * power)
        _, exact = signal.step(([wn * wn], bottom), T=t)
        assert found == pytest.approx(exact, abs=2e-10 * (1.0 if power == 0 else 0.2) * (1e3 if abs(zeta - 1.0) < 1e-3 else 1.0))


@pytest.mark.parametrize("zeta", RATIOS)
def test_a_step_starts_as_its_series_says(zeta: float) -> None:
    """wn^2 t^2/2 and wn^2 t^3/6: differences of nearly equal numbers would show here."""
    t = 1e-7
    assert float(velocity_step(t, zeta, 150.0)) == pytest.approx(0.5 * (150.0 * t) ** 2, rel=1e-3)
    assert float(position_step(t, zeta, 150.0)) == pytest.approx((150.0 * t) ** 2 * t / 6.0, rel=1e-3)


@settings(max_examples=15, deadline=None)
@given(zeta=st.floats(0.05, 5.0), late=st.floats(0.0, 0.02), seed=st.integers(0, 99), of=st.sampled_from(["velocity", "position"]))
def test_any_command_is_a_sum_of_steps(zeta: float, late: float, seed: int, of: str) -> None:
    """Many jumps and few take different ways through the code; a state-space simulation of the delayed command takes a third."""
    rng, period, n = np.random.default_rng(seed), 1e-3, 60
    command = rng.normal(size=n)
    found = held_response(command, period, zeta, 150.0, late, of=of)
    parts = sum(held_response(np.where(np.arange(n) == k, command, 0.0), period, zeta, 150.0, late, of=of) for k in range(n))
    assert found == pytest.approx(parts, abs=1e-13)
    fine = 20
    shifted = np.concatenate([np.zeros(round(late / period * fine)), np.repeat(command, fine)])[: n * fine]
    bottom = np.polymul([1.0, 300.0 * zeta, 22500.0], [1.0] if of == "velocity" else [1.0, 0.0])
    sampled = signal.StateSpace(*signal.tf2ss([22500.0], bottom)).to_discrete(period / fine, method="zoh")
    _, exact, _ = signal.dlsim(sampled, np.r_[shifted, 0.0])
    # The fine grid holds the delay to a fortieth of a period.
    jump = 150.0 * period / fine * np.abs(np.diff(command, prepend=0.0)).sum() * (1.0 if of == "velocity" else period * n)
    assert np.abs(found - exact[: n * fine : fine, 0]).max() <= jump
