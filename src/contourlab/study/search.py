"""Global search in a box, many points at a time: CMA-ES (covariance matrix adaptation) from several starts in parallel."""

from __future__ import annotations

import math
import sys
import threading
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ParameterError, refuse
from contourlab.loop.batch import LANES

Objective = Callable[[Array], Array]
SPREAD = 0.2
"""Initial standard deviation, as a share of the box."""

EXPLORED, POPULATION = 0.4, 16
"""Share of the budget before the first restart, and size of the first generations for each start."""
RESTARTS = (0.05, 0.01)
"""First step of the restarts. Gains compensate each other, so the optima lie along narrow, curved valleys: long steps overshoot them."""


@dataclass(frozen=True, eq=False)
class Found:
    """The result of a search.

    Attributes
    ----------
    point : ndarray (n,)
        The best point, from 0 to 1 in each direction.
    value : float
        Its value.
    per_start : ndarray (n_start,)
        The best value from each start.
    points : ndarray (n_start, n)
        The point of each of these values.
    runs : int
        Number of points tried.
    course : ndarray (n_generation, 2)
        Number of points tried and best value, after each generation.
    interrupted : bool
        Whether Ctrl-C ended the search.
    """

    point: Array
    value: float
    per_start: Array
    points: Array
    runs: int
    course: Array
    interrupted: bool = field(default=False, metadata={"json": False})


def search(
    objective: Objective,
    starts: Array,
    *,
    budget: int,
    seed: int = 0,
    population: int = 32,
    spread: float = SPREAD,
    tolerance: float = 1e-3,
    target: float = -math.inf,
    progress: Callable[[int], None] = lambda tried: None,
    stoppable: bool = False,
) -> Found:
    """Minimise an objective in the box from 0 to 1.

    Parameters
    ----------
    objective : callable
        Returns the values (n,) of points (n, n_number); a value that is not finite counts as the worst.
    starts : ndarray (n_start, n_number)
        Each start is evaluated itself, so the result is never worse than the best start.
    budget : int, > 0
        Largest number of points to try, starts included; every start is tried in any case.
    seed : int
        The same seed gives the same search.
    population : int
        Points per generation and start.
    spread : float
        Initial standard deviation.
    tolerance : float
        A start ends, after 20 generations at the earliest, when its best value has improved by at most this share over ten generations.
    target : float
        The search ends with the generation that reaches this value.
    progress : callable, optional
        Called with the number of points tried.
    stoppable : bool
        Whether Ctrl-C ends the search with the best points so far, instead of an error.

    Raises
    ------
    ParameterError
        If there is no start, or no point has a finite value.

    References
    ----------
    N. Hansen, "The CMA evolution strategy: a tutorial", arXiv 1604.00772; this function uses the author's package cma.
    """
    starts = np.clip(np.atleast_2d(np.asarray(starts, dtype=float)), 0.0, 1.0)
    if starts.size == 0 or budget < 1:
        raise ParameterError("search", f"{len(starts)} starts, {budget} points", "at least one start and one point")
    points, values, runs = starts.copy(), _finite(objective(starts)), len(starts)
    history, course = [values.copy()], [(float(runs), float(values.min()))]
    box = _package().BoundTransform([0.0, 1.0])
    strategies = [_strategy(start, box, seed + i, population, spread) for i, start in enumerate(starts)]
    running, interrupted = list(range(len(starts))), False
    try:
        while running and values.min() > target and runs + population * len(running) <= budget:
            asked = np.array([strategies[i].ask() for i in running])
            # All at once: one by one, this takes the package as long as their runs.
            tried = np.clip(box.repair(asked.ravel()), 0.0, 1.0).reshape(-1, asked.shape[2])[:, : starts.shape[1]]
            reached = np.split(_finite(objective(tried)), len(running))
            for i, rows, own, mine in zip(running, asked, np.split(tried, len(running)), reached, strict=True):
                strategies[i].tell(list(rows), _ranked(mine).tolist())
                at = int(np.argmin(mine))
                if mine[at] < values[i]:
                    points[i], values[i] = own[at], mine[at]
            runs += population * len(running)
            history.append(values.copy())
            course.append((float(runs), float(values.min())))
            past = history[-11] if len(history) > 20 else np.full(values.size, np.inf)
            with np.errstate(invalid="ignore"):  # a start without a finite value is not settled
                settled = past - values <= tolerance * np.abs(values)
            running = [i for i in running if not settled[i] and not strategies[i].stop()]
            progress(runs)
    except KeyboardInterrupt:
        if not stoppable:
            raise
        interrupted = True
    at = int(np.argmin(values))
    refuse(not np.isfinite(values[at]), ParameterError, "search", "no run that went well", "bounds within which the loop holds")
    return Found(points[at], float(values[at]), values, points, runs, np.array(course), interrupted)


