"""Does a shared design hold beyond the variants: over a network between base and local controller, and over a region of plants?"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from contourlab.arrays import Array
from contourlab.components.link.network import Network
from contourlab.errors import ParameterError, refuse
from contourlab.features.link.cost import WAYS, allowed_error, divided, division_cost, undivided_error
from contourlab.features.link.sweep import LinkSetting, LinkSweep
from contourlab.features.swap.search import Design
from contourlab.features.swap.variants import Variant, Variants, losses
from contourlab.loop import DIVISIONS, Division
from contourlab.loop.parameters import with_values
from contourlab.study import Space
from contourlab.study.search import restarted
from contourlab.study.statistics import wilson

PERIOD = "message_period"


@dataclass(frozen=True)
class VariantCost:
    """The cost of a division for one variant.

    Attributes
    ----------
    variant : str
    undivided, allowed : float [SI]
        J without links, and the largest allowed.
    as_given : float [SI]
        J with the links as given, worst of the seeds; nan if a run left its limits.
    unstable : bool
        Whether the linear model with these links is unstable; False if unknown.
    sweep : LinkSweep
        Sweep of the message period.
    """

    variant: str
    undivided: float
    allowed: float
    as_given: float
    unstable: bool
    sweep: LinkSweep

    @property
    def holds(self) -> bool:
        """Whether the variant holds with the links as given."""
        return not self.unstable and self.as_given <= self.allowed


@dataclass(frozen=True)
class NetworkCost:
    """The cost of one division between base and axes for a shared design.

    Attributes
    ----------
    division, ways : str
        See `contourlab.features.link.cost.divided`.
    local_in_base : tuple of str
        Dotted names of local parameters that the division leaves in the base.
    floor : float [SI]
        J_tol.
    variants : tuple of VariantCost
    """

    division: str
    ways: str
    local_in_base: tuple[str, ...]
    floor: float
    variants: tuple[VariantCost, ...]

    json_derived: ClassVar = ("holds", "loss", "message_period", "rate", "limited")

    @property
    def name(self) -> str:
        """Division and ways."""
        return f"{self.division} in the axis, messages {WAYS[self.ways]}"

    @property
    def holds(self) -> bool:
        """Whether all variants hold with the links as given."""
        return all(cost.holds for cost in self.variants)

    @property
    def message_period(self) -> float:
        """The longest message period [s] that holds on all variants; nan if the shortest fails."""
        return float(np.min([cost.sweep.most for cost in self.variants]))

    @property
    def rate(self) -> float:
        """The smallest message rate [Hz] that holds on all variants."""
        return 1.0 / self.message_period

    @property
    def fails(self) -> float:
        """The shortest message period [s] that was tested and fails on a variant; infinite if none does."""
        return min((cost.sweep.fails for cost in self.variants if cost.sweep.limited), default=math.inf)

    @property
    def limited(self) -> bool:
        """Whether a longer period was tested and fails."""
        return any(cost.sweep.limited and cost.sweep.most == self.message_period for cost in self.variants)

    @property
    def loss(self) -> float:
        """Loss with the links as given: the largest (J - J undivided)/max(J undivided, J_tol)."""
        given, whole = ([getattr(cost, name) for cost in self.variants] for name in ("as_given", "undivided"))
        return float(losses(given, whole, self.floor).max())


def stays_in_axis(name: str, division: str) -> bool:
    """Return whether a division puts a parameter of an axis controller, by its dotted name, into the axis."""
    slot = name.split(".")[3] if name.startswith("controller.axes.") else ""
    return Division(division, Network(), Network()).is_local(slot)


def least_division(local: frozenset[str]) -> str:
    """Return the smallest division that puts all local parameters into the axis.

    >>> least_division(frozenset({"controller.axes.x.observer.model_gain"}))
    'observer'
    """
    # Ordered from least to most in the axis; the last has the whole controller there.
    return next(division for division in DIVISIONS if all(stays_in_axis(name, division) for name in local))


def network_cost(
    design: Design,
    division: str,
    ways: str = "both",
    link: Network | None = None,
    *,
    within: float = 0.1,
    longest: float = 0.1,
    few: int = 0,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> NetworkCost:
    """Run a design over a network; the controllers of all axes have the same division.

    Parameters
    ----------
    design : Design
    division, ways, link
        See `contourlab.features.link.cost.divided`.
    within : float, >= 0
        Largest (J - J undivided)/max(J undivided, J_tol) allowed.
    longest : float [s]
        Longest message period to test.
    few : int
        See `LinkSetting`.
    progress : callable, optional
        Called with the number of variants done and in all.

    Raises
    ------
    ParameterError
        If division, ways or a limit is unknown or out of range.
    """
    variants, costs = design.variants, list[VariantCost]()
    for variant, point in zip(variants, design.points, strict=True):
        setting = replace(variants.setting, machine=variant.machine, controller=variants.controller_at(point))
        whole = undivided_error(setting, variants.objective)
        allowed = allowed_error(whole, within, floor=variants.floor)
        over = replace(setting, controller=divided(setting.controller, division, ways, link))
        cost = division_cost(LinkSetting(over, variants.objective, allowed, few=few), (PERIOD,), longest)
        costs.append(VariantCost(variant.name, whole, allowed, cost.error, cost.unstable, cost.sweeps[PERIOD]))
        progress(len(costs), len(variants))
    in_base = tuple(sorted(name for name in design.local if not stays_in_axis(name, division)))
    return NetworkCost(division, ways, in_base, variants.floor, tuple(costs))


SAMPLES = 128
"""Plants to judge against a tolerance."""


@dataclass(frozen=True, eq=False)
class Coverage:
    """How much of a region of plants a shared design covers.

    Attributes
    ----------
    region : Space
        Parameters of the machine and their bounds. A range that lies above 0 is sampled on a logarithmic scale.
    points : ndarray (n, n_parameter)
        Sobol points, 0 to 1.
    values : ndarray (n,) [SI]
        J of the shared design; infinite where it breaks a guard.
    best : ndarray (n,) [SI]
        J* from a search at each point; infinite where no design keeps the guards. Empty with a tolerance.
    covered : int
        Number of covered points.
    tolerance : float [SI], optional
        Largest acceptable J; None: the loss must be below that of full modularity.
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
        """Share of the region that is covered."""
        return self.covered / len(self.points)

    @property
    def interval(self) -> tuple[float, float]:
        """The 95 % interval of the share."""
        return wilson(self.covered, len(self.points))

    @property
    def without_design(self) -> int:
        """Number of points at which no search found a design that keeps the guards; they count as not covered."""
        return int(np.isinf(self.best).sum())


