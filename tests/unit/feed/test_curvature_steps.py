"""Steps of acceleration where the curvature jumps: their size in closed form, and what a picture of the jerk shows there."""

from __future__ import annotations

import numpy as np
import pytest

from contourlab.feed import AxisLimits, Reference, limit_report, plan, route_from_path
from contourlab.geometry import Arc, Line, Path

PERIOD, RADIUS = 1e-3, 0.01
LIMITS = AxisLimits([0.5, 0.5], [3.0, 3.0], [40.0, 40.0])


def bend(length: float) -> Path:
    """A line along x, then half a circle that turns left."""
    return Path([Line((0.0, 0.0), (length, 0.0)), Arc(np.array([length, RADIUS]), RADIUS, -0.5 * np.pi, np.pi)])


# The lines end at the full feed, and on the ramp to it.
@pytest.mark.parametrize("length", [0.05, 1e-3, 3e-4])
def test_a_step_is_the_square_of_the_speed_over_the_radius(length: float) -> None:
    reference = plan(route_from_path(bend(length), 0.05), LIMITS, PERIOD)
    report = limit_report(reference, LIMITS)
    assert reference.profile is not None
    span, dt = reference.profile.reached(np.array([length]))
    v = float((reference.profile.v0 + dt * (reference.profile.a0 + 0.5 * dt * reference.profile.j))[span][0])
    assert (v == pytest.approx(0.05, rel=1e-6)) is (length == 0.05)
    step = report.curvature_step[1]
    assert step.value == pytest.approx(v**2 / RADIUS, rel=5e-3)
    assert step.ratio == pytest.approx(step.value / 3.0, rel=1e-6)
    block = reference.block(step.sample, step.sample + 2)
    assert block.arc_length[0] <= length + 1e-12 and block.arc_length[1] >= length - 1e-12


def test_a_stop_has_no_step() -> None:
    report = limit_report(plan(route_from_path(bend(0.05), 0.05), LIMITS, PERIOD, curvature_step=0.0), LIMITS)
    assert report.curvature_step[1].value < 1e-6
    assert report.jerk_peaks(1, PERIOD).sample.size == 0


@pytest.mark.parametrize("feed", [0.02, 0.05, 0.1])
def test_the_jerk_exceeds_its_limit_at_the_listed_steps_only(feed: float) -> None:
    curves = [Line((0.0, 0.0), (0.05, 0.0)), Arc(np.array([0.05, RADIUS]), RADIUS, -0.5 * np.pi, np.pi), Line((0.05, 0.02), (0.0, 0.02))]
    reference = plan(route_from_path(Path(curves), feed), LIMITS, PERIOD)
    report = limit_report(reference, LIMITS)
    drawn = np.abs(np.diff(reference.block(0, reference.n_sample).acceleration, axis=0)) / PERIOD
    for axis in range(2):
        peaks = report.jerk_peaks(axis, PERIOD)
        above = np.flatnonzero(drawn[:, axis] > 40.0 * (1.0 + 1e-6))
        np.testing.assert_array_equal(above, peaks.sample)
        # Turning changes the acceleration by a little more within the servo period.
        np.testing.assert_allclose(drawn[above, axis], peaks.size / PERIOD, rtol=0.05)
        assert report.jerk[axis].value <= 40.0 * (1.0 + 1e-6)
    assert (report.jerk_peaks(1, PERIOD).sample.size > 0) is (feed**2 / RADIUS > 40.0 * PERIOD)


def test_a_step_that_the_curvature_does_not_explain_is_found() -> None:
    path, feed = bend(0.05), 0.02
    at = feed * PERIOD * np.arange(3000)
    position = path.position(at)
    late = np.maximum(at / feed - 2.5, 0.0)
    jolted = position + np.stack([0.0 * late, 0.5 * 4.0 * late**2], axis=1)
    assert limit_report(Reference.from_samples(position, PERIOD, path, arc_length=at), LIMITS).ok()
    wide = AxisLimits([10.0, 10.0], [100.0, 3.0], [40.0, 40.0])
    report = limit_report(Reference.from_samples(jolted, PERIOD, path, arc_length=at), wide)
    # Five periods of permitted jerk are taken off, because they could explain as much.
    assert report.curvature_step[1].value == pytest.approx(4.0 + feed**2 / RADIUS - 5.0 * 40.0 * PERIOD, rel=1e-3)
    assert report.curvature_step[1].ratio > 1.0
