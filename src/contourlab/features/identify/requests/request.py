"""What the command line asks of an identification, and how its options are read."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from pathlib import Path

from contourlab.errors import ParameterError, UnitError
from contourlab.features.identify.doubts import doubts
from contourlab.features.identify.signals import AxisRecord, axis_pieces, longest_piece, newtons_per, samples_digest
from contourlab.features.measure.log_choice import LogChoice, open_log, positive, told_apart
from contourlab.logs import Log
from contourlab.logs.error_context import about
from contourlab.units import split, to_si


@dataclass(frozen=True)
class Request:
    """An identification as it was asked for.

    Attributes
    ----------
    model : str
    choices : tuple of LogChoice
        One or several logs, read alike.
    axis : str or None
    gain : str or None
        Force per command, as ``"35.15 N/V"``.
    full_scale : str or None
        Full scale of the command, as ``"10 V"``.
    cutoff : str
    decimation : int
    slowest : str or None
        Speed below which samples are left out, as ``"1 mm/s"``.
    validation : str, Path or None
    position_gain, velocity_gain : str or None
        Of the loop as it ran, as ``"4 full_scale/mm"``.
    lead : str or None
        Travel per turn, as ``"10 mm"``: of the shaft of two inertias, and of a command in newton metres.
    motor_inertia : str or None
        Of motor and screw, as ``"2 kg*cm^2"``.
    side : str
        Where the position is measured, ``"motor"`` or ``"load"``.
    said : dict of str to list of str
        What reading the logs had to say, and of which of them; filled while they are read.
    doubts : list of str
        What stands against their signals, in words; filled alike.
    """

    model: str
    choices: tuple[LogChoice, ...]
    axis: str | None = None
    gain: str | None = None
    full_scale: str | None = None
    cutoff: str = "100 Hz"
    decimation: int = 10
    slowest: str | None = None
    validation: str | Path | None = None
    position_gain: str | None = None
    velocity_gain: str | None = None
    lead: str | None = None
    motor_inertia: str | None = None
    side: str = "motor"
    said: dict[str, list[str]] = field(default_factory=dict)
    doubts: list[str] = field(default_factory=list)

    @property
    def inputs(self) -> tuple[str | Path, ...]:
        """The files that are read."""
        second = () if self.validation is None else (self.validation,)
        return (*(file for choice in self.choices for file in choice.files), *second)

    @property
    def notes(self) -> list[str]:
        """What reading the logs had to say: of which of them, where it is not of all."""
        count = len(self.choices) + (self.validation is not None)
        return [note if len(named) == count else f"{listed(named)}: {note}" for note, named in self.said.items()]

    def records(self, *, pieces: bool = False) -> list[AxisRecord]:
        """Return the axis' signals of all logs; with `pieces` a record for each stretch between long gaps, not the longest alone."""
        if self.gain is not None and self.full_scale is not None:
            raise ParameterError("--full-scale", f"{self.full_scale} beside --gain", "one of the two: newtons, or parts of full scale")
        self._check_once()
        found = [self._read(choice, pieces) for choice in self.choices]
        alike: dict[str, list[str]] = {}
        for records in found:
            named = alike.setdefault(samples_digest(records), [])
            self.doubts.extend(f"{records[0].source} has the samples of {first}: they count twice" for first in named)
            named.append(records[0].source)
        return [record for records in found for record in records]

    def about(self) -> AbstractContextManager[None]:
        """Return what gives errors about samples the names of the logs; see `contourlab.logs.error_context.about`."""
        return about(*self._names.values(), options=[each.name for each in fields(self)])

    def _check_once(self) -> None:
        """Refuse a log that is given twice, by whatever path."""
        seen: dict[Path, str | Path] = {}
        for choice in self.choices:
            place = Path(choice.file).resolve()
            if place in seen:
                same = "" if Path(seen[place]) == Path(choice.file) else f", the same file as {seen[place]}"
                raise ParameterError("LOG", f"{choice.file}{same}", "given once: its samples would count twice")
            seen[place] = choice.file

    def second(self) -> AxisRecord | None:
        """Return the axis' signals of the log for validation, if there is one."""
        if self.validation is None:
            return None
        return self._read(replace(self.choices[0], file=self.validation))[0]

    @cached_property
    def _names(self) -> dict[Path, str]:
        """What the logs of this request are called."""
        files = [choice.file for choice in self.choices] + ([] if self.validation is None else [self.validation])
        return dict(zip(map(Path, files), told_apart(files), strict=True))

    def _read(self, choice: LogChoice, pieces: bool = False) -> tuple[AxisRecord, ...]:
        log = open_log(choice)
        self._check_unit(log)
        name = self._names[Path(choice.file)]
        found = axis_pieces(log, self.axis, self.force_gain(), self._full_scale(), name, self.travel())
        self._check_lead(found[0])
        if not pieces:
            found = (longest_piece(log, found),)
        for note in log.notes:
            self.said.setdefault(note, []).append(name)
        said = dict.fromkeys(words for record in found for words in (*record.notes, *doubts(record)))
        self.doubts.extend(words for words in said if words not in self.doubts)
        return found

    def travel(self) -> float | None:
        """Return the travel per turn [m], or None."""
        return None if self.lead is None else positive("--lead", self.lead, "m", 'travel per turn, such as "10 mm"')

    def _check_lead(self, record: AxisRecord) -> None:
        """Refuse a travel per turn of which nothing is made."""
        if self.lead is None or self.model == "two-inertia" or (record.logged, record.unit) == ("N*m", "N"):
            return
        if record.unit == "full_scale" and self.full_scale is not None:
            raise ParameterError("--lead", f"{self.lead} beside --full-scale", "one of the two: newtons, or parts of full scale")
        seen = f"the command of {record.source} is in {record.unit}" if record.unit else f"{record.source} has no command"
        raise ParameterError("--lead", self.lead, f"left out, or beside a command in N*m, for model {self.model}: {seen}")

    def _full_scale(self) -> float | None:
        if self.full_scale is None:
            return None
        try:
            number, unit = split(self.full_scale)
            value = number * to_si(f"1 {unit}", unit)
        except UnitError as error:
            raise ParameterError("--full-scale", repr(self.full_scale), 'a command, such as "10 V"') from error
        if not 0.0 < value < 1e12:
            raise ParameterError("--full-scale", self.full_scale, "> 0")
        return value

    def _check_unit(self, log: Log) -> None:
        """Refuse a gain, or a full scale, per another unit than that of the log's command."""
        logged = next((log.result.signals[name].unit for name in ("command", "torque") if name in log.result), "")
        for option, text in (("--gain", self.gain), ("--full-scale", self.full_scale)):
            if text is None or not logged:
                continue
            try:
                unit = split(text)[1]
                to_si(f"1 {(unit.partition('/')[2] if option == '--gain' else unit).strip()}", logged)
            except UnitError as error:
                wanted = f'per {logged}, as "35 {newtons_per(logged)}"' if option == "--gain" else f'in {logged}, as "10 {logged}"'
                raise ParameterError(option, text, f"{wanted}: the command of {log.record.file.name} is in {logged}") from error

    def record(self) -> AxisRecord:
        """Return the axis' signals of the only log.

        Raises
        ------
        ParameterError
            If there are several.
        """
        if len(self.choices) > 1:
            raise ParameterError("LOG", f"{len(self.choices)} logs", f"one: model {self.model} takes a single run")
        return self.records()[0]

    def force_gain(self) -> float | None:
        """Return the force per command [N per unit of command], or None."""
        return None if self.gain is None else per_command("--gain", self.gain, "N", 'a force per command, such as "35.15 N/V"')


def listed(names: Sequence[str]) -> str:
    """Return names of logs in words, a few of many.

    >>> listed(["a", "b", "c", "d"])
    'a, b and 2 more'
    """
    return ", ".join(names) if len(names) <= 3 else f"{', '.join(names[:2])} and {len(names) - 2} more"


def per_command(option: str, text: str, top: str, wanted: str) -> float:
    """Return a quantity per another, as ``"35.15 N/V"``, in SI.

    Parameters
    ----------
    option, text : str
    top : str
        Unit of what stands above the stroke.
    wanted : str
        What would be right, in words.

    Raises
    ------
    ParameterError
        If it is no such quantity, or 0.
    """
    try:
        number, unit = split(text)
        above, _, below = unit.partition("/")
        value = number * to_si(f"1 {above.strip()}", top) / to_si(f"1 {below.strip()}", below.strip())
    except UnitError as error:
        raise ParameterError(option, repr(text), wanted) from error
    if not 0.0 < abs(value) < 1e12:
        raise ParameterError(option, text, "other than 0, and below 1e12 either way")
    return value
