"""Read a measured log into a `Result` on one clock, in SI, with a report on its clock."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import LogError, ParameterError, UnitError
from contourlab.logs.clock import EVEN, ClockReport, common_clock, look_at_clock, repeats_too_often, resampled
from contourlab.logs.formats import read_record
from contourlab.logs.mapping import SIGNALS, Column, Columns, guessed, unknown
from contourlab.logs.names import TIME
from contourlab.logs.record import AXIS_LETTERS, Channel, Record, quoted
from contourlab.logs.timestamps import CURE
from contourlab.result import Result, Signal
from contourlab.units import from_si, show, si_unit, to_si

Array = NDArray[np.float64]
FARTHEST, FASTEST = 50.0, 50.0
"""No machine exceeds these positions [m] and speeds [m/s]: the unit is wrong, or a position jumps."""

LONG_GAP = 10
"""Most missing samples in a row across which a model may be fitted; the gap holds a straight line."""


@dataclass(frozen=True, eq=False)
class Log:
    """A measured run.

    Attributes
    ----------
    result : Result
    record : Record
        As read.
    columns : tuple of Column
        Which column became which signal.
    clocks : mapping of str to ClockReport
        By the name of the channel.
    notes : tuple of str
        Notes on how it was read.
    start : float [s]
        Time of the result's first sample, as the file counts.
    doubtful : tuple of str
        A line for each signal that several columns may be by their names; none is taken.
    """

    result: Result
    record: Record
    columns: tuple[Column, ...]
    clocks: dict[str, ClockReport]
    notes: tuple[str, ...] = ()
    start: float = 0.0
    doubtful: tuple[str, ...] = ()

    def clock_notes(self) -> list[str]:
        """Return notes on the times of the channels; each names its channels unless it holds for all."""
        of: dict[str, list[str]] = {}
        for name, report in self.clocks.items():
            for line in report.lines(self.result.servo_period):
                of.setdefault(line, []).append(name)
        return [line if len(names) == len(self.clocks) else f"{quoted(names)}: {line}" for line, names in of.items()]

    def gaps_at(self, time: float) -> list[str]:
        """Return the channels of positions with a gap at a time [s] of the result."""
        lengths = [signal for signal, unit in SIGNALS.items() if unit == "m"]
        rounded = EVEN * self.result.servo_period
        return list(dict.fromkeys(name for name, first, last in self.gaps(*lengths) if first + rounded < time < last - rounded))

    def gaps(self, *signals: str) -> list[tuple[str, float, float]]:
        """Return the gaps of signals: channel, and the times [s] of the result of the samples around each."""
        named = {self.record.channel(c.column).name for c in self.columns if c.signal in signals}
        return [
            (name, gap.time - self.start, gap.time - self.start + (gap.missing + 1) * report.period)
            for name, report in self.clocks.items()
            if name in named
            for gap in report.gaps
        ]

    def stretches(self, axis: str) -> list[tuple[int, int]]:
        """Return the samples [start, stop) of the result in which no channel of an axis has a long gap; three samples or more each."""
        n, period = self.result.n_sample, self.result.servo_period
        named = {self.record.channel(c.column).name for c in self.columns if c.axis == axis}
        measured = np.ones(n, dtype=bool)
        for name in named & self.clocks.keys():
            report = self.clocks[name]
            for gap in (gap for gap in report.gaps if gap.missing > LONG_GAP):
                before = (gap.time - self.start) / period
                first, last = np.floor(before + 1e-3) + 1, np.ceil(before + (gap.missing + 1) * report.period / period - 1e-3)
                measured[max(int(first), 0) : max(int(last), 0)] = False
        edges = np.flatnonzero(np.diff(np.r_[False, measured, False].astype(np.int8)))
        return [(a, b) for a, b in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True) if b - a >= 3]


def load_log(
    file: str | Path,
    *,
    format: str | None = None,  # noqa: A002
    columns: Sequence[Column] = (),
    period: float | None = None,
) -> Log:
    """Read a measured log.

    Parameters
    ----------
    file : str or Path
    format : str, optional
        One of `contourlab.logs.formats.FORMATS`; by default what the file looks like.
    columns : sequence of Column
        Which column is which signal; others are taken if their names leave no doubt.
    period : float [s], > 0, optional
        Between samples, if the file does not give it.

    Returns
    -------
    Log

    Raises
    ------
    LogError
        If the file cannot be read, a column is not there or has no unit, times are not those of even sampling, or values cannot be right.
    ParameterError
        If the period is out of range or the format is unknown.
    """
    if period is not None and not (0.0 < period < 1e3):
        raise ParameterError("period", f"{period:g}", "> 0 and < 1000", "s")
    return result_of(read_record(file, format), Columns(tuple(columns), period))


def result_of(record: Record, given: Columns) -> Log:
    """Return the signals of a record; see `load_log`."""
    guesses, doubtful = _guesses(record, given)
    columns = (*given.columns, *guesses)
    wanted = [column for column in columns if column.signal != TIME]
    if not wanted:
        raise LogError("; ".join([*doubtful, unknown(record)]), file=record.file)
    times, time_notes = _times(record, columns, given)
    timed = {name: _timed(record, name, times, given.period, doubtful) for name in dict.fromkeys(column.column for column in wanted)}
    clock = common_clock([(one.report, float(one.time[0]), float(one.time[-1])) for one in timed.values()], record.file)
    signals, unit_notes = _signals(record, {column: timed[column.column] for column in wanted}, clock)
    axes = tuple(sorted({column.axis for column in wanted}, key=_order))
    attributes = {**record.attributes, "log": record.file.name, "format": record.format}
    result = Result(record.file.stem, axes, clock[0], _stacked(signals, axes), attributes=attributes)
    by_name = [f"{column.target} {column.column!r}" for column in guesses if column.signal != TIME and column.column != column.target]
    notes = (*record.notes, *([f"taken by their names: {', '.join(by_name)}"] if by_name else []), *doubtful, *time_notes, *unit_notes)
    clocks = {one.channel.name: one.report for one in timed.values()}
    log = Log(result, record, columns, clocks, start=clock[1], doubtful=tuple(doubtful))
    return replace(log, notes=(*notes, *log.clock_notes()))


def _guesses(record: Record, given: Columns) -> tuple[list[Column], list[str]]:
    """Return the columns that their names identify besides those given, and a line for each signal that is in doubt."""
    named = {(column.signal, column.axis) for column in given.columns}
    taken = {record.channel(column.column).name for column in given.columns}
    guesses, doubtful = [], []
    for target, candidates in guessed(record).items():
        names = [name for name in candidates if name not in taken]
        if target in named or not names:
            continue
        guesses.append(Column(*target, names[0]))
        if len(names) > 1:
            choice = " or ".join(map(repr, names))
            doubtful.append(f"{guesses.pop().target} may be {choice}: none is taken, say which with --column")
    return guesses, doubtful


def _order(axis: str) -> tuple[int, str]:
    place = AXIS_LETTERS.find(axis.lower()) if len(axis) == 1 else -1
    return (place if place >= 0 else len(AXIS_LETTERS), axis)


def _times(record: Record, columns: Sequence[Column], given: Columns) -> tuple[Array | None, list[str]]:
    """Return the times [s] of channels without their own, None if the samples are evenly counted; and notes."""
    notes: list[str] = []
    column = next((c for c in columns if c.signal == TIME), None)
    if column is not None and any(record.channel(c.column).time is None for c in columns if c.signal != TIME):
        channel = record.channel(column.column)
        try:
            return _times_in(channel, column, record)
        except LogError as error:
            if given.period is None or column in given.columns:
                raise
            notes = [f"{error.message.removesuffix(f': {CURE}')}: samples are counted by the period that was given"]
    numbered = next((c for c in record.channels if c.name == "sample" and record.format == "halsampler"), None)
    period = given.period or record.period
    return (np.asarray(numbered.values * period), notes) if numbered is not None and period is not None else (None, notes)


def _times_in(channel: Channel, column: Column, record: Record) -> tuple[Array, list[str]]:
    """Return the times [s] in a column, and notes."""
    if channel.fault is not None:
        raise channel.fault
    missing = np.isnan(channel.values)
    if missing.all():
        raise LogError(f"column {channel.name!r} holds no times: {CURE}", file=record.file)
    if repeats_too_often(channel.values[~missing]):
        raise LogError(f"times in column {channel.name!r} are written too coarsely: {CURE}", file=record.file)
    if channel.is_timestamp and column.unit:
        raise LogError(f"column {channel.name!r} holds dates and times of day: name it without {column.unit}", file=record.file)
    unit = column.unit or channel.unit
    notes = [*channel.notes] if unit else ["time is taken in s: its column says no unit"]
    if missing.any():
        notes.append(f"{int(missing.sum())} of {missing.size} rows say no time, and are left out")
    return _in_si(channel, column, unit or "s", "s", record) * column.factor, notes


@dataclass(eq=False)
class Timed:
    """A channel with the times [s] of its values, one value for each time, and its clock."""

    channel: Channel
    time: Array
    report: ClockReport


def _timed(record: Record, name: str, times: Array | None, period: float | None, doubtful: Sequence[str]) -> Timed:
    """Return a channel with the times of its values, without gaps."""
    channel = record.channel(name)
    if channel.fault is not None:
        raise channel.fault
    time = channel.time if channel.time is not None else times
    period = period or record.period
    if time is None:
        if period is None:
            doubt = "".join(f"{words}; " for words in doubtful if words.startswith(f"{TIME} "))
            cure = 'give the period, as --period "1 ms", or the column, as --column time=NAME'
            raise LogError(f"{doubt}says no sample times: {cure}", file=record.file)
        time = np.asarray(np.arange(channel.values.size) * period)
    if time.size != channel.values.size:
        raise LogError(f"column {channel.name!r} has {channel.values.size} values for {time.size} times", file=record.file)
    there = np.isfinite(channel.values)
    if not there.any():
        raise LogError(f"column {channel.name!r} holds no numbers", file=record.file)
    there &= ~np.isnan(time)
    values, time = channel.values[there], time[there]
    report, kept = look_at_clock(time, channel.name, record.file, period)
    return Timed(replace(channel, values=values[kept]), time[kept], report)


def _in_si(channel: Channel, column: Column, unit: str, expected: str, record: Record) -> Array:
    try:
        size = to_si(f"1 {unit}", expected or unit)
        # Division by a whole number keeps 20 mm exactly 0.02 m.
        return channel.values / from_si(1.0, unit) if size < 1.0 else channel.values * size
    except UnitError as error:
        example = f", such as {expected}" if expected else ""
        raise LogError(f"column {channel.name!r} is in {unit}, which is no unit of {column.signal}{example}", file=record.file) from error


def _signals(
    record: Record, timed: dict[Column, Timed], clock: tuple[float, float, int]
) -> tuple[dict[str, dict[str, tuple[Array, str]]], list[str]]:
    """Return values and unit of each signal and axis on the clock, and notes."""
    signals: dict[str, dict[str, tuple[Array, str]]] = {}
    notes = []
    for column, one in timed.items():
        unit, note = _unit(column, one.channel, timed, record)
        notes += [note] if note else []
        expected = SIGNALS[column.signal]
        values = _in_si(one.channel, column, unit, expected, record) if unit else one.channel.values
        values = values * column.factor
        _check_size(values, column, one, unit, record)
        even, between = resampled(one.time, values, one.report, clock)
        if between:
            one.report = replace(one.report, resampled=True)
        signals.setdefault(column.signal, {})[column.axis] = (even, expected or si_unit(unit))
    return signals, list(dict.fromkeys(notes))


def _unit(column: Column, channel: Channel, timed: dict[Column, Timed], record: Record) -> tuple[str, str]:
    """Return the unit of a column, and a note if it is that of another signal of the axis."""
    unit, expected = column.unit or channel.unit, SIGNALS[column.signal]
    if unit or not expected:
        return unit, ""
    for other, beside in timed.items():
        shared = other.unit or beside.channel.unit
        if other is not column and other.axis == column.axis and SIGNALS[other.signal] == expected and shared:
            return shared, f"{column.signal} is taken in {shared}, as {other.signal} is: its columns say no unit"
    cure = f"write --column '{column.target}={channel.name} [mm]'"
    raise LogError(f"column {channel.name!r} says no unit: {cure}", file=record.file)


def _check_size(values: Array, column: Column, one: Timed, unit: str, record: Record) -> None:
    """Refuse what no machine does: wrong units, counters that wrap, two records. References may jump."""
    si, name = SIGNALS[column.signal], one.channel.name
    limit, largest = {"m": FARTHEST, "m/s": FASTEST}.get(si, np.inf), float(np.abs(values).max())
    if largest > limit:
        raise LogError(f"column {name!r} reaches {show(largest, si, 4)}, beyond any machine: is {unit} its unit?", file=record.file)
    if si != "m" or column.signal == "reference":
        return
    speed = np.abs(np.diff(values)) / np.maximum(np.diff(one.time), one.report.period)
    k = int(np.argmax(speed))
    if speed[k] > FASTEST:
        jump = f"goes from {show(values[k], 'mm')} to {show(values[k + 1], 'mm')} at t = {one.time[k]:.6g} s"
        cure = f"is {unit} its unit, does a counter wrap, are there two records?"
        raise LogError(f"column {name!r} {jump}, {show(float(speed[k]), 'm/s', 3)}, faster than any machine: {cure}", file=record.file)


def _stacked(found: dict[str, dict[str, tuple[Array, str]]], axes: tuple[str, ...]) -> dict[str, Signal]:
    """Return each signal as (n_sample, n_axis); not a number for an axis that has none of it."""
    signals = {}
    for name, by_axis in found.items():
        n = next(iter(by_axis.values()))[0].size
        table = np.column_stack([by_axis[axis][0] if axis in by_axis else np.full(n, np.nan) for axis in axes])
        units = {unit for _, unit in by_axis.values()}
        signals[name] = Signal(table, ("sample", "axis"), units.pop() if len(units) == 1 else "")
    return signals
