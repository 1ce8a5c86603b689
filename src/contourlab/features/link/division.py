"""What it costs to divide controllers between base and axes, and how slow, late or lossy a network may be."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from contourlab.components.link.network import Network
from contourlab.errors import ParameterError
from contourlab.features.link.sweep import FIGURES, QUANTITIES, SEEDS, LinkSetting, LinkSweep, divided, swept
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine, parameter_names, simulate, simulate_batch

WITHIN = 0.1
"""More of the undivided loop's error that is allowed, as a part of it."""


@dataclass(frozen=True)
class LinkLimit:
    """The most of one quantity of the links that a machine stands.

    Attributes
    ----------
    quantity : str
    value : float
        In SI; nan where not even the least holds.
    limited : bool
        False where everything that was looked at holds.
    error : float
        At that value.
    undivided, allowed : float
        Error of the undivided loop, and what is let pass.
    """

    quantity: str
    value: float
    limited: bool
    error: float
    undivided: float
    allowed: float

    @property
    def rate(self) -> float:
        """Of a message period: the smallest message rate that holds [Hz]."""
        return 1.0 / self.value


def undivided_error(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    figure: str = FIGURES[0],
    *,
    seed: int = 0,
    moving: bool = False,
) -> float:
    """Return a figure of the contour error [m, or m s] of the loop without any link, over the last lap or all.

    Raises
    ------
    ParameterError
        If the figure is unknown.
    DivergenceError
        If the run leaves its limits even so: it says where and when.
    """
    if figure not in FIGURES:
        raise ParameterError("figure", repr(figure), "one of " + ", ".join(FIGURES))
    whole = replace(controller, axes={name: replace(mine, link=None) for name, mine in controller.axes.items()})
    name, (part, parameter) = next(iter(parameter_names(machine, whole).items()))
    found = simulate_batch(machine, whole, reference, {name: [part.values()[parameter]]}, seed=seed, moving=moving)
    if math.isnan(found.figures[figure][0]):
        # One run by itself says where and when it fails.
        simulate(machine, whole, reference, seed=seed, moving=moving)
    return float(found.figures[figure][0])


def link_limit(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    quantity: str = "message_period",
    *,
    figure: str = FIGURES[0],
    within: float = WITHIN,
    allowed: float | None = None,
    longest: float = 0.1,
    seeds: int = SEEDS,
    seed: int = 0,
    moving: bool = False,
) -> LinkLimit:
    """Return the most of a quantity of the links at which contour error and stability hold.

    Parameters
    ----------
    machine, controller, reference
        The controller divided, with a network in one direction at least: see `divided`.
    quantity : str
        Of `QUANTITIES`, the same for all axes and both directions.
    figure : str
        Of `FIGURES`.
    within : float, >= 0
        More of the undivided loop's error that is allowed, as a part of it.
    allowed : float, optional
        Largest error in place of that [m, or m s for the integral].
    longest : float [s]
        Up to where times are looked at.
    seeds : int
        Where chance plays a part: the worst of so many runs counts.
    seed : int
        The first of them, and of all other noise.
    moving : bool
        As of `simulate_batch`.

    Raises
    ------
    ParameterError
        If an argument is out of range, or no link is a network.
    """
    whole = undivided_error(machine, controller, reference, figure, seed=seed, moving=moving)
    top = allowed_error(whole, within, allowed)
    sweep = swept(LinkSetting(machine, controller, reference, figure, top, seeds, seed, moving), quantity, longest)
    most = sweep.most
    error = float(sweep.error[sweep.values == most][0]) if math.isfinite(most) else math.nan
    return LinkLimit(quantity, most, sweep.seen, error, whole, top)


def allowed_error(whole: float, within: float, allowed: float | None = None) -> float:
    """Return the largest error that is let pass: what is given, else the undivided loop's and a part of it more.

    Raises
    ------
    ParameterError
        If either is out of range.
    """
    if allowed is None:
        if not (within >= 0.0 and math.isfinite(within)):
            raise ParameterError("within", f"{within:g}", ">= 0 and finite")
        return (1.0 + within) * whole
    if not (allowed > 0.0 and math.isfinite(allowed)):
        raise ParameterError("allowed", f"{allowed:g}", "> 0 and finite")
    return allowed


