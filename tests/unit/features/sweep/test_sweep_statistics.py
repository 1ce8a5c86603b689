"""Effects, intervals and fronts against closed forms."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from SALib.analyze import sobol

from contourlab.study.design import Design
from contourlab.study.statistics import (
    best_split,
    binned,
    convergence,
    first_order,
    pareto_front,
    quantile,
    rank_correlation,
    ranks,
    total_indices,
    variants_needed,
    wilson,
)

N = 20_000


def test_a_linear_model_has_its_indices_and_correlations() -> None:
    x = np.random.default_rng(1).standard_normal((N, 4))
    weights = np.array([3.0, -2.0, 1.0, 0.0])
    y = x @ weights
    for column, weight in zip(x.T, weights, strict=True):
        exact = weight**2 / 14.0
        index, low, high = first_order(binned(ranks(column)), y)
        assert index == pytest.approx(exact, abs=0.025)  # five standard deviations
        assert low <= index <= high and high - low < 0.05
        pearson = weight / math.sqrt(14.0)
        spearman = 6.0 / math.pi * math.asin(pearson / 2.0)  # of a bivariate normal distribution
        found, low, high = rank_correlation(ranks(column), ranks(y))
        assert found == pytest.approx(spearman, abs=0.025) and low < found < high and high - low < 0.03


def test_a_choice_and_a_combination() -> None:
    rng = np.random.default_rng(2)
    choice, sign = rng.integers(3, size=N).astype(float), rng.choice([-1.0, 1.0], N)
    y = choice + 2.0 * sign * rng.choice([-1.0, 1.0], N)
    share = (2.0 / 3.0) / (2.0 / 3.0 + 4.0)
    assert first_order(binned(ranks(choice)), y)[0] == pytest.approx(share, abs=0.025)
    assert first_order(binned(ranks(sign)), y)[0] == pytest.approx(0.0, abs=0.002)  # it acts in combination only
    assert first_order(binned(ranks(sign)), np.ones(N)) == (0.0, 0.0, 0.0)


def test_intervals_of_indices_and_correlations_cover_them() -> None:
    exact = (0.5, 6.0 / math.pi * math.asin(math.sqrt(0.5) / 2.0))
    covered = np.zeros(2)
    for seed in range(200):
        x = np.random.default_rng(seed).standard_normal((1000, 2))
        rank, y = ranks(x[:, 0]), x.sum(axis=1)
        found = first_order(binned(rank), y), rank_correlation(rank, ranks(y))
        covered += [low <= value <= high for (_, low, high), value in zip(found, exact, strict=True)]
    assert np.all(covered >= 180) and np.all(covered < 200)  # 95 %, less three standard deviations


def test_wilson_and_how_many_variants_it_needs() -> None:
    assert wilson(0, 10) == pytest.approx((0.0, 0.27753), abs=1e-5)  # z^2 / (n + z^2)
    assert wilson(5, 10) == pytest.approx((0.23659, 0.76341), abs=1e-5)
    for share in (0.5, 0.9, 1.0):
        n = variants_needed(share, 0.01)
        assert wilson(round(share * n), n)[1] - wilson(round(share * n), n)[0] == pytest.approx(0.02, rel=0.02)


def test_intervals_of_a_quantile_cover_it() -> None:
    covered = 0
    for seed in range(400):
        found, low, high = quantile(np.random.default_rng(seed).random(500), 0.95)
        assert low < found < high
        covered += low <= 0.95 <= high
    assert 368 <= covered <= 392  # 95 % give or take three standard deviations


def test_convergence_ends_at_all_variants() -> None:
    values = np.arange(1.0, 1001.0)
    values[500:] = np.inf
    found = convergence(values, 250.0)
    assert [one.variants for one in found] == [250, 500, 1000][-len(found) :] and found[-1].variants == 1000
    assert (found[0].share, found[-1].share) == (1.0, 0.25)
    assert found[0].p95 == 238.0 and found[-1].p95 is None
    assert convergence(values[:100], 250.0) == ()


def test_the_best_split_is_the_threshold() -> None:
    x = np.random.default_rng(3).random(N)
    bins = binned(ranks(x))
    last, below, above, gain = best_split(bins, x <= 0.7)
    assert x[bins == last].max() == pytest.approx(0.7, abs=0.02) and below > 0.97 and above < 0.03 and gain > 0.95
    assert best_split(bins, np.ones(N, dtype=bool))[3] == 0.0


@pytest.mark.parametrize("columns", [2, 3])
@pytest.mark.parametrize("levels", [0, 6])
def test_the_front_is_what_no_row_beats(columns: int, levels: int) -> None:
    points = np.random.default_rng(4).random((400, columns))
    points = np.floor(points * levels) if levels else points  # with many equal values
    beaten = [bool(np.any(np.all(points <= row, axis=1) & np.any(points < row, axis=1))) for row in points]
    best = {tuple(row) for row in points[~np.array(beaten)]}
    front = pareto_front(points)
    assert {tuple(row) for row in points[front]} == best and len(front) == len(best)
    assert np.all(np.diff(points[front, 0]) >= 0.0)


def test_total_indices_of_a_saltelli_design_are_those_of_salib_and_of_the_closed_form() -> None:
    """The function of Ishigami: the second parameter acts alone, the third one only in combination with the first."""
    design = Design("saltelli", 2048 * 5, 1024, (0, 0, 0), seed=1)
    assert np.array_equal(replace(design, variants=3000).places(2), design.places(2)[:952])
    x = (2.0 * np.concatenate([design.places(k) for k in range(design.chunks)]) - 1.0) * np.pi
    y = np.sin(x[:, 0]) + 7.0 * np.sin(x[:, 1]) ** 2 + 0.1 * x[:, 2] ** 4 * np.sin(x[:, 0])
    found = total_indices(y.reshape(-1, 5))
    problem = {"num_vars": 3, "names": ["a", "b", "c"], "bounds": [[0.0, 1.0]] * 3}
    theirs = sobol.analyze(problem, y.reshape(-1, 5)[:, [0, 2, 3, 4, 1]].ravel(), calc_second_order=False, seed=1)
    assert [middle for middle, _, _ in found] == pytest.approx(theirs["ST"], rel=1e-9)
    for (_, low, high), half, exact in zip(found, theirs["ST_conf"], (0.5576, 0.4424, 0.2437), strict=True):
        assert low < exact < high
        assert (high - low) / 2.0 == pytest.approx(half, rel=0.5)  # a jackknife over 20 groups and a bootstrap
    assert total_indices(y.reshape(-1, 5)[:, [0, 1, 0, 3, 4]])[0][0] == 0.0
