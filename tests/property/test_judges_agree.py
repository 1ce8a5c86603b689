"""The judge of a batch, the exact judge and brute force agree on sharp paths that the tool cuts short."""

from __future__ import annotations

import itertools
import math
from typing import Any

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given, settings
from made_runs import Array, made_run, samples_on
from streamed_judge import streamed

from contourlab.geometry import Arc, Line, Path
from contourlab.metrics.judge import furthest, judge, reach

N = 600
"""Samples of a run."""
EXAMPLES = settings(max_examples=60, deadline=None)


def polygon(points: Any, closed: bool = False) -> Path:
    places = [tuple(float(value) for value in point) for point in points]
    return Path([Line(a, b) for a, b in itertools.pairwise([*places, places[0]] if closed else places)], closed=closed)


@st.composite
def random_polygons(draw: st.DrawFn) -> Path:
    """Legs of 0.2 to 20 mm, turns of any angle; closed or open; in the plane or in space."""
    rng = np.random.default_rng(draw(st.integers(0, 1 << 32)))
    n, axes = draw(st.integers(3, 14)), draw(st.sampled_from([2, 2, 3]))
    legs = rng.normal(size=(n, axes))
    legs *= 10.0 ** rng.uniform(-3.7, -1.7, (n, 1)) / np.linalg.norm(legs, axis=1, keepdims=True)
    return polygon(np.cumsum(legs, axis=0), draw(st.booleans()))


@st.composite
def slots(draw: st.DrawFn) -> Path:
    """Passes to and fro, some on the same line, with turns of 180 degrees."""
    length, width = draw(st.floats(1e-3, 2e-2)), draw(st.sampled_from([0.0, 5e-5, 3e-4, 2e-3]))
    passes, points = draw(st.integers(2, 5)), [(0.0, 0.0)]
    for i in range(passes):
        x = length if i % 2 == 0 else 0.0
        points.append((x, points[-1][1]))
        if width and i < passes - 1:
            points.append((x, points[-1][1] + width))
    return polygon(points)


@st.composite
def stars(draw: st.DrawFn) -> Path:
    """Stars with tips and inner corners, and pentagrams, which cross themselves."""
    tips, inner, radius = draw(st.integers(3, 9)), draw(st.floats(0.1, 0.9)), draw(st.floats(5e-4, 2e-2))
    if draw(st.booleans()):
        angle = 2.0 * math.pi * 2.0 / 5.0 * np.arange(5)
        return polygon(radius * np.column_stack([np.cos(angle), np.sin(angle)]), closed=True)
    angle = math.pi / tips * np.arange(2 * tips)
    size = radius * np.where(np.arange(2 * tips) % 2, inner, 1.0)
    return polygon(np.column_stack([size * np.cos(angle), size * np.sin(angle)]), closed=True)


@st.composite
def rounded(draw: st.DrawFn) -> Path:
    """Lines and arcs that meet at corners, as in a D or a lens."""
    radius, turn = draw(st.floats(5e-4, 1e-2)), draw(st.floats(0.5, 5.5))
    arc = Arc((0.0, 0.0), radius, 0.0, turn)
    end, lead = arc.derivatives(np.array([arc.length]), 0)[0].ravel(), draw(st.floats(1e-3, 1e-2))
    side = draw(st.floats(0.0, 6.28))
    return Path(
        [
            Line((radius + lead * math.cos(side), lead * math.sin(side)), (radius, 0.0)),
            arc,
            Line(tuple(end), tuple(end + lead * np.array([math.cos(1.7 * side), math.sin(1.7 * side)]))),
        ]
    )


