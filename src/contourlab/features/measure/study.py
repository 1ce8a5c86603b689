"""A measured run held against what was asked for: the same figures that a simulation gives."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from contourlab.app.progress import farthest, progress_along, size_of
from contourlab.errors import ResultError
from contourlab.features.measure.laps import last_lap
from contourlab.features.measure.likely import same_column, unlikely_motion, unlikely_period
from contourlab.features.measure.sample_path import moving, path_of_samples
from contourlab.features.measure.shift import fitted_shift
from contourlab.feed import Reference
from contourlab.geometry import Path
from contourlab.metrics import AxisFigures, CircleFigures, Metrics, Spike, circles_of, judge, reversal_spikes, summarise
from contourlab.result import Result, Signal
from contourlab.scenario.placing import placed

Array = NDArray[np.float64]
ACTUAL = ("tool_position", "position", "axis_position")
"""Signals that say where the tool was, the best first: a measured log has the encoders' alone."""
STILL = 1e-9
"""Metres behind the start of a path, or ahead of its end, from which on the tool is not on it; errors below it are nothing."""
NO_DRIVES = {"reference": "places on the path"}
"""Attribute of a result whose reference is none of the drives', but where the tool was on the path: there is no tracking error."""
ALIKE = 0.5
"""Share of a reference's variance that is in the position of an axis that follows it, lag and all."""


@dataclass(frozen=True, eq=False)
class Measured:
    """A measured run, judged.

    Attributes
    ----------
    result : Result
        With the judge's signals.
    reference : Reference
    metrics : Metrics
        Over the samples at which something was asked to move; axes' tracking errors are not a number where the log says no reference.
    spikes : tuple of Spike
        Of the contour error, where an axis turns.
    circles : tuple of CircleFigures
        Full circles of a given path.
    notes : tuple of str
    """

    result: Result
    reference: Reference
    metrics: Metrics
    spikes: tuple[Spike, ...]
    circles: tuple[CircleFigures, ...]
    notes: tuple[str, ...]


def measure(
    result: Result, path: Path | None = None, axes: tuple[str, ...] | None = None, *, shift: Array | Literal["fit"] | None = None
) -> Measured:
    """Judge a measured run.

    Parameters
    ----------
    result : Result
        With ``position``, the encoders', or another of `ACTUAL`; and ``reference`` unless a path is given.
    path : Path, optional
        What the tool was to follow; by default the path through the samples of the reference.
    axes : tuple of str, optional
        Those that make the contour, in the order of the path's coordinates; by default all that the result has.
    shift : ndarray (n_axis,) [m] or "fit", optional
        Where the zero of the path's coordinates lies in those of the result; ``"fit"`` for where the tool is closest to the path.

    Raises
    ------
    ResultError
        If a signal is missing or not finite, nothing moves, the tool is nowhere near the path, or a shift is asked for without one.
    """
    chosen = _of_axes(result, axes or result.axes)
    position = _position_of(chosen)
    notes = [*unlikely_period(result.servo_period, "the run"), *unlikely_motion(position, result.servo_period, "the tool")]
    of_samples = path is None
    if path is None:
        if shift is not None:
            raise ResultError("a shift is for a path of its own coordinates: the reference is in those of the log already")
        wanted = _reference_of(chosen)
        path, along = path_of_samples(wanted)
    else:
        if shift is not None:
            path, words = _shifted(path, position, shift, chosen.axes)
            notes.append(words)
        along, off = progress_along(path, position)
        notes.append(f"laid along the path by its own progress; nearest {off * 1e6:.3g} um at the start")
        if "reference" in chosen:
            wanted = chosen["reference"]
        else:
            wanted, chosen = path.position(along), replace(chosen, attributes={**chosen.attributes, **NO_DRIVES})
    if not NO_DRIVES.items() <= chosen.attributes.items():
        notes += _unlike(chosen.axes, wanted, position)
    reference = Reference.from_samples(wanted, result.servo_period, path, arc_length=along)
    judged = judge(_with_motion(chosen, position, wanted, along), reference)
    window = moving(wanted)
    if of_samples:
        window, left = _on_the_path(judged, reference, window)
        notes += left
        _check_near(judged["contour_error"][slice(*window)], path, position)
        notes += _on_last_lap(judged, reference, window)
    notes += _of_one_sample(judged, window)
    metrics = _of_what_is_known(summarise(judged, reference, window), chosen, window)
    spikes, circles = reversal_spikes(judged, window, reference=reference), circles_of(judged, reference)
    return Measured(judged, reference, metrics, spikes, circles, tuple(notes))


