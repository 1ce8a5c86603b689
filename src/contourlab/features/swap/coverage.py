"""For which part of a region of plants a shared design is good enough."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from contourlab.arrays import Array
from contourlab.design import Space
from contourlab.design.values import machine_with
from contourlab.errors import ParameterError
from contourlab.features.swap.search import restarted
from contourlab.features.swap.variants import Variant, Variants, losses

SAMPLES = 128
"""Plants that are judged against a tolerance."""


@dataclass(frozen=True, eq=False)
class Coverage:
    """How much of a region of plants a shared design covers.

    Attributes
    ----------
    region : Space
        Parameters of the machine and their bounds. Equal factors are equally likely if the whole range is above 0.
    points : ndarray (n, n_parameter)
        Sobol points, from 0 to 1.
    values : ndarray (n,) [SI]
        J of the shared design; infinite where it breaks a guard.
    best : ndarray (n,) [SI]
        J* from a search at each point; infinite where no design keeps the guards. Empty with a tolerance.
    covered : int
        Points that are good enough.
    tolerance : float [SI], optional
        J that is good enough; None for a loss below that of full modularity.
    """

    region: Space
    points: Array
    values: Array
    best: Array
    covered: int
    tolerance: float | None

    json_derived: ClassVar = ("share", "interval", "without_design")

    @property
    def share(self) -> float:
        """Part of the region that is covered."""
        return self.covered / len(self.points)

    @property
    def interval(self) -> tuple[float, float]:
        """The 95 % interval of the share."""
        return wilson_interval(self.covered, len(self.points))

    @property
    def without_design(self) -> int:
        """Points at which no search found a design that keeps the guards. They are not covered."""
        return int(np.isinf(self.best).sum())


def coverage(
    variants: Variants, point: Array, region: Space, *, full: float, tolerance: float | None = None, places: int = 8, budget: int = 2000
) -> Coverage:
    """Find how much of a region a design covers.

    Parameters
    ----------
    variants : Variants
        The machine of the first one is varied.
    point : ndarray (n_parameter,)
        The design.
    region : Space
        Of parameters of the machine.
    full : float
        A plant with a smaller loss is covered.
    tolerance : float [SI], optional
        J that is good enough, in place of a loss: no search is needed, and `SAMPLES` points are judged.
    places : int
        Points at which J* is searched, a power of 2.
    budget : int
        Candidates of each of these searches, which start from the design and from the scenario's own.

    Raises
    ------
    ParameterError
        If the region has a parameter that is not the machine's.
    """
    for name in region.names:
        if not name.startswith("axes."):
            raise ParameterError("region", name, "a number of the machine, such as axes.x.plant.gain")
    from scipy.stats import qmc

    size = SAMPLES if tolerance is not None else places
    if size < 1 or size & (size - 1):
        raise ParameterError("places", f"{size}", "a power of 2")
    points = np.asarray(qmc.Sobol(len(region.names), seed=variants.seed).random(size))
    values, best = np.empty(size), np.empty(0 if tolerance is not None else size)
    for k, plant in enumerate(points):
        machine = machine_with(variants.members[0].machine, region.values(plant))
        there = replace(variants, members=(Variant("", machine),), progress=None)
        found, broken = there.values(point[None, None])
        values[k] = math.inf if broken[0, 0] > 0.0 else found[0, 0]
        if tolerance is None:
            restarted(there.objective_of(0), np.vstack([point, variants.space.start]), budget, variants.seed)
            best[k] = there.best[0]
    if tolerance is not None:
        good = values <= tolerance
    else:
        known = np.isfinite(best)
        good = losses(np.where(known, values, math.inf), np.where(known, best, 1.0), variants.floor) < full
    return Coverage(region, points, values, best, int(good.sum()), tolerance)


def wilson_interval(hits: int, n: int) -> tuple[float, float]:
    """Return Wilson's 95 % interval of a share.

    >>> tuple(round(x, 3) for x in wilson_interval(8, 8))
    (0.676, 1.0)
    """
    from scipy.stats import binomtest

    low, high = binomtest(hits, n).proportion_ci(0.95, "wilson")
    return float(low), float(high)
