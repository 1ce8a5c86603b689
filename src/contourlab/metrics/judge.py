"""The judge: three separate errors, from true positions and the path alone.

- `planning_deviation`: planned path to programmed path, at the reference: the cost of blending;
- `contour_error`: tool to planned path: the cost of the servo loops;
- `part_error`: tool to programmed path: the error of the part, which a tolerance limits.

Each is the exact shortest distance, found around the reference's progress, so that the right branch is taken where a path meets itself.
It has a side in the plane (positive to the left of the direction of travel) and is a magnitude in space.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ResultError
from contourlab.feed import Reference
from contourlab.geometry import Path
from contourlab.result import Result, Signal

Array = NDArray[np.float64]
_MARGIN = 1e-4


def reach(path: Path, tracking: Array) -> float:
    """Return the window [m] in which a foot point is sought: three times the largest tracking error, and 0.1 mm.

    The foot point of a tool that is e away from its reference lies within 2 e of it on a straight path, and a little further on a bent one.
    On a closed path half the length is enough.
    """
    largest = float(np.linalg.norm(tracking, axis=1).max(initial=0.0))
    wanted = 3.0 * largest + _MARGIN
    return min(wanted, 0.5 * path.length) if path.closed else wanted


def judge(result: Result, reference: Reference) -> Result:
    """Return the result with the judge's signals: errors [m], the foot point's arc length [m], the tracking error of each axis [m].

    Parameters
    ----------
    result : Result
        With ``tool_position``, ``reference`` and ``arc_length``.
    reference : Reference
        With its planned and its programmed path.

    Raises
    ------
    ResultError
        If a position is not finite, or the result has other axes than the path.

    Notes
    -----
    Signals ``contour_error``, ``part_error``, ``planning_deviation``, ``foot_arc_length`` (on the programmed path) and ``tracking_error``:
    the reference less the axes' true positions, or less the tool's where these were not kept.
    """
    tool, wanted, along = result["tool_position"], result["reference"], result["arc_length"]
    for name in ("tool_position", "reference", "arc_length"):
        _check_finite(result, name)
    if tool.shape[1] != reference.n_axis:
        raise ResultError(f"a result of axes {', '.join(result.axes)} for a path of {reference.n_axis} coordinates")
    off = wanted - tool
    planned, programmed = reference.path, reference.programmed
    contour, foot = _errors(planned, tool, along, reach(planned, off))
    if programmed is planned:
        part, planning, part_foot = contour, np.zeros_like(contour), foot
    else:
        place, window = _around(reference, wanted, along)
        planning, at = _errors(programmed, wanted, place, window)
        part, part_foot = _errors(programmed, tool, at, reach(programmed, off) + float(np.abs(planning).max(initial=0.0)))
    # The servo's error is that of the axes; where they are the tool may still be off by the machine's error map.
    tracking = wanted - result["axis_position"] if "axis_position" in result.signals else off
    one = ("sample",)
    return result.with_signals(
        contour_error=Signal(contour, one, "m"),
        part_error=Signal(part, one, "m"),
        planning_deviation=Signal(planning, one, "m"),
        foot_arc_length=Signal(part_foot, one, "m"),
        tracking_error=Signal(tracking, ("sample", "axis"), "m"),
    )


def _around(reference: Reference, wanted: Array, along: Array) -> tuple[Array, Array]:
    """Return where on the programmed path the reference is, and how far (n,) [m] its foot point may be from there.

    The place that corresponds is a first guess at the foot point, good to the length of what was replaced there by one curve: a corner or
    a merged piece. A foot point is no further away than that place is, and a path that bends back near there is longer than it is wide.
    """
    place = reference.programmed_arc_length(along)
    if reference.correspondence is None:
        return place, np.full(place.size, 0.02 * reference.programmed.length)
    off = np.linalg.norm(wanted - reference.programmed.position(place), axis=1)
    return place, reference.correspondence.span(along) + 3.0 * off + 1e-9


def _check_finite(result: Result, name: str) -> None:
    good = np.isfinite(result[name])
    if not good.all():
        where = np.argwhere(~good)[0]
        axis = f" of axis {result.axes[where[1]]}" if len(where) == 2 else ""
        raise ResultError(f"{name}{axis} is not finite at sample {int(where[0]) + result.start}: it cannot be judged")


def _errors(path: Path, points: Array, around: Array, window: float | Array) -> tuple[Array, Array]:
    found = path.foot_point(points, around, window)
    return (found.signed if path.is_planar else found.distance), found.arc_length
