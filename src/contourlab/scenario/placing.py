"""A motion on a machine: move a contour, scale and move a part program into the travel on request, and check travel and limits."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import BLOCK, Array, Flags, Index
from contourlab.feed import Reference, Route, route_from_program
from contourlab.feed.reference import ReferenceBlock
from contourlab.geometry import Path
from contourlab.geometry.curve import Curve
from contourlab.geometry.line_and_arc import Arc, Line
from contourlab.geometry.nurbs import BSpline, Nurbs
from contourlab.geometry.parametric import EllipticalArc
from contourlab.geometry.path import boxes
from contourlab.loop import Machine
from contourlab.loop.simulate import jit_enabled, sampler
from contourlab.program import Arc as ProgramArc
from contourlab.program import Dwell, Move, Point, Program, Reading, Spline

MARGIN = 0.01
"""Share of the travel left free at either end of a fitted program."""


def placed(path: Path, offset: Sequence[float]) -> Path:
    """Return a path moved by an offset.

    Parameters
    ----------
    offset : sequence of float [m]
        One value per coordinate of the result; coordinates beyond the path's own stay constant.

    Returns
    -------
    Path
        Lines, arcs, elliptical arcs and splines keep their type.

    >>> from contourlab.geometry import contour
    >>> placed(contour("circle", radius=0.01), (0.1, 0.0, 0.002)).position([0.0]).round(9).tolist()
    [[0.11, 0.0, 0.002]]
    """
    move = np.array(offset, dtype=float)
    if move.size == path.n_axis and not move.any():
        return path
    return Path([_moved(curve, move) for curve in path.curves], path.closed)


def _wide(vectors: Array, n: int) -> Array:
    """Pad vectors (..., m) with zeros to (..., n)."""
    return np.concatenate([vectors, np.zeros((*vectors.shape[:-1], n - vectors.shape[-1]))], axis=-1)


class _Moved(Curve):
    """A moved curve, with further constant coordinates."""

    def __init__(self, curve: Curve, move: Array) -> None:
        self.curve, self.move = curve, move
        self.n_axis, self.length = move.size, curve.length
        self.marks = np.asarray(getattr(curve, "marks", (0.0, curve.length)))

    def derivatives(self, s: ArrayLike, order: int = 3) -> Array:
        derivatives = _wide(self.curve.derivatives(s, order), self.n_axis)
        derivatives[0] += self.move
        return derivatives

    def smallest_radius(self) -> float:
        return self.curve.smallest_radius()

    def describe(self) -> bytes:
        return b"moved" + self.move.astype("<f8").tobytes() + self.curve.describe()


def _moved(curve: Curve, move: Array) -> Curve:
    def wide(*vectors: Array) -> list[Array]:
        return [_wide(vector, move.size) for vector in vectors]

    match curve:
        case Line():
            start, end = wide(curve.start, curve.end)
            return Line(start + move, end + move)
        case Arc():
            centre, *frame = wide(curve.centre, curve.u, curve.v, curve.rise)
            return Arc(centre + move, curve.radius, curve.start_angle, curve.sweep, *frame)
        case EllipticalArc():
            centre, p, q = wide(curve.centre, curve.p, curve.q)
            return EllipticalArc(centre + move, p, q, curve.first, curve.last)
        case BSpline():
            return BSpline(curve.degree, _wide(curve.points, move.size) + move, curve.knots)
        case Nurbs():
            return Nurbs(curve.degree, _wide(curve.points, move.size) + move, curve.knots, curve.weights)
    return _Moved(curve, move)


def zero_known(machine: Machine, reading: Reading) -> bool:
    """Return whether a program's zero in machine coordinates is known; it is at machine zero where no travel floats."""
    return reading.parameters is not None or bool(reading.zero) or not any(axis.limits.floating for axis in machine.axes)


def anchored(machine: Machine, reading: Reading | None = None) -> Machine:
    """Return a machine whose travels have their ends; unchanged where the zero of a program read so is unknown."""
    if reading is not None and not zero_known(machine, reading):
        return machine
    return replace(machine, axes=tuple(replace(axis, limits=replace(axis.limits, floating=False)) for axis in machine.axes))


def beyond_travel(points: Iterable[tuple[int, Point]], letters: Sequence[str], machine: Machine) -> dict[str, tuple[int, float]]:
    """Return for each axis of floating travel the line and the position [m] of the first point in machine coordinates (G53) outside it."""
    outside: dict[str, tuple[int, float]] = {}
    for line, point in points:
        for letter, axis in zip(letters, machine.axes, strict=True):
            at, travel = dict(zip("xyz", point, strict=True)).get(letter, math.nan), axis.limits.travel
            if axis.limits.floating and isinstance(travel, tuple) and max(at - travel[1], travel[0] - at) > ROUNDING:
                outside.setdefault(axis.name, (line, at))
    return outside


