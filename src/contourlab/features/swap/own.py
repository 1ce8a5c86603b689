"""The best design of one variant alone: its J*, and how far that is to be trusted."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ParameterError
from contourlab.features.swap.fleet import BROKEN, Fleet
from contourlab.features.swap.loss import losses
from contourlab.features.swap.thorough import POPULATION, polished, thorough

Array = NDArray[np.float64]


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
    found = thorough(fleet.own(i), starts, budget, seed, spread)
    if found.value >= BROKEN:
        raise ParameterError(
            "guards", fleet.variants[i].name, "kept by some design within the bounds: ask for smaller margins, or give wider bounds"
        )
    return Own(
        found.point, found.value * fleet.floor, np.where(found.per_start < BROKEN, found.per_start * fleet.floor, np.inf), found.runs
    )


def on_from(fleet: Fleet, i: int, own: Own, *, budget: int, seed: int) -> Own:
    """Search on for variant `i` alone, in small steps from where its J* stands, whichever search came there; a generation at least."""
    before = float(fleet.best[i])
    found = polished(fleet.own(i), fleet.best_points[[i]], max(budget, 2 * POPULATION), seed)
    assert found is not None  # the budget is enough for a generation
    after = float(fleet.best[i])
    return replace(own, point=fleet.best_points[i], runs=own.runs + found.runs, on=np.vstack([own.on, [before, after]]))


def afresh(fleet: Fleet, i: int, own: Own, *, budget: int, seed: int) -> Own:
    """Search for variant `i` alone once more, from around where its J* stands: whether a search finds there that is not shown the place."""
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
