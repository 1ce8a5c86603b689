"""What the rows of a store say: shares and quantiles with intervals, effects of parameters, Pareto fronts."""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.study.design import LEVELS, salib_problem

Z = 1.959963984540054
"""Half width of the interval of 95 % of a normal distribution, in standard deviations."""
GROUPS, T = 20, 2.093
"""Groups of the jackknife, and half width of the interval of 95 % of Student's t with one degree of freedom less."""
ANALYSIS: dict[str, Any] = {"num_resamples": 200, "conf_level": 0.95}
BINS = 64
"""Most bins of a parameter."""
LEAST, LEAST_MODULES = 128, 8
"""Fewest variants, and fewest modules of a kind, of an estimate of the convergence."""
FEWEST = 74
"""Fewest independent variants whose interval of the quantile of 95 % ends below the largest."""


def wilson(passed: float, judged: float) -> tuple[float, float]:
    """Return the Wilson interval of 95 % of a share; `judged` may be an `effective_size`.

    >>> [round(end, 4) for end in wilson(98, 100)]
    [0.93, 0.9945]
    """
    if not judged:
        return 0.0, 1.0
    share = passed / judged
    centre = (share + Z * Z / (2 * judged)) / (1 + Z * Z / judged)
    half = _half(share, judged)
    return (max(centre - half, 0.0) if passed else 0.0), (min(centre + half, 1.0) if passed < judged else 1.0)


def _half(share: float, n: float) -> float:
    """Return half of Wilson's interval, also for a share that is not a whole number of n."""
    return Z / (1 + Z * Z / n) * math.sqrt(share * (1 - share) / n + Z * Z / (4 * n**2))


def effective_size(tallies: Sequence[tuple[Array, Array]]) -> float:
    """Return how many independent variants tell as much about a yield as the pairings of modules, or variants that share draws, do.

    Parameters
    ----------
    tallies : sequence of (ndarray (n_module,), ndarray (n_module,))
        For each kind of modules: the judged pairings of each module, and those that passed. A draw that several variants share counts as
        a module.

    Notes
    -----
    The variance of the yield is the sum over the kinds of the jackknife variance over their modules; the interval takes Student's t, as
    Korn and Graubard do for clusters. Bad modules that nobody has drawn are in no variance: the size is therefore at most the number of
    kinds times the fewest modules of a kind, and that number itself where all pairings agree.

    References
    ----------
    E. L. Korn, B. I. Graubard, "Confidence intervals for proportions with small expected number of positive counts estimated from survey
    data", Survey Methodology 24, 1998.
    """
    from scipy.special import stdtrit

    judged, passed = float(tallies[0][0].sum()), float(tallies[0][1].sum())
    share, fewest = passed / judged, min(len(count) for count, _ in tallies)
    if fewest < 2:
        return 1.0
    if not 0.0 < share < 1.0:
        return float(fewest)
    variance = sum(len(n) / (len(n) - 1) * float(np.sum((good - share * n) ** 2)) / judged**2 for n, good in tallies)
    most = float(len(tallies) * fewest)
    if variance == 0.0:
        return most
    return min(share * (1.0 - share) / variance * (Z / float(stdtrit(fewest - 1, 0.975))) ** 2, most)


def variants_needed(share: float, half: float) -> int:
    """Return how many variants give a yield of `share` a Wilson interval of half width `half`."""
    return 1 + bisect_left(range(1, 1 << 50), -half, key=lambda n: -_half(share, n))


def size_of(flags: Flags, members: Sequence[Index]) -> float:
    """Return how many independent variants the rows are worth for the share of `flags` (n,); `members` as in `estimate`."""
    if not members:
        return float(len(flags))
    tallies = []
    for member in members:
        judged = np.bincount(member).astype(np.float64)
        tallies.append((judged[judged > 0], np.bincount(member, flags)[judged > 0].astype(np.float64)))
    return effective_size(tallies)


def share_of(flags: Flags, members: Sequence[Index] = ()) -> tuple[int, float, float, float]:
    """Return how many of `flags` (n,) are set, their share, and its Wilson interval of 95 %; `members` as in `estimate`."""
    passed, n = int(np.count_nonzero(flags)), len(flags)
    share, size = passed / n, size_of(flags, members)
    return passed, share, *wilson(share * size if members else passed, size)


