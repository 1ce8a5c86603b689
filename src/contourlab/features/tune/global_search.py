"""All parameters at once: covariance matrix adaptation from several starts, with the same guards as the line search."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array
from contourlab.features.tune.objective import Objective
from contourlab.study import Found, Space, search
from contourlab.study.guards import Guards

POPULATION = 32
KEPT = 8
"""Number of points per generation that must keep the margins: the best points are checked in turn until it is reached."""


@dataclass(frozen=True, eq=False)
class GlobalResult:
    """The result of the global search.

    Attributes
    ----------
    values : dict of str to float [SI] or None
        The best values that keep all bounds in the exact analysis; None if no start led to any.
    objective : float
        nan if `values` is None.
    """

    values: dict[str, float] | None
    objective: float
    search: Found


def global_search(
    objective: Objective,
    guards: Guards,
    space: Space,
    given: Sequence[Mapping[str, float]],
    *,
    starts: int = 5,
    budget: int = 6000,
    seed: int = 0,
    progress: Callable[[int, int], None] | None = None,
) -> GlobalResult:
    """Search all parameters at once.

    Parameters
    ----------
    given : sequence of mapping of str to float [SI]
        Known starts; the others are drawn from the middle half of the box.
    starts : int, >= 1
        Total number of starts.
    budget : int
        Total number of runs.
    seed : int
        Seed of the drawn starts and the search; the same seed gives the same result.
    progress : callable, optional
        Called with the number of runs done and in all.

    Notes
    -----
    Margins take longer to compute than a run. Each generation therefore checks its best points in turn until `KEPT` of them keep the
    bounds. A point that breaks a bound is ranked behind all others of its generation. The exact analysis checks the result. Ctrl-C ends
    the search with the best values so far.
    """
    generator = np.random.default_rng(seed)
    known = [space.points(values)[0] for values in given][:starts]
    drawn = 0.25 + 0.5 * generator.random((starts - len(known), len(space.numbers)))
    fixed = {name: value for name, value in given[0].items() if name not in space.names}
    found = search(
        _Ranked(objective, guards, space, fixed),
        np.vstack([*known, drawn]) if known else drawn,
        budget=budget,
        seed=seed,
        population=POPULATION,
        progress=None if progress is None else lambda done: progress(done, budget),
        stoppable=True,
    )
    for i in np.argsort(found.per_start, kind="stable"):
        if not np.isfinite(found.per_start[i]):
            break
        values = fixed | space.values(found.points[i])
        run = objective.at(values)
        if not run.violations(values, guards):
            return GlobalResult(values, float(run.value[0]), found)
    return GlobalResult(None, float("nan"), found)


class _Ranked:
    """The objective of points; points that break a bound rank behind the others."""

    def __init__(self, objective: Objective, guards: Guards, space: Space, fixed: Mapping[str, float]) -> None:
        self.objective, self.guards, self.space, self.fixed = objective, guards, space, fixed
        self.axes = tuple(dict.fromkeys(axis for name in space.names for axis in guards.concerned(name)))

    def __call__(self, points: Array) -> Array:
        columns = self.space.columns(points)
        columns |= {name: np.full(len(points), value) for name, value in self.fixed.items()}
        runs = self.objective(columns)
        bounds = self.guards.bounds
        excess = np.maximum(runs.limited - bounds.limited, 0.0)
        if np.isfinite(bounds.command):
            excess = excess + np.maximum(runs.largest / bounds.command - 1.0, 0.0)
        excess = np.where(np.isfinite(excess), excess, np.inf)
        ranked = runs.value.copy()
        for first in range(0, len(points), POPULATION):
            part = slice(first, first + POPULATION)
            ranked[part] = self._generation(ranked[part], excess[part], {name: column[part] for name, column in columns.items()})
        return ranked

    def _generation(self, values: Array, excess: Array, columns: Mapping[str, Array]) -> Array:
        """Return the ranked values of one generation of one start; points that break a bound rank behind the others."""
        good = np.isfinite(values)
        if not good.any():
            return values
        worst = float(values[good].max())
        ranked = np.where(excess > 0.0, worst * (2.0 + excess), values)
        order = [i for i in np.argsort(ranked, kind="stable").tolist() if good[i] and excess[i] <= 0.0]
        loops = self.guards.loops(columns, self.axes)
        kept = 0
        for i in order:
            missing, _ = self.guards.missing(loops[i])
            if missing > 0.0:
                ranked[i] = worst * (2.0 + missing)
            else:
                kept += 1
                if kept == KEPT:
                    break
        return ranked
