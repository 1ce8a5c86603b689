"""``contourlab commission log``: the position loop of each axis from a log of any control, in the control's own terms."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from contourlab.analysis.identification.least_squares import Bounds, fit_records
from contourlab.analysis.identification.left_over import left_over_findings
from contourlab.app.json_values import HIDDEN
from contourlab.app.session import QUIET, Answer, Session, question
from contourlab.errors import ParameterError
from contourlab.features.commission.log_loop import CLOCK, SURE, FittedLoop, fit_servo
from contourlab.features.commission.log_terms import LogTerm, terms_of_log
from contourlab.features.commission.options import OfLog
from contourlab.features.commission.records import EXPLAINED, LATEST, QUICK, SPAN
from contourlab.features.identify.command import axes_of
from contourlab.features.identify.options import Identify
from contourlab.features.identify.position_loop import WELL, check_follows, reverses
from contourlab.features.identify.records import AxisRecord, Request
from contourlab.figures import FACTORS, NONE, number
from contourlab.findings import Finding, finding
from contourlab.logs.load import Log, about
from contourlab.rendering.table import Column, Table, paragraphs

FIGURES = {
    "Kv": ("Kv of the loop", "1/s"),
    "shown": ("velocity over following error", "1/s"),
    "velocity_feedforward": ("velocity feedforward in force", "%"),
    "equivalent_time": ("equivalent time constant inside", "ms"),
    "delay": ("delay before the loop", "ms"),
    "friction_offset": ("friction holds it back by", "um"),
    "drive_gain": ("drive: speed per command", "mm/s"),
    "mass": ("moved mass", "kg"),
    "inertia": ("drive: command per acceleration", ""),
    "coulomb": ("drive: friction", ""),
}
"""Figures of an axis: what they are called, and their unit in the table."""
DETERMINED = {"Kv": 0.3, "velocity_feedforward": 0.3, "equivalent_time": 1.0, "delay": 0.01}
"""Largest half interval of a figure that counts as determined, relative to it; of feedforward and delay [s], in absolute terms."""
BALANCE = "sinumerik"
"""The control that may delay the set position that its position controller sees."""
LAW = 0.02
"""Share of the drive command that the law of a position loop may leave."""


@dataclass(frozen=True, eq=False)
class LoggedAxis:
    """The loop of an axis.

    Attributes
    ----------
    figures : dict of str to Bounds
        In SI, with intervals of 95 %; those that the log does not determine are missing.
    stays : float
        Share of the following error that the model does not explain.
    terms : tuple of LogTerm
    """

    figures: dict[str, Bounds]
    stays: float
    terms: tuple[LogTerm, ...]


@dataclass(frozen=True, eq=False)
class LogCommissioned(Answer):
    """The loops of a log.

    Attributes
    ----------
    control : str
    axes : dict of str to LoggedAxis
    findings : tuple of Finding
    """

    control: str
    axes: dict[str, LoggedAxis]
    findings: tuple[Finding, ...]
    tables: tuple[Table, ...] = field(default=(), metadata=HIDDEN, repr=False)

    @property
    def passed(self) -> bool:
        """Whether the log determines a gain."""
        return any("Kv" in axis.figures for axis in self.axes.values())

    @property
    def text(self) -> str:
        """Tables and findings."""
        return "\n\n".join([*(table.text() for table in self.tables if table.rows), paragraphs(map(str, self.findings))])


@question(OfLog, name="commission log")
def log(log: str | Path | Log, *, settings: OfLog, session: Session = QUIET) -> LogCommissioned:
    """Find gain, delays and feedforward of each position loop from a log of commanded and actual position, of any control.

    Parameters
    ----------
    log : str, Path or Log
        With the drive command too, if there is one.

    Returns
    -------
    LogCommissioned

    Raises
    ------
    LogError, ResultError
        If the log cannot be read, lacks a signal, or no axis follows its reference.
    ParameterError
        If an option is out of range.
    """
    given = {name: getattr(settings, name) for name in Identify.PARTS if name in OfLog.PARTS}
    options = Identify(model="position-loop", **given)
    with about(log, options=list(OfLog.PARTS)):
        opened = Request(options, (log,)).log(0)
        axes, findings = dict[str, LoggedAxis](), dict[str, Finding]()
        for name in axes_of(opened, settings.axis):
            request = Request(replace(options, axis=name), (opened,))
            (record,) = request.records(pieces=False)
            check_follows(record)
            axes[name], more = _axis(record, settings.for_)
            findings |= {str(doubt): doubt for doubt in (*more, *request.findings())}
    nothing = finding("CL940", control=settings.for_)
    return LogCommissioned(settings.for_, axes, (nothing, *findings.values()), _tables(axes, settings.for_))


def _axis(record: AxisRecord, control: str) -> tuple[LoggedAxis, list[Finding]]:
    """Return the loop of an axis, and findings."""
    place, figures, findings = f"axis {record.axis}", dict[str, Bounds](), list[Finding]()
    known = None
    if record.command is not None:
        known, figures, findings = _drive(record, place)
    stays = math.nan
    try:
        loop = fit_servo(record, control == BALANCE, known)
        stays = loop.stays
        figures = _determined(loop) | figures
        if any(doubt.code == "CL944" for doubt in findings):
            figures = {name: figure for name, figure in figures.items() if name in ("shown", "drive_gain")}
        weight = figures.get("velocity_feedforward")
        if weight is not None and weight.low <= 1.0 <= weight.high and figures["Kv"] is loop.figures["Kv"]:
            findings.append(finding("CL947", place))
        findings += [finding("CL594", place, stays=stays)] if stays > WELL else []
        rest, asked, explained = (
            np.diff(values) / record.period for values in (record.position - loop.position, record.asked(), loop.position)
        )
        findings += left_over_findings(place, rest, asked, explained, record.period)
        if unknown := [FIGURES[name][0] for name in DETERMINED if name not in figures]:
            findings.append(finding("CL941", place, parameters=unknown))
    except ParameterError as error:
        findings.append(finding("CL942", place, reason=str(error)))
    findings += [] if reverses(record) else [finding("CL593", place)]
    return LoggedAxis(figures, stays, terms_of_log(control, figures)), findings


def _determined(loop: FittedLoop) -> dict[str, Bounds]:
    """Return the figures that a log determines: without the gain, neither what the feedforward nor what the delay is."""
    x = loop.figures
    shown, friction = x["following_time"], x.get("friction_offset")
    figures = {"shown": Bounds(1.0 / shown.value, 1.0 / shown.high, 1.0 / shown.low)} if shown.half < 0.3 * shown.value else {}
    figures |= {"friction_offset": friction} if friction is not None and friction.low > 0.0 else {}
    if not x["Kv"].half < DETERMINED["Kv"] * x["Kv"].value:
        return figures
    scale = {"Kv": x["Kv"].value, "velocity_feedforward": 1.0, "equivalent_time": x["equivalent_time"].value, "delay": 1.0}
    return figures | {name: x[name] for name, most in DETERMINED.items() if x[name].half < most * scale[name]}


# --- the drive command --------------------------------------------------------------------------------------------------------------


def _drive(record: AxisRecord, place: str) -> tuple[tuple[float, float] | None, dict[str, Bounds], list[Finding]]:
    """Return the gain that the drive command shows, with its deviation; figures of the drive; and findings.

    Notes
    -----
    The command is explained by the motion, u = (v' + v/T + f sign v) T/k + o, all averaged over a triangle of twice `SPAN`, the motion up
    to `LATEST` later.
    """
    s, period = max(round(SPAN / record.period), 2), record.period
    triangle = np.convolve(np.ones(s), np.ones(s)) / s**2
    command = np.convolve(record.driven(), triangle, "valid")
    place_of, fits = np.convolve(record.position, triangle, "valid"), []
    speed = np.gradient(place_of, period)
    way = np.where(np.abs(speed) > 0.01 * np.abs(speed).max(), np.sign(speed), 0.0)
    rows = np.column_stack([np.gradient(speed, period), speed, way, np.ones(speed.size)])
    for late in range(max(round(LATEST / period), 1)):
        target = command[: command.size - late]
        solution, covariance, (rest,) = fit_records([rows[late:]], [target])
        fits.append((1.0 - float(np.var(rest)) / max(float(np.var(target)), 1e-300), solution, covariance.deviations))
    explained, (inertia, damping, rub, _), spread = max(fits, key=lambda fit: fit[0])
    if not explained > EXPLAINED or not max(inertia, damping) > 0.0:
        return None, {}, [finding("CL943", place, explained=explained)]
    if not damping > QUICK * inertia:
        figures = {"mass" if record.unit == "N" else "inertia": _within(inertia, spread[0])}
        return None, figures | {"coulomb": _within(rub, spread[2])}, [finding("CL945", place)]
    figures = {"drive_gain": _within(1.0 / damping, spread[1] / damping**2)}
    gain, deviation, left = _law(record)
    if left > LAW or not gain > 0.0:
        return None, figures, [finding("CL944", place, left=left)]
    known = gain / damping, gain / damping * math.hypot(deviation / gain, spread[1] / damping, CLOCK)
    return known, figures | {"Kv": _within(*known)}, [finding("CL946", place, left=left)]


def _within(value: float, deviation: float) -> Bounds:
    return Bounds(value, value - SURE * deviation, value + SURE * deviation)


def _law(record: AxisRecord) -> tuple[float, float, float]:
    """Return command per following error, its deviation, and the share of the command that the law leaves.

    The law has the derivatives of the reference up to its acceleration: a reference that the position controller sees late has them all.
    What the next derivative would change counts as a deviation.
    """
    asked, command = record.asked(), record.driven()
    columns = [np.ones(asked.size), asked - record.position, asked]
    for _ in range(3):
        columns.append(np.gradient(columns[-1], record.period))
    del columns[2]
    fits = [fit_records([np.column_stack(columns[:n])], [command]) for n in (4, 5)]
    (solution, covariance, (rest,)), (other, *_) = fits
    return (
        float(solution[1]),
        math.hypot(float(covariance.deviations[1]), float(other[1] - solution[1])),
        float(np.std(rest)) / max(float(np.std(command)), 1e-300),
    )


# --- what is printed ----------------------------------------------------------------------------------------------------------------


def _tables(axes: Mapping[str, LoggedAxis], control: str) -> tuple[Table, ...]:
    axis, interval, unit = Column("axis", left=True), Column("95 %", left=True), Column("unit", left=True)
    seen, terms = list[Sequence[str]](), list[Sequence[str]]()
    for name, one in axes.items():
        for key, (words, shown) in FIGURES.items():
            if key in one.figures:
                x, factor = one.figures[key], FACTORS[shown]
                seen.append((name, words, *_cells(Bounds(factor * x.value, factor * x.low, factor * x.high)), shown))
        terms += [(name, term.name, *_cells(term.value), number(term.proposed), term.unit) for term in one.terms]
    return (
        Table([axis, Column("", left=True), Column("value"), interval, unit], "What the log shows", rows=seen),
        Table(
            [axis, Column(control, left=True), Column("value"), interval, Column("proposed"), unit], f"In terms of {control}", rows=terms
        ),
    )


def _cells(x: Bounds) -> Sequence[str]:
    """Return a value and its interval."""
    return (number(x.value), f"{number(x.low)} .. {number(x.high)}") if math.isfinite(x.value) else (NONE, NONE)
