"""A start that crosses a bound: the one number whose change restores the margins at the least error, axis by axis."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from contourlab.design import DesignVariable, Space
from contourlab.design.guards import Guards
from contourlab.features.tune.line import Step
from contourlab.features.tune.objective import Objective

Array = NDArray[np.float64]
LANES = 64


def repaired(objective: Objective, guards: Guards, space: Space, values: Mapping[str, float]) -> tuple[dict[str, float], tuple[Step, ...]]:
    """Return values [SI] that keep the margins, and the steps that led there; no step where they are kept already.

    Parameters
    ----------
    objective : Objective
    guards : Guards
    space : Space
        Numbers that may be changed, each in its range.
    values : mapping of str to float [SI]
        Where it starts.

    Notes
    -----
    Where no single number of an axis restores its margins, the one that comes nearest is changed and the next is looked for. Margins may
    still be crossed in the end: then the ranges do not hold what is asked for.
    """
    now, steps = dict(values), list[Step]()
    for axis in guards.axes:
        mine = [number for number in space.numbers if axis in guards.concerned(number.name)]
        for _ in mine:
            one = {name: np.array([value]) for name, value in now.items()}
            short = guards.missing(guards.loops(one, (axis,))[0])[0]
            if short <= 0.0:
                break
            tried = [_tried(objective, guards, axis, number, now) for number in mine]
            short_after, _, _, step = min(tried, key=lambda found: found[:3])
            if not short_after < short:
                break
            now[step.number.name] = step.after
            steps.append(step)
    return now, tuple(steps)


def _tried(
    objective: Objective, guards: Guards, axis: str, number: DesignVariable, now: Mapping[str, float]
) -> tuple[float, float, float, Step]:
    """Return how far margins fall short at the best value of one number, the objective there, how far it is, and the step."""
    own = now[number.name]
    values = np.unique(np.append(number.physical(np.linspace(0.0, 1.0, LANES - 1)), own))
    columns = {name: np.full(values.size, value) for name, value in now.items()} | {number.name: values}
    judged = objective(columns)
    short = np.array([guards.missing(loops)[0] for loops in guards.loops(columns, (axis,))])
    # Where another axis runs away yet, no run tells anything: margins are restored by the smallest change.
    fine = np.isfinite(judged.value) if np.isfinite(judged.value).any() else np.ones(values.size, dtype=bool)
    shortest = float(short[fine].min(initial=math.inf))
    far = np.abs(number.normalise(values) - number.normalise(own))
    at = int(np.lexsort((far, judged.value, ~(fine & (short <= shortest))))[0])
    here, reached = int(np.flatnonzero(values == own)[0]), float(judged.value[at])
    barred = "margins" if bool((judged.value[fine & (short > shortest)] < reached).any()) else ""
    bound = "; ".join(filter(None, (barred, number.end(float(values[at])))))
    step = Step("repair", number, own, float(values[at]), float(judged.value[here]), reached, bound, values, judged.value, short <= 0.0)
    return shortest, reached, float(far[at]), step
