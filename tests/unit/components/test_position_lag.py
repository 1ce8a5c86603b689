"""Delay and lag of positions: against closed forms, interpolation, and the filter of the same transfer function."""

from __future__ import annotations

import numpy as np
import pytest
from component_rig import PERIOD, make, run_alone
from refusals import refuses
from scipy.signal import lfilter

from contourlab.components.drive.step_generator import PositionLag
from contourlab.errors import ParameterError

WANDER = np.random.default_rng(3).standard_normal(400).cumsum()


@pytest.mark.parametrize("periods", [0.0, 0.3, 1.0, 2.75, 40.5])
def test_positions_arrive_late_by_the_delay(periods: float) -> None:
    sample = np.arange(WANDER.size, dtype=float)
    wanted = np.interp(sample - periods, sample, WANDER, left=0.0)
    wanted[int(np.floor(periods)) : int(np.ceil(periods))] = (np.ceil(periods) - periods) * WANDER[0]  # from rest at zero
    got = run_alone(PositionLag(delay=periods * PERIOD), {"command": WANDER})["applied"]
    assert got == pytest.approx(wanted, abs=1e-12)


@pytest.mark.parametrize(("frequency", "damping"), [(12.0, 0.1), (40.0, 0.7), (300.0, 2.0)])
def test_the_lag_is_the_low_pass_of_the_same_numbers(frequency: float, damping: float) -> None:
    filtered = run_alone(make("filter", "low-pass", frequency=frequency, damping_ratio=damping), {"command": WANDER})["command"]
    got = run_alone(PositionLag(frequency=frequency, damping_ratio=damping), {"command": WANDER})["applied"]
    assert got == pytest.approx(filtered, rel=1e-9, abs=1e-9)


def test_a_steady_motion_is_late_by_delay_and_twice_the_damping_over_the_frequency() -> None:
    speed, delay, frequency, damping = 0.2, 0.0043, 30.0, 0.4
    command = speed * PERIOD * np.arange(3000)
    got = run_alone(PositionLag(delay=delay, frequency=frequency, damping_ratio=damping), {"command": command})["applied"]
    # The bilinear rule with its frequency kept makes the lag at rest that of tan(w dt/2)/(dt/2).
    warped = 2.0 / PERIOD * np.tan(np.pi * frequency * PERIOD)
    assert command[-1] - got[-1] == pytest.approx(speed * (delay + 2.0 * damping / warped), rel=1e-9)
    assert warped == pytest.approx(2.0 * np.pi * frequency, rel=0.01)


def test_it_starts_where_the_axis_stands() -> None:
    part = PositionLag(delay=0.0153, frequency=25.0, damping_ratio=0.2)
    states, outputs = part.at_rest(1.7)
    assert outputs == {"applied": 1.7}
    got = run_alone(part, {"command": np.full(200, 1.7)}, initial=states)["applied"]
    assert got == pytest.approx(np.full(200, 1.7), rel=1e-12)


def test_delay_and_lag_follow_one_another() -> None:
    delayed = lfilter([0.0, 0.0, 0.0, 1.0], [1.0], WANDER)
    one, two = PositionLag(frequency=50.0), PositionLag(frequency=50.0, delay=3.0 * PERIOD)
    assert run_alone(two, {"command": WANDER})["applied"] == pytest.approx(run_alone(one, {"command": delayed})["applied"], abs=1e-9)


def test_a_lag_beyond_half_the_servo_frequency_is_refused() -> None:
    with refuses(ParameterError, name="position-lag.frequency", value="500", unit="Hz"):
        PositionLag(frequency=500.0).block(PERIOD)
