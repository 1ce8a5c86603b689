"""What a study says in words: which numbers matter, which do not, which belong together, what to calibrate first."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from contourlab.features.sensitivity.curves import CHANGE, Curve
from contourlab.features.sensitivity.runs import Array
from contourlab.features.sensitivity.study import Study

LOCAL = "local sensitivity"
SMALL = 0.05
"""Share of the variance, or of the largest effect, below which a number does not matter."""
WIDE = 0.1
"""Half an interval wider than this leaves the order of numbers open."""
TOGETHER = 0.1
"""Share of the variance, and relative second difference, from which two numbers belong together."""
WORTHWHILE = 0.05
"""Part by which a number's minimum must lie below the figure as it is, to be worth calibrating."""


@dataclass(frozen=True)
class Ranking:
    """Numbers in three groups, each from the most to the least.

    Attributes
    ----------
    by : str
        What they were told apart by.
    matter, open, rest : tuple of int
        Those that matter, those of which the intervals do not tell, those that do not matter.
    strength : tuple of float
        Of each number, in the order of the space.
    """

    by: str
    matter: tuple[int, ...]
    open: tuple[int, ...]
    rest: tuple[int, ...]
    strength: tuple[float, ...]


def ranking(study: Study) -> Ranking | None:
    """Return which numbers matter by the best there is: Sobol's total indices, Morris' mu*, local sensitivities, or curves."""
    if study.sobol is not None:
        return _grouped("total index", study.sobol.total, study.sobol.total_interval, SMALL)
    if study.morris is not None:
        top = float(study.morris.mu_star.max())
        return _grouped("mu*", study.morris.mu_star, study.morris.mu_star_interval, SMALL * top)
    if study.local is not None:
        slopes = np.array([abs(one.sensitivity) for one in study.local.slopes])
        apart = np.array([one.apart for one in study.local.slopes])
        return _grouped(LOCAL, np.nan_to_num(slopes), np.nan_to_num(apart, nan=np.inf), SMALL)
    if study.curves is not None:
        ranges = np.array([_decades(curve) for curve in study.curves])
        return _grouped("change over its curve", ranges, np.zeros(len(ranges)), float(np.log10(1.0 + CHANGE)))
    return None


def _grouped(by: str, strength: Array, interval: Array, bound: float) -> Ranking:
    order = [int(j) for j in np.argsort(-strength, kind="stable")]
    matter = tuple(j for j in order if strength[j] - interval[j] > bound)
    rest = tuple(j for j in order if strength[j] + interval[j] < bound)
    return Ranking(by, matter, tuple(j for j in order if j not in matter and j not in rest), rest, tuple(strength.tolist()))


def _decades(curve: Curve) -> float:
    good = curve.figures[np.isfinite(curve.figures)]
    return float(np.log10(good.max() / good.min())) if good.size and good.min() > 0.0 else 0.0


def verdict(study: Study) -> tuple[str, ...]:
    """Return the study in sentences."""
    return (*_groups(study), *_pairs(study), *_first(study), *_doubts(study))


def _names(study: Study, which: tuple[int, ...], figures: tuple[float, ...] = ()) -> str:
    short = [study.space.numbers[j].short for j in which]
    return ", ".join(f"{name} ({figures[j]:.2g})" if figures else name for j, name in zip(which, short, strict=True))


def _groups(study: Study) -> Iterator[str]:
    found = ranking(study)
    if found is None:
        return
    if found.matter:
        yield f"These matter, by {found.by}: {_names(study, found.matter, found.strength)}."
    else:
        yield f"By {found.by} no number stands out."
    if found.open:
        yield f"In between, as far as can be told: {_names(study, found.open, found.strength)}."
    if found.rest:
        where = "near their present values" if found.by == LOCAL else "within their bounds"
        yield f"These do not matter {where}: {_names(study, found.rest)}."


def _pairs(study: Study) -> Iterator[str]:
    sobol, numbers = study.sobol, study.space.numbers
    said = False
    if sobol is not None:
        beyond = sobol.total - sobol.first
        clear = beyond - np.hypot(sobol.total_interval, sobol.first_interval) > TOGETHER
        if clear.any():
            said = True
            who = ", ".join(f"{numbers[j].short} ({beyond[j]:.2g})" for j in np.flatnonzero(clear))
            yield f"These act together with others, by total less first index: {who}; calibrating one moves the best value of another."
        if sobol.second is not None and sobol.second_interval is not None:
            sure = np.nan_to_num(sobol.second - sobol.second_interval) > SMALL / 2.0
            for j, k in np.argwhere(sure):
                said = True
                yield f"{numbers[j].short} and {numbers[k].short} explain {100.0 * sobol.second[j, k]:.0f} % of the variance as a pair."
    if study.local is not None:
        matrix, apart = study.local.interactions, study.local.interactions_apart
        pairs = [(j, k) for j, k in combinations(range(len(numbers)), 2) if abs(matrix[j, k]) > TOGETHER + 2.0 * apart[j, k]]
        pairs.sort(key=lambda pair: -abs(matrix[pair]))
        if pairs:
            said = True
            top = ", ".join(f"{numbers[j].short} with {numbers[k].short} ({matrix[j, k]:+.2g})" for j, k in pairs[:4])
            more = f" and {len(pairs) - 4} pairs more" if len(pairs) > 4 else ""
            yield f"Near the present values the largest interactions are {top}{more}."
        elif any(apart[j, k] > TOGETHER for j, k in combinations(range(len(numbers)), 2)):
            said = True
            yield "Near the present values second differences change with their step: counts, friction or a corner hide any interaction."
    if not said and len(numbers) > 1 and (sobol is not None or study.local is not None):
        yield "No two numbers were seen to act together beyond what each does by itself: they can be calibrated one by one."


def _first(study: Study) -> Iterator[str]:
    """What to calibrate first: the number that alone lowers the figure most."""
    if study.curves is None:
        return
    gains = [(curve.minimum.figure / study.figure, curve) for curve in study.curves if curve.minimum is not None]
    gains.sort(key=lambda gain: gain[0])
    worth = [(part, curve) for part, curve in gains if part < 1.0 - WORTHWHILE]
    if not worth:
        yield f"No number by itself lowers the figure by {100.0 * WORTHWHILE:.0f} % or more: what is left is in several at once."
        return
    told = []
    for part, curve in worth[:3]:
        minimum, number = curve.minimum, curve.number
        assert minimum is not None
        beyond = ", where the bound is: it may be lower beyond" if minimum.bound else ""
        at = f"{number.display_value(minimum.value):.4g} {number.display_unit}".rstrip()
        told.append(f"{number.short} (at {at}{beyond}: {part:.2g} of it)")
    yield f"Calibrate first what alone lowers the figure most: {'; '.join(told)}."


def _doubts(study: Study) -> Iterator[str]:
    sobol = study.sobol
    if sobol is not None and sobol.total_interval.max() > WIDE:
        wide = float(sobol.total_interval.max())
        yield f"The widest interval is +-{wide:.2g}: closer numbers are not in order; --base {2 * study.plan.base} halves its square."
    for name, found in (("Morris", study.morris_outcome), ("Sobol", study.sobol_outcome)):
        if found is not None and found.failed:
            share = f"{100.0 * found.share:.2g} % ({found.failed} of {len(found.values)})"
            yield f"Of the runs for {name} {share} failed; each counts as the worst that any run counts as."
    if study.local is not None:
        shaky = [one for one in study.local.slopes if one.remark]
        if shaky:
            yield f"Local sensitivities with a remark: {', '.join(one.number.short for one in shaky)}."
