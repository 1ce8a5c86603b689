"""Damped Gauss-Newton steps from many points at once: Levenberg-Marquardt within bounds, which bridges the kinks of a model.

References
----------
Nocedal & Wright, "Numerical Optimization", 2nd ed., sections 10.3 (Levenberg-Marquardt) and 16.7 (projected gradient).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Sequence
from dataclasses import dataclass
from typing import TypeAlias, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Flags
from contourlab.errors import ParameterError, refuse

Residuals = Callable[[Array], Array]
"""Points (k, p) to residuals (k, n), all in one call; the row of a point that fails is not finite."""

TOGETHER = 32
"""Candidates that are evaluated in one call: more would not fit into the caches."""
DAMPINGS = 10.0 ** np.arange(-3.0, 5.0)
"""Factors on the damping, tried in parallel."""


@dataclass(frozen=True)
class DescentSettings:
    """Step sizes and stopping rule of a descent.

    Attributes
    ----------
    difference : float
        First step of the central differences, over a parameter's scale.
    visible : float
        Root mean square change of the residual by later steps. Encoder counts and sticking make the sum of squares rough: smaller changes
        are noise.
    least_gain : float
        Relative fall of the sum of squares in one iteration below which the descent has converged.
    """

    difference: float = 5e-3
    visible: float = 0.05
    most_iterations: int = 40
    least_gain: float = 1e-4


@dataclass(frozen=True, eq=False)
class Descent:
    """Result of a descent.

    Attributes
    ----------
    values : ndarray (p,)
    residual : ndarray (n,)
    cost : float
        Sum of squares.
    jacobian : ndarray (n, p)
        At `values`.
    at_bound : ndarray (p,) of bool
        Parameters at a bound beyond which the sum of squares would fall further.
    """

    values: Array
    residual: Array
    cost: float
    jacobian: Array
    at_bound: Flags
    iterations: int
    converged: bool


def descend(
    residuals: Residuals, start: ArrayLike, lower: ArrayLike, upper: ArrayLike, scale: ArrayLike, settings: DescentSettings | None = None
) -> Descent:
    """Descend to the smallest sum of squares near a start: Levenberg-Marquardt, projected onto bounds.

    Parameters
    ----------
    residuals : callable
        Points (k, p) to residuals (k, n); not finite for a point that cannot be evaluated.
    start, lower, upper : array_like (p,)
    scale : array_like (p,), > 0
        Size of each parameter.

    Raises
    ------
    ParameterError
        If the start is outside the bounds, or cannot be evaluated.
    """
    x, low, high, size = (np.array(v, dtype=float) for v in (start, lower, upper, scale))
    if not (np.all(low <= x) and np.all(x <= high) and np.all(size > 0.0)):
        raise ParameterError("start", f"{x}", f"within {low} and {high}, scales above zero")
    r = residuals(x[None])[0]
    refuse(not np.isfinite(r).all(), ParameterError, "start", f"{x}", "parameters that can be simulated: the run diverges there")
    return in_step(residuals, [descent(x, r, low, high, size, settings)])[0]


_End = TypeVar("_End")
Search: TypeAlias = Generator[Array, Array, _End]
"""Asks for the residuals (k, n) of points (k, p) until it ends with a result."""


def in_step(residuals: Residuals, searches: Sequence[Search[_End]], sizes: Sequence[float] = (1.0,)) -> list[_End]:
    """Run searches together: the points that all of them ask for are evaluated in one call. Each sees residuals over its size."""
    asked, ends = {i: next(search) for i, search in enumerate(searches)}, dict[int, _End]()
    while asked:
        left = residuals(np.concatenate(list(asked.values())))
        for i, points in list(asked.items()):
            own, left = left[: len(points)] / sizes[i], left[len(points) :]
            try:
                asked[i] = searches[i].send(own)
            except StopIteration as end:
                ends[i] = end.value
                del asked[i]
    return [ends[i] for i in range(len(searches))]


def descent(x: Array, r: Array, low: Array, high: Array, size: Array, settings: DescentSettings | None) -> Search[Descent]:
    """Descend from a point with residual r."""
    chosen = settings or DescentSettings()
    damping, cost, converged, done = 1e-3, float(r @ r), False, 0
    width = chosen.difference * size
    for _ in range(2):  # the size of the differences depends on the slopes
        slopes = yield from jacobian(x, r, low, high, width)
        width = _widths(slopes, chosen, size)
    while done < chosen.most_iterations and not converged:
        done += 1
        free = ~_held(x, slopes.T @ r, low, high)
        if converged := not free.any():
            break
        factors = damping * DAMPINGS
        trials = _trials(x, r, slopes, free, low, high, factors)
        left = yield trials
        costs = _costs(left)
        best = int(np.argmin(costs))
        if costs[best] >= cost:
            converged = damping > 1e6  # no step of any length reduces the cost
            damping *= DAMPINGS[-1]
            continue
        converged = cost - costs[best] <= chosen.least_gain * cost
        x, r, cost = trials[best], left[best], float(costs[best])
        damping = float(np.clip(0.1 * factors[best], 1e-9, 1e6))
        slopes = yield from jacobian(x, r, low, high, width)
        width = _widths(slopes, chosen, size)
    return Descent(x, r, cost, slopes, _held(x, slopes.T @ r, low, high), done, converged)


def _costs(left: Array) -> Array:
    """Return the sums of squares (k,) of residuals (k, n); infinite where one is not finite."""
    return np.asarray(np.nan_to_num((left**2).sum(axis=1), nan=math.inf, posinf=math.inf))


def _widths(slopes: Array, chosen: DescentSettings, size: Array) -> Array:
    """Return steps that change the residual by `visible`, from a thousandth to a fifth of a parameter's scale."""
    seen = np.sqrt(np.mean(slopes**2, axis=0))
    wanted = chosen.visible / np.where(seen > 0.0, seen, np.inf)
    return np.clip(np.where(seen > 0.0, wanted, chosen.difference * size), 1e-3 * size, 0.2 * size)


