"""The XY table of the course MECH 467 (University of British Columbia): two measured line-circle runs, and the machine found from them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from contourlab.features.refine.log_run import LogRun
from contourlab.papers.rows import Part, Row, Stage, asked, in_parts, measured, ours
from contourlab.papers.ubc.runs import Unseen, read_runs, unseen

MEASURED = {"lead-lag": (76.4, 77.7, 84.7, 262.4), "pole-placement": (1277.4, 1082.7, 48.3, 95.4)}
"""Of the raw logs, worked out by another program [um]: tracking rms of x and y, contour rms and maximum."""
WITHIN = 0.01
"""Share within which they count as the same."""
EXPLAINED = {"lead-lag": 80.0, "pole-placement": 99.0}
"""Least share [percent] of the variance of the tracking errors that a model of the table has to explain."""
CONTOUR = {"lead-lag": 0.25, "pole-placement": 0.15}
"""Share within which its contour rms has to be the measured one."""
FITTED = "the library's machine along the log's own reference"


def reproduce(folder: str | Path | None = None, *, with_unseen: bool = True, stage: Stage | None = None) -> list[dict[str, Any]]:
    """Return the figures of the measured runs, of the simulated ones, and of fits that left something out.

    Parameters
    ----------
    folder : str or Path
        With line_circle_lli.mat and line_circle_pp.mat.
    with_unseen : bool
        Whether fits are made that leave parts of the runs out; they take a few minutes.
    stage : callable, optional
        Told in words what is begun.

    Raises
    ------
    LogError
        If a log is not given or cannot be read.
    """
    runs = read_runs(folder)
    parts: list[Part] = [
        ("judging the measured runs", lambda: _measured(runs)),
        ("simulating along the logs' references", lambda: [*_explained(runs), *_contour(runs)]),
    ]
    if with_unseen:
        parts.append(("fitting with parts of the runs left out", lambda: _unseen(unseen(runs, stage))))
    return list(in_parts(parts, stage))


def _measured(runs: dict[str, LogRun]) -> Iterator[Row]:
    figures = {}
    for name, run in runs.items():
        found = run.judged().metrics
        tracking = [axis.rms for axis in found.tracking_error]
        figures[name] = [1e6 * value for value in (*tracking, found.contour_error.rms, found.contour_error.max)]
    titles = ("measured tracking rms, x", "measured tracking rms, y", "measured contour rms", "measured contour maximum")
    for k, title in enumerate(titles):
        for name, here in figures.items():
            known = MEASURED[name][k]
            yield measured(
                title, name, known, here[k], "um", WITHIN * known, "over the move; beside it what another program makes of the log"
            )


def _explained(runs: dict[str, LogRun]) -> Iterator[Row]:
    found = [one for run in runs.values() for one in run.agreement(run.once())]
    note = "of the measured tracking error over the move; 100 would be all"
    for one in found:
        yield asked("variance explained", f"{one.run}, {one.axis}", EXPLAINED[one.run], 100.0 * one.explained, "%", 100.0, note)
    for one in found:
        yield ours("left of the tracking error, rms", f"{one.run}, {one.axis}", 1e6 * one.rms, "um")


def _contour(runs: dict[str, LogRun]) -> Iterator[Row]:
    figures = {name: (run.judged().metrics.contour_error, run.judged(run.once()).metrics.contour_error) for name, run in runs.items()}
    for name, (there, here) in figures.items():
        yield measured("simulated contour rms", name, 1e6 * there.rms, 1e6 * here.rms, "um", CONTOUR[name] * 1e6 * there.rms, FITTED)
    for name, (there, here) in figures.items():
        yield measured("simulated contour maximum", name, 1e6 * there.max, 1e6 * here.max, "um", CONTOUR[name] * 1e6 * there.max, FITTED)


def _unseen(found: list[Unseen]) -> Iterator[Row]:
    for one in found:
        for axis in one.agreement:
            yield ours("unseen: variance explained", f"{one.case}: {axis.axis}", 100.0 * axis.explained, "%")
    for one in found:
        yield _beside("unseen: contour rms", one.case, one.measured_rms, one.rms)
    for one in found:
        yield _beside("unseen: contour maximum", one.case, one.measured_largest, one.largest)


def _beside(name: str, case: str, there: float, here: float) -> Row:
    return measured(name, case, 1e6 * there, 1e6 * here, "um", None, f"over the part left out; {100.0 * (here / there - 1.0):+.0f} %")
