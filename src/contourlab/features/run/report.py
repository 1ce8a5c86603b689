"""The data of a report: on the outcomes of a session, and on runs made in Python."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import count
from pathlib import Path

import numpy as np

from contourlab.errors import ParameterError
from contourlab.features.run.outcome import Outcome, judged_spikes
from contourlab.features.run.verdict import unexplained
from contourlab.feed import Reference
from contourlab.feed.planner import Binding, limiting
from contourlab.figures import listing
from contourlab.metrics.circles import circles_of
from contourlab.metrics.figures import summarise
from contourlab.metrics.judge import judge
from contourlab.program import Program
from contourlab.rendering.data import FeedRun, JudgedRun, Provenance, ReportData
from contourlab.rendering.html import write_html
from contourlab.result import Result

FEED_POINTS = 4000
PER_SPAN = 3
MOST_POINTS = 200_000
"""Above, only the start of each span is evaluated."""
_HELD_BY = {
    Binding.REST: "at rest",
    Binding.FEEDRATE: "programmed feed",
    Binding.VELOCITY: "axis velocity",
    Binding.ACCELERATION: "axis acceleration",
    Binding.JERK: "axis jerk",
    Binding.CURVATURE_STEP: "curvature step",
    Binding.PLANNER: "near a slow section",
    Binding.CORNER: "corner",
}


def report(
    results: Result | Sequence[Result] | Mapping[str, Result],
    file: str | Path = "report.html",
    *,
    reference: Reference | Sequence[Reference] | None = None,
    tolerance: float | None = None,
    program: Program | None = None,
    title: str = "",
) -> Path:
    """Write one page about runs along one path: HTML that opens off-line, or, to print, a file that ends in ``.pdf``.

    Parameters
    ----------
    results : Result, sequence of Result, or mapping of str to Result
        The first is compared with the others. A run that is not judged is judged first. Names are those of a mapping, or else the
        schemes; equal ones are numbered.
    file : str or Path
        Replaced completely or not at all.
    reference : Reference or sequence of Reference, optional
        The reference of all runs or of each. A result of `simulate` or `judge` knows its own; one from a file does not.
    tolerance : float [m], > 0 and < 1, optional
        Largest part error that passes.
    program : Program, optional
        The part program, for the error of each line.
    title : str
        By default the names of the runs.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    ParameterError
        If there is no result, or their number is not that of the references, a reference is missing, paths or axes differ, or the
        tolerance is out of range.
    ResultError
        If a signal is missing, or a result is of another reference.
    OutputError
        If the file cannot be written.

    Notes
    -----
    Causes, margins and limits need the scenario: `contourlab run` adds them.
    """
    data = data_of(results, reference, tolerance, program, title)
    if Path(file).suffix.lower() == ".pdf":
        from contourlab.rendering.one_page import write_page

        return write_page(data, file)
    return write_html(data, file)


Results = Result | Sequence[Result] | Mapping[str, Result]


def data_of(
    results: Results, reference: Reference | Sequence[Reference] | None, tolerance: float | None, program: Program | None, title: str = ""
) -> ReportData:
    """Return the data of a report on results; parameters and errors as in `report`."""
    if tolerance is not None and not (isinstance(tolerance, float | int) and 0.0 < tolerance < 1.0):
        raise ParameterError("tolerance", repr(tolerance), "> 0 and < 1, in metres: 25e-6 for 25 um", "m")
    named = _named(results)
    motions = _references(named, reference)
    first, motion = next(iter(motions.items()))
    for name, other in motions.items():
        if other.programmed.digest != motion.programmed.digest:
            raise ParameterError(f"path of {name!r}", "another one", f"that of {first!r}")
    schemes = [_scheme(name, result, motions[name], tolerance, program) for name, result in named.items()]
    return ReportData(title or ", ".join(named), schemes, Provenance(), () if program is None else program.lines, tolerance)


def _named(results: Results) -> dict[str, Result]:
    """Return the results by name, equal names numbered."""
    members = [results] if isinstance(results, Result) else list(results.values() if isinstance(results, Mapping) else results)
    wrong = [type(one).__name__ for one in members if not isinstance(one, Result)]
    if wrong or not members:
        raise ParameterError("results", wrong[0] if wrong else "none", "one Result or more")
    if isinstance(results, Mapping):
        return dict(results)
    named: dict[str, Result] = {}
    for result in members:
        names = (result.scheme if number == 1 else f"{result.scheme} {number}" for number in count(1))
        named[next(name for name in names if name not in named)] = result
    return named


def _references(named: Mapping[str, Result], reference: Reference | Sequence[Reference] | None) -> dict[str, Reference]:
    given = [reference] * len(named) if reference is None or isinstance(reference, Reference) else list(reference)
    if len(given) != len(named):
        raise ParameterError("reference", f"{len(given)} references", f"one for all, or one for each of {len(named)} results")
    motions = {}
    for (name, result), one in zip(named.items(), given, strict=True):
        motion = result.motion if one is None else one
        if motion is None:
            raise ParameterError("reference", "None", f"given: {name!r} does not know the reference that it was simulated along")
        motions[name] = motion
    return motions


def _scheme(name: str, result: Result, reference: Reference, tolerance: float | None, program: Program | None) -> JudgedRun:
    """Judge a run where necessary, and sum it up."""
    judged = result if {"part_error", "tracking_error"} <= set(result.signals) else judge(result, reference)
    verdict = None if tolerance is None else unexplained(reference, judged, tolerance, () if program is None else program.lines)
    figures = (summarise(judged, reference), verdict, circles_of(judged, reference), judged_spikes(judged, reference))
    return JudgedRun(name, reference, judged, *figures, () if verdict is None else verdict.findings)


def report_data(title: str, outcomes: Sequence[Outcome], *, scenario: str, command: str) -> ReportData:
    """Return the data of a report on outcomes (at least one) along one path; `scenario` is TOML, `command` as typed."""
    first = outcomes[0]
    again = "save the scenario below as scenario.toml, then: contourlab run scenario.toml"
    provenance = Provenance(command, again, scenario, first.case.run.seed)
    notes = [*first.case.motion.notes]
    others = [outcome.name for outcome in outcomes if first.reference.digest != outcome.reference.digest and not outcome.reference.decided]
    if others:
        notes.append(f"The planned feed shown is that of {first.name}. {listing(others)}: planned differently.")
    return ReportData(title, outcomes, provenance, first.case.lines, first.case.tolerance, notes, _feed(first))


def _feed(outcome: Outcome) -> FeedRun | None:
    """Return the planned motion at even times and within each of its spans; None where it was not planned within limits."""
    reference, profile, route = outcome.reference, outcome.reference.profile, outcome.case.route()
    if profile is None or route is None:
        return None
    # Evenly over time, and within the ramps, which a rapid passes between two even places.
    ends = np.append(profile.t0[1:], profile.duration)
    per_span = PER_SPAN if PER_SPAN * ends.size <= MOST_POINTS else 1
    ramps = np.linspace(profile.t0, ends, per_span, endpoint=False).ravel()
    time = np.unique(np.concatenate([np.linspace(0.0, profile.duration, FEED_POINTS), ramps]))
    motion = profile.motion(time)
    limits, curvature_step = outcome.case.machine.planner_limits(), outcome.case.feed.curvature_step
    codes = limiting(route, limits, profile, motion.arc_length, curvature_step=curvature_step)
    asked = route.feedrate[reference.path.curve_index(motion.arc_length)]
    return FeedRun(motion.arc_length, motion.speed, asked, time, codes, [_HELD_BY[code] for code in Binding])
