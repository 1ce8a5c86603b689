"""The learning law against loops in closed form."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.signal import lsim

from contourlab.features.precompensate.law import Run, filtered, fit_loop, learn, low_pass, proposed, spread
from contourlab.features.precompensate.reading import contour_of, parse_blocks
from contourlab.features.precompensate.runs import Measured, behind_play, run_of
from contourlab.program import Reading

PERIOD = 1e-3
STIFFNESS, DAMPING, FORWARD = 1600.0, 30.0, 25.0  # p'' = 1600 (c - p) + 25 c' - 30 p'


def response(command: np.ndarray) -> np.ndarray:
    """Return the position of the loop."""
    time = PERIOD * np.arange(len(command))
    return np.asarray(lsim(([FORWARD, STIFFNESS], [1.0, DAMPING, STIFFNESS]), command, time)[1])


def moves() -> np.ndarray:
    """Return a command that goes back and forth, at rest before and after (n,) [m]."""
    speed = np.concatenate([np.zeros(300), np.full(900, 0.03), np.full(700, -0.04), np.full(400, 0.02), np.zeros(500)])
    ramp = np.convolve(speed, np.ones(40) / 40.0, mode="same")
    return np.cumsum(ramp) * PERIOD


def test_the_loop_comes_back_from_its_log() -> None:
    loop = fit_loop(moves(), response(moves()), PERIOD)
    # 1600 (c - p) + 25 (c' - p') = p'' + 5 p'
    assert loop.zero == pytest.approx(FORWARD / STIFFNESS, rel=0.05)
    assert loop.velocity_lag == pytest.approx((DAMPING - FORWARD) / STIFFNESS, rel=0.05)
    assert loop.acceleration_lag == pytest.approx(1.0 / STIFFNESS, rel=0.05)
    # 3 dB below: |1600 + 25 s|^2 = |s^2 + 30 s + 1600|^2 / 2
    square = np.roots([1.0, DAMPING**2 - 2.0 * STIFFNESS - 2.0 * FORWARD**2, -(STIFFNESS**2)])
    assert loop.bandwidth == pytest.approx(math.sqrt(square.real.max()) / (2.0 * math.pi), rel=0.05)


def test_the_low_pass_shifts_nothing() -> None:
    values = np.zeros((2001, 1))
    values[1000] = 1.0
    kept = filtered(values, PERIOD, low_pass(10.0), 0.3)[:, 0]
    assert np.argmax(kept) == 1000
    np.testing.assert_allclose(kept, kept[::-1], atol=1e-12)


def made_run(error: np.ndarray, place: np.ndarray, rounded: float = 0.0) -> Run:
    n = len(place)
    off, rest = np.full((n, 1), rounded), np.zeros(1)
    return Run(PERIOD, place, error[:, None], np.ones(n, dtype=bool), np.full(n, 0.02), 1.0, rest, rest, off)


def test_one_pass_removes_what_the_model_explains_below_the_cutoff() -> None:
    """A bump of the error along a straight line: after a pass, the loop driven by the corrected command is free of it."""
    time = PERIOD * np.arange(3000)
    bump = 1e-4 * np.exp(-(((time - 1.5) / 0.12) ** 2))
    place = 0.02 * time
    loop = fit_loop(moves(), response(moves()), PERIOD)
    learned = learn(None, [made_run(bump, place)], [loop], place, 1.2 * loop.bandwidth)
    correction, capped = proposed(learned, 1e-3)
    assert not capped.any()
    left = bump - response(correction[:, 0])
    assert np.abs(left).max() < 0.05 * np.abs(bump).max()


def test_half_of_what_the_control_rounds_is_left_to_the_second_pass() -> None:
    """The short lines of the first pass are rounded less by themselves; a correction of it all would go too far."""
    place = 0.02 * PERIOD * np.arange(4000)
    loop = fit_loop(moves(), response(moves()), PERIOD)
    learned = learn(None, [made_run(np.full(4000, 50e-6), place, 40e-6)], [loop], place, 10.0)
    assert learned.step[2000, 0] == pytest.approx(30e-6, abs=1e-8)
    learned = learn(learned, [made_run(np.full(4000, 20e-6), place, 10e-6)], [loop], place, 10.0)
    assert learned.step[2000, 0] == pytest.approx(20e-6, abs=1e-8)


def test_a_place_keeps_its_best_correction() -> None:
    """The second pass is worse in its first half only: that half goes back and tries half the step."""
    time = PERIOD * np.arange(4000)
    place = 0.02 * time
    loop = fit_loop(moves(), response(moves()), PERIOD)
    error = np.full(4000, 50e-6)
    learned = learn(None, [made_run(error, place)], [loop], place, 10.0)
    tried, _ = proposed(learned, 1e-3)
    second = made_run(np.where(time < 2.0, 80e-6, 10e-6), place)
    learned = learn(replace(learned, tried=tried), [second], [loop], place, 10.0)
    first, last = slice(500, 1500), slice(2500, 3500)
    np.testing.assert_allclose(learned.kept[first], 0.0, atol=1e-8)
    np.testing.assert_allclose(learned.gain[first], 0.5, atol=1e-3)
    np.testing.assert_allclose(learned.kept[last], tried[last], atol=1e-8)
    np.testing.assert_allclose(np.sqrt(learned.error[last]), 10e-6, rtol=1e-3)


def test_the_cap_keeps_direction_and_says_where() -> None:
    place = 0.02 * PERIOD * np.arange(2000)
    loop = fit_loop(moves(), response(moves()), PERIOD)
    learned = learn(None, [made_run(np.full(2000, -3e-3), place)], [loop], place, 10.0)
    correction, capped = proposed(learned, 1e-3)
    assert capped[1000]
    assert correction[1000, 0] == pytest.approx(-1e-3)


def test_near_the_ends_of_a_part_the_path_does_not_turn_back() -> None:
    place = 0.02 * PERIOD * np.arange(2000)
    loop = fit_loop(moves(), response(moves()), PERIOD)
    learned = learn(None, [made_run(np.full(2000, -0.5e-3), place)], [loop], place, 10.0)
    correction, _ = proposed(learned, 1e-3, np.minimum(place, place[-1] - place))
    assert correction[0, 0] == correction[-1, 0] == 0.0
    assert np.abs(np.diff(correction[:, 0])).max() <= 0.5 * (place[1] - place[0]) * 1.0001
    assert correction[1000, 0] == pytest.approx(-0.5e-3, rel=1e-3)


def test_what_differs_between_runs_does_not_repeat() -> None:
    place = 0.02 * PERIOD * np.arange(2000)
    rng = np.random.default_rng(3)
    runs = [made_run(20e-6 + 5e-6 * rng.standard_normal(2000), place) for _ in range(4)]
    assert spread(runs) == pytest.approx(5e-6, rel=0.1)
    assert spread(runs[:1]) is None


def test_the_last_step_of_a_rapid_is_not_part_of_the_cut() -> None:
    source = parse_blocks("G21 G90\nG0 X10\nG1 X20 F600\nM2\n", "part", Reading(require_end=False), ("x", "y"))
    x = np.concatenate([np.zeros(5), np.linspace(0.0, 0.01, 11), np.full(9, 0.01 + 2e-9), np.linspace(0.01, 0.02, 1001), np.full(50, 0.02)])
    command = np.column_stack([x, np.zeros(len(x))])
    load = command - [0.0, 1e-4] * (x < 0.01 + 3e-9)[:, None]
    run = run_of(contour_of(source, ("x", "y"), PERIOD), Measured(PERIOD, command, command, load, "load"))
    assert run.moves.sum() == 1000
    assert run.largest < 1e-9
    np.testing.assert_allclose(run.speed[run.moves], 0.01, rtol=1e-6)


def test_play_holds_the_load_at_a_reversal() -> None:
    np.testing.assert_allclose(behind_play(np.array([0.0, 5.0, 4.0, 3.0, 1.0]), 2.0), [0.0, 4.0, 4.0, 4.0, 2.0])
