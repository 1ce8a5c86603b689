"""Reference, uniform, and the independent judge."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from contourlab.errors import FeedError
from contourlab.feed import AxisLimits, Reference, limit_report, plan, route_from_path, route_from_program, uniform
from contourlab.geometry import contour
from contourlab.program import parse_program

LIMITS = AxisLimits([0.5, 0.5], [1.0, 1.0], [30.0, 30.0])


@pytest.fixture(scope="module")
def planned() -> Reference:
    return plan(route_from_path(contour("ellipse"), 0.1), LIMITS, 1e-3)


@pytest.fixture(scope="module")
def line() -> Reference:
    program = parse_program("G21 G90 F6000\nG1 X20\nG1 X50\nG1 X50 Y30\nM2\n")
    return plan(route_from_program(program, axes=("x", "y")), LIMITS, 1e-3)


def test_blocks_are_slices_of_the_whole(planned):
    whole = planned.block(0, planned.n_sample)
    for start, stop in [(0, 1), (17, 170), (planned.n_sample - 3, planned.n_sample), (5, 5)]:
        for part, of_whole in zip(planned.block(start, stop), whole, strict=True):
            np.testing.assert_array_equal(part, of_whole[start:stop])


@pytest.mark.parametrize(("start", "stop"), [(-1, 3), (4, 3), (0, 10**9)])
def test_blocks_outside_are_refused(planned, start, stop):
    with pytest.raises(FeedError, match="block"):
        planned.block(start, stop)


def test_the_digest_distinguishes_references(planned):
    again = plan(route_from_path(contour("ellipse"), 0.1), LIMITS, 1e-3)
    assert again.digest == planned.digest
    slower = plan(route_from_path(contour("ellipse"), 0.09), LIMITS, 1e-3)
    finer = plan(route_from_path(contour("ellipse"), 0.1), LIMITS, 5e-4)
    assert len({planned.digest, slower.digest, finer.digest}) == 3


def test_uniform_gives_the_circle_of_the_papers():
    reference = uniform(contour("circle", radius=0.02), 0.5, 2, 1e-3)
    assert reference.n_sample == 4000
    assert reference.laps == ((0, 2000), (2000, 4000))
    block = reference.block(0, 4000)
    phase = np.pi * np.arange(4000) * 1e-3
    start = block.position[0]
    angle = np.arctan2(start[1], start[0])
    radius = np.linalg.norm(start)
    np.testing.assert_allclose(radius, 0.02, rtol=1e-14)
    expected = 0.02 * np.stack([np.cos(phase + angle), np.sin(phase + angle)], axis=1)
    np.testing.assert_allclose(block.position, expected, atol=1e-15)
    np.testing.assert_allclose(np.linalg.norm(block.velocity, axis=1), 0.02 * np.pi, rtol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(block.acceleration, axis=1), 0.02 * np.pi**2, rtol=1e-9)
    np.testing.assert_allclose(np.diff(block.arc_length), 0.02 * np.pi * 1e-3, rtol=1e-9)


def test_uniform_is_uniform_in_arc_length_on_an_ellipse():
    reference = uniform(contour("ellipse"), 0.5, 1, 1e-3)
    block = reference.block(0, reference.n_sample)
    np.testing.assert_allclose(np.linalg.norm(block.velocity, axis=1), reference.path.length * 0.5, rtol=1e-8)


def test_uniform_laps_that_end_between_samples_are_refused_with_advice():
    path = contour("circle", radius=0.02)
    with pytest.raises(FeedError, match=r"frequency = .* Hz.* servo_period = .* s") as caught:
        uniform(path, 0.3, 1, 1e-3)
    words = str(caught.value).split()
    frequency = float(words[words.index("frequency") + 2])
    assert uniform(path, frequency, 1, 1e-3).n_sample == 3333
    assert uniform(path, 0.3, 3, 1e-3).laps == ((0, 10000),)


def test_uniform_refuses_invalid_arguments():
    circle = contour("circle", radius=0.02)
    for frequency, laps in [(0.0, 1), (np.inf, 1), (1e-310, 1), (0.5, 0), (0.5, 1.5)]:
        with pytest.raises(FeedError):
            uniform(circle, frequency, laps, 1e-3)
    with pytest.raises(FeedError, match="closed"):
        uniform(contour("line-line-circle"), 0.5, 1, 1e-3)


def test_the_judge_finds_the_figures_of_a_circle():
    reference = uniform(contour("circle", radius=0.02), 0.5, 1, 1e-4)
    report = limit_report(reference, LIMITS)
    w = np.pi
    for worst in report.velocity:
        assert worst.value == pytest.approx(0.02 * w, rel=1e-6)
    for worst in report.acceleration:
        assert worst.value == pytest.approx(0.02 * w**2, rel=1e-6)
    for worst in report.jerk:
        assert worst.value == pytest.approx(0.02 * w**3, rel=1e-6, abs=worst.allowance)
    assert report.steps.sample.size == 0
    assert report.ok()


def test_the_judge_names_the_place(line):
    tight = AxisLimits([0.5, 0.02], [1.0, 1.0], [30.0, 30.0])
    report = limit_report(line, tight)
    assert not report.ok()
    worst = report.velocity[1]
    assert worst.ratio == pytest.approx(5.0, rel=1e-9)
    assert worst.source_line == 4
    assert worst.position[0] == pytest.approx(0.05, abs=1e-12)
    assert 0.0 <= worst.position[1] <= 0.03
    assert worst.time == worst.sample * 1e-3


def test_the_judge_uses_samples_and_not_derivatives(line):
    block = line.block(0, line.n_sample)
    position = block.position.copy()
    position[100:] += [1e-6, 0.0]  # a step of one micrometre
    spoilt = Reference.from_samples(position, 1e-3, line.path, source_lines=line.source_lines)
    report = limit_report(spoilt, LIMITS)
    assert not report.ok()
    assert report.jerk[0].value == pytest.approx(2e-6 / 1e-9, rel=0.05)
    assert abs(report.jerk[0].sample - 100) <= 2
    assert report.jerk[1].ratio <= 1.0


def test_imported_samples_are_judged_like_their_original_plan(line):
    position = line.block(0, line.n_sample).position
    copy = Reference.from_samples(position, 1e-3, line.path, source_lines=line.source_lines)
    ours, theirs = limit_report(line, LIMITS), limit_report(copy, LIMITS)
    assert theirs.ok()
    for one, other in zip(ours.velocity + ours.acceleration, theirs.velocity + theirs.acceleration, strict=True):
        assert dataclasses.replace(one, position=()) == dataclasses.replace(other, position=(), allowance=one.allowance)


def test_from_samples_gives_central_differences():
    time = np.arange(1001) * 1e-3
    position = np.stack([0.1 * time**2, 0.2 * time], axis=1)
    path = contour("line-line-circle")
    reference = Reference.from_samples(position, 1e-3, path)
    block = reference.block(1, 1000)
    np.testing.assert_allclose(block.velocity, np.stack([0.2 * time, 0.2 + 0 * time], axis=1)[1:-1], rtol=1e-9)
    np.testing.assert_allclose(block.acceleration[:, 0], 0.2, rtol=1e-6)
    for part, whole in zip(reference.block(40, 60), block, strict=True):
        np.testing.assert_array_equal(part, whole[39:59])
    assert reference.duration == pytest.approx(1.0)
    assert reference.digest != Reference.from_samples(position * 1.1, 1e-3, path).digest


@pytest.mark.parametrize(
    ("position", "options", "words"),
    [
        (np.zeros((5, 3)), {}, "shape"),
        (np.zeros((1, 2)), {}, "shape"),
        (np.array([[0.0, 0.0], [np.nan, 0.0]]), {}, "sample 1"),
        (np.zeros((5, 2)), {"arc_length": [0.0, 1.0]}, "arc_length"),
        (np.zeros((5, 2)), {"source_lines": np.arange(99)}, "source_lines"),
    ],
)
def test_from_samples_refuses_inconsistent_arrays(position, options, words):
    with pytest.raises(FeedError, match=words):
        Reference.from_samples(position, 1e-3, contour("circle", radius=0.02), **options)


def test_the_judge_reads_in_blocks(line, monkeypatch):
    whole = limit_report(line, LIMITS)
    monkeypatch.setattr("contourlab.feed.reference.BLOCK", 97)
    parts = limit_report(line, LIMITS)
    for one, other in zip(whole.all(), parts.all(), strict=True):
        assert one.value == pytest.approx(other.value, rel=1e-12)
    np.testing.assert_array_equal(parts.steps.sample, whole.steps.sample)
