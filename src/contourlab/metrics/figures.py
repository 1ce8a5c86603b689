"""Summary figures of a run."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Flags
from contourlab.errors import ResultError
from contourlab.feed import Reference
from contourlab.result import Result


@dataclass(frozen=True, slots=True)
class Place:
    """Sample, time [s], arc length [m], position [m] and program line (0 if none)."""

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
class AxisFigures:
    """Tracking error of an axis [m]: rms and max of the magnitude."""

    rms: float
    max: float


@dataclass(frozen=True, slots=True)
class Metrics:
    """Figures of a run.

    Attributes
    ----------
    window : (int, int)
        Evaluated samples [start, stop).
    basis : str
        "last lap", "whole motion" or "window".
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
    """

    window: tuple[int, int]
    basis: str
    part_error: ErrorFigures
    contour_error: ErrorFigures
    planning_deviation: ErrorFigures
    tracking_error: tuple[AxisFigures, ...]
    saturation: tuple[float, ...]
    left_out: float
    feedrate_mean: float
    feedrate_ripple: float
    cycle_time: float


def evaluation_window(reference: Reference, n_sample: int, first: int = 0) -> tuple[tuple[int, int], str]:
    """Return the samples to evaluate, the last whole lap or all, and the name of that choice.

    The result holds `n_sample` samples of the run from sample `first` on; the window is counted from there.
    """
    laps = [(start - first, stop - first) for start, stop in reference.laps if first <= start and stop <= first + n_sample]
    return (laps[-1], "last lap") if laps else ((0, n_sample), "whole motion")


def summarise(result: Result, reference: Reference, window: tuple[int, int] | None = None) -> Metrics:
    """Return the figures of a judged run.

    Parameters
    ----------
    result : Result
        With the judge's signals.
    reference : Reference
    window : (int, int), optional
        Samples [start, stop) to evaluate; by default the last lap, or the whole motion.

    Raises
    ------
    ResultError
        If the run has not been judged, or the window is empty.
    """
    chosen, basis = (window, "window") if window else evaluation_window(reference, result.n_sample, result.start)
    start, stop = chosen
    if not 0 <= start < stop <= result.n_sample:
        raise ResultError(f"window {start} .. {stop} of a result of {result.n_sample} samples: give a non-empty part of it")
    cut = slice(start, stop)
    period = result.servo_period
    tracking = result["tracking_error"][cut]
    axes = tuple(AxisFigures(float(np.sqrt(np.mean(e**2))), float(np.abs(e).max())) for e in tracking.T)
    saturation = tuple(float(np.mean(row)) for row in _saturated(result, cut).T)
    mean, ripple = _feedrate(result, cut)
    cycle = (result.n_sample - 1) * period
    names = ("part_error", "contour_error", "planning_deviation")
    part, contour, planning = (_error_figures(result, reference, name, start, stop) for name in names)
    return Metrics(chosen, basis, part, contour, planning, axes, saturation, left_out(result, reference, chosen)[0], mean, ripple, cycle)


def _error_figures(result: Result, reference: Reference, name: str, start: int, stop: int) -> ErrorFigures:
    signed = result[name][start:stop]
    size = np.abs(signed)
    mean = float(signed.mean())
    sample = start + int(np.argmax(size))
    along = float(result["arc_length"][sample])
    place = Place(
        sample + result.start,
        (sample + result.start) * result.servo_period,
        along,
        tuple(float(v) for v in result["tool_position"][sample]),
        int(reference.source_line(np.array([along]))[0]),
    )
    return ErrorFigures(
        rms=float(np.sqrt(np.mean(size**2))),
        max=float(size.max()),
        mean=float(size.mean()),
        p95=float(np.quantile(size, 0.95)),
        integral=float(size.sum() * result.servo_period),
        signed_mean=mean,
        integral_without_mean=float(np.abs(signed - mean).sum() * result.servo_period),
        worst=place,
    )


def _saturated(result: Result, cut: slice) -> Flags:
    """Return where each drive was at the limit that the run recorded."""
    saturated = np.zeros((cut.stop - cut.start, len(result.axes)), dtype=bool)
    if "applied_command" in result:
        for j, axis in enumerate(result.axes):
            limit = float(result.attributes.get(f"command_limit_{axis}", math.inf))
            saturated[:, j] = np.abs(result["applied_command"][cut, j]) >= limit * (1.0 - 1e-12)
    return saturated


def _feedrate(result: Result, cut: slice) -> tuple[float, float]:
    tool = result["tool_position"][cut]
    if len(tool) < 3:
        return math.nan, math.nan
    speed = np.linalg.norm(np.diff(tool, axis=0), axis=1) / result.servo_period
    wanted = result["feedrate"][cut][:-1] if "feedrate" in result else speed
    steady = (np.abs(np.gradient(wanted)) <= 1e-9 * wanted) & (wanted > 0.0)
    ripple = float(np.std(speed[steady] / wanted[steady])) if np.count_nonzero(steady) > 2 else math.nan
    return float(speed.mean()), ripple


def left_out(result: Result, reference: Reference, window: tuple[int, int]) -> tuple[float, float]:
    """Return the longest piece [m] of the commanded part of the programmed path that has no foot point of the tool.

    Parameters
    ----------
    result : Result
        With the judge's ``foot_arc_length``.
    reference : Reference
    window : (int, int)
        Samples [start, stop) to evaluate. On a whole lap, places before the start count as the end of the lap.

    Returns
    -------
    longest, at_end : float [m]
        The longest piece of all, and the one at the end of the motion; the latter is 0 on a whole lap.

    Notes
    -----
    A tool that follows misses only the path between two samples, what it cuts off at a corner, and its lag at the ends of the motion.
    """
    cut = slice(*window)
    path = reference.programmed
    foot = result["foot_arc_length"][cut]
    commanded = reference.programmed_arc_length(result["arc_length"][cut])
    if path.closed and np.ptp(commanded) > (1.0 - 2.0 / len(commanded)) * path.length:
        foot = np.sort(np.mod(foot, path.length))
        return float(max(np.diff(foot).max(initial=0.0), foot[0] + path.length - foot[-1])), 0.0
    low, high = commanded.min(), commanded.max()
    seen = np.concatenate([[low], np.sort(np.clip(foot, low, high)), [high]])
    return float(np.diff(seen).max()), float(high - seen[-2])
