"""Identification of one rigid axis from a record of position and force: the inverse dynamic model by least squares (IDIM-LS).

The force is linear in the parameters: M a + F_v v + F_c sign(v) + offset. One least-squares solution on filtered derivatives of the
measured position gives all parameters, in open or closed loop. Velocity and acceleration have no lag (`filtered_motion`). Columns and force
pass the same low-pass and decimation. Position noise enters the columns: without filtering it biases the mass towards zero.

References
----------
Gautier, Janot & Vandanjon, "A new closed-loop output error method for parameter identification of robot dynamics", IEEE Trans. Control
Systems Technology 21(2), 2013, section II; Janot, Gautier & Brunot, "Data set and reference models of EMPS", 2019 Workshop on nonlinear
system identification benchmarks, section 3, and eq (12) for friction by direction.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from itertools import chain
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.identification.filtered_motion import decimate, even_record, filtered_motion, kept_samples
from contourlab.analysis.identification.least_squares import (
    Estimate,
    bartlett,
    check_apart,
    coloured_deviations,
    correlation_of,
    deviation_findings,
    fit_findings,
    mass_findings,
    usual_lags,
)
from contourlab.arrays import Array
from contourlab.errors import ParameterError, refuse
from contourlab.findings import Finding, finding

EXCITED = 100.0
"""Condition number, columns of length one, above which the excitation is too weak."""
EXPLAINED, LEAST = 90.0, 75.0
"""Fit [percent] below which the model is in doubt, and below which the figures cannot be used.

