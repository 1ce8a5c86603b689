"""A measured run held against what was asked for: the same figures that a simulation gives."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ResultError
from contourlab.feed import Reference
from contourlab.geometry import Line, Path
from contourlab.metrics import AxisFigures, CircleFigures, Metrics, Spike, circles_of, judge, reversal_spikes, summarise
from contourlab.metrics.judge import reach
from contourlab.result import Result, Signal
from contourlab.studies.progress import progress_along

__all__ = ["Measured", "measure", "moving", "path_of_samples"]

Array = NDArray[np.float64]
ACTUAL = ("tool_position", "position", "axis_position")
"""Signals that say where the tool was, the best first: a measured log has the encoders' alone."""
COARSE = 40
"""Places on either side of the reference's that are looked at for the one nearest to the tool."""
STRAIGHT = 10e-9
"""Metres by which a sample of the reference may be off the path that is laid through them: far below any encoder."""


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


def moving(wanted: Array) -> tuple[int, int]:
    """Return the samples [start, stop) from the first to the last at which positions (n, n_axis) change.

    Raises
    ------
    ResultError
        If they never do.
    """
    changes = np.flatnonzero((np.diff(wanted, axis=0) != 0.0).any(axis=1))
    if not changes.size:
        raise ResultError("nothing is asked to move: the reference is the same at all samples")
    return int(changes[0]), int(changes[-1]) + 1


def path_of_samples(positions: Array) -> tuple[Path, Array]:
    """Return the path through positions (n, n_axis) [m], lines from each to the next, and the arc length [m] of each along it.

    Samples within ten nanometres of a line between others are left out of the path.

    Raises
    ------
    ResultError
        If they are all the same, or not finite.
    """
    if not np.isfinite(positions).all():
        raise ResultError(f"the reference is not finite at sample {int(np.argmin(np.isfinite(positions).all(axis=1)))}")
    moving(positions)
    new = np.append(True, (np.diff(positions, axis=0) != 0.0).any(axis=1))
    points = positions[new]
    arc = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
    kept = _corners(points)
    path = Path([Line(a, b) for a, b in zip(points[kept][:-1], points[kept][1:], strict=True)])
    # The chords that were left out are shorter than the polygon by next to nothing: arc length is that of the path.
    own = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points[kept], axis=0), axis=1)))
    along = np.interp(arc, arc[kept], own)
    return path, along[np.cumsum(new) - 1]


def _corners(points: Array) -> NDArray[np.int64]:
    """Return the points that a polygon needs so that no other is further than `STRAIGHT` from it, each line as long as it can be."""
    kept, at, span, last = [0], 0, 1, len(points) - 1
    while at < last:
        # Twice as far as long as it goes, then halving what is between; lines are about as long as the one before.
        good, bad = 1, last - at + 1
        while good < bad - 1:
            trial = min(span, bad - 1) if span > good else (good + bad) // 2 if bad <= last - at else min(2 * good, bad - 1)
            if _is_line(points[at : at + trial + 1]):
                good, span = trial, 2 * trial
            else:
                bad, span = trial, 0
        at += good
        span = good
        kept.append(at)
    return np.array(kept)


def _is_line(points: Array) -> bool:
    """Tell whether points lie on the line from the first to the last, one behind the other."""
    way = points[-1] - points[0]
    length = float(np.linalg.norm(way))
    if length == 0.0:
        return False
    off = points - points[0]
    along = off @ (way / length)
    if np.any(np.diff(along) < 0.0):
        return False
    return float(((off - np.outer(along, way / length)) ** 2).sum(axis=1).max()) <= STRAIGHT**2


