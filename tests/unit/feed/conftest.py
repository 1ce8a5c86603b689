"""The analytic judge of planned motions."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from contourlab.feed import AxisLimits, Reference

Demand = Callable[..., tuple[float, float, float]]


def _demand(reference: Reference, limits: AxisLimits, per_span: int = 40) -> tuple[float, float, float]:
    """Return the greatest velocity, acceleration and jerk relative to the limits, from derivatives of path and profile.

    Only the inside of every span counts, so that nothing straddles a corner or a jump of jerk or curvature.
    """
    profile = reference.profile
    assert profile is not None
    limits = limits.for_axes(reference.n_axis)
    ends = np.append(profile.t0[1:], profile.duration)
    inside = np.linspace(1e-4, 1.0 - 1e-4, per_span)
    time = (profile.t0[:, None] + (ends - profile.t0)[:, None] * inside).ravel()
    motion = profile.motion(time)
    _, t, k, c = reference.path.derivatives(motion.arc_length, 3)
    v, a, j = (part[:, None] for part in motion[1:])
    velocity, acceleration, jerk = t * v, t * a + k * v**2, t * j + 3 * k * v * a + c * v**3
    parts = zip((velocity, acceleration, jerk), (limits.velocity, limits.acceleration, limits.jerk), strict=True)
    worst = [float(np.max(np.abs(value) / limit)) for value, limit in parts]
    return worst[0], worst[1], worst[2]


@pytest.fixture(scope="session")
def demand() -> Demand:
    """Judge of planned motions by analytic derivatives."""
    return _demand
