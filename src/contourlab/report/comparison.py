"""Table of figures for the terminal, Markdown and the page."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from contourlab.report.data import ReportData, SchemeReport
from contourlab.report.run_data import FrequencyResponse
from contourlab.report.style import scheme_style
from contourlab.report.text import nominal, number

PASS, FAIL = "✓ pass", "✗ fail"
UM = 1e6


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
    label, unit : str
    cells : tuple of Cell
        One per scheme.
    change : str
        Of the last against the first, in percent.
    mood : str
        Of the change.
    strong : bool
        Whether the verdict depends on it.
    """

    label: str
    unit: str
    cells: tuple[Cell, ...]
    change: str = ""
    mood: str = ""
    strong: bool = False


@dataclass(frozen=True)
class Comparison:
    """The table, with notes on its figures and on the runs."""

    heads: tuple[Head, ...]
    rows: tuple[Row, ...]
    tolerance: str
    note: str
    notes: tuple[str, ...] = ()

    @property
    def has_change(self) -> bool:
        """Whether there is a before and an after."""
        return len(self.heads) > 1


def compare(data: ReportData) -> Comparison:
    """Return the table of a report: verdict, unstable loops, learning, errors, axes, drives, time; without figures that no scheme has."""
    count = len(data.schemes)
    heads = tuple(Head(scheme.name, scheme_style(i, count)[0]) for i, scheme in enumerate(data.schemes))
    columns = [figures_of(data, scheme) for scheme in data.schemes]
    keys = dict.fromkeys(key for column in columns for key in column)
    rows = [_row([column.get(key) for column in columns]) for key in keys]
    rows = [row for row in rows if any(cell.text != number(math.nan) for cell in row.cells)]
    rows = [*_verdict_row(data), *_loop_row(data), *_learning_row(data), *rows]
    tolerance = "" if data.tolerance is None else nominal(data.tolerance, "µm", 1e6)
    return Comparison(heads, tuple(rows), tolerance, _note(data), tuple(data.notes))


def _verdict_row(data: ReportData) -> list[Row]:
    """Return pass or fail of every scheme."""
    answers = [_passed(scheme, data.tolerance) for scheme in data.schemes]
    if all(answer is None for answer in answers):
        return []
    cells = tuple(Cell("–") if a is None else Cell(PASS if a else FAIL, "good" if a else "poor") for a in answers)
    tolerance = data.tolerance
    if tolerance is None:
        tolerance = next(scheme.verdict.tolerance for scheme in data.schemes if scheme.verdict is not None)
    return [Row(f"tolerance {nominal(tolerance, 'µm', 1e6)}", "", cells, strong=True)]


def _loop_row(data: ReportData) -> list[Row]:
    """Return which loops are unstable; nothing if none is."""
    unstable = [", ".join(_loop_name(axis, answer) for axis, answer in scheme.bode.items() if not answer.stable) for scheme in data.schemes]
    if not any(unstable):
        return []
    cells = (
        Cell(f"unstable: {axes}", "poor") if axes else Cell("stable" if scheme.bode else "–")
        for axes, scheme in zip(unstable, data.schemes, strict=True)
    )
    return [Row("servo loops", "", tuple(cells))]


def _loop_name(axis: str, answer: FrequencyResponse) -> str:
    """Return an axis, and which of its linear loops if it has several."""
    return f"{axis} ({answer.meant})" if answer.meant else axis


def _learning_row(data: ReportData) -> list[Row]:
    """Return how learning ended; nothing if no scheme learns."""
    if all(scheme.trials is None for scheme in data.schemes):
        return []
    cells = (
        Cell("–") if scheme.trials is None else Cell(scheme.trials.in_words, "poor" if scheme.trials.status.startswith("diverged") else "")
        for scheme in data.schemes
    )
    return [Row("learning", "", tuple(cells))]


def _passed(scheme: SchemeReport, tolerance: float | None) -> bool | None:
    """Return the verdict, or else compare the largest error with the tolerance; a run that stopped early fails."""
    if not scheme.result.status.ok:
        return False
    if scheme.verdict is not None:
        return bool(scheme.verdict.passed)
    if tolerance is None:
        return None
    return bool(scheme.metrics.part_error.max <= tolerance)


def _row(figures: list[Figure | None]) -> Row:
    """Return one row of numbers."""
    known = next(figure for figure in figures if figure is not None)
    values = [math.nan if figure is None else figure.value * known.factor for figure in figures]
    change, mood = _change(values[0], values[-1], known.lower_is_better) if len(values) > 1 else ("", "")
    return Row(known.label, known.unit, tuple(Cell(number(value)) for value in values), change, mood, known.strong)


