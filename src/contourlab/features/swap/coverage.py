"""For how much of a region of plants a shared design is good enough."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from contourlab.design import Evaluator, Space
from contourlab.design.values import machine_with
from contourlab.errors import ParameterError
from contourlab.features.swap.fleet import Fleet
from contourlab.features.swap.guard import Guard, holds
from contourlab.features.swap.loss import losses
from contourlab.features.swap.own import best_of_its_own
from contourlab.features.swap.variants import Variant

Array = NDArray[np.float64]
SAMPLES = 128


@dataclass(frozen=True, eq=False)
class Coverage:
    """How much of a region of plants a shared design covers.

    Attributes
    ----------
    region : Space
        Numbers of the machine and their bounds; equal factors are equally likely, where all of a range is above 0.
    points : ndarray (n, n_number)
        Sobol points, in places from 0 to 1.
    values : ndarray (n,) [SI]
        J of the shared design there; infinite where it breaks a guard.
    best : ndarray (m,) [SI]
        J* at the first m points, from a search at each of them, infinite where none found a design that keeps the guards: such a plant
        is not covered. Empty where a tolerance was given.
    covered : int
        Points that are good enough, of `judged`.
    judged : int
    tolerance : float [SI], optional
        J that is good enough; None for a loss below that of full modularity.
    """

    region: Space
    points: Array
    values: Array
    best: Array
    covered: int
    judged: int
    tolerance: float | None

    @property
    def share(self) -> float:
        """Part of the region that is covered."""
        return self.covered / self.judged

    @property
    def without(self) -> int:
        """At how many points no search found a design that keeps the guards."""
        return int(np.isinf(self.best).sum())

    @property
    def bounds(self) -> tuple[float, float]:
        """Between which the share lies with 95 % confidence."""
        return interval(self.covered, self.judged)


def coverage(
    fleet: Fleet, point: Array, region: Space, *, full: float, tolerance: float | None = None, places: int = 8, budget: int = 2000
) -> Coverage:
    """Return how much of a region a design covers.

    Parameters
    ----------
    fleet : Fleet
        Its first variant is the machine whose numbers are moved.
    point : ndarray (n_number,)
        The design, in the fleet's space.
    region : Space
        Of numbers of the machine.
    full : float
        Loss below which a plant counts as covered.
    tolerance : float [SI], optional
        J that is good enough, in place of a loss: then nothing has to be searched, and all points count.
    places : int
        Points at which J* is searched; a power of 2 keeps them evenly spread.
    budget : int
        Candidates of each of these searches, from the design and around it: J* is the best found, the design included.

    Raises
    ------
    ParameterError
        If the region has a number that is not the machine's.
    """
    for name in region.names:
        if not name.startswith("axes."):
            raise ParameterError("region", name, "a number of the machine, such as axes.x.plant.gain")
    from scipy.stats import qmc

    size = SAMPLES if tolerance is not None else places
    if size < 1 or size & (size - 1):
        raise ParameterError("places", f"{size}", "a power of 2")
    points = np.asarray(qmc.Sobol(len(region.names), seed=fleet.seed).random(size))
    values = _values(fleet, point, region, points)
    if tolerance is not None:
        return Coverage(region, points, values, np.zeros(0), int((values <= tolerance).sum()), size, tolerance)
    best = np.array([_best(fleet, point, region.values(at), budget) for at in points])
    found = np.isfinite(best)
    good = losses(values[found], best[found], fleet.floor) < full
    return Coverage(region, points, values, best, int(good.sum()), size, None)


def _values(fleet: Fleet, point: Array, region: Space, points: Array) -> Array:
    """Return J at points of the region, infinite where a guard is broken; all of it in lanes but the margins, which the plants decide."""
    variant = fleet.variants[0]
    evaluator = Evaluator(variant.machine, fleet.controller, fleet.reference, moving=fleet.moving, seed=fleet.seed, threads=fleet.threads)
    base = {name: np.full(len(points), value) for name, value in fleet.space.values(point).items()}
    figures = evaluator(base | region.columns(points))
    excess = np.empty(len(points))
    for k, at in enumerate(points):
        guard = Guard(machine_with(variant.machine, region.values(at)), fleet.controller, fleet.bounds)
        excess[k] = guard.excess({name: column[:1] for name, column in base.items()})[0]
    limited = np.nan_to_num(fleet.keepers[0].limited(figures), nan=1.0)
    found = np.where(np.isfinite(figures[fleet.objective]), figures[fleet.objective], math.inf)
    return np.where(holds(excess, limited), found, math.inf)


def _best(fleet: Fleet, point: Array, values: dict[str, float], budget: int) -> float:
    """Return J* of a plant by a search around a design; infinite where nothing keeps the guards."""
    there = replace(fleet, variants=(Variant("", machine_with(fleet.variants[0].machine, values)),))
    try:
        best_of_its_own(there, 0, budget=budget, seed=fleet.seed, starts=np.vstack([point, fleet.space.start]), spread=0.1)
    except ParameterError:
        return math.inf
    return float(there.best[0])


def interval(hits: int, n: int) -> tuple[float, float]:
    """Return Wilson's 95 % interval of a share.

    >>> tuple(round(x, 3) for x in interval(8, 8))
    (0.676, 1.0)
    """
    z, p = 1.959964, hits / n
    middle, half = p + z * z / (2 * n), z * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
    scale = 1.0 + z * z / n
    return max((middle - half) / scale, 0.0), min((middle + half) / scale, 1.0)
