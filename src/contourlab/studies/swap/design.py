"""Designs that variants share: base numbers for all of them, local ones for each, searched together."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ParameterError
from contourlab.studies.space import Found, search
from contourlab.studies.swap.division import Division
from contourlab.studies.swap.fleet import BROKEN, Fleet
from contourlab.studies.swap.loss import losses

__all__ = [
    "Choice",
    "Design",
    "Own",
    "afresh",
    "best_of_its_own",
    "evaluated",
    "on_from",
    "shared",
    "shortfalls",
    "starts_around",
    "within",
]

Array = NDArray[np.float64]
Objective = Callable[[Array], Array]
POPULATION = 16
"""Candidates of a generation and start, to begin with. The count of an encoder makes figures rough at the end: each time a search comes to
rest, the next one has generations twice as large (restarts of Auger & Hansen, CEC 2005)."""
POLISH, POLISHED, STEPS = 0.6, 2, (0.05, 0.01)
"""Part of a budget that goes into searching on around so many of the best starts, and its first steps in parts of the box: the last one is
taken as long as the budget lasts. Where gains make up for each other the best designs lie along narrow, bent valleys, past which longer
steps go."""
EVENNESS = 0.01
"""Weight of the mean loss beside the largest one: of two designs that are equal for the worst variant, the others decide."""


@dataclass(frozen=True, eq=False)
class Own:
    """The best design of one variant alone.

    Attributes
    ----------
    point : ndarray (n_number,)
    value : float
        J.
    per_start : ndarray (n_start,)
        J that each start came to; infinite where it found nothing that keeps the guards.
    runs : int
    on : ndarray (n_on, 2)
        J from which further searches for the variant alone went on, J* as another search had found it, and what each came to.
    afresh : float
        J of a second search for the variant alone, from around J* but not from there; infinite where nothing it tried keeps the guards, nan
        where none was made.
    """

    point: Array
    value: float
    per_start: Array
    runs: int
    on: Array = field(default_factory=lambda: np.zeros((0, 2)))
    afresh: float = math.nan

    @property
    def by_itself(self) -> float:
        """The best that a search for the variant alone came to, without being shown where J* stands."""
        return float(np.fmin(self.value, self.afresh))

    @property
    def reached(self) -> float:
        """The best that any search for the variant alone came to."""
        return min(float(self.on[-1, 1]), self.by_itself) if len(self.on) else self.by_itself

    @property
    def fell(self) -> float:
        """By how much the last one that went on lowered J*; 0 where none did."""
        return float(self.on[-1, 0] - self.on[-1, 1]) if len(self.on) else 0.0


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


def starts_around(start: Array, number: int, seed: int, distance: float = 0.15) -> Array:
    """Return starts (number, n): a point, and others at a distance from it that is normal with a standard deviation in parts of the box."""
    generator = np.random.default_rng([seed, number])
    return np.clip(start + np.vstack([np.zeros(start.size), distance * generator.standard_normal((number - 1, start.size))]), 0.0, 1.0)


def best_of_its_own(fleet: Fleet, i: int, *, budget: int, seed: int, starts: Array, spread: float = 0.2) -> Own:
    """Search the best design of one variant.

    Raises
    ------
    ParameterError
        If nothing that was tried keeps the guards.
    """
    found = _thorough(fleet.own(i), starts, budget, seed, spread)
    if found.value >= BROKEN:
        raise ParameterError(
            "guards", fleet.variants[i].name, "kept by some design within the bounds: ask for smaller margins, or give wider bounds"
        )
    return Own(
        found.point, found.value * fleet.floor, np.where(found.per_start < BROKEN, found.per_start * fleet.floor, np.inf), found.runs
    )


def on_from(fleet: Fleet, i: int, own: Own, *, budget: int, seed: int) -> Own:
    """Search on for one variant alone, in small steps from where its J* stands, whichever search came there."""
    before = float(fleet.best[i])
    found = _polished(fleet.own(i), fleet.best_points[[i]], max(budget, 2 * POPULATION), seed)
    assert found is not None  # the budget is enough for a generation
    after = float(fleet.best[i])
    return replace(own, point=fleet.best_points[i], runs=own.runs + found.runs, on=np.vstack([own.on, [before, after]]))


def afresh(fleet: Fleet, i: int, own: Own, *, budget: int, seed: int) -> Own:
    """Search for one variant alone once more, from around where its J* stands: whether a search finds there that is not shown the place."""
    starts = starts_around(fleet.best_points[i], len(own.per_start) + 1, seed)[1:]
    try:
        found = best_of_its_own(fleet, i, budget=budget, seed=seed, starts=starts)
    except ParameterError:  # nothing that was tried keeps the guards
        return replace(own, afresh=math.inf, runs=own.runs + budget)
    return replace(own, afresh=found.value, runs=own.runs + found.runs)


def shortfalls(fleet: Fleet, owns: Sequence[Own], *, by_themselves: bool) -> Array:
    """Return by how much J* may be too large (n_variant,), counted as a loss.

    That is how far the searches for a variant alone ended above what another one found, or what the last of them still took off; those that
    were shown where J* stood count unless they have to have come there `by_themselves`.
    """
    above = losses([own.by_itself if by_themselves else own.reached for own in owns], fleet.best, fleet.floor)
    return np.maximum(above, np.array([own.fell for own in owns]) / np.maximum(fleet.best, fleet.floor))


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
        first = _polished(objective, np.array([division.gathered(points) for points in near]), budget // 2, seed + 7, spread)
    found = _thorough(objective, rows, budget - (first.runs if first is not None else 0), seed, spread)
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
    found = _polished(objective, rows, max(budget - len(starts), 2 * POPULATION), seed, limit=limit / (1.0 + EVENNESS))
    assert found is not None  # the budget is enough for a generation
    return _found(fleet, division, replace(found, runs=found.runs + len(starts)))


def _found(fleet: Fleet, division: Division, found: Found) -> Design:
    points = division.spread(found.point[None])[:, 0]
    return _design(fleet, division.local, points, np.where(found.per_start < BROKEN, found.per_start, np.inf), found.runs)


def _thorough(objective: Objective, starts: Array, budget: int, seed: int, spread: float = 0.2) -> Found:
    """Search from all starts, then again and again around the best of what they came to."""
    found = search(objective, starts, budget=max(int((1.0 - POLISH) * budget), 1), seed=seed, spread=spread, population=POPULATION)
    ranked = np.argsort(found.per_start, kind="stable")[:POLISHED]
    more = _polished(objective, found.points[ranked], budget - found.runs, seed, spread)
    return found if more is None else replace(found, point=more.point, value=more.value, runs=found.runs + more.runs)


def _polished(objective: Objective, starts: Array, budget: int, seed: int, spread: float = 0.2, limit: float = -math.inf) -> Found | None:
    """Search on around some points in small steps, with ever larger generations, until the budget is spent; None where it is too small."""
    found, size, turn = None, POPULATION, 0
    while budget > len(starts) * (size + 1) and (found is None or found.value > limit):
        step = min(spread, STEPS[min(turn, len(STEPS) - 1)])
        more = search(objective, starts, budget=budget, seed=seed + 1000 * size, spread=step, population=size, target=limit)
        budget -= more.runs
        starts, size, turn = more.point[None], 2 * size, turn + 1
        found = more if found is None else replace(more, runs=found.runs + more.runs)
    return found


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