def quantile(values: Array, probability: float, members: Sequence[Index] = ()) -> tuple[float, float | None, float | None]:
    """Return a quantile and the ends of its interval of 95 % (Woodruff's), each one of the values; None where these are too few.

    Parameters
    ----------
    values : ndarray (n,)
        inf where a variant has none because it failed.
    probability : float
    members : sequence of ndarray (n,)
        As in `estimate`.
    """
    n = len(values)
    middle = math.ceil(n * probability) - 1
    found = float(np.partition(values, middle)[middle])
    size = size_of(values <= found, members)
    half = Z * math.sqrt(probability * (1.0 - probability) / size)
    if size < FEWEST:
        return found, None, None
    index = [min(max(math.ceil(n * place) - 1, 0), n - 1) for place in (probability - half, probability + half)]
    sorted_there = np.partition(values, sorted(set(index)))
    low, high = (float(sorted_there[i]) for i in index)
    return found, low, high


@dataclass(frozen=True)
class Estimate:
    """Yield and quantile of 95 % of the first variants, with the ends of their intervals of 95 %.

    Attributes
    ----------
    variants : int
    share, share_low, share_high : float or None
        None without a tolerance.
    p95, p95_low, p95_high : float or None [unit of the figure]
        None where the variant there diverged.
    """

    variants: int
    share: float | None
    share_low: float | None
    share_high: float | None
    p95: float | None
    p95_low: float | None
    p95_high: float | None


def estimate(values: Array, tolerance: float | None, members: Sequence[Index] = ()) -> Estimate:
    """Return the estimates from all values.

    Parameters
    ----------
    values : ndarray (n,)
        inf for variants that diverged.
    tolerance : float or None
    members : sequence of ndarray (n,)
        For each kind of modules, which one is in each pairing; empty for independent variants.
    """
    share = (None, None, None) if tolerance is None else share_of(values <= tolerance, members)[1:]
    tail = [None if end is None or not math.isfinite(end) else end for end in quantile(values, 0.95, members)]
    return Estimate(len(values), *share, *tail)


def convergence(values: Array, tolerance: float | None, members: Sequence[Index] = ()) -> tuple[Estimate, ...]:
    """Return the estimates from the first n variants, or the first n modules of each kind, n doubling up to all.

    Parameters
    ----------
    values : ndarray (n,)
        In the order of the variants; inf for those that diverged.
    tolerance : float or None
    members : sequence of ndarray (n,)
        As in `estimate`.
    """
    found, k = list[Estimate](), 0
    counts = [int(member.max()) + 1 for member in members]
    while (min(counts) >> k >= LEAST_MODULES) if members else (len(values) >> k >= LEAST):
        kept = np.all([m < n >> k for m, n in zip(members, counts, strict=True)], axis=0) if members else slice(len(values) >> k)
        found.append(estimate(values[kept], tolerance, [member[kept] for member in members]))
        k += 1
    return tuple(reversed(found))


# --- effects ---------------------------------------------------------------------------------------------------------------------------


def ranks(values: Array) -> Array:
    """Return ranks from 1; equal values share their mean rank."""
    from scipy.stats import rankdata

    return np.asarray(rankdata(values))


def binned(rank: Array) -> Index:
    """Return bins of about equal size for ranks (n,); few distinct values each have their own."""
    n = len(rank)
    count = min(max(round(n**0.4), 2), BINS)
    # `np.unique` sorts all: first see whether a few rows already have more values.
    if len(np.unique(rank[: 4 * BINS])) <= count and len(distinct := np.unique(rank)) <= count:
        return np.asarray(np.searchsorted(distinct, rank))
    return np.asarray(np.minimum(((rank - 0.5) * (count / n)).astype(np.int64), count - 1))


def rank_correlation(first: Array, second: Array, size: int | None = None) -> tuple[float, float, float]:
    """Return Spearman's correlation from ranks (n,), and its interval of 95 %, for `size` independent pairs; by default all are.

    References
    ----------
    D. G. Bonett, T. A. Wright, "Sample size requirements for estimating Pearson, Kendall and Spearman correlations",
    Psychometrika 65, 2000: the variance of Fisher's z of a rank correlation.
    """
    a, b, size = first - first.mean(), second - second.mean(), size or len(first)
    norm = math.sqrt(float(a @ a) * float(b @ b))
    if norm == 0.0 or size <= 3:
        return 0.0, -1.0, 1.0
    found = min(max(float(a @ b) / norm, -1.0), 1.0)
    if abs(found) == 1.0:
        return found, found, found
    z, half = math.atanh(found), Z * math.sqrt((1.0 + found**2 / 2.0) / (size - 3))
    return found, math.tanh(z - half), math.tanh(z + half)


