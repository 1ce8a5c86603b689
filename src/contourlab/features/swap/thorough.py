"""A search that goes on in ever smaller steps and ever larger generations until its budget is spent."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from contourlab.design import Found, search

Array = NDArray[np.float64]
Objective = Callable[[Array], Array]
POPULATION = 16
"""Candidates of a generation and start, to begin with. The count of an encoder makes figures rough at the end: each time a search comes to
rest, the next one has generations twice as large (restarts of Auger & Hansen, CEC 2005)."""
POLISH, POLISHED, STEPS = 0.6, 2, (0.05, 0.01)
"""Part of a budget that goes into searching on around so many of the best starts, and its first steps in parts of the box: the last one is
taken as long as the budget lasts. Where gains make up for each other the best designs lie along narrow, bent valleys, past which longer
steps go."""


def thorough(objective: Objective, starts: Array, budget: int, seed: int, spread: float = 0.2) -> Found:
    """Search from all starts (n_start, n), in places from 0 to 1, then again and again around the best of what they came to.

    `budget` candidates in all; `spread` is the first step, in parts of the box. See `contourlab.design.search`.
    """
    found = search(objective, starts, budget=max(int((1.0 - POLISH) * budget), 1), seed=seed, spread=spread, population=POPULATION)
    ranked = np.argsort(found.per_start, kind="stable")[:POLISHED]
    more = polished(objective, found.points[ranked], budget - found.runs, seed, spread)
    return found if more is None else replace(found, point=more.point, value=more.value, runs=found.runs + more.runs)


def polished(objective: Objective, starts: Array, budget: int, seed: int, spread: float = 0.2, limit: float = -math.inf) -> Found | None:
    """Search on around some points (n_start, n) in small steps, with ever larger generations, until the budget is spent.

    It ends before where a value comes to `limit`. None where the budget is too small for a generation.
    """
    found, size, turn = None, POPULATION, 0
    while budget > len(starts) * (size + 1) and (found is None or found.value > limit):
        step = min(spread, STEPS[min(turn, len(STEPS) - 1)])
        more = search(objective, starts, budget=budget, seed=seed + 1000 * size, spread=step, population=size, target=limit)
        budget -= more.runs
        starts, size, turn = more.point[None], 2 * size, turn + 1
        found = more if found is None else replace(more, runs=found.runs + more.runs)
    return found
