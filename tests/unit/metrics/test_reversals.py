"""Planted reversal spikes: their time, height and width."""

from __future__ import annotations

import math
import tracemalloc
from dataclasses import astuple

import numpy as np
import pytest
from made_runs import PERIOD, Array, circle_laps, made_run, samples_on, with_error

from contourlab.feed import Reference, uniform
from contourlab.geometry import Arc, Line, Path, contour
from contourlab.metrics.judge import judge
from contourlab.metrics.reversals import Spike, reversal_figures, reversal_spikes
from contourlab.result import Result

N = 2000
START = math.pi / 4
SLOPE = 1e-7
"""Slope of the baseline [m/s]. Its ends are means over five samples, which shifts it by the slope over three samples."""


def hat(when: Array, at: float, half: float) -> Array:
    """Return a triangle of height 1, `half` wide at half its height."""
    return np.maximum(1.0 - np.abs(when - at) / half, 0.0)


def planted(clockwise: float, heights: tuple[float, ...], delay: float, half: float, laps: int = 1) -> Result:
    """Return triangles after the reversals of a circle, on a sloping baseline of 2 um."""
    # Start in the middle of a quadrant, so that no reversal lies at the edge.
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
    """A sloping baseline without a spike gives no height."""
    for spike in reversal_spikes(planted(0.0, (), 0.0, 1.0)):
        assert abs(spike.height) == pytest.approx(3.0 * PERIOD * SLOPE, rel=1e-6)


def test_window_and_longest() -> None:
    result = planted(0.0, (5e-6,) * 8, 0.1, 0.05, laps=2)
    assert len(reversal_spikes(result)) == 8
    second = reversal_spikes(result, (N, 2 * N))
    assert len(second) == 4
    assert all(N <= s.sample < 2 * N for s in second)
    # A search of 20 ms does not see a spike that comes after 50 ms.
    assert all(abs(s.height) < 4.0 * PERIOD * SLOPE for s in reversal_spikes(result, longest=0.02))


def test_times_of_a_window_are_those_of_the_run() -> None:
    result = planted(0.0, (5e-6, 4e-6, 3e-6, 2e-6), 0.04, 0.03)
    whole, part = reversal_spikes(result), reversal_spikes(result.window(600, 2000))
    assert [astuple(spike) for spike in part] == [astuple(spike) for spike in whole[1:]]  # from Python 3.13 on nan makes spikes unequal


def test_standstill_in_between_is_one_reversal() -> None:
    """Forward, 0.1 s at rest, back: one reversal, at the first sample that moves back."""
    path = Path([Line((0.0, 0.0), (0.1, 0.0)), Line((0.1, 0.0), (0.0, 0.0))])
    along = np.concatenate([np.linspace(0.0, 0.1, 200), np.full(100, 0.1), np.linspace(0.1, 0.2, 200)])
    reference = samples_on(path, along)
    result = with_error(made_run(reference, path.position(along)), 5e-6 * hat(np.arange(500) * PERIOD, 0.34, 0.02))
    (spike,) = reversal_spikes(result)
    # The central difference at the last sample at rest already sees the backward motion.
    assert (spike.axis, spike.quadrant) == ("x", 0)
    assert spike.sample in (299, 300)
    assert spike.height == pytest.approx(5e-6, rel=0.05)


def test_in_space_there_is_no_quadrant() -> None:
    path = Path([Line((0.0, 0.0, 0.0), (0.1, 0.1, 0.0)), Line((0.1, 0.1, 0.0), (0.2, 0.0, 0.0))])
    reference = samples_on(path, np.linspace(0.0, path.length, 400))
    result = with_error(made_run(reference, reference.block(0, 400).position), np.zeros(400))
    (spike,) = reversal_spikes(result)
    assert (spike.axis, spike.quadrant) == ("y", 0)


