"""Figures of errors with closed-form sums."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from made_runs import PERIOD, Array, circle_laps, made_run, samples_on, with_error

from contourlab.app.json_values import json_values
from contourlab.errors import ResultError
from contourlab.feed import Reference, uniform
from contourlab.feed.reference import Judged
from contourlab.geometry import Line, Path, contour
from contourlab.metrics.figures import ErrorFigures, summarise
from contourlab.metrics.judge import judge
from contourlab.result import Result, Signal

N = 4000


def figures_of(error: Array) -> ErrorFigures:
    reference = circle_laps(len(error))
    result = with_error(made_run(reference, reference.block(0, len(error)).position), error)
    return summarise(result, reference).contour_error


def test_sine_over_whole_periods() -> None:
    """rms A/sqrt 2, mean of |.| 2A/pi, max A, 95 % below A sin(0.475 pi), signed mean 0, integral mean * T."""
    amplitude = 3e-6
    found = figures_of(amplitude * np.sin(2.0 * np.pi * 5.0 * (np.arange(N) + 0.5) / N))
    grid = (np.pi * 5.0 / N) ** 2  # error of the midpoint rule on |sin|
    assert found.rms == pytest.approx(amplitude / math.sqrt(2.0), rel=1e-12)
    assert found.mean == pytest.approx(amplitude * 2.0 / math.pi, rel=grid)
    assert found.max == pytest.approx(amplitude, rel=grid)
    assert found.p95 == pytest.approx(amplitude * math.sin(0.475 * math.pi), rel=2e-3)
    assert abs(found.signed_mean) < 1e-20
    assert found.integral == pytest.approx(found.mean * N * PERIOD, rel=1e-12)


def test_ramp() -> None:
    """|e| = k on samples 1 .. 100: mean 50.5, rms sqrt(101 * 201/6), integral 5050 dt; the sign alternates."""
    k = np.arange(1, 101) * 1e-6
    found = figures_of(k * np.where(np.arange(100) % 2, 1.0, -1.0))
    assert found.mean == pytest.approx(50.5e-6, rel=1e-13)
    assert found.rms == pytest.approx(1e-6 * math.sqrt(101 * 201 / 6), rel=1e-13)
    assert found.integral == pytest.approx(5050e-6 * PERIOD, rel=1e-13)
    assert found.signed_mean == pytest.approx(0.5e-6, rel=1e-12)
    assert 95e-6 <= found.p95 <= 96e-6
    # Without the mean m: 50 values k - m and 50 of k + m, whose magnitudes are the values themselves.
    assert found.integral_without_mean == pytest.approx(5050e-6 * PERIOD, rel=1e-12)


@pytest.mark.parametrize("clockwise", [0.0, 1.0])
@pytest.mark.parametrize("radius_error", [12.5e-6, -40e-6])
def test_radius_error(radius_error: float, clockwise: float) -> None:
    """A circle too large by dr: every figure is |dr|, its integral over the period |dr| T; without the mean nothing is left."""
    reference = circle_laps(800, laps=2, clockwise=clockwise)
    tool = reference.block(0, 1600).position * (1.0 + radius_error / 0.02)
    found = summarise(judge(made_run(reference, tool), reference), reference).part_error
    size = abs(radius_error)
    for figure in (found.rms, found.max, found.mean, found.p95):
        assert figure == pytest.approx(size, rel=1e-10)
    assert found.integral == pytest.approx(size * 800 * PERIOD, rel=1e-10)
    assert found.signed_mean == pytest.approx(-radius_error if clockwise == 0.0 else radius_error, rel=1e-10)
    assert found.integral_without_mean < 1e-15


def test_worst_place_is_where_it_was_planted() -> None:
    path = Path([Line((0.0, 0.0), (0.1, 0.0)), Line((0.1, 0.0), (0.1, 0.05))])
    along = np.linspace(0.0, path.length, 301)
    reference = Reference.from_samples(path.position(along), PERIOD, path, arc_length=along, source_lines=[11, 12])
    tool = np.array(reference.block(0, 301).position)
    tool[250, 0] += 4e-5
    tool[20, 1] -= 3e-5
    found = summarise(judge(made_run(reference, tool), reference), reference).contour_error
    assert found.max == pytest.approx(4e-5, rel=1e-10)
    worst = found.worst
    assert (worst.sample, worst.line) == (250, 12)
    assert worst.time == pytest.approx(0.25)
    assert worst.arc_length == pytest.approx(0.125)
    assert worst.position == pytest.approx((0.1 + 4e-5, 0.025))


def test_tracking_of_each_axis() -> None:
    path = Path([Line((0.0, 0.0), (0.1, 0.0))])
    reference = samples_on(path, np.linspace(0.0, 0.1, 400))
    wave = np.sin(2.0 * np.pi * (np.arange(400) + 0.5) / 400)
    tool = reference.block(0, 400).position - np.column_stack([2e-3 * np.ones(400), 6e-6 * wave])
    x, y = summarise(judge(made_run(reference, tool), reference), reference).tracking_error
    assert (x.rms, x.max) == pytest.approx((2e-3, 2e-3), rel=1e-10)
    assert (y.rms, y.max) == pytest.approx((6e-6 / math.sqrt(2.0), 6e-6), rel=1e-4)


def test_the_last_lap_counts() -> None:
    reference = circle_laps(100, laps=3)
    error = np.concatenate([np.full(100, 9e-6), np.full(100, 5e-6), np.full(100, 2e-6)])
    result = with_error(made_run(reference, reference.block(0, 300).position), error)
    last = summarise(result, reference)
    assert last.judged == Judged(((200, 300),), "last lap")
    assert last.contour_error.max == 2e-6
    assert summarise(result, reference, (100, 200)).contour_error.max == 5e-6
    # If the last lap fails, the previous one is judged.
    assert summarise(result.window(0, 250), reference).contour_error.max == 5e-6
    assert summarise(result.window(0, 99), reference).judged == Judged(((0, 99),), "whole motion")


def test_a_window_of_a_run_keeps_its_laps() -> None:
    """Samples count from the start of the window, laps from the start of the run."""
    reference = circle_laps(100, laps=3)
    error = np.concatenate([np.full(100, 9e-6), np.full(100, 5e-6), np.full(100, 2e-6)])
    result = with_error(made_run(reference, reference.block(0, 300).position), error)
    later = summarise(result.window(150, 300), reference)
    assert later.judged.ranges == ((50, 150),)
    assert later.contour_error.mean == pytest.approx(2e-6, rel=1e-12)
    assert later.contour_error.worst.sample == 200
    assert later.contour_error.worst.time == pytest.approx(0.2)
    assert summarise(result.window(150, 250), reference).basis == "whole motion"


def test_feedrate_of_a_circle_run_too_large() -> None:
    """Chord of the n-th part of a lap: 2 R' sin(pi/n)/dt; a steady speed has no ripple."""
    reference = circle_laps(500)
    tool = reference.block(0, 500).position * 1.01
    found = summarise(judge(made_run(reference, tool), reference), reference)
    assert found.feedrate_mean == pytest.approx(2.0 * 0.02 * 1.01 * math.sin(math.pi / 500) / PERIOD, rel=1e-12)
    assert found.feedrate_ripple < 1e-11
    assert found.cycle_time == pytest.approx(0.499)


