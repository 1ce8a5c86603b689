"""Circle criterion: against fine grids, closed forms, and motions."""

from __future__ import annotations

import math

import numpy as np
import pytest
from backlash_loops import HALF_GAP, K_S, PAPER, SCHEME_II, drive
from exact_run import simulate_exact
from hypothesis import given, settings
from hypothesis import strategies as st

from contourlab.analysis.backlash.lure import BacklashLoop
from contourlab.papers.shahin.circle_criterion import circle_criterion
from contourlab.papers.shahin.two_inertia_loop import motor_pid, p_pi_cascade, two_inertia_loop

W = np.logspace(-4, 7, 60_001)


def least_on_a_grid(loop: BacklashLoop) -> float:
    """Return the minimum of 1 + k Re G over a fine grid."""
    return float((1.0 + loop.stiffness * loop.transfer(W).real).min())


@settings(max_examples=10, deadline=None)
@given(
    gains=st.tuples(st.floats(20.0, 500.0), st.floats(0.5, 1000.0)),
    load=st.floats(-2.5, 1.0),
    integral=st.sampled_from([0.0, 10.0]),
)
def test_the_minimum_agrees_with_a_grid(gains: tuple[float, float], load: float, integral: float) -> None:
    loop = two_inertia_loop(drive(load_damping=10.0**load), motor_pid(*gains, integral))
    circle = circle_criterion(loop)
    on_grid = least_on_a_grid(loop)
    # A grid can only miss the minimum; an infinite grid would find the limit at infinity, 1.
    assert circle.margin <= on_grid + 1e-9 * abs(on_grid)
    assert circle.margin == pytest.approx(on_grid, rel=1e-3, abs=2e-3)


@pytest.mark.parametrize(("damping", "verdict"), [(2.0, "undecided"), (2.1, "stable"), (3.0, "stable")])
def test_the_circle_criterion_needs_much_damping(damping: float, verdict: str) -> None:
    """Low frequencies: Re G = 1/K_p - J_l/c^2, so c must exceed about sqrt(k J_l) = 2.04."""
    loop = two_inertia_loop(drive(load_damping=damping), SCHEME_II)
    found = circle_criterion(loop)
    assert found.verdict == verdict
    assert (least_on_a_grid(loop) > 0.0) == (verdict == "stable")
    assert found.largest_stiffness == pytest.approx(K_S / (1.0 - found.margin))


def test_it_finds_a_resonance_between_the_points_of_a_grid() -> None:
    """Damping of 1e-9 of the frequency: the dip below -1/k is narrower than the steps of any reasonable grid."""
    w, zeta, gain = 464.7, 1e-9, 2e-11
    a = np.array([[0.0, 1.0, 0.0], [-(w**2), -2.0 * zeta * w, 0.0], [0.0, 0.0, -50.0]])
    # G = -gain w^2/(s^2 + 2 zeta w s + w^2) + 1e-4/(s + 50) - ...; its second row makes it of relative degree 2.
    b, c = np.array([0.0, 1.0, 1.0]), np.array([0.0, -gain, gain])
    loop = BacklashLoop(a, b, c, stiffness=1.0 / (gain * 1e3), half_gap=HALF_GAP)
    found = circle_criterion(loop)
    depth = gain / (2.0 * zeta * w)
    assert found.frequency == pytest.approx(w, rel=1e-6)
    assert found.margin == pytest.approx(1.0 - depth / (gain * 1e3), rel=1e-3)
    grid = np.logspace(0, 5, 2001)
    assert 1.0 + loop.stiffness * loop.transfer(grid).real.min() > 0.9
    assert found.margin < 0.0


def test_loops_outside_its_scope_are_reported() -> None:
    lossless = circle_criterion(two_inertia_loop(PAPER, SCHEME_II))
    assert (lossless.verdict, "double pole" in lossless.explanation) == ("undecided", True)
    damped_shaft = circle_criterion(two_inertia_loop(drive(load_damping=0.1, shaft_damping=0.1), SCHEME_II))
    assert "damped shaft" in damped_shaft.explanation
    assert "not Hurwitz" in circle_criterion(two_inertia_loop(drive(load_damping=0.1), motor_pid(200.0, -1.0))).explanation
    assert math.isnan(lossless.margin)


@pytest.mark.slow
def test_a_loop_with_a_limit_cycle_is_never_called_stable() -> None:
    """Motor side, K_v 60, K_p 0.3, K_i 3000 with a damped load oscillates for ever at 1.2 half-gaps."""
    loop = two_inertia_loop(drive(load_damping=0.2), p_pi_cascade(60.0, 0.3, 3000.0, "motor"))
    run = simulate_exact(loop, [0.0, 0.0, -3.0 * HALF_GAP, 0.0, 0.0], 3.0)
    assert np.ptp(run.difference(np.linspace(2.9, 3.0, 500))) > 2.0 * HALF_GAP
    assert circle_criterion(loop).verdict == "undecided"


def test_simulations_confirm_a_stable_verdict() -> None:
    """All motions of the loop end with the gap unloaded."""
    loop = two_inertia_loop(drive(load_damping=3.0), SCHEME_II)
    assert circle_criterion(loop).verdict == "stable"
    for start in np.vstack([np.eye(4), -3.0 * np.ones((1, 4))]):
        run = simulate_exact(loop, 0.1 * start, 100.0)
        assert run.torque(100.0)[0] == pytest.approx(0.0, abs=1e-3)
