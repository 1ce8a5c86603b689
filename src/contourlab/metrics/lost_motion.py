"""Lost motion from the measured positions of motor and load: the gap, and the windup that comes on top of it.

Where the motor pushes the load, motor less load is o + b/2 + F/k forwards and o - b/2 - F/k backwards: o what the two scales are apart, b
the gap, F the force handed on and k the stiffness behind the motor. Their difference is the lost motion b + 2 F/k. From positions alone no
more can be known; a force that is measured, or a stiffness, tells the gap from the windup.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import ParameterError, ResultError

Array = NDArray[np.float64]

MARGIN = 1.2
"""Travel since the last turn from which contact is sure, over the whole range of motor less load."""
LEAST_CELL = 0.25
"""A pass counts in a bin in which it goes at least this part of the bin's width."""


@dataclass(frozen=True, eq=False)
class LostMotion:
    """The play between a motor and its load.

    Attributes
    ----------
    lost_motion, lost_motion_deviation : float [m]
        Motor less load forwards, less that backwards, in slow motion with contact; and its standard deviation, from the scatter between
        passes and places (nan where there is but one pass each way in one bin).
    gap, gap_deviation : float [m]
        Free travel at no force, b; nan where neither force nor stiffness was given.
    windup : float [m]
        Elastic part of the lost motion; nan as the gap.
    stiffness : float [N/m]
        As given, or as found from the force; nan where there is neither.
    plateau_gap : float [m]
        Distance between the two plateaus of the distribution of motor less load: the lost motion by another way, which does not ask for
        the direction, but is blurred by what varies along the axis.
    offset : float [m]
        Motor less load midway between the plateaus of both directions.
    passes_forward, passes_backward : int
        Stretches of motion in one direction that were counted.
    place : ndarray (n_bin,) [m]
        Middles of the bins that were passed both ways, by the position of the motor.
    lost_motion_at, deviation_at : ndarray (n_bin,) [m]
        Lost motion there, and its standard deviation (nan without repetitions).
    """

    lost_motion: float
    lost_motion_deviation: float
    gap: float
    gap_deviation: float
    windup: float
    stiffness: float
    plateau_gap: float
    offset: float
    passes_forward: int
    passes_backward: int
    place: Array
    lost_motion_at: Array
    deviation_at: Array


