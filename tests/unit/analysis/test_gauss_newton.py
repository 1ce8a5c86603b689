"""Damped Gauss-Newton against closed forms and a hard curved valley; deviations against many random draws."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import pytest
from scipy.signal import lfilter

from contourlab.analysis.identification.descent import DAMPINGS, DescentSettings, descend, in_step, jacobian, spread_starts
from contourlab.analysis.identification.least_squares import Free, descended, fit_covariance, parted
from contourlab.errors import ParameterError

RNG = np.random.default_rng(5)
MATRIX, WANTED = RNG.standard_normal((40, 3)), RNG.standard_normal(40)


def line(points: np.ndarray) -> np.ndarray:
    return points @ MATRIX.T - WANTED


def banana(points: np.ndarray) -> np.ndarray:
    x, y = points.T
    return np.column_stack([10.0 * (y - x**2), 1.0 - x])


def test_a_linear_problem_is_solved_as_by_the_normal_equations() -> None:
    exact = np.linalg.lstsq(MATRIX, WANTED, rcond=None)[0]
    found = descend(line, np.zeros(3), np.full(3, -9.0), np.full(3, 9.0), np.ones(3))
    assert found.values == pytest.approx(exact, abs=1e-4) and found.converged and not found.at_bound.any()
    assert found.jacobian == pytest.approx(MATRIX, abs=1e-9)


def test_a_curved_valley_is_followed_to_its_end() -> None:
    settings = DescentSettings(visible=1e-4, most_iterations=200, least_gain=1e-12)
    found = descend(banana, [-1.2, 1.0], [-5.0, -5.0], [5.0, 5.0], [1.0, 1.0], settings)
    assert found.values == pytest.approx([1.0, 1.0], abs=1e-4)


def test_at_a_bound_the_other_parameters_are_optimal() -> None:
    high = np.array([9.0, 0.0, 9.0])
    exact = np.linalg.lstsq(MATRIX, WANTED, rcond=None)[0]
    low = np.array([-9.0, min(exact[1], 0.0) - 1.0, -9.0])
    shifted = lambda points: line(points + np.array([0.0, exact[1] + 1.0, 0.0]))  # noqa: E731 - the free minimum lies at -1
    found = descend(lambda points: shifted(points * np.array([1.0, -1.0, 1.0])), np.array([0.0, -0.5, 0.0]), low, high, np.ones(3))
    rest = np.linalg.lstsq(MATRIX[:, [0, 2]], WANTED - MATRIX[:, 1] * (exact[1] + 1.0), rcond=None)[0]
    assert found.at_bound.tolist() == [False, True, False] and found.values[1] == 0.0
    assert found.values[[0, 2]] == pytest.approx(rest, abs=1e-4)


def test_failed_points_are_avoided() -> None:
    def broken(points: np.ndarray) -> np.ndarray:
        left = banana(points)
        left[points[:, 0] < -1.25] = np.nan
        return left

    settings = DescentSettings(visible=1e-3, most_iterations=200, least_gain=1e-10)
    found = descend(broken, [-1.2499, 1.0], [-5.0, -5.0], [5.0, 5.0], [1.0, 1.0], settings)
    assert found.values == pytest.approx([1.0, 1.0], abs=1e-2)
    at, bounds = np.array([-1.2499, 1.0]), np.array([[-5.0] * 2, [5.0] * 2, [0.01] * 2])
    (slopes,) = in_step(broken, [jacobian(at, banana(at[None])[0], *bounds)])
    assert slopes == pytest.approx(np.array([[24.9, 10.0], [-1.0, 0.0]]), abs=0.01)  # one-sided: -20 x - 10 h


def test_descents_from_several_starts_end_where_each_alone_does() -> None:
    """Bit by bit, whatever the size of the residual at each start; the best end counts."""
    times = np.linspace(0.0, 3.0, 200)
    measured = 2.0 * np.exp(-0.7 * times)
    free = {"height": Free(1.0, 0.0, 9.0), "rate": Free(0.1, 0.0, 9.0)}
    calls = list[int]()

    def model(points: Sequence[Mapping[str, float]]) -> np.ndarray:
        calls.append(len(points))
        return np.array([point["height"] * np.exp(-point["rate"] * times) for point in points])

    starts = np.array([[0.5, 6.0], [1.0, 0.1], [6.0, 3.0]])
    alone = [descended(model, measured, free, start[None])[0] for start in starts]
    before = len(calls)
    best, ends = descended(model, measured, free, starts)
    assert len(calls) - before < before and max(calls[before:]) == 3 * len(DAMPINGS)
    np.testing.assert_array_equal(ends, [one.values for one in alone])
    assert best.fit == max(one.fit for one in alone)
    assert best.values == pytest.approx([2.0, 0.7], abs=1e-3)


def test_a_start_that_fails_or_lies_outside_is_refused() -> None:
    with pytest.raises(ParameterError, match="diverges"):
        descend(lambda points: np.full((len(points), 2), np.nan), [0.0], [-1.0], [1.0], [1.0])
    with pytest.raises(ParameterError, match="within"):
        descend(line, np.full(3, 99.0), np.full(3, -9.0), np.full(3, 9.0), np.ones(3))


def test_starts_lie_within_bounds_and_the_given_one_comes_first() -> None:
    starts = spread_starts(banana, [1e-3, 2.0], [1e-4, -5.0], [1e-2, 5.0], 4)
    assert starts[0].tolist() == [1e-3, 2.0] and len(starts) == 4
    assert (starts[:, 0] >= 1e-4).all() and (starts[:, 0] <= 1e-2).all()
    costs = (banana(starts[1:]) ** 2).sum(axis=1)
    assert (np.diff(costs) >= 0.0).all()


@pytest.mark.parametrize("keep", [0.0, 0.9])
def test_deviations_match_many_random_draws(keep: float) -> None:
    """A line through 1500 rows of noise, white or with a memory of ten rows, drawn 300 times."""
    n, draws = 1500, 300
    time = np.linspace(0.0, 1.0, n)
    columns = np.column_stack([np.ones(n), np.sin(9.0 * time)])[:, None, :]
    rng = np.random.default_rng(1)
    values, told, white = [], [], []
    for _ in range(draws):
        noise = lfilter([1.0], [1.0, -keep], rng.standard_normal(n + 200))[200:]
        found = np.linalg.lstsq(columns[:, 0], noise, rcond=None)[0]
        known = fit_covariance([columns], [(noise - columns[:, 0] @ found)[:, None]])
        values.append(found)
        told.append(known.deviations)
        white.append(known.white_deviations)
    spread = np.std(values, axis=0)
    assert np.sqrt(np.mean(np.square(told), axis=0)) == pytest.approx(spread, rel=0.2)
    if keep:
        assert (np.mean(white, axis=0) < 0.35 * spread).all()


def test_parameters_without_an_effect_of_their_own_are_reported() -> None:
    columns = RNG.standard_normal((200, 2, 4))
    columns[:, :, 2] = 0.0
    columns[:, :, 3] = -2.0 * columns[:, :, 1]
    known = fit_covariance([columns], [RNG.standard_normal((200, 2))])
    assert known.untold.tolist() == [False, True, True, True]
    assert np.isfinite(known.deviations).tolist() == [True, False, False, False]


def test_parted_deviation_of_a_mean_is_the_spread_of_the_means_of_parts() -> None:
    values = np.random.default_rng(1).normal(size=120)
    means = values.reshape(6, 20).mean(axis=1)
    found, _ = parted(np.ones((120, 1)), values - values.mean(), 6)
    assert found == pytest.approx([means.std(ddof=1) / np.sqrt(6.0)])
    alone = np.column_stack([np.ones(120), np.arange(120) < 20])
    assert np.isinf(parted(alone, values, 6)[0]).all()
