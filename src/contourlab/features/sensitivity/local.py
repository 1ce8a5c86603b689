"""What a small change of each number does, by itself and together with another: central differences whose steps are put to the test."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from contourlab.design import DesignVariable, Space
from contourlab.features.sensitivity.runs import Array, Judge

LARGEST, STEPS = 0.04, 5
"""Largest step in parts of the value, and how many are tried, each half of the one before."""
APART, APART_SHARE = 0.02, 0.05
"""Two steps agree when their sensitivities differ by less than this, and this part of them."""
NOTICED = 0.1
"""Interactions below this are next to nothing, whatever their step."""
CORNER = 0.75
"""At a corner the slopes on the two sides stay apart when the step is halved; on a smooth curve they come half as near."""


@dataclass(frozen=True)
class Slope:
    """The normalised sensitivity S = dJ/dp |p|/J of a figure J to a number p.

    Attributes
    ----------
    number : DesignVariable
    sensitivity : float
        In percent of the figure for each percent of the number; NaN where it cannot be told. Of a number that is 0, for each percent of the
        way between its bounds.
    step : float
        Of the central difference, in parts of the number (of the way between the bounds).
    apart : float
        By how much the sensitivity differs with twice this step.
    below, above : float
        The same by the step below alone, and by the step above alone.
    remark : str
        What speaks against the figure, in words; empty if nothing does.
    """

    number: DesignVariable
    sensitivity: float
    step: float
    apart: float
    below: float
    above: float
    remark: str


@dataclass(frozen=True, eq=False)
class Local:
    """Small changes.

    Attributes
    ----------
    figure : float [SI]
        With all numbers at their values.
    slopes : tuple of Slope
    interactions : ndarray (n, n)
        Second differences d2J/dp_j dp_k |p_j p_k|/J: off the diagonal by how much more the figure grows when both grow, than by each alone.
    interactions_apart : ndarray (n, n)
        By how much they differ with half the step.
    interaction_steps : ndarray (n,)
        Their steps, in parts of each number.
    """

    figure: float
    slopes: tuple[Slope, ...]
    interactions: Array
    interactions_apart: Array
    interaction_steps: Array

    @property
    def doubtful(self) -> NDArray[np.bool_]:
        """Which interactions (n, n) are half off with half the step, and not next to nothing."""
        size = np.abs(self.interactions)
        return (self.interactions_apart >= 0.5 * size) & (size > NOTICED)


def local(space: Space, judge: Judge, limits: Mapping[str, tuple[float, float]] | None = None) -> Local:
    """Return sensitivities and interactions at the values of a space.

    Parameters
    ----------
    space : Space
    judge : callable
    limits : mapping of str to (float, float) [SI]
        What the numbers may be at all, whatever the bounds of the study; no limit by default.

    Notes
    -----
    The step is chosen for each number by itself: of steps of 4, 2, 1, 0.5 and 0.25 percent, the two neighbours whose sensitivities agree
    best, and of these the smaller. A larger step sees the curve bend, a smaller one the counts of an encoder. Where no two agree, or where
    the slopes below and above have different signs and stay apart, the remark says so.
    """
    tops = np.array([_top(number, (limits or {}).get(number.name, (-math.inf, math.inf))) for number in space.numbers])
    figure, ladder = _ladder(space, judge, tops)
    slopes = tuple(_slope(number, top, rows, figure) for number, top, rows in zip(space.numbers, tops, ladder, strict=True))
    full, half = _second(space, judge, np.stack([tops, tops / 2.0]), figure)
    return Local(figure, slopes, full, np.abs(full - half), tops)


def scale(number: DesignVariable) -> float:
    """Return what a step of 1 is [SI]: the number itself, or for 0 the way between its bounds."""
    return abs(number.value) or number.high - number.low


def _top(number: DesignVariable, limits: tuple[float, float]) -> float:
    """Return the largest step to try, in parts: less where the number may not go so far; 0 where it may not go at all."""
    room = min(number.value - limits[0], limits[1] - number.value) / scale(number)
    return min(LARGEST, room) if room > 1e-6 else 0.0


def _judged(space: Space, judge: Judge, moves: Sequence[Mapping[int, float]]) -> Array:
    """Return the figures of runs that move some numbers by some parts of their scales."""
    columns = {number.name: np.full(len(moves), number.value) for number in space.numbers}
    for row, move in enumerate(moves):
        for j, part in move.items():
            number = space.numbers[j]
            columns[number.name][row] = number.value + part * scale(number)
    return judge(columns)


def _ladder(space: Space, judge: Judge, tops: Array) -> tuple[float, Array]:
    """Return the figure as it is, and those (n_number, step, below and above) around it."""
    parts = 0.5 ** np.arange(STEPS)
    moves: list[dict[int, float]] = [{}]
    moves += [{j: sign * top * part} for j, top in enumerate(tops) for part in parts for sign in (-1.0, 1.0)]
    found = _judged(space, judge, moves)
    return float(found[0]), found[1:].reshape(len(tops), STEPS, 2)


def _slope(number: DesignVariable, top: float, rows: Array, figure: float) -> Slope:
    nan = float("nan")
    if top == 0.0:
        return Slope(number, nan, 0.0, nan, nan, nan, "it lies on a bound of what it may be: no difference can be taken on both sides")
    if np.isnan(rows).any():
        return Slope(number, nan, top, nan, nan, nan, f"a change of {100.0 * top:.3g} % makes the run fail")
    steps = top * 0.5 ** np.arange(STEPS)
    below, above = (figure - rows[:, 0]) / (steps * figure), (rows[:, 1] - figure) / (steps * figure)
    central = (below + above) / 2.0
    apart = np.abs(np.diff(central))
    at = int(np.argmin(apart)) + 1
    remark = _remark(central[at], float(apart[at - 1]), below, above, at)
    return Slope(number, float(central[at]), float(steps[at]), float(apart[at - 1]), float(below[at]), float(above[at]), remark)


def _remark(central: float, apart: float, below: Array, above: Array, at: int) -> str:
    bend, wider = abs(above[at] - below[at]), abs(above[at - 1] - below[at - 1])
    if below[at] < 0.0 < above[at] and bend > APART and bend > CORNER * wider:
        return f"a minimum with a corner: the slope is {below[at]:+.2g} below and {above[at]:+.2g} above"
    if apart > APART + APART_SHARE * abs(central):
        return f"steps do not agree: with twice the step it differs by {apart:.2g}, so counts, friction or a corner rule so small a change"
    return ""


def _second(space: Space, judge: Judge, tops: Array, figure: float) -> tuple[Array, Array]:
    """Return the matrix of second differences (n, n) for each row of steps."""
    n = len(space.numbers)
    moves: list[dict[int, float]] = []
    signs = ((1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0))
    pairs = list(combinations(range(n), 2))
    for steps in tops:
        moves += [{j: sign * steps[j]} for j in range(n) for sign in (1.0, -1.0)]
        moves += [{j: a * steps[j], k: b * steps[k]} for j, k in pairs for a, b in signs]
    found = _judged(space, judge, moves).reshape(2, -1)
    made = []
    for steps, values in zip(tops, found, strict=True):
        matrix = np.full((n, n), np.nan)
        with np.errstate(divide="ignore", invalid="ignore"):
            alone, both = values[: 2 * n].reshape(n, 2), values[2 * n :].reshape(-1, 4)
            np.fill_diagonal(matrix, (alone.sum(axis=1) - 2.0 * figure) / (steps**2 * figure))
            for (j, k), (pp, pm, mp, mm) in zip(pairs, both, strict=True):
                matrix[j, k] = matrix[k, j] = (pp - pm - mp + mm) / (4.0 * steps[j] * steps[k] * figure)
        matrix[~np.isfinite(matrix)] = np.nan
        made.append(matrix)
    return made[0], made[1]