def first_order(bins: Index, values: Array, inner: Array | None = None, units: Sequence[Index] = ()) -> tuple[float, float, float]:
    """Return the share of the variance of `values` (n,) that the mean over each bin explains, and its interval of 95 %.

    Parameters
    ----------
    bins : ndarray (n,)
    values : ndarray (n,)
        Of rows, or means over the pairings of each module.
    inner : ndarray (n,), optional
        Variance within each of the means; part of the whole.
    units : sequence of ndarray (n,)
        What the jackknife leaves out together: the modules of each kind. By default each row is on its own.

    Notes
    -----
    What chance explains is taken off, as in an adjusted coefficient of determination. The interval is that of a jackknife over random
    groups of units; the variances of several kinds add up.
    """
    count = int(bins.max()) + 1
    centred = values - values.mean()
    within = np.zeros(len(values)) if inner is None else inner

    def share(n: Array, sums: Array, squares: Array, spread_within: Array) -> Array:
        rows, common = n.sum(-1), sums.sum(-1) ** 2 / np.maximum(n.sum(-1), 1.0)
        between = (sums**2 / np.maximum(n, 1.0)).sum(-1) - common
        total = squares - common
        left = np.maximum(rows - np.count_nonzero(n, axis=-1), 1.0)
        spread = total > 1e-12 * np.maximum(squares, np.finfo(float).tiny)
        unexplained = (total - between) * (rows - 1.0) / (left * np.where(spread, total, 1.0))
        return np.where(spread, (1.0 - unexplained) * total / np.where(spread, total + spread_within, 1.0), 0.0)

    variance = 0.0
    for unit in units or (np.arange(len(values)),):
        last = int(unit.max()) + 1
        groups = min(GROUPS, last)
        part = np.random.default_rng(0).integers(groups, size=last)[unit]
        cell = part * count + bins
        n = np.bincount(cell, minlength=groups * count).reshape(groups, count).astype(np.float64)
        sums = np.bincount(cell, centred, groups * count).reshape(groups, count)
        squares, inside = np.bincount(part, centred * centred, groups), np.bincount(part, within, groups)
        found = float(share(n.sum(0), sums.sum(0), squares.sum(), inside.sum()))
        without = share(n.sum(0) - n, sums.sum(0) - sums, squares.sum() - squares, inside.sum() - inside)
        variance += (groups - 1) / groups * float(np.sum((without - without.mean()) ** 2))
    half = T * math.sqrt(variance)
    clipped = np.clip([found, found - half, found + half], 0.0, 1.0)
    return float(clipped[0]), float(clipped[1]), float(clipped[2])


def total_indices(figure: Array) -> list[tuple[float, float, float]]:
    """Return the total index of each dimension of a Saltelli design, and its interval of 95 % by a jackknife over random groups.

    Parameters
    ----------
    figure : ndarray (n_group, n_dimension + 2)
        Of A, of B, and of A with one dimension after the other from B.

    References
    ----------
    M. J. W. Jansen, "Analysis of variance designs for model output", Computer Physics Communications 117, 1999: the estimator.
    """
    n = len(figure)
    parts = min(GROUPS, n)
    part = np.random.default_rng(0).permutation(n) % parts
    centred = figure - figure[:, :2].mean()

    def summed(terms: Array) -> Array:
        return np.bincount(part, terms, parts).astype(np.float64)

    count, first, second = summed(np.full(n, 2.0)), summed(centred[:, :2].sum(1)), summed((centred[:, :2] ** 2).sum(1))

    def share(half: Any, count: Any, first: Any, second: Any) -> Any:
        return 2.0 * half / np.maximum(second - first**2 / count, np.finfo(float).tiny)

    found = []
    for changed in centred[:, 2:].T:
        terms = [summed((centred[:, 0] - changed) ** 2 / 2.0), count, first, second]
        middle = float(share(*(term.sum() for term in terms)))
        without = share(*(term.sum() - term for term in terms))
        half = T * math.sqrt((parts - 1) / parts * float(np.sum((without - without.mean()) ** 2)))
        found.append((middle, max(middle - half, 0.0), middle + half))
    return found


def best_split(bins: Index, passed: Flags) -> tuple[int, float, float, float]:
    """Return where to cut the bins in two so that the yields differ most.

    Returns
    -------
    last : int
        Last bin of the lower part.
    below, above : float
        Share that passes in each part.
    gain : float
        Part of the variance of passing that the cut explains; 0 if there is none.
    """
    n, good = np.bincount(bins).astype(float), np.bincount(bins, passed)
    low, low_good = np.cumsum(n)[:-1], np.cumsum(good)[:-1]
    high, share = n.sum() - low, good.sum() / n.sum()
    if not len(low) or not 0.0 < share < 1.0:
        return 0, share, share, 0.0
    below, above = low_good / np.maximum(low, 1.0), (good.sum() - low_good) / np.maximum(high, 1.0)
    gain = low * high / n.sum() ** 2 * (below - above) ** 2 / (share * (1.0 - share))
    best = int(np.argmax(gain))
    return best, float(below[best]), float(above[best]), float(gain[best])


