"""Invariants of merged and rounded routes over polylines with arcs drawn at random, in the plane and in space."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from contourlab.feed import Route, blended
from contourlab.geometry import Arc, Curve, Line, Path
from contourlab.geometry.blend import Blend

Array = NDArray[np.float64]
few = settings(max_examples=40, deadline=None)


@st.composite
def routes(draw: st.DrawFn) -> Route:
    """Lines and arcs of lengths over three decades at any angle, with tolerances from a tenth of a micron to a millimetre."""
    n_axis, n = draw(st.integers(2, 3)), draw(st.integers(2, 14))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    bent = draw(st.sampled_from([0.0, 0.5]))
    scale = 10.0 ** rng.uniform(-5.0, -2.0, n)
    curves: list[Curve] = []
    at = rng.uniform(-1.0, 1.0, n_axis) * draw(st.sampled_from([0.0, 1.0]))
    for k in range(n):
        frame = np.linalg.qr(rng.normal(size=(n_axis, n_axis)))[0].T
        if rng.uniform() < bent:
            first, rise = rng.uniform(0.0, 6.0), None
            if n_axis == 3 and rng.uniform() < 0.5:
                rise = scale[k] * rng.uniform(-2.0, 2.0) * frame[2]
            centre = at - scale[k] * (math.cos(first) * frame[0] + math.sin(first) * frame[1])
            curves.append(Arc(centre, scale[k], first, rng.uniform(0.1, 6.0) * rng.choice([-1.0, 1.0]), frame[0], frame[1], rise))
        else:
            curves.append(Line(at, at + scale[k] * frame[0]))
        at = curves[-1].position(curves[-1].length)[0]
    corner, merge = 10.0 ** draw(st.floats(-7.0, -3.0)), draw(st.sampled_from([0.0, 1e-6, 1e-4]))
    feedrate = rng.choice([0.01, 0.02], n) if draw(st.booleans()) else np.full(n, 0.01)
    return Route(Path(curves), feedrate, False, 0.0, np.arange(1, n + 1), corner_tolerance=corner, merge_tolerance=merge)


def reach(route: Route) -> float:
    corner, merge = float(route.corner_tolerance[0]), float(route.merge_tolerance[0])
    return corner if merge <= corner else merge + 0.5 * corner


@few
@given(routes())
def test_no_point_is_further_from_the_programmed_path_than_the_tolerances(route: Route) -> None:
    found = blended(route)
    path = found.path
    s = (path.breaks[:-1, None] + np.diff(path.breaks)[:, None] * np.linspace(0.0, 1.0, 41)).ravel()
    # Distance to any point of the path; a test below checks the order of travel.
    distance = route.path.foot_point(path.position(s), found.programmed_arc_length(s), route.path.length).distance
    assert distance.max() <= reach(route) * (1.0 + 1e-9) + 1e-15


@few
@given(routes())
def test_no_programmed_corner_is_further_away_than_the_tolerances(route: Route) -> None:
    found = blended(route)
    joints = route.path.breaks[1:-1]
    if found.correspondence is None or not joints.size:
        return
    distance = found.path.foot_point(route.path.position(joints), joints * 0.0, found.path.length).distance
    assert distance.max() <= reach(route) * (1.0 + 1e-9) + 1e-15


@few
@given(routes())
def test_the_arc_length_map_rises_and_leads_to_nearby_points(route: Route) -> None:
    found = blended(route)
    s = np.unique(np.concatenate([np.linspace(0.0, found.path.length, 201), found.path.breaks]))
    at = found.programmed_arc_length(s)
    assert (np.diff(at) > 0.0).all()
    np.testing.assert_allclose(at[[0, -1]], [0.0, route.path.length], rtol=1e-14, atol=1e-18)
    ends = [path.position([0.0, path.length]) for path in (found.path, route.path)]
    np.testing.assert_allclose(ends[0], ends[1], rtol=0, atol=1e-15)
    # On the remaining parts of unmerged lines and arcs the positions are identical.
    if route.merge_tolerance[0] == 0.0:
        kept = np.array([not isinstance(curve, Blend) for curve in found.path.curves])[found.path.curve_index(s)]
        kept &= np.abs(s[:, None] - found.path.breaks).min(axis=1) > 1e-12
        np.testing.assert_allclose(found.path.position(s[kept]), route.path.position(at[kept]), rtol=0, atol=1e-14)


@few
@given(routes())
def test_joints_are_smooth_up_to_curvature_except_at_kept_corners(route: Route) -> None:
    found = blended(route)
    path = found.path
    curve, span = np.arange(found.n_curve - 1), np.diff(path.breaks)
    before, after = path.at(curve, span[:-1], 2), path.at(curve + 1, 0.0 * span[1:], 2)
    blend = np.array([isinstance(c, Blend) for c in path.curves])
    joint = np.flatnonzero(blend[1:] | blend[:-1])
    turned = np.linalg.norm(after[1] - before[1], axis=1)[joint]
    # A joint next to a blend is smooth, or it is a corner of the programmed path.
    smooth = joint[turned < 1e-6]
    assert np.isin(found.programmed_arc_length(path.breaks[1:-1][joint[turned >= 1e-6]]).round(13), route.path.breaks.round(13)).all()
    # Compare curvatures relative to the sharpest bend nearby and to the rounding of coordinates.
    size = np.abs(path.derivatives((path.breaks[:-1, None] + span[:, None] * np.linspace(0.01, 0.99, 25)).ravel(), 2)[2])
    local = size.reshape(found.n_curve, -1).max(axis=1)
    limit = 1e-7 * np.maximum(local[smooth], local[smooth + 1]) + 1e-6
    assert (np.abs(after[2] - before[2])[smooth].max(axis=1, initial=0.0) <= limit).all()
