"""Bracket the closest point on a curve, for the iteration that then refines it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.geometry.table import PathTable

Near = Callable[[Index, Array, int], Array]
Width = Callable[[Index, Array, Array], Array]
_MOST_CELLS = 1 << 21
_SLACK = 1e-8  # [m] larger than the error of the table


class Bends:
    """Largest curvature of a path between two arc lengths, from its table.

    Level k holds the maximum over 2^k successive pieces; two entries cover any range.
    """

    def __init__(self, table: PathTable) -> None:
        self.table = table
        h = np.diff(table.start)[:, None, None] * np.linspace(0.0, 1.0, 5)[:, None]
        c = np.moveaxis(table.coefficients, 2, 0)[:, :, None, :]
        second = 2.0 * c[2] + h * (6.0 * c[3] + h * (12.0 * c[4] + h * 20.0 * c[5]))
        levels = [np.linalg.norm(second, axis=2).max(axis=1)]
        while len(levels[-1]) > (step := 1 << (len(levels) - 1)):
            levels.append(np.maximum(levels[-1][:-step], levels[-1][step:]))
        self._levels = np.array([np.pad(level, (0, len(levels[0]) - len(level))) for level in levels])

    def largest(self, low: Array, high: Array) -> Array:
        """Return the largest curvature [1/m] in each range (n,) of arc lengths along the path."""
        last = self._levels.shape[1] - 1
        i = np.clip(np.searchsorted(self.table.start, low, side="right") - 1, 0, last)
        j = np.clip(np.searchsorted(self.table.start, high, side="left") - 1, i, last)
        k = np.frexp((j - i + 1).astype(float))[1] - 1
        return np.asarray(np.maximum(self._levels[k, i], self._levels[k, j + 1 - (1 << k)]))


def brackets(points: Array, near: Near, width: Width, low: Array, high: Array, middle: Array) -> tuple[Index, Array, Array, Array]:
    """Return brackets of the closest points: pair, first guess, and both ends.

    A cell of width `step` whose ends lie d and e from the point is nowhere closer than (d + e - step) / 2. It is excluded if a sample is
    closer.

    Parameters
    ----------
    points : ndarray (n, n_axis) [m]
        One for each pair of a sample and a curve.
    near : callable
        (pair, s, order) -> derivatives at local arc lengths.
    width : callable
        (pair, a, b) -> largest width of a cell between a and b with a single closest point.
    low, high : ndarray (n,) [m]
        Local arc lengths to search between.
    middle : ndarray (n,) [m]
        The progress; ties go to the sample nearest to it.
    """
    row = np.arange(low.size)
    enough = width(row, low, high)
    # Take few samples of all curves; where these do not suffice, divide only the relevant cells.
    ratio = (high - low) / np.maximum(enough, 1e-12)
    n = int(np.clip(np.ceil(np.median(ratio)), 4, 64)) if row.size else 4
    grid = low[:, None] + (high - low)[:, None] * np.linspace(0.0, 1.0, n + 1)
    at = near(np.repeat(row, n + 1), grid.ravel(), 0)[0].reshape(*grid.shape, -1)
    away = np.sqrt(((at - points[:, None, :]) ** 2).sum(axis=2))
    step, best = (high - low) / n, away.min(axis=1)
    hope = away[:, :-1] + away[:, 1:] - step[:, None] <= 2.0 * best[:, None] + _SLACK
    k = np.argmin(away**2 + 1e-18 * np.abs(grid - middle[:, None]), axis=1)
    fine = row[step <= enough * (1.0 + 1e-9)]
    k = k[fine]
    left, right = np.maximum(k - 1, 0), np.minimum(k + 1, n)
    hope[fine, left] = False
    hope[fine, right - 1] = False
    pair, cell = np.nonzero(hope)
    pair, a, b = _refine(points, near, width, pair, grid[pair, cell], grid[pair, cell + 1], best)
    return (
        np.concatenate([fine, pair]),
        np.concatenate([grid[fine, k], 0.5 * (a + b)]),
        np.concatenate([grid[fine, left], a]),
        np.concatenate([grid[fine, right], b]),
    )


def _refine(points: Array, near: Near, width: Width, pair: Index, a: Array, b: Array, best: Array) -> tuple[Index, Array, Array]:
    """Divide cells until each holds at most one closest point; return those with a minimum of the distance."""
    while pair.size and pair.size < _MOST_CELLS:
        split = b - a > width(pair, a, b) * (1.0 + 1e-9)
        if not split.any():
            break
        owner, keep = pair[split], ~split
        ends = a[split, None] + (b - a)[split, None] * np.linspace(0.0, 1.0, 5)
        owners = np.repeat(owner, 5)
        away = np.sqrt(((near(owners, ends.ravel(), 0)[0] - points[owners]) ** 2).sum(axis=1)).reshape(-1, 5)
        np.minimum.at(best, owner, away.min(axis=1))
        i, j = np.nonzero(away[:, :-1] + away[:, 1:] - np.diff(ends, axis=1) <= 2.0 * best[owner, None] + _SLACK)
        pair = np.concatenate([pair[keep], owner[i]])
        a, b = np.concatenate([a[keep], ends[i, j]]), np.concatenate([b[keep], ends[i, j + 1]])
    slope = []
    for s in (a, b):
        r, first = near(pair, s, 1)
        slope.append(np.einsum("ij,ij->i", first, r - points[pair]))
    turns = (slope[0] <= 0.0) & (slope[1] >= 0.0)
    return pair[turns], a[turns], b[turns]
