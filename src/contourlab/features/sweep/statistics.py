"""What the rows of a store say: shares and quantiles with intervals, effects of parameters, Pareto fronts."""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.features.sweep.query import Z, wilson

GROUPS, T = 20, 2.093
"""Groups of the jackknife, and half width of the interval of 95 % of Student's t with one degree of freedom less."""
BINS = 64
"""Most bins of a parameter."""
LEAST = 128
"""Fewest variants of a quantile of 95 % whose interval ends at two variants."""


def variants_needed(share: float, half: float) -> int:
    """Return how many variants give a yield of `share` a Wilson interval of half width `half`."""

    def negative_half(n: int) -> float:
        # Half of Wilson's interval, for a share that need not be a whole number of n.
        return -Z / (1.0 + Z * Z / n) * math.sqrt(share * (1.0 - share) / n + Z * Z / (4.0 * n * n))

    return 1 + bisect_left(range(1, 1 << 50), -half, key=negative_half)


def quantile(values: Array, probability: float) -> tuple[float, float, float]:
    """Return a quantile and the ends of its interval of 95 %, each one of the values, by their order.

    Parameters
    ----------
    values : ndarray (n,)
        Independent; inf where a variant has none because it failed.
    probability : float
    """
    n = len(values)
    half = Z * math.sqrt(n * probability * (1.0 - probability))
    places = (n * probability, n * probability - half, n * probability + half)
    index = [min(max(math.ceil(place) - 1, 0), n - 1) for place in places]
    sorted_there = np.partition(values, sorted(set(index)))
    found, low, high = (float(sorted_there[i]) for i in index)
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


def convergence(values: Array, tolerance: float | None) -> tuple[Estimate, ...]:
    """Return the estimates from the first n variants, n doubling from about `LEAST` to all.

    Parameters
    ----------
    values : ndarray (n,)
        In the order of the variants; inf for those that diverged.
    tolerance : float or None
    """
    sizes: list[int] = [len(values)] if len(values) >= LEAST else []
    while sizes and sizes[-1] // 2 >= LEAST:
        sizes.append(sizes[-1] // 2)
    found = []
    for n in reversed(sizes):
        share: tuple[float | None, ...] = (None, None, None)
        if tolerance is not None:
            passed = int(np.count_nonzero(values[:n] <= tolerance))
            share = (passed / n, *wilson(passed, n))
        tail = [end if math.isfinite(end) else None for end in quantile(values[:n], 0.95)]
        found.append(Estimate(n, *share, *tail))
    return tuple(found)


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


def rank_correlation(first: Array, second: Array) -> tuple[float, float, float]:
    """Return Spearman's correlation from ranks (n,), and the ends of its interval of 95 %.

    References
    ----------
    D. G. Bonett, T. A. Wright, "Sample size requirements for estimating Pearson, Kendall and Spearman correlations",
    Psychometrika 65, 2000: the variance of Fisher's z of a rank correlation.
    """
    a, b = first - first.mean(), second - second.mean()
    norm = math.sqrt(float(a @ a) * float(b @ b))
    if norm == 0.0 or len(a) <= 3:
        return 0.0, -1.0, 1.0
    found = min(max(float(a @ b) / norm, -1.0), 1.0)
    if abs(found) == 1.0:
        return found, found, found
    z, half = math.atanh(found), Z * math.sqrt((1.0 + found**2 / 2.0) / (len(a) - 3))
    return found, math.tanh(z - half), math.tanh(z + half)


def first_order(bins: Index, values: Array) -> tuple[float, float, float]:
    """Return the share of the variance of `values` (n,) that the mean over each bin explains, and its interval of 95 %.

    Notes
    -----
    What chance explains is taken off, as in an adjusted coefficient of determination. The interval is that of a jackknife over random
    groups of rows.
    """
    count = int(bins.max()) + 1
    groups = min(GROUPS, len(values))
    part = np.random.default_rng(0).integers(groups, size=len(values))
    centred = values - values.mean()
    cell = part * count + bins
    n = np.bincount(cell, minlength=groups * count).reshape(groups, count).astype(np.float64)
    sums = np.bincount(cell, centred, groups * count).reshape(groups, count)
    squares = np.bincount(part, centred * centred, groups)

    def share(n: Array, sums: Array, squares: Array) -> Array:
        rows, common = n.sum(-1), sums.sum(-1) ** 2 / np.maximum(n.sum(-1), 1.0)
        between = (sums**2 / np.maximum(n, 1.0)).sum(-1) - common
        total = squares - common
        left = np.maximum(rows - np.count_nonzero(n, axis=-1), 1.0)
        spread = total > 1e-12 * np.maximum(squares, np.finfo(float).tiny)
        unexplained = (total - between) * (rows - 1.0) / (left * np.where(spread, total, 1.0))
        return np.where(spread, 1.0 - unexplained, 0.0)

    found = float(share(n.sum(0), sums.sum(0), squares.sum()))
    without = share(n.sum(0) - n, sums.sum(0) - sums, squares.sum() - squares)
    half = T * math.sqrt((groups - 1) / groups * float(np.sum((without - without.mean()) ** 2)))
    clipped = np.clip([found, found - half, found + half], 0.0, 1.0)
    return float(clipped[0]), float(clipped[1]), float(clipped[2])


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
