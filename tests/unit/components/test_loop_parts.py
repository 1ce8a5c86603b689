"""Drives, sensors, velocity estimates and disturbances against their specifications."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, make, run_alone
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import kstest

# --- drives --------------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("jit", [False, True])
def test_a_drive_passes_the_command_up_to_its_limit(jit: bool) -> None:
    asked = np.array([0.0, -0.0, 0.5, math.nextafter(0.5, 1.0), 7.0, -0.5, -7.0, 0.25])
    limited = run_alone(make("drive", "saturation", limit=0.5), {"command": asked}, jit=jit)["applied"]
    assert np.array_equal(limited, np.clip(asked, -0.5, 0.5))
    assert np.array_equal(run_alone(make("drive", "saturation"), {"command": 1e300 * asked}, jit=jit)["applied"], 1e300 * asked)


@pytest.mark.parametrize("jit", [False, True])
@pytest.mark.parametrize(("delay", "ticks"), [(0.0, 0), (1e-3, 1), (3e-3, 3), (0.007, 7), (0.031, 31), (0.3, 300)])
def test_a_whole_delay_shifts(delay: float, ticks: int, jit: bool) -> None:
    """Rounding does not make a whole delay fractional: 0.007/0.001 is 7.000000000000001."""
    asked = np.sin(np.arange(500.0)) + 2.0
    out = run_alone(make("drive", "delayed-saturation", delay=delay), {"command": asked}, jit=jit)["applied"]
    assert out == pytest.approx(np.concatenate([np.zeros(ticks), asked[: 500 - ticks]]), abs=1e-8)
    assert np.array_equal(out[:ticks], np.zeros(ticks))


@given(periods=st.floats(0.0, 20.0), seed=st.integers(0, 99))
def test_a_fractional_delay_keeps_the_mean_of_the_held_command(periods: float, seed: int) -> None:
    """The mean over a period of the held and delayed command, here from its integral."""
    asked = np.random.default_rng(seed).normal(size=60)
    out = run_alone(make("drive", "delayed-saturation", delay=periods * PERIOD), {"command": asked})["applied"]
    held = np.concatenate([[0.0], np.cumsum(asked)])  # integral of the held command, in periods
    ticks = np.arange(61.0)
    late = np.interp(ticks - periods, ticks, held, left=0.0)
    assert out == pytest.approx(np.diff(late), abs=1e-7)


@given(periods=st.floats(0.0, 20.0), slope=st.floats(-5.0, 5.0))
def test_a_delayed_ramp_lags_by_the_delay(periods: float, slope: float) -> None:
    asked = slope * np.arange(80.0)
    out = run_alone(make("drive", "delayed-saturation", delay=periods * PERIOD), {"command": asked})["applied"]
    assert out[25:] == pytest.approx(slope * (np.arange(25.0, 80.0) - periods), abs=1e-7)


def test_the_limit_acts_before_the_delay() -> None:
    asked = np.array([4.0, 4.0, -4.0, -4.0, 4.0, 4.0])
    out = run_alone(make("drive", "delayed-saturation", delay=0.5 * PERIOD, limit=1.0), {"command": asked})["applied"]
    # The mean of 4 and 0 limited afterwards is 1; limited first, the mean of 1 and 0 is smaller.
    assert out == pytest.approx([0.5, 1.0, 0.0, -1.0, 0.0, 1.0])


def test_the_accepted_command_is_known_without_delay() -> None:
    """Only the limit acts on it: an anti-windup integral needs it at once."""
    asked = np.array([0.5, 4.0, -4.0, -0.25])
    out = run_alone(make("drive", "delayed-saturation", delay=7.5 * PERIOD, limit=1.0), {"command": asked})
    assert out["accepted"].tolist() == [0.5, 1.0, -1.0, -0.25]
    assert not out["applied"].any()


# --- sensors -------------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("jit", [False, True])
def test_an_encoder_rounds_to_the_nearest_count_and_halves_to_even(jit: bool) -> None:
    r = 0.25  # a power of two, so that halves are exact
    seen = r * np.array([0.0, 0.49, 0.5, 0.51, 1.5, 2.5, -0.5, -1.5, -2.51, 1e6 + 0.5])
    out = run_alone(make("sensor", "encoder", resolution=r), {"position": seen}, jit=jit)["position"]
    assert (out / r).tolist() == [0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 0.0, -2.0, -3.0, 1e6]


@given(resolution=st.floats(1e-9, 1e-3), position=st.floats(-1.0, 1.0))
def test_an_encoder_is_off_by_half_a_count_at_most(resolution: float, position: float) -> None:
    out = float(run_alone(make("sensor", "encoder", resolution=resolution), {"position": [position]})["position"][0])
    assert abs(out - position) <= 0.5 * resolution + 1e-15 * abs(position)
    assert out / resolution == pytest.approx(round(out / resolution), abs=1e-6)


def test_quantisation_of_a_slow_motion_adds_a_twelfth_of_a_count_squared() -> None:
    seen = np.linspace(0.0, 1e-3, 20_001)
    out = run_alone(make("sensor", "encoder", resolution=1e-6), {"position": seen}, jit=True)["position"]
    assert np.std(out - seen) == pytest.approx(1e-6 / math.sqrt(12.0), rel=1e-2)


def noise(stream: float, n: int = 20_000) -> Any:
    sensor = make("sensor", "encoder", resolution=1e-12, noise=1e-6, stream=stream)
    return run_alone(sensor, {"position": np.zeros(n)}, jit=True)["position"] / 1e-6


def test_encoder_noise_is_normal_white_and_repeatable() -> None:
    one, other = noise(3.0), noise(4.0)
    assert np.array_equal(one, noise(3.0)) and np.array_equal(one[:100], noise(3.0, 100))
    # Five standard deviations of each estimate: the seed is fixed, so a sound generator always passes.
    n = one.size
    assert abs(one.mean()) < 5.0 / math.sqrt(n)
    assert abs(one.std() - 1.0) < 5.0 / math.sqrt(2.0 * n)
    for lag in (1, 2, 3, 10):
        assert abs(np.corrcoef(one[lag:], one[:-lag])[0, 1]) < 5.0 / math.sqrt(n)
    assert abs(np.corrcoef(one, other)[0, 1]) < 5.0 / math.sqrt(n)
    assert kstest(one, "norm").pvalue > 1e-4


# --- velocity estimates ----------------------------------------------------------------------------------------------------------------

RULES = ["backward-euler", "pole-matched"]


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("bandwidth", [50.0, 800.0, 1e6])
def test_a_filtered_difference_is_exact_at_rest_and_on_a_ramp(rule: str, bandwidth: float) -> None:
    part = make("velocity", "filtered-difference", bandwidth=bandwidth, discretisation=rule)
    start = part.at_rest(0.3)[0]
    still = run_alone(part, {"position": np.full(50, 0.3)}, initial=start)["velocity"]
    assert not still.any()
    moving = run_alone(part, {"position": 0.3 + 0.02 * PERIOD * np.arange(1, 801)}, initial=start)["velocity"]
    # The slope converges by the same factor at every tick.
    factor = math.exp(-bandwidth * PERIOD) if rule == "pole-matched" else 1.0 / (1.0 + bandwidth * PERIOD)
    left = factor ** np.arange(1, 801)
    assert moving == pytest.approx(0.02 * (1.0 - left), abs=1e-12)


@pytest.mark.parametrize(("rule", "order"), [("backward-euler", 1), ("pole-matched", 2)])
def test_a_filtered_difference_converges_to_the_continuous_filter(rule: str, order: int) -> None:
    """s w/(s + w) on a sine: the difference is half a tick late; with pole matching the low-pass is half a tick early."""
    w, f, gaps = 300.0, 100.0, []
    part = make("velocity", "filtered-difference", bandwidth=w, discretisation=rule)
    for n in (1000, 2000, 4000):
        t = np.arange(n) / n * 0.5
        out = run_alone(part, {"position": np.sin(f * t)}, period=0.5 / n)["velocity"]
        gain = 1j * f * w / (1j * f + w)
        steady = np.imag(gain * np.exp(1j * f * t))
        gaps.append(np.abs(out - steady)[n // 2 :].max() / abs(gain))
    assert gaps[-1] < 0.02
    assert np.log2([gaps[0] / gaps[1], gaps[1] / gaps[2]]) == pytest.approx([order, order], abs=0.1)


# --- disturbances --------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("start", "first"), [(0.0, 0), (0.003, 3), (0.0035, 4), (0.007, 7)])
def test_a_constant_force_begins_at_its_time(start: float, first: int) -> None:
    out = run_alone(make("disturbance", "constant", force=-2.0, start=start), {"position": np.zeros(10)})["force"]
    assert out.tolist() == [0.0] * first + [-2.0] * (10 - first)


def test_a_sine_keeps_its_phase_for_hours() -> None:
    """Time is tick number times period, never a sum: after 1e6 ticks the phase is a whole number of turns."""
    part = make("disturbance", "sine", amplitude=3.0, frequency=50.0, phase=0.4)
    out = run_alone(part, {"position": np.zeros(1_000_020)}, jit=True)["force"]
    assert out[-20:] == pytest.approx(out[:20], abs=3.0 * 1e6 * 1e-3 * 2.0 * math.pi * 50.0 * 4e-16)
    assert out[:20] == pytest.approx(3.0 * np.sin(2.0 * math.pi * 50.0 * PERIOD * np.arange(20) + 0.4), abs=1e-14)


TABLES = st.lists(st.floats(-10.0, 10.0), min_size=2, max_size=9)


@given(
    values=TABLES, origin=st.floats(-0.1, 0.1), step=st.floats(1e-3, 0.1), places=st.lists(st.floats(-2.0, 2.0), min_size=1, max_size=20)
)
def test_a_table_over_position_holds_its_ends(values: list[float], origin: float, step: float, places: list[float]) -> None:
    part = make("disturbance", "table", over="position", start_position=origin, position_step=step, forces=values)
    out = run_alone(part, {"position": places})["force"]
    grid = origin + step * np.arange(len(values))
    assert out == pytest.approx(np.interp(places, grid, values), abs=1e-9)


@given(values=TABLES, origin=st.floats(-0.02, 0.02), step=st.floats(1e-3, 0.1))
def test_a_table_over_time_repeats(values: list[float], origin: float, step: float) -> None:
    closed = [*values[:-1], values[0]]
    part = make("disturbance", "table", over="time", beyond="repeat", start_time=origin, time_step=step, forces=closed)
    out = run_alone(part, {"position": np.zeros(200)})["force"]
    grid = origin + step * np.arange(len(closed))
    turn = step * (len(closed) - 1)
    assert out == pytest.approx(np.interp(PERIOD * np.arange(200), grid, closed, period=turn), abs=1e-9)


@pytest.mark.parametrize("jit", [False, True])
def test_a_table_over_time_holds(jit: bool) -> None:
    part = make("disturbance", "table", over="time", start_time=0.01, time_step=0.02, forces=(1.0, 5.0, -3.0))
    out = run_alone(part, {"position": np.full(80, 7.0)}, jit=jit)["force"]
    assert out == pytest.approx(np.interp(PERIOD * np.arange(80), [0.01, 0.03, 0.05], [1.0, 5.0, -3.0]), abs=1e-12)


def test_a_repeating_table_that_does_not_close_jumps_at_the_turn() -> None:
    """Just before the turn it has its last value, at the turn its first."""
    part = make("disturbance", "table", over="position", beyond="repeat", position_step=1.0, forces=(1.0, 2.0, 8.0))
    out = run_alone(part, {"position": [0.0, 1.0, 1.5, 2.0 - 1e-12, 2.0, 3.0, -0.5]})["force"]
    assert out == pytest.approx([1.0, 2.0, 5.0, 8.0, 1.0, 2.0, 5.0], abs=1e-9)
