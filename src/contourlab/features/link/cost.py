"""The cost of dividing controllers between base and axes, and the limits of message period, delay, jitter and loss between them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import count
from typing import Any

from contourlab.components.ideal import IdealLink
from contourlab.components.link.network import Network
from contourlab.errors import ParameterError, check_known, refuse
from contourlab.features.link.options import SEEDS
from contourlab.features.link.sweep import QUANTITIES, LinkSetting, LinkSweep, swept
from contourlab.feed import Reference
from contourlab.findings import Finding, finding
from contourlab.loop import Controller, Division, Machine
from contourlab.metrics.run_figures import goal_named
from contourlab.study import Setting
from contourlab.threads import in_threads

WAYS = {"both": "both ways", "one": "one way"}
"""Directions of messages. One way means down only: the base has its own wires to the sensors, or sees nothing."""
WITHIN = 0.1
"""Allowed error above that of the undivided loop, as a share of it."""


def divided(
    controller: Controller,
    division: str,
    ways: str = "both",
    link: Network | None = None,
    axes: Sequence[str] | None = None,
) -> Controller:
    """Divide a controller between base and axes.

    Parameters
    ----------
    controller : Controller
        Its own links are replaced.
    division : str
        One of `contourlab.loop.DIVISIONS`.
    ways : {"both", "one"}
        Whether messages also go up. If not, the base has its own wires to the sensors. With the whole controller in the axis the base sees
        nothing; contour estimator and coupling are then left out.
    link : Network, optional
        Network in each direction; by default without delay.
    axes : sequence of str, optional
        Axes to divide; all by default.

    Raises
    ------
    ParameterError
        If division, ways or an axis is unknown.
    """
    check_known("ways", ways, WAYS)
    chosen = tuple(controller.axes if axes is None else axes)
    unknown = [name for name in chosen if name not in controller.axes]
    if unknown:
        raise ParameterError("axes", repr(unknown[0]), "one of " + ", ".join(controller.axes))
    blind, part = ways == "one" and division == "controller", link or Network()
    network = Division(division, part, part if ways == "both" else None if blind else IdealLink())
    made = {name: replace(axis, link=network if name in chosen else None) for name, axis in controller.axes.items()}
    contour: dict[str, Any] = {"estimator": None, "coupling": None} if blind else {}
    return replace(controller, axes=made, **contour)


def undivided_error(setting: Setting, figure: str = "contour_error_rms") -> float:
    """Return a figure of the contour error [m, or m s] of the loop without links, over the last lap or the whole motion.

    Raises
    ------
    ParameterError
        If the figure is unknown.
    DivergenceError
        If the run leaves its limits.
    """
    figure, axes = goal_named(figure, "figure").name, setting.controller.axes.items()
    whole = replace(setting, controller=replace(setting.controller, axes={name: replace(axis, link=None) for name, axis in axes}))
    error = float(whole.batch(whole.as_it_is(), [figure]).figures[figure][0])
    if math.isnan(error):
        whole.single()  # raises an error with the place and time of the failure
    return error


def allowed_error(whole: float, within: float, allowed: float | None = None, floor: float = 0.0) -> float:
    """Return the largest error allowed: `allowed` if given, else `whole` + `within` max(`whole`, `floor`).

    Raises
    ------
    ParameterError
        If `within` or `allowed` is out of range.
    """
    if allowed is None:
        refuse(not (within >= 0.0 and math.isfinite(within)), ParameterError, "within", f"{within:g}", ">= 0 and finite")
        return (1.0 + within) * whole if whole >= floor else whole + within * floor
    refuse(not (allowed > 0.0 and math.isfinite(allowed)), ParameterError, "allowed", f"{allowed:g}", "> 0 and finite")
    return allowed


# --- the limit of one quantity -----------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class LinkLimit:
    """The largest value of one quantity of the links that holds.

    Attributes
    ----------
    quantity : str
    value : float [SI]
        nan if the smallest fails.
    limited : bool
        False if all tested values hold.
    error : float [m or m s]
        Error at that value.
    undivided, allowed : float [m or m s]
        Error of the undivided loop, and the largest allowed.
    """

    quantity: str
    value: float
    limited: bool
    error: float
    undivided: float
    allowed: float

    @property
    def rate(self) -> float:
        """For a message period: the smallest message rate that holds [Hz]."""
        return 1.0 / self.value


def link_limit(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    quantity: str = "message_period",
    *,
    figure: str = "contour_error_rms",
    within: float = WITHIN,
    allowed: float | None = None,
    longest: float = 0.1,
    seeds: int = SEEDS,
    seed: int = 0,
    moving: bool = False,
) -> LinkLimit:
    """Find the largest value of a link quantity at which the contour error is allowed and the loop is not unstable.

    Parameters
    ----------
    machine, controller, reference
        The controller must be divided, with a network in at least one direction: see `divided`.
    quantity : str
        One of `QUANTITIES`, the same for all axes and both directions.
    figure : str
        One of `contourlab.metrics.run_figures.GOALS`.
    within : float, >= 0
        Allowed error above that of the undivided loop, as a share of it.
    allowed : float, optional
        Largest error allowed, instead of `within` [m, or m s for the integral].
    longest : float [s]
        Largest time to test.
    seeds : int
        Runs with jitter or loss: the worst counts.
    seed : int
        The first of these seeds.
    moving : bool
        See `simulate_batch`.

    Raises
    ------
    ParameterError
        If an argument is out of range, or no link is a network.
    """
    setting = Setting(machine, controller, reference, seed, moving)
    whole = undivided_error(setting, figure)
    sweep = swept(LinkSetting(setting, figure, allowed_error(whole, within, allowed), seeds), quantity, longest)
    error = next(iter(sweep.error[sweep.values == sweep.most].tolist()), math.nan)
    return LinkLimit(quantity, sweep.most, sweep.limited, error, whole, sweep.allowed)


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
    """Find the smallest message rate at which a machine with divided controllers holds: `LinkLimit.rate`.

    Parameters
    ----------
    machine : Machine
    controller : Controller
        Undivided; its own links are replaced.
    reference : Reference
    division : {"observer", "drive", "controller"}
        What is in the axis: see `Division`.
    ways : {"both", "one"}
        Whether messages also go up, from the axis to the base.
    link : Network, optional
        Network in each direction, whose delay, jitter and loss stay as given; by default it has none.
    axes : sequence of str, optional
        Axes to divide; all by default.
    **options : Any
        See `contourlab.features.link.cost.link_limit`.

    Returns
    -------
    LinkLimit

    Raises
    ------
    ParameterError
        If division, ways, an axis or an option is out of range.
    DivergenceError
        If the undivided loop leaves its limits.
    """
    return link_limit(machine, divided(controller, division, ways, link, axes), reference, "message_period", **options)


# --- the cost of a division --------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class DivisionCost:
    """The cost of one division of the controllers.

    Attributes
    ----------
    division, ways : str
        Lists each that occurs if axes differ.
    local_parameters : dict of str to tuple of str
        Parameters that may move with each axis.
    error : float
        Error with the links as given; nan if a run left its limits.
    unstable : bool
        Whether the linear model with the links as given is unstable; False if unknown.
    sweeps : dict of str to LinkSweep
    findings : tuple of Finding
    """

    division: str
    ways: str
    local_parameters: Mapping[str, tuple[str, ...]]
    error: float
    unstable: bool
    sweeps: Mapping[str, LinkSweep]
    findings: tuple[Finding, ...] = ()

    @property
    def name(self) -> str:
        """Division and ways."""
        return f"{self.division}, {WAYS.get(self.ways, self.ways)}"


def division_cost(
    setting: LinkSetting,
    quantities: Sequence[str] = QUANTITIES,
    longest: float = 0.1,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> DivisionCost:
    """Sweep the links of a divided controller, one quantity at a time, the others as given.

    The swept quantity is the same for all links, even if the given links differ.

    Parameters
    ----------
    setting : LinkSetting
    quantities : sequence of str
        From `QUANTITIES`.
    longest : float [s]
        Largest time to test.
    progress : callable, optional
        Called with the number of quantities done and in all.

    Raises
    ------
    ParameterError
        If a quantity is unknown, or the longest time shorter than a servo period.
    """
    error, done = setting.as_given(), count(1)  # this run compiles the components before the threads start

    def sweep(quantity: str) -> LinkSweep:
        found = swept(setting, quantity, longest)
        progress(next(done), len(quantities))
        return found

    sweeps = dict(zip(quantities, in_threads(sweep, quantities), strict=True))
    axes = setting.divided.controller.axes
    links = [axis.link for axis in axes.values() if axis.link is not None]
    timed = {"message_period", "delay"} & set(quantities)
    return DivisionCost(
        division=", ".join(dict.fromkeys(link.division for link in links)),
        ways=", ".join(dict.fromkeys("both" if isinstance(link.up, Network) else "one" for link in links)),
        local_parameters={name: axis.local_parameters for name, axis in axes.items()},
        error=error,
        unstable=setting.growth("message_period", next(iter(setting.networks.values())).message_period) >= 1.0,
        sweeps=sweeps,
        findings=(*_on_links(setting), *(_on_stability(setting) if timed and not setting.few else ())),
    )


def _on_links(setting: LinkSetting) -> Iterator[Finding]:
    run = setting.divided
    period, duration, controller = run.machine.servo_period, run.reference.duration, run.controller
    for (axis, way), part in setting.networks.items():
        place, ticks = f"axis {axis}, {way}", part.message_period / period
        if abs(ticks - round(ticks)) > 1e-6:
            yield finding("CL750", place, asked=part.message_period, sent=math.ceil(ticks) * period)
        if part.loss >= 1.0:
            yield finding("CL751", place)
        elif part.delay >= duration:
            yield finding("CL752", place, delay=part.delay, duration=duration)
    if controller.coupling is None and any(axis.link is not None and axis.link.up is None for axis in controller.axes.values()):
        yield finding("CL753")


def _on_stability(setting: LinkSetting) -> Iterator[Finding]:
    """Yield the reasons why a stability limit is unknown."""
    if any(part.jitter > 0.0 or part.loss > 0.0 for part in setting.networks.values()):
        yield finding("CL754")
        return
    if len(setting.divided.reference.laps) < 2:
        yield finding("CL755")
    if not setting.loops:
        yield finding("CL756")
    elif any(part.between != "hold" for part in setting.networks.values()):
        yield finding("CL757")