def message_rate(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    division: str = "observer",
    ways: str = "both",
    link: Network | None = None,
    axes: Sequence[str] | None = None,
    **options: Any,
) -> LinkLimit:
    """Return the smallest message rate at which a machine holds with its controllers divided in a way: `LinkLimit.rate`.

    Parameters
    ----------
    machine, controller, reference
        The controller whole; what it has of links is replaced.
    division, ways, link, axes
        As of `divided`; delay, jitter and loss of the link stay as they are.
    **options
        As of `link_limit`.
    """
    return link_limit(machine, divided(controller, division, ways, link, axes), reference, "message_period", **options)


# --- the study ---------------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class DivisionCost:
    """What one way of dividing the controllers costs.

    Attributes
    ----------
    division, ways : str
        Where axes differ in them, all that there are with commas between.
    local : dict of str to tuple of str
        Parameters that may move with each axis.
    error : float
        With the links as they are given, before anything of them is swept; nan where a run left its limits.
    sweeps : dict of str to LinkSweep
    remarks : tuple of str
    """

    division: str
    ways: str
    local: Mapping[str, tuple[str, ...]]
    error: float
    sweeps: Mapping[str, LinkSweep]
    remarks: tuple[str, ...] = ()


def division_cost(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    *,
    allowed: float,
    figure: str = FIGURES[0],
    quantities: Sequence[str] = QUANTITIES,
    longest: float = 0.1,
    seeds: int = SEEDS,
    seed: int = 0,
    moving: bool = False,
    progress: Callable[[int, int], None] | None = None,
) -> DivisionCost:
    """Sweep the links of a divided controller, one quantity at a time, the others as they are given.

    What is swept is the same for all links, also where they differ in it as they are given.

    Parameters
    ----------
    machine, controller, reference
        The controller divided.
    allowed : float
        Largest error that is let pass.
    quantities : sequence of str
        Of `QUANTITIES`.
    figure, longest, seeds, seed, moving
        As of `link_limit`.
    progress : callable, optional
        Told quantities done and quantities in all.

    Raises
    ------
    ParameterError
        If a quantity is unknown, an argument is out of range, or no link is a network.
    """
    unknown = [name for name in quantities if name not in QUANTITIES]
    if unknown:
        raise ParameterError("quantities", repr(unknown[0]), "of " + ", ".join(QUANTITIES))
    setting = LinkSetting(machine, controller, reference, figure, allowed, seeds, seed, moving)
    sweeps = {}
    for i, quantity in enumerate(quantities):
        sweeps[quantity] = swept(setting, quantity, longest)
        if progress is not None:
            progress(i + 1, len(quantities))
    links = [mine.link for mine in controller.axes.values() if mine.link is not None]
    divisions = ", ".join(dict.fromkeys(link.division for link in links))
    ways = ", ".join(dict.fromkeys("both" if isinstance(link.up, Network) else "one" for link in links))
    local = {name: mine.local_parameters for name, mine in controller.axes.items()}
    remarks = [*_remarks(machine, controller, setting), *(_on_stability(setting) if {"message_period", "delay"} & set(quantities) else ())]
    return DivisionCost(divisions, ways, local, setting.as_given(), sweeps, tuple(remarks))


def _remarks(machine: Machine, controller: Controller, setting: LinkSetting) -> Iterator[str]:
    period, duration = machine.servo_period, setting.reference.duration
    for (axis, way), part in setting.networks.items():
        ticks = part.message_period / period
        if abs(ticks - round(ticks)) > 1e-6:
            rounded = math.ceil(ticks) * period
            yield f"axis {axis}, {way}: messages each {part.message_period * 1e3:g} ms go each {rounded * 1e3:g} ms, on the servo clock"
        if part.loss >= 1.0:
            yield f"axis {axis}, {way}: every message is lost"
        elif part.delay >= duration:
            yield f"axis {axis}, {way}: messages take {part.delay:g} s, the motion {duration:g} s: none arrives"
    if controller.coupling is None and any(mine.link is not None and mine.link.up is None for mine in controller.axes.values()):
        yield "the base sees no position: contour estimator and coupling are left out"


def _on_stability(setting: LinkSetting) -> Iterator[str]:
    """Yield why limits of stability of times are not told."""
    if any(part.jitter > 0.0 or part.loss > 0.0 for part in setting.networks.values()):
        yield "jitter and loss make the loop another one with each message: no limit of stability is told, the contour error alone counts"
        return
    if len(setting.reference.laps) < 2:
        yield "no two laps to compare: what is simulated tells no limit of stability"
    if not setting.loops:
        yield "no linear model: a component is not linear, or the axes have unlike links"
    elif any(part.between != "hold" for part in setting.networks.values()):
        yield "no linear model of messages that are extrapolated"
