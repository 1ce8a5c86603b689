"""What a report says first: one sentence that answers the question, and the error of each program line."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.feed import Reference
from contourlab.figures import NONE, figure, number
from contourlab.metrics.figures import blocks_of
from contourlab.rendering.data import JudgedRun, ReportData
from contourlab.rendering.judgement import FEED
from contourlab.rendering.samples import signal

MOST_LINES, LETTERS = 500, 200
"""Most lines of a program on a page, and letters of a line."""


def sentence(data: ReportData) -> str:
    """Return the answer in one or two sentences: does the tool keep the tolerance, where not, why, and what helps."""
    schemes = data.schemes
    best = min(schemes, key=lambda scheme: (data.passed(scheme) is False, scheme.metrics.part_error.max))
    if len(schemes) == 1:
        return answer(best)
    size = figure(best.metrics.part_error.max, "um")
    if data.tolerance is None:
        return f"Of {len(schemes)} runs, {best.name} keeps closest to the path: {size} at most."
    kept = sum(data.passed(scheme) is not False for scheme in schemes)
    count = f"{kept} of {len(schemes)} runs {'stays' if kept == 1 else 'stay'}" if kept else f"None of {len(schemes)} runs stays"
    return f"{count} within {figure(data.tolerance, 'um', 6)}. Best: {best.name}, {size}."


def answer(scheme: JudgedRun) -> str:
    """Return the verdict on a run: where and how large the error is, its largest cause, and the price of what lowers it.

    The price is that of a lower feed and of the best other change, each as it was run alone.
    """
    verdict = scheme.verdict
    if not scheme.result.status.ok:
        return f"The run did not finish: {scheme.result.status.reason}."
    if verdict is None:
        return f"The tool leaves the path by {figure(scheme.metrics.part_error.max, 'um')} at most."
    worst, cause = verdict.worst, max(verdict.causes, key=lambda cause: cause.contribution, default=None)
    where = f"line {worst.line}" if worst.line else "(" + ", ".join(f"{x * 1e3:.3f}" for x in worst.position) + ") mm"
    size, allowed = figure(worst.value, "um"), figure(verdict.tolerance, "um", 6)
    # An error within the tolerance alone would not explain the verdict.
    skips = f", the tool skips {figure(verdict.left_out, 'mm')} of the path" if verdict.left_out else ""
    why = "" if cause is None else f", {cause.words}"
    text = f"{'PASS' if verdict.passed else 'FAIL'} at {where}, t = {worst.time:.3f} s: {size} of {allowed} allowed{skips}{why}."
    lower_feed = [change for change in verdict.changes if change.name == FEED]
    for change in [*lower_feed, *[other for other in verdict.changes if other.name != FEED][:1]]:
        longer = f", {float(f'{change.added_time:.2g}'):+g} s" if abs(change.added_time) > 0.005 else ""
        text += f" {change.name[0].upper()}{change.name[1:]}: {figure(change.part_error, 'um')}{longer}."
    return text


def lines_at(reference: Reference, along: Array) -> Index:
    """Return the program line at arc lengths (n,) [m] of the programmed path; 0 for none."""
    breaks = reference.programmed_arc_length(reference.line_breaks)
    return np.take(reference.source_lines, np.searchsorted(breaks, along, side="right") - 1, mode="clip")


@dataclass(frozen=True)
class LineRow:
    """A line of the program: number, text, and of each run the largest part error [um] and whether it exceeds the tolerance."""

    number: int
    text: str
    errors: tuple[tuple[str, bool], ...]


def program_lines(data: ReportData) -> tuple[LineRow, ...]:
    """Return the judged lines of the program with their errors; of very many those with the largest errors."""
    columns = [_largest(scheme) for scheme in data.schemes]
    worst = {int(s.verdict.worst.line) for s in data.schemes if s.verdict is not None} - {0}
    together = {line: max(column.get(line, 0.0) for column in columns) for column in columns for line in column}
    shown = worst | set(sorted(together, key=lambda line: -together[line])[:MOST_LINES])
    limit = np.inf if data.tolerance is None else data.tolerance

    def cell(error: float | None) -> tuple[str, bool]:
        return (NONE, False) if error is None else (number(1e6 * error), error > limit)

    inside = [n for n in sorted(shown) if n <= len(data.program)]
    return tuple(LineRow(n, data.program[n - 1][:LETTERS], tuple(cell(column.get(n)) for column in columns)) for n in inside)


def _largest(scheme: JudgedRun) -> dict[int, float]:
    """Return the largest part error [m] of each line with judged samples."""
    size = np.full(int(scheme.reference.source_lines.max()) + 1, -1.0)
    for cut in blocks_of(scheme.metrics.judged):
        np.maximum.at(size, scheme.lines(cut), np.abs(signal(scheme.result, "part_error")[cut]))
    return {line: float(size[line]) for line in np.flatnonzero(size >= 0.0).tolist() if line}
