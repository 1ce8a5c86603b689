"""Nonlinear least squares: the fit of a model's output, and its deviations.

The model's output depends on the command alone, so measurement noise does not bias the parameters. The covariance is (J'J)^-1 S (J'J)^-1,
where S is the sum of the autocovariances of J'r under a window over the lags: Bartlett's for nearly independent rows, Parzen's (round at
its top) if the errors of neighbouring samples cancel, a flat one if a model error lasts.

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
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.identification.descent import DescentSettings, descent, in_step, jacobian
from contourlab.arrays import Array, Flags
from contourlab.errors import ParameterError, refuse
from contourlab.findings import Finding, finding

NEAR_BOUND = 1e-6
"""Share of a parameter's scale within which it counts as lying at its bound."""
UNTOLD = 1e5
"""Condition number, columns of length one, above which parameters cannot be separated."""


@dataclass(frozen=True)
class Bounds:
    """A value within an interval of 95 %."""

    value: float
    low: float
    high: float

    @property
    def half(self) -> float:
        """Half the width."""
        return 0.5 * (self.high - self.low)


@dataclass(frozen=True)
class Free:
    """A parameter of a fit: start, bounds, and a typical size."""

    start: float
    low: float = -math.inf
    high: float = math.inf
    scale: float = 1.0


def arrays_of(free: Mapping[str, Free]) -> Array:
    """Return start, bounds and size of the parameters of a fit (4, p)."""
    return np.array([(part.start, part.low, part.high, part.scale) for part in free.values()]).T


@dataclass(frozen=True, eq=False)
class Estimate:
    """Parameters of a fit.

    Attributes
    ----------
    values, deviations, robust_deviations : ndarray (p,)
        Standard deviations for a white residual, and for a residual correlated in time; 0 for a parameter at its bound.
    correlation : ndarray (p, p)
        For a white residual.
    """

    names: tuple[str, ...]
    values: Array
    deviations: Array
    robust_deviations: Array
    correlation: Array

    @property
    def parameters(self) -> dict[str, float]:
        """All values by name."""
        return dict(zip(self.names, self.values.tolist(), strict=True))

    def __getitem__(self, name: str) -> float:
        """Return a parameter by name; KeyError if it was not fitted."""
        return self.parameters[name]

    def deviation(self, name: str) -> float:
        """Return the robust deviation of a parameter by name; KeyError if it was not fitted.

        The noise of a differenced position is correlated: deviations for a white residual would be many times too large.
        """
        return dict(zip(self.names, self.robust_deviations.tolist(), strict=True))[name]  # type: ignore[no-any-return]

    def mean(self, name: str) -> tuple[float, float]:
        """Return a parameter and its deviation; of the mean if there is one for each direction, which alone includes an offset."""
        if f"{name}+" not in self.names:
            return self[name], self.deviation(name)
        ways = f"{name}+", f"{name}-"
        return 0.5 * sum(map(self.__getitem__, ways)), 0.5 * math.hypot(*map(self.deviation, ways))


@dataclass(frozen=True, eq=False)
class OutputFit(Estimate):
    """Result of a fit of a model's output.

    Attributes
    ----------
    condition_number : float
        Of the sensitivities, columns of length one.
    measured, predicted : ndarray (n,)
    fit : float [percent]
        100 (1 - |measured - predicted|/|measured - mean|).
    left_out : float
        Rms of what stays in parts of the record under parameters fitted to the others, in the unit of `measured`; nan if not computed.
    """

    condition_number: float
    at_bound: tuple[str, ...]
    measured: Array
    predicted: Array
    fit: float
    left_out: float = field(default=math.nan, kw_only=True)


WELL_KNOWN = 0.1
"""Relative deviation up to which a parameter counts as identified: the usual limit for robots (Gautier)."""


def deviation_findings(name: str, value: float, deviation: float) -> list[Finding]:
    """Return a finding on a parameter whose deviation exceeds `WELL_KNOWN`."""
    if not deviation > WELL_KNOWN * abs(value):
        return []
    return [finding("CL526", name, value=value, deviation=deviation, share=deviation / abs(value) if value else math.inf)]


def fit_findings(fit: float, least: float, output: str) -> list[Finding]:
    """Return a finding on a fit [percent] of an output that is below the least one of a model that is not in doubt."""
    return [finding("CL533", fit=fit / 100.0, output=output)] if fit < least else []


