"""Limit cycles by the describing function: closed forms of the load-side cascade, all solutions, stability and validity."""

from __future__ import annotations

import math

import numpy as np
import pytest
from backlash_loops import HALF_GAP, J_L, K_S, PAPER, SCHEME_II, drive
from hypothesis import given, settings
from hypothesis import strategies as st

from contourlab.analysis.backlash.lure import BacklashLoop, harmonic, predict_limit_cycles, real_frequencies
from contourlab.papers.shahin.two_inertia_loop import p_pi_cascade, two_inertia_loop


@settings(max_examples=25, deadline=None)
@given(velocity_gain=st.floats(0.3, 30.0), share=st.floats(0.01, 0.99))
def test_lossless_load_side_cascade_in_closed_form(velocity_gain: float, share: float) -> None:
    """G is real only at w = sqrt(K_p K_v/J_l), where it is -1/(K_p K_v): the amplitude is that of N = K_p K_v."""
    position_gain = share * K_S / velocity_gain
    found = predict_limit_cycles(two_inertia_loop(PAPER, p_pi_cascade(position_gain, velocity_gain)))
    assert len(found) == 1
    assert found[0].frequency == pytest.approx(math.sqrt(share * K_S / J_L), rel=1e-9)
    assert complex(harmonic(found[0].ratio, 0.0)).real == pytest.approx(share, rel=1e-6, abs=1e-9)
    assert found[0].amplitude == pytest.approx(found[0].ratio * HALF_GAP)


def test_beyond_the_stiffness_there_is_no_limit_cycle() -> None:
    """K_p K_v > k: contact itself is unstable, and no amplitude has such a large N."""
    assert predict_limit_cycles(two_inertia_loop(PAPER, p_pi_cascade(200.0, 5.0))) == ()
    assert predict_limit_cycles(two_inertia_loop(PAPER, SCHEME_II)) == ()


def test_all_solutions_are_found() -> None:
    """A locus that crosses the real axis twice beyond -1/k has two cycles, one of them stable."""
    # 120 (s + 1)^2/s^3 with two lags of 1/40 s is stable only for a range of gains.
    numerator, denominator = 120.0 * np.poly([-1.0, -1.0]), np.poly([0.0, 0.0, 0.0, -40.0, -40.0]) / 1600.0
    a = np.vstack([-denominator[1:] / denominator[0], np.eye(4, 5)])
    b = np.eye(5)[0]
    c = np.concatenate([np.zeros(2), numerator / denominator[0]])
    loop = BacklashLoop(a, b, c, stiffness=1.0, half_gap=1.0)
    w = np.logspace(-2, 3, 200_001)
    gain = loop.transfer(w)
    on_grid = w[:-1][(gain.imag[1:] > 0.0) != (gain.imag[:-1] > 0.0)]
    assert real_frequencies(loop) == pytest.approx(on_grid, rel=1e-4)
    cycles = predict_limit_cycles(loop)
    assert len(cycles) == 2
    # The gain rises with the amplitude. Above the larger cycle it exceeds the stable range, so the amplitude grows. Below the smaller
    # one it is under the range, so the amplitude grows too, until it returns.
    assert [cycle.stable for cycle in cycles] == [False, True]
    for cycle in cycles:
        assert 1.0 + complex(harmonic(cycle.ratio, 0.0)) * complex(loop.transfer(cycle.frequency)) == pytest.approx(0.0, abs=1e-8)


@pytest.mark.slow
def test_shaft_damping_moves_the_cycle_continuously() -> None:
    """The grid search for little damping finds the closed-form solution; both solve 1 + N G = 0."""
    for feedback in (p_pi_cascade(120.0, 5.0), p_pi_cascade(30.0, 2.0)):
        plain = predict_limit_cycles(two_inertia_loop(PAPER, feedback))
        damped = predict_limit_cycles(two_inertia_loop(drive(shaft_damping=1e-6), feedback))
        assert len(damped) == len(plain) == 1
        assert damped[0].frequency == pytest.approx(plain[0].frequency, rel=1e-4)
        assert damped[0].ratio == pytest.approx(plain[0].ratio, rel=1e-4)
        assert damped[0].stable == plain[0].stable


def test_validity_is_a_number_and_words() -> None:
    """A cycle of 24 half-gaps is nearly sinusoidal, one of 1.2 is not. A cycle whose phase hardly turns may not exist."""
    large = predict_limit_cycles(two_inertia_loop(PAPER, p_pi_cascade(180.0, 5.0)))[0]
    small = predict_limit_cycles(two_inertia_loop(PAPER, p_pi_cascade(30.0, 2.0)))[0]
    doubtful = predict_limit_cycles(two_inertia_loop(PAPER, p_pi_cascade(60.0, 1.0, 1700.0, "motor")))[0]
    assert large.validity.startswith("good")
    assert small.validity.startswith("poor")
    assert large.harmonics < 0.01 < 0.1 < small.harmonics
    # Its harmonics are small and its amplitude is large, yet shooting finds no such orbit.
    assert doubtful.harmonics < 0.05
    assert doubtful.ratio > 4.0
    assert doubtful.uncertainty > 1.0
    assert doubtful.validity.startswith("poor")
