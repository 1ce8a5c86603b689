"""Output-error least squares, with standard deviations that allow for a residual correlated in time.

The model's output depends on the command alone, so measurement noise does not bias the parameters. The covariance is
(J'J)^-1 S (J'J)^-1, where S is the sum of the autocovariances of J'r under a window over the lags: Bartlett's for nearly independent rows,
Parzen's (round at its top) if the errors of neighbouring samples cancel, a flat one if a model error lasts.

References
----------
Ljung, "System Identification", 2nd ed., sections 4.2 and 9.4; Newey & West, "A simple, positive semi-definite, heteroskedasticity and
autocorrelation consistent covariance matrix", Econometrica 55(3), 1987; Andrews, "Heteroskedasticity and autocorrelation consistent
covariance matrix estimation", Econometrica 59(3), 1991; Politis & Romano, "Bias-corrected nonparametric spectral estimation", J. Time
Series Analysis 16, 1995.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.arrays import Array
from contourlab.errors import ParameterError

NEAR_BOUND = 1e-6
"""Share of a parameter's scale within which it counts as lying at its bound."""
UNTOLD = 1e10
"""Condition number of the normal equations, columns of length one, above which parameters cannot be separated."""


@dataclass(frozen=True)
class Free:
    """A parameter of a fit: start, bounds, and a typical size."""

    start: float
    low: float = -math.inf
    high: float = math.inf
    scale: float = 1.0


@dataclass(frozen=True, eq=False)
class OutputFit:
    """Result of a fit of a model's output.

    Attributes
    ----------
    values, deviations, robust_deviations : ndarray (p,)
        Standard deviations for a white residual, and for a residual correlated in time; 0 for a parameter at its bound.
    correlation : ndarray (p, p)
    condition_number : float
        Of the sensitivities, columns of length one.
    measured, predicted : ndarray (n,)
    fit : float [percent]
        100 (1 - |measured - predicted|/|measured - mean|).
    """

    names: tuple[str, ...]
    values: Array
    deviations: Array
    robust_deviations: Array
    correlation: Array
    condition_number: float
    at_bound: tuple[str, ...]
    measured: Array
    predicted: Array
    fit: float

    def __getitem__(self, name: str) -> float:
        """Return the value of a parameter by name."""
        return float(self.values[self.names.index(name)])

    def deviation(self, name: str) -> float:
        """Return the robust deviation of a parameter by name.

        The noise of a differenced position is correlated: deviations for a white residual would be many times too large.
        """
        return float(self.robust_deviations[self.names.index(name)])


def fit_percent(measured: NDArray[Any], predicted: NDArray[Any]) -> float:
    """Return 100 (1 - |measured - predicted|/|measured - mean of measured|), of real or complex values."""
    spread = float(np.linalg.norm(measured - measured.mean()))
    if spread == 0.0:
        raise ParameterError("measured", f"{measured[0]:g} throughout", "a record that changes")
    return 100.0 * (1.0 - float(np.linalg.norm(measured - predicted)) / spread)


def fit_output(model: Callable[[Mapping[str, float]], Array], measured: Array, free: Mapping[str, Free]) -> OutputFit:
    """Fit a model's output by nonlinear least squares (Gauss-Newton in a trust region, within bounds).

    Parameters
    ----------
    model : callable
        From parameters by name to its output (n,).
    measured : ndarray (n,)

    Raises
    ------
    ParameterError
        If the record is too short, does not change, or does not determine the parameters.
    """
    from scipy.optimize import least_squares

    names = tuple(free)
    if measured.size <= 2 * len(names):
        raise ParameterError("record", f"{measured.size} samples", f"more than {2 * len(names)} for {len(names)} parameters")
    low, high, scale = (np.array([getattr(f, part) for f in free.values()]) for part in ("low", "high", "scale"))

    def output(x: Array) -> Array:
        return model(dict(zip(names, x.tolist(), strict=True)))

    # Scaled to one, so that the tolerances do not depend on the unit.
    size = float(np.linalg.norm(measured - measured.mean())) / math.sqrt(measured.size) or 1.0

    def left(x: Array) -> Array:
        return (output(x) - measured) / size

    start = np.clip([f.start for f in free.values()], low, high)
    solution = least_squares(left, start, jac="3-point", bounds=(low, high), x_scale=scale, xtol=1e-10, ftol=1e-12, gtol=1e-12)
    values = np.asarray(solution.x, dtype=float)
    lowest, highest = values - low <= NEAR_BOUND * scale, high - values <= NEAR_BOUND * scale
    values, bound = np.where(lowest, low, np.where(highest, high, values)), lowest | highest
    predicted = output(values)
    slopes = _slopes(output, values, low, high, scale)
    white, robust, correlation = np.zeros(len(names)), np.zeros(len(names)), np.eye(len(names))
    inside = [name for name, b in zip(names, bound, strict=True) if not b]
    part = np.ix_(~bound, ~bound)
    white[~bound], robust[~bound], correlation[part], condition = _covariance(slopes[:, ~bound], predicted - measured, inside)
    stuck = tuple(name for name, b in zip(names, bound, strict=True) if b)
    return OutputFit(names, values, white, robust, correlation, condition, stuck, measured, predicted, fit_percent(measured, predicted))


def _slopes(output: Callable[[Array], Array], at: Array, low: Array, high: Array, scale: Array) -> Array:
    """Return the sensitivities (n, p) by differences within the bounds, wide enough to bridge the kinks of sticking."""
    columns = []
    for i in range(at.size):
        step = np.zeros(at.size)
        step[i] = 1e-4 * max(abs(at[i]), scale[i])
        up, down = np.minimum(at + step, high), np.maximum(at - step, low)
        columns.append((output(up) - output(down)) / max(up[i] - down[i], 1e-300))
    return np.column_stack(columns)


