"""Logs of one axis, read as the options of an identification say, with findings on them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

from contourlab.errors import ParameterError, UnitError
from contourlab.features.identify.options import Identify
from contourlab.features.identify.records import AxisRecord, axis_pieces, longest_piece, newtons_per, samples_digest
from contourlab.features.identify.result import join_names
from contourlab.features.measure.log_choice import LogChoice, distinct_names, open_log
from contourlab.findings import Finding, finding
from contourlab.logs import Log
from contourlab.units import split, to_si


@dataclass(frozen=True)
class Request:
    """Logs to read: one or several with the same options, and one for validation."""

    options: Identify
    logs: Sequence[str | Path]
    _on_logs: list[tuple[Finding, list[str]]] = field(default_factory=list)
    _doubts: list[Finding] = field(default_factory=list)

    @property
    def files(self) -> list[str | Path]:
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
        seen: dict[Path, str | Path] = {}
        for file in self.logs:
            place = Path(file).resolve()
            if place in seen:
                same = "" if Path(seen[place]) == Path(file) else f", the same file as {seen[place]}"
                raise ParameterError("LOG", f"{file}{same}", "given once: its samples would count twice")
            seen[place] = file
        logs = [self.read(file, pieces) for file in self.logs]
        by_samples: dict[str, str] = {}
        for records in logs:
            other = by_samples.setdefault(samples_digest(records), records[0].source)
            if other != records[0].source:
                self._doubts.append(finding("CL500", records[0].source, other=other))
        return [record for records in logs for record in records]

    def findings(self) -> list[Finding]:
        """Return the findings on the logs, and on reading them; one that holds for some logs only names them."""
        places = ("" if len(names) == len(self.files) else join_names(names) for _, names in self._on_logs)
        placed = zip((doubt for doubt, _ in self._on_logs), places, strict=True)
        return [*self._doubts, *(replace(doubt, place=": ".join(filter(None, (at, doubt.place)))) for doubt, at in placed)]

    def read(self, file: str | Path, pieces: bool = False) -> list[AxisRecord]:
        """Return the signals of the axis in a log."""
        options, name = self.options, self.names[Path(file)]
        log = open_log(LogChoice.of(file, options))
        self._check_unit(log)
        records = axis_pieces(log, name, options.axis, self._gain(), self._full_scale(), options.si("lead"))
        self._check_lead(records[0])
        if not pieces:
            records = [longest_piece(log, records)]
        for on_reading in log.findings:
            names = next((names for other, names in self._on_logs if other == on_reading), None)
            if names is None:
                self._on_logs.append((on_reading, names := []))
            names.append(name)
        for doubt in (doubt for record in records for doubt in record.doubts()):
            if doubt not in self._doubts:
                self._doubts.append(doubt)
        return records

    def _check_lead(self, record: AxisRecord) -> None:
        """Raise if a travel per turn is given but not needed."""
        lead, model = self.options.lead, self.options.model
        if lead is None or model == "two-inertia" or (record.logged, record.unit) == ("N*m", "N"):
            return
        if record.unit == "full_scale" and self.options.full_scale is not None:
            raise ParameterError("--lead", f"{lead} with --full-scale", "one of the two: newtons, or shares of full scale")
        seen = f"the command of {record.source} is in {record.unit}" if record.unit else f"{record.source} has no command"
        raise ParameterError("--lead", lead, f"omitted, or used with a command in N*m, for model {model}: {seen}")

    def _gain(self) -> float | None:
        """Return the force per command, in SI."""
        text = self.options.gain
        if text is None:
            return None
        try:
            number, unit = split(text)
            force, _, below = unit.partition("/")
            value = number * to_si(f"1 {force.strip()}", "N") / to_si(f"1 {below.strip()}", below.strip())
        except UnitError as error:
            raise ParameterError("--gain", repr(text), 'a force per command, such as "35.15 N/V"') from error
        if not 0.0 < abs(value) < 1e12:
            raise ParameterError("--gain", text, "other than 0, and below 1e12 in magnitude")
        return value

    def _full_scale(self) -> float | None:
        text = self.options.full_scale
        if text is None:
            return None
        try:
            number, unit = split(text)
            value = number * to_si(f"1 {unit}", unit)
        except UnitError as error:
            raise ParameterError("--full-scale", repr(text), 'a command, such as "10 V"') from error
        if not 0.0 < value < 1e12:
            raise ParameterError("--full-scale", text, "> 0")
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
