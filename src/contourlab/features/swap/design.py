"""Designs that variants share: base numbers for all of them, local ones for each, searched together."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from contourlab.design import Found
from contourlab.features.swap.division import Division
from contourlab.features.swap.fleet import BROKEN, Fleet
from contourlab.features.swap.loss import losses
from contourlab.features.swap.thorough import POPULATION, polished, thorough

Array = NDArray[np.float64]
Objective = Callable[[Array], Array]
EVENNESS = 0.01
"""Weight of the mean loss beside the largest one: of two designs that are equal for the worst variant, the others decide."""


@dataclass(frozen=True, eq=False)
class Design:
    """A shared design.

    Attributes
    ----------
    local : frozenset of str
        Numbers that each variant has its own value of.
    points : ndarray (n_variant, n_number)
        What each variant runs with; equal but for the local numbers.
    values : ndarray (n_variant,)
        J of each.
    per_start : ndarray (n_start,)
        Swap loss that each start came to, against J* as it was known then.
    runs : int
        Candidates that were tried, each on all variants.
    """

    local: frozenset[str]
    points: Array
    values: Array
    per_start: Array
    runs: int

    @property
    def holds(self) -> bool:
        """Whether it keeps the guards on all variants."""
        return bool(np.isfinite(self.values).all())


@dataclass(frozen=True, eq=False)
class Choice:
    """A choice of local numbers and what it leaves.

    Attributes
    ----------
    name : str
        In words.
    design : Design
    losses : ndarray (n_variant,)
    """

    name: str
    design: Design
    losses: Array

    @property
    def loss(self) -> float:
        """The swap loss."""
        return float(self.losses.max())

    @property
    def effort(self) -> int:
        """How many numbers are local."""
        return len(self.design.local)


def shared(
    fleet: Fleet,
    local: frozenset[str],
    starts: Sequence[Array],
    *,
    budget: int,
    seed: int,
    spread: float = 0.2,
    near: Sequence[Array] = (),
    most: int | None = None,
) -> Design:
    """Search the shared design with the least swap loss.

    Parameters
    ----------
    fleet : Fleet
        With J* of all variants.
    local : frozenset of str
    starts : sequence of ndarray (n_variant, n_number)
        Designs to start from; what they have in the way of base numbers is averaged.
    budget : int
        Candidates; each is run on all variants.
    seed : int
    spread : float
        First step of the search, in parts of the box.
    near : sequence of ndarray (n_variant, n_number)
        Designs near which a good one may be: half of the budget goes on around them, in small steps.
    most : int, optional
        How many of the starts are taken, the best ones; by default all.
    """
    division = Division(fleet.space, fleet.variants, local)
    objective, rows = _objective(fleet, division.spread), np.array([division.gathered(points) for points in starts])
    if most is not None and len(rows) > most:
        rows = rows[np.argsort(objective(rows), kind="stable")[:most]]
    first = None
    if near:
        first = polished(objective, np.array([division.gathered(points) for points in near]), budget // 2, seed + 7, spread)
    found = thorough(objective, rows, budget - (first.runs if first is not None else 0), seed, spread)
    if first is not None:
        best = first if first.value < found.value else found
        found = replace(found, point=best.point, value=best.value, runs=found.runs + first.runs)
    return _found(fleet, division, found)


def within(fleet: Fleet, local: frozenset[str], starts: Sequence[Array], *, budget: int, seed: int, limit: float = -math.inf) -> Design:
    """Search on around the best of some designs, until one loses less than a limit.

    Parameters
    ----------
    fleet, local, starts, budget, seed
        As of `shared`.
    limit : float
        Swap loss that is good enough, against J* as it is known at the beginning; by default all of the budget is spent.
    """
    division = Division(fleet.space, fleet.variants, local)
    objective, rows = _objective(fleet, division.spread), np.array([division.gathered(points) for points in starts])
    rows = rows[[int(np.argmin(objective(rows)))]]
    found = polished(objective, rows, max(budget - len(starts), 2 * POPULATION), seed, limit=limit / (1.0 + EVENNESS))
    assert found is not None  # the budget is enough for a generation
    return _found(fleet, division, replace(found, runs=found.runs + len(starts)))


def _found(fleet: Fleet, division: Division, found: Found) -> Design:
    points = division.spread(found.point[None])[:, 0]
    return _design(fleet, division.local, points, np.where(found.per_start < BROKEN, found.per_start, np.inf), found.runs)


def evaluated(fleet: Fleet, local: frozenset[str], points: Array) -> Design:
    """Return a design as it is, one point a variant."""
    return _design(fleet, local, points, np.zeros(0), 0)


def _design(fleet: Fleet, local: frozenset[str], points: Array, per_start: Array, runs: int) -> Design:
    values, broken = fleet.values(points[:, None, :])
    return Design(local, points, np.where(broken[:, 0] > 0.0, np.inf, values[:, 0]), per_start, runs)


def _objective(fleet: Fleet, spread: Objective) -> Objective:
    best = fleet.best.copy()  # J* as it is known now: a target that moves would rank candidates of one generation by different rules

    def objective(rows: Array) -> Array:
        values, broken = fleet.values(spread(rows))
        lost = losses(np.where(np.isfinite(values), values, 0.0).T, best, fleet.floor)
        whole = (lost.max(axis=1) + EVENNESS * lost.mean(axis=1)) / (1.0 + EVENNESS)
        return np.asarray(np.where((broken > 0.0).any(axis=0), BROKEN * (1.0 + broken.sum(axis=0)), whole))

    return objective
