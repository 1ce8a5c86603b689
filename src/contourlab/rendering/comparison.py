"""The comparison of schemes: the same rows for the terminal, Markdown and the page."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from contourlab.figures import NONE, figure, grouped, listing, number
from contourlab.metrics.figures import ErrorFigures
from contourlab.metrics.run_figures import FIGURES, PART, figures_of_run
from contourlab.rendering.data import JudgedRun, ReportData
from contourlab.rendering.table import Column, Table, paragraphs

UM = 1e6
ERRORS = {"max": "largest", "rms": "rms", "mean": "mean", "p95": "95th percentile", "signed_mean": "signed mean", "integral": "integral"}
"""Figures of an error in printing order, in words."""


@dataclass(frozen=True)
class Head:
    """A column: one scheme and its colour."""

    name: str
    colour: str


@dataclass(frozen=True)
class Cell:
    """One figure in print; `mood` is ``"good"``, ``"poor"`` or ``""``."""

    text: str
    mood: str = ""


@dataclass(frozen=True)
class Row:
    """One figure of every scheme.

    Parameters
    ----------
    cells : tuple of Cell
        One per scheme.
    change : Cell
        Change from the first scheme to the last, in percent.
    strong : bool
        Whether the tolerance applies to this row.
    """

    label: str
    unit: str
    cells: tuple[Cell, ...]
    change: Cell = Cell("")
    strong: bool = False


@dataclass(frozen=True)
class Comparison:
    """The whole table; `note` explains its figures, `notes` concern the path and the runs."""

    heads: tuple[Head, ...]
    rows: tuple[Row, ...]
    tolerance: str
    note: str
    notes: tuple[str, ...] = ()

    @property
    def has_change(self) -> bool:
        """Whether there are two schemes or more."""
        return len(self.heads) > 1


def compare(data: ReportData) -> Comparison:
    """Return the comparison of a report's schemes.

    Rows: verdict (with a tolerance), servo loops (if one is unstable), learning, errors, axes, drives, time. A figure that no scheme has
    is omitted.
    """
    heads = tuple(Head(name, colour) for name, colour, _ in data.looks.values())
    columns = [figures_of(data, scheme) for scheme in data.schemes]
    figures = [_row([column.get(key) for column in columns]) for key in dict.fromkeys(key for column in columns for key in column)]
    rows = [*_status_rows(data), *(row for row in figures if any(cell.text != NONE for cell in row.cells))]
    tolerance = "" if data.tolerance is None else figure(data.tolerance, "um", 6)
    return Comparison(heads, tuple(rows), tolerance, _note(data), tuple(data.notes))


def _status_rows(data: ReportData) -> list[Row]:
    """Return the rows of text: pass or fail, unstable loops, how learning ended."""
    rows = []
    passed = [data.passed(scheme) for scheme in data.schemes]
    if any(answer is not None for answer in passed):
        tolerance = data.tolerance or next(scheme.verdict.tolerance for scheme in data.schemes if scheme.verdict is not None)
        cells = tuple(Cell(NONE) if answer is None else Cell("pass", "good") if answer else Cell("fail", "poor") for answer in passed)
        rows.append(Row(f"tolerance {figure(tolerance, 'um', 6)}", "", cells, strong=True))
    if any(not loop.margins.stable for scheme in data.schemes for loop in scheme.bode.values()):
        rows.append(Row("servo loops", "", tuple(map(_loops, data.schemes))))
    if any(scheme.trials is not None for scheme in data.schemes):
        rows.append(Row("learning", "", tuple(map(_learning, data.schemes))))
    return rows


def _loops(scheme: JudgedRun) -> Cell:
    """Name the unstable loops of a scheme."""
    unstable = [f"{axis} ({loop.meant})" if loop.meant else axis for axis, loop in scheme.bode.items() if not loop.margins.stable]
    return Cell(f"unstable: {', '.join(unstable)}", "poor") if unstable else Cell("stable" if scheme.bode else NONE)


def _learning(scheme: JudgedRun) -> Cell:
    if scheme.trials is None:
        return Cell(NONE)
    return Cell(scheme.trials.in_words, "poor" if scheme.trials.status.startswith("diverged") else "")


def _row(figures: list[Figure | None]) -> Row:
    known = next(figure for figure in figures if figure is not None)
    values = [math.nan if figure is None else figure.value * known.factor for figure in figures]
    change = _change(values[0], values[-1], known.lower_is_better) if len(values) > 1 else Cell("")
    return Row(known.label, known.unit, tuple(Cell(number(value)) for value in values), change, known.strong)


def _change(before: float, after: float, lower_is_better: bool) -> Cell:
    """Return the change of the magnitude in percent, and whether it is an improvement."""
    # A first value that is only rounding gives no meaningful ratio.
    if not (math.isfinite(before) and math.isfinite(after)) or abs(before) <= 1e-9 * abs(after) or before == 0.0:
        return Cell(NONE)
    percent = 100.0 * (abs(after) - abs(before)) / abs(before)
    if abs(percent) < 0.05:
        return Cell("0 %")
    text = f"{percent:+.0f} %" if abs(percent) >= 10.0 else f"{percent:+.1f} %"
    return Cell(text, ("good" if percent < 0.0 else "poor") if lower_is_better and abs(percent) >= 1.0 else "")


def judged_words(scheme: JudgedRun) -> str:
    """Describe the judged samples of a run."""
    metrics, period = scheme.metrics, scheme.result.servo_period
    if len(metrics.judged.ranges) > 1:
        return f"the {metrics.basis}, {figure(metrics.judged_time, 's', 4)} of {figure(metrics.cycle_time, 's', 4)}"
    start, stop = (figure(sample * period, "s", 4) for sample in metrics.judged.ranges[0])
    return f"the {metrics.basis}, {start} to {stop}"


def _judged_parts(schemes: Sequence[JudgedRun]) -> str:
    """Describe the evaluated part of the run; by scheme if they differ."""
    parts = grouped((judged_words(scheme), scheme.name) for scheme in schemes)
    if len(parts) == 1:
        return f"Errors over {next(iter(parts))}."
    texts = [f"{part} ({listing(names)})" for part, names in parts.items()]
    return f"Errors over {listing(texts)}."


def _note(data: ReportData) -> str:
    """Describe what the numbers do not show."""
    notes = [_judged_parts(data.schemes)]
    if data.is_measured:
        notes.append("Positions are those of the log: errors that neither its encoders nor its tool position show are not included.")
    elif not data.is_blended:
        notes.append("The planned path equals the programmed path, so contour error and part error are equal.")
    if len(data.schemes) > 1:
        notes.append(f"Change: {data.schemes[-1].name} compared with {data.schemes[0].name}.")
    stopped = [scheme for scheme in data.schemes if not scheme.result.status.ok]
    notes += [f"{scheme.name} did not finish: {scheme.result.status.reason}. Its figures cover the part that ran." for scheme in stopped]
    return " ".join(notes)


@dataclass(frozen=True)
class Figure:
    """One number of one run: SI value, and how to print it.

    Parameters
    ----------
    value : float
        SI.
    factor : float
        From SI to `unit`.
    strong : bool
        Whether the tolerance applies to it.
    """

    label: str
    value: float
    factor: float
    unit: str
    strong: bool = False
    lower_is_better: bool = True


def figures_of(data: ReportData, scheme: JudgedRun) -> dict[str, Figure]:
    """Return the figures of a run by label, in printing order; part error and contour error appear once if they are the same."""
    figures: dict[str, Figure] = {}
    for row in _figures(data, scheme):
        figures.setdefault(row.label, row)
    return figures


def _errors(what: str, error: ErrorFigures, names: Iterable[str], strong: bool = False) -> Iterator[Figure]:
    """Yield figures of an error; the tolerance applies to the largest one if it is `strong`."""
    for name in names:
        unit = "um s" if name == "integral" else "um"
        yield Figure(f"{what}, {ERRORS[name]}", getattr(error, name), UM, unit, strong and name == "max", name != "signed_mean")


def _figures(data: ReportData, scheme: JudgedRun) -> Iterator[Figure]:
    metrics, blended = scheme.metrics, data.is_blended
    if blended:
        yield from _errors("part error", metrics.part_error, ("max", "rms"), strong=True)
        yield from _errors("planning deviation", metrics.planning_deviation, ("max",))
    # In space the error has no side.
    shown = [name for name in ERRORS if name != "signed_mean" or len(data.axes) == 2]
    yield from _errors("contour error", metrics.contour_error, shown, strong=not blended)
    for name, value in figures_of_run(scheme.result, metrics.judged).items():
        row = FIGURES[name]
        if row.is_row and (blended or row.source != PART):
            yield Figure(row.label, value, row.factor, row.display)
    for other in metrics.others:
        yield Figure(f"part error, {other.moves} (not judged)", other.max, UM, "um")
    for axis, tracking in zip(data.axes, metrics.tracking_error, strict=True):
        yield Figure(f"tracking error {axis}, rms", tracking.rms, UM, "um")
    for axis, part in zip(data.axes, metrics.saturation, strict=True):
        yield Figure(f"drive {axis} saturated", part, 100.0, "% of time")
    yield Figure("feedrate, mean", metrics.feedrate_mean, 6e4, "mm/min", lower_is_better=False)
    yield Figure("feedrate, ripple", metrics.feedrate_ripple, 100.0, "%")
    yield Figure("cycle time", metrics.cycle_time, 1.0, "s")
    if scheme.tick is not None:
        yield Figure("computing time per servo tick", scheme.tick, 1e9, "ns", lower_is_better=False)


def comparison_table(comparison: Comparison, title: str) -> Table:
    """Return a comparison as a table."""
    heads = [*(head.name for head in comparison.heads), *(["change"] if comparison.has_change else [])]
    rows = (
        (
            f"{row.label} [{row.unit}]" if row.unit else row.label,
            *(cell.text for cell in row.cells),
            *([row.change.text] if comparison.has_change else []),
        )
        for row in comparison.rows
    )
    return Table([Column("figure", left=True), *map(Column, heads)], title, rows=rows)


def with_intervals(data: ReportData) -> Comparison:
    """Return the comparison, and below it the interval of the part error of each scheme that has one."""
    comparison, rows = compare(data), []
    for name in ("max", "rms"):
        spreads = [getattr(scheme.trust and scheme.trust.interval, name, None) for scheme in data.schemes]
        cells = tuple(Cell(NONE if one is None else f"{number(UM * one.low)} to {number(UM * one.high)}") for one in spreads)
        rows += [Row(f"part error, {ERRORS[name]}, 5 to 95 % of the machines", "um", cells)] if any(spreads) else []
    return replace(comparison, rows=(*comparison.rows, *rows))


def comparison_text(data: ReportData, width: int | None = None) -> str:
    """Return the comparison for the terminal."""
    comparison = compare(data)
    table = comparison_table(comparison, data.title)
    return f"{table.text(width)}\n\n{paragraphs(filter(None, [comparison.note, *comparison.notes]), width)}"
