"""What a network between base and local controller costs a shared design, and the smallest message rate that holds on all variants."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from contourlab.arrays import Array
from contourlab.components.link.network import Network
from contourlab.features.link.cost import WAYS, allowed_error, divided, division_cost, undivided_error
from contourlab.features.link.sweep import SEEDS, LinkSetting, LinkSweep
from contourlab.features.swap.variants import Variants, losses
from contourlab.loop import DIVISIONS, Division

PERIOD = "message_period"


@dataclass(frozen=True)
class VariantCost:
    """What a division costs one variant.

    Attributes
    ----------
    variant : str
    undivided, allowed : float [SI]
        J without links, and the largest allowed.
    as_given : float [SI]
        J with the links as given, the worst of the seeds; nan if a run left its limits.
    unstable : bool
        Whether the linear model with these links is unstable; False if unknown.
    sweep : LinkSweep
        Of the message period.
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
    """What one division between base and axes costs a shared design.

    Attributes
    ----------
    division, ways : str
        As of `contourlab.features.link.cost.divided`.
    local_in_base : tuple of str
        Local parameters, dotted, that the division leaves in the base.
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
        """The longest message period [s] that holds on all variants; nan if not even the shortest does."""
        return float(np.min([cost.sweep.most for cost in self.variants]))

    @property
    def rate(self) -> float:
        """The smallest message rate [Hz] that holds on all variants."""
        return 1.0 / self.message_period

    @property
    def limited(self) -> bool:
        """Whether a longer period was tested and fails."""
        return any(cost.sweep.limited and cost.sweep.most == self.message_period for cost in self.variants)

    @property
    def loss(self) -> float:
        """What the links as given lose: the largest (J - J undivided)/max(J undivided, J_tol)."""
        given, whole = ([getattr(cost, name) for cost in self.variants] for name in ("as_given", "undivided"))
        return float(losses(given, whole, self.floor).max())


def stays_in_axis(name: str, division: str) -> bool:
    """Tell whether a division leaves a parameter of an axis' controller, by its dotted name, in the axis."""
    slot = name.split(".")[3] if name.startswith("controller.axes.") else ""
    return Division(division, Network(), Network()).is_local(slot)


def least_division(local: frozenset[str]) -> str:
    """Return the division with the least in the axis that has all local parameters there.

    >>> least_division(frozenset({"controller.axes.x.observer.model_gain"}))
    'observer'
    """
    # `DIVISIONS` goes from the least to the most in the axis; the last has the whole controller there.
    return next(division for division in DIVISIONS if all(stays_in_axis(name, division) for name in local))


def network_cost(
    variants: Variants,
    points: Array,
    local: frozenset[str],
    division: str,
    ways: str = "both",
    link: Network | None = None,
    *,
    within: float = 0.1,
    longest: float = 0.1,
    seeds: int = SEEDS,
    progress: Callable[[int, int], None] | None = None,
) -> NetworkCost:
    """Run a design over a network, with the controllers of all axes divided alike.

    Parameters
    ----------
    variants : Variants
    points : ndarray (n_variant, n_parameter)
        What each variant runs with.
    local : frozenset of str
        Local parameters.
    division, ways, link
        As of `contourlab.features.link.cost.divided`.
    within : float, >= 0
        Largest (J - J undivided)/max(J undivided, J_tol) allowed.
    longest : float [s]
        Longest message period to test.
    seeds : int
        Runs with jitter or loss: the worst counts.
    progress : callable, optional
        Called with the variants done, and their number.

    Raises
    ------
    ParameterError
        If division, ways or a limit is unknown or out of range.
    """
    costs = []
    for variant, point in zip(variants, points, strict=True):
        machine, controller, reference, figure = variant.machine, variants.controller_at(point), variants.reference, variants.objective
        whole = undivided_error(machine, controller, reference, figure, seed=variants.seed, moving=variants.moving)
        allowed = allowed_error(whole, within, floor=variants.floor)
        over = divided(controller, division, ways, link)
        setting = LinkSetting(machine, over, reference, figure, allowed, seeds, variants.seed, variants.moving)
        cost = division_cost(setting, (PERIOD,), longest)
        costs.append(VariantCost(variant.name, whole, allowed, cost.error, cost.unstable, cost.sweeps[PERIOD]))
        if progress is not None:
            progress(len(costs), len(variants))
    in_base = tuple(sorted(name for name in local if not stays_in_axis(name, division)))
    return NetworkCost(division, ways, in_base, variants.floor, tuple(costs))