def _shifted(path: Path, position: Array, shift: Array | Literal["fit"], axes: tuple[str, ...]) -> tuple[Path, str]:
    """Return the path with its zero where it lies in the log, and what there is to say of it."""
    fitted = isinstance(shift, str)
    move = fitted_shift(path, position) if isinstance(shift, str) else shift
    where = ", ".join(f"{axis} {1e3 * value:.6g} mm" for axis, value in zip(axes, move, strict=True))
    return placed(path, move.tolist()), f"the path is shifted by {where}" + (
        ", fitted: a constant offset of the tool is not in the error" if fitted else ""
    )


def _position_of(chosen: Result) -> Array:
    """Return where the tool was (n_sample, n_axis) [m]."""
    actual = next((name for name in ACTUAL if name in chosen), None)
    if actual is None:
        raise ResultError(f"no position in {chosen.source}: say which column is one, such as --column 'position.x=NAME [mm]'")
    position = chosen[actual]
    missing = [axis for axis, column in zip(chosen.axes, position.T, strict=True) if not np.isfinite(column).all()]
    if missing:
        raise ResultError(
            f"no position of {', '.join(missing)} in {chosen.source}: say which column it is, or leave the axis out with --axes"
        )
    return position


def _reference_of(chosen: Result) -> Array:
    if "reference" not in chosen:
        raise ResultError(f"no reference in {chosen.source}: say which columns, or name the part program with --reference part.ngc")
    wanted = chosen["reference"]
    missing = [axis for axis, column in zip(chosen.axes, wanted.T, strict=True) if not np.isfinite(column).any()]
    if missing:
        raise ResultError(
            f"no reference of {', '.join(missing)} in {chosen.source}: say which column it is, such as "
            f"--column 'reference.{missing[0]}=NAME [mm]', or leave the axis out with --axes"
        )
    return wanted


def _check_near(contour: Array, path: Path, position: Array) -> None:
    """Refuse positions that are not on the path of their reference at all, as where columns are exchanged or units differ."""
    rms, size, moved = float(np.sqrt(np.mean(contour**2))), size_of(path), float(np.ptp(position, axis=0).max())
    if rms > farthest(min(size, moved)):
        raise ResultError(
            f"the tool is off the path of its reference by {rms * 1e3:.4g} mm rms, on a path of {size * 1e3:.4g} mm in size, and moves by "
            f"{moved * 1e3:.4g} mm: are the columns of position and reference the right ones, of the same axes, coordinates and units?"
        )


def _unlike(axes: tuple[str, ...], wanted: Array, position: Array) -> list[str]:
    """Remark on axes whose position has little of their reference in it."""
    left, whole = np.var(wanted - position, axis=0), np.var(wanted, axis=0)
    names = ", ".join(axis for axis, off, size in zip(axes, left, whole, strict=True) if off > (1.0 - ALIKE) * size > 0.0)
    said = [f"the position of {names} does not go with its reference: are column, unit and direction right?"] if names else []
    return [*said, *same_column(axes, wanted, position)]


def _with_motion(chosen: Result, position: Array, wanted: Array, along: Array) -> Result:
    """Return the result with the signals that a simulation gives."""
    period = chosen.servo_period
    return chosen.with_signals(
        tool_position=Signal(position, ("sample", "axis"), "m"),
        reference=Signal(wanted, ("sample", "axis"), "m"),
        arc_length=Signal(along, ("sample",), "m"),
        feedrate=Signal(np.abs(np.gradient(along, period)), ("sample",), "m/s"),
        reference_velocity=Signal(np.gradient(wanted, period, axis=0), ("sample", "axis"), "m/s"),
    )


