"""Lost motion from measured positions of motor and load: the gap and the windup.

Where the motor pushes the load, motor less load is o + b/2 + F/k forwards and o - b/2 - F/k backwards: o is the offset of the two scales,
b the gap, F the transmitted force and k the stiffness behind the motor. Their difference is the lost motion b + 2 F/k. Positions alone give
no more; a measured force, or a known stiffness, separates the gap from the windup.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Index
from contourlab.errors import ParameterError, ResultError, refuse

MARGIN = 1.2
"""Travel since the last turn that ensures contact, as a multiple of the range of motor less load."""
LEAST_CELL = 0.25
"""Least travel of a pass that counts in a bin, as a fraction of the bin's width."""


@dataclass(frozen=True, eq=False)
class LostMotion:
    """The play between a motor and its load.

    Attributes
    ----------
    lost_motion, lost_motion_deviation : float [m]
        Change of motor less load from backwards to forwards, in contact; and its standard deviation from the scatter of passes and places
        (nan for one pass each way in one bin).
    gap, gap_deviation : float [m]
        Free travel without force, b; nan if neither force nor stiffness was given.
    windup : float [m]
        Elastic part of the lost motion; nan like the gap.
    stiffness : float [N/m]
        As given, or as identified from the force; else nan.
    offset : float [m]
        Motor less load midway between forwards and backwards.
    passes_forward, passes_backward : int
        Number of counted strokes.
    place : ndarray (n_bin,) [m]
        Motor positions in the middle of the bins passed both ways.
    lost_motion_at, deviation_at : ndarray (n_bin,) [m]
        Lost motion there, and its standard deviation (nan without repetitions).
    """

    json_form: ClassVar = {"lost_motion": "lost_motion", "deviation": "lost_motion_deviation", "gap": "gap"}

    lost_motion: float
    lost_motion_deviation: float
    gap: float
    gap_deviation: float
    windup: float
    stiffness: float
    offset: float
    passes_forward: int
    passes_backward: int
    place: Array
    lost_motion_at: Array
    deviation_at: Array


class _Cells(NamedTuple):
    """Means over one pass in one bin; arrays (n_cell,)."""

    apart: Array
    side: Array
    bin: Index
    force: Array


def lost_motion_from_pair(
    motor_position: ArrayLike,
    load_position: ArrayLike,
    *,
    force: ArrayLike | None = None,
    friction: float | None = None,
    stiffness: float | None = None,
    bins: int = 10,
) -> LostMotion:
    """Return the lost motion between a motor and a load that were measured while the axis went back and forth.

    Parameters
    ----------
    motor_position, load_position : array_like (n,) [m]
        As travel of the load, positive in the same direction; any zero points.
    force : array_like (n,) [N], optional
        From motor to load, positive where it pushes forwards. With `stiffness` the windup is subtracted pass by pass. Without it the
        stiffness is identified, which needs a force that varies in more than its direction.
    friction : float [N], optional
        Magnitude of the force at the speed of the test, if it was not measured; needs `stiffness`.
    stiffness : float [N/m], optional
        Behind the motor, k > 0.
    bins : int
        Number of places along the axis, >= 1.

    Returns
    -------
    LostMotion

    Raises
    ------
    ResultError
        If the records differ in length, are not finite, or never go both ways far enough over the same place, or if the force does not
        determine the stiffness.
    ParameterError
        If bins, stiffness or friction are out of range, or friction is given without stiffness.

    Notes
    -----
    A sample counts once the motor has gone further in one direction than `MARGIN` times the range of motor less load. This ensures contact
    if the load is slow enough for its friction to hold it against the motor: a heavy load leans on the other flank while the motor slows
    down, and the lost motion is then too small. Samples are weighted by their travel, so standstill has no
    weight. Means are taken over each pass in each bin; scale errors along the axis cancel, since they are the same both ways.
    """
    no_force = np.zeros(np.shape(motor_position))
    motor, load, push = _records(motor=motor_position, load=load_position, force=no_force if force is None else force)
    refuse(bins != int(bins) or bins < 1, ParameterError, "bins", bins, "a whole number, 1 or more")
    if stiffness is not None:
        _check_positive("stiffness", stiffness, "N/m")
    if friction is not None:
        _check_positive("friction", friction, "N", or_zero=True)
        if stiffness is None or force is not None:
            raise ParameterError("friction", friction, "given with stiffness, and without force")
    cells, middle, passes = _cells(motor, motor - load, push, bins)
    bins_used = np.unique(cells.bin)
    design = np.column_stack([0.5 * cells.side, cells.bin[:, None] == bins_used]).astype(float)
    values, deviation = _least_squares(design, cells.apart)
    if friction is not None and stiffness is not None:
        gap, gap_deviation, k = values[0] - 2.0 * friction / stiffness, deviation[0], stiffness
    elif force is None:
        gap, gap_deviation, k = math.nan, math.nan, math.nan if stiffness is None else stiffness
    else:
        gap, gap_deviation, k = _gap_and_stiffness(cells, design, stiffness)
    lost_at, deviation_at = _by_place(cells, bins_used)
    return LostMotion(
        lost_motion=values[0],
        lost_motion_deviation=deviation[0],
        gap=gap,
        gap_deviation=gap_deviation,
        windup=values[0] - gap,
        stiffness=k,
        offset=float(np.mean(values[1:])),
        passes_forward=passes[0],
        passes_backward=passes[1],
        place=middle[bins_used],
        lost_motion_at=lost_at,
        deviation_at=deviation_at,
    )


