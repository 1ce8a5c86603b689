"""Summary figures of a run."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from typing import ClassVar

import numpy as np

from contourlab.arrays import Index
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
    cut = judged.samples
    tracking = result["tracking_error"][cut]
    axes = tuple(AxisFigures(float(np.sqrt(np.mean(e**2))), float(np.abs(e).max())) for e in tracking.T)
    saturation = (0.0,) * len(result.axes)
    if "applied_command" in result:
        limits = np.array([float(result.attributes.get(f"command_limit_{axis}", math.inf)) for axis in result.axes])
        saturation = tuple(np.mean(np.abs(result["applied_command"][cut]) >= limits * (1.0 - 1e-12), axis=0).tolist())
    mean, ripple = _feedrate(result, judged)
    cycle = (result.n_sample - 1) * result.servo_period
    names = ("part_error", "contour_error", "planning_deviation")
    part, contour, planning = (_error_figures(result, reference, name, cut) for name in names)
    missed, others = left_out(result, reference, judged)[0], tuple(_others(result, reference, judged))
    time = cut.size * result.servo_period
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
    for name, ranges in (("approach", [(0, first)]), ("rapids", between), ("retract", [(last, result.n_sample)])):
        if moved := tuple((start, stop) for start, stop in ranges if start < stop):
            samples = Judged(moved, name).samples
            size = np.abs(result["part_error"][samples])
            worst = _place(result, reference, samples[size.argmax()])
            yield MoveFigures(name, samples.size * result.servo_period, float(size.max()), worst)


def _place(result: Result, reference: Reference, sample: int) -> Place:
    along = float(result["arc_length"][sample])
    number = int(sample) + result.start
    position = tuple(float(v) for v in result["tool_position"][sample])
    return Place(number, number * result.servo_period, along, position, int(reference.source_line(np.array([along]))[0]))


def _error_figures(result: Result, reference: Reference, name: str, cut: Index) -> ErrorFigures:
    signed = result[name][cut]
    size = np.abs(signed)
    mean = float(signed.mean())
    return ErrorFigures(
        rms=float(np.sqrt(np.mean(size**2))),
        max=float(size.max()),
        mean=float(size.mean()),
        p95=float(np.quantile(size, 0.95)),
        integral=float(size.sum() * result.servo_period),
        signed_mean=mean,
        integral_without_mean=float(np.abs(signed - mean).sum() * result.servo_period),
        worst=_place(result, reference, cut[size.argmax()]),
    )


def _feedrate(result: Result, judged: Judged) -> tuple[float, float]:
    before = np.concatenate([np.arange(start, stop - 1) for start, stop in judged.ranges])
    if before.size < 2:
        return math.nan, math.nan
    tool = result["tool_position"]
    speed = np.linalg.norm(tool[before + 1] - tool[before], axis=1) / result.servo_period
    wanted = result["feedrate"][before] if "feedrate" in result else speed
    steady = (np.abs(np.gradient(wanted)) <= 1e-9 * wanted) & (wanted > 0.0)
    ripple = float(np.std(speed[steady] / wanted[steady])) if np.count_nonzero(steady) > 2 else math.nan
    return float(speed.mean()), ripple


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
    path, cut = reference.programmed, judged.samples
    foot = result["foot_arc_length"][cut]
    commanded = reference.programmed_arc_length(result["arc_length"][cut])
    if path.closed and np.ptp(commanded) > (1.0 - 2.0 / len(commanded)) * path.length:
        foot = np.sort(np.mod(foot, path.length))
        return float(max(np.diff(foot).max(initial=0.0), foot[0] + path.length - foot[-1])), 0.0
    sizes = np.diff(judged.ranges, axis=1)[:, 0]
    begins = np.cumsum(sizes) - sizes
    low, high = (edge.reduceat(commanded, begins) for edge in (np.minimum, np.maximum))
    # Lay the pieces of the path end to end.
    total = np.cumsum(high - low)
    behind = np.repeat(low - (total - (high - low)), sizes)
    seen = np.sort(np.concatenate([[0.0], np.clip(foot, np.repeat(low, sizes), np.repeat(high, sizes)) - behind, total]))
    return float(np.diff(seen).max()), float(seen[-1] - seen[-2])
