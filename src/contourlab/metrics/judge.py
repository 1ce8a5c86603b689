"""The judge: three separate errors, from true positions and the path alone.

- `planning_deviation`: reference to programmed path, caused by blending;
- `contour_error`: tool to planned path, caused by the servo loops;
- `part_error`: tool to programmed path, limited by a tolerance.

Each is the exact shortest distance, searched near the progress of the reference, which selects the right branch where a path meets itself.
In the plane it is signed, positive to the left of the direction of travel; in space it is a magnitude.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Flags
from contourlab.errors import DivergenceError, ResultError
from contourlab.feed import Reference
from contourlab.geometry import Path
from contourlab.geometry.foot_point import CHUNK, gaps
from contourlab.result import Result, Signal
from contourlab.threads import in_threads

MARGIN = 1e-4
PLACE = "programmed_place"
"""While a run is judged: the arc length on the programmed path that the reference is nearest to."""
_STILL = 0.9


def furthest(off: Array) -> float:
    """Return the largest length [m] of some differences (n, n_axis) [m]."""
    return math.sqrt(squares(off).max(initial=0.0))


def squares(off: Array) -> Array:
    """Return the squared lengths (n,) [m^2] of some differences (n, n_axis) [m]."""
    return np.asarray(np.einsum("ij,ij->i", off, off))


def reach(path: Path, error: float) -> float:
    """Return the search window [m] of foot points: three times the largest tracking error [m] plus 0.1 mm, at most half of a closed path.

    The foot point of a tool at the distance e from its reference lies within 2 e of it on a straight path, and slightly further on a curve.
    """
    window = 3.0 * error + MARGIN
    return min(window, 0.5 * path.length) if path.closed else window


def judge(result: Result, reference: Reference) -> Result:
    """Add the errors [m], the arc length of the foot point [m] and the tracking error of each axis [m] to a result.

    Parameters
    ----------
    result : Result
        With ``tool_position``, ``reference`` and ``arc_length``.
    reference : Reference

    Returns
    -------
    Result
        With the signals below.

    Raises
    ------
    ResultError
        If a position is not finite or not in metres, the result and the path have different axes, or the result is of another reference.

    Notes
    -----
    Signals ``contour_error``, ``part_error``, ``planning_deviation``, ``foot_arc_length`` (on the programmed path) and ``tracking_error``:
    the reference less the true axis positions, or less the tool position if those were not recorded. The search for the nearest point is
    as wide as the largest tracking error and planning deviation of all samples need.
    """
    check_reference(result, reference)
    planned, programmed = reference.path, reference.programmed
    error = planning = 0.0

    def plan(part: Result) -> dict[str, Signal]:
        """Return planning deviation and place on the programmed path; note the largest errors."""
        nonlocal error, planning
        tool, wanted, along = _positions(part)
        if tool.shape[1] != reference.n_axis:
            raise ResultError(f"a result of axes {', '.join(result.axes)} for a path of {reference.n_axis} coordinates")
        error = max(error, furthest(wanted - tool))
        if programmed is planned:
            deviation = at = np.zeros_like(along)
        else:
            deviation, at = planning_deviation(reference, wanted, along)
            planning = max(planning, float(np.abs(deviation).max(initial=0.0)))
        return _along_path(planning_deviation=deviation, **{PLACE: at})

    def errors(part: Result) -> dict[str, Signal]:
        """Return the errors of the tool."""
        tool, wanted, along = _positions(part)
        found, foot = _errors(planned, tool, along, reach(planned, error))
        off, part_foot = found, foot
        if programmed is not planned:
            off, part_foot = _errors(programmed, tool, part[PLACE], reach(programmed, error) + planning)
        # The tracking error is that of the axes; the machine's error map moves the tool only.
        tracking = wanted - (_position(part, "axis_position") if "axis_position" in part else tool)
        made = _along_path(contour_error=found, part_error=off, foot_arc_length=part_foot)
        return {**made, "tracking_error": Signal(tracking, ("sample", "axis"), "m")}

    judged = replace(result, motion=reference).with_blocks(plan).with_blocks(errors)
    return judged.only([name for name in judged.signals if name != PLACE])


def _along_path(**values: Array) -> dict[str, Signal]:
    """Return values (n,) [m] as signals."""
    return {name: Signal(data, ("sample",), "m") for name, data in values.items()}


def planning_deviation(reference: Reference, wanted: Array, along: Array) -> tuple[Array, Array]:
    """Return the planning deviation (n,) [m] of some samples of a reference, and the arc length (n,) [m] of their foot points."""
    deviation, foot = np.empty(len(along)), np.empty(len(along))

    def fill(some: slice) -> None:
        """Fill one block, whose memory stays in the caches."""
        place = reference.programmed_arc_length(along[some])
        window = np.full(place.size, 0.02 * reference.programmed.length)
        if reference.correspondence is not None:
            # The error of the corresponding place is at most the length that one curve replaces there: a corner or a merged piece. The
            # foot point is not further away than that place, and the margin covers a path that bends back.
            window = reference.correspondence.span(along[some]) + 3.0 * gaps(reference.programmed, wanted[some], place) + 1e-9
        deviation[some], foot[some] = _errors(reference.programmed, wanted[some], place, window)

    # Each block is one chunk of the search, which then starts no threads of its own.
    first, *others = (slice(i, i + CHUNK) for i in range(0, max(len(along), 1), CHUNK))
    fill(first)  # prepares the path for all threads
    in_threads(fill, others)
    return deviation, foot


def stands_still(reference: Reference, error: ArrayLike) -> Flags:
    """Return whether runs with these largest tracking errors [m] hardly leave their start.

    A tool that stands on the path has no contour error, so such a run has no figures. It does if its largest tracking error reaches
    0.9 times the largest distance of the reference from its start.
    """
    return np.asarray(error) >= _STILL * _extent(reference)


def check_follows(judged: Result) -> None:
    """Raise DivergenceError if the tool stands still while its reference moves; see `stands_still`."""
    largest, extent, sample, start = -1.0, 0.0, 0, judged["reference"][:1]
    for part in judged.blocks():
        extent, behind = max(extent, furthest(part["reference"] - start)), squares(part["reference"] - part["tool_position"])
        if behind.max() > largest:
            largest, sample = behind.max(), int(behind.argmax()) + part.start - judged.start
    if math.sqrt(largest) >= _STILL * (extent or math.inf):
        axis = judged.axes[int(np.argmax(np.abs(judged["reference"][sample] - judged["tool_position"][sample])))]
        reason = f"{judged.scheme}: the tool hardly leaves its start: it is {1e3 * math.sqrt(largest):.4g} mm from its reference"
        raise DivergenceError(reason, sample=sample, time=sample * judged.servo_period, axis=axis)


@lru_cache(maxsize=8)
def _extent(reference: Reference) -> float:
    """Return the largest distance [m] of the reference from its start; infinite if it does not move."""
    blocks = (reference.block(*samples).position for samples in reference.blocks())
    start = reference.block(0, 1).position
    return max(furthest(block - start) for block in blocks) or math.inf


def check_reference(result: Result, reference: Reference) -> None:
    """Raise ResultError if a result was simulated along another reference."""
    if result.attributes.get("reference_digest", reference.digest) != reference.digest:
        raise ResultError(f"{result.scheme} is the result of another reference: judge it with the one it was simulated along")


def _positions(result: Result) -> tuple[Array, Array, Array]:
    """Return tool position, reference and arc length."""
    return _position(result, "tool_position"), _position(result, "reference"), _position(result, "arc_length")


def _position(result: Result, name: str) -> Array:
    """Return a signal in metres, row after row: rows of a log lie far apart in memory, and each search would copy them."""
    values, unit = result[name], result.signals[name].unit
    if unit != "m":
        raise ResultError(f"{name} is in {unit or 'no unit'}: convert it to m")
    if values.ndim == 1:
        values = np.ascontiguousarray(values)
    elif not values.flags.c_contiguous:
        log, values = values, np.empty(values.shape)
        for column, found in zip(log.T, values.T, strict=True):  # much faster than a copy by rows
            found[:] = column
    good = np.isfinite(values)
    if not good.all():
        where = np.argwhere(~good)[0]
        axis = f" of axis {result.axes[where[1]]}" if len(where) == 2 else ""
        raise ResultError(f"{name}{axis} is not finite at sample {int(where[0]) + result.start}")
    return values


def _errors(path: Path, points: Array, around: Array, window: float | Array) -> tuple[Array, Array]:
    feet = path.foot_point(points, around, window)
    return (feet.signed if path.is_planar else feet.distance), feet.arc_length
