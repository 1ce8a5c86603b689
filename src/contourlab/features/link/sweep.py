"""Controllers divided between base and axes, and the contour error over message period, delay, jitter and loss of their links."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.divided_loop import DividedLoop, LinkTiming, divided_loop, timing_of
from contourlab.components.contract import Component
from contourlab.components.ideal import IdealLink
from contourlab.components.link.network import Network
from contourlab.errors import ComponentError, ParameterError
from contourlab.features.link.values import EACH, LOSSES, passed_over, times
from contourlab.features.run.causes.idealise import perfect_sensing, undisturbed, unlimited, without_friction
from contourlab.feed import Reference
from contourlab.loop import Controller, Division, Machine, simulate_batch
from contourlab.loop.tool import stream_of

Array = NDArray[np.float64]

QUANTITIES = ("message_period", "delay", "jitter", "loss")
"""What of a link is swept."""
FIGURES = ("contour_error_rms", "contour_error_max", "contour_error_integral")
"""What of the contour error is held against what is allowed."""
WAYS = {
    "both": "messages both ways",
    "one": "messages down alone; the base has wires of its own to the sensors, or, where it only sends a reference, sees nothing",
}
SEEDS = 8
"""Runs of which the worst counts where chance plays a part."""
CHUNK = 32
"""Values that run at once; where none of them holds no more are looked at."""
LARGE, LARGEST = 200, 700
"""States of a linear model beyond which it is worked out now and then only, and not at all."""
COLUMNS = ("values", "error", "median", "growth", "repeats")
GROWN = 0.5
"""Part by which the error of a lap may exceed that of the lap before in a loop that is stable."""


def divided(
    controller: Controller,
    division: str,
    ways: str = "both",
    link: Network | None = None,
    axes: Sequence[str] | None = None,
) -> Controller:
    """Return a controller that is divided between base and axes.

    Parameters
    ----------
    controller : Controller
        Links that it has are replaced.
    division : str
        Of `contourlab.loop.DIVISIONS`.
    ways : {"both", "one"}
        Whether messages go up too. One way the base either has wires of its own to the sensors, or, where the whole controller is in the
        axis, sees nothing: then contour estimator and coupling are left out.
    link : Network, optional
        Of each direction in which messages go; by default one without any loss of time.
    axes : sequence of str, optional
        Those that are divided; all by default.

    Raises
    ------
    ParameterError
        If division, ways or an axis is unknown.
    """
    if ways not in WAYS:
        raise ParameterError("ways", repr(ways), "one of " + ", ".join(WAYS))
    named = tuple(controller.axes) if axes is None else tuple(axes)
    unknown = [name for name in named if name not in controller.axes]
    if unknown:
        raise ParameterError("axes", repr(unknown[0]), "of " + ", ".join(controller.axes))
    part = link or Network()
    blind = ways == "one" and division == "controller"
    up: Component | None = part if ways == "both" else (None if blind else IdealLink())
    made = {name: replace(mine, link=Division(division, part, up) if name in named else None) for name, mine in controller.axes.items()}
    contour: dict[str, Any] = {"estimator": None, "coupling": None} if blind else {}
    return replace(controller, axes=made, **contour)


# --- one quantity ------------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class LinkSweep:
    """The contour error over one quantity of the links.

    Attributes
    ----------
    quantity : str
        Of `QUANTITIES`.
    values : ndarray (n,)
        Rising, in SI; times on the grid of the servo period.
    error : ndarray (n,)
        The worst over the seeds; nan where a run left its limits.
    median : ndarray (n,)
        Over the seeds.
    growth : ndarray (n,)
        Factor per tick of the slowest error of the linear model, in the worst direction of the path; nan where it was not worked out.
    repeats : ndarray (n,)
        Error of the last lap over that of the lap before, on the machine without friction, counting, disturbance and limits; nan where
        there are no two laps, or chance plays a part.
    allowed : float
        Largest error that is let pass.
    asked : float
        Up to where values were to be looked at, on their grid; nan where that is not known.
    """

    quantity: str
    values: Array
    error: Array
    median: Array
    growth: Array
    repeats: Array
    allowed: float
    asked: float = math.nan

    @property
    def holds(self) -> NDArray[np.bool_]:
        """Whether the error is allowed and the loop not known to be unstable (n,)."""
        return np.asarray((self.error <= self.allowed) & ~(self.growth >= 1.0))

    @property
    def most(self) -> float:
        """The largest value up to which every one that was looked at holds; nan if the first does not."""
        return _last_before(self.values, ~self.holds)

    @property
    def seen(self) -> bool:
        """Whether a value was found that does not hold, so that `most` is a limit and not the end of what was looked at."""
        return bool((~self.holds).any())

    @property
    def ended(self) -> bool:
        """Whether it ended ahead of what was asked for: nothing held any more over the last `CHUNK` values."""
        return bool(self.values[-1] < self.asked)

    @property
    def limited_by(self) -> tuple[float, str] | None:
        """The first value that does not hold, and why: ``"runs away"``, ``"error"`` or ``"unstable"``, in this order; None if all hold."""
        if not self.seen:
            return None
        first = int(np.argmin(self.holds))
        worst = float(self.error[first])
        return float(self.values[first]), "runs away" if math.isnan(worst) else "error" if worst > self.allowed else "unstable"

    @property
    def stable_linear(self) -> float:
        """The largest value up to which the linear model is stable; nan where that is not known, infinite if it is to the end."""
        return _limit(self.values, self.growth >= 1.0, np.isnan(self.growth))

    @property
    def stable_simulated(self) -> float:
        """The same of the machine without friction and limits as it was simulated."""
        return _limit(self.values, self.repeats > 1.0 + GROWN, np.isnan(self.repeats))


def _last_before(values: Array, bad: NDArray[np.bool_]) -> float:
    first = int(np.argmax(bad)) if bad.any() else len(values)
    return float(values[first - 1]) if first else math.nan


def _limit(values: Array, bad: NDArray[np.bool_], unknown: NDArray[np.bool_]) -> float:
    """Return the last value known to be good ahead of the first bad one; infinite if all is good to the end, nan if nobody knows."""
    known = ~unknown
    if bad.any() or not known.any():
        return _last_before(values[known], bad[known])
    return math.inf if known[-1] else math.nan


class LinkSetting:
    """A machine under a divided controller, whose links are varied.

    Parameters
    ----------
    machine, controller, reference
        The controller with a network in one direction at least.
    figure : str
        Of `FIGURES`.
    allowed : float
        Largest error that is let pass.
    seeds, seed : int
        How many, and the first.
    moving : bool
        As of `contourlab.loop.simulate_batch`.
    """

    def __init__(
        self,
        machine: Machine,
        controller: Controller,
        reference: Reference,
        figure: str,
        allowed: float,
        seeds: int,
        seed: int,
        moving: bool,
    ) -> None:
        if figure not in FIGURES:
            raise ParameterError("figure", repr(figure), "one of " + ", ".join(FIGURES))
        self.machine, self.controller, self.reference = machine, controller, reference
        self.figure, self.allowed, self.seeds, self.seed, self.moving = figure, allowed, seeds, seed, moving
        links = {(name, way): link for name, mine in controller.axes.items() if mine.link for way, link in _ways(mine.link)}
        self.networks = {key: link for key, link in links.items() if isinstance(link, Network)}
        if not self.networks:
            raise ParameterError("controller.axes", "without a network", 'divided, with a link of kind "network" in one direction at least')
        ideal = undisturbed(unlimited(perfect_sensing(without_friction(machine))))
        self.ideal = ideal
        self.loops = tuple(_linear(machine, controller))

    def by_chance(self, quantity: str) -> bool:
        """Tell whether chance plays a part where a quantity is varied."""
        drawn = any(part.jitter > 0.0 or part.loss > 0.0 for part in self.networks.values())
        return drawn or quantity in ("jitter", "loss")

    def columns(self, quantity: str, values: Array, seeds: int) -> dict[str, Array]:
        """Return what differs between the lanes: each value of all links under each seed."""
        found = {f"controller.axes.{a}.link.{w}.{quantity}": np.repeat(values, seeds) for a, w in self.networks}
        return found | self._streams(seeds, len(values))

    def _streams(self, seeds: int, times: int) -> dict[str, Array]:
        """Return the streams of jitter and loss under each seed, so many times over; none for one seed, which is the run's own."""
        return {
            f"controller.axes.{a}.link.{w}.stream": np.tile([stream_of(self.seed + i, a, f"link.{w}") for i in range(seeds)], times)
            for a, w in (self.networks if seeds > 1 else ())
        }

    def as_given(self) -> float:
        """Return the worst error over the seeds with the links as they are; nan where a run left its limits."""
        seeds = self.seeds if self.by_chance("delay") else 1
        own = {f"controller.axes.{a}.link.{w}.delay": np.full(seeds, part.delay) for (a, w), part in self.networks.items()}
        return float(self._run(self.machine, own | self._streams(seeds, 1), None).max())

    def errors(self, quantity: str, values: Array) -> Array:
        """Return the error of each value under each seed: (n, n_seed)."""
        seeds = self.seeds if self.by_chance(quantity) else 1
        run = self._run(self.machine, self.columns(quantity, values, seeds), None)
        return np.asarray(run.reshape(len(values), seeds))

    def repeats(self, quantity: str, values: Array) -> Array:
        """Return by how much a lap of the ideal machine is worse than the one before."""
        laps = self.reference.laps
        if len(laps) < 2 or self.by_chance(quantity):
            return np.full(len(values), math.nan)
        columns = self.columns(quantity, values, 1)
        before, last = (self._run(self.ideal, columns, lap) for lap in laps[-2:])
        with np.errstate(invalid="ignore", divide="ignore"):
            # What left its limits has grown beyond all bounds.
            return np.asarray(np.where(np.isnan(last), math.inf, last / before), dtype=float)

    def _run(self, machine: Machine, columns: Mapping[str, Array], window: tuple[int, int] | None) -> Array:
        given: dict[str, Any] = {"window": window, "seed": self.seed, "moving": self.moving}
        return simulate_batch(machine, self.controller, self.reference, columns, **given).figures[self.figure]

    def growth(self, quantity: str, value: float, size_limit: int = LARGEST) -> float:
        """Return the growth of the linear model in the worst of a few directions; nan where there is none, or it is too large."""
        if self.by_chance(quantity) or not self.loops:
            return math.nan
        try:
            down, up = (self._timing(way, quantity, value) for way in ("down", "up"))
            size = len(self.loops[0].a) + sum((down if way == "down" else up).taken + 1 for _, way in self.loops[0].links)
            return math.nan if size > size_limit else max(loop.growth(down, up) for loop in self.loops)
        except ComponentError:
            return math.nan

    def _timing(self, way: str, quantity: str, value: float) -> LinkTiming:
        part = next((part for (_, known), part in self.networks.items() if known == way), None)
        return timing_of(None if part is None else part.replace(**{quantity: value}), self.machine.servo_period)