LIGHT, HEAVY = 1e-2, 2e4
"""Moved masses [kg] from small stages to gantries; outside this range the units are in doubt."""
IMPOSSIBLE = (1e-5, 1e6)
"""Range of possible masses [kg]."""


def mass_findings(mass: float) -> tuple[list[Finding], bool]:
    """Return a finding for an implausible moved mass [kg], and whether the mass is possible at all.

    >>> mass_findings(95.1)
    ([], True)
    """
    if LIGHT <= mass <= HEAVY:
        return [], True
    return [finding("CL532", mass=mass)], IMPOSSIBLE[0] <= mass <= IMPOSSIBLE[1]


def fit_percent(measured: NDArray[Any], predicted: NDArray[Any]) -> float:
    """Return 100 (1 - |measured - predicted|/|measured - mean of measured|), of real or complex values."""
    spread = float(np.linalg.norm(measured - measured.mean()))
    if spread == 0.0:
        raise ParameterError("measured", f"{measured[0]:g} throughout", "a record that changes")
    return 100.0 * (1.0 - float(np.linalg.norm(measured - predicted)) / spread)


def fit_output(
    model: Callable[[Mapping[str, float]], Array], measured: Array, free: Mapping[str, Free], least_gain: float = 1e-12
) -> OutputFit:
    """Fit a model's output by nonlinear least squares (Gauss-Newton in a trust region, within bounds).

    Parameters
    ----------
    model : callable
        From parameters by name to its output (n,).
    measured : ndarray (n,)
    least_gain : float
        Relative fall of the sum of squares in a step below which the fit ends.

    Raises
    ------
    ParameterError
        If the record is too short, does not change, or does not determine the parameters.
    """
    from scipy.optimize import least_squares

    names = tuple(free)
    if measured.size <= 2 * len(names):
        raise ParameterError("record", f"{measured.size} samples", f"more than {2 * len(names)} for {len(names)} parameters")
    start, low, high, scale = arrays_of(free)

    def output(x: Array) -> Array:
        return model(dict(zip(names, x.tolist(), strict=True)))

    # Scaled to one, so that the tolerances do not depend on the unit.
    size = float(np.linalg.norm(measured - measured.mean())) / math.sqrt(measured.size) or 1.0

    def left(x: Array) -> Array:
        return (output(x) - measured) / size

    solution = least_squares(
        left, np.clip(start, low, high), jac="3-point", bounds=(low, high), x_scale=scale, xtol=1e-10, ftol=least_gain, gtol=1e-12
    )
    values = np.asarray(solution.x, dtype=float)
    lowest, highest = values - low <= NEAR_BOUND * scale, high - values <= NEAR_BOUND * scale
    values, inside = np.where(lowest, low, np.where(highest, high, values)), ~(lowest | highest)
    predicted, step = output(values), 1e-4 * np.maximum(np.abs(values), scale)  # wide enough to bridge the kinks of sticking
    (slopes,) = in_step(lambda points: np.array([output(x) for x in points]), [jacobian(values, predicted, low, high, step)])
    *known, condition = _covariance(slopes[:, inside], predicted - measured, np.array(names)[inside])
    return _output_fit(names, values, inside, known, condition, measured, predicted)


def _output_fit(
    names: tuple[str, ...], values: Array, inside: Flags, known: Sequence[Array], condition: float, measured: Array, predicted: Array
) -> OutputFit:
    """Return a fit, from white and robust deviations and the correlation of its parameters inside their bounds."""
    white, robust, correlation = np.zeros(len(names)), np.zeros(len(names)), np.eye(len(names))
    white[inside], robust[inside], correlation[np.ix_(inside, inside)] = known
    stuck = tuple(name for name, is_free in zip(names, inside, strict=True) if not is_free)
    return OutputFit(names, values, white, robust, correlation, condition, stuck, measured, predicted, fit_percent(measured, predicted))


def correlation_of(covariance: NDArray[Any]) -> Array:
    """Return the correlations of a covariance (p, p); 0 for a parameter without variance."""
    size = np.sqrt(np.where(np.diag(covariance) > 0.0, np.diag(covariance), 1.0))
    return np.asarray(covariance / np.outer(size, size))