def _covariance(slopes: Array, residual: Array, names: Sequence[str]) -> tuple[Array, Array, Array, float]:
    """Return deviations for a white and for a correlated residual, correlation, and the condition number of the scaled slopes."""
    if not names:
        return np.empty(0), np.empty(0), np.empty((0, 0)), 1.0
    lengths = np.linalg.norm(slopes, axis=0)
    if not lengths.all():
        raise ParameterError("record", "a record", f"one in which {names[int(np.argmin(lengths))]} shows")
    scaled = slopes / lengths
    condition = float(np.linalg.cond(scaled))
    if condition**2 > UNTOLD:
        _, _, directions = np.linalg.svd(scaled, full_matrices=False)
        mixed = [name for name, part in zip(names, directions[-1], strict=True) if abs(part) > 0.2]
        raise ParameterError("record", "a record", f"one that tells {' and '.join(mixed)} apart: vary the command more")
    inverse = np.linalg.inv(scaled.T @ scaled)
    white = np.sqrt(np.diag(inverse) * float(residual @ residual) / max(residual.size - len(names), 1))
    robust = coloured_deviations(scaled, residual, inverse, lasting_window(residual))
    size = np.sqrt(np.diag(inverse))
    return white / lengths, robust / lengths, inverse / np.outer(size, size), condition


def lasting_window(residual: Array) -> Array:
    """Return the window over lags that suits the residual (n,) of a simulated model.

    Notes
    -----
    Parzen's window over four times the memory of the residual, at least 4 sqrt(n) and at most a tenth of the record. Residuals of a
    simulated model last as long as its motion. Those of a differenced position cancel from one sample to the next: a window with a corner
    at its top, such as Bartlett's, misses this.
    """
    n = residual.size
    until = 4 * memory(residual, max(0.05, 2.0 / math.sqrt(n)), n // 10)
    return parzen(min(max(until, int(4.0 * math.sqrt(n))), max(n // 10, 1)))


def bartlett(lags: int) -> Array:
    """Return Bartlett's window (lags + 1,): a line from 1 at lag 0 to 0 after the last lag. Variances under it are never negative."""
    return np.asarray(1.0 - np.arange(lags + 1) / (lags + 1.0))


def parzen(lags: int) -> Array:
    """Return Parzen's window (lags + 1,): two cubics, with zero slope at lag 0. Variances under it are never negative."""
    x = np.arange(lags + 1) / (lags + 1.0)
    return np.asarray(np.where(x < 0.5, 1.0 - 6.0 * x**2 * (1.0 - x), 2.0 * (1.0 - x) ** 3))


def flat_top(lags: int) -> Array:
    """Return a window (2 lags,), lags >= 1: 1 up to `lags`, then a line to 0 at twice that. A variance under it may be negative."""
    return np.asarray(np.minimum(1.0, 2.0 - np.arange(2 * lags) / lags))


def usual_lags(n: int) -> int:
    """Return the usual number of lags for n rows, 4 (n/100)^(2/9) + 1."""
    return int(4.0 * (n / 100.0) ** (2.0 / 9.0)) + 1


def memory(residual: Array, faded: float, longest: int) -> int:
    """Return the first lag at which the autocorrelation of a residual (n,) is below `faded`; `longest` if there is none.

    Parameters
    ----------
    residual : ndarray (n,)
    faded : float
        Between 0 and 1.
    longest : int, >= 0
        Longest lag that is tested. The result is 0 for a residual of zeros.
    """
    n = residual.size
    power = np.abs(np.fft.rfft(residual, 1 << (2 * n - 1).bit_length())) ** 2
    along = np.fft.irfft(power)[: longest + 1]
    if along[0] <= 0.0:
        return 0
    forgotten = np.flatnonzero(along < faded * along[0])
    return int(forgotten[0]) if forgotten.size else longest


def long_run(rows: Array, window: Array) -> Array:
    """Return the weighted sum of the autocovariances (p, p) of rows over positive and negative lags.

    Parameters
    ----------
    rows : ndarray (n, p)
        Terms of J'r: the slopes of a sample times its residual.
    window : ndarray (k,)
        Weight of each lag, from 0 on; lags beyond the rows are ignored.
    """
    n, lags = len(rows), min(window.size, len(rows))
    size = 1 << (n + lags - 1).bit_length()
    weights = np.zeros(size)
    weights[:lags] = window[:lags]
    weights[size - lags + 1 :] = window[1:lags][::-1]
    # Both ends of the spectrum count once, every other line twice, for its conjugate.
    share = np.fft.rfft(weights).real / size
    share[1:-1] *= 2.0
    spectrum = np.fft.rfft(rows, size, axis=0)
    return np.asarray(((spectrum.conj() * share[:, None]).T @ spectrum).real)


def coloured_deviations(columns: Array, residual: Array, inverse: Array, window: Array) -> Array:
    """Return standard deviations (p,) of least squares for a residual correlated over neighbouring rows.

    Parameters
    ----------
    columns : ndarray (n, p)
        Sensitivities.
    residual : ndarray (n,)
    inverse : ndarray (p, p)
        Inverse of columns' columns.
    window : ndarray (k,)
        Weight of each lag, from 0 on.
    """
    n, p = columns.shape
    covariance = inverse @ long_run(columns * residual[:, None], window) @ inverse * (n / max(n - p, 1))
    return np.asarray(np.sqrt(np.maximum(np.diag(covariance), 0.0)))
