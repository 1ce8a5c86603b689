"""What a study of a log comes to, whatever the model: figures with deviations, a fit, remarks, pictures, tables of an axis file."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.components.origin import Origin

Array = NDArray[np.float64]
Row = tuple[float | str, str, Origin | None]
"""A value in SI, its unit there, and where it is from; None for a word."""
Tables = Mapping[str, Mapping[str, Row]]
"""Of an axis file, by table and key."""
Drawn = tuple[Array, Array] | tuple[Array, Array, Array]
"""A line through (x, y); with a third array points, and half the heights of the bars at them."""
UNTOLD = "at the bound of what is looked for: the log does not tell it"
ROOM = 0.2
"""Share by which a limit in an axis file lies above the largest in the log: what was reached would bar the motion that reached it."""


@dataclass(frozen=True)
class Figure:
    """A number found from a log.

    Attributes
    ----------
    name : str
    value : float
        In SI.
    unit : str
    deviation : float
        Standard deviation for a white residual; 0 for a number at the bound of what was looked for, which has none.
    robust_deviation : float
        The same for one that is correlated.
    """

    name: str
    value: float
    unit: str
    deviation: float
    robust_deviation: float


@dataclass(frozen=True, eq=False)
class Graph:
    """Curves, or points with bars, on one pair of axes, each in the units of its label."""

    x_label: str
    y_label: str
    curves: Mapping[str, Drawn]
    log_x: bool = False
    log_y: bool = False


@dataclass(frozen=True, eq=False)
class Picture:
    """Graphs under one another over one x axis."""

    key: str
    title: str
    graphs: tuple[Graph, ...]
    caption: str = ""


@dataclass(frozen=True, eq=False)
class Finding:
    """What a model's study found.

    Attributes
    ----------
    model, axis : str
    sources : tuple of str
        Names of the logs.
    figures : tuple of Figure
    fit : float or None [percent]
        100 (1 - |measured - model|/|measured - mean|); None where nothing is fitted.
    usable : bool
        False where the figures cannot be taken as they stand; then no axis file is written.
    remarks : tuple of str
    tables : Tables
        Of the axis file; empty where there is nothing to write.
    pictures : tuple of Picture
    lines : tuple of str
        What else to print.
    more : mapping
        What else to say in JSON.
    correlations : tuple of (str, str, float)
        Of numbers of the axis file, by their names there, such as ``"plant.mass"``.
    """

    model: str
    axis: str
    sources: tuple[str, ...]
    figures: tuple[Figure, ...]
    fit: float | None
    usable: bool
    remarks: tuple[str, ...] = ()
    tables: Tables = field(default_factory=dict)
    pictures: tuple[Picture, ...] = ()
    lines: tuple[str, ...] = ()
    more: Mapping[str, Any] = field(default_factory=dict)
    correlations: tuple[tuple[str, str, float], ...] = ()


@dataclass(frozen=True, eq=False)
class Carried:
    """What the numbers of an axis file are worth, by their names there: deviations, and correlations two by two."""

    deviations: Mapping[str, float]
    correlations: tuple[tuple[str, str, float], ...]


def carried(
    numbers: Callable[[Mapping[str, float]], Mapping[str, float]],
    names: Sequence[str],
    values: Array,
    deviations: Array,
    correlation: Array,
) -> Carried:
    """Carry what is known of the parameters of a fit to the numbers of an axis file.

    Parameters
    ----------
    numbers : callable
        From the parameters by name to the numbers by theirs, such as ``"plant.mass"``.
    names : sequence of str
        Of the parameters.
    values, deviations : ndarray (p,)
        A parameter without a deviation, as one at its bound, adds nothing.
    correlation : ndarray (p, p)

    Notes
    -----
    First order: S = D C D', with D the effect of one deviation of each parameter on the numbers.
    """
    columns, small = [], 1e-3
    for i, deviation in enumerate(deviations.tolist()):
        step = np.zeros(values.size)
        step[i] = small * deviation
        up, down = (numbers(dict(zip(names, (values + way * step).tolist(), strict=True))) for way in (1.0, -1.0))
        columns.append([(up[name] - down[name]) / (2.0 * small) for name in up])
    effect = np.array(columns).T
    covariance = effect @ correlation @ effect.T
    sizes = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    of = list(numbers(dict(zip(names, values.tolist(), strict=True))))
    known = [i for i, size in enumerate(sizes.tolist()) if 0.0 < size < float("inf")]
    pairs = ((of[i], of[j], round(float(covariance[i, j] / (sizes[i] * sizes[j])), 4)) for i, j in combinations(known, 2))
    return Carried(dict(zip(of, sizes.tolist(), strict=True)), tuple(pair for pair in pairs if pair[2]))


def fitted(log: str, deviation: float | None = None, note: str = "") -> Origin:
    """Return the origin of a number fitted to a log; a deviation that is none is left out."""
    known = deviation is not None and 0.0 < deviation < float("inf")
    return Origin("fitted", deviation=deviation if known else None, reference=log, note=note)


def told(log: str, deviation: float, note: str = "") -> Origin:
    """Return the origin of a number out of a fit: fitted where it has a deviation; without one it stands at its bound, and is assumed."""
    return fitted(log, deviation, note) if deviation > 0.0 else Origin("assumed", reference=log, note=UNTOLD)


def reached(log: str, note: str) -> Origin:
    """Return the origin of a number read off a log."""
    return Origin("measured", reference=log, note=note)


def assumed(note: str) -> Origin:
    """Return the origin of a number that the log does not tell."""
    return Origin("assumed", note=note)


def of_command(unit: str) -> str:
    """Return the label of a command on a picture: in its unit, where it has one.

    >>> of_command("V"), of_command("")
    ('command [V]', 'command')
    """
    return f"command [{unit}]" if unit else "command"
