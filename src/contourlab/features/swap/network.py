"""What a network between base and local controller costs a design that variants share, and the smallest message rate that still holds."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.components.link.network import Network
from contourlab.features.link.division import undivided_error
from contourlab.features.link.sweep import SEEDS, LinkSetting, LinkSweep, divided, swept
from contourlab.features.swap.fleet import Fleet
from contourlab.features.swap.loss import losses
from contourlab.features.swap.numbers import divided_controller
from contourlab.loop import DIVISIONS, Division

Array = NDArray[np.float64]
PERIOD = "message_period"


@dataclass(frozen=True, eq=False)
class NetworkCost:
    """What one division between base and axes costs a shared design, on each variant.

    Attributes
    ----------
    division, ways : str
        As of `contourlab.features.link.sweep.divided`.
    apart : tuple of str
        Numbers that are to move with the axis, dotted, though the division leaves them in the base.
    whole : ndarray (n_variant,) [SI]
        J without any link.
    allowed : ndarray (n_variant,) [SI]
        Largest J that is let pass.
    given : ndarray (n_variant,) [SI]
        J with the links as they are given, the worst of the seeds; nan where a run left its limits.
    stable : tuple of bool
        Whether the linear model with these links is stable, or unknown.
    sweeps : tuple of LinkSweep
        Of the message period, one for each variant.
    at_limit : ndarray (n_variant,) [SI]
        J at the longest message period that holds on all variants; nan where there is none.
    floor : float [SI]
        J_tol.
    """

    division: str
    ways: str
    apart: tuple[str, ...]
    whole: Array
    allowed: Array
    given: Array
    stable: tuple[bool, ...]
    sweeps: tuple[LinkSweep, ...]
    at_limit: Array
    floor: float

    @property
    def holds(self) -> bool:
        """Whether all variants hold with the links as they are given."""
        return all(self.stable) and bool((self.given <= self.allowed).all())

    @property
    def period(self) -> float:
        """The longest message period [s] that holds on all variants; nan where not even the shortest does."""
        return float(np.min([sweep.most for sweep in self.sweeps]))

    @property
    def rate(self) -> float:
        """The smallest message rate [Hz] that holds on all variants."""
        return 1.0 / self.period

    @property
    def limited(self) -> bool:
        """Whether it is a limit, and not the end of what was looked at."""
        return any(sweep.seen and sweep.most == self.period for sweep in self.sweeps)

    @property
    def loss(self) -> float:
        """What the links as given lose over the undivided loop: max over variants of (J - J undivided)/max(J undivided, J_tol)."""
        return float(losses(self.given, self.whole, self.floor).max())


def stays_in_axis(name: str, division: str) -> bool:
    """Tell whether a number of an axis' controller, by its dotted name, stands in the axis under a division."""
    slot = name.split(".")[3] if name.startswith("controller.axes.") else ""
    return Division(division, Network(), Network()).is_local(slot)


def least_division(local: frozenset[str]) -> str:
    """Return the division that has the least in the axis, and all of some numbers.

    >>> least_division(frozenset({"controller.axes.x.observer.model_gain"}))
    'observer'
    """
    # In the order of `DIVISIONS` each has in the axis what the one before has; the last has all of the axis' controller.
    return next(division for division in DIVISIONS if all(stays_in_axis(name, division) for name in local))


def network_cost(
    fleet: Fleet,
    points: Array,
    local: frozenset[str],
    division: str,
    ways: str = "both",
    link: Network | None = None,
    *,
    within: float = 0.1,
    longest: float = 0.1,
    seeds: int = SEEDS,
    told: Callable[[int, int], None] | None = None,
) -> NetworkCost:
    """Return what it costs to run a design over a network, with the controllers of all axes divided alike.

    Parameters
    ----------
    fleet : Fleet
    points : ndarray (n_variant, n_number)
        What each variant runs with, in the fleet's space.
    local : frozenset of str
        Numbers that move with the axis.
    division, ways, link
        As of `contourlab.features.link.sweep.divided`.
    within : float, >= 0
        Largest part that is let pass, of (J - J undivided)/max(J undivided, J_tol): a swap loss by another cause.
    longest : float [s]
        Up to where message periods are looked at.
    seeds : int
        Where chance plays a part: the worst of so many runs counts.
    told : callable, optional
        Told the variants done, and how many there are.

    Raises
    ------
    ParameterError
        If division, ways or a limit is unknown or out of range.
    """
    part, rows = link or Network(), []
    for i, (variant, point) in enumerate(zip(fleet.variants, points, strict=True)):
        whole_controller = divided_controller(fleet.controller, fleet.space.values(point))
        whole = undivided_error(variant.machine, whole_controller, fleet.reference, fleet.objective, seed=fleet.seed, moving=fleet.moving)
        allowed = whole + within * max(whole, fleet.floor)
        controller = divided(whole_controller, division, ways, part)
        setting = LinkSetting(variant.machine, controller, fleet.reference, fleet.objective, allowed, seeds, fleet.seed, fleet.moving)
        given = float(setting.errors(PERIOD, np.array([part.message_period])).max())
        stable = not setting.growth(PERIOD, part.message_period) >= 1.0
        rows.append((setting, whole, allowed, given, stable, swept(setting, PERIOD, longest)))
        if told is not None:
            told(i + 1, fleet.n_variant)
    settings, whole_of, allowed_of, given_of, stable_of, sweeps = zip(*rows, strict=True)
    period = float(np.min([sweep.most for sweep in sweeps]))
    apart = tuple(sorted(name for name in local if not stays_in_axis(name, division)))
    return NetworkCost(
        division,
        ways,
        apart,
        whole=np.array(whole_of),
        allowed=np.array(allowed_of),
        given=np.array(given_of),
        stable=stable_of,
        sweeps=sweeps,
        at_limit=_errors_at(settings, period),
        floor=fleet.floor,
    )


def _errors_at(settings: Sequence[LinkSetting], period: float) -> Array:
    """Return the worst error of each variant with messages of one period."""
    if not math.isfinite(period):
        return np.full(len(settings), math.nan)
    return np.array([float(setting.errors(PERIOD, np.array([period])).max()) for setting in settings])
