"""One parameter at a time: the figure over each parameter, its minimum, and where it hardly changes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array, Flags, true_spans
from contourlab.study import DesignVariable, Space
from contourlab.study.runner import Columns, Judge

CHANGE = 0.05
"""Largest relative change of the figure over a flat interval."""
SHARE = 0.25
"""Smallest share of the values in a flat interval."""
FINE = 16
"""Subdivisions of each of the two steps around the smallest figure."""


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
        Curve(variable, grid, values, _minimum(variable, *close), _flat(grid, values), _intervals(grid, np.isnan(values)))
        for variable, grid, values, *close in zip(space.numbers, grids, figures, near, fine, strict=True)
    )


def one_at_a_time(space: Space, grids: Sequence[Array]) -> Columns:
    """Return the values of runs that move one parameter at a time through its grid, grid after grid."""
    total = sum(len(grid) for grid in grids)
    columns = {variable.name: np.full(total, variable.value) for variable in space.numbers}
    first = 0
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
        while first <= last and not _is_flat(figures[first : last + 1]):
            first += 1
        if last >= first and last - first + 1 >= best[0]:
            best = last - first + 1, first, last
    return _interval(values, *best[1:]) if best[0] and best[0] >= SHARE * len(values) else None


def _is_flat(part: Array) -> bool:
    return bool(np.isfinite(part).all() and part.max() <= (1.0 + CHANGE) * part.min())


def _intervals(values: Array, which: Flags) -> tuple[Interval, ...]:
    """Return the intervals over which a condition holds."""
    return tuple(_interval(values, a, b - 1) for a, b in true_spans(which))


def _interval(values: Array, a: int, b: int) -> Interval:
    return Interval(float(values[a]), float(values[b]), a == 0, b == len(values) - 1)
