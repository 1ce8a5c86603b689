"""The tables of a report: for the terminal, for Markdown, for the page."""

from __future__ import annotations

from dataclasses import dataclass

from contourlab.figures import NONE, number
from contourlab.report.comparison import compare
from contourlab.report.data import ReportData
from contourlab.report.table import Column, Table, paragraphs
from contourlab.report.trials import trial_rows
from contourlab.report.trust import Number


def comparison_text(data: ReportData, width: int | None = None) -> str:
    """Return the comparison for the terminal."""
    comparison = compare(data)
    table = Table([Column("figure", left=True), *(Column(head.name) for head in comparison.heads)], data.title)
    if comparison.has_change:
        table.columns = [*table.columns, Column("change")]
    for row in comparison.rows:
        label = f"{row.label} [{row.unit}]" if row.unit else row.label
        table.add(label, *(cell.text for cell in row.cells), *([row.change.text] if comparison.has_change else []))
    notes = [comparison.note, *(f"note: {note}" for note in comparison.notes)]
    return f"{table.text(width)}\n\n{paragraphs(filter(None, notes), width)}"


def comparison_markdown(data: ReportData) -> str:
    """Return the comparison in GitHub's Markdown; text from outside cannot break its cells."""
    comparison = compare(data)
    heads = ["figure", "unit", *(head.name for head in comparison.heads)]
    rules = ["---", "---"] + ["---:"] * len(comparison.heads)
    rows = [[row.label, row.unit, *(cell.text for cell in row.cells)] for row in comparison.rows]
    if comparison.has_change:
        heads, rules = [*heads, "change"], [*rules, "---:"]
        rows = [[*cells, row.change.text] for cells, row in zip(rows, comparison.rows, strict=True)]
    table = "\n".join("| " + " | ".join(map(_escaped, row)) + " |" for row in (heads, rules, *rows))
    notes = [comparison.note, *(f"Note: {note}" for note in comparison.notes)]
    return "\n\n".join([table, *(_escaped(note) for note in notes if note)]) + "\n"


def trials_text(data: ReportData) -> str:
    """Return the trials of each scheme that learns; empty where none does."""
    tables = []
    for scheme in data.schemes:
        if scheme.trials is not None:
            table = Table([Column("trial"), Column("contour rms [um]"), Column("tracking rms [um]"), Column("", left=True)], scheme.name)
            for trial, contour, tracking in trial_rows(scheme.trials):
                table.add(str(trial), number(contour * 1e6, 4), number(tracking * 1e6, 4), "best" if trial == scheme.trials.best else "")
            tables.append(table.text())
    return "\n\n".join(tables)


@dataclass(frozen=True)
class OriginTable:
    """Numbers of one scheme: all of them for the first, those that differ from the schemes before for the others."""

    title: str
    rows: tuple[Number, ...]
    not_stated: tuple[str, ...]


def origin_tables(data: ReportData) -> tuple[OriginTable, ...]:
    """Return the sources of the numbers, for the page; empty where nobody asked for an interval."""
    tables: list[OriginTable] = []
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
            title = f"{scheme.name}: what differs from the schemes before" if tables else "Stated numbers"
            tables.append(OriginTable(title, rows, names))
    return tuple(tables)


def interval_rows(data: ReportData) -> tuple[tuple[str, ...], ...]:
    """Return for each scheme with an interval: name, then run, median and interval of rms and maximum [um], failed, beyond, main."""
    rows = []
    for scheme in data.schemes:
        interval, error = scheme.trust.interval if scheme.trust else None, scheme.metrics.contour_error
        if interval is None or interval.rms is None or interval.max is None:
            continue
        cells: list[str] = []
        for value, spread in ((error.rms, interval.rms), (error.max, interval.max)):
            median, low, high = (number(1e6 * figure) for figure in (spread.median, spread.low, spread.high))
            cells += [number(1e6 * value), median, f"{low} to {high}"]
        beyond = NONE if interval.beyond_tolerance is None else f"{interval.beyond_tolerance} of {interval.samples}"
        rows.append((scheme.name, *cells, f"{interval.failed} of {interval.samples}", beyond, interval.main or "none stands out"))
    return tuple(rows)


def _escaped(text: str) -> str:
    """Return text that Markdown takes as it is."""
    for sign in "\\|<>*_`[]":
        text = text.replace(sign, {"<": "&lt;", ">": "&gt;"}.get(sign, "\\" + sign))
    return " ".join(text.split())