def _covariance(slopes: Array, residual: Array, names: NDArray[Any]) -> tuple[Array, Array, Array, float]:
    """Return deviations for a white and for a correlated residual, correlation, and the condition number of the scaled slopes."""
    if not names.size:
        return np.empty(0), np.empty(0), np.empty((0, 0)), 1.0
    lengths = np.linalg.norm(slopes, axis=0)
    if not lengths.all():
        raise ParameterError("record", "a record", f"one in which {names[int(np.argmin(lengths))]} shows")
    scaled = slopes / lengths
    check_apart(scaled, names.tolist(), UNTOLD, "vary the command more")
    inverse = np.linalg.inv(scaled.T @ scaled)
    white = np.sqrt(np.diag(inverse) * float(residual @ residual) / max(residual.size - names.size, 1))
    robust = coloured_deviations(scaled, residual, inverse, lasting_window(residual))
    return white / lengths, robust / lengths, correlation_of(inverse), float(np.linalg.cond(scaled))


def check_apart(scaled: Array, names: Sequence[str], limit: float, cure: str) -> None:
    """Raise `ParameterError` if columns of length one have a condition number above a limit; it names the parameters they mix."""
    _, singular, directions = np.linalg.svd(scaled, full_matrices=False)
    if singular[-1] * limit <= singular[0]:
        mixed = [name for name, part in zip(names, directions[-1], strict=True) if abs(part) > 0.2]
        raise ParameterError("record", "a record", f"one that tells {' and '.join(mixed)} apart: {cure}")


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