def _on_the_path(judged: Result, reference: Reference, window: tuple[int, int]) -> tuple[tuple[int, int], list[str]]:
    """Return the samples that are judged, and what there is to say of others.

    A log that begins in motion does not hold the path that the tool is on until it comes to where the reference was at the first sample:
    what it is off there is its lag. The same holds for a tool that is ahead where the log ends in motion.
    """
    path, tool, foot = reference.path, judged["tool_position"], judged["foot_arc_length"]
    start, stop = window
    ends = np.array([0.0, path.length])
    behind, ahead = (((tool - at) @ way) for at, way in zip(path.position(ends), path.tangent(ends), strict=True))
    before, beyond = (foot <= 0.0) & (behind < -STILL), (foot >= path.length) & (ahead > STILL)
    first = int(np.argmin(before)) if start == 0 and not before.all() else start
    last = stop - int(np.argmin(beyond[:stop][::-1])) if stop >= len(foot) - 1 and not beyond.all() else stop
    if last - first < 2 or (first, last) == window:
        return window, []
    left = first - start + stop - last
    return (first, last), [f"the log is cut in motion: {left} samples at which the tool is not on the recorded path are left out"]


def _on_last_lap(judged: Result, reference: Reference, window: tuple[int, int]) -> list[str]:
    """Tell the last lap alone, which is what a simulated run is judged by: the first one has the start from rest in it."""
    first = last_lap(reference.path, judged["arc_length"])
    if first is None or not window[0] < first < window[1] - 2:
        return []
    error = np.abs(judged["contour_error"][first : window[1]])
    rms, largest = 1e6 * float(np.sqrt(np.mean(error**2))), 1e6 * float(error.max())
    when = f"from t = {judged.time[first]:.4g} s on"
    return [f"of the last lap alone, {when}, the contour error is {rms:.3g} um rms, {largest:.3g} um at most"]


def _of_one_sample(judged: Result, window: tuple[int, int]) -> list[str]:
    """Ask about a largest error of which no other sample has half: no mass goes there and back between two samples."""
    error = np.abs(judged["contour_error"][slice(*window)])
    worst = int(np.argmax(error))
    rest = float(np.delete(error, worst).max(initial=0.0))
    if rest > 0.5 * error[worst] or error[worst] < STILL:
        return []
    when, others = f"at t = {judged.time[window[0] + worst]:.4g} s", f"all others are below {1e6 * rest:.3g} um"
    return [f"the largest contour error, {when}, is that of one sample alone, {others}: a fault of the log?"]


def _of_what_is_known(metrics: Metrics, chosen: Result, window: tuple[int, int]) -> Metrics:
    """Return the figures without those that the log does not tell."""
    nan = float("nan")
    if NO_DRIVES.items() <= chosen.attributes.items():
        metrics = replace(metrics, tracking_error=(AxisFigures(nan, nan),) * len(chosen.axes))
    if "applied_command" not in chosen:
        metrics = replace(metrics, saturation=(nan,) * len(chosen.axes))
    return replace(metrics, basis="moving part", cycle_time=(window[1] - window[0]) * chosen.servo_period)


def _of_axes(result: Result, axes: tuple[str, ...]) -> Result:
    if len(set(axes)) < len(axes):
        raise ResultError(f"axes {', '.join(axes)}: one is named twice")
    unknown = [axis for axis in axes if axis not in result.axes]
    if unknown:
        raise ResultError(f"no axis {unknown[0]} in {result.source}; there are {', '.join(result.axes)}")
    if axes == result.axes:
        return result
    columns = [result.axes.index(axis) for axis in axes]
    cut = {n: replace(s, data=s.data[:, columns]) if s.data.ndim == 2 else s for n, s in result.signals.items()}
    return replace(result, axes=axes, signals=cut)
