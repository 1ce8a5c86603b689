"""What stands against refined parameters, in words."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.identification.gauss_newton import Descent, FitCovariance
from contourlab.features.refine.log_run import Agreement
from contourlab.features.refine.parameters import Sought

Array = NDArray[np.float64]

TOGETHER = 0.95
"""Correlation from which two parameters are said to go together."""
UNKNOWN = 0.5
"""Relative deviation from which a parameter is said to be hardly known."""
EXPLAINED = 0.5
"""Share of the variance of a signal below which it is remarked on."""
WORSE = 0.01
"""Share by which more may be left of what was not fitted than before."""
COLOURED = 1.5
"""Ratio of deviations with and without colour from which it is remarked on."""


def shown(one: Sought, value: float, digits: int = 5) -> str:
    """Return a value of a parameter in the unit that people use."""
    return f"{one.number.shown(value):.{digits}g} {one.number.written_in}".strip()


def remarks_on(
    sought: Sequence[Sought],
    found: Descent,
    deviations: Array,
    white: Array,
    knowledge: FitCovariance,
    after: Sequence[Agreement],
    descents: tuple[int, int],
) -> tuple[tuple[str, ...], bool]:
    """Return what stands against the parameters, and whether they can be used.

    Parameters
    ----------
    sought : sequence of Sought
    found : Descent
    deviations, white : ndarray (p,)
        With and without the colour of the residual.
    knowledge : FitCovariance
        Of the parameters that are not at a bound.
    after : sequence of Agreement
    descents : (int, int)
        Made, and ended at the same minimum as the best.
    """
    usable = found.converged and all(one.explained > 0.0 for one in after)
    said = [*_on_values(sought, found, deviations), *_on_pairs(sought, found, knowledge)]
    if not found.converged:
        said.append(f"not converged within {found.iterations} steps: the figures are not those of a minimum")
    made, same = descents
    if made > 1 and same < made:
        told = "the others ended higher" if same > 1 else "all others ended higher, so that a better one cannot be ruled out"
        said.append(f"{same} of {made} descents ended at the least sum of squares; {told}")
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.nan_to_num(deviations / white, nan=1.0, posinf=1.0)
    if ratio.size and ratio.max() > COLOURED:
        said.append(f"the residual is not white: deviations that allow for it are up to {ratio.max():.2g} times as large")
    said += [
        f"{one.run}: the model explains {100.0 * one.explained:.3g} % of the variance of the {one.signal} of {one.axis} only"
        for one in after
        if 0.0 < one.explained < EXPLAINED
    ]
    said += [
        f"{one.run}: the model explains none of the {one.signal} of {one.axis}: something else is at work there"
        for one in after
        if one.explained <= 0.0
    ]
    return tuple(said), usable


def worse_than_before(where: str, before: Sequence[Agreement], after: Sequence[Agreement]) -> tuple[str, ...]:
    """Return what is to be said where a refined model follows what was not fitted less well than the one that it began with.

    Parameters
    ----------
    where : str
        What was not fitted, in words.
    before, after : sequence of Agreement
        Of the same signals in the same order.
    """
    worse = [(one, other) for one, other in zip(before, after, strict=True) if other.rms > (1.0 + WORSE) * one.rms]
    if not worse:
        return ()
    told = ", ".join(
        f"{other.signal} of {other.axis} in {other.run} {size_left(other)} where it left {size_left(one)}" for one, other in worse
    )
    return (f"{where} the refined numbers follow less well than those before: {told}; they fit what was fitted and nothing else",)


def size_left(one: Agreement) -> str:
    """Return how much of a signal is left (rms), in the unit that people use."""
    return f"{one.rms * 1e6:.3g} um" if one.signal == "position" else f"{one.rms:.3g}"


def _on_values(sought: Sequence[Sought], found: Descent, deviations: Array) -> Iterator[str]:
    for one, value, deviation, bound in zip(sought, found.values.tolist(), deviations.tolist(), found.at_bound.tolist(), strict=True):
        if bound:
            yield f"{one.label} stands at the bound of its range, {shown(one, value)}: the fit wants it further"
        elif not np.isfinite(deviation):
            yield f"{one.label} has no effect of its own in these logs: it cannot be told from them"
        elif deviation > UNKNOWN * abs(value) and not one.signed:
            yield f"{one.label} = {shown(one, value)} is hardly known, standard deviation {shown(one, deviation, 2)}"


def _on_pairs(sought: Sequence[Sought], found: Descent, knowledge: FitCovariance) -> Iterator[str]:
    names = [one.label for one, bound in zip(sought, found.at_bound, strict=True) if not bound]
    strong = np.argwhere(np.triu(np.abs(knowledge.correlation), 1) > TOGETHER)
    for i, j in strong.tolist():
        if not (knowledge.untold[i] or knowledge.untold[j]):
            pair, strength = f"{names[i]} and {names[j]}", f"{knowledge.correlation[i, j]:.3f}"
            yield f"{pair} go together, correlation {strength}: one is worth what is known of the other"
