"""The tables of a report in the terminal."""

from __future__ import annotations

from contourlab.figures import number
from contourlab.rendering.comparison import compare
from contourlab.rendering.data import ReportData
from contourlab.rendering.learning_pictures import trial_rows
from contourlab.rendering.table import Column, Table, paragraphs


def comparison_text(data: ReportData, width: int | None = None) -> str:
    """Return the comparison for the terminal."""
    comparison = compare(data)
    table = Table([Column("figure", left=True), *(Column(head.name) for head in comparison.heads)], data.title)
    if comparison.has_change:
        table.columns = [*table.columns, Column("change")]
    for row in comparison.rows:
        label = f"{row.label} [{row.unit}]" if row.unit else row.label
        table.add(label, *(cell.text for cell in row.cells), *([row.change.text] if comparison.has_change else []))
    return f"{table.text(width)}\n\n{paragraphs(filter(None, [comparison.note, *comparison.notes]), width)}"


def trials_text(data: ReportData) -> str:
    """Return the trials of each scheme that learns; empty if none learns."""
    tables = []
    for scheme in data.schemes:
        if scheme.trials is not None:
            table = Table([Column("trial"), Column("contour rms [um]"), Column("tracking rms [um]"), Column("", left=True)], scheme.name)
            for trial, contour, tracking in trial_rows(scheme.trials):
                table.add(str(trial), number(contour * 1e6, 4), number(tracking * 1e6, 4), "best" if trial == scheme.trials.best else "")
            tables.append(table.text())
    return "\n\n".join(tables)
