"""The contour error over message period, delay, jitter or loss of the links of a divided controller."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import ClassVar

import numpy as np

from contourlab.analysis.linear.divided_loop import DividedLoop, divided_loop, timing_of
from contourlab.app.json_values import HIDDEN
from contourlab.arrays import Array, Flags, Index
from contourlab.components.link.network import Network
from contourlab.errors import ComponentError, ParameterError, check_known, refuse
from contourlab.features.link.options import SEEDS
from contourlab.features.run.causes import perfect_sensing, undisturbed, unlimited, without_friction
from contourlab.feed.reference import Judged
from contourlab.metrics.run_figures import goal_named
from contourlab.study import Setting

LOSSES = np.linspace(0.0, 0.98, 50)
EACH = 128
"""Every multiple of the servo period is tested up to this one."""
FARTHER = 64
"""Values per doubling above `EACH`."""
FEW = (4, 2, 1)
"""Values per doubling of a quick grid, and the multiple of the servo period up to which it has each one: the most that fit."""


def times(quantity: str, period: float, longest: float, few: int = 0) -> Array:
    """Return the times to test [s]: each multiple of the servo period up to `EACH`, then `FARTHER` values per doubling.

    Grids of different length agree where they overlap, so a limit does not depend on `longest`.

    Parameters
    ----------
    quantity : str
        ``message_period`` begins at one servo period, other times begin at 0.
    period, longest : float [s]
        Servo period, and the last value.
    few : int
        For a quick grid, one of `FEW`: it replaces both numbers. 0 for the whole grid.

    Raises
    ------
    ParameterError
        If the longest time is shorter than a servo period.
    """
    refuse(not longest >= period, ParameterError, "longest", f"{longest:g}", f">= the servo period, {period:g}", "s")
    ticks = _multiples(*((few, few) if few else (EACH, FARTHER)), math.floor(longest / period + 1e-9)).astype(float)
    return np.asarray(period * (ticks[1:] if quantity == "message_period" else ticks))


def _multiples(each: int, farther: int, last: int) -> Index:
    """Return 0 and each number up to `each`, then `farther` per doubling, and `last`."""
    parts, start = [np.arange(min(each, last) + 1)], each
    while start < last:
        parts.append(np.arange(start, min(2 * start, last) + 1, start // farther))
        start *= 2
    return np.unique(np.concatenate([*parts, [last]]))


def passed_over(values: Array, bad: Flags, unknown: Flags, period: float, most: int) -> Array:
    """Return multiples of the servo period, evenly spaced, between the last good value and the first bad one.

    Parameters
    ----------
    values : ndarray (n,) [s]
        Increasing.
    bad, unknown : ndarray (n,)
        An unknown value is neither good nor bad.
    period : float [s]
        Servo period.
    most : int
        Largest number of values.

    Examples
    --------
    >>> import numpy as np
    >>> values, no = np.array([0.0, 8.0, 16.0, 24.0]), np.zeros(4, dtype=bool)
    >>> passed_over(values, np.array([False, False, True, False]), no, 1.0, 3).tolist()
    [10.0, 12.0, 14.0]
    """
    first = int(np.argmax(bad))
    good = np.flatnonzero(~unknown[:first])
    if not bad.any() or not good.size:
        return np.zeros(0)
    low, high = (round(value / period) for value in (values[good[-1]], values[first]))
    step = max(1, math.ceil((high - low) / (most + 1)))
    return period * np.arange(low + step, high, step, dtype=float)


QUANTITIES = ("message_period", "delay", "jitter", "loss")
"""Quantities to sweep."""
CHUNK = 32
"""Values that run at once. If none of them holds, the sweep may end."""
LARGE, LARGEST = 200, 700
"""Number of states above which a linear model is evaluated at one value of a chunk only, and above which it is not evaluated."""
COLUMNS = ("values", "error", "median", "growth", "repeats")
GROWN = 0.5
"""Share by which the error of a lap may exceed that of the lap before in a stable loop."""


@dataclass(frozen=True, eq=False)
class LinkSweep:
    """The contour error over one quantity of the links, in SI.

    Attributes
    ----------
    quantity : str
        One of `QUANTITIES`.
    values : ndarray (n,)
        Increasing; times are multiples of the servo period.
    error : ndarray (n,)
        Worst of the seeds; nan where a run left its limits.
    median : ndarray (n,)
        Median of the seeds.
    growth : ndarray (n,)
        Spectral radius of the linear model per tick, in the worst direction of the path; nan where unknown.
    repeats : ndarray (n,)
        Error of the last lap over that of the lap before, on the machine without friction, encoder counts, disturbance and limits; nan
        without two laps, or with jitter or loss.
    allowed : float
        Largest error allowed.
    asked : float
        Largest value requested.
    coarse : bool
        Whether values between the last that holds and the first that fails are not tested.
    """

    quantity: str
    values: Array
    error: Array
    median: Array
    growth: Array
    repeats: Array
    allowed: float = field(metadata=HIDDEN)
    asked: float = math.nan
    coarse: bool = False

    json_derived: ClassVar = ("most", "fails", "rate", "limited", "limited_by", "ended_early", "stable_linear", "stable_simulated")

    @property
    def holds(self) -> Flags:
        """Whether the error is allowed and the linear model is stable or unknown (n,)."""
        return np.asarray((self.error <= self.allowed) & ~(self.growth >= 1.0))

    @property
    def most(self) -> float:
        """The largest value up to which all tested values hold; nan if the first fails.

        With jitter or loss a value between two that hold may fail. A quick sweep therefore wants as much room between its worst seed and
        the limit as between its worst seed and the median, except at the first value, which every sweep tests.
        """
        bad = ~self.holds
        if self.coarse:
            bad[1:] |= ~(2.0 * self.error - self.median <= self.allowed)[1:]
        return _last_before(self.values, bad)

    @property
    def fails(self) -> float:
        """The smallest tested value that fails; nan if all hold."""
        return float(self.values[int(np.argmin(self.holds))]) if self.limited else math.nan

    @property
    def rate(self) -> float:
        """For a message period: the smallest message rate that holds [Hz]; else nan."""
        return 1.0 / self.most if self.quantity == "message_period" else math.nan

    @property
    def limited(self) -> bool:
        """Whether a tested value fails, so that `most` is a limit."""
        return bool((~self.holds).any())

    @property
    def ended_early(self) -> bool:
        """Whether the sweep ended before `asked` because none of the last `CHUNK` values held."""
        return not self.coarse and bool(self.values[-1] < self.asked)

    @property
    def limited_by(self) -> str | None:
        """Why the first failing value fails: ``"runs away"``, ``"error"`` or ``"unstable"``; None if all hold."""
        if not self.limited:
            return None
        worst = float(self.error[int(np.argmin(self.holds))])
        return "runs away" if math.isnan(worst) else "error" if worst > self.allowed else "unstable"

    @property
    def stable_linear(self) -> float:
        """The largest value up to which the linear model is stable; infinite if all values are stable, nan if unknown."""
        return _limit(self.values, self.growth >= 1.0, np.isnan(self.growth))

    @property
    def stable_simulated(self) -> float:
        """The same limit for the simulated machine without friction and limits."""
        return _limit(self.values, self.repeats > 1.0 + GROWN, np.isnan(self.repeats))


def _last_before(values: Array, bad: Flags) -> float:
    first = int(np.argmax(bad)) if bad.any() else len(values)
    return float(values[first - 1]) if first else math.nan


def _limit(values: Array, bad: Flags, unknown: Flags) -> float:
    """Return the last known good value before the first bad one; infinite if all are good to the end, nan if unknown."""
    known = ~unknown
    if bad.any() or not known.any():
        return _last_before(values[known], bad[known])
    return math.inf if known[-1] else math.nan


@dataclass(eq=False)
class LinkSetting:
    """A machine under a divided controller whose links are varied.

    Attributes
    ----------
    divided : Setting
        Its controller needs a network in at least one direction. Its seed is the first.
    figure : str
        One of `contourlab.metrics.run_figures.GOALS`.
    allowed : float
        Largest error allowed.
    seeds : int
        Number of runs with jitter or loss: the worst counts.
    few : int
        For a quick sweep, values per doubling, one of `contourlab.features.link.sweep.FEW`: none between the last that holds and the first
        that fails, and no limits of stability. 0 for a whole sweep.

    Raises
    ------
    ParameterError
        If the figure is unknown, or no link is a network.
    """

    divided: Setting
    figure: str
    allowed: float
    seeds: int = SEEDS
    few: int = 0

    def __post_init__(self) -> None:
        self.figure = goal_named(self.figure, "figure").name
        axes = self.divided.controller.axes.items()
        links = [(name, way, getattr(axis.link, way)) for name, axis in axes if axis.link for way in ("down", "up")]
        self.networks = {(name, way): link for name, way, link in links if isinstance(link, Network)}
        if not self.networks:
            raise ParameterError("controller.axes", "without a network", 'divided, with a link of kind "network" in at least one direction')
        self.ideal = undisturbed(unlimited(perfect_sensing(without_friction(self.divided.machine, self.divided.controller)[0])))

    @cached_property
    def loops(self) -> tuple[DividedLoop, ...]:
        """Linear models along each axis and the diagonal; empty without a model, or if the axes have different links."""
        machine, controller = self.divided.machine, self.divided.controller
        links = [mine.link for mine in controller.axes.values() if mine.link is not None]
        if any(link != links[0] for link in links):
            return ()
        n = len(machine.axes)
        directions = [np.ones(n)] if controller.coupling is None else [*np.eye(n), np.ones(n)]
        with suppress(ComponentError):
            return tuple(divided_loop(machine, controller, along) for along in directions)
        return ()

    def by_chance(self, quantity: str) -> bool:
        """Return whether jitter or loss is drawn at random while a quantity is varied."""
        drawn = any(part.jitter > 0.0 or part.loss > 0.0 for part in self.networks.values())
        return drawn or quantity in ("jitter", "loss")

    def runs(self, quantity: str) -> int:
        """Return the number of runs of each value while a quantity is varied."""
        return self.seeds if self.by_chance(quantity) else 1

    def values(self, quantity: str, longest: float) -> Array:
        """Return the values of a quantity to test, up to a longest time [s]."""
        if quantity != "loss":
            return times(quantity, self.divided.machine.servo_period, longest, self.few)
        half = max(self.few // 2, 1)
        return LOSSES[_multiples(half, half, len(LOSSES) - 1)] if self.few else LOSSES

    def batches(self, quantities: Sequence[str], longest: float) -> int:
        """Return the largest number of batches of `CHUNK` runs that a quick sweep of some quantities takes."""
        return 1 + sum(math.ceil(len(self.values(name, longest)) / max(CHUNK // self.runs(name), 1)) for name in quantities)

    def columns(self, quantity: str, values: Array, seeds: int) -> dict[str, Array]:
        """Return the parameter values of the lanes: each value, on all links, for each seed."""
        return {f"controller.axes.{a}.link.{w}.{quantity}": np.repeat(values, seeds) for a, w in self.networks}

    def as_given(self) -> float:
        """Return the worst error over the seeds with the links as given; nan if a run left its limits."""
        seeds = self.runs("delay")
        own = {f"controller.axes.{a}.link.{w}.delay": np.full(seeds, part.delay) for (a, w), part in self.networks.items()}
        return float(self._run(self.divided, own, seeds).max())

    def errors(self, quantity: str, values: Array) -> Array:
        """Return the error of each value for each seed (n, n_seed)."""
        seeds = self.runs(quantity)
        run = self._run(self.divided, self.columns(quantity, values, seeds), seeds)
        return np.asarray(run.reshape(len(values), seeds))

    def repeats(self, quantity: str, values: Array) -> Array:
        """Return the error of a lap of the ideal machine over that of the lap before."""
        laps, reference = self.divided.reference.laps, self.divided.reference
        if len(laps) < 2 or self.few or self.by_chance(quantity):
            return np.full(len(values), math.nan)
        columns = self.columns(quantity, values, 1)
        of_laps = (replace(reference, chosen=Judged((lap,), "lap")) for lap in laps[-2:])
        before, last = (self._run(replace(self.divided, machine=self.ideal, reference=of_lap), columns) for of_lap in of_laps)
        with np.errstate(invalid="ignore", divide="ignore"):
            # A run that left its limits counts as infinite growth.
            return np.asarray(np.where(np.isnan(last), math.inf, last / before), dtype=float)

    def _run(self, setting: Setting, columns: Mapping[str, Array], seeds: int = 1) -> Array:
        """Return the error of each lane; the lanes take the seeds in turns."""
        drawn = [setting.seed + i % seeds for i in range(len(next(iter(columns.values()))))]
        return setting.batch(columns, [self.figure], seed=drawn).figures[self.figure]

    def growth(self, quantity: str, value: float, size_limit: int = LARGEST) -> float:
        """Return the growth of the linear model in the worst of a few directions; nan without a model or if it is too large."""
        if self.by_chance(quantity) or not self.loops:
            return math.nan
        try:
            parts = {way: part.replace(**{quantity: value}) for (_, way), part in self.networks.items()}
            timing = {way: timing_of(parts.get(way), self.divided.machine.servo_period) for way in ("down", "up")}
            size = len(self.loops[0].a) + sum(timing[way].taken + 1 for _, way in self.loops[0].links)
            return math.nan if size > size_limit else max(loop.growth(**timing) for loop in self.loops)
        except ComponentError:
            return math.nan


def swept(setting: LinkSetting, quantity: str, longest: float) -> LinkSweep:
    """Sweep a quantity of the links from its smallest value.

    The sweep ends early if the error is too large at all `CHUNK` values of a chunk, and either the stability limits are found or `EACH`
    values are tested. Multiples of the servo period between the last value that holds and the first that fails are then tested too.
    A quick sweep tests fewer values, and ends soon after the first that fails.

    Parameters
    ----------
    setting : LinkSetting
    quantity : str
        One of `QUANTITIES`.
    longest : float [s]
        Largest time to test.

    Raises
    ------
    ParameterError
        If the quantity is unknown or the longest time is shorter than a servo period.
    """
    check_known("quantity", quantity, QUANTITIES)
    values, coarse = setting.values(quantity, longest), setting.few > 0
    size = max(CHUNK // setting.runs(quantity), 1) if coarse else CHUNK
    table = np.empty((len(COLUMNS), 0))
    for i in range(0, len(values), size):
        chunk = values[i : i + size]
        table = _tested(setting, quantity, chunk, chunk[-1], table)
        columns = dict(zip(COLUMNS, table, strict=True))
        found = LinkSweep(quantity, **columns, allowed=setting.allowed, asked=float(values[-1]), coarse=coarse)
        if coarse and found.limited:
            break
        stable = math.isinf(found.stable_linear) or math.isinf(found.stable_simulated)  # to the end: the limit lies beyond
        if not (found.error[-len(chunk) :] <= setting.allowed).any() and (i + size >= EACH or not stable):
            break
    return found if coarse or quantity == "loss" else _closed_in(setting, found, table)


def _tested(setting: LinkSetting, quantity: str, values: Array, surely: float, table: Array) -> Array:
    """Return a table, whose rows are `COLUMNS`, with the results at further values; they replace those at equal values.

    A large linear model is evaluated only at the value `surely`. No model is evaluated from the first unstable value on, nor, in a quick
    sweep, from the first value whose error is too large.
    """
    errors = setting.errors(quantity, values)
    worst = np.where(np.isnan(errors).any(axis=1), math.nan, errors.max(axis=1))
    growth = np.full(len(values), math.nan)
    unstable = table[0, table[3] >= 1.0].min(initial=math.inf)
    for j, value in enumerate(values.tolist()):
        if value >= unstable or (setting.few and not worst[j] <= setting.allowed):
            break
        growth[j] = setting.growth(quantity, value, LARGEST if value == surely else LARGE)
        if growth[j] >= 1.0:
            unstable = value
    new = np.array([values, worst, np.median(errors, axis=1), growth, setting.repeats(quantity, values)])
    joined = np.hstack([new, table])
    return np.asarray(joined[:, np.unique(joined[0], return_index=True)[1]])


def _closed_in(setting: LinkSetting, sweep: LinkSweep, table: Array) -> LinkSweep:
    """Test every servo period between the last good value and the first bad one."""
    period, tried = setting.divided.machine.servo_period, set[float]()
    while True:
        values, none, grown = sweep.values, np.zeros(len(sweep.values), dtype=bool), sweep.repeats > 1.0 + GROWN
        evenly = passed_over(values, ~sweep.holds, none, period, CHUNK), passed_over(values, grown, np.isnan(sweep.repeats), period, CHUNK)
        wanted, surely = np.setdiff1d(np.concatenate(evenly), values), math.nan
        # Evaluating the linear model at one value costs as much as many runs.
        middle = passed_over(values, sweep.growth >= 1.0, np.isnan(sweep.growth), period, 1)
        if middle.size and middle[0] not in tried:
            surely = float(middle[0])
            tried.add(surely)
            wanted = np.union1d(wanted, middle)
        if not wanted.size:
            return sweep
        table = _tested(setting, sweep.quantity, wanted, surely, table)
        sweep = replace(sweep, **dict(zip(COLUMNS, table, strict=True)))
