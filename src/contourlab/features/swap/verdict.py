"""The verdict on a swap, in words."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from contourlab.features.swap.design import Choice
from contourlab.features.swap.fleet import OBJECTIVES
from contourlab.features.swap.study import SwapStudy


def verdict(study: SwapStudy) -> str:
    """Return the verdict in one sentence."""
    limit, base, best = f"{100.0 * study.settings.full:g} %", study.base, study.recommended
    if best is not None and study.fell_short:
        names, stands = " and ".join(study.fell_short), _percent(base.loss)
        return (
            f"not told: the searches for {names} alone did not come within {limit} of what others found, so that J* may lie lower: raise "
            f"--budget, or give known designs by --from; against J* as it stands the swap loss is {stands} with nothing local"
        )
    if study.full:
        return f"full modularity: one controller serves all variants, swap loss {_percent(base.loss)} with nothing local (limit {limit})"
    if best is None:
        least = min(study.choices, key=lambda choice: choice.loss)
        which = f"with {least.name} local" if least.effort else "with nothing local"
        found = f"the least is {at_least(study, least.loss)}{_percent(least.loss)}, {which}"
        return f"not modular: no choice of local numbers that was tried brings the swap loss under {limit}; {found}"
    how = "found by dropping one number after another, not by trying all sets"
    if study.settings.exhaustive:
        how = "all smaller sets were tried"
    elif study.settings.local is not None:
        how = "of the sets that were asked for"
    several = "s" if best.effort > 1 else ""
    return (
        f"modular with {best.effort} local number{several}: {_listed(study, best)}; swap loss {_percent(best.loss)} in place of "
        f"{_percent(base.loss)} with nothing local (limit {limit}; {how})"
    )


def at_least(study: SwapStudy, loss: float) -> str:
    """Return what stands before a loss: it is no more than a lower bound where J* was still falling."""
    return "at least " if study.fell_short and math.isfinite(loss) else ""


def _listed(study: SwapStudy, choice: Choice) -> str:
    return ", ".join(number.short for number in study.fleet.space.numbers if number.name in choice.design.local)


def search_words(study: SwapStudy) -> Iterator[str]:
    """Yield what has to be known of the searches: definition, bounds, budget, spread."""
    fleet, settings = study.fleet, study.settings
    scale, shown = 1e6, {"m*s": "um s", "m": "um"}[OBJECTIVES[fleet.objective][0]]
    yield (
        f"swap loss = max over variants of (J - J*)/max(J*, J_tol), J = {fleet.objective.replace('_', ' ')}, "
        f"J_tol = {fleet.floor * scale:g} {shown}; J* = best value of any search of this run"
    )
    yield f"guards on every axis: {fleet.bounds.words}"
    for name, why in {name: why for keeper in fleet.keepers for name, why in keeper.unknown.items()}.items():
        yield f"margins of axis {name} were not looked at: {why}"
    yield (
        f"{fleet.runs} runs; {settings.budget} candidates a search (twice for the shared design, up to half for a set that is tried, "
        f"a quarter to go on from J*, a whole one where it is searched once more) from {len(study.owns[0].per_start)} starts, "
        f"seed {settings.seed}; "
        "shared designs make the largest loss small, then the mean"
    )
    for variant, own in zip(fleet.variants, study.owns, strict=True):
        good = own.per_start[np.isfinite(own.per_start)] * scale
        span = f"{good.min():.3g} to {good.max():.3g} {shown}" if good.size else "nothing"
        on = "".join(f"; on from {before * scale:.3g} of another search to {after * scale:.3g}" for before, after in own.on[:1].tolist())
        on += "".join(f", then to {after * scale:.3g}" for _, after in own.on[1:].tolist())
        on += "" if math.isnan(own.afresh) else f"; once more by itself to {own.afresh * scale:.3g}"
        yield f"{variant.name}: its starts came to {span}, then {own.value * scale:.3g} {shown} around the best of them{on}"
    each = study.base.design.per_start
    came = ", ".join(f"{100.0 * loss:.3g} %" for loss in each if math.isfinite(loss)) or "nothing that keeps the guards"
    lost = int(np.count_nonzero(~np.isfinite(each)))
    also = f" ({lost} of {len(each)} to nothing that does)" if 0 < lost < len(each) else ""
    last = at_least(study, study.base.loss) + _percent(study.base.loss)
    yield f"nothing local: the starts of its search came to {came}{also} against J* as it stood then; in the end {last}"


def on_bounds(study: SwapStudy, choice: Choice) -> list[str]:
    """Return the numbers of a design that stand on a bound, where a wider one might do better."""
    found = []
    for j, number in enumerate(study.fleet.space.numbers):
        values = number.physical(choice.design.points[:, j])
        ends = [value for value in values.tolist() if number.cramped(value)]
        for bound in dict.fromkeys(number.low if value - number.low < number.high - value else number.high for value in ends):
            found.append(f"{number.short} at {number.shown(bound):.4g} {number.written_in}".rstrip())
    return found


def _percent(loss: float) -> str:
    return f"{100.0 * loss:.3g} %" if math.isfinite(loss) else "without bound (no design keeps the guards on all variants)"
