"""Reversal spikes that were planted: when, how high, how wide."""

from __future__ import annotations

import math

import numpy as np
import pytest
from made_runs import PERIOD, Array, circle_laps, made_run, samples_on, with_error

from contourlab.feed import uniform
from contourlab.geometry import Line, Path, contour
from contourlab.metrics import reversal_spikes
from contourlab.result import Result

N = 2000
START = math.pi / 4
SLOPE = 1e-7
"""Of the baseline [m/s]: its ends are means over five samples, which shifts it by the slope of three."""


def hat(time: Array, at: float, half: float) -> Array:
    """Triangle of height 1: half of it stands above half its height, `half` wide."""
    return np.maximum(1.0 - np.abs(time - at) / half, 0.0)


def planted(clockwise: float, heights: tuple[float, ...], delay: float, half: float, laps: int = 1) -> Result:
    """Triangles behind the reversals of a circle, on a baseline of 2 um that slopes."""
    # A start in the middle of a quadrant, so that no reversal stands at the edge.
    path = contour("circle", radius=0.02, start_angle=START, clockwise=clockwise)
    reference = uniform(path, 1.0 / (N * PERIOD), laps, PERIOD)
    time = np.arange(N * laps) * PERIOD
    period = N * PERIOD
    offset = (math.pi / 2 - START if clockwise == 0.0 else START) / (2.0 * math.pi) * period
    error = 2e-6 + SLOPE * time
    for i, height in enumerate(heights):
        error = error + height * hat(time, offset + i * period / 4.0 + delay, half)
    return with_error(made_run(reference, reference.block(0, N * laps).position), error)


@pytest.mark.parametrize("clockwise", [0.0, 1.0])
def test_planted_spikes_are_found(clockwise: float) -> None:
    heights, delay, half = (5e-6, -3e-6, 4e-6, -6e-6), 0.04, 0.03
    spikes = reversal_spikes(planted(clockwise, heights, delay, half))
    assert len(spikes) == 4
    for spike, height in zip(spikes, heights, strict=True):
        # The tip lies between two samples: at most half a period's slope is lost.
        assert spike.height == pytest.approx(height, rel=PERIOD / half)
        assert spike.peak_time - spike.time == pytest.approx(delay, abs=2.0 * PERIOD)
        assert spike.width == pytest.approx(half, abs=2.0 * PERIOD)


def test_reversals_of_a_counter_clockwise_circle() -> None:
    """From 45 degrees: y turns at 90 degrees, x at 180, y at 270, x at 0; quadrants 2, 3, 4, 1 are entered."""
    spikes = reversal_spikes(planted(0.0, (1e-6,) * 4, 0.03, 0.02))
    assert [s.axis for s in spikes] == ["y", "x", "y", "x"]
    assert [s.quadrant for s in spikes] == [2, 3, 4, 1]
    turns = (np.array([0.25, 0.5, 0.75, 1.0]) - START / (2.0 * math.pi)) * N * PERIOD
    for spike, time in zip(spikes, turns, strict=True):
        assert 0.0 <= spike.time - time <= PERIOD * (1.0 + 1e-9)
        assert spike.time == pytest.approx(spike.sample * PERIOD)


def test_reversals_of_a_clockwise_circle() -> None:
    """From 45 degrees the other way: x turns at 0, y at -90 degrees, x at 180, y at 90; quadrants 4, 3, 2, 1 are entered."""
    spikes = reversal_spikes(planted(1.0, (1e-6,) * 4, 0.03, 0.02))
    assert [s.axis for s in spikes] == ["x", "y", "x", "y"]
    assert [s.quadrant for s in spikes] == [4, 3, 2, 1]


def test_no_spike_no_height() -> None:
    """On a sloping baseline without a spike nothing stands out."""
    for spike in reversal_spikes(planted(0.0, (), 0.0, 1.0)):
        assert abs(spike.height) == pytest.approx(3.0 * PERIOD * SLOPE, rel=1e-6)


def test_window_and_longest() -> None:
    result = planted(0.0, (5e-6,) * 8, 0.1, 0.05, laps=2)
    assert len(reversal_spikes(result)) == 8
    second = reversal_spikes(result, (N, 2 * N))
    assert len(second) == 4
    assert all(N <= s.sample < 2 * N for s in second)
    # Looked for during 20 ms, a spike that comes after 50 ms is not seen.
    assert all(abs(s.height) < 4.0 * PERIOD * SLOPE for s in reversal_spikes(result, longest=0.02))


def test_times_of_a_window_are_those_of_the_run() -> None:
    result = planted(0.0, (5e-6, 4e-6, 3e-6, 2e-6), 0.04, 0.03)
    whole, part = reversal_spikes(result), reversal_spikes(result.window(600, 2000))
    assert part == whole[1:]


def test_standstill_in_between_is_one_reversal() -> None:
    """Forward, 0.1 s at rest, back: one reversal, at the first sample that moves back."""
    path = Path([Line((0.0, 0.0), (0.1, 0.0)), Line((0.1, 0.0), (0.0, 0.0))])
    along = np.concatenate([np.linspace(0.0, 0.1, 200), np.full(100, 0.1), np.linspace(0.1, 0.2, 200)])
    reference = samples_on(path, along)
    result = with_error(made_run(reference, path.position(along)), 5e-6 * hat(np.arange(500) * PERIOD, 0.34, 0.02))
    (spike,) = reversal_spikes(result)
    # The central difference of the last sample at rest already sees the move back.
    assert (spike.axis, spike.quadrant) == ("x", 0)
    assert spike.sample in (299, 300)
    assert spike.height == pytest.approx(5e-6, rel=0.05)


def test_in_space_there_is_no_quadrant() -> None:
    path = Path([Line((0.0, 0.0, 0.0), (0.1, 0.1, 0.0)), Line((0.1, 0.1, 0.0), (0.2, 0.0, 0.0))])
    reference = samples_on(path, np.linspace(0.0, path.length, 400))
    result = with_error(made_run(reference, reference.block(0, 400).position), np.zeros(400))
    (spike,) = reversal_spikes(result)
    assert (spike.axis, spike.quadrant) == ("y", 0)


def test_circle_laps_have_a_reversal_per_quarter() -> None:
    reference = circle_laps(400, laps=3)
    result = with_error(made_run(reference, reference.block(0, 1200).position), np.zeros(1200))
    # At the very start y moves already and x begins to: 4 reversals a lap, but for the one at the first sample.
    assert len(reversal_spikes(result)) == 3 * 4 - 1
