"""``contourlab reproduce``: run the parts of a reproduction and print its rows."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import groupby
from pathlib import Path

from contourlab.app.checkpoint import said_if_interrupted
from contourlab.papers.rows import KINDS, Part, Row, tally
from contourlab.rendering.table import Column, Table, paragraphs


def run_parts(parts: Iterable[Part], stage: Callable[[str], object] | None = None) -> list[Row]:
    """Compute the rows of all parts.

    Parameters
    ----------
    parts : iterable of Part
    stage : callable, optional
        Called with the name of each part before it runs.
    """
    rows: list[Row] = []
    with said_if_interrupted(lambda: text_of(rows) if rows else ""):
        for name, rows_of in parts:
            if stage is not None:
                stage(name)
            rows += rows_of()
    return rows


def check_pictures(folder: str | Path, formats: Sequence[str]) -> None:
    """Check that pictures can be written.

    Raises
    ------
    ParameterError
        If a format is unknown.
    OutputError
        If the folder is not writable.
    """
    from contourlab.app.results import staged
    from contourlab.rendering.plots import write_charts

    write_charts((), folder, formats)
    with staged(folder):
        pass


def text_of(rows: Sequence[Row]) -> str:
    """Return the rows as tables by name, one line per case, and how many figures agree."""
    blocks = []
    for (name, unit), members in groupby(sorted(rows, key=_first_place(rows)), key=lambda row: (row.name, row.unit)):
        group = list(members)
        notes = dict.fromkeys(row.note for row in group)
        title = f"{name} [{unit}]" if unit else name
        if len(notes) == 1:
            blocks.append("\n".join([paragraphs([title, *filter(None, notes)]), _table(group).text()]))
        else:
            blocks.append("\n".join([title, _table(group, with_notes=True).text()]))
    return "\n\n".join([*blocks, paragraphs([tally(rows)])])


def _first_place(rows: Sequence[Row]) -> Callable[[Row], int]:
    """Return a sort key that groups rows of equal name and unit at the first of them."""
    places: dict[tuple[str, str], int] = {}
    for row in rows:
        places.setdefault((row.name, row.unit), len(places))
    return lambda row: places[row.name, row.unit]


def _table(rows: Sequence[Row], *, with_notes: bool = False) -> Table:
    compared = any(row.paper is not None for row in rows)
    origins = dict.fromkeys(KINDS[row.source][0] for row in rows if row.source in KINDS and row.paper is not None)
    columns = [Column("case", left=True, prose=True)]
    if compared:
        columns += [Column(" or ".join(origins)), Column("here"), Column("difference"), Column("source", left=True)]
        columns.append(Column("verdict", left=True))
    else:
        columns.append(Column("here"))
    table = Table([*columns, *([Column("note", prose=True)] if with_notes else [])])
    for row in rows:
        table.add(row.case, *_figures(row, compared=compared), *([row.note] if with_notes else []))
    return table


def _figures(row: Row, *, compared: bool) -> list[str]:
    """Return the cells of a row between its case and its note."""
    paper, here = row.paper, row.here
    ours = "" if here is None else f"{here:.6g}"
    if not compared:
        return [ours]
    difference = "" if paper is None or here is None else f"{here - paper:+.3g}"
    return ["" if paper is None else f"{paper:.6g}", ours, difference, row.source, row.verdict]
