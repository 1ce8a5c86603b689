"""Nonlinear least squares by damped Gauss-Newton steps within bounds, many points at once, and the covariance of the result."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.identification.output_error import bartlett, flat_top, long_run, memory, usual_lags
from contourlab.arrays import Array, Flags
from contourlab.errors import ParameterError

Residuals = Callable[[Array], Array]
"""Points (k, p) to residuals (k, n), all in one call; the row of a point that fails is not finite."""

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

    References
    ----------
    Nocedal & Wright, "Numerical Optimization", 2nd ed., sections 10.3 (Levenberg-Marquardt) and 16.7 (projected gradient).
    """
    chosen = settings or DescentSettings()
    x, low, high, size = (np.array(v, dtype=float) for v in (start, lower, upper, scale))
    if not (np.all(low <= x) and np.all(x <= high) and np.all(size > 0.0)):
        raise ParameterError("start", f"{x}", f"within {low} and {high}, scales above zero")
    r = residuals(x[None])[0]
    if not np.isfinite(r).all():
        raise ParameterError("start", f"{x}", "parameters that can be simulated: the run diverges there")
    damping, cost, converged, done = 1e-3, float(r @ r), False, 0
    width = chosen.difference * size
    for _ in range(2):  # the size of the differences depends on the slopes
        slopes = jacobian(residuals, x, r, low, high, width)
        width = _widths(slopes, chosen, size)
    while done < chosen.most_iterations and not converged:
        done += 1
        free = ~_held(x, slopes.T @ r, low, high)
        if not free.any():
            converged = True
            break
        factors = damping * DAMPINGS
        trials = _trials(x, r, slopes, free, low, high, factors)
        left = residuals(trials)
        costs = np.where(np.isfinite(left).all(axis=1), (np.nan_to_num(left) ** 2).sum(axis=1), math.inf)
        best = int(np.argmin(costs))
        if costs[best] >= cost:
            if damping > 1e6:
                converged = True  # no step of any length reduces the cost
            damping *= DAMPINGS[-1]
            continue
        converged = cost - costs[best] <= chosen.least_gain * cost
        x, r, cost = trials[best], left[best], float(costs[best])
        damping = float(np.clip(0.1 * factors[best], 1e-9, 1e6))
        slopes = jacobian(residuals, x, r, low, high, width)
        width = _widths(slopes, chosen, size)
    return Descent(x, r, cost, slopes, _held(x, slopes.T @ r, low, high), done, converged)


def _widths(slopes: Array, chosen: DescentSettings, size: Array) -> Array:
    """Return steps that change the residual by `visible`, from a thousandth to a fifth of a parameter's scale."""
    seen = np.sqrt(np.mean(slopes**2, axis=0))
    wanted = chosen.visible / np.where(seen > 0.0, seen, np.inf)
    return np.clip(np.where(seen > 0.0, wanted, chosen.difference * size), 1e-3 * size, 0.2 * size)


def _held(x: Array, gradient: Array, low: Array, high: Array) -> Flags:
    """Return which parameters the gradient holds at a bound."""
    held: Flags = ((x <= low) & (gradient >= 0.0)) | ((x >= high) & (gradient <= 0.0))
    return held


def _trials(x: Array, r: Array, slopes: Array, free: Flags, low: Array, high: Array, dampings: Array) -> Array:
    """Return the ends (k, p) of damped steps, clipped to the bounds."""
    j = slopes[:, free]
    lengths = np.linalg.norm(j, axis=0)
    lengths = np.where(lengths > 0.0, lengths, 1.0)  # a parameter without effect stays where it is
    # Solved as least squares: normal equations would square the condition number.
    q, unit = np.linalg.qr(j / lengths)
    wanted = np.append(-r @ q, np.zeros(lengths.size))
    moved = np.repeat(x[None], dampings.size, axis=0)
    for trial, damping in zip(moved, dampings, strict=True):
        matrix = np.vstack([unit, math.sqrt(damping) * np.eye(lengths.size)])
        trial[free] += np.linalg.lstsq(matrix, wanted, rcond=None)[0] / lengths
    return np.clip(moved, low, high)


