"""The comparison table in the terminal and in Markdown."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, TextIO

from contourlab.report.comparison import Comparison, Row, compare
from contourlab.report.data import ReportData
from contourlab.report.learning_pictures import trial_rows
from contourlab.report.text import number, plain_unit

if TYPE_CHECKING:
    from rich.table import Table

_MOOD = {"good": "green", "poor": "red", "": ""}


def comparison_table(data: ReportData, *, ascii_only: bool = False) -> Table:
    """Return the table of schemes and figures, for rich to print.

    Parameters
    ----------
    data : ReportData
    ascii_only : bool
        Whether lines and units are kept to ASCII (``um`` for µm).
    """
    from rich import box
    from rich.table import Table
    from rich.text import Text

    comparison = compare(data)
    table = Table(title=Text(data.title), title_justify="left", box=box.ASCII2 if ascii_only else box.SIMPLE_HEAD)
    table.add_column("figure")
    table.add_column("unit")
    for head in comparison.heads:
        table.add_column(Text(head.name), justify="right")
    if comparison.has_change:
        table.add_column("change", justify="right")
    for row in comparison.rows:
        cells = [Text(_shown(cell.text, ascii_only), style=_MOOD[cell.mood]) for cell in row.cells]
        change = [Text(_shown(row.change, ascii_only), style=_MOOD[row.mood])] if comparison.has_change else []
        names = [Text(_shown(text, ascii_only)) for text in (row.label, row.unit)]
        table.add_row(*names, *cells, *change, style="bold" if row.strong else "")
    return table


def trials_text(data: ReportData) -> str:
    """Return the trials of each scheme that learns as plain text; empty where none does."""
    lines = []
    for scheme in data.schemes:
        if scheme.trials is None:
            continue
        lines += ["", f"{scheme.name}", "trial   contour rms [um]   tracking rms [um]"]
        for trial, contour, tracking in trial_rows(scheme.trials):
            best = "   best" if trial == scheme.trials.best else ""
            lines.append(f"{trial:5d}   {number(contour * 1e6, 4):>16}   {number(tracking * 1e6, 4):>17}{best}".replace("−", "-"))
    return "\n".join(lines)


def _shown(text: str, ascii_only: bool) -> str:
    """Return the text, in ASCII where only that can be relied on."""
    if not ascii_only:
        return text
    plain = plain_unit(text).replace("–", "-").replace("−", "-").replace("✓ ", "").replace("✗ ", "").replace("∞", "inf")
    return plain.encode("ascii", "replace").decode("ascii")


def print_comparison(data: ReportData, stream: TextIO | None = None) -> None:
    """Print the table to a stream: in colour on a terminal, in plain ASCII anywhere else.

    Parameters
    ----------
    data : ReportData
    stream : text stream, optional
        Standard output if not given.
    """
    from rich.console import Console

    target = sys.stdout if stream is None else stream
    if target.isatty() and "NO_COLOR" not in os.environ:
        Console(file=target).print(comparison_table(data))
    else:
        target.write(comparison_text(data) + "\n")


def comparison_text(data: ReportData) -> str:
    """Return the table as plain ASCII text, as wide as it needs to be; lines end without spaces."""
    from rich.console import Console

    console = Console(width=10_000, color_system=None, force_terminal=False, legacy_windows=False, record=False)
    with console.capture() as captured:
        console.print(comparison_table(data, ascii_only=True))
    comparison = compare(data)
    below = [comparison.note, *(f"note: {note}" for note in comparison.notes)]
    return "\n".join([*(line.rstrip() for line in captured.get().splitlines()), *(_shown(text, True) for text in below if text)])


def comparison_markdown(data: ReportData) -> str:
    """Return the table in GitHub's Markdown; text from outside cannot break its cells."""
    comparison = compare(data)
    heads = ["figure", "unit", *(head.name for head in comparison.heads)]
    rules = ["---", "---"] + ["---:"] * len(comparison.heads)
    if comparison.has_change:
        heads, rules = [*heads, "change"], [*rules, "---:"]
    rows = [heads, rules, *(_markdown_row(comparison, row) for row in comparison.rows)]
    table = "\n".join("| " + " | ".join(row) + " |" for row in (_escaped(row) for row in rows))
    below = [comparison.note, *(f"Note: {note}" for note in comparison.notes)]
    return "\n\n".join([table, *(_cell(text) for text in below if text)]) + "\n"


def _markdown_row(comparison: Comparison, row: Row) -> list[str]:
    """Return the cells of one row."""
    cells = [row.label, row.unit, *(cell.text for cell in row.cells)]
    return [*cells, row.change] if comparison.has_change else cells


def _escaped(row: list[str]) -> list[str]:
    """Return the cells of a row, safe to stand between bars."""
    return [_cell(text) for text in row]


def _cell(text: str) -> str:
    """Return text that Markdown takes as it is."""
    for sign in "\\|<>*_`[]":
        text = text.replace(sign, {"<": "&lt;", ">": "&gt;"}.get(sign, "\\" + sign))
    return " ".join(text.split())
