"""``contourlab commission log``: the position loop of each axis from a log of any control, in the control's own terms."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from contourlab.analysis.identification.least_squares import Bounds, fit_records
from contourlab.analysis.identification.left_over import left_over_findings
from contourlab.app.json_values import HIDDEN
from contourlab.app.session import QUIET, Answer, Session, question
from contourlab.arrays import Array
from contourlab.errors import ParameterError
from contourlab.features.commission.log_loop import CLOCK, SURE, TICK, Known, fit_servo
from contourlab.features.commission.options import OfLog
from contourlab.features.commission.records import EXPLAINED, QUICK, SPAN, explained_by_motion
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
    "reset": ("integral over gain of the loop", "1/s"),
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
TIME = "equivalent_time"
UNKNOWN = Bounds(math.nan, -math.inf, math.inf)
TERMS: dict[str, tuple[tuple[str, str, str, float, float, str], ...]] = {
    "generic": (
        ("Kv", "1/s", "Kv", 1.0, math.nan, ""),
        ("velocity feedforward", "%", "velocity_feedforward", 100.0, 100.0, ""),
        ("acceleration feedforward", "ms", "", 1.0, 1e3, TIME),
        ("velocity loop: time constant", "ms", TIME, 1e3, math.nan, ""),
    ),
    "sinumerik": (
        ("MD32200 POSCTRL_GAIN", "1000/min", "Kv", 0.06, math.nan, ""),
        ("MD32610 VELO_FFW_WEIGHT", "", "velocity_feedforward", 1.0, 1.0, ""),
        ("MD32620 FFW_MODE", "", "", 1.0, 3.0, ""),
        ("MD32810 EQUIV_SPEEDCTRL_TIME", "s", TIME, 1.0, 1.0, TIME),
    ),
    "twincat": (
        ("Proportional Factor Kv", "1/s", "Kv", 1.0, math.nan, ""),
        ("Pre-Control Weighting", "", "velocity_feedforward", 1.0, 1.0, ""),
        ("Proportional Factor Ka", "s", "", 1.0, 1.0, TIME),
    ),
    "cia402": (
        ("position loop: gain", "1/s", "Kv", 1.0, math.nan, ""),
        ("0x60B1 velocity offset", "of set velocity", "velocity_feedforward", 1.0, 1.0, ""),
    ),
}
"""Name, unit, figure that it is and its factor; and what is proposed: a number, or a number times a figure."""
LAW = 0.1
"""Share that the law of a position loop may leave of what the drive command has beside set velocity and acceleration."""


@dataclass(frozen=True)
class LogTerm:
    """A parameter of a control.

    Attributes
    ----------
    name, unit : str
    value : Bounds
        As the log shows it; nan where it does not.
    proposed : float
        nan: it stays, or the log does not give it.
    """

    name: str
    unit: str
    value: Bounds
    proposed: float


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
            axes[name], more = _axis(record, settings)
            findings |= {str(doubt): doubt for doubt in (*more, *request.findings())}
    control = settings.for_
    return LogCommissioned(control, axes, (finding("CL940", control=control), *findings.values()), _tables(axes, control))


def _axis(record: AxisRecord, settings: OfLog) -> tuple[LoggedAxis, list[Finding]]:
    """Return the loop of an axis, and findings."""
    place, stays = f"axis {record.axis}", math.nan
    known, figures, findings = (None, {}, []) if record.command is None else _drive(record, place)
    try:
        loop = fit_servo(record, (sinumerik := settings.for_ == "sinumerik"), sinumerik or settings.proportional, known)
        stays = loop.stays
        figures = _determined(loop.figures) | figures
        if any(doubt.code == "CL944" for doubt in findings):
            figures = {name: figure for name, figure in figures.items() if name in ("shown", "drive_gain")}
        elif (gain := _determined(loop.proportional).get("Kv")) and "Kv" not in figures:
            findings.append(finding("CL947", place, low=gain.low, high=gain.high))
        findings += [finding("CL594", place, stays=stays)] if stays > WELL else []
        rest, asked, explained = (
            np.diff(values) / record.period for values in (record.position - loop.position, record.asked(), loop.position)
        )
        findings += left_over_findings(place, rest, asked, explained, record.period)
        if unknown := [FIGURES[name][0] for name in DETERMINED if name not in figures]:
            findings.append(finding("CL941", place, parameters=unknown))
    except ParameterError as error:
        findings.append(finding("CL942", place, reason=error.bound))
    findings += [] if reverses(record) else [finding("CL593", place)]
    return LoggedAxis(figures, stays, terms_of_log(settings.for_, figures)), findings


def _determined(x: Mapping[str, Bounds]) -> dict[str, Bounds]:
    """Return the figures that a log determines: without the gain, neither what the feedforward nor what the delay is."""
    if not x:
        return {}
    shown, friction, integral = x["following_time"], x.get("friction_offset"), x["reset"].low > 0.0
    figures = {}
    if not integral and shown.half < 0.3 * shown.value:
        figures["shown"] = Bounds(1.0 / shown.value, 1.0 / shown.high, 1.0 / shown.low)
    figures |= {"friction_offset": friction} if friction is not None and friction.low > 0.0 else {}
    if not x["Kv"].half < DETERMINED["Kv"] * x["Kv"].value:
        return figures
    figures |= {"reset": x["reset"]} if integral else {}
    scale = {"Kv": x["Kv"].value, "velocity_feedforward": 1.0, "equivalent_time": x["equivalent_time"].value, "delay": 1.0}
    return figures | {name: x[name] for name, most in DETERMINED.items() if x[name].half < most * scale[name]}


def terms_of_log(control: str, x: Mapping[str, Bounds]) -> tuple[LogTerm, ...]:
    """Return the parameters of a control for the figures of an axis; without a time constant nothing is proposed."""
    terms = []
    for name, unit, key, factor, wanted, of in TERMS[control]:
        shown, known = x.get(key, UNKNOWN), x.get(of or TIME, UNKNOWN).value
        value = Bounds(factor * shown.value, factor * shown.low, factor * shown.high)
        terms.append(LogTerm(name, unit, value, wanted * known if of else wanted + 0.0 * known))
    return tuple(terms)


# --- the drive command --------------------------------------------------------------------------------------------------------------


def _drive(record: AxisRecord, place: str) -> tuple[Known | None, dict[str, Bounds], list[Finding]]:
    """Return what the drive command shows of the position controller; figures of the drive; and findings."""
    explained, (inertia, damping, rub, _), spread = explained_by_motion([(record.driven(), record.position)], record.period)
    if not explained > EXPLAINED or not max(inertia, damping) > 0.0:
        return None, {}, [finding("CL943", place, explained=explained)]
    if not damping > QUICK * inertia:
        figures = {"mass" if record.unit == "N" else "inertia": _within(inertia, spread[0])}
        return None, figures | {"coulomb": _within(rub, spread[2])}, [finding("CL945", place)]
    figures = {"drive_gain": _within(1.0 / damping, math.hypot(spread[1] / damping, CLOCK) / damping)}
    law, more = (_law(record, integral=integral) for integral in (False, True))
    law = more if more.left <= LAW and more.reset > SURE * more.unsure else law
    if law.left > LAW or not law.gain > 0.0:
        return None, figures, [finding("CL944", place, left=law.left)]
    known = Known(law.gain / damping, law.gain / damping * math.hypot(law.deviation / law.gain, spread[1] / damping, CLOCK), law.reset)
    if not SURE * known.deviation < DETERMINED["Kv"] * known.gain:
        return None, figures, []
    figures |= {"Kv": _within(known.gain, known.deviation)} | ({"reset": _within(law.reset, law.unsure)} if law.reset else {})
    return known, figures, [finding("CL946", place, left=law.left)]


def _within(value: float, deviation: float) -> Bounds:
    return Bounds(value, value - SURE * deviation, value + SURE * deviation)


class _Law(NamedTuple):
    """Command per following error, integral gain over gain [1/s], and their deviations.

    `left` is the share of the command that the law leaves, of what it leaves without the following error.
    """

    gain: float
    deviation: float
    reset: float
    unsure: float
    left: float


def _law(record: AxisRecord, *, integral: bool) -> _Law:
    """Return the law of the position controller.

    The law has the derivatives of the reference up to its acceleration: a reference that the position controller sees late has them all.
    All is averaged over a triangle of twice `SPAN`, which leaves the law as it is. What the next derivative would change counts as a
    deviation, and so does what is left: as much of that may look like the following error.
    """
    asked, command, ahead = record.asked(), record.driven(), list[Array]()
    error = asked - record.position
    for _ in range(3):
        ahead.append(np.gradient(ahead[-1] if ahead else asked, record.period))
    columns = [error, *([(np.cumsum(error) - 0.5 * error) * record.period, asked] if integral else []), np.ones(asked.size), *ahead]
    mean = np.ones(max(round(SPAN / record.period), 1))
    mean = np.convolve(mean, mean) / mean.size**2
    rows, target = np.column_stack([np.convolve(column, mean, "valid") for column in columns]), np.convolve(command, mean, "valid")
    parts = rows[:, :-1], rows, rows[:, (2 if integral else 1) : -1]
    (x, covariance, (rest,)), (other, *_), (*_, (without,)) = (fit_records([part], [target]) for part in parts)
    left = float(np.std(rest)) / max(float(np.std(without)), 1e-300)
    reset = float(x[1] / x[0]) if integral else 0.0
    unsure = np.hypot(np.hypot(covariance.deviations, other[:-1] - x) / np.abs(x), left)
    unsure[0] = math.hypot(unsure[0], TICK * record.period * reset)  # when the control adds up its errors is unknown
    return _Law(float(x[0]), float(unsure[0] * abs(x[0])), reset, abs(reset) * math.hypot(*unsure[:2]), left)


# --- what is printed ----------------------------------------------------------------------------------------------------------------


def _tables(axes: Mapping[str, LoggedAxis], control: str) -> tuple[Table, ...]:
    axis, interval, unit = Column("axis", left=True), Column("95 %", left=True), Column("unit", left=True)
    seen, terms = list[Sequence[str]](), list[Sequence[str]]()
    for name, one in axes.items():
        for key, (words, shown) in FIGURES.items():
            if key in one.figures:
                x, factor = one.figures[key], FACTORS[shown]
                seen.append((name, words, *_cells(Bounds(factor * x.value, factor * x.low, factor * x.high)), shown))
        known = (term for term in one.terms if math.isfinite(term.value.value) or math.isfinite(term.proposed))
        terms += [(name, term.name, *_cells(term.value), number(term.proposed), term.unit) for term in known]
    return (
        Table([axis, Column("", left=True), Column("value"), interval, unit], "What the log shows", rows=seen),
        Table(
            [axis, Column(control, left=True), Column("value"), interval, Column("proposed"), unit], f"In terms of {control}", rows=terms
        ),
    )


def _cells(x: Bounds) -> Sequence[str]:
    """Return a value and its interval."""
    return (number(x.value), f"{number(x.low)} .. {number(x.high)}") if math.isfinite(x.value) else (NONE, NONE)
