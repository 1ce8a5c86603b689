"""One parameter at a time: the figure over each parameter; and small changes of one and of two, by tested central differences."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from contourlab.arrays import Array, Flags, true_spans
from contourlab.features.sensitivity.options import FINE, STEPS
from contourlab.findings import Finding, finding
from contourlab.study import DesignVariable, Space
from contourlab.study.runner import Columns, Judge

CHANGE = 0.05
"""Largest relative change of the figure over a flat interval."""
SHARE = 0.25
"""Smallest share of the values in a flat interval."""


@dataclass(frozen=True)
class Interval:
    """An interval [SI]; `first` and `last` tell whether it includes the first and the last value tried."""

    low: float
    high: float
    first: bool
    last: bool


@dataclass(frozen=True)
class Minimum:
    """Where a figure is smallest.

    Attributes
    ----------
    value : float [SI]
        Value of the parameter.
    figure : float [SI]
    within : float [SI]
        Largest distance to a neighbouring value tried.
    bound : str
        ``"lower"`` or ``"upper"`` if it lies on that bound: the figure may be smaller beyond it. Else empty.
    """

    value: float
    figure: float
    within: float
    bound: str


@dataclass(frozen=True, eq=False)
class Curve:
    """A figure over one parameter.

    Attributes
    ----------
    variable : DesignVariable
    values : ndarray (n,) [SI]
        Values of the parameter, increasing.
    figures : ndarray (n,) [SI]
        nan where the run failed.
    minimum : Minimum or None
        None if all runs failed.
    flat : Interval or None
        The longest interval over which the figure changes by less than `CHANGE`, if it contains at least `SHARE` of the values.
    failed : tuple of Interval
        Where runs fail.
    """

    variable: DesignVariable
    values: Array
    figures: Array
    minimum: Minimum | None
    flat: Interval | None
    failed: tuple[Interval, ...]


def curves(space: Space, judge: Judge, count: int = 41) -> tuple[Curve, ...]:
    """Return the curve of each parameter between its bounds, the others at their present values.

    Parameters
    ----------
    space : Space
    judge : callable
    count : int, >= 5
        Values of each curve, equal factors apart if the parameter is logarithmic, else equally spaced.

    Notes
    -----
    Runs locate the minimum, not a parabola through three of them: the curve has a corner where the sign of an error changes.
    """
    places = np.linspace(0.0, 1.0, count)
    grids = [variable.physical(places) for variable in space.numbers]
    figures = np.split(judge(one_at_a_time(space, grids)), len(grids))
    near: list[Array] = []
    for variable, values in zip(space.numbers, figures, strict=True):
        at = 0 if np.isnan(values).all() else int(np.nanargmin(values))
        low, high = max(at - 1, 0), min(at + 1, count - 1)
        near.append(variable.physical(np.linspace(places[low], places[high], FINE * (high - low) + 1)))
    fine = np.split(judge(one_at_a_time(space, near)), np.cumsum([len(grid) for grid in near])[:-1])
    return tuple(
        Curve(
            variable,
            grid,
            values,
            _minimum(variable, *close),
            _flat(grid, values),
            tuple(_interval(grid, a, b - 1) for a, b in true_spans(np.isnan(values))),
        )
        for variable, grid, values, *close in zip(space.numbers, grids, figures, near, fine, strict=True)
    )


def present_values(space: Space, runs: int = 1) -> dict[str, Array]:
    """Return the present values [SI] of all parameters, for so many runs."""
    return {variable.name: np.full(runs, variable.value) for variable in space.numbers}


def one_at_a_time(space: Space, grids: Sequence[Array]) -> Columns:
    """Return the values of runs that move one parameter at a time through its grid, grid after grid."""
    columns, first = present_values(space, sum(map(len, grids))), 0
    for variable, grid in zip(space.numbers, grids, strict=True):
        columns[variable.name][first : first + len(grid)] = grid
        first += len(grid)
    return columns


def _minimum(variable: DesignVariable, values: Array, figures: Array) -> Minimum | None:
    if np.isnan(figures).all():
        return None
    at = int(np.nanargmin(figures))
    steps = np.abs(values[[max(at - 1, 0), min(at + 1, len(values) - 1)]] - values[at])
    bound = "lower" if values[at] <= variable.low else "upper" if values[at] >= variable.high else ""
    return Minimum(float(values[at]), float(figures[at]), float(steps.max()), bound)


def _flat(values: Array, figures: Array) -> Interval | None:
    """Return the longest flat interval; of two equally long ones, that with larger values."""
    best = (0, 0, 0)
    first = 0
    for last in range(len(values)):
        while first <= last and not ((part := figures[first : last + 1]).max() <= (1.0 + CHANGE) * part.min()):  # nan is not flat
            first += 1
        if last >= first and last - first + 1 >= best[0]:
            best = last - first + 1, first, last
    return _interval(values, *best[1:]) if best[0] and best[0] >= SHARE * len(values) else None


def _interval(values: Array, a: int, b: int) -> Interval:
    return Interval(float(values[a]), float(values[b]), a == 0, b == len(values) - 1)


LARGEST = 0.04
"""Largest step relative to the value; each of `STEPS` is half the one before."""
AGREE, AGREE_SHARE = 0.02, 0.05
"""Two steps agree if their sensitivities differ by at most `AGREE` + `AGREE_SHARE` times the sensitivity."""
NOTICED = 0.1
"""Interactions below this are negligible for any step."""
CORNER = 0.75
"""Smallest ratio at a corner by which halving the step changes the difference of the two slopes: 0.5 on a smooth curve, 1 at a corner."""


@dataclass(frozen=True)
class Slope:
    """The normalised sensitivity S = dJ/dp |p|/J of a figure J to a parameter p.

    Attributes
    ----------
    variable : DesignVariable
    sensitivity : float
        Percent of the figure per percent of the parameter; nan if unknown. For a parameter at 0, per percent of its range.
    step : float
        Step of the central difference, relative to the parameter (or its range).
    difference : float
        Difference to the sensitivity with twice this step.
    below, above : float
        One-sided sensitivities, from the step below and from the step above.
    doubt : Finding or None
        Why the sensitivity is doubtful.
    """

    variable: DesignVariable
    sensitivity: float
    step: float
    difference: float
    below: float
    above: float
    doubt: Finding | None


@dataclass(frozen=True, eq=False)
class Local:
    """Effects of small changes.

    Attributes
    ----------
    slopes : tuple of Slope
    interactions : ndarray (n, n)
        Second differences d2J/dp_j dp_k |p_j p_k|/J. Off the diagonal: the growth of the figure when both grow, beyond that of each alone.
    interaction_differences : ndarray (n, n)
        Difference to the interactions with half the step.
    interaction_steps : ndarray (n,)
        Step of each parameter, relative to its value.
    """

    slopes: tuple[Slope, ...]
    interactions: Array
    interaction_differences: Array
    interaction_steps: Array

    @property
    def doubtful(self) -> Flags:
        """Interactions (n, n) that are not negligible and change by half or more with half the step."""
        size = np.abs(self.interactions)
        return (self.interaction_differences >= 0.5 * size) & (size > NOTICED)


def local(space: Space, judge: Judge) -> Local:
    """Return sensitivities and interactions at the present values of a space.

    Parameters
    ----------
    space : Space
    judge : callable

    Notes
    -----
    The step is chosen for each parameter from 4, 2, 1, 0.5 and 0.25 percent: the smaller of the two neighbours whose sensitivities agree
    best. A larger step suffers from curvature, a smaller one from encoder counts.
    """
    tops = np.array([_top(variable) for variable in space.numbers])
    figure, ladder = _ladder(space, judge, tops)
    slopes = tuple(_slope(variable, top, rows, figure) for variable, top, rows in zip(space.numbers, tops, ladder, strict=True))
    full, half = _second(space, judge, np.stack([tops, tops / 2.0]), figure)
    return Local(slopes, full, np.abs(full - half), tops)


def _scale(variable: DesignVariable) -> float:
    """Return the size [SI] of a relative step of 1: the value, or the range of a parameter at 0."""
    return abs(variable.value) or variable.high - variable.low


def _top(variable: DesignVariable) -> float:
    """Return the largest relative step, reduced to what the component accepts; 0 if it accepts none."""
    room = min(variable.value - variable.least, variable.most - variable.value) / _scale(variable)
    return min(LARGEST, room) if room > 1e-6 else 0.0


def _judged(space: Space, judge: Judge, moves: Sequence[Mapping[int, float]]) -> Array:
    """Return the figures of runs that move some parameters by relative steps."""
    columns = present_values(space, len(moves))
    for row, move in enumerate(moves):
        for j, part in move.items():
            variable = space.numbers[j]
            columns[variable.name][row] = variable.value + part * _scale(variable)
    return judge(columns)


def _ladder(space: Space, judge: Judge, tops: Array) -> tuple[float, Array]:
    """Return the present figure, and the figures around it (n_parameter, step, below and above)."""
    parts = 0.5 ** np.arange(STEPS)
    moves: list[dict[int, float]] = [{}]
    moves += [{j: sign * top * part} for j, top in enumerate(tops) for part in parts for sign in (-1.0, 1.0)]
    figures = _judged(space, judge, moves)
    return float(figures[0]), figures[1:].reshape(len(tops), STEPS, 2)


def _slope(variable: DesignVariable, top: float, rows: Array, figure: float) -> Slope:
    nan, place = float("nan"), variable.short
    if top == 0.0:
        return Slope(variable, nan, 0.0, nan, nan, nan, finding("CL670", place))
    if np.isnan(rows).any():
        return Slope(variable, nan, top, nan, nan, nan, finding("CL671", place))
    steps = top * 0.5 ** np.arange(STEPS)
    below, above = (figure - rows[:, 0]) / (steps * figure), (rows[:, 1] - figure) / (steps * figure)
    central = (below + above) / 2.0
    differences = np.abs(np.diff(central))
    at = int(np.argmin(differences)) + 1
    difference = float(differences[at - 1])
    bend, wider = abs(above[at] - below[at]), abs(above[at - 1] - below[at - 1])
    doubt = None
    if below[at] < 0.0 < above[at] and bend > AGREE and bend > CORNER * wider:
        doubt = finding("CL672", place)
    elif difference > AGREE + AGREE_SHARE * abs(central[at]):
        doubt = finding("CL673", place)
    return Slope(variable, float(central[at]), float(steps[at]), difference, float(below[at]), float(above[at]), doubt)


def _second(space: Space, judge: Judge, tops: Array, figure: float) -> tuple[Array, Array]:
    """Return the matrices of second differences (n, n), one for each of the two rows of steps."""
    n = len(space.numbers)
    moves: list[dict[int, float]] = []
    signs = ((1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0))
    pairs = list(combinations(range(n), 2))
    for steps in tops:
        moves += [{j: sign * steps[j]} for j in range(n) for sign in (1.0, -1.0)]
        moves += [{j: a * steps[j], k: b * steps[k]} for j, k in pairs for a, b in signs]
    matrices = []
    for steps, values in zip(tops, _judged(space, judge, moves).reshape(2, -1), strict=True):
        matrix = np.full((n, n), np.nan)
        with np.errstate(divide="ignore", invalid="ignore"):
            alone, both = values[: 2 * n].reshape(n, 2), values[2 * n :].reshape(-1, 4)
            np.fill_diagonal(matrix, (alone.sum(axis=1) - 2.0 * figure) / (steps**2 * figure))
            for (j, k), (pp, pm, mp, mm) in zip(pairs, both, strict=True):
                matrix[j, k] = matrix[k, j] = (pp - pm - mp + mm) / (4.0 * steps[j] * steps[k] * figure)
        matrix[~np.isfinite(matrix)] = np.nan
        matrices.append(matrix)
    return matrices[0], matrices[1]
