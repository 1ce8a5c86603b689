"""Doubts about an identified axis: impossible signs, poorly determined parameters, a residual that is not noise."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ParameterError

Array = NDArray[np.float64]

WELL_KNOWN = 10.0
"""Relative deviation [percent] up to which a parameter counts as identified: the usual limit for robots (Gautier)."""
EXCITED = 100.0
"""Condition number, columns of length one, from which excitation gets a remark."""
EXPLAINED, LEAST = 90.0, 75.0
"""Fit [percent] below which the model gets a remark, and below which the figures cannot be used.

The EMPS' log leaves 4 % of its force. Of the runs of one measured table at constant speeds those with a fit of 80 % and more tell its mass
within 8 %, at 72 % it is a fifth too large, at 51 % two thirds; the EMPS with its reference in place of its position has 69 %.
"""
LIGHT, HEAVY = 1e-2, 2e4
"""Moved masses [kg] from small stages to gantries; outside, the units are in doubt."""
IMPOSSIBLE = (1e-5, 1e6)
"""Range of possible masses [kg]."""
COLOURED = 1.5
"""Ratio of deviations, with and without correlation of the residual, from which it gets a remark."""
AT_REST, RESTS = 5e-3, 0.05
"""Share of the largest speed below which an axis is at rest, and share of rows at rest from which that gets a remark."""


def check_signs(names: tuple[str, ...], values: Array, deviations: Array) -> None:
    """Refuse a mass, or a Coulomb friction by more than two deviations, below zero.

    Parameters
    ----------
    names : tuple of str
    values, deviations : ndarray (p,)

    Raises
    ------
    ParameterError
        If there is one.
    """
    found = dict(zip(names, values.tolist(), strict=True))
    if found["M"] <= 0.0:
        bound = "> 0: force or position is counted the other way round, they are not of one axis, or the record hardly accelerates"
        raise ParameterError("M", f"{found['M']:.4g} kg", bound)
    friction, deviation = mean_coulomb(names, values, deviations)
    if friction < -2.0 * deviation:
        bound = "above zero: the force helps the motion in both directions, so it is not what moves this axis"
        raise ParameterError("Fc", f"{friction:.4g} N", bound)


def on_mass(mass: float) -> tuple[list[str], bool]:
    """Return remarks on an unlikely moved mass [kg], and whether it is possible at all.

    >>> on_mass(95.1)
    ([], True)
    """
    if LIGHT <= mass <= HEAVY:
        return [], True
    remark = f"a mass of {mass:.4g} kg is moved: are the units of position, force and gain right?"
    return [remark], IMPOSSIBLE[0] <= mass <= IMPOSSIBLE[1]


def mean_coulomb(names: tuple[str, ...], values: Array, deviations: Array) -> tuple[float, float]:
    """Return Coulomb friction over both directions and its deviation; one direction alone also holds the offset, as gravity."""
    places = [i for i, name in enumerate(names) if name.startswith("Fc")]
    return float(values[places].mean()), float(np.sqrt(np.sum(deviations[places] ** 2)) / len(places))


def remarks_on(
    names: tuple[str, ...], values: Array, deviations: Array, robust: Array, columns: Array, velocity: Array, fit: float, slowest: float
) -> tuple[tuple[str, ...], bool]:
    """Return remarks on the figures, and whether they can be used.

    Parameters
    ----------
    names : tuple of str
    values, deviations, robust : ndarray (p,)
        Robust: deviations that allow for correlation of the residual.
    columns : ndarray (n, p)
    velocity : ndarray (n,) [m/s]
    fit : float [percent]
    slowest : float [m/s]
        Speed below which rows were left out.
    """
    remarks, usable = _on_parameters(names, values, np.maximum(deviations, robust))
    lengths = np.linalg.norm(columns, axis=0)
    condition = float(np.linalg.cond(columns / lengths))
    if condition > EXCITED:
        remarks.append(f"too little excitation: condition number {condition:.3g} with columns of length one, below {EXCITED:g} is usual")
    if fit < EXPLAINED:
        asked = "is the position the measured one, and the force that of this axis?"
        remarks.append(f"the model explains {fit:.3g} % of the force: other friction or another force is at work, or {asked}")
        usable = usable and fit >= LEAST
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = float(np.nan_to_num(robust / deviations, nan=1.0).max())
    if ratio > COLOURED:
        remarks.append(f"the residual is not white: deviations that allow for it are up to {ratio:.2g} times as large")
    resting = float(np.mean(np.abs(velocity) < AT_REST * np.abs(velocity).max()))
    if resting > RESTS and slowest == 0.0:
        remarks.append(f"{100.0 * resting:.2g} % of the rows are at rest, where the sign of v is noise: leave them out with --slowest")
    return tuple(remarks), usable


def _on_parameters(names: tuple[str, ...], values: Array, deviations: Array) -> tuple[list[str], bool]:
    remarks, usable = [], True
    for name, value, deviation in zip(names, values.tolist(), deviations.tolist(), strict=True):
        share = 100.0 * deviation / abs(value) if value else np.inf
        if name == "offset" or share <= WELL_KNOWN:
            continue  # an offset of nothing is welcome
        known = "is not distinguishable from zero" if abs(value) < 2.0 * deviation else f"is known to {share:.2g} % only"
        remarks.append(f"{name} = {value:.4g} {known}, standard deviation {deviation:.2g}: too little excitation")
        usable = usable and name != "M"
    on_the_mass, possible = on_mass(float(values[names.index("M")]))
    remarks, usable = [*remarks, *on_the_mass], usable and possible
    friction, _ = mean_coulomb(names, values, deviations)
    if friction < 0.0:
        remarks.append(f"Fc = {friction:.4g} is below zero within its deviation: unusable as it stands, take no Coulomb friction")
        usable = False
    elif len(names) == 5:
        remarks.extend(
            f"{name} = {value:.4g} is below zero: a constant force larger than Coulomb friction acts, as gravity does"
            for name, value in zip(names, values.tolist(), strict=True)
            if name.startswith("Fc") and value < 0.0
        )
    for name, value in zip(names, values.tolist(), strict=True):
        if name.startswith("Fv") and value < 0.0:
            remarks.append(f"{name} = {value:.4g} is below zero: unusable; friction falls with speed (Stribeck), or speeds are too alike")
            usable = False
    return remarks, usable
