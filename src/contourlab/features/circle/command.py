"""``contourlab circle``: the causes behind measured circles, ranked by what they add, as text, JSON and a page."""

from __future__ import annotations

import math
import os
import shlex
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from pathlib import Path

import numpy as np

from contourlab.analysis.identification.least_squares import correlation_of, fit_records
from contourlab.app.command_line import as_typed
from contourlab.app.json_values import HIDDEN, write_json
from contourlab.app.results import staged
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.arrays import Array
from contourlab.errors import ParameterError, ResultError, refuse
from contourlab.features.circle.fit import CircleFit, ReversalSpike, Term, fit_circle
from contourlab.features.circle.options import Circle
from contourlab.features.circle.runs import CircleRun, find_circle, is_polar, own_columns, polar_runs, runs_of
from contourlab.features.measure.log_choice import open_log, read_again
from contourlab.features.measure.plausibility import columns_of, known_signal
from contourlab.features.measure.study import ACTUAL
from contourlab.figures import figure, limit_to_propose, number
from contourlab.findings import Finding, finding
from contourlab.logs import Log, read_record
from contourlab.logs.load import about
from contourlab.metrics.circles import Bidirectional, CircleFigures, bidirectional, circle_figures
from contourlab.rendering.charts import Chart, CircleCauses, CircleTrace, traces_chart
from contourlab.rendering.html import page_text
from contourlab.rendering.style import scheme_style
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result import write_text_atomic

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
POINTS = 2400
"""Most points of a run in the picture."""
SURE = 3.0
"""Deviations from which a cause counts as found."""
TIED = 0.9
"""Correlation from which two estimates count as hard to tell apart."""
_NOT_SHAPE = ("radius", "centre")


@dataclass(frozen=True)
class Cause:
    """What one cause adds to the circle.

    Attributes
    ----------
    cause : str
        In the terms of ball-bar software, as "servo mismatch".
    axis : str
        Empty for a cause of both axes.
    contribution, deviation : float [m]
        Largest less smallest radial deviation that it causes, over all runs, and its standard deviation.
    value, value_deviation : float
        The cause in its own unit.
    unit : str
        SI unit of the value: m, s, rad, or empty for a ratio.
    pitch : float or None [m]
        Of a cyclic error.
    frequency : float or None [Hz]
        Of a vibration; null if the feed is unknown.
    order : float or None
        Vibration cycles per turn.
    """

    cause: str
    axis: str
    contribution: float
    deviation: float
    value: float
    value_deviation: float
    unit: str
    pitch: float | None = None
    frequency: float | None = None
    order: float | None = None

    @property
    def name(self) -> str:
        """Cause and axis."""
        return f"{self.cause} {self.axis}".strip()

    @property
    def is_sure(self) -> bool:
        """Whether it exceeds `SURE` deviations."""
        return self.contribution > SURE * self.deviation


@dataclass(frozen=True)
class Correlation:
    """Correlation of the estimates of two causes; near 1 or -1 their sum is known better than each."""

    causes: tuple[str, str]
    correlation: float


@dataclass(frozen=True)
class Lag:
    """Following lag of an axis.

    Attributes
    ----------
    axis : str
    time, deviation : float [s]
        Command less position over the commanded velocity, and its standard deviation.
    """

    axis: str
    time: float
    deviation: float


