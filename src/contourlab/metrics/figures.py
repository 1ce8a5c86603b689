"""Summary figures of a run."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any, ClassVar

import numpy as np

from contourlab.arrays import BLOCK, Array, Index, ranges
from contourlab.errors import ResultError
from contourlab.feed import Reference
from contourlab.feed.reference import CUTTING, LAST_LAP, Judged
from contourlab.figures import figure
from contourlab.metrics.judge import check_reference
from contourlab.notebook import Figure, Frame, bars, facts_line, facts_table, frame, grid, svg
from contourlab.result import Result


@dataclass(frozen=True, slots=True)
class Place:
    """Where an error is largest.

    Attributes
    ----------
    sample : int
    time : float [s]
    arc_length : float [m]
        Progress of the reference.
    position : tuple of float [m]
        Of the tool, by axis.
    line : int
        Program line; 0 for none.
    """

    sample: int
    time: float
    arc_length: float
    position: tuple[float, ...]
    line: int


@dataclass(frozen=True, slots=True)
class ErrorFigures:
    """An error over the evaluated samples.

    Attributes
    ----------
    rms, max, mean, p95 : float [m]
        Figures of the magnitude; p95 is its 95 % quantile.
    integral : float [m s]
        Sum of the magnitude times the servo period.
    signed_mean : float [m]
        Mean of the signed error: the radius error on a circle. Mean magnitude on a path in space.
    integral_without_mean : float [m s]
        As `integral`, after subtraction of the signed mean.
    worst : Place
    """

    rms: float
    max: float
    mean: float
    p95: float
    integral: float
    signed_mean: float
    integral_without_mean: float
    worst: Place


@dataclass(frozen=True, slots=True)
class MoveFigures:
    """Moves that are not judged.

    Attributes
    ----------
    moves : {"approach", "rapids", "retract"}
    time : float [s]
    max : float [m]
        Largest part error.
    worst : Place
    """

    moves: str
    time: float
    max: float
    worst: Place


@dataclass(frozen=True, slots=True)
class AxisFigures:
    """Tracking error of an axis.

    Attributes
    ----------
    rms, max : float [m]
        Of the magnitude.
    """

    rms: float
    max: float


@dataclass(frozen=True, slots=True, repr=False)
class Metrics:
    """Figures of a run.

    Attributes
    ----------
    judged : Judged
        The samples that all figures but `cycle_time` cover.
    axes : tuple of str
        Names of the axes.
    judged_time : float [s]
        Their duration.
    part_error, contour_error, planning_deviation : ErrorFigures
    tracking_error : tuple of AxisFigures
        One for each axis.
    saturation : tuple of float
        Fraction of the samples, 0 to 1, at which the drive was saturated, for each axis.
    left_out : float [m]
        Longest piece of the programmed path that the tool missed; see `left_out`.
    feedrate_mean : float [m/s]
        Mean speed of the tool along its path.
    feedrate_ripple : float
        Standard deviation of tool speed over reference speed, where the latter is constant.
    cycle_time : float [s]
        Duration of the whole motion.
    others : tuple of MoveFigures
        The moves that are not judged, where only cutting moves are.
    """

    json_derived: ClassVar = ("basis",)

    judged: Judged = field(metadata={"json": False})
    axes: tuple[str, ...] = field(metadata={"json": False})
    judged_time: float
    part_error: ErrorFigures
    contour_error: ErrorFigures
    planning_deviation: ErrorFigures
    tracking_error: tuple[AxisFigures, ...]
    saturation: tuple[float, ...]
    left_out: float
    feedrate_mean: float
    feedrate_ripple: float
    cycle_time: float
    others: tuple[MoveFigures, ...] = ()

    @property
    def basis(self) -> str:
        """What is judged, such as "cutting moves"."""
        return self.judged.basis

    @property
    def _errors(self) -> dict[str, ErrorFigures]:
        """The errors from the path, by name."""
        return {"part error": self.part_error, "contour error": self.contour_error, "planning deviation": self.planning_deviation}

    @property
    def _tracking(self) -> dict[str, AxisFigures]:
        return {f"tracking error {axis}": figures for axis, figures in zip(self.axes, self.tracking_error, strict=True)}

    def to_pandas(self) -> Frame:
        """Return a row for each error and a column for each figure of `ErrorFigures`, in SI; the worst place as time [s] and line."""
        names = ("rms", "max", "mean", "p95", "integral", "signed_mean", "integral_without_mean")
        rows: list[dict[str, float]] = [
            {name: getattr(error, name) for name in names} | {"worst_time": error.worst.time, "worst_line": error.worst.line}
            for error in self._errors.values()
        ]
        rows += [{"rms": axis.rms, "max": axis.max} for axis in self._tracking.values()]
        columns = {name: [row.get(name, math.nan) for row in rows] for name in rows[0]}
        return frame(columns, [*self._errors, *self._tracking], "error")

    def plot(self) -> Figure:
        """Draw the largest and the rms value of each error [um]."""
        pairs = {name: (1e6 * error.max, 1e6 * error.rms) for name, error in self._errors.items()}
        pairs |= {name: (1e6 * axis.max, 1e6 * axis.rms) for name, axis in self._tracking.items()}
        return bars("error [um]", pairs, ("largest", "rms"))

    def __repr__(self) -> str:
        errors = {name: f"{figure(error.max, 'um')} largest, {figure(error.rms, 'um')} rms" for name, error in self._errors.items()}
        return facts_line("Metrics", {**errors, "judged": self.basis})

    def _repr_html_(self) -> str:
        rows = {
            name: [figure(value, "um") for value in (error.rms, error.p95, error.max)]
            + [figure(error.worst.time, "s", 5), str(error.worst.line or "")]
            for name, error in self._errors.items()
        }
        rows |= {name: [figure(axis.rms, "um"), "", figure(axis.max, "um"), "", ""] for name, axis in self._tracking.items()}
        facts = {
            "judged": f"{self.basis}, {figure(self.judged_time, 's', 4)}",
            "cycle time": figure(self.cycle_time, "s", 5),
            "mean feedrate": figure(self.feedrate_mean, "mm/min", 4),
            "feedrate ripple": figure(self.feedrate_ripple, "%"),
            "saturated": ", ".join(f"{axis} {figure(part, '%')}" for axis, part in zip(self.axes, self.saturation, strict=True)),
        }
        return grid(("", "rms", "95 %", "largest", "at", "line"), rows) + facts_table(facts) + svg(self.plot())


def summarise(result: Result, reference: Reference, window: tuple[int, int] | Judged | None = None) -> Metrics:
    """Return the figures of a judged run.

    Parameters
    ----------
    result : Result
        With the judge's signals.
    reference : Reference
    window : (int, int) or Judged, optional
        Samples [start, stop) to judge, or several such ranges; by default those of `Reference.judged`.

    Returns
    -------
    Metrics

    Raises
    ------
    ResultError
        If the run has not been judged, the window is empty, or the result is of another reference.
    """
    check_reference(result, reference)
    judged = judged_part(result, reference) if window is None else window if isinstance(window, Judged) else Judged((window,), "window")
    first, last = judged.ranges[0][0], judged.ranges[-1][1]
    if not 0 <= first < last <= result.n_sample:
        raise ResultError(f"window {first} .. {last} of a result of {result.n_sample} samples: give a non-empty part of it")
    n, (squares,) = count_of(judged), total(result, "tracking_error", judged, np.square)
    most = np.max([np.abs(result["tracking_error"][cut]).max(axis=0) for cut in blocks_of(judged)], axis=0)
    limits = np.array([float(result.attributes.get(f"command_limit_{axis}", math.inf)) for axis in result.axes]) * (1.0 - 1e-12)
    known = "applied_command" in result
    (limited,) = total(result, "applied_command", judged, lambda command: np.abs(command) >= limits) if known else np.zeros((1, len(most)))
    axes, saturation = tuple(map(AxisFigures, np.sqrt(squares / n).tolist(), most.tolist())), tuple((limited / n).tolist())
    mean, ripple = _feedrate(result, judged)
    cycle = (result.n_sample - 1) * result.servo_period
    names = ("part_error", "contour_error", "planning_deviation")
    part, contour, planning = (_error_figures(result, reference, name, judged) for name in names)
    missed, others = left_out(result, reference, judged)[0], tuple(_others(result, reference, judged))
    time = n * result.servo_period
    return Metrics(judged, result.axes, time, part, contour, planning, axes, saturation, missed, mean, ripple, cycle, others)


def judged_part(result: Result, reference: Reference) -> Judged:
    """Return the samples of a result to judge; of a part of a run with laps, the last whole one."""
    first, stop = result.start, result.start + result.n_sample
    judged = reference.judged
    if judged.basis == LAST_LAP and reference.laps:
        judged = Judged(tuple(lap for lap in reference.laps if first <= lap[0] and lap[1] <= stop)[-1:], LAST_LAP)
    return judged.within(first, result.n_sample)


def _others(result: Result, reference: Reference, judged: Judged) -> Iterator[MoveFigures]:
    """Yield the figures of the rapid moves before, between and after the cutting moves."""
    if judged.basis != CUTTING:
        return
    first, last = judged.ranges[0][0], judged.ranges[-1][1]
    between = [(before[1], after[0]) for before, after in pairwise(judged.ranges)]
    for name, spans in (("approach", [(0, first)]), ("rapids", between), ("retract", [(last, result.n_sample)])):
        if moved := tuple((start, stop) for start, stop in spans if start < stop):
            part = Judged(moved, name)
            size, sample = largest(result, "part_error", part)
            yield MoveFigures(name, count_of(part) * result.servo_period, size, _place(result, reference, sample))


def count_of(judged: Judged) -> int:
    """Return the number of judged samples."""
    return sum(stop - start for start, stop in judged.ranges)


def _part_of(judged: Judged, first: int, last: int) -> Index:
    """Return the numbers of the judged samples [first, last), counted from the first one judged."""
    start, stop = np.array(judged.ranges, dtype=np.int64).T
    ends = np.cumsum(stop - start)
    low, high = (np.clip(edge, ends - (stop - start), ends) for edge in (first, last))
    return ranges(stop - ends + low, high - low)


def blocks_of(judged: Judged) -> Iterator[Index]:
    """Yield the numbers of the judged samples in blocks, so that memory does not grow with them."""
    yield from (_part_of(judged, first, first + BLOCK) for first in range(0, count_of(judged), BLOCK))


def range_of(judged: Judged, samples: Index) -> Index:
    """Return the number of the range, from 1, that each sample (n,) is in; 0 for none."""
    begins, stops = np.array(judged.ranges, dtype=np.int64).T
    number = np.searchsorted(begins, samples, side="right")
    return np.where(samples < stops[number - 1], number, 0)


def total(result: Result, name: str, judged: Judged, *of: Callable[[Array], Any]) -> Array:
    """Return the sums of functions of a signal over judged samples: each a number, or one for each axis."""
    blocks = (result[name][cut] for cut in blocks_of(judged))
    return np.asarray(sum(np.array([np.ascontiguousarray(each(part).T).sum(axis=-1) for each in of]) for part in blocks))


def largest(result: Result, name: str, judged: Judged) -> tuple[float, int]:
    """Return the largest magnitude of a signal over judged samples, and the first sample that has it."""
    sizes = ((np.abs(result[name][cut]), cut) for cut in blocks_of(judged))
    peaks = [(float(size.max()), int(cut[size.argmax()])) for size, cut in sizes]
    return peaks[int(np.argmax([size for size, _ in peaks]))]


def _place(result: Result, reference: Reference, sample: int) -> Place:
    along = float(result["arc_length"][sample])
    number = int(sample) + result.start
    position = tuple(float(v) for v in result["tool_position"][sample])
    return Place(number, number * result.servo_period, along, position, int(reference.source_line(np.array([along]))[0]))


def _error_figures(result: Result, reference: Reference, name: str, judged: Judged) -> ErrorFigures:
    n, highest = count_of(judged), np.empty(0)
    rank = 0.95 * (n - 1)
    above = n - int(rank)  # samples from the one below the quantile on
    for cut in blocks_of(judged):
        highest = np.append(highest, np.abs(result[name][cut]))
        highest = np.partition(highest, max(highest.size - above, 0))[-above:]
    size, square, signed = total(result, name, judged, np.abs, np.square, np.asarray)
    (off,) = total(result, name, judged, lambda error: np.abs(error - signed / n))
    most, sample = largest(result, name, judged)
    return ErrorFigures(
        rms=math.sqrt(square / n),
        max=most,
        mean=float(size / n),
        p95=float(np.quantile(np.sort(highest)[:2], rank - int(rank))),
        integral=float(size * result.servo_period),
        signed_mean=float(signed / n),
        integral_without_mean=float(off * result.servo_period),
        worst=_place(result, reference, sample),
    )


def _feedrate(result: Result, judged: Judged) -> tuple[float, float]:
    moves = Judged(tuple((start, stop - 1) for start, stop in judged.ranges if start < stop - 1), judged.basis)
    n = count_of(moves)
    if n < 2:
        return math.nan, math.nan

    def speeds() -> Iterator[tuple[Array, Array]]:
        """Yield the speeds of the next samples, and speed over reference speed where the latter is constant."""
        for first in range(0, n, BLOCK):
            here, own = _part_of(moves, first - 1, first + BLOCK + 1), int(first > 0)
            inside = slice(own, own + BLOCK)
            speed = np.linalg.norm(result["tool_position"][here + 1] - result["tool_position"][here], axis=1) / result.servo_period
            wanted = result["feedrate"][here] if "feedrate" in result else speed
            steady = np.flatnonzero(((np.abs(np.gradient(wanted)) <= 1e-9 * wanted) & (wanted > 0.0))[inside]) + inside.start
            yield speed[inside], speed[steady] / wanted[steady]

    total, share, count = (sum(parts) for parts in zip(*((speed.sum(), of.sum(), of.size) for speed, of in speeds()), strict=True))
    ripple = math.sqrt(sum(np.sum((of - share / count) ** 2) for _, of in speeds()) / count) if count > 2 else math.nan
    return float(total / n), ripple


def left_out(result: Result, reference: Reference, judged: Judged) -> tuple[float, float]:
    """Return the longest piece [m] of the commanded part of the programmed path that has no foot point of the tool.

    Parameters
    ----------
    result : Result
        With the judge's ``foot_arc_length``.
    judged : Judged
        On a whole lap, places before the start count as the end of the lap.

    Returns
    -------
    longest, at_end : float [m]
        The longest piece of all, and the one at the end of the motion; the latter is 0 on a whole lap.

    Notes
    -----
    A tool that follows misses only the path between two samples, what it cuts off at a corner, and its lag at the ends of the motion.
    """
    path, n = reference.programmed, count_of(judged)
    low, high = np.full(len(judged.ranges), np.inf), np.full(len(judged.ranges), -np.inf)

    def blocks(signal: str) -> Iterator[tuple[Array, Index]]:
        """Yield the next judged samples of a signal, and the range of each."""
        yield from ((result[signal][cut], range_of(judged, cut) - 1) for cut in blocks_of(judged))

    for along, of in blocks("arc_length"):
        commanded = reference.programmed_arc_length(along)
        np.minimum.at(low, of, commanded)
        np.maximum.at(high, of, commanded)
    if path.closed and high.max() - low.min() > (1.0 - 2.0 / n) * path.length:
        first, last, longest, _ = _gaps(lambda: (np.mod(foot, path.length) for foot, _ in blocks("foot_arc_length")))
        return max(longest, first + path.length - last), 0.0
    # Lay the pieces of the path end to end.
    total = np.cumsum(high - low)
    behind = low - (total - (high - low))

    def laid() -> Iterator[Array]:
        """Yield the ends of the pieces, and the foot points."""
        yield np.append(0.0, total)
        yield from (np.clip(foot, low[of], high[of]) - behind[of] for foot, of in blocks("foot_arc_length"))

    _, _, longest, at_end = _gaps(laid)
    return longest, at_end


def _gaps(blocks: Callable[[], Iterator[Array]]) -> tuple[float, float, float, float]:
    """Return the lowest and highest of all values in blocks, the largest gap between neighbours, and the last one.

    What lies below all later blocks is final: of values that come nearly in order, few are held.
    """
    least = [float(block.min()) for block in blocks()]
    longest, held = 0.0, np.empty(0)
    for block, coming in zip(blocks(), np.minimum.accumulate([np.inf, *least[:0:-1]])[::-1], strict=True):
        held = np.sort(np.concatenate([held, block]))
        final = int(np.searchsorted(held, coming))
        longest = max(longest, float(np.diff(held[:final]).max(initial=0.0)))
        held = held[max(final - 2, 0) :]
    return min(least), float(held[-1]), longest, float(np.diff(held[-2:]).sum())
