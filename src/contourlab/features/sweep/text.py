"""Tables of a store."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from contourlab.figures import figure, number, shown_unit
from contourlab.rendering.table import Column, Table, paragraphs

if TYPE_CHECKING:
    from contourlab.features.sweep.command import SweepSummary

WORKSHOP = {"m": ("um", 1e6), "m s": ("um s", 1e6)}
"""Display unit of the figures of errors, and the factor from SI."""


def summary_text(result: SweepSummary) -> str:
    """Return the summary of a store."""
    head = f"{result.done} of {result.variants} variants in {result.store}; {result.chunks_made} chunks new"
    if result.rate:
        head += f"; {number(result.rate)} variants per second, {figure(result.elapsed, 's')} in all"
    ended = ", ".join(f"{count} {status}" for status, count in result.statuses.items() if status != "unsure" or count)
    lines = [f"{head}\nstatus: {ended or 'no variant yet'}"]
    within = result.within
    if within is not None:
        ends = f"{figure(within.low, '%', 4)} to {figure(within.high, '%', 4)}"
        what = f"{within.figure} within {figure(within.tolerance, 'um')}"
        lines.append(f"yield: {figure(within.share, '%', 4)} ({ends} with 95 % confidence): {within.passed} of {within.judged} have {what}")
    if result.figures:
        names = ("mean", "minimum", "p5", "median", "p95", "p99", "maximum")
        table = Table([Column("figure", left=True), Column("unit", left=True), *map(Column, names)])
        for name, spread in result.figures.items():
            unit, factor = display(spread.unit)
            values = (getattr(spread, word) for word in names)
            table.add(name, unit, *("-" if value is None else number(value * factor, 4) for value in values))
        lines.append(table.text())
    if result.findings:
        lines.append(paragraphs(map(str, result.findings)))
    return "\n\n".join(lines)


def display(unit: str) -> tuple[str, float]:
    """Return the display unit of values in an SI unit, and the factor."""
    if unit in WORKSHOP:
        return WORKSHOP[unit]
    factor, shown = shown_unit(unit)
    return shown, factor


def rows_text(names: Sequence[str], rows: Sequence[Sequence[Any]], units: Mapping[str, str] | None = None) -> str:
    """Return rows of a query as a table; columns with a unit in its display unit."""
    shown = {name: display(unit) for name, unit in (units or {}).items()}
    heads = [f"{name} [{shown[name][0]}]" if shown.get(name, ("", 1.0))[0] else name for name in names]
    texts = [any(isinstance(row[i], str) for row in rows) for i in range(len(names))]
    table = Table([Column(head, left=left) for head, left in zip(heads, texts, strict=True)])
    for row in rows:
        table.add(*(_cell(value, shown.get(name, ("", 1.0))[1]) for name, value in zip(names, row, strict=True)))
    return table.text()


def _cell(value: Any, factor: float) -> str:
    if value is None:
        return "-"
    return number(value * factor, 5) if isinstance(value, float) else str(value)
