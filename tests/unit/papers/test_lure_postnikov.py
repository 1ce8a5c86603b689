"""Energy plus the dead zone's integral: checked along motions, and on loops without such a function."""

from __future__ import annotations

import math

import numpy as np
import pytest
from backlash_loops import FREE, HALF_GAP, J_L, J_M, K_S, PAPER, SCHEME_II, SCHEME_III, drive, paper_loop
from exact_run import simulate_exact
from hypothesis import given, settings
from hypothesis import strategies as st

from contourlab.errors import ParameterError
from contourlab.papers.shahin.lure_postnikov import energy_function
from contourlab.papers.shahin.two_inertia_loop import motor_pid, p_pi_cascade, two_inertia_loop


def test_it_exists_for_the_model_of_the_paper() -> None:
    """Lossless load, motor under PD: the energy of the controller's spring, both inertias and the shaft; all motions end at rest."""
    for half_gap in (HALF_GAP, 2.0 * HALF_GAP):
        found = energy_function(two_inertia_loop(drive(half_gap=half_gap), SCHEME_II))
        assert found.verdict == "stable"
        assert found.settles
        assert found.p == pytest.approx(np.diag([200.0, J_M, 0.0, J_L]), rel=1e-14)
        # Only the derivative gain dissipates.
        assert found.dissipation == pytest.approx(np.diag([0.0, 2000.0, 0.0, 0.0]), rel=1e-12)


@settings(max_examples=8, deadline=None)
@given(
    start=st.tuples(*[st.floats(-1.0, 1.0)] * 4),
    gains=st.tuples(st.floats(1.0, 500.0), st.floats(0.0, 20.0)),
    losses=st.tuples(st.floats(0.0, 0.1), st.floats(0.0, 0.1)),
)
def test_it_never_rises_and_its_bounds_hold(start: tuple[float, ...], gains: tuple[float, float], losses: tuple[float, float]) -> None:
    """Along exact motions V falls, and the motor-load difference stays within the initial bound."""
    loop = two_inertia_loop(drive(motor_damping=losses[0], load_damping=losses[1]), motor_pid(*gains))
    found = energy_function(loop)
    assert found.verdict == "stable"
    x0 = np.array(start) * [0.1, 5.0, 0.1, 5.0]
    x = simulate_exact(loop, x0, 0.4).state(np.linspace(0.0, 0.4, 161))
    v = found.value(x)
    assert (np.diff(v) <= 1e-10 * v[0]).all()
    assert np.abs(x @ loop.c).max() <= found.difference_bound(x0) * (1.0 + 1e-9)


def test_its_bound_is_a_closed_form() -> None:
    """Half of the gap and sqrt(2 V/k)."""
    found, x0 = energy_function(paper_loop()), np.array([0.0, 3.0, 0.0, 0.0])
    assert found.difference_bound(x0) == pytest.approx(HALF_GAP + math.sqrt(J_M * 9.0 / K_S), rel=1e-12)


def test_motions_end_at_the_predicted_rest() -> None:
    """With load damping and a softer controller, for a quick end: motor at the reference, load anywhere in the gap."""
    loop = two_inertia_loop(drive(load_damping=0.05), motor_pid(100.0, 1.0))
    found = energy_function(loop)
    assert found.settles
    x = simulate_exact(loop, [0.0, 0.0, 0.05, 0.0], 4.0).state(4.0)[0]
    assert x[[0, 1, 3]] == pytest.approx(np.zeros(3), abs=1e-8)
    assert abs(x[2]) <= HALF_GAP * (1.0 + 1e-9)


def test_it_exists_for_a_damped_shaft() -> None:
    """With the twist of the shaft in place of the dead zone it falls too."""
    loop = two_inertia_loop(drive(shaft_damping=0.3), motor_pid(100.0, 1.0))
    found = energy_function(loop)
    run = simulate_exact(loop, [0.0, 0.0, 0.05, 2.0], 1.0)
    times = np.linspace(0.0, 1.0, 2001)
    v = found.value(run.state(times), run.twist(times))
    assert (np.diff(v) <= 1e-11 * v[0]).all()


def test_without_damping_it_bounds_but_does_not_settle() -> None:
    """Two inertias and a spring to the reference: bounded, but never at rest."""
    found = energy_function(two_inertia_loop(PAPER, motor_pid(100.0, 0.0)))
    assert found.verdict == "stable"
    assert not found.settles


def test_a_loop_that_adds_energy_is_undecided() -> None:
    for feedback in (motor_pid(200.0, -1.0), motor_pid(-200.0, 10.0), FREE, SCHEME_III, p_pi_cascade(30.0, 2.0)):
        found = energy_function(two_inertia_loop(PAPER, feedback))
        assert found.verdict == "undecided", feedback
        with pytest.raises(ParameterError, match="energy function"):
            found.value(np.zeros(4))
