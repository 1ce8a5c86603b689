"""The streaming judge of a batch against the exact judge, on hand-made positions."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from made_runs import Array, made_run, samples_on
from streamed_judge import TABLE, streamed

from contourlab.geometry import Arc, Line, Path, contour
from contourlab.metrics.judge import judge


def wobble(n: int, size: float) -> Array:
    """Return a smooth position error (n, 2)."""
    u = 2.0 * np.pi * np.arange(n) / n
    return size * np.column_stack([np.sin(3.0 * u) + 0.4 * np.cos(7.0 * u), np.cos(2.0 * u) - 0.3 * np.sin(5.0 * u)])


CASES = [("circle", {}), ("ellipse", {"a": 0.03, "b": 0.015}), ("lemniscate", {}), ("star", {"lobes": 4, "depth": 0.2})]


@pytest.mark.parametrize(("name", "parameters"), CASES)
@pytest.mark.parametrize("size", [1e-5, 3e-4])
def test_agrees_with_the_exact_judge(name: str, parameters: dict[str, float], size: float) -> None:
    """Each sample agrees to the tolerance of the path's table; doubt is only for errors comparable to the path's radii."""
    path = contour(name, **parameters)
    along = np.linspace(0.0, 1.2 * path.length, 500)
    tool = path.position(along - 2.0 * size) + wobble(500, size)
    exact = judge(made_run(samples_on(path, along), tool), samples_on(path, along))["contour_error"]
    sums, error, _ = streamed(path, along, tool)
    assert np.abs(error - exact).max() < TABLE
    assert sums["unsure"] == 0.0 or size > 1e-4


@pytest.mark.parametrize("analytic", [True, False])
def test_sums(analytic: bool) -> None:
    """Every sum equals that of the judged errors."""
    path = contour("circle")
    along = np.linspace(0.0, path.length, 300)
    tool = path.position(along) + wobble(300, 5e-5)
    exact = judge(made_run(samples_on(path, along), tool), samples_on(path, along))
    start, stop = 100, 220
    sums, _, _ = streamed(path, along, tool, (start, stop), analytic)
    away = np.linalg.norm(exact["tracking_error"], axis=1)
    e, t = exact["contour_error"][start:stop], away[start:stop]
    assert sums["count"] == stop - start
    assert sums["sum_magnitude"] == pytest.approx(np.abs(e).sum(), abs=120e-10)
    assert sums["sum_square"] == pytest.approx((e**2).sum(), abs=1e-4 * 120e-10)
    assert sums["sum_signed"] == pytest.approx(e.sum(), abs=120e-10)
    assert sums["largest"] == pytest.approx(np.abs(e).max(), abs=1e-10)
    assert sums["largest_at"] == start + int(np.argmax(np.abs(e)))
    assert sums["sum_tracking"] == pytest.approx((t**2).sum(), rel=1e-12)
    assert sums["largest_tracking"] == pytest.approx((t**2).max(), rel=1e-12)
    assert sums["reach"] == pytest.approx((away**2).max(), rel=1e-12)  # of all samples, judged or not


def test_side_of_a_clockwise_circle() -> None:
    path = contour("circle", clockwise=1.0)
    along = np.linspace(0.0, path.length, 100)
    _, error, _ = streamed(path, along, 1.001 * path.position(along))
    assert np.abs(error - 2e-5).max() < 1e-14


def test_branch_at_the_self_intersection() -> None:
    path = contour("lemniscate")
    along = 0.5 * path.length + np.linspace(-4e-3, 4e-3, 200)
    tool = path.position(along - 1e-3) + 2e-4 * path.normal(along - 1e-3)
    sums, error, _ = streamed(path, along, tool)
    assert np.abs(error - 2e-4).max() < 1e-10
    assert sums["unsure"] == 0.0


def test_in_space_it_is_a_distance() -> None:
    path = Path([Arc((0.0, 0.0, 0.0), 0.02, 0.0, 2.0 * math.pi, rise=(0.0, 0.0, 0.01))])
    along = np.linspace(0.05 * path.length, 0.95 * path.length, 200)
    binormal = np.cross(path.tangent(along), path.normal(along))
    sums, error, _ = streamed(path, along, path.position(along) + 4e-5 * binormal)
    assert np.abs(error - 4e-5).max() < 1e-9
    assert sums["sum_signed"] == pytest.approx(sums["sum_magnitude"], rel=1e-15)


def test_every_wrong_sample_is_marked_as_doubtful() -> None:
    """Jumps as large as the path's radii, which Newton's method cannot follow."""
    path = contour("star", lobes=5, depth=0.4)
    along = np.linspace(0.0, path.length, 500)
    tool = path.position(along) + np.random.default_rng(0).normal(0.0, 2e-3, (500, 2))
    exact = judge(made_run(samples_on(path, along), tool), samples_on(path, along))["contour_error"]
    sums, error, doubt = streamed(path, along, tool)
    wrong = np.abs(np.abs(error) - np.abs(exact)) > 1e-9
    assert wrong.any()
    assert not np.any(wrong & ~doubt)
    assert sums["unsure"] == np.count_nonzero(doubt) < 500


def test_at_rest_the_error_is_zero() -> None:
    path = Path([Line((0.0, 0.0), (0.1, 0.0))])
    along = np.zeros(20)
    sums, error, _ = streamed(path, along, path.position(along))
    assert not error.any()
    assert sums["unsure"] == 0.0


def square_or_zigzag(closed: bool) -> Path:
    points = [(0.0, 0.0), (0.03, 0.0), (0.03, 0.02), (0.055, 0.045), (0.0, 0.045)] + ([(0.0, 0.0)] if closed else [])
    return Path([Line(a, b) for a, b in itertools.pairwise(points)], closed=closed)


@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("size", [2e-5, 5e-4])
def test_corners_from_inside_and_outside(closed: bool, size: float) -> None:
    """A tool that lags and wobbles around corners: outside, the corner itself is the foot point; no sample is in doubt."""
    path = square_or_zigzag(closed)
    # On a closed path a run that begins at the closing corner has no earlier segment to come from.
    along = np.linspace(0.1 * path.length if closed else 0.0, (1.7 if closed else 1.0) * path.length, 1500)
    tool = path.position(np.maximum(along - 3.0 * size, 0.0)) + wobble(1500, size)
    exact = judge(made_run(samples_on(path, along), tool), samples_on(path, along))["contour_error"]
    sums, error, _ = streamed(path, along, tool)
    assert np.abs(np.abs(error) - np.abs(exact)).max() < 2.0 * TABLE
    assert np.count_nonzero(np.sign(error) != np.sign(exact)) <= 0.01 * len(exact)  # straight behind a corner both sides are right
    assert sums["unsure"] == 0.0


@pytest.mark.parametrize("beyond", [1e-6, 3e-4])
def test_a_tool_beyond_the_end_is_in_error(beyond: float) -> None:
    path = Path([Line((0.0, 0.0), (0.04, 0.0)), Line((0.04, 0.0), (0.04, 0.03))])
    along = np.concatenate([np.linspace(0.0, path.length, 300), np.full(20, path.length)])
    tool = path.position(along)
    tool[-10:] += (0.0, beyond)
    _, error, _ = streamed(path, along, tool)
    assert np.abs(error[:-10]).max() < TABLE
    np.testing.assert_allclose(np.abs(error[-10:]), beyond, rtol=0, atol=TABLE)