def measure(result: Result, path: Path | None = None, axes: tuple[str, ...] | None = None) -> Measured:
    """Judge a measured run.

    Parameters
    ----------
    result : Result
        With ``position``, the encoders', or another of `ACTUAL`; and ``reference`` unless a path is given.
    path : Path, optional
        What the tool was to follow; by default the path through the samples of the reference.
    axes : tuple of str, optional
        Those that make the contour, in the order of the path's coordinates; by default all that the result has.

    Raises
    ------
    ResultError
        If a signal is missing or not finite, or nothing moves.
    """
    chosen = _of_axes(result, axes or result.axes)
    actual = next((name for name in ACTUAL if name in chosen), None)
    if actual is None:
        raise ResultError(f"no position in {result.scheme}: say which column is one, such as --column 'position.x=NAME [mm]'")
    position = chosen[actual]
    if not np.isfinite(position).all():
        missing = [axis for axis, column in zip(chosen.axes, position.T, strict=True) if not np.isfinite(column).all()]
        raise ResultError(
            f"no position of {', '.join(missing)} in {result.scheme}: say which column it is, or leave the axis out with --axes"
        )
    notes: list[str] = []
    if path is None:
        if "reference" not in chosen:
            raise ResultError(f"no reference in {result.scheme}: say which columns, or name the part program with --reference part.ngc")
        wanted = chosen["reference"]
        path, along = path_of_samples(wanted)
    else:
        along, off = progress_along(path, position)
        wanted = path.position(along)
        notes.append(f"laid along the path by its own progress; nearest {off * 1e6:.3g} um at the start")
        if "reference" in chosen:
            wanted = chosen["reference"]
    reference = Reference.from_samples(wanted, result.servo_period, path, arc_length=along)
    speed = np.gradient(along, result.servo_period)
    whole = chosen.with_signals(
        tool_position=Signal(position, ("sample", "axis"), "m"),
        reference=Signal(wanted, ("sample", "axis"), "m"),
        arc_length=Signal(along, ("sample",), "m"),
        feedrate=Signal(np.abs(speed), ("sample",), "m/s"),
        reference_velocity=Signal(np.gradient(wanted, result.servo_period, axis=0), ("sample", "axis"), "m/s"),
    )
    judged = _judged(whole, reference)
    window = moving(wanted)
    metrics = summarise(judged, reference, window)
    if "reference" not in chosen:
        unknown = AxisFigures(float("nan"), float("nan"))
        metrics = replace(metrics, tracking_error=(unknown,) * len(chosen.axes))
    unsaid = () if "applied_command" in chosen else (float("nan"),) * len(chosen.axes)
    cycle = (window[1] - window[0]) * result.servo_period
    metrics = replace(metrics, basis="moving part", saturation=unsaid or metrics.saturation, cycle_time=cycle)
    spikes, circles = reversal_spikes(judged, window, reference=reference), circles_of(judged, reference)
    return Measured(judged, reference, metrics, spikes, circles, tuple(notes))


def _judged(whole: Result, reference: Reference) -> Result:
    """Return the result judged around the place on the path that is nearest to the tool, within what its reference allows.

    A log's path has as many pieces as the log has samples, and a lagging axis trails far behind its reference: to look through all that
    lies between would take a hundred times as long.
    """
    path, tool, wanted, along = reference.path, whole["tool_position"], whole["reference"], whole["arc_length"]
    near, step = along, reach(path, wanted - tool) / COARSE
    for _ in range(2):
        near, step = _nearest(path, tool, near, step), step / COARSE
    around = whole.with_signals(
        reference=Signal(path.position(near % path.length if path.closed else near), ("sample", "axis"), "m"),
        arc_length=Signal(near, ("sample",), "m"),
    )
    judged = judge(around, reference)
    tracking = Signal(wanted - tool, ("sample", "axis"), "m")
    return judged.with_signals(reference=whole.signals["reference"], arc_length=whole.signals["arc_length"], tracking_error=tracking)


def _nearest(path: Path, tool: Array, along: Array, step: float) -> Array:
    """Return the places on the path [m] nearest to the tool, of `COARSE` steps on either side of those given."""
    best, near = np.full(along.size, np.inf), along.copy()
    for offset in np.arange(-COARSE, COARSE + 1) * step:
        place = along + offset if path.closed else np.clip(along + offset, 0.0, path.length)
        square = ((path.position(place % path.length if path.closed else place) - tool) ** 2).sum(axis=1)
        better = square < best
        best[better], near[better] = square[better], place[better]
    return near


def _of_axes(result: Result, axes: tuple[str, ...]) -> Result:
    unknown = [axis for axis in axes if axis not in result.axes]
    if unknown:
        raise ResultError(f"no axis {unknown[0]} in {result.scheme}; there are {', '.join(result.axes)}")
    if axes == result.axes:
        return result
    columns = [result.axes.index(axis) for axis in axes]
    cut = {n: replace(s, data=s.data[:, columns]) if s.data.ndim == 2 else s for n, s in result.signals.items()}
    return replace(result, axes=axes, signals=cut)