def _ways(link: Division) -> Iterator[tuple[str, Component]]:
    yield "down", link.down
    if link.up is not None:
        yield "up", link.up


def _linear(machine: Machine, controller: Controller) -> Iterator[DividedLoop]:
    """Yield the linear model in each axis' direction and along the diagonal; none where it does not exist or axes differ in their links."""
    links = [mine.link for mine in controller.axes.values() if mine.link is not None]
    if any(link != links[0] for link in links):
        return
    n = len(machine.axes)
    coupled = controller.coupling is not None
    try:
        yield from [divided_loop(machine, controller, t) for t in ([*np.eye(n), np.ones(n)] if coupled else [np.ones(n)])]
    except ComponentError:
        return


def swept(setting: LinkSetting, quantity: str, longest: float) -> LinkSweep:
    """Return the contour error over a quantity of the links, from the least value on, at most to where there is nothing more to find.

    That is where nothing holds over `CHUNK` values, and either the limits of stability are found that can be told or `EACH` values were
    looked at. What the grid of times passes over ahead of a limit, of the error or of stability, is looked at too, to each servo period.

    Parameters
    ----------
    setting : LinkSetting
    quantity : str
        Of `QUANTITIES`.
    longest : float [s]
        Up to where times are looked at.

    Raises
    ------
    ParameterError
        If the quantity is unknown or the longest time below a servo period.
    """
    if quantity not in QUANTITIES:
        raise ParameterError("quantity", repr(quantity), "one of " + ", ".join(QUANTITIES))
    period = setting.machine.servo_period
    values = LOSSES if quantity == "loss" else times(quantity, period, longest)
    parts: list[tuple[Array, ...]] = []
    for i in range(0, len(values), CHUNK):
        chunk = values[i : i + CHUNK]
        parts.append(_looked_at(setting, quantity, chunk, chunk[-1], _unstable_at(parts)))
        found = _joined(setting, quantity, parts, float(values[-1]))
        if not (parts[-1][1] <= setting.allowed).any() and (i + CHUNK >= EACH or not _stable_to_the_end(found)):
            break
    return found if quantity == "loss" else _closed_in(setting, found, parts)


