"""Invariances of the judge: position and orientation of the machine, speed of the clock."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from contourlab.feed import Reference
from contourlab.geometry import Arc, Line, Path
from contourlab.metrics.circles import circle_figures, minimum_zone
from contourlab.metrics.figures import Metrics, summarise
from contourlab.metrics.judge import judge
from contourlab.result import Result, Signal

Array = NDArray[np.float64]
few = settings(max_examples=40, deadline=None)
angles = st.floats(-math.pi, math.pi)
shifts = st.tuples(st.floats(-0.5, 0.5), st.floats(-0.5, 0.5))
seeds = st.integers(0, 2**32 - 1)


def turned(angle: float) -> Array:
    return np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])


def a_path(angle: float = 0.0, shift: tuple[float, float] = (0.0, 0.0), mirrored: bool = False) -> Path:
    """Line, corner, line, tangent arc, line; turned, moved, mirrored in x."""
    m = turned(angle) @ np.diag([1.0, -1.0 if mirrored else 1.0])
    a, b, c = (m @ p + shift for p in np.array([(0.0, 0.0), (0.05, 0.0), (0.08, 0.04)]))
    # The arc leaves along the second line, turning left by 100 degrees.
    heading = math.atan2(0.04, 0.03)
    centre = np.array([0.08, 0.04]) + 0.02 * np.array([-math.sin(heading), math.cos(heading)])
    arc = Arc(m @ centre + shift, 0.02, heading - math.pi / 2, math.radians(100.0), m[:, 0], m[:, 1])
    end = arc.derivatives([arc.length], 1)[:, 0]
    return Path([Line(a, b), Line(b, c), arc, Line(end[0], end[0] + 0.03 * end[1])])


def wander(seed: int, n: int) -> Array:
    """Return an error (n, 2) of about a hundredth of a millimetre, smooth in time."""
    rng = np.random.default_rng(seed)
    t = np.linspace(0.0, 1.0, n)[:, None]
    return np.asarray(sum(rng.normal(0.0, 1e-5, 2) * np.sin(2.0 * np.pi * k * t + rng.uniform(0.0, 6.0, 2)) for k in range(1, 8)))


def judged(path: Path, along: Array, tool: Array, period: float = 1e-3) -> tuple[Result, Metrics]:
    reference = Reference.from_samples(path.position(along), period, path, arc_length=along)
    asked = reference.block(0, len(along))
    signals = {
        "tool_position": Signal(tool, ("sample", "axis"), "m"),
        "reference": Signal(asked.position, ("sample", "axis"), "m"),
        "arc_length": Signal(along, ("sample",), "m"),
        "feedrate": Signal(asked.feedrate, ("sample",), "m/s"),
    }
    result = judge(Result("made", ("x", "y"), period, signals), reference)
    return result, summarise(result, reference)


def numbers(metrics: Metrics) -> dict[str, float]:
    found: dict[str, float] = {}
    for name in ("part_error", "contour_error", "planning_deviation"):
        figures: Any = getattr(metrics, name)
        found |= {f"{name}.{key}": getattr(figures, key) for key in ("rms", "max", "mean", "p95", "integral", "signed_mean")}
    return found


N = 300


@few
@given(angle=angles, shift=shifts, seed=seeds)
def test_moved_and_turned(angle: float, shift: tuple[float, float], seed: int) -> None:
    """Errors and their sides are the same on a moved and rotated machine."""
    here = a_path()
    along = np.linspace(0.0, here.length, N)
    tool = here.position(along) + wander(seed, N)
    there = a_path(angle, shift)
    one, figures = judged(here, along, tool)
    other, figures_there = judged(there, along, tool @ turned(angle).T + shift)
    # Positions of half a metre are rounded to 1e-16 m; foot points add up several such roundings.
    assert np.abs(one["contour_error"] - other["contour_error"]).max() < 5e-15
    # Where two samples are equally bad, either may be named.
    worst = figures_there.contour_error.worst.sample
    assert abs(abs(one["contour_error"][worst]) - figures.contour_error.max) < 5e-15
    for name, value in numbers(figures).items():
        assert abs(value - numbers(figures_there)[name]) < 5e-15


@few
@given(seed=seeds)
def test_mirrored(seed: int) -> None:
    """A mirror changes sides, and nothing else."""
    here, there = a_path(), a_path(mirrored=True)
    along = np.linspace(0.0, here.length, N)
    tool = here.position(along) + wander(seed, N)
    one, _ = judged(here, along, tool)
    other, _ = judged(there, along, tool * [1.0, -1.0])
    assert np.abs(one["contour_error"] + other["contour_error"]).max() < 1e-15


@few
@given(seed=seeds, factor=st.floats(0.01, 100.0))
def test_clock(seed: int, factor: float) -> None:
    """With another clock, integrals and times scale with the period and speeds inversely; errors do not change."""
    path = a_path()
    along = np.linspace(0.0, path.length, N)
    tool = path.position(along) + wander(seed, N)
    one, figures = judged(path, along, tool, 1e-3)
    other, slow = judged(path, along, tool, factor * 1e-3)
    assert np.array_equal(one["contour_error"], other["contour_error"])
    close = 1e-12
    assert abs(slow.contour_error.integral / figures.contour_error.integral / factor - 1.0) < close
    assert abs(slow.cycle_time / figures.cycle_time / factor - 1.0) < close
    assert abs(slow.feedrate_mean / figures.feedrate_mean * factor - 1.0) < close
    assert slow.contour_error.rms == figures.contour_error.rms


@few
@given(error=st.lists(st.floats(-1e-3, 1e-3), min_size=3, max_size=200))
def test_order_of_the_figures(error: list[float]) -> None:
    """mean <= rms <= max, p95 <= max, |signed mean| <= mean, on a line, where the error is the given one."""
    path = Path([Line((0.0, 0.0), (1.0, 0.0))])
    along = np.linspace(0.0, 1.0, len(error))
    figures = judged(path, along, np.column_stack([along, error]))[1].contour_error
    rounding = 1e-15
    assert abs(figures.signed_mean) <= figures.mean + rounding
    assert figures.mean <= figures.rms + rounding
    assert figures.rms <= figures.max + rounding
    assert figures.p95 <= figures.max
    assert abs(figures.max - max(abs(e) for e in error)) < rounding
    # 95 % of the samples do not exceed it, and at least 5 % reach it.
    assert sum(abs(e) <= figures.p95 + rounding for e in error) >= 0.95 * (len(error) - 1)
    assert sum(abs(e) >= figures.p95 - rounding for e in error) >= 0.05 * (len(error) - 1)
    assert abs(figures.integral - math.fsum(abs(e) for e in error) * 1e-3) < rounding


@settings(max_examples=25, deadline=None)
@given(seed=seeds, angle=angles, shift=shifts)
@pytest.mark.slow
def test_roundness_is_the_same_anywhere(seed: int, angle: float, shift: tuple[float, float]) -> None:
    """Both circular deviations depend on the shape alone; minimum zone <= least squares <= F_max - F_min around any centre."""
    rng = np.random.default_rng(seed)
    a = np.linspace(0.0, 2.0 * np.pi, 200, endpoint=False)
    shape = 0.03 + sum(rng.normal(0.0, 3e-6) * np.cos(k * a + rng.uniform(0.0, 6.0)) for k in range(1, 7))
    points = shape[:, None] * np.column_stack([np.cos(a), np.sin(a)])
    here = circle_figures(points, np.zeros(2), 0.03, False, "here")
    there = circle_figures(points @ turned(angle).T + shift, np.asarray(shift), 0.03, False, "there")
    for name, value in here.figures().items():
        assert abs(value - there.figures()[name]) < 1e-13
    assert here.circular_deviation <= here.circular_deviation_least_squares + 1e-15
    assert here.circular_deviation <= here.radial_max - here.radial_min + 1e-15
    # Points within the ring change nothing.
    zone, centre = minimum_zone(points)
    radius = np.linalg.norm(points - centre, axis=1)
    middle = centre + 0.5 * (radius.max() + radius.min()) * np.column_stack([np.cos(a[::7] + 0.01), np.sin(a[::7] + 0.01)])
    assert abs(minimum_zone(np.concatenate([points, middle]))[0] - zone) < 1e-12
