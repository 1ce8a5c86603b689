"""Largest servo period: closed forms of Jury's conditions, and brute force over periods."""

from __future__ import annotations

import math

import numpy as np
import pytest
from backlash_loops import J_M, K_S, PAPER, SCHEME_II, SCHEME_III, drive
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import expm

from contourlab.errors import ParameterError
from contourlab.papers.shahin.servo_period import servo_period_limit
from contourlab.papers.shahin.two_inertia_loop import Feedback, motor_pid, p_pi_cascade


@pytest.mark.parametrize("feedback", [SCHEME_II, SCHEME_III])
def test_the_papers_schemes_need_ten_microseconds(feedback: Feedback) -> None:
    """K_1'/J_m = 1.92e5 1/s: a held command swings above 2 J_m/K_1' = 10.4 us, in the gap as in contact."""
    gap, contact = servo_period_limit(PAPER, feedback)
    assert gap.largest == pytest.approx(2.0 * J_M / 1000.0, rel=1e-5)
    assert contact.largest == pytest.approx(1.04e-5, rel=1e-3)
    # The free load is told apart: two zeros, neither moved nor seen.
    assert gap.free == (0.0, 0.0)
    assert contact.free == ()


def test_scheme_one_follows_the_load_in_the_gap() -> None:
    """K_4 = 10^4 1/s on the acceleration: 2/K_4 = 200 us."""
    gap = Feedback((J_M * 2000.0, J_M * 1e4, -J_M * 2000.0, -J_M * 1e4))
    contact = Feedback((J_M * 2000.0, J_M * 1e4, 0.0, 0.0))
    limits = servo_period_limit(PAPER, gap, contact)
    assert limits[0].largest == pytest.approx(2e-4, rel=1e-6)
    assert limits[1].largest < 2e-4


@settings(max_examples=8, deadline=None)
@given(proportional=st.floats(1.0, 1e4), derivative=st.floats(0.05, 500.0))
def test_jury_on_a_held_pd(proportional: float, derivative: float) -> None:
    """Held PD on an inertia: stable for T < 2 J/K_d and T < 2 K_d/K_p, and at no other period."""
    wanted = min(2.0 * J_M / derivative, 2.0 * derivative / proportional)
    gap, _ = servo_period_limit(PAPER, motor_pid(proportional, derivative), longest=min(20.0 * wanted, 0.5))
    assert gap.largest == pytest.approx(wanted, rel=1e-5)
    assert len(gap.windows) == 1


def test_one_period_of_delay() -> None:
    """Velocity loop with the command a period late: z^2 - z + K T/J, stable for K T/J < 1."""
    velocity_only = Feedback((0.0, 4.0, 0.0, 0.0))
    gap, _ = servo_period_limit(PAPER, velocity_only, delay=1)
    assert gap.largest == pytest.approx(J_M / 4.0, rel=1e-5)
    later, _ = servo_period_limit(PAPER, velocity_only, delay=2)
    # z^3 - z^2 + q: on the circle at q = 2 sin(18 deg).
    assert later.largest == pytest.approx(2.0 * math.sin(math.radians(18.0)) * J_M / 4.0, rel=1e-5)


def test_all_windows_are_found() -> None:
    """A load-side position loop on a resonance: at every period of a dense list the windows say what the eigenvalues say."""
    plant = drive(shaft_damping=0.02, load_damping=0.005, motor_damping=0.02)
    feedback = Feedback((0.0, 0.3, 20.0, 0.0))
    _, contact = servo_period_limit(plant, feedback, longest=0.08)
    assert len(contact.windows) > 1
    a, b = plant.contact_a, plant.command
    rng = np.random.default_rng(1)
    for period in np.sort(rng.uniform(1e-4, 0.08, 800)):
        held = expm(np.block([[a, b[:, None]], [np.zeros((1, 5))]]) * period)
        radius = np.abs(np.linalg.eigvals(held[:4, :4] - np.outer(held[:4, 4], feedback.gain))).max()
        if abs(radius - 1.0) > 1e-7:
            inside = any(low <= period <= high for low, high in contact.windows)
            assert inside == (radius < 1.0), period


def test_integrals_and_cascades() -> None:
    """As the period goes to 0 the sampled loop is the continuous one: a cascade that is stable has a window from 0 on."""
    limits = servo_period_limit(PAPER, p_pi_cascade(100.0, 5.0, 50.0))
    assert all(limit.windows[0][0] == 0.0 < limit.largest for limit in limits)
    unstable = servo_period_limit(PAPER, p_pi_cascade(1.1 * K_S / 5.0, 5.0))[1]
    assert unstable.largest == 0.0
    assert "no servo period" in str(unstable)


def test_bad_requests_are_refused() -> None:
    with pytest.raises(ParameterError, match="longest"):
        servo_period_limit(PAPER, SCHEME_II, longest=0.0)
    with pytest.raises(ParameterError, match="delay"):
        servo_period_limit(PAPER, SCHEME_II, delay=-1)