def fitted(program: Program, letters: Sequence[str], machine: Machine) -> tuple[Program, str]:
    """Return a program fitted into the travel of a machine, and a note on the change.

    Parameters
    ----------
    letters : sequence of str
        The address that each axis of the machine obeys.

    Returns
    -------
    program : Program
        Scaled down by one factor for all axes if it is too large, and moved no further than needed. Feedrates stay.
    note : str
        Empty if it is unchanged.

    Raises
    ------
    ProgramError
        If the program moves an axis that the machine lacks.
    """
    route = route_from_program(program, letters)
    lows, highs = boxes(route.path)
    low, high = lows.min(axis=0), highs.max(axis=0)
    length = highs.max(axis=0, initial=-np.inf, where=~route.rapid[:, None]) - lows.min(axis=0, initial=np.inf, where=~route.rapid[:, None])
    travel = np.array([axis.limits.ends for axis in machine.axes], dtype=np.float64)
    extent = np.array([axis.limits.extent for axis in machine.axes])
    room = travel[:, 1] - travel[:, 0]
    least, most = travel[:, 0], travel[:, 1]
    if np.all(low >= least) and np.all(high <= most) and np.all(length <= extent):
        return program, ""
    margin = np.where(np.isfinite(room), MARGIN * room, 0.0)
    least, most = least + margin, most - margin
    wanted, size = np.array([most - least, (1.0 - 2.0 * MARGIN) * extent]), np.array([high - low, length])
    ratios = np.divide(wanted, size, out=np.full(size.shape, np.inf), where=size > 0.0)
    scale = float(min(1.0, ratios.min()))
    shift = dict(zip(letters, (np.maximum(least - scale * low, 0.0) + np.minimum(most - scale * high, 0.0)).tolist(), strict=True))
    x, y, z = (shift.get(letter, 0.0) for letter in "xyz")
    moved_by = ", ".join(f"{value * 1e3:+.6g}" for value in (x, y, z))
    scaled = "" if scale == 1.0 else f"scaled by {scale:.6g}, then "
    return _scaled(program, scale, (x, y, z)), f"fitted into the machine's travel: {scaled}moved by ({moved_by}) mm"


def _scaled(program: Program, scale: float, shift: Point) -> Program:
    """Return a program with every point p of its moves at ``scale * p + shift`` [m]."""

    def scaled(point: Point) -> Point:
        x, y, z = (scale * value + offset for value, offset in zip(point, shift, strict=True))
        return (x, y, z)

    def moved(move: Move) -> Move:
        if isinstance(move, Dwell):
            return move
        if isinstance(move, Spline):
            return replace(move, points=tuple(map(scaled, move.points)))
        if isinstance(move, ProgramArc):
            move = replace(move, centre=scaled(move.centre))
        return replace(move, start=scaled(move.start), end=scaled(move.end))

    return replace(program, moves=tuple(moved(move) for move in program.moves))


# --- checks --------------------------------------------------------------------------------------------------------------------------

MOST_SAMPLES = 100_000_000
"""More than a day at 1 kHz; all of a run's signals then take some 30 GB."""

ROUNDING = 1e-9
"""Rounding [m] that does not count as leaving the travel."""

Fault = Callable[[str, int], Exception]


def check_motion(reference: Reference, machine: Machine, fault: Fault, *, bounded: bool, cure: str = "move the part") -> None:
    """Refuse a motion that is too long or beyond the limits of the machine.

    Parameters
    ----------
    fault : callable
        Returns the error to raise, from a message and a program line (0 for none).
    bounded : bool
        Whether a planner kept to the limits of velocity and acceleration.
    cure : str
        What to do if the motion leaves the travel.
    """
    if reference.n_sample > MOST_SAMPLES:
        raise fault(
            f"the motion takes {reference.duration:.3g} s or {reference.n_sample:.3g} samples of {reference.servo_period:g} s, but at most "
            f"{MOST_SAMPLES:.0e} are allowed: check the feed",
            0,
        )
    if any(axis.limits.bounded for axis in machine.axes):
        _check_travel(reference, machine, fault, cure)
    if not bounded:
        _check_speeds(reference, machine, fault)


def _blocks(reference: Reference, stop: int) -> Iterator[ReferenceBlock]:
    # A run asks for the same blocks, which the reference caches.
    fill = sampler(jit_enabled())
    for start in range(0, stop, BLOCK):
        yield reference.block(start, min(start + BLOCK, stop), fill)