def drawn_starts(known: Sequence[Array], count: int, size: int, seed: int) -> Array:
    """Return starts (count, size) of a search: the known ones, and others drawn from the middle half of the box."""
    kept = known[:count]
    return np.vstack([*kept, 0.25 + 0.5 * np.random.default_rng(seed).random((count - len(kept), size))])


def restarted(
    objective: Objective, starts: Array, budget: int, seed: int, spread: float = SPREAD, target: float = -math.inf, *, quick: bool = False
) -> Found:
    """Search from all starts (n_start, n), then restart from the best until `budget` candidates are tried or `target` is reached.

    Each restart has a smaller first step, and generations twice as large as before: encoder counts make the objective rough near its
    optimum (Auger & Hansen, CEC 2005). A quick search has generations as wide as a batch at the least, and ends once a restart with the
    smallest first step improves nothing.
    """
    first, size = max(int(EXPLORED * budget), 1), LANES if quick else POPULATION
    reached = search(objective, starts, budget=first, seed=seed, spread=spread, population=size, target=target)
    runs, turn, course, idle = reached.runs, 1, [reached.course], False
    while budget - runs > size and reached.value > target and not (quick and idle and turn > len(RESTARTS)):
        options = {"seed": seed + 1000 * turn, "spread": RESTARTS[min(turn, len(RESTARTS)) - 1], "population": size, "target": target}
        more = search(objective, reached.point[None], budget=budget - runs, **options)  # type: ignore[arg-type]
        idle = not more.value < reached.value
        reached = replace(reached, point=more.point, value=more.value)
        course.append(more.course + np.array([runs, 0.0]))
        runs, size, turn = runs + more.runs, 2 * size, turn + 1
    return replace(reached, runs=runs, course=np.vstack(course))


@dataclass(eq=False)
class _Spared:
    """Says, to one thread alone, that packages are missing which cma takes for pictures and tests of ranks: three quarters of a second."""

    thread: int

    def find_spec(self, name: str, path: object = None, target: object = None) -> None:
        if name in ("matplotlib", "scipy.stats") and threading.get_ident() == self.thread:
            raise ModuleNotFoundError(name, name=name)


_LOADING = threading.Lock()


def _package() -> Any:
    """Return cma; the first of the threads that ask loads it."""
    import logging

    with _LOADING:
        if "cma" not in sys.modules:
            finder = _Spared(threading.get_ident())
            sys.meta_path = [finder, *sys.meta_path]  # a new list: other threads may be walking through the old one
            try:
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")  # of the package, on optional plotting
                    import cma  # noqa: F401
            finally:
                sys.meta_path = [one for one in sys.meta_path if one is not finder]
            logging.getLogger("cma").setLevel(logging.ERROR)
    return sys.modules["cma"]


def _strategy(start: Array, box: Any, seed: int, population: int, spread: float) -> Any:
    generator = np.random.default_rng(seed)
    options: dict[str, Any] = {"maxstd": 1.0 / 3.0, "popsize": population, "verbose": -9, "tolfun": 0.0, "tolfunhist": 0.0}
    # Use a separate generator: otherwise the package seeds numpy's global generator.
    options |= {"seed": np.nan, "randn": lambda *shape: generator.standard_normal(shape)}
    # On a bound the transformation of the box has zero slope. The package needs two dimensions: a lone parameter gets an idle one.
    inside = [*np.clip(start, 1e-3, 1.0 - 1e-3), *([0.5] if start.size == 1 else [])]
    return _package().CMAEvolutionStrategy(box.inverse(np.array(inside)), spread, options)


def _finite(values: Array) -> Array:
    return np.where(np.isfinite(values), values, np.inf)


def _ranked(values: Array) -> Array:
    """Replace values that are not finite by a value worse than the worst finite value."""
    good = values[np.isfinite(values)]
    worst = float(good.max()) if good.size else 1.0
    return np.where(np.isfinite(values), values, worst + abs(worst) + 1.0)