@dataclass(frozen=True, eq=False)
class CircleTest(Answer):
    """The result of a circle test.

    Attributes
    ----------
    name : str
    command : str
        Command line as typed.
    axes : (str, str)
    radius : float [m]
        Nominal.
    feedrate : float or None [m/s]
    runs : tuple of CircleFigures
        Figures of ISO 230-4 for each run.
    bidirectional : Bidirectional or None
        Of the first two runs in opposite senses.
    causes : tuple of Cause
        The largest first.
    correlations : tuple of Correlation
        Pairs of causes that are hard to tell apart.
    radius_change, radius_deviation : float [m]
        Mean radius less nominal, which no cause explains, and its standard deviation.
    centre, centre_deviation : (float, float) [m]
        Centre from the nominal one.
    lag : tuple of Lag
        Empty without a command in the log.
    spikes : tuple of ReversalSpike
    residual : float [m]
        Root mean square of what no cause explains, away from reversals.
    tolerance : float or None [m]
    passed : bool or None
        Whether the circular deviation is within the tolerance.
    """

    ROWS = "causes"

    name: str
    command: str
    axes: tuple[str, str]
    radius: float
    feedrate: float | None
    runs: tuple[CircleFigures, ...]
    bidirectional: Bidirectional | None
    causes: tuple[Cause, ...]
    correlations: tuple[Correlation, ...]
    radius_change: float
    radius_deviation: float
    centre: tuple[float, float]
    centre_deviation: tuple[float, float]
    lag: tuple[Lag, ...]
    spikes: tuple[ReversalSpike, ...]
    residual: float
    tolerance: float | None
    passed: bool | None
    findings: tuple[Finding, ...]
    report: str = field(default="", metadata=HIDDEN)
    fit: CircleFit | None = field(default=None, metadata=HIDDEN, repr=False)
    inputs: tuple[str | os.PathLike[str], ...] = field(default=(), metadata=HIDDEN, repr=False)

    @property
    def circular_deviation(self) -> float:
        """Circular deviation of both senses together, or the largest of a run [m]."""
        largest = max(run.circular_deviation for run in self.runs)
        return largest if self.bidirectional is None else max(largest, self.bidirectional.circular_deviation)

    @property
    def text(self) -> str:
        """The result for the terminal."""
        report = f"report: {self.report}" if self.report else ""
        parts = (paragraphs([self.sentence]), self._causes().text(), paragraphs(self._about()), paragraphs(map(str, self.findings)), report)
        return "\n\n".join(filter(None, parts))

    def _charts(self) -> Iterator[Chart]:
        assert self.fit is not None
        runs = {f"{run.name} {k + 1}": (np.degrees(run.angle), 1e6 * run.deviation) for k, run in enumerate(self.fit.runs)}
        yield traces_chart("circle", "Deviation from the circle", ("angle [deg]", "radial deviation [um]"), runs)

    def _pictures(self) -> Iterator[CircleCauses]:
        assert self.fit is not None
        yield _picture(self, self.fit)

    def save(self, folder: str | Path = "results") -> CircleTest:
        """Write summary.json and report.html into a folder.

        Returns
        -------
        CircleTest
            With the name of its report.

        Raises
        ------
        OutputError
            If the folder cannot be written to.
        """
        assert self.fit is not None
        saved = replace(self, report=str(Path(folder) / "report.html"))
        with staged(folder, "summary.json", "report.html", inputs=self.inputs) as stage:
            write_json(stage / "summary.json", saved)
            _write_page(saved, self.fit, stage / "report.html")
        return saved

    @property
    def next_step(self) -> str:
        """The command to type next: with a tolerance, or what identifies the cause; empty if no command says what was asked."""
        if not self.command:
            return ""
        if self.tolerance is None:
            return f"{self.command} {as_typed(['--tolerance', limit_to_propose(0.5 * self.circular_deviation)])}"
        if self.lag:
            kept = read_again(shlex.split(self.command))
            return as_typed(["contourlab", "identify", str(self.inputs[0]), "--model", "position-loop", *kept])
        return as_typed(["contourlab", "explain", self.findings[0].code if self.findings else "CL480"])

    def _next(self, asked: Asked) -> Sequence[object]:
        return shlex.split(self.next_step)[1:]

    @property
    def sentence(self) -> str:
        """Circular deviation, verdict and largest cause."""
        verdict = ""
        if self.tolerance is not None:
            verdict = f"{'PASS' if self.passed else 'FAIL'}, tolerance {figure(self.tolerance, 'um')}: "
        sure = [cause for cause in self.causes if cause.is_sure]
        largest = f"; most of it: {sure[0].name}, {plus_minus(sure[0].contribution, sure[0].deviation)} um" if sure else "; no cause found"
        return f"{verdict}circular deviation {figure(self.circular_deviation, 'um')}{largest}."

    def _causes(self) -> Table:
        adds = (plus_minus(cause.contribution, cause.deviation) for cause in self.causes)
        rows = ((one.name, size if one.is_sure else f"({size})", value_text(one)) for one, size in zip(self.causes, adds, strict=True))
        return Table([Column("cause", left=True), Column("adds [um]"), Column("value", left=True)], rows=rows)

    def _about(self) -> Iterator[str]:
        senses = [f"{'clockwise' if run.clockwise else 'counter-clockwise'} {figure(run.circular_deviation, 'um')}" for run in self.runs]
        feed = "" if self.feedrate is None else f" at {figure(self.feedrate, 'mm/min', 4)}"
        yield f"circle       radius {figure(self.radius, 'mm', 6)}{feed}, axes {', '.join(self.axes)}; deviation {', '.join(senses)}"
        yield f"radius       {plus_minus(self.radius_change, self.radius_deviation)} um from nominal"
        places = zip(self.axes, self.centre, self.centre_deviation, strict=True)
        yield "centre       " + ", ".join(f"{axis} {plus_minus(at, deviation)} um" for axis, at, deviation in places)
        if self.lag:
            times = ", ".join(f"{lag.axis} {plus_minus(lag.time, lag.deviation, 1e3)} ms" for lag in self.lag)
            yield f"lag          {times}"
        if not all(cause.is_sure for cause in self.causes):
            yield f"(in brackets: below {SURE:g} deviations)"
        yield f"unexplained  {figure(self.residual, 'um')} rms away from reversals"