def test_circle_laps_have_four_reversals_each() -> None:
    reference = circle_laps(400, laps=3)
    result = with_error(made_run(reference, reference.block(0, 1200).position), np.zeros(1200))
    # At the very start y already moves and x begins to: 4 reversals per lap, less the one at the first sample.
    assert len(reversal_spikes(result)) == 3 * 4 - 1


@pytest.mark.parametrize(("clockwise", "order"), [(0.0, (90, 180, 270, 0)), (1.0, (0, 270, 180, 90))])
def test_reversals_of_a_circle_are_at_its_four_quadrants(clockwise: float, order: tuple[int, ...]) -> None:
    """x is farthest out at 0 degrees and turns back there, in either sense."""
    path = contour("circle", radius=0.02, start_angle=START, clockwise=clockwise)
    result = planted(clockwise, (1e-6,) * 4, 0.03, 0.02)
    spikes = reversal_spikes(result, reference=uniform(path, 1.0 / (N * PERIOD), 1, PERIOD))
    assert [round(math.degrees(s.angle)) for s in spikes] == list(order)
    assert [s.direction for s in spikes] == [-1 if degrees < 135 else 1 for degrees in order]
    assert all(math.isnan(s.angle) for s in reversal_spikes(result))


def test_only_arcs_have_quadrants() -> None:
    """Up, around a half circle, down: x turns on the arc, y at the corner of a line."""
    path = Path(
        [
            Line((0.0, -0.02), (0.0, 0.0)),
            Arc((0.01, 0.0), 0.01, math.pi, -math.pi),
            Line((0.02, 0.0), (0.02, -0.02)),
            Line((0.02, -0.02), (0.01, 0.0)),
        ]
    )
    reference = samples_on(path, np.linspace(0.0, path.length, 3000))
    result = with_error(made_run(reference, reference.block(0, 3000).position), np.zeros(3000))
    found = [(s.axis, s.direction, s.angle) for s in reversal_spikes(result, reference=reference)]
    top, corner = found[0], found[1:]
    assert top == ("y", -1, pytest.approx(math.pi / 2))
    assert [(axis, way) for axis, way, _ in corner] == [("x", -1), ("y", 1)]
    assert all(math.isnan(angle) for _, _, angle in corner)


@pytest.mark.parametrize(("plane", "first", "second"), [("xy", 0, 1), ("yz", 1, 2), ("zx", 2, 0)])
def test_quadrants_of_a_circle_in_space_start_at_the_first_axis_of_its_plane(plane: str, first: int, second: int) -> None:
    frame = np.eye(3)
    path = Path([Arc((0.0, 0.0, 0.0), 0.02, 0.5, 2.0 * math.pi, u=frame[first], v=frame[second])], closed=True)
    reference = uniform(path, 1.0 / (N * PERIOD), 2, PERIOD)
    result = judge(made_run(reference, reference.block(0, 2 * N).position), reference)
    spikes = reversal_spikes(result, (N, 2 * N), reference=reference)
    assert [s.axis for s in spikes] == [plane[1], plane[0], plane[1], plane[0]]
    assert [round(math.degrees(s.angle)) for s in spikes] == [90, 180, 270, 0]


def test_many_reversals_in_space_take_the_memory_of_one_run() -> None:
    n = 400
    points = np.column_stack([np.arange(n + 1.0), 0.2 * (np.arange(n + 1) % 2), np.zeros(n + 1)]) * 1e-3
    path = Path(Line.many(points[:-1], points[1:]))
    reference = samples_on(path, np.linspace(0.0, path.length, 60 * n))
    result = judge(made_run(reference, reference.block(0, 60 * n).position + np.array([0.0, 0.0, 1e-5])), reference)
    tracemalloc.start()
    spikes = reversal_spikes(result, reference=reference)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert len(spikes) >= n - 4
    assert peak < 30 * result["tool_position"].nbytes