class TravelCheck:
    """Where a motion, given piece by piece, first leaves the travel of each axis.

    Attributes
    ----------
    low, high : ndarray (n_axis,) [m]
        Ends of the motion so far.
    cut_low, cut_high : ndarray (n_axis,) [m]
        Those of its feed moves, for axes whose travel is a length: rapids to a tool change are not in the coordinates of the part.
    left : dict of str to int
        Program line on which an axis first leaves its travel, in the order of the motion.
    """

    def __init__(self, machine: Machine) -> None:
        self.axes = machine.axes
        self.low, self.cut_low = np.full((2, len(machine.axes)), np.inf)
        self.high, self.cut_high = np.full((2, len(machine.axes)), -np.inf)
        self.left: dict[str, int] = {}

    def add(self, low: Array, high: Array, feed: Flags, lines: Index) -> None:
        """Add points or boxes (n, n_axis), n > 0, with their program lines (n,); `feed` tells which belong to feed moves."""
        left = []
        for j, axis in enumerate(self.axes):
            start, stop = axis.limits.ends
            outside = np.maximum(high[:, j] - stop, start - low[:, j]) > ROUNDING
            if math.isfinite(axis.limits.extent):
                cut_low = np.minimum.accumulate(np.append(self.cut_low[j], np.where(feed, low[:, j], np.inf)))
                cut_high = np.maximum.accumulate(np.append(self.cut_high[j], np.where(feed, high[:, j], -np.inf)))
                outside |= (cut_high - cut_low)[1:] > axis.limits.extent + ROUNDING
                self.cut_low[j], self.cut_high[j] = cut_low[-1], cut_high[-1]
            left += [(int(np.argmax(outside)), axis.name)] if outside.any() else []
        for k, name in sorted(left):
            self.left.setdefault(name, int(lines[k]))
        self.low, self.high = np.minimum(self.low, low.min(axis=0)), np.maximum(self.high, high.max(axis=0))


def check_route(route: Route, machine: Machine, fault: Fault, cure: str) -> None:
    """Refuse a programmed path with a curve that ends outside the travel, by more than blends and fitted curves may cut off.

    It is refused before it takes time to plan; of all others `check_motion` tells.
    """
    tolerance = float(np.maximum(route.corner_tolerance, route.merge_tolerance).max())
    start, end, check = route.path.starts[0], route.path.ends[0], TravelCheck(machine)
    check.add(np.minimum(start, end) + tolerance, np.maximum(start, end) - tolerance, ~route.rapid, route.source_line)
    if check.left:
        check, (low, high) = TravelCheck(machine), boxes(route.path)
        for cut_off in (tolerance, 0.0):  # tells first what is sure, then the whole range
            check.add(low + cut_off, high - cut_off, ~route.rapid, route.source_line)
    _refuse(check, machine, fault, cure)


def _check_travel(reference: Reference, machine: Machine, fault: Fault, cure: str) -> None:
    """Refuse the first sample outside the travel."""
    check = TravelCheck(machine)
    rapid = np.zeros(len(reference.path.curves), dtype=bool) if reference.rapid is None else reference.rapid
    for block in _blocks(reference, reference.n_sample):
        curve = reference.path.curve_index(block.arc_length)
        check.add(block.position, block.position, ~rapid[curve], reference.source_line(block.arc_length))
    _refuse(check, machine, fault, cure)


def _refuse(check: TravelCheck, machine: Machine, fault: Fault, cure: str) -> None:
    """Refuse a motion that leaves the travel, with the full range of the axis that leaves it first."""
    for name, line in check.left.items():
        j, limits = machine.axis_names.index(name), machine.axis(name).limits
        if math.isfinite(limits.extent):
            way, travel = f"cut over {_mm(check.cut_high[j] - check.cut_low[j])} mm", f"{_mm(limits.extent)} mm: shorten the part"
        else:
            low, high = (_mm(end) for end in limits.ends)
            way, travel = f"move from {_mm(check.low[j])} to {_mm(check.high[j])} mm", f"{low} to {high} mm: {cure}"
        code = "CL478" if math.isfinite(limits.extent) else "CL470"
        raise fault(f"{code} axis {name} would {way}, but its travel is {travel}, or correct limits.travel", line)


def _mm(value: float) -> str:
    """Write a position in mm to 0.1 um, so that rounding errors show as 0.

    >>> _mm(-9.5e-18), _mm(0.22)
    ('0', '220')
    """
    return f"{round(value * 1e3, 4) + 0.0:.10g}"


def _check_speeds(reference: Reference, machine: Machine, fault: Fault) -> None:
    """Check velocity and acceleration over the first lap; all laps are alike."""
    worst = {"velocity": np.zeros(len(machine.axes)), "acceleration": np.zeros(len(machine.axes))}
    for block in _blocks(reference, reference.laps[0][1] if reference.laps else reference.n_sample):
        for name, largest in worst.items():
            np.maximum(largest, np.abs(getattr(block, name)).max(axis=0), out=largest)
    for power, (name, unit, scale) in enumerate((("velocity", "mm/s", 1e3), ("acceleration", "m/s^2", 1.0)), 1):
        for axis, asked in zip(machine.axes, worst[name], strict=True):
            limit = getattr(axis.limits, name)
            if asked > limit * (1.0 + 1e-9):
                what = f"{'an' if name[0] == 'a' else 'a'} {name} of {asked * scale:.4g} {unit}"
                raise fault(
                    f"axis {axis.name} reaches {what}, but its limit is {limit * scale:.4g} {unit}: "
                    f"use at most {(limit / asked) ** (1.0 / power):.3g} times this frequency",
                    0,
                )
