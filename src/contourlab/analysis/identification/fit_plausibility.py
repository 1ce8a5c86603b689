"""Plausibility of an identified axis: impossible signs, poorly determined parameters, a residual that is not noise."""

from __future__ import annotations

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ParameterError
from contourlab.findings import Finding, finding

WELL_KNOWN = 10.0
"""Relative deviation [percent] up to which a parameter counts as identified: the usual limit for robots (Gautier)."""
EXCITED = 100.0
"""Condition number, columns of length one, above which the excitation is too weak."""
EXPLAINED, LEAST = 90.0, 75.0
"""Fit [percent] below which the model is in doubt, and below which the figures cannot be used.

The log of the EMPS leaves 4 % of the force unexplained. For one measured table at constant speeds, a fit of 80 % or more gives the mass
within 8 %; at 72 % the mass is a fifth too large, at 51 % two thirds. The EMPS with its reference in place of its position has 69 %.
"""
LIGHT, HEAVY = 1e-2, 2e4
"""Moved masses [kg] from small stages to gantries; outside this range the units are in doubt."""
IMPOSSIBLE = (1e-5, 1e6)
"""Range of possible masses [kg]."""
COLOURED = 1.5
"""Ratio of the deviations with and without correlation of the residual, above which the residual is coloured."""
AT_REST, RESTS = 5e-3, 0.05
"""Share of the largest speed below which an axis is at rest, and largest share of rows at rest."""


def check_signs(names: tuple[str, ...], values: Array, deviations: Array) -> None:
    """Check the signs of mass and Coulomb friction.

    Parameters
    ----------
    values, deviations : ndarray (p,)

    Raises
    ------
    ParameterError
        If the mass is not above zero, or Coulomb friction is below zero by more than two deviations.
    """
    found = dict(zip(names, values.tolist(), strict=True))
    if found["M"] <= 0.0:
        bound = "> 0: force or position is counted the other way round, they are not of one axis, or the record hardly accelerates"
        raise ParameterError("M", f"{found['M']:.4g} kg", bound)
    friction, deviation = mean_coulomb(names, values, deviations)
    if friction < -2.0 * deviation:
        bound = "above zero: the force helps the motion in both directions, so it is not what moves this axis"
        raise ParameterError("Fc", f"{friction:.4g} N", bound)


def mass_findings(mass: float) -> tuple[list[Finding], bool]:
    """Return a finding for an implausible moved mass [kg], and whether the mass is possible at all.

    >>> mass_findings(95.1)
    ([], True)
    """
    if LIGHT <= mass <= HEAVY:
        return [], True
    return [finding("CL532", mass=mass)], IMPOSSIBLE[0] <= mass <= IMPOSSIBLE[1]


def mean_coulomb(names: tuple[str, ...], values: Array, deviations: Array) -> tuple[float, float]:
    """Return the mean Coulomb friction of both directions and its deviation; that of one direction includes the offset, such as gravity."""
    places = [i for i, name in enumerate(names) if name.startswith("Fc")]
    return float(values[places].mean()), float(np.sqrt(np.sum(deviations[places] ** 2)) / len(places))


def fit_findings(
    names: tuple[str, ...], values: Array, deviations: Array, robust: Array, columns: Array, velocity: Array, fit: float, slowest: float
) -> tuple[tuple[Finding, ...], bool]:
    """Return findings on the result of inverse dynamics, and whether it can be used.

    Parameters
    ----------
    values, deviations, robust : ndarray (p,)
        `robust` are deviations that allow for correlation of the residual.
    columns : ndarray (n, p)
    velocity : ndarray (n,) [m/s]
    fit : float [percent]
    slowest : float [m/s]
        Speed below which rows were left out.
    """
    findings, usable = _parameter_findings(names, values, np.maximum(deviations, robust))
    lengths = np.linalg.norm(columns, axis=0)
    condition = float(np.linalg.cond(columns / lengths))
    if condition > EXCITED:
        findings.append(finding("CL534", condition=condition, usual=EXCITED))
    if fit < EXPLAINED:
        findings.append(finding("CL533", fit=fit / 100.0, output="force"))
        usable = usable and fit >= LEAST
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = float(np.nan_to_num(robust / deviations, nan=1.0).max())
    if ratio > COLOURED:
        findings.append(finding("CL535", ratio=ratio))
    resting = float(np.mean(np.abs(velocity) < AT_REST * np.abs(velocity).max()))
    if resting > RESTS and slowest == 0.0:
        findings.append(finding("CL536", share=resting))
    return tuple(findings), usable


def _parameter_findings(names: tuple[str, ...], values: Array, deviations: Array) -> tuple[list[Finding], bool]:
    findings, usable = [], True
    for name, value, deviation in zip(names, values.tolist(), deviations.tolist(), strict=True):
        share = deviation / abs(value) if value else np.inf
        if name == "offset" or 100.0 * share <= WELL_KNOWN:
            continue  # the offset may be zero
        findings.append(finding("CL526", name, value=value, deviation=deviation, share=share))
        usable = usable and name != "M"
    on_mass, possible = mass_findings(float(values[names.index("M")]))
    findings, usable = [*findings, *on_mass], usable and possible
    friction, _ = mean_coulomb(names, values, deviations)
    if friction < 0.0:
        findings.append(finding("CL530", "Fc", value=friction))
        usable = False
    elif len(names) == 5:
        findings += [finding("CL531", n, value=x) for n, x in zip(names, values.tolist(), strict=True) if n.startswith("Fc") and x < 0.0]
    negative = [finding("CL530", n, value=x) for n, x in zip(names, values.tolist(), strict=True) if n.startswith("Fv") and x < 0.0]
    return [*findings, *negative], usable and not negative
