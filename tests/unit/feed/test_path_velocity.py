"""A bound of the velocity along the path, in the limits that every plan keeps."""

import numpy as np
import pytest

from contourlab.feed import AxisLimits, blended, limit_report, plan, route_from_path
from contourlab.feed.planner import Binding, limiting
from contourlab.feed.route import controlled
from contourlab.geometry import Line, Path


@pytest.mark.parametrize("corner", [0.0, 1e-4])
def test_no_move_is_faster_than_the_bound(corner: float) -> None:
    """On a diagonal, where each axis could be faster; the feedrate is what limits, and the axes keep their own limits."""
    path = Path([Line((0.0, 0.0), (0.3, 0.3)), Line((0.3, 0.3), (0.3, 0.0))])
    limits = AxisLimits([0.5, 0.5], 2.0, 40.0, path_velocity=0.1)
    route = blended(controlled(route_from_path(path, 0.4), "blend" if corner else "exact_path", corner, 0.0), limits)
    reference = plan(route, limits, 1e-3)
    block = reference.block(0, reference.n_sample)
    assert np.linalg.norm(block.velocity, axis=1).max() == pytest.approx(0.1, rel=1e-9)
    assert limiting(route, limits, reference.profile, [0.1])[0] == Binding.FEEDRATE
    assert limit_report(reference, limits).ok
    same = plan(blended(controlled(route_from_path(path, 0.1), "blend" if corner else "exact_path", corner, 0.0), limits), limits, 1e-3)
    assert same.duration == reference.duration


def test_a_limit_of_one_axis_for_all_keeps_the_bound() -> None:
    assert AxisLimits(1.0, 2.0, path_velocity=0.3).for_axes(3).path_velocity == 0.3
    assert AxisLimits(1.0, 2.0).for_axes(3).path_velocity == np.inf
