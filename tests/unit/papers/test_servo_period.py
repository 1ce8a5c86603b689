"""Largest servo period: closed forms of Jury's conditions."""

from __future__ import annotations

import math

import pytest
from backlash_loops import J_M, K_S, PAPER, SCHEME_II, SCHEME_III, drive
from hypothesis import given, settings
from hypothesis import strategies as st

from contourlab.papers.shahin.servo_period import LONGEST, servo_period_limit
from contourlab.papers.shahin.two_inertia_loop import Feedback, motor_pid, p_pi_cascade


@pytest.mark.parametrize("feedback", [SCHEME_II, SCHEME_III])
def test_the_schemes_of_the_paper_need_ten_microseconds(feedback: Feedback) -> None:
    """K_1'/J_m = 1.92e5 1/s: above 2 J_m/K_1' = 10.4 us a held command oscillates, in the gap and in contact."""
    gap, contact = servo_period_limit(PAPER, feedback)
    assert gap == pytest.approx(2.0 * J_M / 1000.0, rel=1e-5)
    assert contact == pytest.approx(1.04e-5, rel=1e-3)


def test_scheme_one_follows_the_load_in_the_gap() -> None:
    """K_4 = 10^4 1/s on the acceleration: 2/K_4 = 200 us."""
    gap, _ = servo_period_limit(PAPER, Feedback((J_M * 2000.0, J_M * 1e4, -J_M * 2000.0, -J_M * 1e4)))
    _, contact = servo_period_limit(PAPER, Feedback((J_M * 2000.0, J_M * 1e4, 0.0, 0.0)))
    assert gap == pytest.approx(2e-4, rel=1e-6)
    assert contact < 2e-4


@settings(max_examples=8, deadline=None)
@given(proportional=st.floats(1.0, 1e4), derivative=st.floats(0.05, 500.0))
def test_jury_on_a_held_pd(proportional: float, derivative: float) -> None:
    """Held PD on an inertia: stable for T < 2 J/K_d and T < 2 K_d/K_p."""
    wanted = min(2.0 * J_M / derivative, 2.0 * derivative / proportional)
    gap, _ = servo_period_limit(PAPER, motor_pid(proportional, derivative))
    assert gap == (pytest.approx(wanted, rel=1e-5) if wanted < LONGEST else math.inf)


def test_integrals_and_cascades() -> None:
    """As the period goes to 0 the sampled loop becomes the continuous one."""
    assert min(servo_period_limit(PAPER, p_pi_cascade(100.0, 5.0, 50.0))) > 0.0
    assert servo_period_limit(PAPER, p_pi_cascade(1.1 * K_S / 5.0, 5.0))[1] == 0.0


def test_a_slow_loop_is_stable_at_every_period() -> None:
    """A motor with a velocity loop of 1 1/s and viscous friction."""
    assert servo_period_limit(drive(motor_damping=0.1), Feedback((0.0, 1e-3, 0.0, 0.0)))[0] == math.inf