# --- indices by SALib ---


@dataclass(frozen=True, eq=False)
class SobolIndices:
    """Shares of the variance.

    Attributes
    ----------
    first, first_interval : ndarray (n,)
        First-order indices: the share of each parameter alone; and half the width of the 95 % confidence interval.
    total, total_interval : ndarray (n,)
        Total indices: the share of each parameter with all its interactions; and the same interval.
    second, second_interval : ndarray (n, n) or None
        Second-order indices: the share of an interaction of two parameters. Above the diagonal, else nan; None if not requested.
    deviation : float
        Standard deviation of the sample.
    """

    first: Array
    first_interval: Array
    total: Array
    total_interval: Array
    second: Array | None
    second_interval: Array | None
    deviation: float


@dataclass(frozen=True, eq=False)
class MorrisIndices:
    """Elementary effects: the effect of a step over two thirds of the range, divided by its length.

    Attributes
    ----------
    mu_star, mu_star_interval : ndarray (n,)
        Mean magnitude of the effects, and half the width of its 95 % confidence interval.
    mu : ndarray (n,)
        Mean of the effects.
    sigma : ndarray (n,)
        Standard deviation of the effects: large if the effect is nonlinear or depends on other parameters.
    """

    mu_star: Array
    mu_star_interval: Array
    mu: Array
    sigma: Array


def sobol_indices(values: Array, n: int, second: bool = False, seed: int = 0) -> SobolIndices:
    """Return the Sobol indices of the values at `saltelli_points`, with bootstrap intervals.

    Notes
    -----
    If the values do not vary, all indices are 0. An estimate may lie a little below 0; its interval then includes 0.
    """
    zero = np.zeros(n)
    if np.ptp(values) == 0.0:
        pairs = np.where(np.triu(np.ones((n, n)), 1) > 0, 0.0, np.nan) if second else None
        return SobolIndices(zero, zero, zero, zero, pairs, pairs, 0.0)
    from SALib.analyze import sobol

    # A generator, because SALib treats the seed 0 as no seed: its intervals would differ each time.
    draw = np.random.default_rng(seed)
    found = sobol.analyze(salib_problem(n), values, calc_second_order=second, print_to_console=False, seed=draw, **ANALYSIS)
    arrays = {key: np.asarray(value, dtype=float) for key, value in found.items()}
    names = ("S1", "S1_conf", "ST", "ST_conf", "S2", "S2_conf")
    return SobolIndices(*(arrays.get(name) for name in names), float(values.std()))  # type: ignore[arg-type, call-arg]


def morris_indices(points: Array, values: Array, seed: int = 0) -> MorrisIndices:
    """Return the elementary effects of the values at `morris_points`, over the whole range of each parameter."""
    from SALib.analyze import morris

    found = morris.analyze(salib_problem(points.shape[1]), points, values, num_levels=LEVELS, seed=seed, **ANALYSIS)
    return MorrisIndices(*(np.asarray(np.ma.getdata(found[key]), dtype=float) for key in ("mu_star", "mu_star_conf", "mu", "sigma")))


# --- Pareto front ----------------------------------------------------------------------------------------------------------------------


def pareto_front(points: Array) -> Index:
    """Return the rows of `points` (n, 2 or 3) that no other row beats, all columns as small as possible, by the first column.

    Notes
    -----
    Of equal rows the first counts. Rows are visited by their first column; what was seen is kept as a staircase of the other two, so the
    time is that of sorting.

    >>> pareto_front(np.array([[1.0, 4.0], [2.0, 2.0], [3.0, 3.0], [4.0, 1.0]])).tolist()
    [0, 1, 3]
    """
    second, third = points[:, 1], points[:, 2] if points.shape[1] > 2 else np.zeros(len(points))
    order = np.lexsort((third, second, points[:, 0]))
    # Most rows are beaten by the one with the least sum of ranks: drop those without a loop.
    best = points[np.argmin(sum(np.argsort(np.argsort(column)) for column in points.T))]
    beaten = np.all(points >= best, axis=1) & np.any(points > best, axis=1)
    order = order[~beaten[order]]
    front, steps, heights = [], list[float](), list[float]()
    for row, y, z in zip(order.tolist(), second[order].tolist(), third[order].tolist(), strict=True):
        at = bisect_right(steps, y)
        if at and heights[at - 1] <= z:
            continue
        last = at
        first = bisect_left(steps, y)
        while last < len(steps) and heights[last] >= z:
            last += 1
        steps[first:last], heights[first:last] = [y], [z]
        front.append(row)
    return np.array(front, dtype=np.int64)