def plus_minus(value: float, deviation: float, factor: float = 1e6) -> str:
    """Return a value with its standard deviation, by default in um.

    >>> plus_minus(8.0049e-6, 2.3e-8), plus_minus(1.2e-7, 4e-7)
    ('8.005 +- 0.023', '0.12 +- 0.40')
    """
    deviation *= factor
    if not 0.0 < deviation < math.inf:
        return f"{number(factor * value)} +- {number(deviation)}"
    places = min(max(1 - math.floor(math.log10(deviation)), 0), 4)
    return f"{factor * value:.{places}f} +- {deviation:.{places}f}"


def value_text(cause: Cause) -> str:
    """Return the value of a cause in its own unit."""
    factor, unit = {"m": (1e6, "um"), "s": (1e3, "ms"), "rad": (1e6, "um/m"), "": (1e6, "um/m")}[cause.unit]
    where = f" at pitch {figure(cause.pitch, 'mm', 4)}" if cause.pitch is not None else ""
    if cause.order is not None:
        where = f" at {number(cause.order, 4)} per turn" if cause.frequency is None else f" at {figure(cause.frequency, 'Hz')}"
    return f"{plus_minus(cause.value, cause.value_deviation, factor)} {unit}{where}"


def causes_of(fit: CircleFit) -> list[Cause]:
    """Return the causes of a fit, the one that adds most first."""
    causes = [_cause(fit, term) for term in fit.terms if term.cause not in _NOT_SHAPE]
    causes += [_spike(fit, axis) for axis in fit.axes if any(spike.axis == axis for spike in fit.spikes)]
    return sorted(causes, key=lambda cause: -cause.contribution)


def _cause(fit: CircleFit, term: Term) -> Cause:
    part = fit.place(term)
    values, block = fit.coefficients[part], fit.covariance[part, part]
    rows, curve = np.concatenate(fit.columns(term)), np.concatenate(fit.curves(term))
    spread = rows[int(np.argmax(curve))] - rows[int(np.argmin(curve))]
    contribution, deviation = float(np.ptp(curve)), _root(float(spread @ block @ spread))
    value, value_deviation, unit = float(values[0]), _root(block[0, 0]), "m"
    radius, feed = fit.runs[0].radius, fit.runs[0].feedrate
    periodic: dict[str, float | None] = {}
    if term.cause in ("squareness", "scaling mismatch"):
        value, value_deviation, unit = value / radius, value_deviation / radius, "rad" if term.cause == "squareness" else ""
    elif term.cause == "servo mismatch" and math.isfinite(feed):
        value, value_deviation, unit = value / feed, value_deviation / feed, "s"
    elif term.cause in ("cyclic error", "vibration"):
        value = float(np.linalg.norm(values)) / math.sqrt(term.columns / (2 if term.cause == "cyclic error" else 4))
        along = values / max(float(np.linalg.norm(values)), 1e-300)
        value_deviation = _root(float(along @ block @ along)) * value / max(float(np.linalg.norm(values)), 1e-300)
        hertz = term.order * feed / (2.0 * math.pi * radius) if math.isfinite(term.order * feed) else None
        periodic = {"pitch": term.length} if term.cause == "cyclic error" else {"order": term.order, "frequency": hertz}
    return Cause(term.cause, term.axis, contribution, deviation, value, value_deviation, unit, **periodic)


def _spike(fit: CircleFit, axis: str) -> Cause:
    """Return the mean spike of an axis. What the means cut off is common to its spikes, so more of them do not lessen the deviation."""
    heights = np.array([spike.height for spike in fit.spikes if spike.axis == axis])
    deviations = np.array([spike.deviation for spike in fit.spikes if spike.axis == axis])
    mean, scatter = float(heights.mean()), float(heights.std(ddof=1)) / math.sqrt(len(heights))
    deviation = max(float(deviations.mean()), scatter)
    return Cause("reversal spikes", axis, abs(mean), deviation, mean, deviation, "m")


def _root(variance: float) -> float:
    return math.sqrt(max(variance, 0.0))


def correlations_of(fit: CircleFit) -> list[Correlation]:
    """Return the pairs of causes whose estimates are correlated by more than `TIED`."""
    terms = [term for term in fit.terms if term.cause != "centre" and term.columns <= 2]
    correlation, pairs = correlation_of(fit.covariance), []
    for one, other in combinations(terms, 2):
        at = float(correlation[fit.place(one).start, fit.place(other).start])
        if abs(at) > TIED:
            pairs.append(Correlation((f"{one.cause} {one.axis}".strip(), f"{other.cause} {other.axis}".strip()), at))
    return sorted(pairs, key=lambda pair: -abs(pair.correlation))


