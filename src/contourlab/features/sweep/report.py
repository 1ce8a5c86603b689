"""``contourlab sweep report``: the answers of a store in words, for the terminal and for the page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import astuple, dataclass
from pathlib import Path

from contourlab.app.session import Answer, Asked
from contourlab.features.sweep.answers import Answers, answers_of
from contourlab.features.sweep.effects import Effect, Subset
from contourlab.features.sweep.page import write_page
from contourlab.features.sweep.pairings import Pairings
from contourlab.features.sweep.rows import read_rows
from contourlab.features.sweep.store import read_store
from contourlab.features.sweep.summary import display
from contourlab.features.sweep.words import kind_of, range_text, said, share_text, value_text
from contourlab.figures import number
from contourlab.rendering.table import Column, Table, paragraphs

SHOWN = 12
"""Most rows of a table on the terminal."""


@dataclass(frozen=True)
class SweepReport(Answer):
    """The answers of a store, and their page.

    Attributes
    ----------
    page : Path
    answers : Answers
    """

    page: Path
    answers: Answers

    def _next(self, asked: Asked) -> Sequence[object]:
        """List the worst variants."""
        return ["sweep", "worst", *asked.inputs]

    @property
    def text(self) -> str:
        """Text for the terminal."""
        words = said(self.answers)
        sentence, decides, stop, front, modules = (paragraphs([part]) if part else "" for part in astuple(words))
        tables = _subset_text(self.answers), _effect_text(self.answers.effects)
        remarks = paragraphs(map(str, self.answers.findings))
        pairings = _module_text(self.answers.pairings)
        parts = (sentence, modules, pairings, tables[0], decides, tables[1], front, stop, remarks, f"page: {self.page}")
        return "\n\n".join(part for part in parts if part)


def report(folder: str | Path, file: str | Path | None = None, figure: str | None = None) -> SweepReport:
    """Answer the questions to a store, and write the page.

    Parameters
    ----------
    folder : str or Path
        A store.
    file : str or Path, optional
        The page; by default ``report.html`` in the store. Replaced completely or not at all.
    figure : str, optional
        By default the largest part error, or else the first figure of the store.

    Raises
    ------
    ResultError
        If it is no store, or damaged.
    ParameterError
        If it has no such figure, or no variant that was judged.
    OutputError
        If the page cannot be written.
    """
    store = read_store(folder)
    rows = read_rows(store, figure)
    answers = answers_of(rows)
    page = Path(file) if file is not None else store.folder / "report.html"
    write_page(answers, rows, said(answers), page)
    return SweepReport(page, answers)


def _subset_text(answers: Answers) -> str:
    if not answers.subsets:
        return ""
    unit, factor = display(answers.unit)
    table = Table([Column("column", left=True), Column("value"), Column(kind_of(answers)), *_yield_heads(answers)], keys=2)
    table.columns = [*table.columns, Column(f"median [{unit}]"), Column(f"p95 [{unit}]")]
    for one in answers.subsets:
        ends = [number(value * factor, 4) if value is not None else "-" for value in (one.median, one.p95)]
        table.add(one.column, value_text(one), str(one.judged), *_yield_cells(one), *ends)
    return table.text()


def _yield_heads(answers: Answers) -> list[Column]:
    return [] if answers.tolerance is None else [Column("yield"), Column("95 % interval")]


def _yield_cells(one: Subset) -> list[str]:
    return [] if one.share is None else [share_text(one.share), range_text(one.low, one.high)]


def _effect_text(effects: tuple[Effect, ...]) -> str:
    if not effects:
        return ""
    heads = [Column("explains"), Column("95 % interval"), Column("rank correlation"), Column("95 % interval")]
    has_totals = any(one.total is not None for one in effects)
    totals = [Column("with others"), Column("95 % interval")] if has_totals else []
    table = Table([Column("parameter", left=True), *heads[:2], *totals, *heads[2:]])
    for one in effects[:SHOWN]:
        signed = ["-", "-"]
        if one.correlation is not None and one.correlation_low is not None and one.correlation_high is not None:
            signed = [f"{one.correlation:+.2f}", f"{one.correlation_low:+.2f} to {one.correlation_high:+.2f}"]
        total = [share_text(one.total, 2), range_text(one.total_low, one.total_high, 2)] if has_totals else []
        table.add(one.column, share_text(one.index, 2), range_text(one.index_low, one.index_high, 2), *total, *signed)
    more = len(effects) - SHOWN
    return table.text() + (f"\n{more} more on the page" if more > 0 else "")


def _module_text(found: Pairings | None) -> str:
    """Return the modules to sort out."""
    if found is None or not found.bad:
        return ""
    heads = [Column("pairings"), Column("yield"), Column("yield without it and those above")]
    table = Table([Column("modules", left=True), Column("module"), *heads])
    for one in found.bad[:SHOWN]:
        table.add(one.column.removesuffix(".module"), str(one.module), str(one.judged), share_text(one.share), share_text(one.left))
    more = len(found.bad) - SHOWN
    return table.text() + (f"\n{more} more in --json" if more > 0 else "")