def jacobian(residuals: Residuals, x: Array, r: Array, low: Array, high: Array, step: Array) -> Array:
    """Return the slopes of the residuals (n, p) at x by central differences; one-sided at a bound and next to a point that fails.

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
    around = residuals(points)
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
    even = qmc.Sobol(x.size, seed=0).random(candidates)
    away = line[1] + even * (line[2] - line[1]) - line[0]
    placed = line[0] + reach * away
    points = np.clip(np.where(ratio, np.exp(np.where(ratio, placed, 0.0)), placed), low, high)
    left = residuals(points)
    costs = np.where(np.isfinite(left).all(axis=1), (np.nan_to_num(left) ** 2).sum(axis=1), math.inf)
    order = [i for i in np.argsort(costs, kind="stable")[: count - 1] if math.isfinite(costs[i])]
    return np.vstack([x[None], points[order]])


UNTOLD = 1e-10
"""Eigenvalue of the normal matrix (columns of length one) over the largest, up to which a direction counts as without effect."""
FADED = 0.1
"""Autocorrelation below which samples count as uncorrelated."""
LONGEST = 4
"""Length of a record over the longest lag."""


@dataclass(frozen=True, eq=False)
class FitCovariance:
    """Covariance of parameters from least squares.

    Attributes
    ----------
    deviations, white_deviations : ndarray (p,)
        Standard deviations for a residual correlated over neighbouring rows and across channels, and for a white residual; infinite for an
        undetermined parameter.
    correlation : ndarray (p, p)
        Of the parameters, for a white residual.
    untold : ndarray (p,) of bool
        Parameters, or combinations of them, without effect on the residual.
    """

    deviations: Array
    white_deviations: Array
    correlation: Array
    untold: Flags


def fit_covariance(jacobians: Sequence[Array], residuals: Sequence[Array], floor: float = 0.0) -> FitCovariance:
    """Return the covariance of the parameters at the least sum of squares.

    Parameters
    ----------
    jacobians : sequence of ndarray (n_k, c_k, p)
        Slopes of the residuals of each record: rows over time, channels recorded together.
    residuals : sequence of ndarray (n_k, c_k)
        Weighted to the same size.
    floor : float
        Root mean square error that the residuals may not show, such as half an encoder count.

    Notes
    -----
    The covariance is (J'J)^-1 S (J'J)^-1, where S is the sum of the autocovariances of J'r under a window that is flat up to the lag at
    which the autocorrelation of the residual has faded, and falls to 0 at twice that lag. Model errors last longer than the usual number of
    lags, and a window that falls from the start (Bartlett's) gives deviations too small by a tenth or more. A flat window may give a
    variance far too small, even below zero: so no deviation is below that of Bartlett's window, or the white one. Several neighbouring
    minima are not accounted for.

    References
    ----------
    See `contourlab.analysis.identification.output_error`.
    """
    p = jacobians[0].shape[-1]
    if p == 0:  # all parameters are at the bounds of their ranges
        nothing, none = np.zeros(0), np.zeros((0, 0))
        return FitCovariance(nothing, nothing, none, np.zeros(0, dtype=bool))
    flat = np.concatenate([j.reshape(-1, p) for j in jacobians])
    left = np.concatenate([r.ravel() for r in residuals])
    normal = flat.T @ flat
    lengths = np.sqrt(np.diag(normal))
    size = np.where(lengths > 0.0, lengths, 1.0)
    values, vectors = np.linalg.eigh(normal / np.outer(size, size))
    lost = values <= UNTOLD * max(float(values[-1]), 1e-300)
    untold: Flags = (lengths == 0.0) | (np.abs(vectors[:, lost]) > 0.2).any(axis=1)
    inverse = (vectors[:, ~lost] / values[~lost]) @ vectors[:, ~lost].T / np.outer(size, size)
    spare = max(left.size - p, 1)
    white = np.sqrt(np.maximum(np.diag(inverse), 0.0) * (float(left @ left) + floor**2 * left.size) / spare)
    lags = max(_remembered(r) for r in residuals)
    pushed = [np.einsum("ncp,nc->np", j, r) for j, r in zip(jacobians, residuals, strict=True)]
    windows = flat_top(lags), bartlett(2 * lags - 1)
    covariances = [inverse @ sum(long_run(part, window) for part in pushed) @ inverse * (left.size / spare) for window in windows]
    # Never below Bartlett's window or the white deviation; correlations stay.
    covariance, own = covariances[0], np.diag(covariances[0]).copy()
    least = np.maximum(np.diag(covariances[1]), white**2)
    raised = np.sqrt(np.where(own > 0.0, np.maximum(own, least) / np.where(own > 0.0, own, 1.0), 0.0))
    covariance = covariance * np.outer(raised, raised)
    np.fill_diagonal(covariance, np.maximum(own, least))
    covariance[untold, untold] = np.inf
    scale = np.sqrt(np.where(np.diag(inverse) > 0.0, np.diag(inverse), 1.0))
    deviations = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    return FitCovariance(deviations, np.where(untold, np.inf, white), inverse / np.outer(scale, scale), untold)


def parted_deviations(jacobian: Array, residual: Array, parts: int) -> Array:
    """Return standard deviations (p,) by the jackknife: the spread of estimates that leave out one part of the record after another.

    Parameters
    ----------
    jacobian : ndarray (n, p)
        At the least sum of squares.
    residual : ndarray (n,)
    parts : int, >= 2
        Consecutive parts of equal length. What the model lacks lasts for a motion and differs from one kind of motion to the next: it is
        not noise, and is seen only between parts.

    Returns
    -------
    ndarray (p,)
        Infinite if a part alone determines a parameter.

    Notes
    -----
    Each estimate takes one Gauss-Newton step from the whole record's.

    References
    ----------
    Efron & Stein, "The jackknife estimate of variance", Annals of Statistics 9(3), 1981.
    """
    lengths = np.linalg.norm(jacobian, axis=0)
    if not lengths.all():
        return np.full(lengths.size, math.inf)
    columns = jacobian / lengths
    normal, moved = columns.T @ columns, []
    for rows in np.array_split(np.arange(residual.size), parts):
        part = columns[rows]
        rest = normal - part.T @ part
        if np.linalg.cond(rest) * UNTOLD > 1.0:
            return np.full(lengths.size, math.inf)
        moved.append(np.linalg.solve(rest, part.T @ residual[rows]))
    return np.asarray(np.std(moved, axis=0) * math.sqrt(parts - 1.0) / lengths)


def _remembered(residual: Array) -> int:
    """Return the number of rows over which a record's residual (n, c) counts as correlated."""
    n = residual.shape[0]
    longest = max(n // LONGEST, 1)
    reached = max(memory(column - column.mean(), FADED, longest) for column in residual.T)
    return int(min(max(usual_lags(n), reached), longest))
