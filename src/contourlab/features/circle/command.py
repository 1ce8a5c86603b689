"""``contourlab circle``: the causes behind measured circles."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from contourlab.app.session import QUIET, Session, question
from contourlab.errors import ParameterError, ResultError
from contourlab.features.circle.fit import CircleFit, fit_circle
from contourlab.features.circle.options import Circle
from contourlab.features.circle.result import SURE, Cause, CircleTest, Correlation, causes_of, correlations_of, lags_of
from contourlab.features.circle.runs import CircleRun, find_circle, is_polar, own_columns, polar_runs, runs_of
from contourlab.features.measure.log_choice import LogChoice, open_log
from contourlab.features.measure.plausibility import columns_of, known_signal
from contourlab.features.measure.study import ACTUAL
from contourlab.findings import Finding, finding
from contourlab.logs import Log, read_record
from contourlab.logs.load import about
from contourlab.metrics import bidirectional, circle_figures

FINDINGS = {
    "backlash": "CL480",
    "lateral play": "CL481",
    "reversal spikes": "CL482",
    "servo mismatch": "CL483",
    "squareness": "CL484",
    "scaling mismatch": "CL485",
    "cyclic error": "CL486",
    "vibration": "CL487",
    "squareness or servo mismatch": "CL488",
}
LARGE, MOST = 0.2, 3
"""Share of the largest cause from which another one gets a finding, and the most of them."""
HELD = 0.02
"""Acceleration [m/s^2] that the friction of a guideway gives a load: 0.002 of its weight, that of rolling guides without seals."""
SAME = 0.01
"""Share by which fitted radii of one circle may differ."""


@question(Circle)
def circle(*logs: str | Path | Log, settings: Circle, session: Session = QUIET) -> CircleTest:
    """Find the causes that shape measured circles.

    Parameters
    ----------
    *logs : str, Path or Log
        Logs, or text files of angle and radius: one with all runs, or one for each sense.

    Returns
    -------
    CircleTest

    Raises
    ------
    LogError
        If a file cannot be read, or holds no circle.
    ParameterError
        If an option is out of range.
    """
    session.will_write(logs, "summary.json", "report.html")
    runs, axes, findings = _read([LogChoice.of(log, settings) for log in logs], settings)
    with about(*logs):
        fit = fit_circle(runs, axes, settings.si("pitch"))
        name = " and ".join(Path(log).name for log in logs)
        test = _result(fit, name, session.command, settings.si("tolerance"))
    return replace(test, findings=(*test.findings, *findings), inputs=tuple(logs))


def _read(choices: Sequence[LogChoice], settings: Circle) -> tuple[list[CircleRun], tuple[str, str], list[Finding]]:
    """Return the runs of all files, around one nominal radius; the axes; and findings on the files."""
    radius, feed = settings.si("radius"), settings.si("feed")
    runs, findings, pair, is_known = list[CircleRun](), list[Finding](), ("x", "y"), radius is not None
    for choice in choices:
        named, columns = own_columns(choice.columns)
        record = read_record(choice.file, choice.format)
        if named or is_polar(record, named):
            axes = tuple(choice.axes) or ("x", "y")
            with about(choice.file, options=("radius",)):
                runs += polar_runs(record, named, radius, math.nan if feed is None else feed)
        else:
            log = open_log(replace(choice, columns=columns))
            axes = tuple(choice.axes) or log.result.axes[:2]
            with about(choice.file):
                own, has_reference = _log_runs(log, axes, radius)
            runs += own
            findings += [*log.findings, *([] if "tool_position" in log.result else [finding("CL491")])]
            is_known = is_known or has_reference
        if len(axes) != 2:
            raise ParameterError("--axes", ",".join(axes), "two axes, such as x,y")
        pair = axes[0], axes[1]
    unique = {str(doubt): doubt for doubt in findings}
    radii = [run.radius for run in runs]
    mean = sum(radii) / len(radii)
    if max(radii) - min(radii) <= SAME * mean:  # fitted radii of the same circle differ by little
        runs = [replace(run, radius=mean, deviation=run.deviation + (run.radius - mean)) for run in runs]
    return runs, pair, [*unique.values(), *([] if is_known else [finding("CL492")])]


def _log_runs(log: Log, axes: tuple[str, ...], radius: float | None) -> tuple[tuple[CircleRun, ...], bool]:
    """Return the runs of a log, and whether it has the command."""
    result = log.result
    if len(columns_of(result, axes)) < 2:
        raise ResultError(f"has the axis {', '.join(axes)} only: a circle needs two")
    measured, commanded = (known_signal(result, axes[:2], names) for names in (ACTUAL, ("reference",)))
    if measured is None:
        raise ResultError(f"no position in {result.source}: name its columns, such as --column 'position.x=NAME [mm]'")
    position, reference = measured[1], None if commanded is None else commanded[1]
    circle = find_circle(position if reference is None else reference)
    if radius is not None and abs(radius - circle.radius) > 0.05 * radius:
        raise ResultError(f"a circle of {1e3 * circle.radius:.6g} mm radius, not of {1e3 * radius:.6g} mm")
    circle = replace(circle, radius=circle.radius if radius is None else radius)
    return runs_of(log.record.file.name, position, result.servo_period, circle, reference), reference is not None


def _result(fit: CircleFit, name: str, command: str, tolerance: float | None) -> CircleTest:
    plane = "".join(fit.axes).upper()
    runs = tuple(circle_figures(run.points, np.zeros(2), run.radius, run.clockwise, f"{plane} of {run.name}") for run in fit.runs)
    senses = {run.clockwise: run for run in reversed(runs)}
    causes, correlations = causes_of(fit), correlations_of(fit)
    radius, centre = (fit.place(term) for term in fit.terms[:2])
    deviations = np.sqrt(np.maximum(np.diag(fit.covariance), 0.0))
    feed = fit.runs[0].feedrate
    test = CircleTest(
        name=name,
        command=command,
        axes=fit.axes,
        radius=fit.runs[0].radius,
        feedrate=feed if math.isfinite(feed) else None,
        runs=runs,
        bidirectional=bidirectional(senses[False], senses[True]) if fit.both else None,
        causes=tuple(causes),
        correlations=tuple(correlations),
        radius_change=float(fit.coefficients[radius][0]),
        radius_deviation=float(deviations[radius][0]),
        centre=tuple(fit.coefficients[centre].tolist()),
        centre_deviation=tuple(deviations[centre].tolist()),
        lag=lags_of(fit),
        spikes=fit.spikes,
        residual=fit.residual,
        tolerance=tolerance,
        passed=None,
        findings=(*_cause_findings(causes), *_fit_findings(fit, causes, correlations)),
        fit=fit,
    )
    return replace(test, passed=None if tolerance is None else test.circular_deviation <= tolerance)


def _cause_findings(causes: Sequence[Cause]) -> list[Finding]:
    """Return a finding for each large cause: its meaning and remedy are in the catalogue."""
    sure = [cause for cause in causes if cause.is_sure]
    large = [cause for cause in sure if cause.contribution >= LARGE * sure[0].contribution][:MOST]
    return [
        finding(FINDINGS[cause.cause], f"axis {cause.axis}" if cause.axis else "", adds=cause.contribution, deviation=cause.deviation)
        for cause in large
    ]


def _fit_findings(fit: CircleFit, causes: Sequence[Cause], correlations: Sequence[Correlation]) -> list[Finding]:
    """Return what limits the fit: one sense, correlated estimates, a fast circle, a residual as large as the causes."""
    findings = [] if fit.both else [finding("CL489")]
    by_name = {cause.name: cause for cause in causes}
    shown = [pair for pair in correlations if any(name in by_name and by_name[name].is_sure for name in pair.causes)]
    if shown:
        pairs = [f"{a} with {b} ({pair.correlation:+.2f})" for pair in shown[:MOST] for a, b in [pair.causes]]
        findings.append(finding("CL490", pairs=pairs))
    largest = max((cause.contribution for cause in causes if cause.is_sure), default=0.0)
    if (acceleration := fit.runs[0].feedrate ** 2 / fit.runs[0].radius) > HELD:
        findings.append(finding("CL494", acceleration=acceleration, feed=math.sqrt(HELD * fit.runs[0].radius)))
    if SURE * fit.residual > largest:
        findings.append(finding("CL493", residual=fit.residual))
    return findings
