"""Chains: order, direction, gaps, duplicates, and messages about several chains."""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path as File
from typing import Any

import numpy as np
import pytest
from drawings import MM, away, dxf
from hypothesis import given, settings
from hypothesis import strategies as st

from contourlab.contours import read_contour
from contourlab.contours.drawing import Strand, chains_of
from contourlab.contours.dxf import read_dxf
from contourlab.errors import GeometryError
from contourlab.geometry import Arc, Line
from contourlab.geometry.path import JOIN_TOLERANCE


@given(
    steps=st.lists(st.tuples(st.floats(0.1, 5.0), st.floats(-2.5, 2.5)), min_size=1, max_size=30),
    seed=st.integers(0, 2**32 - 1),
    noise=st.floats(0.0, 0.3),
)
@settings(max_examples=60)
def test_shuffled_and_reversed_lines_form_the_polygon_again(steps: list[tuple[float, float]], seed: int, noise: float) -> None:
    rng = np.random.default_rng(seed)
    # Steps to the right only, so that no two corners meet.
    corners = np.cumsum(np.array([(0.0, 0.0), *steps]), axis=0)
    strands = []
    for a, b in pairwise(corners):
        a, b = (p + noise * 1e-6 * rng.uniform(-1.0, 1.0, 2) for p in (a, b))
        strands.append(Strand((Line(a, b) if rng.random() < 0.5 else Line(b, a),)))
    order = rng.permutation(len(strands))
    chains, left_out = chains_of([strands[i] for i in order], 1e-6)
    assert len(chains) == 1
    assert not left_out
    path = chains[0].path
    # Its direction is that of the first line in the drawing.
    ran = corners if strands[order[0]].ends[0][0] < strands[order[0]].ends[1][0] else corners[::-1]
    np.testing.assert_allclose(path.position(path.breaks), ran, rtol=0, atol=1e-6)
    assert len(path.curves) == len(steps)


def test_gaps_are_closed_and_curves_keep_their_places(tmp_path: File) -> None:
    gap = 0.8e-3  # mm

    def draw(m: Any) -> None:
        m.add_arc((0, 0), 10, 0, 90)
        m.add_line((gap, 10), (-20, 10))
        m.add_open_spline([(-20, 10 - gap, 0), (-30, 5, 0), (-25, -5, 0), (-20, -10, 0)], degree=3)
        m.add_ellipse((-20, 0), (0, -10 - gap), 0.5, 0, 1.2)

    path = read_contour(dxf(tmp_path, draw))
    assert len(path.curves) == 4
    ends, starts = [c.position(c.length)[0] for c in path.curves[:-1]], [c.position(0.0)[0] for c in path.curves[1:]]
    assert np.linalg.norm(np.array(ends) - starts, axis=1).max() <= JOIN_TOLERANCE
    assert isinstance(path.curves[0], Arc)
    # Only a line next to an arc has moved; arc and ellipse by no more than the gap.
    assert path.curves[0].radius == pytest.approx(0.01, rel=1e-15)
    with pytest.raises(GeometryError, match=r"\b[34]\b.*chains"):
        read_contour(tmp_path / "part.dxf", tolerance=1e-7)


@given(st.lists(st.floats(-0.9, 0.9), min_size=8, max_size=8))
@settings(max_examples=30)
def test_no_point_moves_further_than_three_gaps(errors: list[float]) -> None:
    """Two half circles and two lines with gaps at all four joints."""
    e = 1e-6 * np.array(errors).reshape(4, 2) / math.sqrt(2.0)
    exact = [
        Line((-1, -1), (1, -1)),
        Arc((1, 0), 1.0, -math.pi / 2, math.pi),
        Line((1, 1), (-1, 1)),
        Arc((-1, 0), 1.0, math.pi / 2, math.pi),
    ]
    shifted = [
        Line(c.start + d, c.end + d) if isinstance(c, Line) else Arc(c.centre + d, 1.0, c.start_angle, c.sweep)
        for c, d in zip(exact, e, strict=True)
    ]
    chains, _ = chains_of([Strand((curve,)) for curve in shifted], 3e-6)
    assert len(chains) == 1
    path = chains[0].path
    assert path.closed
    samples = np.concatenate([curve.position(np.linspace(0.0, curve.length, 5)) for curve in shifted])
    assert away(path, samples) < 3.0 * 2e-6


def test_several_chains_are_listed(tmp_path: File) -> None:
    def draw(m: Any) -> None:
        m.add_line((1, 2), (5, 2), dxfattribs={"layer": "cut"})
        m.add_circle((20, 0), 5, dxfattribs={"layer": "hole"})
        m.add_line((5, 8), (5, 2), dxfattribs={"layer": "cut"})

    file = dxf(tmp_path, draw)
    with pytest.raises(GeometryError) as met:
        read_contour(file)
    text = str(met.value)
    first, second = text.index("1: open, 10 mm"), text.index("2: closed, 31.4159 mm")
    assert "(1, 2) mm, layer cut" in text[first:second] and "(25, 0) mm" in text[second:]
    assert "chain = 1" in text and "layer = " in text
    assert read_contour(file, chain=2).closed
    assert read_contour(file, chain=1).length == pytest.approx(10 * MM)
    assert read_contour(file, layer="hole").digest == read_contour(file, chain=2).digest
    with pytest.raises(GeometryError, match=r"chain = 3 .* 2 "):
        read_contour(file, chain=3)


def test_branches_end_chains(tmp_path: File) -> None:
    def draw(m: Any) -> None:
        for end in ((10, 0), (-10, 1), (0, 10)):
            m.add_line((0, 0), end)

    assert len(read_dxf(dxf(tmp_path, draw)).chains) == 3


def test_circles_that_touch_are_two(tmp_path: File) -> None:
    file = dxf(tmp_path, lambda m: (m.add_circle((-5, 0), 5), m.add_arc((5, 0), 5, 180, 180 + 359.999999999)))
    chains = read_dxf(file).chains
    assert [chain.closed for chain in chains] == [True, True]


def test_duplicates_and_specks_are_noted(tmp_path: File) -> None:
    def draw(m: Any) -> None:
        m.add_line((0, 0), (10, 0))
        m.add_line((10, 0), (0, 0))
        m.add_line((10, 0), (10, 5e-4))
        m.add_line((3, 3), (3, 3))
        m.add_arc((5, 0), 5, 0, 180)

    drawing = read_dxf(dxf(tmp_path, draw))
    assert len(drawing.chains) == 1
    assert drawing.chains[0].closed
    said = " | ".join(drawing.notes)
    assert "no length" in said
    assert "two tolerances" in said
    assert "on LINE" in said


def test_the_order_of_entities_alone_decides_start_and_direction(tmp_path: File) -> None:
    sides = [((0, 0), (10, 0)), ((10, 0), (10, 10)), ((10, 10), (0, 10)), ((0, 10), (0, 0))]
    for first in range(4):
        rows = sides[first:] + sides[:first]
        path = read_contour(dxf(tmp_path, lambda m, r=rows: [m.add_line(*side) for side in r]))
        np.testing.assert_allclose(path.position([0.0, 0.005]), MM * np.array([rows[0][0], np.mean(rows[0], axis=0)]), atol=1e-15)


@pytest.mark.parametrize("tolerance", [0.0, -1.0, math.inf, math.nan])
def test_a_tolerance_out_of_range_is_refused(tmp_path: File, tolerance: float) -> None:
    file = dxf(tmp_path, lambda m: m.add_line((0, 0), (1, 0)))
    with pytest.raises(GeometryError, match=r"tolerance = .*> 0"):
        read_contour(file, tolerance=tolerance)
