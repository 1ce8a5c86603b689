"""The global search beside the sequential procedure: five starts, with the same guards."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.design import Found, Space, search
from contourlab.design.guards import Guards
from contourlab.features.tune.objective import Objective

Array = NDArray[np.float64]
POPULATION = 32
CHECKED = 8
"""So many of a generation's best have their margins looked at and kept: these lead the search."""


@dataclass(frozen=True, eq=False)
class Searched:
    """What the global search found.

    Attributes
    ----------
    values : dict of str to float [SI] or None
        The best that keeps all bounds by the exact analysis; None where no start came to one.
    value : float
        Its objective.
    found : Found
        Of each start, and the course.
    """

    values: dict[str, float] | None
    value: float
    found: Found


def globally(
    objective: Objective,
    guards: Guards,
    space: Space,
    given: Sequence[Mapping[str, float]],
    *,
    starts: int = 5,
    budget: int = 6000,
    seed: int = 0,
    tell: Callable[[int, int], None] | None = None,
) -> Searched:
    """Search all numbers at once, by covariance matrix adaptation from several starts.

    Parameters
    ----------
    objective : Objective
    guards : Guards
    space : Space
    given : sequence of mapping of str to float [SI]
        Starts that are known; the others are drawn over the middle half of the box.
    starts : int, >= 1
        How many in all.
    budget : int
        Runs in all.
    seed : int
        Of the draw and the search: the same seed gives the same answer.
    tell : callable, optional
        Told runs done and runs in all.

    Notes
    -----
    Margins take longer than a run, so of each generation the best are looked at in turn, until `CHECKED` of them keep the bounds; one that
    does not is put behind all others of its generation. What is returned is held against the exact analysis.
    """
    generator = np.random.default_rng(seed)
    known = [space.points(values)[0] for values in given][:starts]
    drawn = 0.25 + 0.5 * generator.random((starts - len(known), len(space.numbers)))
    fixed = {name: value for name, value in given[0].items() if name not in space.names}
    judge = _Judge(objective, guards, space, fixed)
    found = search(
        judge,
        np.vstack([*known, drawn]) if known else drawn,
        budget=budget,
        seed=seed,
        population=POPULATION,
        progress=None if tell is None else lambda done: tell(done, budget),
    )
    for i in np.argsort(found.per_start, kind="stable"):
        values = fixed | space.values(found.points[i])
        if not np.isfinite(found.per_start[i]):
            break
        judged = objective({name: np.array([value]) for name, value in values.items()})
        if not guards.broken(values, float(judged.limited[0]), float(judged.largest[0])):
            return Searched(values, float(judged.value[0]), found)
    return Searched(None, float("nan"), found)


class _Judge:
    """The objective of points, with what crosses a bound put behind the rest."""

    def __init__(self, objective: Objective, guards: Guards, space: Space, fixed: Mapping[str, float]) -> None:
        self.objective, self.guards, self.space, self.fixed = objective, guards, space, fixed
        self.axes = tuple(dict.fromkeys(axis for name in space.names for axis in guards.concerned(name)))

    def __call__(self, points: Array) -> Array:
        columns = self.space.columns(points)
        columns |= {name: np.full(len(points), value) for name, value in self.fixed.items()}
        judged = self.objective(columns)
        bounds = self.guards.bounds
        beyond = np.maximum(judged.limited - bounds.limited, 0.0)
        if np.isfinite(bounds.command):
            beyond = beyond + np.maximum(judged.largest / bounds.command - 1.0, 0.0)
        values = judged.value.copy()
        for first in range(0, len(points), POPULATION):
            part = slice(first, first + POPULATION)
            values[part] = self._ranked(values[part], np.where(np.isfinite(beyond[part]), beyond[part], np.inf), columns, part)
        return values

    def _ranked(self, values: Array, beyond: Array, columns: Mapping[str, Array], part: slice) -> Array:
        """Return the values of a generation of one start, those that cross a bound behind the others."""
        good = np.isfinite(values)
        if not good.any():
            return values
        worst = float(values[good].max())
        ranked = np.where(beyond > 0.0, worst * (2.0 + beyond), values)
        order = [i for i in np.argsort(ranked, kind="stable").tolist() if good[i] and beyond[i] <= 0.0]
        loops = self.guards.loops({name: column[part] for name, column in columns.items()}, self.axes)
        kept = 0
        for i in order:
            short, _ = self.guards.missing(loops[i])
            if short > 0.0:
                ranked[i] = worst * (2.0 + short)
            else:
                kept += 1
                if kept == CHECKED:
                    break
        return ranked