def test_feedrate_ripple_of_a_planted_wave() -> None:
    """Speed v (1 + m sin): standard deviation m/sqrt 2 of the programmed speed."""
    path = Path([Line((0.0, 0.0), (1.0, 0.0))])
    n, speed, depth = 2001, 0.1, 0.05
    along = 0.1 + speed * PERIOD * np.arange(n)
    between = speed * (1.0 + depth * np.sin(2.0 * np.pi * 20.0 * np.arange(n - 1) / (n - 1)))
    tool = np.column_stack([0.1 + PERIOD * np.concatenate([[0.0], np.cumsum(between)]), np.zeros(n)])
    result = made_run(samples_on(path, along), tool, feedrate=np.full(n, speed))
    found = summarise(judge(result, samples_on(path, along)), samples_on(path, along))
    assert found.feedrate_mean == pytest.approx(speed, rel=1e-9)
    assert found.feedrate_ripple == pytest.approx(depth / math.sqrt(2.0), rel=1e-9)


def test_ramps_of_the_feed_are_no_ripple() -> None:
    """Following a reference that changes speed is no ripple."""
    path = Path([Line((0.0, 0.0), (1.0, 0.0))])
    feed = np.concatenate([np.linspace(0.0, 0.1, 300), np.full(400, 0.1), np.linspace(0.1, 0.0, 300)])
    along = np.concatenate([[0.0], np.cumsum(feed[:-1] * PERIOD)])
    result = made_run(samples_on(path, along), path.position(along), feedrate=feed)
    assert summarise(judge(result, samples_on(path, along)), samples_on(path, along)).feedrate_ripple < 1e-9


def saturated(command: Array, limits: tuple[float, float]) -> Result:
    reference = circle_laps(len(command))
    made = with_error(made_run(reference, reference.block(0, len(command)).position), np.zeros(len(command)))
    signal = Signal(command, ("sample", "axis"), "A")
    attributes = dict(zip(("command_limit_x", "command_limit_y"), limits, strict=True))
    return Result("made", made.axes, PERIOD, {**made.signals, "applied_command": signal}, attributes=attributes)


def test_saturation_share() -> None:
    command = np.zeros((200, 2))
    command[:30, 0] = 0.5
    command[100:120, 0] = -0.5
    command[120:130, 0] = 0.4999
    command[:, 1] = 1e9
    found = summarise(saturated(command, (0.5, math.inf)), circle_laps(200)).saturation
    assert found == (50 / 200, 0.0)


def test_saturation_counts_the_window_only() -> None:
    command = np.zeros((200, 2))
    command[:100, 0] = 0.5
    assert summarise(saturated(command, (0.5, 1.0)), circle_laps(200), (50, 150)).saturation == (0.5, 0.0)


@pytest.mark.parametrize("window", [(5, 5), (0, 101), (-1, 50), (60, 40)])
def test_window_outside_the_run(window: tuple[int, int]) -> None:
    reference = circle_laps(100)
    result = with_error(made_run(reference, reference.block(0, 100).position), np.zeros(100))
    with pytest.raises(ResultError, match=rf"window {window[0]} \.\. {window[1]}\b.*100 samples"):
        summarise(result, reference, window)


def test_an_unjudged_run() -> None:
    reference = circle_laps(100)
    with pytest.raises(ResultError, match=r"'tracking_error'.* judge\(result, reference\)"):
        summarise(made_run(reference, reference.block(0, 100).position), reference)


def test_figures_as_json() -> None:
    """JSON has no NaN: an unknown ripple is null."""
    reference = uniform(contour("circle"), 500.0, 1, 1e-3)
    result = with_error(made_run(reference, reference.block(0, 2).position), np.array([1e-6, -1e-6]))
    plain = json_values(summarise(result, reference))
    assert plain["feedrate_ripple"] is None
    assert json.loads(json.dumps(plain, allow_nan=False))["contour_error"]["max"] == 1e-6