UNTOLD_SHARE = 1e-10
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
    See `contourlab.analysis.identification.least_squares`.
    """
    p = jacobians[0].shape[-1]  # 0 if all parameters are at the bounds of their ranges
    flat = np.concatenate([j.reshape(r.size, p) for j, r in zip(jacobians, residuals, strict=True)])
    left = np.concatenate([r.ravel() for r in residuals])
    normal = flat.T @ flat
    lengths = np.sqrt(np.diag(normal))
    size = np.where(lengths > 0.0, lengths, 1.0)
    values, vectors = np.linalg.eigh(normal / np.outer(size, size))
    lost = values <= UNTOLD_SHARE * values.max(initial=1e-300)
    untold: Flags = (lengths == 0.0) | (np.abs(vectors[:, lost]) > 0.2).any(axis=1)
    inverse = (vectors[:, ~lost] / values[~lost]) @ vectors[:, ~lost].T / np.outer(size, size)
    spare = max(left.size - p, 1)
    white = np.sqrt(np.maximum(np.diag(inverse), 0.0) * (float(left @ left) + floor**2 * left.size) / spare)
    # Rows over which a record's residual counts as correlated.
    longest = [max(len(r) // LONGEST, 1) for r in residuals]
    faded = [max(memory(c - c.mean(), FADED, most) for c in r.T) for r, most in zip(residuals, longest, strict=True)]
    lags = max(min(max(usual_lags(len(r)), n), most) for r, n, most in zip(residuals, faded, longest, strict=True))
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
    deviations = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    return FitCovariance(deviations, np.where(untold, np.inf, white), correlation_of(inverse), untold)


def fit_records(designs: Sequence[Array], values: Sequence[Array]) -> tuple[Array, FitCovariance, list[Array]]:
    """Fit records by linear least squares; return the parameters (p,), their covariance, and the residual (n_k,) of each record.

    Parameters
    ----------
    designs : sequence of ndarray (n_k, p)
    values : sequence of ndarray (n_k,)
    """
    solution = np.asarray(np.linalg.lstsq(np.concatenate(designs), np.concatenate(values), rcond=None)[0])
    residuals = [value - design @ solution for value, design in zip(values, designs, strict=True)]
    return solution, fit_covariance([design[:, None] for design in designs], [rest[:, None] for rest in residuals]), residuals


def parted(jacobian: Array, residual: Array, parts: int, equal_information: bool = False) -> tuple[Array, float]:
    """Return what estimates show that leave out one part of the record after another: deviations by the jackknife, and what stays.

    Parameters
    ----------
    jacobian : ndarray (n, p)
        At the least sum of squares.
    residual : ndarray (n,)
    parts : int, >= 2
        Consecutive parts of equal length. What the model lacks lasts for a motion and differs from one kind of motion to the next: it is
        not noise, and is seen only between parts.
    equal_information : bool
        Divide the record into parts of equal information on the parameters, not of equal length: an axis may stand still for long.

    Returns
    -------
    deviations : ndarray (p,)
        Standard deviations; infinite if a part alone determines a parameter.
    left_out : float
        Rms residual of the parts under parameters fitted to the others; infinite likewise.

    Notes
    -----
    Each estimate takes one Gauss-Newton step from the whole record's.

    References
    ----------
    Efron & Stein, "The jackknife estimate of variance", Annals of Statistics 9(3), 1981.
    """
    lengths, unknown = np.linalg.norm(jacobian, axis=0), (np.full(jacobian.shape[1], math.inf), math.inf)
    if not lengths.all():
        return unknown
    columns, moved, left = jacobian / lengths, list[Array](), list[Array]()
    normal = columns.T @ columns
    share = (columns**2).sum(axis=1).cumsum()
    ends = np.searchsorted(share, share[-1] * np.arange(1, parts) / parts) if equal_information and lengths.size else parts
    for rows in np.array_split(np.arange(residual.size), ends):
        part = columns[rows]
        rest = normal - part.T @ part
        if lengths.size and np.linalg.cond(rest) * UNTOLD_SHARE > 1.0:
            return unknown
        moved.append(np.linalg.solve(rest, part.T @ residual[rows]))
        left.append(residual[rows] + part @ moved[-1])
    return np.std(moved, axis=0) * math.sqrt(parts - 1.0) / lengths, float(np.sqrt(np.mean(np.concatenate(left) ** 2)))


PARTS = range(4, 13)
"""Numbers of parts that a record is divided into. How long it lasts what the model lacks is unknown: the largest deviation counts."""
Model = Callable[[Sequence[Mapping[str, float]]], Array]
"""Outputs (m, n) of a model for m sets of its parameters."""


def descended(
    model: Model,
    measured: Array,
    free: Mapping[str, Free],
    points: Array,
    settings: DescentSettings | None = None,
    equal_information: bool = False,
) -> tuple[OutputFit, list[Array]]:
    """Fit a model's output (n,) from points (k, p), in steps that bridge its kinks; return the best end, and the values (p,) of all.

    The deviations are those of the jackknife over parts of the record, the largest over several numbers of parts; see `parted` for
    `equal_information`.

    Raises
    ------
    ParameterError
        If no point can be evaluated, or one is outside the bounds.
    """
    names, (_, low, high, scale) = tuple(free), arrays_of(free)

    def residuals(points: Array) -> Array:
        return model([dict(zip(names, x.tolist(), strict=True)) for x in points]) - measured

    refuse(not (np.all(low <= points) and np.all(points <= high)), ParameterError, "start", "a point", f"within {low} and {high}")
    left = residuals(points)
    usable = np.isfinite(left).all(axis=1) & left.any(axis=1)
    if not usable.any():
        raise ParameterError("start", "all points", "parameters that can be simulated, and do not fit exactly: the runs diverge there")
    points, left = points[usable], left[usable]
    sizes = [float(np.sqrt(np.mean(r**2))) for r in left]
    searches = [descent(x, r / size, low, high, scale, settings) for x, r, size in zip(points, left, sizes, strict=True)]
    ends = in_step(residuals, searches, sizes)
    fits = [fit_percent(measured, measured + size * end.residual) for end, size in zip(ends, sizes, strict=True)]
    best = int(np.argmax(fits))
    end, size = ends[best], sizes[best]
    inside = (end.values > low) & (end.values < high)
    slopes, away = end.jacobian[:, inside], math.nan
    by_parts = [parted(slopes, end.residual, parts, equal_information) for parts in PARTS]
    robust = np.max([deviations for deviations, _ in by_parts], axis=0)
    lengths = np.linalg.norm(slopes, axis=0)
    lengths = np.where(lengths > 0.0, lengths, np.inf)
    inverse = np.linalg.pinv((slopes / lengths).T @ (slopes / lengths), hermitian=True)
    spread = np.sqrt(np.maximum(np.diag(inverse), 0.0))  # rounding may turn the sign
    white = spread / lengths * math.sqrt(float(end.residual @ end.residual) / max(measured.size - len(names), 1))
    if equal_information:  # it is equal for all parameters together, not for each
        robust = np.maximum(robust, white)
        away = size * float(np.mean([left for _, left in by_parts]))
    known, output = (white, robust, correlation_of(inverse)), measured + size * end.residual
    fit = replace(_output_fit(names, end.values, inside, known, 1.0, measured, output), left_out=away)
    return fit, [end.values for end in ends]
