"""Reversal spikes of all schemes side by side: by axis and direction, on arcs by quadrant."""

from __future__ import annotations

import math
from dataclasses import dataclass

from contourlab.figures import NONE, number
from contourlab.metrics import ReversalFigures, Spike, reversal_figures
from contourlab.report.data import ReportData
from contourlab.report.table import Column, Table

Key = tuple[str, int, float | None]


@dataclass(frozen=True)
class ReversalTable:
    """A row for each kind of reversal.

    Parameters
    ----------
    heads : tuple of str
        Names of the schemes.
    rows : tuple
        Each: where, how many, and for each scheme mean and largest spike [um] and mean duration [ms].
    """

    heads: tuple[str, ...]
    rows: tuple[tuple[str, str, tuple[tuple[str, str, str], ...]], ...]


def reversal_table(data: ReportData, *, places: bool = True) -> ReversalTable | None:
    """Return the table; None where no axis turns.

    Parameters
    ----------
    data : ReportData
    places : bool
        Whether the quadrants of arcs have rows of their own.
    """
    columns = [
        {_key(f): f for f in reversal_figures([s for s in scheme.spikes if isinstance(s, Spike)], places=places)} for scheme in data.schemes
    ]
    keys = sorted({key for column in columns for key in column}, key=lambda key: _order(key, data.axes))
    if not keys:
        return None
    mixed = any(key[2] is not None for key in keys) and any(key[2] is None for key in keys)
    rows = []
    for key in keys:
        there = [column[key] for column in columns if key in column]
        counts = sorted({f.count for f in there})
        many = str(counts[0]) if len(counts) == 1 else f"{counts[0]} to {counts[-1]}"
        rows.append((_words(key, mixed and places), many, tuple(_cells(column.get(key)) for column in columns)))
    return ReversalTable(tuple(scheme.name for scheme in data.schemes), tuple(rows))


def reversal_text(data: ReportData) -> str:
    """Return mean and largest spike by axis and direction for the terminal; empty where no axis turns."""
    found = reversal_table(data, places=False)
    if found is None:
        return ""
    heads = ["reversal spikes (number), mean / largest [um]", *found.heads]
    table = Table([Column(head, left=i == 0) for i, head in enumerate(heads)])
    for where, many, cells in found.rows:
        table.add(f"{where} ({many})", *(f"{mean} / {top}" for mean, top, _ in cells))
    return table.text()


def _key(figures: ReversalFigures) -> Key:
    return figures.axis, figures.direction, None if math.isnan(figures.angle) else figures.angle


def _order(key: Key, axes: tuple[str, ...]) -> tuple[bool, float, int, int]:
    """Order by quadrant, then by axis and direction."""
    axis, direction, angle = key
    return angle is None, angle or 0.0, axes.index(axis), -direction


def _words(key: Key, mixed: bool) -> str:
    axis, direction, angle = key
    if angle is not None:
        return f"{axis} at {math.degrees(angle):.0f} deg" + (" of arcs" if mixed else "")
    return f"{axis}, {'- to +' if direction > 0 else '+ to -'}" + (" elsewhere" if mixed else "")


def _cells(figures: ReversalFigures | None) -> tuple[str, str, str]:
    if figures is None:
        return NONE, NONE, NONE
    return number(figures.mean * 1e6), number(figures.largest * 1e6), number(figures.duration * 1e3)