def pushed(motor: Array, width: float) -> Array:
    """Return +1 or -1 (n,) where the motor has gone by `width` in one direction since its last turn, else 0.

    Turns smaller than a quarter of `width`, such as noise, do not count.
    """
    most, rise, fall, signs = 1.25 * width, 0.0, 0.0, []
    for step in np.diff(motor, prepend=motor[0]).tolist():
        rise = min(max(rise + step, 0.0), most)
        fall = min(max(fall - step, 0.0), most)
        signs.append(1.0 if rise >= width else -1.0 if fall >= width else 0.0)
    return np.array(signs)


def _cells(motor: Array, apart: Array, force: Array, bins: int) -> tuple[_Cells, Array, tuple[int, int]]:
    """Return the means over passes in bins that are passed both ways, the middles of all bins, and the number of passes each way."""
    width = MARGIN * float(np.ptp(apart))
    side, travel, (place, *values) = _steps(motor, width, (apart, force))
    low, high = _common(place, side, width)
    inside = (place >= low) & (place <= high)
    number = np.cumsum(np.diff(side, prepend=side[:1]) != 0.0)
    cell = number * bins + np.clip(((place - low) / (high - low) * bins).astype(np.int64), 0, bins - 1)
    weight = travel * inside
    total = np.bincount(cell, weight)
    kept = np.flatnonzero(total >= LEAST_CELL * (high - low) / bins)
    of_apart, of_side, of_force = (np.bincount(cell, weight * v)[kept] / total[kept] for v in (values[0], side, values[1]))
    middle = low + (np.arange(bins) + 0.5) * (high - low) / bins
    forward = len(np.unique(kept[of_side > 0.0] // bins))
    cells = _Cells(of_apart, np.sign(of_side), kept % bins, of_force)
    both = np.isin(cells.bin, np.intersect1d(cells.bin[cells.side == 1.0], cells.bin[cells.side == -1.0]))
    refuse(not both.any(), ResultError, "no place is passed in both directions: go both ways over one place, or use fewer bins")
    cells = _Cells(cells.apart[both], cells.side[both], cells.bin[both], cells.force[both])
    return cells, middle, (forward, len(np.unique(kept // bins)) - forward)


def _steps(motor: Array, width: float, values: tuple[Array, ...]) -> tuple[Array, Array, list[Array]]:
    """Return direction and travel of the steps between samples that count, and the place and values in the middle of each.

    The noise in the travel, which is the weight of a step, does not correlate with that in its middle.
    """
    refuse(len(motor) < 2 or not np.ptp(motor) > 0.0, ResultError, "the motor does not move: record it going back and forth")
    step = np.diff(motor)
    side = np.sign(step)
    if width > 0.0:
        sure = pushed(motor, width)
        # Both ends of a step must be in contact: at speed a step is as long as the gap.
        side = np.where(sure[1:] == sure[:-1], sure[1:], 0.0)
    used = side * step > 0.0
    middles = [(0.5 * (v[1:] + v[:-1]))[used] for v in (motor, *values)]
    return side[used], np.abs(step[used]), middles


def _common(place: Array, side: Array, width: float) -> tuple[float, float]:
    """Return the ends of the range that was passed both ways."""
    forward, backward = place[side > 0.0], place[side < 0.0]
    if not (len(forward) and len(backward)):
        way = "backwards" if len(forward) else "forwards"
        raise ResultError(
            f"the motor never goes {way} by more than {MARGIN:g} times the range of motor less load, {1e6 * width / MARGIN:.6g} um: "
            "use longer strokes both ways, or a load scale that agrees with the motor's"
        )
    low, high = max(float(forward.min()), float(backward.min())), min(float(forward.max()), float(backward.max()))
    refuse(not high > low, ResultError, "the motor goes forwards and backwards over different places: go both ways over one place")
    return low, high


def _least_squares(design: Array, values: Array) -> tuple[list[float], list[float]]:
    """Return the coefficients, and their standard deviations (nan without a degree of freedom)."""
    inverse = np.linalg.pinv(design)
    coefficients = inverse @ values
    free = len(values) - design.shape[1]
    rest = values - design @ coefficients
    scatter = math.sqrt(float(rest @ rest) / free) if free > 0 else math.nan
    return coefficients.tolist(), (scatter * np.linalg.norm(inverse, axis=1)).tolist()


def _gap_and_stiffness(cells: _Cells, design: Array, stiffness: float | None) -> tuple[float, float, float]:
    """Return the gap, its deviation, and the stiffness, from a measured force."""
    if stiffness is not None:
        gap, deviation = _least_squares(design, cells.apart - cells.force / stiffness)
        return gap[0], deviation[0], stiffness
    independent = cells.force - design @ np.linalg.lstsq(design, cells.force, rcond=None)[0]
    if not float(np.linalg.norm(independent)) > 0.02 * float(np.linalg.norm(cells.force)):
        raise ResultError("the force varies in its direction alone: give a stiffness to separate windup from the gap")
    values, deviation = _least_squares(np.column_stack([design, cells.force]), cells.apart)
    if not values[-1] > 0.0:
        raise ResultError(
            f"motor less load falls as the force rises, by {-values[-1]:.3g} m/N: give a force that is positive where it pushes forwards"
        )
    return values[0], deviation[0], 1.0 / values[-1]


def _by_place(cells: _Cells, bins: Index) -> tuple[Array, Array]:
    """Return the lost motion in each bin, and its deviation from the scatter between passes, pooled over all bins."""
    groups = [[cells.apart[(cells.bin == i) & (cells.side == side)] for side in (1.0, -1.0)] for i in bins]
    free = sum(len(passes) - 1 for pair in groups for passes in pair)
    square = sum(float(((passes - passes.mean()) ** 2).sum()) for pair in groups for passes in pair)
    scatter = math.sqrt(square / free) if free > 0 else math.nan
    lost = np.array([forward.mean() - backward.mean() for forward, backward in groups])
    deviation = np.array([scatter * math.sqrt(1.0 / len(forward) + 1.0 / len(backward)) for forward, backward in groups])
    return lost, deviation


def _records(**values: ArrayLike) -> list[Array]:
    """Return records (n,) as float arrays; raise a ResultError unless they are vectors of one length, not empty, and finite."""
    arrays, names = [np.asarray(value, dtype=float) for value in values.values()], " and ".join(values)
    if arrays[0].ndim != 1 or len({array.shape for array in arrays}) > 1:
        shapes = " and ".join(str(array.shape) for array in arrays)
        raise ResultError(f"{names} have shapes {shapes}: give one number per sample, the same number of samples")
    refuse(not arrays[0].size, ResultError, f"{names} hold no samples")
    refuse(not all(np.isfinite(array).all() for array in arrays), ResultError, f"{names} hold values that are not finite")
    return arrays


def _check_positive(name: str, value: float, unit: str, *, or_zero: bool = False) -> None:
    """Raise a ParameterError unless a value is finite and > 0, or 0 if that is allowed."""
    if not (0.0 < value < math.inf or (or_zero and value == 0.0)):
        raise ParameterError(name, value, f"finite and {'>= 0' if or_zero else '> 0'}", unit)
