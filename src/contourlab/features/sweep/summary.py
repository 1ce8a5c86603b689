"""What a store holds, as a result and as text."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from contourlab.app.json_values import HIDDEN
from contourlab.app.session import Answer, Asked
from contourlab.features.sweep.query import Spread, Yield, counts, spreads, yield_of
from contourlab.features.sweep.store import SCHEMA, Store
from contourlab.figures import figure, number, shown_unit
from contourlab.findings import Finding, finding
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.study.design import DRAWN

WORKSHOP = {"m": ("um", 1e6), "m s": ("um s", 1e6)}
"""Display unit of the figures of errors, and the factor from SI."""


@dataclass(frozen=True)
class SweepSummary(Answer):
    """What a store holds.

    Attributes
    ----------
    store : str
    design : str
    variants, done : int
        Variants of the study, and in the store.
    chunks, chunks_done, chunks_made : int
        Chunks of the study, in the store, and of this call.
    columns : mapping of str to str
        What varies, with SI units.
    statuses : mapping of str to int
        Number of variants that ended ``ok``, ``diverged`` or were ``refused``; ``unsure`` counts those whose error is an upper bound.
    within : Yield or None
        The yield.
    figures : mapping of str to Spread
    elapsed, cpu_seconds : float [s]
        Time of all calls that wrote into the store, and processor time of its workers.
    rate : float [1/s]
        Variants per elapsed second.
    findings : tuple of Finding
    """

    store: str
    design: str
    variants: int
    done: int
    chunks: int
    chunks_done: int
    chunks_made: int
    columns: Mapping[str, str]
    statuses: Mapping[str, int]
    within: Yield | None = field(metadata={"json": "yield"})
    figures: Mapping[str, Spread]
    elapsed: float
    cpu_seconds: float
    rate: float
    findings: tuple[Finding, ...]
    fresh: bool = field(default=False, metadata=HIDDEN)

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Read the report of a study that was run."""
        return ["sweep", "report", self.store] if self.fresh else None

    @property
    def text(self) -> str:
        """Text for the terminal."""
        return _text(self)


def summary(store: Store, made: int = 0, findings: Sequence[Finding] = ()) -> SweepSummary:
    """Return what a store holds, after `made` new chunks."""
    has_rows = bool(store.parts)
    statuses = counts(store) if has_rows else {}
    times = store.times()
    return SweepSummary(
        store=str(store.home),
        design=store.manifest.design,
        variants=store.manifest.variants,
        done=store.done,
        chunks=store.chunks,
        chunks_done=len(store.parts),
        chunks_made=made,
        columns=store.manifest.columns,
        statuses=statuses,
        within=yield_of(store) if has_rows else None,
        figures=spreads(store) if has_rows else {},
        elapsed=times["elapsed"],
        cpu_seconds=times["cpu_seconds"],
        rate=times["variants"] / times["elapsed"] if times["elapsed"] else 0.0,
        findings=(*findings, *remarks(store, statuses)),
    )


def remarks(store: Store, statuses: Mapping[str, int]) -> tuple[Finding, ...]:
    """Return what to know about the variants of a store: missing, refused, unsure."""
    found = [finding("CL935", store=str(store.home))] if store.manifest.schema != SCHEMA else []
    found += [finding("CL931", done=store.done, variants=store.manifest.variants)] if store.done < store.manifest.variants else []
    found += [finding("CL932", count=statuses["refused"])] if statuses.get("refused") else []
    found += [finding("CL933", count=statuses["unsure"])] if statuses.get("unsure") else []
    return tuple(found)


def _text(result: SweepSummary) -> str:
    head = f"{result.done} of {result.variants} variants in {result.store}"
    if result.chunks_made:
        head += f"; {result.chunks_made} of {result.chunks} chunks new"
    if result.rate:
        head += f"; {number(result.rate)} variants per second, {figure(result.elapsed, 's')} in all"
    ended = ", ".join(f"{count} {status}" for status, count in result.statuses.items() if status != "unsure" or count)
    lines = [paragraphs([head, f"status: {ended or 'no variant yet'}"])]
    within = result.within
    if within is not None:
        ends = f" ({figure(within.low, '%', 4)} to {figure(within.high, '%', 4)} with 95 % confidence)"
        ends = ends if result.design in DRAWN else ""  # a grid or list is no sample
        what = f"{within.figure} within {figure(within.tolerance, 'um')}"
        share = f"yield: {figure(within.share, '%', 4)}{ends}"
        lines.append(paragraphs([f"{share}: {within.passed} of {within.judged} have {what}"]))
    if result.figures:
        names = ("mean", "minimum", "p5", "median", "p95", "p99", "maximum")
        table = Table([Column("figure", left=True), Column("unit", left=True), *map(Column, names)])
        for name, spread in result.figures.items():
            unit, factor = display(spread.unit)
            values = (getattr(spread, word) for word in names)
            table.add(name, unit, *("-" if value is None else number(value * factor, 4) for value in values))
        lines.append(table.text())
    return "\n\n".join(filter(None, [*lines, paragraphs(map(str, result.findings))]))


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