@dataclass(frozen=True, eq=False)
class _Cells:
    """Means over one pass in one bin each: (n_cell,)."""

    apart: Array
    side: Array
    bin: NDArray[np.int64]
    force: Array
    middle: Array


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
        Both as travel of the load, positive the same way; where they have their zeros does not matter.
    force : array_like (n,) [N], optional
        Handed on from motor to load, positive where it pushes forwards. With `stiffness`, the windup is taken off pass by pass; without,
        the stiffness is found as well, for which the force has to vary in more than its direction.
    friction : float [N], optional
        Magnitude of the force at the speed of the test, where it was not measured; goes with `stiffness`.
    stiffness : float [N/m], optional
        Behind the motor, k > 0.
    bins : int
        Number of places along the axis at which the lost motion is evaluated, >= 1.

    Notes
    -----
    The motor has to go further in one direction than `MARGIN` times the whole range of motor less load before a sample counts, which makes
    contact sure if the load is slow enough for its friction to hold it against the motor. Samples count by the travel in which they were
    taken, so that standstill counts nothing. Means are taken over each pass in each bin; errors of the scales along the axis drop out, as
    they are the same both ways.

    Raises
    ------
    ResultError
        If the records differ in length, have numbers that are not finite, never go both ways far enough over the same place, or hold a
        force that does not determine the stiffness.
    ParameterError
        If bins, stiffness or friction are out of range, or friction is given without stiffness.
    """
    motor, load, push = _records(motor_position, load_position, force)
    _check_numbers(bins, stiffness, friction, force is not None)
    apart = motor - load
    cells, passes = _cells(motor, apart, push, bins)
    design = _design(cells)
    found, deviation = _solved(design, cells.apart)
    gap, gap_deviation, k = _gap_and_stiffness(cells, design, found, deviation, force is not None, friction, stiffness)
    place, lost_at, deviation_at = _by_place(cells)
    return LostMotion(
        lost_motion=found[0],
        lost_motion_deviation=deviation[0],
        gap=gap,
        gap_deviation=gap_deviation,
        windup=found[0] - gap,
        stiffness=k,
        plateau_gap=_plateau_gap(apart),
        offset=float(np.mean(found[1:])),
        passes_forward=passes[0],
        passes_backward=passes[1],
        place=place,
        lost_motion_at=lost_at,
        deviation_at=deviation_at,
    )


def _records(motor: ArrayLike, load: ArrayLike, force: ArrayLike | None) -> tuple[Array, Array, Array]:
    m, p = (np.asarray(values, dtype=float) for values in (motor, load))
    f = np.zeros(m.shape) if force is None else np.asarray(force, dtype=float)
    if m.ndim != 1 or not m.shape == p.shape == f.shape:
        shapes = f"{m.shape} and {p.shape}" + ("" if force is None else f" and {f.shape}")
        raise ResultError(f"motor and load of shapes {shapes}: give one number a sample, as many of each")
    if not m.size:
        raise ResultError("motor and load hold no samples")
    if not (np.isfinite(m).all() and np.isfinite(p).all() and np.isfinite(f).all()):
        raise ResultError("motor, load or force hold numbers that are not finite")
    return m, p, f


def _check_numbers(bins: int, stiffness: float | None, friction: float | None, measured: bool) -> None:
    if bins != int(bins) or bins < 1:
        raise ParameterError("bins", bins, "a whole number, 1 or more")
    if stiffness is not None and not 0.0 < stiffness < math.inf:
        raise ParameterError("stiffness", stiffness, "finite and > 0", "N/m")
    if friction is not None and not 0.0 <= friction < math.inf:
        raise ParameterError("friction", friction, "finite and >= 0", "N")
    if friction is not None and (stiffness is None or measured):
        raise ParameterError("friction", friction, "given with stiffness, and without force")


def pushed(motor: Array, width: float) -> Array:
    """Return +1 or -1 (n,) where the motor has gone by `width` in one direction since it last turned, else 0.

    Both ways are counted up to a quarter more than that, so that noise on the way, and turns smaller than this quarter, are no turns.
    """
    most, rise, fall, ways = 1.25 * width, 0.0, 0.0, []
    for step in np.diff(motor, prepend=motor[0]).tolist():
        rise = min(max(rise + step, 0.0), most)
        fall = min(max(fall - step, 0.0), most)
        ways.append(1.0 if rise >= width else -1.0 if fall >= width else 0.0)
    return np.array(ways)


def _cells(motor: Array, apart: Array, force: Array, bins: int) -> tuple[_Cells, tuple[int, int]]:
    """Return the means over passes and bins that are passed both ways, and how many passes there are each way."""
    width = MARGIN * float(np.ptp(apart))
    side, place, travel, values = _steps(motor, width, (apart, force))
    low, high = _common(place, side, width)
    inside = (place >= low) & (place <= high)
    number = np.cumsum(np.diff(side, prepend=side[:1]) != 0.0)
    cell = number * bins + np.clip(((place - low) / (high - low) * bins).astype(np.int64), 0, bins - 1)
    weight = travel * inside
    total = np.bincount(cell, weight)
    kept = np.flatnonzero(total >= LEAST_CELL * (high - low) / bins)
    of_apart, of_side, of_force = (np.bincount(cell, weight * v)[kept] / total[kept] for v in (values[0], side, values[1]))
    middle = low + (np.arange(bins) + 0.5) * (high - low) / bins
    cells = _both_ways(_Cells(of_apart, np.sign(of_side), kept % bins, of_force, middle))
    forward = len(np.unique(kept[of_side > 0.0] // bins))
    return cells, (forward, len(np.unique(kept // bins)) - forward)


def _steps(motor: Array, width: float, values: tuple[Array, ...]) -> tuple[Array, Array, Array, list[Array]]:
    """Return the steps from sample to sample that count: their side, place and travel, and the values in their middle.

    A step is weighed by its own travel, in which the motor's noise takes part; with the middle of the two samples that noise has nothing
    in common, with either of them it would.
    """
    if len(motor) < 2 or not np.ptp(motor) > 0.0:
        raise ResultError("the motor does not move: record it going back and forth")
    step = np.diff(motor)
    side = np.sign(step)
    if width > 0.0:
        sure = pushed(motor, width)
        # Both ends of a step have to be in contact: at speed a step is as long as the gap.
        side = np.where(sure[1:] == sure[:-1], sure[1:], 0.0)
    used = side * step > 0.0
    middles = [(0.5 * (v[1:] + v[:-1]))[used] for v in (motor, *values)]
    return side[used], middles[0], np.abs(step[used]), middles[1:]


def _common(place: Array, side: Array, width: float) -> tuple[float, float]:
    """Return the ends of the stretch that was passed both ways."""
    forward, backward = place[side > 0.0], place[side < 0.0]
    if not (len(forward) and len(backward)):
        way = "backwards" if len(forward) else "forwards"
        raise ResultError(
            f"the motor never goes {way} by more than {MARGIN:g} times the range of motor less load, {1e6 * width / MARGIN:.6g} um: "
            "use longer strokes both ways, or a load scale that agrees with the motor's"
        )
    low, high = max(float(forward.min()), float(backward.min())), min(float(forward.max()), float(backward.max()))
    if not high > low:
        raise ResultError("forwards and backwards the motor goes over different places: go both ways over one place")
    return low, high


def _both_ways(cells: _Cells) -> _Cells:
    """Return the cells of bins that were passed both ways."""
    forward, backward = (np.unique(cells.bin[cells.side == s]) for s in (1.0, -1.0))
    kept = np.isin(cells.bin, np.intersect1d(forward, backward))
    if not kept.any():
        raise ResultError("no place is passed in both directions: go both ways over one place, or use fewer bins")
    return _Cells(cells.apart[kept], cells.side[kept], cells.bin[kept], cells.force[kept], cells.middle)


def _design(cells: _Cells) -> Array:
    """Return the columns (n_cell, 1 + n_bin): half the side, and one for each bin."""
    here = np.unique(cells.bin)
    return np.column_stack([0.5 * cells.side, cells.bin[:, None] == here[None, :]]).astype(float)


def _solved(design: Array, values: Array) -> tuple[list[float], list[float]]:
    """Return the coefficients of least squares, and their standard deviations (nan without a degree of freedom)."""
    inverse = np.linalg.pinv(design)
    found = inverse @ values
    free = len(values) - design.shape[1]
    rest = values - design @ found
    scatter = math.sqrt(float(rest @ rest) / free) if free > 0 else math.nan
    return found.tolist(), (scatter * np.linalg.norm(inverse, axis=1)).tolist()


def _gap_and_stiffness(
    cells: _Cells,
    design: Array,
    found: list[float],
    deviation: list[float],
    measured: bool,
    friction: float | None,
    stiffness: float | None,
) -> tuple[float, float, float]:
    """Return gap, its deviation, and the stiffness."""
    if stiffness is not None and friction is not None:
        return found[0] - 2.0 * friction / stiffness, deviation[0], stiffness
    if not measured:
        return math.nan, math.nan, math.nan if stiffness is None else stiffness
    if stiffness is not None:
        gap, spread = _solved(design, cells.apart - cells.force / stiffness)
        return gap[0], spread[0], stiffness
    own = cells.force - design @ np.linalg.lstsq(design, cells.force, rcond=None)[0]
    if not float(np.linalg.norm(own)) > 0.02 * float(np.linalg.norm(cells.force)):
        raise ResultError("the force varies in its direction alone: give a stiffness to separate windup from the gap")
    both, spread = _solved(np.column_stack([design, cells.force]), cells.apart)
    if not both[-1] > 0.0:
        raise ResultError(
            f"motor less load falls as the force rises, by {-both[-1]:.3g} m/N: give a force that is positive where it pushes forwards"
        )
    return both[0], spread[0], 1.0 / both[-1]


def _by_place(cells: _Cells) -> tuple[Array, Array, Array]:
    """Return places, lost motion there, and its deviation from the scatter between passes, which is taken to be one everywhere."""
    here = np.unique(cells.bin)
    groups: list[list[Any]] = [[cells.apart[(cells.bin == i) & (cells.side == s)] for s in (1.0, -1.0)] for i in here]
    free = sum(len(one) - 1 for pair in groups for one in pair)
    square = sum(float(((one - one.mean()) ** 2).sum()) for pair in groups for one in pair)
    scatter = math.sqrt(square / free) if free > 0 else math.nan
    lost = np.array([forward.mean() - backward.mean() for forward, backward in groups])
    spread = np.array([scatter * math.sqrt(1.0 / len(forward) + 1.0 / len(backward)) for forward, backward in groups])
    return cells.middle[here], lost, spread


def _plateau_gap(apart: Array) -> float:
    """Return the distance between the two places around which motor less load is most often."""
    low, high = np.quantile(apart, [0.01, 0.99])
    middle = 0.5 * (low + high)
    upper, lower = (_plateau(np.sort(half)) for half in (apart[apart >= middle], apart[apart <= middle]))
    return upper - lower


def _plateau(values: Array) -> float:
    """Return the mean of what lies around the mode of sorted values, by three times their own scatter there."""
    away = np.abs(values - _mode(values))
    return float(np.mean(values[away <= 3.0 * 1.4826 * np.median(away)]))


def _mode(values: Array) -> float:
    """Return the half-sample mode of sorted values: the narrowest half, again and again (Robertson & Cryer 1974)."""
    while len(values) > 3:
        n = (len(values) + 1) // 2
        widths = values[n - 1 :] - values[: len(values) - n + 1]
        # Among equals the middle one: steps of an encoder make many.
        least = np.flatnonzero(widths == widths.min())
        start = int(least[len(least) // 2])
        values = values[start : start + n]
    return float(np.mean(values))
