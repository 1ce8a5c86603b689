"""One axis of logs, read as the options of an identification say: its signals and their units, and whether they are plausible."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ParameterError, ResultError, UnitError, refuse, refused
from contourlab.features.identify.options import Identify
from contourlab.features.measure.log_choice import distinct_names, open_log
from contourlab.features.measure.plausibility import motion_findings, period_findings, same_column_findings
from contourlab.findings import Finding, finding
from contourlab.logs import Log
from contourlab.logs.reading import join_names
from contourlab.units import split, to_si

POSITIONS = {"position": ("position", "motor_position", "axis_position"), "acceleration": ("acceleration",)}
"""Signals that count as the position of a record, or as what it has in place of it."""
LARGEST = {"N": 1e5, "V": 1e3, "A": 1e3, "full_scale": 1.01}
"""Largest plausible command of a feed drive, by unit."""
TRAVEL = '--lead, the travel per turn, as "10 mm"'
"""Option for two inertias, and to convert torques to newtons."""


@dataclass(frozen=True, eq=False)
class AxisRecord:
    """The signals of one axis of a log.

    Attributes
    ----------
    period : float [s]
    position : ndarray (n,) [m]
        Or the acceleration [m/s^2], for a model that takes that.
    command : ndarray (n,) or None
        Force [N] if logged or if a gain was given; else the command in its own unit.
    unit : str
        Unit of the command.
    reference : ndarray (n,) or None [m]
    estimate : ndarray (n,) or None
        Disturbance that an observer subtracted from the command.
    gain : float [N per unit of the logged command]
        Given, or from the lead for a torque; else 1.
    logged : str
        Unit of the logged command; ``"N*m"`` for a torque.
    start : float [s]
        Time of the first sample since the start of the log.
    """

    source: str
    axis: str
    period: float
    position: Array
    command: Array | None
    unit: str
    reference: Array | None
    estimate: Array | None
    gain: float = 1.0
    logged: str = ""
    start: float = 0.0
    findings: tuple[Finding, ...] = ()

    @property
    def time(self) -> Array:
        """Times of the samples [s], from 0."""
        return np.asarray(self.period * np.arange(self.position.size))

    def driven(self) -> Array:
        """Return the command.

        Raises
        ------
        ResultError
            If the log has none.
        """
        if self.command is None:
            wanted = f"give --column 'command.{self.axis}=NAME [V]', or use force [N] or torque [N*m] instead of command"
            raise ResultError(f"no force, torque or command of {self.axis} in {self.source}: {wanted}")
        return self.command

    def largest(self) -> float:
        """Return the largest magnitude of the command or force; raises as `driven`."""
        return float(np.abs(self.driven()).max())

    def asked(self) -> Array:
        """Return the reference.

        Raises
        ------
        ResultError
            If the log has none.
        """
        if self.reference is None:
            raise ResultError(f"no reference of {self.axis} in {self.source}: give --column 'reference.{self.axis}=NAME [mm]'")
        return self.reference

    def part(self, start: int, stop: int) -> AxisRecord:
        """Return the record of the samples [start, stop)."""
        named = ((name, getattr(self, name)) for name in ("command", "reference", "estimate"))
        signals: dict[str, Any] = {name: None if values is None else values[start:stop] for name, values in named}
        return replace(self, position=self.position[start:stop], start=self.start + start * self.period, **signals)

    def doubts(self) -> list[Finding]:
        """Return findings on the record and on implausible signals."""
        place, position = f"{self.axis} in {self.source}", self.position[:, None]
        doubts = [*self.findings, *period_findings(self.period, self.source), *motion_findings(position, self.period, place)]
        if self.reference is not None:
            doubts += same_column_findings((self.axis,), self.reference[:, None], position, self.source)
        if self.command is not None:
            reached, unit = self.largest(), self.unit
            if unit == "N" and self.logged not in ("", "N") and reached / abs(self.gain) > LARGEST.get(self.logged, np.inf):
                reached, unit = reached / abs(self.gain), self.logged
            doubts += [finding("CL502", place, largest=reached, unit=unit)] if reached > LARGEST.get(unit, np.inf) else []
        return doubts


def newton_option(unit: str) -> str:
    """Return the option that converts commands in a unit to newtons, with an example.

    >>> newton_option("V")
    '--gain, as "35.15 N/V"'
    """
    return TRAVEL if unit == "N*m" else f'--gain, as "35.15 {newtons_per(unit)}"'


def newtons_per(unit: str) -> str:
    """Return the unit of a gain that converts commands in a unit to newtons.

    >>> newtons_per("V"), newtons_per("N*m"), newtons_per("")
    ('N/V', 'N/(N*m)', 'N')
    """
    return f"N/({unit})" if "*" in unit else f"N/{unit}".removesuffix("/")


def command_label(unit: str, name: str = "command") -> str:
    """Return the label of a command in a picture.

    >>> command_label("V"), command_label("")
    ('command [V]', 'command')
    """
    return f"{name} [{unit}]" if unit else name


def unit_findings(unit: str) -> list[Finding]:
    """Return a finding if friction in the unit of the command fits no plant; newtons and shares of full scale fit."""
    return [] if unit in ("", "N", "full_scale") else [finding("CL505", unit=unit, option=newton_option(unit))]


def common_unit(records: Sequence[AxisRecord], what: str) -> str:
    """Return the unit of the commands of all records.

    Parameters
    ----------
    what : str
        What the logs describe, for the message.

    Raises
    ------
    ResultError
        If the units differ.
    """
    units = sorted({record.unit for record in records})
    refuse(len(units) > 1, ResultError, f"commands in {' and '.join(units)}: all logs of {what} must have the same unit")
    return units[0]


def log_names(records: Sequence[AxisRecord]) -> tuple[str, ...]:
    """Return the names of the logs of records, each once."""
    return tuple(dict.fromkeys(record.source for record in records))


def reference_name(records: Sequence[AxisRecord]) -> str:
    """Return the reference for parameters from several logs: the first log, and the number of others."""
    names = log_names(records)
    return names[0] if len(names) == 1 else f"{names[0]} and {len(names) - 1} more"


def longest_piece(log: Log, pieces: Sequence[AxisRecord]) -> AxisRecord:
    """Return the longest stretch of a log, with a finding if it is not the whole log."""
    longest = max(pieces, key=lambda piece: piece.position.size)
    if len(pieces) == 1 and longest.position.size == log.result.n_sample:
        return longest
    end = longest.start + longest.position.size * longest.period
    return replace(longest, findings=(finding("CL501", longest.source, start=longest.start, end=end),))


def samples_digest(pieces: Sequence[AxisRecord]) -> str:
    """Return a digest of position and command; logs with equal digests are the same record."""
    signals = (signal for piece in pieces for signal in (piece.position, np.zeros(0) if piece.command is None else piece.command))
    return sha256(b"".join(b"%d %b" % (signal.size, signal.tobytes()) for signal in signals)).hexdigest()


# --- the logs of a request ----------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Request:
    """Logs to read: one or several with the same options, and one for validation."""

    options: Identify
    logs: Sequence[str | Path | Log]
    _on_logs: dict[str, tuple[Finding, list[str]]] = field(default_factory=dict)
    _doubts: list[Finding] = field(default_factory=list)

    @property
    def files(self) -> list[str | Path | Log]:
        """The logs, that for validation last."""
        return [*self.logs, *([] if self.options.validation is None else [self.options.validation])]

    @cached_property
    def names(self) -> dict[Path, str]:
        """The names of the logs by file."""
        return dict(zip(map(Path, self.files), distinct_names(self.files), strict=True))

    def records(self, pieces: bool) -> list[AxisRecord]:
        """Return the signals of the axis in all logs: the longest stretch of each, or with `pieces` all stretches between long gaps."""
        options = self.options
        if options.gain is not None and options.full_scale is not None:
            raise ParameterError("--full-scale", f"{options.full_scale} with --gain", "one of the two: newtons, or shares of full scale")
        seen: dict[tuple[Path, tuple[str, ...]], str | Path | Log] = {}
        for number, file in enumerate(self.logs):
            place = Path(file).resolve(), self._options_of(number).window
            if place in seen:
                same = "" if Path(seen[place]) == Path(file) else f", the same file as {seen[place]}"
                raise ParameterError("LOG", f"{file}{same}", "given once: its samples would count twice")
            seen[place] = file
        logs = [self.read(number, pieces) for number in range(len(self.logs))]
        by_samples: dict[str, str] = {}
        for records in logs:
            other = by_samples.setdefault(samples_digest(records), records[0].source)
            if other != records[0].source:
                self._doubts.append(finding("CL500", records[0].source, other=other))
        return [record for records in logs for record in records]

    def findings(self) -> list[Finding]:
        """Return the findings on the logs, and on reading them; one that holds for some logs only names them."""
        named = ((doubt, "" if len(names) == len(self.files) else join_names(names)) for doubt, names in self._on_logs.values())
        return [*self._doubts, *(replace(doubt, place=": ".join(filter(None, (at, doubt.place)))) for doubt, at in named)]

    def _options_of(self, number: int) -> Identify:
        """Return the options of one of the files: its window; that for validation may have its own, too."""
        count = len(self.files) if len(self.options.window) == len(self.files) else len(self.logs)
        return self.options.of_log(min(number, count - 1), count)

    def log(self, number: int) -> Log:
        """Return one of the files, read."""
        return open_log(self.files[number], self._options_of(number % len(self.files)))

    def read(self, number: int = -1, pieces: bool = False) -> list[AxisRecord]:
        """Return the signals of the axis in one of the files, by default in that for validation."""
        name, log = self.names[Path(self.files[number])], self.log(number)
        self._check_unit(log)
        records = self._pieces(log, name)
        self._check_lead(records[0])
        if not pieces:
            records = [longest_piece(log, records)]
        for on_reading in log.findings:
            self._on_logs.setdefault(repr(on_reading), (on_reading, []))[1].append(name)
        for doubt in (doubt for record in records if self.options.model != "resonance" for doubt in record.doubts()):
            if doubt not in self._doubts:
                self._doubts.append(doubt)
        return records

    def _pieces(self, log: Log, source: str) -> list[AxisRecord]:
        """Return the signals of the axis in a log, one record for each stretch without a long gap.

        Raises
        ------
        ResultError
            If the log has several axes and none is named, or has no position; if a gain is given for a log that has only forces, or
            together with the lead for a log of torques.
        """
        result, axis = log.result, self.options.axis
        if axis is None and len(result.axes) == 1:
            axis = result.axes[0]
        if axis not in result.axes:
            problem = "which axis?" if axis is None else f"no axis {axis} in {result.source}:"
            raise ResultError(f"{problem} There are {', '.join(result.axes)}: name one with --axis")
        whole, spans = self._whole(log, source, axis), log.stretches(axis)
        if spans == [(0, whole.position.size)]:
            return [whole]
        refuse(not spans, ResultError, f"{source} has no stretch without a long gap")
        return [whole.part(*span) for span in spans]

    def _whole(self, log: Log, source: str, axis: str) -> AxisRecord:
        """Return the signals of an axis, gaps included."""
        result, lead = log.result, self.options.si("lead")
        gain = self._given("gain", 'a force per command, such as "35.15 N/V"', "other than 0, and below 1e12 in magnitude")
        full_scale = self._given("full_scale", 'a command, such as "10 V"', "> 0")
        kind = "acceleration" if self.options.model == "resonance" else "position"
        position, command, force = log.signal(axis, *POSITIONS[kind]), log.signal(axis, "command"), log.signal(axis, "force")
        if position is None:
            problem = f"no {kind} of {axis} in {result.source}: give --column '{kind}.{axis}=NAME [mm{'/s^2' * (kind != 'position')}]'"
            raise ResultError("; ".join([problem, *(doubt.text for doubt in log.doubtful)]))
        logged = result.signals["command"].unit if command is not None else ""
        if command is None and force is None and (command := log.signal(axis, "torque")) is not None:
            logged = "N*m"
        if command is None and gain is not None and force is not None:
            raise ResultError(f"{source} has the force of {axis} and no command: omit --gain")
        if lead is not None and logged == "N*m" and full_scale is None:
            if gain is not None:
                raise ResultError(f"{source} has the torque of {axis}, which --lead converts to a force: omit --gain")
            gain = 2.0 * np.pi / lead
        unit = logged
        if gain is not None and command is not None:
            command, unit = gain * command, "N"
        elif full_scale is not None and command is not None:
            command, unit = command / full_scale, "full_scale"
        elif gain is None and force is not None:
            command, unit = force, "N"
        signals = position, command, unit, log.signal(axis, "reference"), log.signal(axis, "disturbance_estimate")
        return AxisRecord(source, axis, result.servo_period, *signals, gain=1.0 if gain is None else gain, logged=logged)

    def _check_lead(self, record: AxisRecord) -> None:
        """Raise if a travel per turn is given but not needed."""
        lead, model = self.options.lead, self.options.model
        if lead is None or model == "two-inertia" or (record.logged, record.unit) == ("N*m", "N"):
            return
        if record.unit == "full_scale" and self.options.full_scale is not None:
            raise ParameterError("--lead", f"{lead} with --full-scale", "one of the two: newtons, or shares of full scale")
        seen = f"the command of {record.source} is in {record.unit}" if record.unit else f"{record.source} has no command"
        raise ParameterError("--lead", lead, f"omitted, or used with a command in N*m, for model {model}: {seen}")

    def _given(self, name: str, wanted: str, bound: str) -> float | None:
        """Return the force per command, or the command at full scale, in SI."""
        text, option = getattr(self.options, name), f"--{name.replace('_', '-')}"
        if text is None:
            return None
        with refused(option, text, wanted):
            number, unit = split(text)
            value = number * to_si(f"1 {unit}", f"N/{unit.partition('/')[2].strip() or 1}" if name == "gain" else unit)
        refuse(not (0.0 < abs(value) < 1e12 and (value > 0.0 or name == "gain")), ParameterError, option, text, bound)
        return value

    def _check_unit(self, log: Log) -> None:
        """Raise if the unit of gain or full scale does not match the command in the log."""
        logged = next((log.result.signals[name].unit for name in ("command", "torque") if name in log.result), "")
        gain, full_scale = f'per {logged}, as "35 {newtons_per(logged)}"', f'in {logged}, as "10 {logged}"'
        for option, text, wanted in (("--gain", self.options.gain, gain), ("--full-scale", self.options.full_scale, full_scale)):
            if text is None or not logged:
                continue
            try:
                unit = split(text)[1]
                to_si(f"1 {(unit.partition('/')[2] if option == '--gain' else unit).strip()}", logged)
            except UnitError as error:
                raise ParameterError(option, text, f"{wanted}: the command of {log.record.file.name} is in {logged}") from error