def _looked_at(setting: LinkSetting, quantity: str, values: Array, surely: float, unstable: float) -> tuple[Array, ...]:
    """Return the columns of a sweep at some values, in the order of `COLUMNS`.

    The linear model, if it is large, is worked out at one value only, and never from the first one on at which it is unstable.
    """
    errors = setting.errors(quantity, values)
    growth = np.full(len(values), math.nan)
    for j, value in enumerate(values.tolist()):
        if value >= unstable:
            break
        growth[j] = setting.growth(quantity, value, LARGEST if value == surely else LARGE)
        if growth[j] >= 1.0:
            unstable = value
    worst = np.where(np.isnan(errors).any(axis=1), math.nan, errors.max(axis=1))
    return values, worst, np.median(errors, axis=1), growth, setting.repeats(quantity, values)


def _unstable_at(parts: Sequence[tuple[Array, ...]]) -> float:
    """Return the first value at which the linear model is known to be unstable; infinite if there is none."""
    return min((float(values[growth >= 1.0].min()) for values, _, _, growth, _ in parts if (growth >= 1.0).any()), default=math.inf)


def _stable_to_the_end(sweep: LinkSweep) -> bool:
    """Tell whether the loop is stable as far as was looked, by the linear model or as it was simulated: its limit is farther on."""
    return math.isinf(sweep.stable_linear) or math.isinf(sweep.stable_simulated)


