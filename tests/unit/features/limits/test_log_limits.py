"""Derivatives of logged positions: never above the truth by more than their resolution."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from contourlab.features.limits.command import LimitTest, annotated
from contourlab.features.limits.log_limits import AxisPeak, control_samples, course, moving_part, position_error
from contourlab.feed.verify import Worst

PERIOD = 1e-3
TIME = PERIOD * np.arange(4000)


def sine(amplitude: float, frequency: float) -> np.ndarray:
    return np.asarray(amplitude * np.sin(2.0 * math.pi * frequency * TIME))


@settings(max_examples=40)
@given(
    count=st.sampled_from([0.0, 1e-9, 1e-8, 1e-7, 1e-6]),
    frequency=st.floats(0.5, 5.0),
    amplitude=st.floats(1e-3, 0.05),
    order=st.integers(1, 3),
)
def test_counts_never_invent_a_peak(count: float, frequency: float, amplitude: float, order: int) -> None:
    exact = sine(amplitude, frequency)
    seen = count * np.rint(exact / count) if count else exact
    found = course(seen, PERIOD, order, math.inf)
    peak = amplitude * (2.0 * math.pi * frequency) ** order
    assert np.nanmax(found.magnitude) <= peak * (1.0 + 1e-9) + found.resolution + 1e-9


def test_exact_positions_are_differenced_sample_by_sample() -> None:
    found = course(sine(0.02, 2.0), PERIOD, 3, math.inf)
    assert found.stride == 1 and np.nanmax(found.magnitude) == pytest.approx(0.02 * (4.0 * math.pi) ** 3, rel=1e-3)


def test_coarse_positions_are_differenced_over_longer_strides() -> None:
    seen = 1e-6 * np.rint(sine(0.02, 2.0) / 1e-6)
    found = course(seen, PERIOD, 3, math.inf)
    truth = 0.02 * (4.0 * math.pi) ** 3
    # Sample by sample, counts alone would give 4 um / ms^3 = 4000 m/s^3, a hundred times the truth.
    assert np.abs(np.diff(seen, 3)).max() / PERIOD**3 > 50.0 * truth
    assert found.stride > 5 and found.resolution < 0.06 * truth
    assert np.nanmax(found.magnitude) == pytest.approx(truth, rel=0.15)


def test_the_error_of_positions_is_a_count_or_noise() -> None:
    assert position_error(1e-6 * np.rint(sine(0.02, 0.5) / 1e-6)) == pytest.approx(1.9e-6, rel=0.5)
    noise = 1e-7 * np.random.default_rng(1).standard_normal(TIME.size)
    assert position_error(sine(0.02, 2.0) + noise) == pytest.approx(6e-7, rel=0.1)
    assert position_error(sine(0.02, 2.0)) < 1e-12


@pytest.mark.parametrize("holds", [(8,), (7, 8, 9), (2,)])
def test_positions_of_a_log_faster_than_the_control_are_held(holds: tuple[int, ...]) -> None:
    sampled, held = np.cumsum(np.arange(60.0)), np.resize(holds, 60)
    held[30] += 500 * int(np.mean(holds))  # a rest
    seen = np.repeat(sampled, held)[:, None]
    first, period = control_samples(seen, 1e-4)
    assert period == pytest.approx(1e-4 * np.mean(holds), rel=0.01)
    np.testing.assert_array_equal(np.unique(seen[first, 0]), sampled)
    assert len(first) == pytest.approx(60 + 500, rel=0.01)


def test_other_logs_have_a_period_of_their_own() -> None:
    sampled = np.cumsum(np.arange(60.0))[:, None]
    slow = 1e-6 * np.rint(1e3 * np.sin(np.linspace(0.0, 3.0, 4000)))[:, None]
    for seen, period in ((sampled, 1e-4), (np.repeat(sampled, 8, axis=0), 0.01), (slow, 1e-4)):
        first, own = control_samples(seen, period)
        assert own == period and len(first) == len(seen)


def test_rest_is_not_cycle_time() -> None:
    position = np.concatenate([np.zeros(300), 0.005 * (1.0 - np.cos(np.linspace(0.0, math.pi, 500))), np.full(200, 0.01)])[:, None]
    moves = moving_part(position)
    assert abs(int(moves.sum()) - 500) <= 8 and moves[400] and not moves[0] and not moves[-1]


def test_comments_leave_active_lines_alone(tmp_path: object) -> None:
    from pathlib import Path

    file = Path(str(tmp_path)) / "a.ngc"
    file.write_bytes(b"G1 X1 F100\r\n(MSG, look)\nG1 X2 ; old\nO100 CALL\nG1 X3 (MSG, look)\n")
    content, skipped = annotated(file, [(1, "a"), (2, "b"), (3, "c"), (4, "d"), (5, "e"), (9, "f")])
    assert content == b"G1 X1 F100 (a)\r\n(MSG, look)\nG1 X2 ; old (c)\nO100 CALL\nG1 X3 (MSG, look)\n" and skipped == 4


@pytest.mark.parametrize(
    ("value", "resolution", "has_interval"), [(0.0, 4e-6, False), (0.0, 0.0, False), (2.0, 0.1, True), (2.0, 1e-3, False)]
)
def test_an_axis_at_rest_has_no_interval(value: float, resolution: float, has_interval: bool) -> None:
    peak = AxisPeak("z", "jerk", Worst(2, value, 100.0, resolution), PERIOD)
    test = LimitTest("part.ngc", "plan", ("z",), PERIOD, 1.0, "m", 0.005, True, (peak,), (), ())
    assert ("+-" in test.text) == has_interval
