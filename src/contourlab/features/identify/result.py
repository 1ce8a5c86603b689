"""Result of an identification: parameters with deviations, findings, pictures, tables of an axis file."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.app.json_values import HIDDEN
from contourlab.arrays import Array
from contourlab.components.origin import Origin
from contourlab.findings import Finding
from contourlab.rendering.table import Table

Row = tuple[float | str, str, Origin | None]
"""A value in SI, its unit, and its origin (None for a word)."""
Tables = Mapping[str, Mapping[str, Row]]
"""Rows of an axis file, by table and key."""
Drawn = tuple[Array, Array] | tuple[Array, Array, Array]
"""A line through (x, y); with a third array: points, and half the heights of their error bars."""
AT_BOUND = "at the bound of the search: the log does not determine it"


@dataclass(frozen=True)
class Figure:
    """An identified parameter.

    Attributes
    ----------
    value : float
        In SI.
    deviation : float
        Standard deviation for a white residual; nan at the bound of the search.
    robust_deviation : float
        Standard deviation for a correlated residual.
    """

    value: float
    unit: str
    deviation: float
    robust_deviation: float


@dataclass(frozen=True, eq=False)
class Graph:
    """Curves, or points with error bars, on one pair of axes, in the units of the labels."""

    x_label: str
    y_label: str
    curves: Mapping[str, Drawn]
    log_x: bool = False
    log_y: bool = False


@dataclass(frozen=True, eq=False)
class Picture:
    """Graphs, one below the other, with a common x axis."""

    key: str
    title: str
    graphs: tuple[Graph, ...]
    caption: str = ""


@dataclass(frozen=True, eq=False)
class Identified:
    """An identified model.

    Attributes
    ----------
    fit_percent : float or None
        100 (1 - |measured - model|/|measured - mean|); None if nothing is fitted.
    usable : bool
        Whether the parameters are usable; if not, no axis file is written.
    details : mapping
        Further results of the model.
    lines : tuple of str
        Further lines of text.
    points : Table or None
        Table printed below the lines.
    tables : Tables
        Tables of the axis file; empty if there is none.
    correlations : tuple of (str, str, float)
        Correlations between parameters of the axis file, such as ``"plant.mass"``.
    axis_file : Path or None
        The file that was written, if any.
    """

    model: str
    axis: str
    logs: tuple[str, ...]
    parameters: dict[str, Figure]
    fit_percent: float | None
    usable: bool
    findings: tuple[Finding, ...] = ()
    details: Mapping[str, Any] = field(default_factory=dict)
    lines: tuple[str, ...] = field(default=(), metadata=HIDDEN)
    points: Table | None = field(default=None, metadata=HIDDEN)
    tables: Tables = field(default_factory=dict, metadata=HIDDEN)
    correlations: tuple[tuple[str, str, float], ...] = field(default=(), metadata=HIDDEN)
    pictures: tuple[Picture, ...] = field(default=(), metadata=HIDDEN)
    axis_file: Path | None = None


def figures(names: Sequence[str], values: Array, deviations: Array, robust: Array, units: Callable[[str], str]) -> dict[str, Figure]:
    """Return the parameters of a fit by name."""
    rows = zip(names, values.tolist(), deviations.tolist(), robust.tolist(), strict=True)
    return {name: Figure(value, units(name), white or math.nan, coloured or math.nan) for name, value, white, coloured in rows}


@dataclass(frozen=True, eq=False)
class Propagated:
    """Uncertainty of the parameters of an axis file, by name: deviations, and correlations of pairs; the log, and a note on the method."""

    deviations: Mapping[str, float] = field(default_factory=dict)
    correlations: tuple[tuple[str, str, float], ...] = ()
    log: str = ""
    note: str = ""

    def origin(self, name: str, note: str = "") -> Origin:
        """Return the origin of a parameter: fitted, or assumed if the fit lacks it, or if it is at its bound and so has no deviation."""
        deviation = self.deviations.get(name)
        if deviation is None or not deviation > 0.0:
            return Origin("assumed", reference=self.log, note="not visible in the log" if deviation is None else AT_BOUND)
        return fitted(self.log, deviation, note or self.note)


def propagate(
    numbers: Callable[[Mapping[str, float]], Mapping[str, float]],
    names: Sequence[str],
    values: Array,
    deviations: Array,
    correlation: Array,
    log: str = "",
    note: str = "",
) -> Propagated:
    """Propagate the uncertainty of fitted parameters to the parameters of an axis file.

    Parameters
    ----------
    numbers : callable
        Maps fitted parameters to those of the axis file, such as ``"plant.mass"``, both by name.
    names : sequence of str
        Names of the fitted parameters.
    values, deviations : ndarray (p,)
        A parameter without a deviation, for example at its bound, adds nothing.
    correlation : ndarray (p, p)
    log, note : str
        Log of the fit, and its method.

    Notes
    -----
    First order: S = D C D', where D is the effect of one deviation of each fitted parameter on those of the axis file.
    """
    columns, small = [], 1e-3
    for i, deviation in enumerate(deviations.tolist()):
        step = np.zeros(values.size)
        step[i] = small * deviation
        up, down = (numbers(dict(zip(names, (values + sign * step).tolist(), strict=True))) for sign in (1.0, -1.0))
        columns.append([(up[name] - down[name]) / (2.0 * small) for name in up])
    effect = np.array(columns).T
    covariance = effect @ correlation @ effect.T
    sizes = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    of = list(numbers(dict(zip(names, values.tolist(), strict=True))))
    known = np.flatnonzero((sizes > 0.0) & (sizes < np.inf)).tolist()
    pairs = ((of[i], of[j], round(float(covariance[i, j] / (sizes[i] * sizes[j])), 4)) for i, j in combinations(known, 2))
    return Propagated(dict(zip(of, sizes.tolist(), strict=True)), tuple(pair for pair in pairs if pair[2]), log, note)


def fitted(log: str, deviation: float, note: str = "") -> Origin:
    """Return the origin of a parameter fitted to a log; only a finite deviation > 0 is kept."""
    return Origin("fitted", deviation=deviation if 0.0 < deviation < float("inf") else None, reference=log, note=note)


def assumed(note: str) -> Origin:
    """Return the origin of a parameter that the log does not give."""
    return Origin("assumed", note=note)


def command_label(unit: str) -> str:
    """Return the label of a command in a picture.

    >>> command_label("V"), command_label("")
    ('command [V]', 'command')
    """
    return f"command [{unit}]" if unit else "command"


def join_names(names: Sequence[str]) -> str:
    """Join the names of logs; shorten the list if there are more than three.

    >>> join_names(["a", "b", "c", "d"])
    'a, b and 2 more'
    """
    return ", ".join(names) if len(names) <= 3 else f"{', '.join(names[:2])} and {len(names) - 2} more"