def _joined(setting: LinkSetting, quantity: str, parts: Sequence[tuple[Array, ...]], asked: float) -> LinkSweep:
    """Return one sweep of several parts; of a value in two of them the later one counts."""
    columns = [np.concatenate(column[::-1]) for column in zip(*parts, strict=True)]
    _, order = np.unique(columns[0], return_index=True)
    found = {name: column[order] for name, column in zip(COLUMNS, columns, strict=True)}
    return LinkSweep(quantity, **found, allowed=setting.allowed, asked=asked)


def _closed_in(setting: LinkSetting, sweep: LinkSweep, parts: list[tuple[Array, ...]]) -> LinkSweep:
    """Return a sweep in which no servo period is passed over ahead of a limit."""
    period, tried = setting.machine.servo_period, set[float]()
    while True:
        values, none, grown = sweep.values, np.zeros(len(sweep.values), dtype=bool), sweep.repeats > 1.0 + GROWN
        evenly = passed_over(values, ~sweep.holds, none, period, CHUNK), passed_over(values, grown, np.isnan(sweep.repeats), period, CHUNK)
        wanted, surely = np.setdiff1d(np.concatenate(evenly), values), math.nan
        # One value of the linear model takes as long as many runs.
        middle = passed_over(values, sweep.growth >= 1.0, np.isnan(sweep.growth), period, 1)
        if middle.size and middle[0] not in tried:
            surely = float(middle[0])
            tried.add(surely)
            wanted = np.union1d(wanted, middle)
        if not wanted.size:
            return sweep
        parts.append(_looked_at(setting, sweep.quantity, wanted, surely, _unstable_at(parts)))
        sweep = _joined(setting, sweep.quantity, parts, sweep.asked)
