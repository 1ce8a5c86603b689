"""One number at a time: the figure over each number with the others as they are, the minimum, and where it hardly matters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.design import DesignVariable, Space
from contourlab.errors import ParameterError
from contourlab.features.sensitivity.runs import Array, Columns, Judge

CHANGE = 0.05
"""Part by which the figure may change over a stretch that is called flat."""
SHARE = 0.25
"""Part of the values that such a stretch has at least."""
FINE = 16
"""Steps into which the two steps around the smallest value are divided."""


@dataclass(frozen=True)
class Stretch:
    """From where to where [SI]; `first` and `last` say whether it begins and ends with the values that were tried."""

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
        Of the number.
    figure : float [SI]
    within : float [SI]
        The next value that was tried lies this far away.
    bound : str
        ``"lower"`` or ``"upper"`` where it lies on a bound, so that it may be smaller beyond; else empty.
    """

    value: float
    figure: float
    within: float
    bound: str


@dataclass(frozen=True, eq=False)
class Curve:
    """A figure over one number.

    Attributes
    ----------
    number : DesignVariable
    values : ndarray (n,) [SI]
        Of the number, rising.
    figures : ndarray (n,) [SI]
        NaN where the run failed.
    minimum : Minimum or None
        None where all runs failed.
    flat : Stretch or None
        The longest stretch over which the figure changes by less than `CHANGE`, if it has at least `SHARE` of the values.
    failed : tuple of Stretch
        Where runs fail.
    """

    number: DesignVariable
    values: Array
    figures: Array
    minimum: Minimum | None
    flat: Stretch | None
    failed: tuple[Stretch, ...]


def curves(space: Space, judge: Judge, count: int = 41) -> tuple[Curve, ...]:
    """Return the curve of each number between its bounds, the others at their values.

    Parameters
    ----------
    space : Space
    judge : callable
    count : int, >= 5
        Values of each number: equal factors apart where the number is logarithmic, else equal steps.

    Raises
    ------
    ParameterError
        If there are fewer than five values.

    Notes
    -----
    The minimum is located by runs, not by a parabola through three of them: where the sign of an error changes the curve has a corner.
    """
    check_values(count)
    grids = [number.physical(np.linspace(0.0, 1.0, count)) for number in space.numbers]
    figures = np.split(judge(one_at_a_time(space, grids)), len(grids))
    around: list[Array] = []
    for number, found in zip(space.numbers, figures, strict=True):
        places = np.linspace(0.0, 1.0, count)
        at = 0 if np.isnan(found).all() else int(np.nanargmin(found))
        low, high = max(at - 1, 0), min(at + 1, count - 1)
        around.append(number.physical(np.linspace(places[low], places[high], FINE * (high - low) + 1)))
    finer = np.split(judge(one_at_a_time(space, around)), np.cumsum([len(grid) for grid in around])[:-1])
    return tuple(
        Curve(number, grid, found, _minimum(number, near, fine), _flat(grid, found), _failed(grid, found))
        for number, grid, found, near, fine in zip(space.numbers, grids, figures, around, finer, strict=True)
    )


def check_values(count: int) -> None:
    """See that a curve has values enough; raises `ParameterError` if not."""
    if count < 5:
        raise ParameterError("--values", f"{count}", "5 or more")


def one_at_a_time(space: Space, grids: Sequence[Array]) -> Columns:
    """Return the values of runs that each move one number through its grid, grid after grid."""
    total = sum(len(grid) for grid in grids)
    columns = {number.name: np.full(total, number.value) for number in space.numbers}
    first = 0
    for number, grid in zip(space.numbers, grids, strict=True):
        columns[number.name][first : first + len(grid)] = grid
        first += len(grid)
    return columns


def _minimum(number: DesignVariable, values: Array, figures: Array) -> Minimum | None:
    if np.isnan(figures).all():
        return None
    at = int(np.nanargmin(figures))
    steps = np.abs(values[[max(at - 1, 0), min(at + 1, len(values) - 1)]] - values[at])
    bound = "lower" if values[at] <= number.low else "upper" if values[at] >= number.high else ""
    return Minimum(float(values[at]), float(figures[at]), float(steps.max()), bound)


def _flat(values: Array, figures: Array) -> Stretch | None:
    """Return the longest stretch over which the figure changes by less than `CHANGE`; of two as long, the one of larger values."""
    best: tuple[int, int, int] | None = None
    first = 0
    for last in range(len(values)):
        while first <= last and not _level(figures[first : last + 1]):
            first += 1
        if last >= first and (best is None or last - first + 1 >= best[0]):
            best = last - first + 1, first, last
    if best is None or best[0] < SHARE * len(values):
        return None
    return _stretch(values, best[1], best[2])


def _level(part: Array) -> bool:
    return bool(np.isfinite(part).all() and part.max() <= (1.0 + CHANGE) * part.min())


def _failed(values: Array, figures: Array) -> tuple[Stretch, ...]:
    bad: NDArray[np.bool_] = np.isnan(figures)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], bad, [False]]).astype(int)))
    return tuple(_stretch(values, int(a), int(b) - 1) for a, b in zip(edges[::2], edges[1::2], strict=True))


def _stretch(values: Array, a: int, b: int) -> Stretch:
    return Stretch(float(values[a]), float(values[b]), a == 0, b == len(values) - 1)