def _change(before: float, after: float, lower_is_better: bool) -> tuple[str, str]:
    """Return the change of the magnitude in percent, and whether it is an improvement."""
    # Rounding is no base for a comparison.
    if not (math.isfinite(before) and math.isfinite(after)) or abs(before) <= 1e-9 * abs(after) or before == 0.0:
        return "–", ""
    percent = 100.0 * (abs(after) - abs(before)) / abs(before)
    if abs(percent) < 0.05:
        return "0 %", ""
    text = f"{percent:+.0f} %" if abs(percent) >= 10.0 else f"{percent:+.1f} %"
    mood = ("good" if percent < 0.0 else "poor") if lower_is_better and abs(percent) >= 1.0 else ""
    return text.replace("-", "−"), mood


def _judged_part(schemes: Sequence[SchemeReport]) -> str:
    """Say over which part of the run the errors are: once where it is the same of all, else of each."""
    parts = []
    for scheme in schemes:
        start, stop = (number(sample * scheme.result.servo_period, 4) for sample in scheme.metrics.window)
        parts.append((scheme.metrics.basis, f"{start} s to {stop} s"))
    if len(set(parts)) == 1:
        return f"Errors over the {parts[0][0]}, {parts[0][1]}."
    if len({basis for basis, _ in parts}) == 1:
        times = ", ".join(f"{when} of {scheme.name}" for scheme, (_, when) in zip(schemes, parts, strict=True))
        return f"Errors over the {parts[0][0]}: {times}."
    text = ", ".join(f"the {basis} of {scheme.name}, {when}" for scheme, (basis, when) in zip(schemes, parts, strict=True))
    return f"Errors over {text}."


def _note(data: ReportData) -> str:
    """Return remarks on the figures."""
    notes = [_judged_part(data.schemes)]
    if data.is_measured:
        notes.append("Positions are those of the log: errors exclude what its encoders do not see.")
    elif not data.is_blended:
        notes.append("The planned path is the programmed one: the contour error is the part error.")
    if len(data.schemes) > 1:
        notes.append(f"Change: {data.schemes[-1].name} against {data.schemes[0].name}.")
    for scheme in data.schemes:
        if not scheme.result.status.ok:
            why = scheme.result.status.reason
            notes.append(f"{scheme.name} did not finish: {why}; its figures cover the completed part.")
    return " ".join(notes)


@dataclass(frozen=True)
class Figure:
    """One number of one run: SI value, and how to print it.

    Parameters
    ----------
    label : str
    value : float
        SI.
    factor : float
        From SI to `unit`.
    unit : str
    strong : bool
        Whether the tolerance applies to it.
    lower_is_better : bool
    """

    label: str
    value: float
    factor: float
    unit: str
    strong: bool = False
    lower_is_better: bool = True


def figures_of(data: ReportData, scheme: SchemeReport) -> dict[str, Figure]:
    """Return the figures of a run in the order of print, by label; part error and contour error appear once if they are the same."""
    return {figure.label: figure for figure in _figures(data, scheme)}


def _figures(data: ReportData, scheme: SchemeReport) -> Iterator[Figure]:
    metrics, blended = scheme.metrics, data.is_blended
    if blended:
        yield Figure("part error, largest", metrics.part_error.max, UM, "µm", strong=True)
        yield Figure("part error, rms", metrics.part_error.rms, UM, "µm")
        yield Figure("planning deviation, largest", metrics.planning_deviation.max, UM, "µm")
    error = metrics.contour_error
    yield Figure("contour error, largest", error.max, UM, "µm", strong=not blended)
    yield Figure("contour error, rms", error.rms, UM, "µm")
    yield Figure("contour error, mean", error.mean, UM, "µm")
    yield Figure("contour error, 95th percentile", error.p95, UM, "µm")
    if len(data.axes) == 2:  # in space the error has no side
        yield Figure("contour error, signed mean", error.signed_mean, UM, "µm", lower_is_better=False)
    yield Figure("contour error, integral", error.integral, UM, "µm·s")
    for axis, tracking in zip(data.axes, metrics.tracking_error, strict=True):
        yield Figure(f"tracking error {axis}, rms", tracking.rms, UM, "µm")
    for axis, part in zip(data.axes, metrics.saturation, strict=True):
        yield Figure(f"drive {axis} saturated", part, 100.0, "% of time")
    yield Figure("feedrate, mean", metrics.feedrate_mean, 6e4, "mm/min", lower_is_better=False)
    yield Figure("feedrate, ripple", metrics.feedrate_ripple, 100.0, "%")
    yield Figure("cycle time", metrics.cycle_time, 1.0, "s")
    if scheme.tick is not None:
        yield Figure("servo tick, machine included", scheme.tick, 1e9, "ns", lower_is_better=False)
