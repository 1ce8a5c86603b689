"""Matrices of loops with a gap, against hand-written ones."""

from __future__ import annotations

import numpy as np
import pytest
from backlash_loops import J_L, J_M, K_S, PAPER, SCHEME_III, drive, paper_loop
from refusals import refuses

from contourlab.analysis.backlash.lure import dead_zone
from contourlab.errors import ParameterError
from contourlab.papers.shahin.two_inertia_loop import Feedback, motor_pid, p_pi_cascade, two_inertia_loop


def test_the_modes_of_the_paper() -> None:
    """Gap: the motor's two poles and the free load's two zeros; contact: 464.7 rad/s with a damping of 0.475 1/s."""
    loop = paper_loop()
    gap = np.sort(np.linalg.eigvals(loop.gap_matrix).real)
    assert gap == pytest.approx([-1000.0 / J_M, -0.2, 0.0, 0.0], rel=3e-6, abs=1e-12)
    pair = max(np.linalg.eigvals(loop.contact_matrix), key=lambda pole: pole.imag)
    assert pair.imag == pytest.approx(464.7, abs=0.05)
    assert pair.real == pytest.approx(-0.475, abs=5e-4)


def test_transfer_of_a_motor_controller() -> None:
    """G = s/(J_m s^3 + K_d s^2 + K_p s + K_i) + 1/(s (J_l s + c_l))."""
    c_l = 0.03
    loop = two_inertia_loop(drive(load_damping=c_l), SCHEME_III)
    s = 1j * np.logspace(-2, 6, 50)
    wanted = s / (J_M * s**3 + 1000.0 * s**2 + 200.0 * s + 25.0) + 1.0 / (s * (J_L * s + c_l))
    assert loop.transfer(s.imag) == pytest.approx(wanted, rel=1e-9)


def test_transfer_of_a_load_side_cascade() -> None:
    """G = ((J_m + J_l) s^2 + K_p s + K_p K_v)/(J_l s^3 (J_m s + K_p))."""
    kv, kp = 30.0, 2.0
    loop = two_inertia_loop(PAPER, p_pi_cascade(kv, kp))
    s = 1j * np.logspace(0, 4, 50)
    wanted = ((J_M + J_L) * s**2 + kp * s + kp * kv) / (J_L * s**3 * (J_M * s + kp))
    assert loop.transfer(s.imag) == pytest.approx(wanted, rel=1e-9)


def test_the_cascade_follows_its_reference() -> None:
    """At rest at the reference nothing moves; on a ramp with full velocity feedforward the PI cascade has no lag."""
    loop = two_inertia_loop(drive(motor_damping=0.1), p_pi_cascade(30.0, 2.0, 40.0, "motor", velocity_feedforward=1.0))
    at_rest = np.array([1.0, 0.0, 1.0, 0.0, 0.0])
    assert loop.a @ at_rest + loop.reference_input @ [1.0, 0.0, 0.0] == pytest.approx(np.zeros(5), abs=1e-12)
    moving = np.array([1.0, 0.5, 1.0, 0.5, 0.1 * 0.5 / 40.0])
    assert loop.a @ moving + loop.reference_input @ [1.0, 0.5, 0.0] == pytest.approx([0.5, 0.0, 0.5, 0.0, 0.0], abs=1e-12)


def test_scheme_one_switches_its_controller() -> None:
    """Eqs (10) and (14): in the gap the motor follows the load, in contact the reference."""
    gap = Feedback((J_M * 2000.0, J_M * 1e4, -J_M * 2000.0, -J_M * 1e4))
    contact = Feedback((J_M * 2000.0, J_M * 1e4, 0.0, 0.0))
    loop = two_inertia_loop(PAPER, gap, contact)
    assert loop.gap_matrix[1] == pytest.approx([-2000.0, -1e4, 2000.0, 1e4])
    assert loop.contact_matrix[1] == pytest.approx([-2000.0 - K_S / J_M, -1e4, K_S / J_M, 0.0])
    with refuses(ParameterError, name="contact_a"):
        loop.transfer(1.0)


def test_shaft_damping_acts_in_contact_only() -> None:
    """It damps the relative speed."""
    plain, damped = two_inertia_loop(PAPER, SCHEME_III), two_inertia_loop(drive(shaft_damping=0.2), SCHEME_III)
    assert np.array_equal(plain.gap_matrix, damped.gap_matrix)
    change = damped.contact_matrix - plain.contact_matrix
    assert change[1] == pytest.approx([0.0, -0.2 / J_M, 0.0, 0.2 / J_M, 0.0])
    assert change[3] == pytest.approx([0.0, 0.2 / J_L, 0.0, -0.2 / J_L, 0.0])


def test_dead_zone() -> None:
    assert dead_zone([-2.0, -1.0, 0.3, 1.0, 4.0], 1.0).tolist() == [-1.0, 0.0, 0.0, 0.0, 3.0]


def test_mismatched_controllers_are_refused() -> None:
    with refuses(ParameterError, name="contact_feedback"):
        two_inertia_loop(PAPER, motor_pid(1.0, 1.0), SCHEME_III)
