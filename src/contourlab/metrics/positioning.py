"""Bidirectional positioning by ISO 230-2: the same targets approached from both sides, and the difference between the approaches.

Formulas as they are commonly given for ISO 230-2:2014. With x_ij the deviation of approach j to target i, arrows for the direction:

- mean x_i and estimate s_i of the standard uncertainty, for each target and direction;
- reversal value B_i = x_i(up) - x_i(down), reversal value of the axis B = max |B_i|, mean reversal value: the mean of all B_i;
- unidirectional repeatability R_i = 4 s_i; bidirectional R_i = max(2 s_i(up) + 2 s_i(down) + |B_i|, R_i(up), R_i(down)); R = max R_i;
- bidirectional systematic deviation E = max of all means - min of all means.

A load that lags behind its motor by half the gap gives negative reversal values; `lost_motion` is their mean with the other sign.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import ParameterError, ResultError

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class ReversalTest:
    """Targets approached from both sides.

    Attributes
    ----------
    target : ndarray (n,) [m]
        In rising order; those alone that were approached both ways.
    forward, backward : ndarray (n,) [m]
        Mean deviation after approaches in the positive and in the negative direction.
    forward_scatter, backward_scatter : ndarray (n,) [m]
        Their standard deviations s_i from approach to approach (n - 1 in the divisor); nan for a single approach.
    forward_count, backward_count : ndarray (n,) of int
        Approaches.
    reversal_value : ndarray (n,) [m]
        B_i, forward less backward.
    mean_reversal_value : float [m]
    largest_reversal_value : float [m]
        B, the largest magnitude.
    deviation : float [m]
        Standard deviation of the mean reversal value, from the scatter of the approaches pooled over targets; nan without repetitions.
    repeatability : float [m]
        R, bidirectional; nan where a target has a single approach.
    systematic_deviation : float [m]
        E.
    """

    target: Array
    forward: Array
    backward: Array
    forward_scatter: Array
    backward_scatter: Array
    forward_count: NDArray[np.int64]
    backward_count: NDArray[np.int64]
    reversal_value: Array
    mean_reversal_value: float
    largest_reversal_value: float
    deviation: float
    repeatability: float
    systematic_deviation: float

    @property
    def lost_motion(self) -> float:
        """Mean travel by which the measured side falls short after a reversal [m]: the mean reversal value with the other sign."""
        return -self.mean_reversal_value


def reversal_test(
    reference: ArrayLike,
    position: ArrayLike,
    *,
    dwell: int = 50,
    standstill: float = 0.0,
    least_approach: float = 0.0,
    tolerance: float = 1e-6,
) -> ReversalTest:
    """Return the bidirectional positioning of an axis that went to targets from both sides and rested there.

    Parameters
    ----------
    reference : array_like (n,) [m]
        Set point, or position of the motor; the targets are where it rests.
    position : array_like (n,) [m]
        Of the load or table.
    dwell : int
        Least samples of a rest, >= 2. The deviation is the mean of position less reference over the second half of a rest.
    standstill : float [m]
        Range within which the reference counts as standing, >= 0: 0 for one that is computed, a few counts for an encoder.
    least_approach : float [m]
        How far away the reference has to have been last for its direction of approach to count, >= 0; for one that swings into its target,
        more than what it swings by.
    tolerance : float [m]
        Largest distance between the rests at one target, > 0.

    Raises
    ------
    ResultError
        If the records differ in length or are not finite, or no target is approached from both sides.
    ParameterError
        If an option is out of range.
    """
    r, p = np.asarray(reference, dtype=float), np.asarray(position, dtype=float)
    if r.ndim != 1 or r.shape != p.shape:
        raise ResultError(f"reference and position of shapes {r.shape} and {p.shape}: give one number a sample, as many of each")
    if not (np.isfinite(r).all() and np.isfinite(p).all()):
        raise ResultError("reference or position hold numbers that are not finite")
    if dwell != int(dwell) or dwell < 2:
        raise ParameterError("dwell", dwell, "a whole number, 2 or more")
    for name, value in (("standstill", standstill), ("least_approach", least_approach)):
        if not 0.0 <= value < math.inf:
            raise ParameterError(name, value, "finite and >= 0", "m")
    found = []
    for start, stop in _stands(r, int(dwell), standstill):
        level = float(np.median(r[start:stop]))
        way = _approach(r[:start], level, max(least_approach, standstill))
        half = slice((start + stop) // 2, stop)
        if way:
            found.append((level, float(np.mean(p[half] - r[half])), way))
    if not found:
        raise ResultError(
            f"no approach to a stand of {dwell} samples or more: give a reference that moves to its targets and rests there"
        )
    target, deviation, direction = np.array(found).T
    return bidirectional_positioning(target, deviation, direction, tolerance=tolerance)


def bidirectional_positioning(target: ArrayLike, deviation: ArrayLike, direction: ArrayLike, *, tolerance: float = 1e-6) -> ReversalTest:
    """Return the figures of single approaches: target [m], deviation there [m] and direction of approach (its sign), (n,) each.

    Approaches whose targets, in rising order, are no more than `tolerance` apart belong to one target. Targets that were approached from
    one side alone are left out.

    Raises
    ------
    ResultError
        If the arrays differ in length or are not finite, or no target is approached from both sides.
    ParameterError
        If the tolerance is not above zero.
    """
    x, away, way = (np.asarray(values, dtype=float) for values in (target, deviation, direction))
    if x.ndim != 1 or not x.shape == away.shape == way.shape:
        raise ResultError(
            f"targets, deviations and directions of shapes {x.shape}, {away.shape} and {way.shape}: give as many of each"
        )
    if not all(np.isfinite(values).all() for values in (x, away, way)):
        raise ResultError("targets, deviations or directions hold numbers that are not finite")
    if not 0.0 < tolerance < math.inf:
        raise ParameterError("tolerance", tolerance, "finite and > 0", "m")
    order = np.argsort(x, kind="stable")
    x, away, way = x[order], away[order], way[order]
    groups = np.split(np.arange(len(x)), np.flatnonzero(np.diff(x) > tolerance) + 1)
    sets = [(x[g].mean(), away[g][way[g] > 0.0], away[g][way[g] < 0.0]) for g in groups if len(g)]
    both = [one for one in sets if len(one[1]) and len(one[2])]
    if not both:
        raise ResultError(f"{len(sets)} targets, none of them approached from both sides: approach each target up and down")
    return _figures(both)


def _figures(sets: list[tuple[float, Array, Array]]) -> ReversalTest:
    ways = [[one[1] for one in sets], [one[2] for one in sets]]
    up, down = (np.array([values.mean() for values in way]) for way in ways)
    s_up, s_down = (np.array([_scatter(values) for values in way]) for way in ways)
    n_up, n_down = (np.array([len(values) for values in way]) for way in ways)
    reversal = up - down
    free = float((n_up - 1).sum() + (n_down - 1).sum())
    square = float(np.nansum((n_up - 1) * s_up**2) + np.nansum((n_down - 1) * s_down**2))
    pooled = square / free if free > 0.0 else math.nan
    repeat = np.maximum(2.0 * s_up + 2.0 * s_down + np.abs(reversal), np.maximum(4.0 * s_up, 4.0 * s_down))
    means = np.concatenate([up, down])
    return ReversalTest(
        target=np.array([one[0] for one in sets]),
        forward=up,
        backward=down,
        forward_scatter=s_up,
        backward_scatter=s_down,
        forward_count=n_up,
        backward_count=n_down,
        reversal_value=reversal,
        mean_reversal_value=float(reversal.mean()),
        largest_reversal_value=float(np.abs(reversal).max()),
        deviation=math.sqrt(pooled * float((1.0 / n_up + 1.0 / n_down).sum())) / len(sets),
        repeatability=float(repeat.max()),
        systematic_deviation=float(np.ptp(means)),
    )


def _scatter(values: Array) -> float:
    return float(np.std(values, ddof=1)) if len(values) > 1 else math.nan


def _stands(reference: Array, dwell: int, standstill: float) -> list[tuple[int, int]]:
    """Return the stretches [start, stop) in which every window of `dwell` samples keeps within the range of a standstill."""
    from scipy.ndimage import maximum_filter1d, minimum_filter1d

    if len(reference) < dwell:
        return []
    # Windows that begin at each sample.
    first = -(dwell // 2)
    spread = maximum_filter1d(reference, dwell, origin=first) - minimum_filter1d(reference, dwell, origin=first)
    still = np.zeros(len(reference) + 2, dtype=bool)
    still[1 : len(reference) - dwell + 2] = spread[: len(reference) - dwell + 1] <= standstill
    edges = np.flatnonzero(np.diff(still.astype(int)))
    return [(int(a), int(b) + dwell - 1) for a, b in zip(edges[::2], edges[1::2], strict=True)]


def _approach(before: Array, level: float, least: float) -> float:
    """Return the direction of the last way to a level from further off than `least`; 0 where there was none."""
    away = np.flatnonzero(np.abs(before - level) > least)
    return float(np.sign(level - before[away[-1]])) if len(away) else 0.0
