"""AxisLimits and Profile."""

from __future__ import annotations

import numpy as np
import pytest
from each import each

from contourlab.errors import FeedError, ParameterError
from contourlab.feed import AxisLimits
from contourlab.feed.reference import Profile


def test_one_number_applies_to_all_axes():
    limits = AxisLimits([0.5, 0.4], 2.0, 40.0)
    assert limits.n_axis == 2
    np.testing.assert_array_equal(limits.acceleration, [2.0, 2.0])
    np.testing.assert_array_equal(AxisLimits(0.5, 2.0).for_axes(3).jerk, [np.inf] * 3)


def test_limits_cannot_be_changed():
    with pytest.raises(ValueError, match="read-only"):
        AxisLimits([0.5], [2.0], [40.0]).velocity[0] = 1.0


@each(
    "args, name",
    [
        ((0.0, 1.0, 1.0), "velocity"),
        ((np.inf, 1.0, 1.0), "velocity"),
        ((1.0, -1.0, 1.0), "acceleration"),
        ((1.0, 1.0, np.nan), "jerk"),
        ((1.0, 1e160), "acceleration"),
        ((1.0, 1e-160), "acceleration"),
        ((1.0, 1.0, 1e-200), "jerk"),
        ((1.0, 1.0, 1e200), "jerk"),
        ((1e200, 1.0, 1.0), "velocity"),
        ((1e-200, 1.0, 1.0), "velocity"),
        (([1.0, 1.0], [1.0, 1.0, 1.0], 1.0), "velocity"),
        (([[1.0]], 1.0, 1.0), "velocity"),
    ],
)
def test_bad_limits_are_named(args, name):
    with pytest.raises(ParameterError) as caught:
        AxisLimits(*args)
    assert caught.value.name == name


def test_limits_for_another_number_of_axes_are_refused():
    with pytest.raises(FeedError, match=r"\b2 axes.*\b3\b"):
        AxisLimits([1.0, 1.0], 1.0).for_axes(3)


@pytest.fixture
def profile() -> Profile:
    # 1 s of jerk 6, then 2 s at 3 m/s after the acceleration drops to zero at once: s = 1, then 7.
    return Profile(
        t0=np.array([0.0, 1.0]),
        s0=np.array([0.0, 1.0]),
        v0=np.array([0.0, 3.0]),
        a0=np.array([0.0, 0.0]),
        j=np.array([6.0, 0.0]),
        duration=3.0,
        length=7.0,
    )


def test_motion_follows_the_polynomials(profile):
    motion = profile.motion(np.array([0.5, 2.0]))
    np.testing.assert_allclose(motion.arc_length, [0.125, 4.0], rtol=1e-15)
    np.testing.assert_allclose(motion.speed, [0.75, 3.0], rtol=1e-15)
    np.testing.assert_allclose(motion.acceleration, [3.0, 0.0], rtol=1e-15)
    np.testing.assert_array_equal(motion.jerk, [6.0, 0.0])


def test_motion_rests_outside(profile):
    motion = profile.motion(np.array([-1.0, 3.0, 9.0]))
    np.testing.assert_array_equal(motion.arc_length, [0.0, 7.0, 7.0])
    for part in motion[1:]:
        np.testing.assert_array_equal(part, 0.0)