def lags_of(fit: CircleFit) -> tuple[Lag, ...]:
    """Return the lag of each axis by least squares of command less position over the commanded velocity; empty without a command."""
    known = [run for run in fit.runs if run.lag is not None]
    lags = []
    for j, axis in enumerate(fit.axes if known else ()):
        velocities = [run.sense * run.feedrate * (np.cos(run.turned) if j else -np.sin(run.turned)) for run in known]
        # Backlash and friction reverse with the velocity: its sign takes their part.
        designs = [np.column_stack([velocity, np.ones(len(velocity)), np.sign(velocity)]) for velocity in velocities]
        values = [run.lag[:, j] for run in known if run.lag is not None]
        solution, covariance, _ = fit_records(designs, values)
        lags.append(Lag(axis, float(solution[0]), float(covariance.deviations[0])))
    return tuple(lags)


def _write_page(test: CircleTest, fit: CircleFit, file: str | Path) -> None:
    """Write the report as one HTML file that needs no network."""
    rows = [
        {"name": cause.name, "adds": plus_minus(cause.contribution, cause.deviation), "value": value_text(cause), "sure": cause.is_sure}
        for cause in test.causes
    ]
    picture = _picture(test, fit)
    values = {"title": f"Circle {test.name}", "test": test, "rows": rows, "picture": picture}
    write_text_atomic(Path(file), page_text("circle.html.j2", {"causes": [picture]}, **values))


def _picture(test: CircleTest, fit: CircleFit) -> CircleCauses:
    """Return the runs with the curve of each cause."""
    curves: dict[str, list[Array]] = {}
    for cause in test.causes:
        if cause.cause == "reversal spikes":
            curves[cause.name] = fit.spike_curves(cause.axis)
            continue
        # Terms of one name add up: two vibrations.
        alike = [fit.curves(term) for term in fit.terms if (term.cause, term.axis) == (cause.cause, cause.axis)]
        curves[cause.name] = [np.sum(parts, axis=0) for parts in zip(*alike, strict=True)]
    traces = []
    for k, run in enumerate(fit.runs):
        # The last whole turn, evenly thinned.
        last = np.flatnonzero(np.abs(run.turned - run.turned[-1]) <= 2.0 * np.pi)
        kept = last[:: max(len(last) // POINTS, 1)]
        parts = np.array([parts[k][kept] for parts in curves.values()]).reshape(len(curves), len(kept))
        way = "clockwise" if run.clockwise else "counter-clockwise"
        look = scheme_style(k, len(fit.runs))[0]
        traces.append(CircleTrace(way, look, np.degrees(run.angle[kept]), 1e6 * run.deviation[kept], 1e6 * parts))
    caption = "Pale: as measured. A slider scales the fitted curve of its cause: 100 % as measured, 0 % removed."
    if test.bidirectional is None:
        caption += " The verdict is on the minimum zone of a run, which is never larger than the deviation around the least-squares centre."
    return CircleCauses("causes", "Radial deviation", caption, tuple(fit.axes), tuple(curves), tuple(traces), test.radius)


# --- the question --------------------------------------------------------------------------------------------------------------------


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
    runs, axes, findings = _read(logs, settings)
    with about(*logs):
        fit = fit_circle(runs, axes, settings.si("pitch"))
        name = " and ".join(Path(log).name for log in logs)
        test = _result(fit, name, session.command, settings.si("tolerance"))
    return replace(test, findings=(*test.findings, *findings), inputs=tuple(logs))


def _read(logs: Sequence[str | Path | Log], settings: Circle) -> tuple[list[CircleRun], tuple[str, str], list[Finding]]:
    """Return the runs of all files, around one nominal radius; the axes; and findings on the files."""
    radius, feed = settings.si("radius"), settings.si("feed")
    runs, findings, pair, is_known = list[CircleRun](), list[Finding](), ("x", "y"), radius is not None
    for k, file in enumerate(logs):
        named, columns = own_columns(settings.column)
        record = read_record(file, settings.format)
        if named or is_polar(record, named):
            axes = settings.axes or ("x", "y")
            if settings.window:
                raise ParameterError("--window", settings.window[0], f"left out: {file} holds angles, and no times")
            with about(file, options=("radius",)):
                runs += polar_runs(record, named, radius, math.nan if feed is None else feed)
        else:
            log = open_log(file, replace(settings.of_log(k, len(logs)), column=columns))
            axes = settings.axes or log.result.axes[:2]
            with about(file):
                own, has_reference = _log_runs(log, axes, radius)
            runs += own
            findings += [*log.findings, *([] if "tool_position" in log.result else [finding("CL491")])]
            is_known = is_known or has_reference
        refuse(len(axes) != 2, ParameterError, "--axes", ",".join(axes), "two axes, such as x,y")
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
    refuse(len(columns_of(result, axes)) < 2, ResultError, f"has the axis {', '.join(axes)} only: a circle needs two")
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
