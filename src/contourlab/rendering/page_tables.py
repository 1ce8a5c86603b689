"""Tables of the page: circles, limits, reversals, and how far to trust the figures."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from contourlab.feed.verify import LimitReport, Worst
from contourlab.figures import NONE, figure, number, shown_unit
from contourlab.metrics.circles import pairs
from contourlab.metrics.reversals import ReversalFigures, reversal_figures
from contourlab.rendering.data import ReportData
from contourlab.rendering.judgement import Number
from contourlab.rendering.table import Column, Table

LIMIT_TITLE = "Planned motion and axis limits"
LIMIT_ROWS = (
    ("velocity", "velocity", "m/s"),
    ("acceleration", "acceleration", "m/s^2"),
    ("jerk", "jerk", "m/s^3"),
    ("curvature step", "curvature_step", "m/s^2"),
    ("kink", "kink", "m/s"),
)


@dataclass(frozen=True)
class PageTable:
    """A table of the page.

    Parameters
    ----------
    note : str or tuple of str
        What the rows leave out.
    """

    title: str
    rows: tuple[Any, ...]
    heads: tuple[Any, ...] = ()
    note: str | tuple[str, ...] = ""


def circle_tables(data: ReportData) -> tuple[PageTable, ...]:
    """Return the ISO 230-4 figures [um], one table per circle: a row per figure, a column per run.

    The heads are each scheme with its directions.
    """
    tables: dict[str, dict[tuple[str, str], dict[str, float]]] = {}
    for scheme in data.schemes:
        for circle in scheme.circles:
            way = "cw" if circle.clockwise else "ccw"
            tables.setdefault(circle.name, {})[scheme.name, way] = dict(circle.figures())
        for name, both in pairs(scheme.circles).items():
            tables.setdefault(name, {})[scheme.name, "both"] = {
                "bi-directional circular deviation G(b)": both.circular_deviation,
                "mean bi-directional radial deviation D": both.mean_radial,
                "hysteresis H": both.hysteresis,
            }
    return tuple(_circle_table(name, runs) for name, runs in tables.items())


def _circle_table(name: str, runs: dict[tuple[str, str], dict[str, float]]) -> PageTable:
    """Return one table; a missing figure is a dash."""
    labels = dict.fromkeys(label for figures in runs.values() for label in figures)
    rows = tuple((label, tuple(number(1e6 * figures.get(label, math.nan)) for figures in runs.values())) for label in labels)
    heads = tuple((scheme, tuple(way for of, way in runs if of == scheme)) for scheme in dict.fromkeys(of for of, _ in runs))
    return PageTable(name, rows, heads)


def nearest(entries: Sequence[Worst]) -> Worst | None:
    """Return the entry of the axis nearest to its limit or furthest beyond it (without limits: with the largest value), or None."""
    seen = [entry for entry in entries if entry.sample >= 0]
    return max(seen, key=lambda entry: (entry.ratio, entry.value), default=None)


def limit_tables(data: ReportData) -> Iterator[PageTable]:
    """Yield a table for each motion planned within limits, with what the jerk leaves out; schemes with equal figures share it.

    A row per kind of limit has the worst axis, value, limit, share of it, time and line.
    """
    planned = [(scheme, scheme.limits) for scheme in data.schemes if scheme.limits is not None]
    for k, (first, report) in enumerate(planned):
        names = [scheme.name for scheme, limits in planned if limits == report]
        if any(limits == report for _, limits in planned[:k]):
            continue
        note = _peaks_note(report, float(first.result.servo_period))
        rows = []
        for label, kind, unit in LIMIT_ROWS:
            shown = "jerk between curvature steps" if note and kind == "jerk" else label
            rows.append((shown, _limit_cells(nearest(getattr(report, kind)), unit, data.axes)))
        title = LIMIT_TITLE + (f": {', '.join(names)}" if len(names) < len(data.schemes) else "")
        yield PageTable(title, tuple(rows), note=note)


def _peaks_note(report: LimitReport, period: float) -> str:
    """Describe the curvature steps that samples show as a jerk above the limit; empty without any."""
    peaks = [report.jerk_peaks(axis, period) for axis in range(len(report.jerk))]
    count = len({int(sample) for steps in peaks for sample in steps.sample})
    if not count:
        return ""
    largest = max(float(steps.size.max(initial=0.0)) for steps in peaks)
    return (
        f"Curvature steps whose jerk exceeds the limit: {count}. The largest, {figure(largest, 'm/s^2')}, is a jerk of"
        f" {figure(largest / period, 'm/s^3')} over one servo period of {figure(period, 'ms')}."
        " Where the curvature jumps, no jerk limit can hold without a stop; curvature_step limits the step."
    )


def _limit_cells(worst: Worst | None, unit: str, axes: Sequence[str]) -> tuple[str, ...]:
    """Return the cells of one row; dashes if there is no such limit."""
    if worst is None:
        return (NONE,) * 6
    shown = shown_unit(unit)[1]
    bounded = math.isfinite(worst.limit)
    return (
        axes[worst.axis],
        figure(worst.value, shown, 4),
        figure(worst.limit, shown, 4) if bounded else "none",
        f"{100.0 * worst.ratio:.1f} %" if bounded else NONE,
        figure(worst.time, "s", 5),
        str(worst.source_line) if worst.source_line else NONE,
    )


def reversal_table(data: ReportData, *, places: bool = True) -> PageTable | None:
    """Return the reversal spikes by axis and direction, with `places` also by quadrant of arcs; None without reversals.

    A row has kind, number, and for each scheme mean and largest spike [um] and mean duration [ms].
    """
    columns = [
        {
            (math.isnan(f.angle), np.nan_to_num(f.angle), data.axes.index(f.axis), -f.direction): f
            for f in reversal_figures(scheme.spikes, places=places)
        }
        for scheme in data.schemes
    ]
    keys = sorted({key for column in columns for key in column})
    if not keys:
        return None
    mixed = places and len({elsewhere for elsewhere, *_ in keys}) == 2
    rows = []
    for key in keys:
        there = [column[key] for column in columns if key in column]
        counts = sorted({f.count for f in there})
        many = str(counts[0]) if len(counts) == 1 else f"{counts[0]} to {counts[-1]}"
        rows.append((_kind(there[0], mixed), many, tuple(_reversal_cells(column.get(key)) for column in columns)))
    return PageTable("", tuple(rows), tuple(scheme.name for scheme in data.schemes))


def reversal_text(data: ReportData) -> str:
    """Return mean and largest spike by axis and direction for the terminal; empty without reversals."""
    reversals = reversal_table(data, places=False)
    if reversals is None:
        return ""
    heads = [Column("axis, direction (count)", left=True), *map(Column, reversals.heads)]
    rows = ((f"{where} ({many})", *(f"{mean} / {top}" for mean, top, _ in cells)) for where, many, cells in reversals.rows)
    return Table(heads, "Reversal spikes, mean / largest [um]", rows=rows).text()


def _kind(figures: ReversalFigures, mixed: bool) -> str:
    if not math.isnan(figures.angle):
        return f"{figures.axis} at {math.degrees(figures.angle):.0f} deg" + (" on arcs" if mixed else "")
    return f"{figures.axis}, {'- to +' if figures.direction > 0 else '+ to -'}" + (", not on arcs" if mixed else "")


def _reversal_cells(figures: ReversalFigures | None) -> tuple[str, str, str]:
    if figures is None:
        return NONE, NONE, NONE
    return number(figures.mean * 1e6), number(figures.largest * 1e6), number(figures.duration * 1e3)


def origin_tables(data: ReportData) -> list[PageTable]:
    """Return the sources of the parameters; empty if no interval was requested.

    A table has all numbers of the first scheme, then those that differ from earlier schemes; its note holds the names without a source.
    """
    tables: list[PageTable] = []
    seen: set[Number] = set()
    blank: set[str] = set()
    for scheme in data.schemes:
        if scheme.trust is None or scheme.trust.interval is None:
            continue
        rows = tuple(number for number in scheme.trust.provenance if number not in seen)
        names = tuple(name for name in scheme.trust.not_stated if name not in blank)
        seen |= set(rows)
        blank |= set(names)
        if rows or names:
            title = "Parameters with a stated source" if not tables else f"{scheme.name}: parameters that differ from the schemes above"
            tables.append(PageTable(title, rows, note=names))
    return tables