def _held(x: Array, gradient: Array, low: Array, high: Array) -> Flags:
    """Return which parameters the gradient holds at a bound."""
    return np.asarray(((x <= low) & (gradient >= 0.0)) | ((x >= high) & (gradient <= 0.0)))


def _trials(x: Array, r: Array, slopes: Array, free: Flags, low: Array, high: Array, dampings: Array) -> Array:
    """Return the ends (k, p) of damped steps, clipped to the bounds."""
    from scipy import linalg  # its factors have the bits of NumPy's, but are not copied

    j = slopes[:, free]
    lengths = np.linalg.norm(j, axis=0)
    lengths = np.where(lengths > 0.0, lengths, 1.0)  # a parameter without effect stays where it is
    # Solved as least squares: normal equations would square the condition number.
    q, unit = linalg.qr(j / lengths, mode="economic", overwrite_a=True, check_finite=False)
    wanted = np.append(-r @ np.ascontiguousarray(q), np.zeros(lengths.size))
    moved = np.repeat(x[None], dampings.size, axis=0)
    for trial, damping in zip(moved, dampings, strict=True):
        trial[free] += np.linalg.lstsq(np.vstack([unit, math.sqrt(damping) * np.eye(lengths.size)]), wanted, rcond=None)[0] / lengths
    return np.clip(moved, low, high)


def jacobian(x: Array, r: Array, low: Array, high: Array, step: Array) -> Search[Array]:
    """Search the slopes of the residuals (n, p) at x by central differences; one-sided at a bound and next to a point that fails.

    Parameters
    ----------
    x : ndarray (p,)
    r : ndarray (n,)
        Residual at x.
    low, high, step : ndarray (p,)
    """
    p = x.size
    up, down = np.minimum(x + step, high), np.maximum(x - step, low)
    points = np.repeat(x[None], 2 * p, axis=0)
    points[np.arange(p), np.arange(p)] = up
    points[p + np.arange(p), np.arange(p)] = down
    around = yield points
    slopes = np.zeros((r.size, p))
    for i in range(p):
        above, below = around[i], around[p + i]
        (top, at_top) = (above, up[i]) if np.isfinite(above).all() else (r, x[i])
        (bottom, at_bottom) = (below, down[i]) if np.isfinite(below).all() else (r, x[i])
        if at_top > at_bottom:
            slopes[:, i] = (top - bottom) / (at_top - at_bottom)
    return slopes


def spread_starts(
    residuals: Residuals, start: ArrayLike, lower: ArrayLike, upper: ArrayLike, count: int, candidates: int = 64, reach: float = 0.3
) -> Array:
    """Return starts (count, p): the given one, and the best of candidates spread evenly around it.

    Parameters
    ----------
    start, lower, upper : array_like (p,)
    candidates : int
        Points of a scrambled Sobol sequence with a fixed seed.
    reach : float, 0 to 1
        Share of the distance from start to bounds that the candidates cover; on a logarithmic scale for ranges above zero.
    """
    from scipy.stats import qmc

    x, low, high = (np.array(v, dtype=float) for v in (start, lower, upper))
    if count <= 1:
        return x[None]
    ratio = low > 0.0
    line = [np.where(ratio, np.log(np.where(ratio, v, 1.0)), v) for v in (x, low, high)]
    away = line[1] + qmc.Sobol(x.size, seed=0).random(candidates) * (line[2] - line[1]) - line[0]
    placed = line[0] + reach * away
    points = np.clip(np.where(ratio, np.exp(np.where(ratio, placed, 0.0)), placed), low, high)
    costs = np.concatenate([_costs(residuals(points[i : i + TOGETHER])) for i in range(0, candidates, TOGETHER)])
    order = [i for i in np.argsort(costs, kind="stable")[: count - 1] if math.isfinite(costs[i])]
    return np.vstack([x[None], points[order]])