The log of the EMPS leaves 4 % of the force unexplained. For one measured table at constant speeds, a fit of 80 % or more gives the mass
within 8 %; at 72 % the mass is a fifth too large, at 51 % two thirds. The EMPS with its reference in place of its position has 69 %.
"""
COLOURED = 1.5
"""Ratio of the deviations with and without correlation of the residual, above which the residual is coloured."""
AT_REST, RESTS = 5e-3, 0.05
"""Share of the largest speed below which an axis is at rest, and largest share of rows at rest."""


PARAMETERS = {"symmetric": ("M", "Fv", "Fc", "offset"), "asymmetric": ("M", "Fv+", "Fc+", "Fv-", "Fc-")}
"""Parameters by friction model; in the asymmetric model the Coulomb forces include the offset, (Fc+ - Fc-)/2."""
FEWEST_ROWS = 20
"""Smallest number of samples after filter and decimation."""
SINGULAR = 1e6
"""Condition number, columns of length one, above which the parameters cannot be separated."""


@dataclass(frozen=True)
class InverseDynamicsSettings:
    """Filtering of a record, and friction model.

    Attributes
    ----------
    friction : str
        ``"symmetric"``: F_c sign(v) + F_v v + offset; ``"asymmetric"``: F_c+ and F_v+ forwards, F_c- and F_v- backwards.
    cutoff : float [Hz], > 0
        Of the low-pass of the position: five times the bandwidth of the position loop is usual.
    order : int, >= 1
        Of that low-pass, one pass of two.
    decimation : int, >= 1
        Of the columns and the force: 0.8 of the Nyquist frequency over twice the bandwidth is usual.
    dropped : (int, int), >= 0
        Samples dropped at the start and at the end, where the filter settles.
    slowest : float [m/s], >= 0
        Rows at a lower speed are left out: at rest friction equals the force, and the sign of v is noise.
    lost_degrees : int or None
        Degrees of freedom subtracted from the rows in the residual's variance; by default the number of parameters. The figures published
        for the EMPS use 1.
    """

    friction: str = "symmetric"
    cutoff: float = 100.0
    order: int = 4
    decimation: int = 10
    dropped: tuple[int, int] = (50, 50)
    slowest: float = 0.0
    lost_degrees: int | None = None

    def __post_init__(self) -> None:
        if not (isinstance(self.decimation, int) and self.decimation >= 1):
            raise ParameterError("decimation", self.decimation, "a whole number of 1 or more")
        refuse(not (math.isfinite(self.slowest) and self.slowest >= 0.0), ParameterError, "slowest", f"{self.slowest:g}", ">= 0", "m/s")


class _Rows(NamedTuple):
    """One row of the equations for each decimated sample."""

    time: Array
    velocity: Array
    columns: Array
    force: Array


@dataclass(frozen=True, eq=False)
class Validation:
    """How well known parameters explain a record.

    Attributes
    ----------
    time, velocity : ndarray (n,) [s, m/s]
        Of the rows.
    force, predicted : ndarray (n,) [N]
        Measured (filtered as the columns), and from the model.
    residual_norm : float [N]
        Euclidean norm of their difference.
    residual_deviation : float [N]
        Its standard deviation about its mean.
    relative_error : float [percent]
        100 |force - predicted|/|force|.
    fit : float [percent]
        100 (1 - |force - predicted|/|force - mean of force|).
    condition_number : float
        Of the observation matrix, in SI units.
    """

    time: Array
    velocity: Array
    force: Array
    predicted: Array
    residual_norm: float
    residual_deviation: float
    relative_error: float
    fit: float
    condition_number: float


@dataclass(frozen=True, eq=False)
class InverseDynamicsFit(Validation, Estimate):
    """The parameters of an axis, and how well they explain their own record.

    Parameters are from `PARAMETERS`: M [kg], Fv [N s/m], Fc [N], offset [N]. Deviations assume a residual that is white after decimation,
    and columns without noise; robust ones a residual correlated over neighbouring rows (Newey & West) after decimation.

    Attributes
    ----------
    usable : bool
        False if viscous or mean Coulomb friction is below zero, the mass is impossible or uncertain by more than 10 percent, or the fit is
        below 75 percent.
    findings : tuple of Finding
        Reasons to doubt the parameters; may be empty.
    """

    settings: InverseDynamicsSettings
    usable: bool = True
    findings: tuple[Finding, ...] = ()

    @property
    def relative_deviations(self) -> Array:
        """Deviations over the values (p,) [percent]."""
        with np.errstate(divide="ignore"):
            return np.asarray(100.0 * self.deviations / np.abs(self.values))

    @property
    def known(self) -> Array:
        """The larger deviation (p,) of each parameter."""
        return np.maximum(self.deviations, self.robust_deviations)


def identify_inverse_dynamics(
    time: ArrayLike, position: ArrayLike, force: ArrayLike, settings: InverseDynamicsSettings | None = None
) -> InverseDynamicsFit:
    """Identify mass, viscous and Coulomb friction and offset of an axis from a record of its motion and its drive's force.

    Parameters
    ----------
    time : array_like (n,) [s]
        Evenly spaced within a thousandth of the period.
    position : array_like (n,) [m]
        Measured.
    force : array_like (n,) [N]
        Of the drive, at the table: command times drive gain. In another unit F, the parameters are in F s^2/m, F s/m and F.

    Raises
    ------
    ParameterError
        If the record is too short, uneven or not finite; if its arrays differ in length; if the cut-off is not below the Nyquist
        frequency; if the axis never moves in one of its directions; if the parameters cannot be separated; if the mass is below zero, or
        Coulomb friction by more than two deviations.
    """
    chosen = settings or InverseDynamicsSettings()
    rows = _rows(time, position, force, chosen)
    names = PARAMETERS[chosen.friction]
    _check_excitation(rows, names)
    q, r = np.linalg.qr(rows.columns)
    values = np.linalg.solve(r, q.T @ rows.force)
    residual = rows.force - rows.columns @ values
    inverse = np.linalg.inv(r)
    unscaled = inverse @ inverse.T
    lost = len(names) if chosen.lost_degrees is None else chosen.lost_degrees
    fit = InverseDynamicsFit(
        names=names,
        values=values,
        deviations=np.sqrt(np.diag(unscaled) * float(residual @ residual) / max(residual.size - lost, 1)),
        robust_deviations=coloured_deviations(rows.columns, residual, unscaled, bartlett(usual_lags(residual.size))),
        correlation=correlation_of(unscaled),
        settings=chosen,
        **vars(_judged(rows, rows.columns @ values)),
    )
    friction, deviation = replace(fit, robust_deviations=fit.known).mean("Fc")
    if fit["M"] <= 0.0:
        bound = "> 0: force or position is counted the other way round, they are not of one axis, or the record hardly accelerates"
        raise ParameterError("M", f"{fit['M']:.4g} kg", bound)
    if friction < -2.0 * deviation:
        bound = "above zero: the force helps the motion in both directions, so it is not what moves this axis"
        raise ParameterError("Fc", f"{friction:.4g} N", bound)
    findings, usable = _doubts(fit, rows.columns)
    return replace(fit, findings=tuple(findings), usable=usable)


def _doubts(fit: InverseDynamicsFit, columns: Array) -> tuple[list[Finding], bool]:
    """Return findings on parameters and record, and whether the fit can be used."""
    on_mass, usable = mass_findings(fit["M"])
    poor = {
        name: deviation_findings(name, value, deviation)
        for name, value, deviation in zip(fit.names, fit.values.tolist(), fit.known.tolist(), strict=True)
        if name != "offset"  # it may be zero
    }
    negative, friction = {name: value for name, value in fit.parameters.items() if value < 0.0}, fit.mean("Fc")[0]
    coulomb = [finding("CL531", name, value=value) for name, value in negative.items() if name in ("Fc+", "Fc-")]
    viscous = [finding("CL530", name, value=value) for name, value in negative.items() if name.startswith("Fv")]
    findings = [*chain(*poor.values()), *on_mass, *([finding("CL530", "Fc", value=friction)] if friction < 0.0 else coulomb), *viscous]
    condition = float(np.linalg.cond(columns / np.linalg.norm(columns, axis=0)))
    findings += [finding("CL534", condition=condition, usual=EXCITED)] if condition > EXCITED else []
    findings += fit_findings(fit.fit, EXPLAINED, "force")
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = float(np.nan_to_num(fit.robust_deviations / fit.deviations, nan=1.0).max())
    findings += [finding("CL535", ratio=ratio)] if ratio > COLOURED else []
    resting = float(np.mean(np.abs(fit.velocity) < AT_REST * np.abs(fit.velocity).max()))
    findings += [finding("CL536", share=resting)] if resting > RESTS and fit.settings.slowest == 0.0 else []
    return findings, usable and not poor["M"] and friction >= 0.0 and not viscous and fit.fit >= LEAST


def cross_validate(fit: InverseDynamicsFit, time: ArrayLike, position: ArrayLike, force: ArrayLike) -> Validation:
    """Return how well the parameters of one record explain a second one, with the same filter settings.

    Parameters
    ----------
    time, position, force
        As in `identify_inverse_dynamics`; length and period may differ.

    Raises
    ------
    ParameterError
        If the record is too short, uneven or not finite, its arrays differ in length, or its Nyquist frequency is below the cut-off.
    """
    rows = _rows(time, position, force, fit.settings)
    return _judged(rows, rows.columns @ fit.values)


def _rows(time: ArrayLike, position: ArrayLike, force: ArrayLike, settings: InverseDynamicsSettings) -> _Rows:
    period, (t, q, f) = even_record(time, {"position": position, "force": force}, FEWEST_ROWS)
    motion = filtered_motion(q, period, cutoff=settings.cutoff, order=settings.order)
    first, last = settings.dropped[0], t.size - settings.dropped[1]
    n_row = -(-max(last - first, 0) // settings.decimation)
    if n_row < FEWEST_ROWS:
        shortest = sum(settings.dropped) + (FEWEST_ROWS - 1) * settings.decimation + 1
        raise ParameterError("time", f"{t.size} samples", f"a record of {shortest} or more: fewer leave under {FEWEST_ROWS} rows")
    part = slice(first, last)
    v = motion.velocity[part]
    columns = decimate(_columns(motion.acceleration[part], v, settings.friction), settings.decimation)
    kept = kept_samples(v.size, settings.decimation)
    rows = _Rows(t[part][kept], v[kept], columns, decimate(f[part], settings.decimation))
    if settings.slowest == 0.0:
        return rows
    moving = np.abs(rows.velocity) >= settings.slowest
    if np.count_nonzero(moving) < FEWEST_ROWS:
        raise ParameterError("slowest", f"{settings.slowest:g}", f"passed in at least {FEWEST_ROWS} rows", "m/s")
    return _Rows(*(part[moving] for part in rows))


def _columns(acceleration: Array, velocity: Array, friction: str) -> Array:
    """Return the observation matrix, with one column per parameter."""
    way = np.sign(velocity)
    if friction == "symmetric":
        return np.column_stack([acceleration, velocity, way, np.ones_like(way)])
    forward, backward = 0.5 * (1.0 + way), 0.5 * (1.0 - way)
    return np.column_stack([acceleration, velocity * forward, way * forward, velocity * backward, way * backward])


def _check_excitation(rows: _Rows, names: tuple[str, ...]) -> None:
    """Raise `ParameterError` for a record without both directions, or with linearly dependent columns."""
    fastest = float(np.abs(rows.velocity).max())
    refuse(fastest == 0.0, ParameterError, "position", "one place throughout", "a record in which the axis moves")
    for way, word in ((1.0, "forwards"), (-1.0, "backwards")):
        if np.count_nonzero(way * rows.velocity > 0.01 * fastest) < FEWEST_ROWS // 4:
            bound = "a record that moves both ways: one direction cannot separate friction and offset"
            raise ParameterError("velocity", f"never {word}", bound)
    lengths = np.linalg.norm(rows.columns, axis=0)
    if not lengths.all():
        raise ParameterError("record", "a record", f"one that moves {names[int(np.argmin(lengths))]}")
    check_apart(rows.columns / lengths, names, SINGULAR, "vary speed and acceleration")


def _judged(rows: _Rows, predicted: Array) -> Validation:
    left = rows.force - predicted
    norm, size, spread = (float(np.linalg.norm(x)) for x in (left, rows.force, rows.force - rows.force.mean()))
    if spread <= 1e-9 * size:
        raise ParameterError("force", f"{rows.force.mean():.4g} throughout", "a record in which the drive pushes the axis about")
    deviation = float(np.std(left, ddof=1))
    condition = float(np.linalg.cond(rows.columns))
    relative, explained = 100.0 * norm / size, 100.0 * (1.0 - norm / spread)
    return Validation(rows.time, rows.velocity, rows.force, predicted, norm, deviation, relative, explained, condition)
