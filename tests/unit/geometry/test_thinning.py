"""The corners of a long polygon."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from contourlab.errors import GeometryError
from contourlab.geometry.thinning import corners, polygon_corners

TOLERANCE = 1e-8


def strayed(points: np.ndarray, kept: np.ndarray) -> float:
    """Return the distance of each point from its line of the polygon through the kept points."""
    worst = 0.0
    for first, last in pairwise(kept):
        way = (points[last] - points[first]) / np.linalg.norm(points[last] - points[first])
        off = points[first : last + 1] - points[first]
        along = off @ way
        assert np.all(np.diff(along) >= -1e-15)
        worst = max(worst, float(np.linalg.norm(off - np.outer(along, way), axis=1).max()))
    return worst


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 2**32 - 1), st.integers(1, 3), st.sampled_from([1e-9, 1e-8, 1e-7]), st.integers(2, 400))
def test_no_point_is_further_off_than_the_tolerance(seed: int, n_axis: int, step: float, n: int) -> None:
    """Walks on a raster around a circle, like a logged reference: machine code and plain Python keep the same points."""
    rng = np.random.default_rng(seed)
    angle = np.cumsum(rng.uniform(0.0, 1e-4, n))
    smooth = 0.01 * np.column_stack([np.cos(angle), np.sin(angle), angle])[:, :n_axis]
    points = np.round(smooth / step) * step
    points = points[np.append(True, (np.diff(points, axis=0) != 0.0).any(axis=1))]
    kept = polygon_corners(points, TOLERANCE)
    assert kept[0] == 0 and kept[-1] == len(points) - 1 and np.all(np.diff(kept) > 0)
    assert strayed(points, kept) <= TOLERANCE * (1.0 + 1e-6)
    plain, count = np.empty(len(points), dtype=np.int64), np.empty(1, dtype=np.int64)
    corners(points, TOLERANCE, plain, count)
    assert kept.tolist() == plain[: count[0]].tolist()


def test_a_long_line_and_its_corner() -> None:
    way = np.linspace(0.0, 0.1, 100_001)
    points = np.vstack([np.column_stack([way, 0.0 * way]), [[0.1, 0.02]]])
    assert polygon_corners(points, TOLERANCE).tolist() == [0, 100_000, 100_001]


def test_turning_back_on_a_line_is_a_corner() -> None:
    way = np.concatenate([np.linspace(0.0, 0.01, 1000), np.linspace(0.01, 0.002, 1000)[1:]])
    assert polygon_corners(np.column_stack([way, 0.0 * way]), TOLERANCE).tolist() == [0, 999, 1998]


def test_lines_on_an_arc_have_the_maximum_length() -> None:
    """The sagitta of a chord on a circle is the tolerance: c = sqrt(8 R tolerance)."""
    angle = np.linspace(0.0, np.pi, 200_001)
    kept = polygon_corners(0.02 * np.column_stack([np.cos(angle), np.sin(angle)]), TOLERANCE)
    assert np.pi * 0.02 / (len(kept) - 1) == pytest.approx(np.sqrt(8.0 * 0.02 * TOLERANCE), rel=0.01)


@pytest.mark.parametrize("points", [np.empty((0, 2)), np.zeros(3), np.array([[0.0, 0.0], [0.0, 0.0]])])
def test_an_invalid_polygon_is_refused(points: np.ndarray) -> None:
    with pytest.raises(GeometryError):
        polygon_corners(points, TOLERANCE)


def test_one_point_is_its_own_corner() -> None:
    assert polygon_corners(np.zeros((1, 2)), TOLERANCE).tolist() == [0]