def in_space(inward: float, height: float) -> tuple[Result, Reference]:
    """Return a circle in the XY plane of three axes: the tool runs inside by its lag; a spike after each reversal throws it outwards."""
    path = Path([Arc((0.0, 0.0, 0.0), 0.02, START, 2.0 * math.pi, u=(1.0, 0.0, 0.0), v=(0.0, 1.0, 0.0))], closed=True)
    reference = uniform(path, 1.0 / (N * PERIOD), 1, PERIOD)
    asked, when = reference.block(0, N).position, np.arange(N) * PERIOD
    out = -inward + sum(height * hat(when, (i + 0.5) * N * PERIOD / 4.0 + 0.04, 0.03) for i in range(4))
    return judge(made_run(reference, asked * (1.0 + out / 0.02)[:, None]), reference), reference


def test_in_space_too_a_spike_through_the_path_counts_from_its_baseline() -> None:
    """From 10 um inside to 10 um outside the spike is 20 um high, though the distance is 10 um at its foot and at its tip."""
    result, reference = in_space(10e-6, 20e-6)
    assert result["contour_error"].min() >= 0.0 and result["contour_error"].max() == pytest.approx(10e-6, rel=0.01)
    spikes = reversal_spikes(result, reference=reference)
    assert len(spikes) == 4
    for spike in spikes:
        # The baseline is a chord; the lag turns by 45 degrees with the circle, so it is off by up to 10 um (1 - cos 22.5 deg).
        assert spike.height == pytest.approx(20e-6, abs=0.8e-6)
        assert spike.peak_time - spike.time == pytest.approx(0.04, abs=2.0 * PERIOD)
        assert spike.width == pytest.approx(0.03, rel=0.1)


def test_in_space_the_error_refers_to_the_planned_path() -> None:
    """Planning cuts the programmed corner by 0.4 mm: this is no spike of the servo."""
    programmed = Path([Line((0.0, 0.0, 0.0), (0.02, 0.0, 0.0)), Line((0.02, 0.0, 0.0), (0.01, 0.02, 0.0))])
    planned = Path(
        [
            Line((0.0, 0.0, 0.0), (0.0195, 0.0, 0.0)),
            Line((0.0195, 0.0, 0.0), (0.0195, 0.001, 0.0)),
            Line((0.0195, 0.001, 0.0), (0.01, 0.02, 0.0)),
        ]
    )
    reference = samples_on(planned, np.linspace(0.0, planned.length, 1500), programmed)
    result = judge(made_run(reference, reference.block(0, 1500).position + np.array([0.0, 0.0, 3e-6])), reference)
    assert result["part_error"].max() > 100e-6
    (spike,) = reversal_spikes(result, reference=reference)
    assert spike.axis == "x" and spike.height < 1e-9


def test_figures_of_spikes_by_hand() -> None:
    def spike(axis: str, direction: int, angle: float, height: float, time: float, width: float) -> Spike:
        return Spike(axis, time, int(time * 1e3), 0, height, time, width, direction, angle)

    spikes = [
        spike("x", -1, 0.0, 4e-6, 1.0, 0.01),
        spike("x", -1, 0.0, -8e-6, 2.0, 0.03),
        spike("x", -1, math.nan, 1e-6, 3.0, 0.05),
        spike("y", 1, 1.5 * math.pi, 2e-6, 4.0, 0.02),
    ]
    first, second, third = reversal_figures(spikes)
    assert (first.axis, first.direction, first.angle, first.count) == ("x", -1, 0.0, 2)
    assert (first.mean, first.largest, first.largest_time, first.duration) == pytest.approx((6e-6, 8e-6, 2.0, 0.02))
    assert (second.axis, second.angle) == ("y", 1.5 * math.pi)
    assert (third.axis, third.count) == ("x", 1) and math.isnan(third.angle)
    # Without places, the quadrant is given if all share it.
    together = {f.axis: f for f in reversal_figures(spikes, places=False)}
    assert together["x"].count == 3 and math.isnan(together["x"].angle)
    assert together["y"].angle == 1.5 * math.pi
    assert reversal_figures([]) == ()