def coverage(
    variants: Variants, point: Array, region: Space, *, full: float, tolerance: float | None = None, places: int = 8, budget: int = 2000
) -> Coverage:
    """Find how much of a region a design covers.

    Parameters
    ----------
    variants : Variants
        The machine of the first variant is varied.
    point : ndarray (n_parameter,)
        The design.
    region : Space
        Parameters of the machine.
    full : float
        A plant with a smaller loss is covered.
    tolerance : float [SI], optional
        Largest acceptable J, instead of a loss: judges `SAMPLES` points without a search.
    places : int
        Points at which J* is searched, a power of 2.
    budget : int
        Candidates of each search; a search starts from the design and from the scenario's own parameters.

    Raises
    ------
    ParameterError
        If a parameter of the region does not belong to the machine, or `places` is not a power of 2.
    """
    for name in region.names:
        refuse(not name.startswith("axes."), ParameterError, "region", name, "a parameter of the machine, such as axes.x.plant.gain")
    from scipy.stats import qmc

    searched = tolerance is None
    size = places if searched else SAMPLES
    refuse(size < 1 or size & (size - 1), ParameterError, "places", f"{size}", "a power of 2")
    points = np.asarray(qmc.Sobol(len(region.names), seed=variants.setting.seed).random(size))
    values, best = np.empty(size), np.empty(size if searched else 0)
    for k, plant in enumerate(points):
        machine, _ = with_values(variants.members[0].machine, variants.setting.controller, region.values(plant))
        there = replace(variants, members=(Variant("", machine),), progress=lambda tried: None)
        values[k] = there.kept(point[None, None])[0, 0]
        if searched:
            restarted(there.objective_of(0), np.vstack([point, variants.space.start]), budget, variants.setting.seed)
            best[k] = there.best[0]
    if tolerance is not None:
        good = values <= tolerance
    else:
        known = np.isfinite(best)
        good = losses(np.where(known, values, math.inf), np.where(known, best, 1.0), variants.floor) < full
    return Coverage(region, points, values, best, int(good.sum()), tolerance)
