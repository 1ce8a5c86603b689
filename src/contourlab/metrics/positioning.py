"""Bidirectional positioning by ISO 230-2: the same targets approached from both sides.

Formulas as commonly given for ISO 230-2:2014. For each target i and direction (up, down), over the approaches:

- mean deviation x_i and standard deviation s_i;
- reversal value B_i = x_i(up) - x_i(down), of the axis B = max |B_i|, mean reversal value: the mean of all B_i;
- unidirectional repeatability R_i = 4 s_i; bidirectional R_i = max(2 s_i(up) + 2 s_i(down) + |B_i|, R_i(up), R_i(down)); R = max R_i;
- bidirectional systematic deviation E = max of all means - min of all means.

A load that lags behind its motor gives negative reversal values; `lost_motion` is their mean with opposite sign.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Index
from contourlab.errors import ParameterError, ResultError
from contourlab.metrics.records import check_positive, records


@dataclass(frozen=True, eq=False)
class ReversalTest:
    """Targets approached from both sides.

    Attributes
    ----------
    target : ndarray (n,) [m]
        Rising; only targets approached both ways.
    forward, backward : ndarray (n,) [m]
        Mean deviation after approaches in positive and in negative direction.
    forward_scatter, backward_scatter : ndarray (n,) [m]
        Standard deviations s_i between approaches (divisor n - 1); nan for a single approach.
    forward_count, backward_count : ndarray (n,) of int
        Number of approaches.
    reversal_value : ndarray (n,) [m]
        B_i, forward less backward.
    mean_reversal_value : float [m]
    largest_reversal_value : float [m]
        B, the largest magnitude.
    deviation : float [m]
        Standard deviation of the mean reversal value, from the pooled scatter of the approaches; nan without repetitions.
    repeatability : float [m]
        R, bidirectional; nan if a target has a single approach.
    systematic_deviation : float [m]
        E.
    """

    target: Array
    forward: Array
    backward: Array
    forward_scatter: Array
    backward_scatter: Array
    forward_count: Index
    backward_count: Index
    reversal_value: Array
    mean_reversal_value: float
    largest_reversal_value: float
    deviation: float
    repeatability: float
    systematic_deviation: float

    @property
    def lost_motion(self) -> float:
        """Mean travel lost at a reversal [m]: the mean reversal value with opposite sign."""
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
        Set point, or motor position; it rests at the targets.
    position : array_like (n,) [m]
        Of the load or table.
    dwell : int
        Least number of samples of a rest, >= 2. The deviation is the mean of position less reference over the second half of a rest.
    standstill : float [m]
        Range of the reference during a rest, >= 0: 0 if it is computed, a few counts for an encoder.
    least_approach : float [m]
        Least distance from the target that gives the direction of approach, >= 0; more than the overshoot of a reference that swings.
    tolerance : float [m]
        Largest distance between rests at one target, > 0.

    Raises
    ------
    ResultError
        If the records differ in length or are not finite, or no target is approached from both sides.
    ParameterError
        If an option is out of range.
    """
    r, p = records(reference=reference, position=position)
    if dwell != int(dwell) or dwell < 2:
        raise ParameterError("dwell", dwell, "a whole number, 2 or more")
    check_positive("standstill", standstill, "m", or_zero=True)
    check_positive("least_approach", least_approach, "m", or_zero=True)
    approaches = []
    for start, stop in _stands(r, int(dwell), standstill):
        level = float(np.median(r[start:stop]))
        direction = _approach(r[:start], level, max(least_approach, standstill))
        half = slice((start + stop) // 2, stop)
        if direction:
            approaches.append((level, float(np.mean(p[half] - r[half])), direction))
    if not approaches:
        raise ResultError(
            f"no approach to a stand of {dwell} samples or more: give a reference that moves to its targets and rests there"
        )
    target, deviation, directions = np.array(approaches).T
    return bidirectional_positioning(target, deviation, directions, tolerance=tolerance)


def bidirectional_positioning(target: ArrayLike, deviation: ArrayLike, direction: ArrayLike, *, tolerance: float = 1e-6) -> ReversalTest:
    """Return the positioning from single approaches (n,): target [m], deviation there [m] and direction (its sign).

    Targets up to `tolerance` from the next are one target. Targets approached from one side only are left out.

    Raises
    ------
    ResultError
        If the arrays differ in length or are not finite, or no target is approached from both sides.
    ParameterError
        If the tolerance is not above zero.
    """
    x, away, way = records(target=target, deviation=deviation, direction=direction)
    check_positive("tolerance", tolerance, "m")
    order = np.argsort(x, kind="stable")
    x, away, way = x[order], away[order], way[order]
    groups = np.split(np.arange(len(x)), np.flatnonzero(np.diff(x) > tolerance) + 1)
    sets = [(x[g].mean(), away[g][way[g] > 0.0], away[g][way[g] < 0.0]) for g in groups if len(g)]
    both = [(at, up, down) for at, up, down in sets if len(up) and len(down)]
    if not both:
        raise ResultError(f"{len(sets)} targets, none of them approached from both sides: approach each target up and down")
    return _figures(both)


def _figures(sets: list[tuple[float, Array, Array]]) -> ReversalTest:
    target, *ways = zip(*sets, strict=True)
    up, down = (np.array([values.mean() for values in way]) for way in ways)
    s_up, s_down = (np.array([np.std(values, ddof=1) if len(values) > 1 else math.nan for values in way]) for way in ways)
    n_up, n_down = (np.array([len(values) for values in way]) for way in ways)
    reversal = up - down
    free = float((n_up - 1).sum() + (n_down - 1).sum())
    square = float(np.nansum((n_up - 1) * s_up**2) + np.nansum((n_down - 1) * s_down**2))
    pooled = square / free if free > 0.0 else math.nan
    repeat = np.maximum(2.0 * s_up + 2.0 * s_down + np.abs(reversal), np.maximum(4.0 * s_up, 4.0 * s_down))
    return ReversalTest(
        target=np.array(target),
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
        systematic_deviation=float(np.ptp([up, down])),
    )


def _stands(reference: Array, dwell: int, standstill: float) -> list[tuple[int, int]]:
    """Return the ranges [start, stop) of samples in which every window of `dwell` samples is at a standstill."""
    from scipy.ndimage import maximum_filter1d, minimum_filter1d

    if len(reference) < dwell:
        return []
    # Windows start at each sample.
    first = -(dwell // 2)
    spread = maximum_filter1d(reference, dwell, origin=first) - minimum_filter1d(reference, dwell, origin=first)
    still = np.zeros(len(reference) + 2, dtype=bool)
    still[1 : len(reference) - dwell + 2] = spread[: len(reference) - dwell + 1] <= standstill
    edges = np.flatnonzero(np.diff(still.astype(int)))
    return [(int(a), int(b) + dwell - 1) for a, b in zip(edges[::2], edges[1::2], strict=True)]


def _approach(before: Array, level: float, least: float) -> float:
    """Return the direction in which a level was last approached from more than `least` away; 0 if it never was."""
    away = np.flatnonzero(np.abs(before - level) > least)
    return float(np.sign(level - before[away[-1]])) if len(away) else 0.0
