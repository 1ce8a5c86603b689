"""``contourlab commission log``: the position loop of each axis from a log of any control, in the control's own terms."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.analysis.identification.least_squares import fit_records
from contourlab.app.json_values import HIDDEN
from contourlab.app.session import QUIET, Answer, Session, question
from contourlab.errors import ParameterError
from contourlab.features.commission.log_loop import SURE, Bounds, FittedLoop, fit_servo
from contourlab.features.commission.log_terms import LogTerm, terms_of_log
from contourlab.features.commission.options import OfLog
from contourlab.features.commission.records import EXPLAINED, LATEST, QUICK, SPAN
from contourlab.features.identify.command import axes_of
from contourlab.features.identify.options import Identify
from contourlab.features.identify.position_loop import WELL, check_follows, reverses
from contourlab.features.identify.records import AxisRecord, Request
from contourlab.figures import NONE, figure, number
from contourlab.findings import Finding, finding
from contourlab.logs.load import Log, about
from contourlab.rendering.table import Column, Table, paragraphs

FIGURES = {
    "Kv": ("Kv of the loop", "1/s"),
    "shown": ("velocity over following error", "1/s"),
    "velocity_feedforward": ("velocity feedforward in force", "%"),
    "equivalent_time": ("equivalent time constant of the loop inside", "ms"),
    "delay": ("delay before the loop", "ms"),
    "friction_offset": ("friction holds it back by", "um"),
    "drive_gain": ("drive: speed per command", "mm/s"),
    "mass": ("moved mass", "kg"),
    "inertia": ("drive: command per acceleration", ""),
    "coulomb": ("drive: friction", ""),
}
"""Figures of an axis: what they are called, and their unit in the table."""
DETERMINED = {"Kv": 0.3, "velocity_feedforward": 0.3, "equivalent_time": 1.0}
"""Largest half interval of a figure that counts as determined, relative to it; of the feedforward, in absolute terms."""
LAW = 0.02
"""Share of the drive command that the law of a position loop may leave."""


@dataclass(frozen=True, eq=False)
class LoggedAxis:
    """The loop of an axis.

    Attributes
    ----------
    figures : dict of str to Bounds
        In SI, with intervals of 95 %; those that the log does not determine are missing.
    left : dict of str to float [m]
        Parts of the following error at the largest velocity and acceleration of the log: what velocity and acceleration feedforward would
        take away, what the delay leaves, and friction.
    stays : float
        Share of the following error that the model does not explain.
    terms : tuple of LogTerm
    """

    figures: dict[str, Bounds]
    left: dict[str, float]
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
        loop = fit_servo(record, known)
        stays, shown = loop.stays, loop.figures["following_time"]
        fitted = _determined(loop)
        if shown.low > 0.0:
            fitted["shown"] = Bounds(1.0 / shown.value, 1.0 / shown.high, 1.0 / shown.low)
        figures = fitted | figures
        findings += [finding("CL594", place, stays=stays)] if stays > WELL else []
        if unknown := [FIGURES[name][0] for name in DETERMINED if name not in figures]:
            findings.append(finding("CL941", place, parameters=unknown))
    except ParameterError as error:
        findings.append(finding("CL942", place, reason=str(error)))
    findings += [] if reverses(record) else [finding("CL593", place)]
    return LoggedAxis(figures, _left(record, figures), stays, terms_of_log(control, figures)), findings


def _determined(loop: FittedLoop) -> dict[str, Bounds]:
    """Return the figures that a log determines: without the gain, neither what the feedforward nor what the delay is."""
    figures = {name: figure for name, figure in loop.figures.items() if name != "following_time"}
    for name, most in DETERMINED.items():
        scale = 1.0 if name == "velocity_feedforward" else abs(figures[name].value)
        if not figures[name].half < most * scale:
            lost = ("Kv", "velocity_feedforward", "delay", "equivalent_time") if name == "Kv" else (name,)
            figures = {other: figure for other, figure in figures.items() if other not in lost}
            if name == "Kv":
                break
    return figures


def _left(record: AxisRecord, x: Mapping[str, Bounds]) -> dict[str, float]:
    """Return parts of the following error at the largest velocity and acceleration [m]."""
    speed = np.gradient(record.asked(), record.period)
    fastest, strongest = float(np.abs(speed).max()), float(np.quantile(np.abs(np.gradient(speed, record.period)), 0.999))
    value = {name: figure.value for name, figure in x.items()}
    gain, nan = value.get("Kv", math.nan), math.nan
    return {
        "velocity": (1.0 - value.get("velocity_feedforward", nan)) / gain * fastest,
        "acceleration": value.get("equivalent_time", nan) / gain * strongest,
        "delay": value.get("delay", nan) * fastest,
        "friction": value.get("friction_offset", nan),
    }


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
    rows = np.column_stack([np.gradient(speed, period), speed, np.sign(speed) * (np.abs(speed) > 0.01 * np.abs(speed).max()), np.ones(speed.size)])
    for late in range(max(round(LATEST / period), 1)):
        target = command[: command.size - late]
        solution, covariance, (rest,) = fit_records([rows[late:]], [target])
        fits.append((1.0 - float(np.var(rest) / max(np.var(target), 1e-300)), solution, covariance.deviations))
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
    known = gain / damping, gain / damping * math.hypot(deviation / gain, spread[1] / damping)
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
        float(np.std(rest) / max(np.std(command), 1e-300)),
    )


# --- what is printed ----------------------------------------------------------------------------------------------------------------


def _tables(axes: Mapping[str, LoggedAxis], control: str) -> tuple[Table, ...]:
    heads = [Column("axis", left=True), Column("", left=True), Column("value"), Column("95 %", left=True), Column("unit", left=True)]
    seen = Table(heads, "What the log shows")
    terms = Table([*heads[:1], Column(control, left=True), *heads[2:4], Column("proposed"), heads[4]], f"In terms of {control}")
    left = Table([Column("axis", left=True), *map(Column, ("velocity", "acceleration", "delay", "friction"))], _LEFT)
    for name, axis in axes.items():
        for key, (words, unit) in FIGURES.items():
            if key in axis.figures:
                scaled = [float(figure(value, unit).split()[0]) for value in vars(axis.figures[key]).values()]
                seen.rows.append((name, words, *_cells(Bounds(*scaled)), unit))
        for term in axis.terms:
            terms.rows.append((name, term.name, *_cells(term.value), number(term.proposed), term.unit))
        if not math.isnan(axis.left["velocity"]):
            left.rows.append((name, *(figure(part, "um") for part in axis.left.values())))
    return seen, terms, left


_LEFT = "Following error at the largest velocity and acceleration of the log: velocity and acceleration feedforward take away their part"


def _cells(x: Bounds) -> Sequence[str]:
    """Return a value and its interval."""
    return (number(x.value), f"{number(x.low)} .. {number(x.high)}") if math.isfinite(x.value) else (NONE, NONE)
