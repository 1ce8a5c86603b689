"""Rows of the XY table of the course MECH 467 (University of British Columbia): two measured runs and the identified machine.

Fits to parts of the runs stop early, so their bands are 5 % wide.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

from contourlab.features.refine.log_run import LogRun
from contourlab.features.refine.study import CrossValidation
from contourlab.papers.rows import IDENTITY, INPUT, Part, Row, asked, measured, ours
from contourlab.papers.ubc.runs import Unseen, left_out, read_runs, unseen

MEASURED = {"lead-lag": (76.4, 77.7, 84.7, 262.4), "pole-placement": (1277.4, 1082.7, 48.3, 95.4)}
"""From the raw logs by another program [um]: tracking rms of x and y, contour rms and maximum."""
WITHIN = 0.01
"""Relative tolerance of these figures."""
EXPLAINED = {"lead-lag": 80.0, "pole-placement": 99.0}
"""Smallest share [percent] of the variance of the tracking errors that the model must explain."""
CONTOUR = {"lead-lag": 0.25, "pole-placement": 0.15}
"""Relative tolerance of the simulated contour errors."""
FITTED = "the shipped machine, fitted to this run, along the reference of the log"
OVER = "over the part that no fit has seen; friction and damping scatter from run to run"


def parts_of(folder: str | Path | None, *, with_unseen: bool = True, stage: Callable[[str], object] | None = None) -> list[Part]:
    """Return the parts of the reproduction.

    Parameters
    ----------
    folder : str or Path
        With line_circle_lli.mat and line_circle_pp.mat.
    with_unseen : bool
        Include fits to parts of the runs; they take a few minutes.
    stage : callable, optional
        Called with the name of each fit.

    Raises
    ------
    LogError
        If a log is missing or cannot be read.
    """
    runs = read_runs(folder)
    parts: list[Part] = [
        ("judging the measured runs", lambda: _measured(runs)),
        ("simulating along the logs' references", lambda: [*_explained(runs), *_contour(runs)]),
    ]
    if with_unseen:
        parts.append(("fitting parts of the runs", lambda: _unseen(unseen(runs, stage))))
        parts.append(("leaving out each run", lambda: _left_out(left_out(runs))))
    return parts


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
            note = "over the move; compared with the figure of another program"
            yield measured(title, name, known, here[k], "um", WITHIN * known, note, kind=IDENTITY)


def _explained(runs: dict[str, LogRun]) -> Iterator[Row]:
    agreements = [agreement for run in runs.values() for agreement in run.agreement(run.once())]
    note = "of the measured tracking error over the move, to which the shipped machine is fitted"
    for part in agreements:
        case, here = f"{part.run}, {part.axis}", 100.0 * part.explained
        yield asked("variance explained", case, EXPLAINED[part.run], here, "%", 100.0, note, kind=INPUT)
    for part in agreements:
        yield ours("left of the tracking error, rms", f"{part.run}, {part.axis}", 1e6 * part.rms, "um")


def _contour(runs: dict[str, LogRun]) -> Iterator[Row]:
    figures = {name: (run.judged().metrics.contour_error, run.judged(run.once()).metrics.contour_error) for name, run in runs.items()}
    for what, figure in (("rms", "rms"), ("maximum", "max")):
        for name, pair in figures.items():
            there, here = (1e6 * getattr(error, figure) for error in pair)
            yield measured(f"simulated contour {what}", name, there, here, "um", CONTOUR[name] * there, FITTED, kind=INPUT)


def _unseen(found: list[Unseen]) -> Iterator[Row]:
    for fit in found:
        for axis in fit.agreement:
            yield ours("unseen: variance explained", f"{fit.case}: {axis.axis}", 100.0 * axis.explained, "%")
    for fit in found:
        yield _beside("unseen: contour rms", fit.case, fit.measured_rms, fit.rms)
    for fit in found:
        yield _beside("unseen: contour maximum", fit.case, fit.measured_largest, fit.largest)


def _left_out(found: CrossValidation) -> Iterator[Row]:
    for one in found.held_out:
        case = f"{one.run}, physics of the other run, gains of its first half, second half unseen"
        yield _beside("left out: contour rms", case, one.measured_rms, one.simulated_rms)
        yield _beside("left out: contour maximum", case, one.measured_max, one.simulated_max)
    note = f"for {100.0 * found.level:.0f} % of new runs of this kind"
    for name, factor in (("rms", found.rms_factor), ("maximum", found.max_factor)):
        yield ours(f"left out: factor of the contour {name}", "both runs", factor, "", note)


def _beside(name: str, case: str, there: float, here: float) -> Row:
    return measured(name, case, 1e6 * there, 1e6 * here, "um", None, OVER)