@st.composite
def cut(draw: st.DrawFn, paths: st.SearchStrategy[Path]) -> tuple[Path, Array, Array]:
    """Return a path, the progress of the reference, and a tool that lags or leads, rounds corners and wanders."""
    path = draw(paths)
    lag = draw(st.sampled_from([-1.0, 1.0])) * 10.0 ** draw(st.floats(-6.0, -2.8))
    size, width = 10.0 ** draw(st.floats(-6.5, -3.3)), draw(st.integers(1, 60))
    along = np.linspace(0.0, path.length * (1.3 if path.closed else 1.0), N)
    at = along - lag if path.closed else np.clip(along - lag, 0.0, path.length)
    u = 2.0 * np.pi * np.arange(N) / N
    wave = np.column_stack([np.sin(3.0 * u) + 0.4 * np.cos(7.0 * u), np.cos(2.0 * u) - 0.3 * np.sin(5.0 * u), np.sin(4.0 * u)])
    tool = path.position(at) + size * wave[:, : path.n_axis]
    padded = np.pad(tool, ((width // 2, (width - 1) // 2), (0, 0)), mode="edge")
    return path, along, np.lib.stride_tricks.sliding_window_view(padded, width, axis=0).mean(axis=2)


def brute_force(path: Path, along: Array, tool: Array) -> Array:
    """Return the least distance (n,) from the lines of a path within the window of the exact judge."""
    window = reach(path, furthest(path.position(along) - tool))
    laps = range(-1, 3) if path.closed else range(1)
    best = np.full(len(along), np.inf)
    for lap, (curve, start) in itertools.product(laps, zip(path.curves, path.breaks, strict=False)):
        a, b = (path.position([start + t * curve.length * (1.0 - 1e-15)])[0] for t in (0.0, 1.0))
        place = start + lap * path.length
        low, high = (np.clip((along + side * window - place) / curve.length, 0.0, 1.0) for side in (-1.0, 1.0))
        inside = (along + window >= place) & (along - window <= place + curve.length)
        part = np.clip((tool - a) @ (b - a) / curve.length**2, low, high)
        away = np.linalg.norm(a + part[:, None] * (b - a) - tool, axis=1)
        best = np.where(inside, np.minimum(best, away), best)
    return best


def check(path: Path, along: Array, tool: Array, straight: bool) -> None:
    """Every sample that is not in doubt has the distance of the exact judge, and of brute force, and the side of the exact judge."""
    reference = samples_on(path, along)
    exact = judge(made_run(reference, tool), reference)["contour_error"]
    if straight:
        np.testing.assert_allclose(np.abs(exact), brute_force(path, along, tool), rtol=0, atol=1e-13)
    # The window of the batch may be larger than that of the run, not smaller.
    largest = float(np.linalg.norm(tool - path.position(along), axis=1).max())
    for error in (largest, 10.0 * largest):
        sums, found, doubt = streamed(path, along, tool, error=error, jit=True)
        sure = ~doubt
        np.testing.assert_allclose(np.abs(found[sure]), np.abs(exact[sure]), rtol=0, atol=1e-13 if straight else 2e-11)
        assert sums["unsure"] == np.count_nonzero(doubt)
        assert sums["sum_magnitude"] == pytest.approx(np.abs(exact[sure]).sum(), rel=1e-9, abs=1e-11 * N)


@EXAMPLES
@given(cut(st.one_of(random_polygons(), slots(), stars())))
def test_sharp_paths(run: tuple[Path, Array, Array]) -> None:
    check(*run, straight=True)


@EXAMPLES
@given(cut(rounded()))
def test_arcs_that_meet_at_corners(run: tuple[Path, Array, Array]) -> None:
    check(*run, straight=False)


@pytest.mark.parametrize("turn", [30.0, 60.0, 90.0, 120.0, 150.0])
def test_a_tool_that_follows_well_is_never_in_doubt(turn: float) -> None:
    """Legs of 6 mm, corners cut by 10 to 200 um: as on good machines, nothing is judged twice."""
    way = np.concatenate([[0.3], 0.3 + np.cumsum([math.radians(turn) * (1 if i % 2 else -1) for i in range(9)])])
    path = polygon(np.concatenate([[(0.0, 0.0)], np.cumsum(6e-3 * np.column_stack([np.cos(way), np.sin(way)]), axis=0)]))
    along = np.linspace(0.0, path.length, 6000)
    padded = np.pad(path.position(np.maximum(along - 1e-4, 0.0)), ((15, 15), (0, 0)), mode="edge")
    tool = np.lib.stride_tricks.sliding_window_view(padded, 31, axis=0).mean(axis=2)
    reference = samples_on(path, along)
    exact = judge(made_run(reference, tool), reference)["contour_error"]
    _, found, doubt = streamed(path, along, tool, error=2e-3, jit=True)
    assert np.abs(exact).max() > 1e-5 and not doubt.any()
    np.testing.assert_allclose(np.abs(found), np.abs(exact), rtol=0, atol=1e-14)
