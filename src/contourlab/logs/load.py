"""Read a measured log into a `Result` on one clock, in SI, with a report on its clock."""

from __future__ import annotations

import os
import re
from collections.abc import Container, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Flags, Index, true_spans
from contourlab.errors import FeedError, GeometryError, LogError, ParameterError, ResultError, UnitError, refuse, refused
from contourlab.findings import Finding, finding
from contourlab.logs.clock import (
    EVEN,
    UNEVEN,
    ClockReport,
    common_clock,
    counted_times,
    look_at_clock,
    repeats_too_often,
    resampled,
    resampling_error,
)
from contourlab.logs.delimited import CURE
from contourlab.logs.formats import read_record
from contourlab.logs.mapping import LINE, LINES, SIGNALS, TIME, USUAL, Column, Columns, guessed, parse_columns
from contourlab.logs.reading import AXIS_LETTERS, FASTEST, Blocks, Channel, Record, join_names, name_and_unit, quoted
from contourlab.logs.window import Window, inside, parse_window, share_rows, start_of
from contourlab.result import Result, Signal
from contourlab.units import from_si, plain, same_dimension, show, si_unit, to_si

_ANGLE = re.compile(r"(deg|rad|rev|turn)\w*(/|\Z)|rpm\Z")
FARTHEST = 50.0
"""Largest plausible position [m]; beyond, the unit is wrong."""

MOST_NAMES = 30
"""Most columns that a finding lists."""
LONG_GAP = 10
"""Longest gap in samples across which a model may be fitted; gaps are interpolated linearly."""


@dataclass(frozen=True, eq=False)
class Log:
    """A measured run; it may stand wherever the name of a log does.

    Attributes
    ----------
    result : Result
        The signals in SI on one clock.
    record : Record
        The file as read.
    columns : tuple of Column
        The column of each signal.
    clocks : mapping of str to ClockReport
        Clock of each channel.
    findings : tuple of Finding
        Findings on the reading.
    start : float [s]
        Time of the first sample in the file.
    doubtful : tuple of Finding
        Findings on signals with several candidate columns, which are not used.
    given : Columns
        The columns and the period as given, without those that were identified by name.
    blocks : Blocks or None
        Of the part program, with the times of the file.
    """

    result: Result
    record: Record
    columns: tuple[Column, ...]
    clocks: dict[str, ClockReport]
    findings: tuple[Finding, ...] = ()
    start: float = 0.0
    doubtful: tuple[Finding, ...] = ()
    given: Columns = field(default_factory=Columns)
    blocks: Blocks | None = None

    def __fspath__(self) -> str:
        return str(self.record.file)

    __str__ = __fspath__

    @property
    def block(self) -> Index | None:
        """Index of the block of the part program at each sample (n_sample,), -1 for none; None if the log does not say."""
        time = self.start + (np.arange(self.result.n_sample, dtype=np.float64) + EVEN) * self.result.servo_period
        return None if self.blocks is None else self.blocks.at(time)

    @property
    def lines(self) -> Index | None:
        """Line of the part program at each sample (n_sample,), 0 for none; None if the log does not say."""
        return None if self.blocks is None else np.append(self.blocks.line, 0)[self.block]

    @property
    def rapid(self) -> Flags | None:
        """Whether each sample (n_sample,) is of a block that is known to be a rapid move; None if the log does not say."""
        known = None if self.blocks is None else self.blocks.is_rapid
        return None if known is None else np.append(known, False)[self.block]

    def span(self, window: Window) -> tuple[float, float]:
        """Return the times [s] in the result between which a part of the log lies."""
        half = 0.5 * self.result.servo_period
        if window.kind == "time":
            last = (self.result.n_sample - 1) * self.result.servo_period + half
            return max(window.first, 0.0), window.last if window.last < np.inf else last
        part = result_of(self.record, replace(self.given, window=window))
        first = part.start - self.start
        return first - half, first + (part.result.n_sample - 1) * part.result.servo_period + half

    def signal(self, axis: str, *names: str) -> Array | None:
        """Return the first of some signals that an axis has at all samples (n,); None if there is none."""
        columns = (self.result[name][:, self.result.axes.index(axis)] for name in names if name in self.result)
        return next((values for values in columns if np.isfinite(values).all()), None)

    def clock_findings(self) -> list[Finding]:
        """Return the findings on uneven sample times; they name the channels unless all are alike."""
        period = self.result.servo_period
        alike: dict[ClockReport, list[str]] = {}
        for name, report in self.clocks.items():
            alike.setdefault(report, []).append(name)
        places = {report: "" if len(names) == len(self.clocks) else quoted(names) for report, names in alike.items()}
        return [one for report, place in places.items() for one in report.findings(period, place)]

    def gaps_at(self, time: float) -> list[str]:
        """Return the position channels with a gap at a time [s] of the result."""
        lengths = [signal for signal, unit in SIGNALS.items() if unit == "m"]
        rounded = EVEN * self.result.servo_period
        return list(dict.fromkeys(name for name, first, last in self.gaps(*lengths) if first + rounded < time < last - rounded))

    def gaps(self, *signals: str) -> list[tuple[str, float, float]]:
        """Return the gaps of signals: channel, and times [s] in the result of the samples before and after."""
        named = {self.record.channel(c.column).name for c in self.columns if c.signal in signals}
        return [
            (name, gap.time - self.start, gap.time - self.start + (gap.missing + 1) * report.period)
            for name, report in self.clocks.items()
            if name in named
            for gap in report.gaps
        ]

    def stretches(self, axis: str) -> list[tuple[int, int]]:
        """Return the sample ranges [start, stop) without a long gap in any channel of an axis, at least three samples each."""
        n, period = self.result.n_sample, self.result.servo_period
        named = {self.record.channel(c.column).name for c in self.columns if c.axis == axis}
        measured = np.ones(n, dtype=bool)
        for name in named & self.clocks.keys():
            report = self.clocks[name]
            for gap in (gap for gap in report.gaps if gap.missing > LONG_GAP):
                before = (gap.time - self.start) / period
                first, last = np.floor(before + 1e-3) + 1, np.ceil(before + (gap.missing + 1) * report.period / period - 1e-3)
                measured[max(int(first), 0) : max(int(last), 0)] = False
        return [(a, b) for a, b in true_spans(measured) if b - a >= 3]


def load_log(
    file: str | Path | Mapping[str, ArrayLike],
    *,
    format: str | None = None,  # noqa: A002
    columns: Sequence[Column | str] = (),
    period: float | None = None,
    unit: str = "",
    window: str | None = None,
    name: str = "arrays",
) -> Log:
    """Read a measured log from a file, or from arrays.

    Parameters
    ----------
    file : str, Path or mapping of str to array_like (n,)
        A file; or arrays by the names that their columns would have in a file, with units, as ``x [mm]``; a DataFrame is such a mapping.
    format : str, optional
        One of `contourlab.logs.formats.FORMATS`; by default recognised.
    columns : sequence of Column or str
        Columns of signals, as text such as ``position.x=NAME [mm]``; others are identified by unambiguous names.
    period : float [s], > 0, optional
        Sample period, if the log has no times.
    unit : str
        Unit of lengths in columns that have none, such as ``mm``; speeds have it per second.
    window : str, optional
        The part to read, as ``"10.706 s..14 s"``, ``"0..1493"`` or ``"line 20..line 40"``.
    name : str
        Name of a log from arrays.

    Returns
    -------
    Log
        It may stand wherever a question asks for the file of a log.

    Raises
    ------
    LogError
        If the file cannot be read, a column is missing or has no unit, sampling is uneven, or values are implausible.
    ParameterError
        If the period is out of range, or format, unit or window are not known.

    >>> log = load_log({"time [s]": [0.0, 0.001, 0.002], "x [mm]": [0.0, 1.0, 2.0]})
    >>> log.result["position"].tolist()
    [[0.0], [0.001], [0.002]]
    """
    refuse(period is not None and not (0.0 < period < 1e3), ParameterError, "period", f"{period}", "> 0 and < 1000", "s")
    record = read_record(file, format) if isinstance(file, str | os.PathLike) else record_of(file, name)
    texts = [column for column in columns if isinstance(column, str)]
    given = (*(column for column in columns if isinstance(column, Column)), *parse_columns(texts, "columns"))
    return result_of(record, Columns(given, period, unit=unit, window=None if window is None else parse_window(window)))


def record_of(arrays: Mapping[str, ArrayLike], name: str) -> Record:
    """Return arrays as a log; see `load_log`."""
    channels, source = [], Path(name)
    for head, values in arrays.items():
        title, unit = name_and_unit(str(head))
        try:
            column = np.asarray(values, dtype=float)
        except (TypeError, ValueError):
            column = np.empty((0, 0))
        refuse(column.ndim != 1, LogError, f"column {title!r} must be numbers of shape (n,)", file=source)
        channels.append(Channel(title, column, unit))
    if len({channel.values.size for channel in channels}) > 1:
        raise LogError(f"columns of different length: {', '.join(f'{c.name} {c.values.size}' for c in channels)}", file=source)
    return Record(source, "arrays", tuple(channels))


def result_of(record: Record, given: Columns) -> Log:
    """Return the signals of a record; see `load_log`."""
    with refused("--unit", given.unit, "a unit of length, such as mm"):
        refuse(bool(given.unit) and not same_dimension(given.unit, "m"), ValueError)
    guesses, doubtful = _guesses(record, given)
    units, spare, unit_findings = _units(record, given, guesses)
    guesses = [column for column in guesses if column not in spare]
    columns = (*given.columns, *guesses)
    wanted = [column for column in columns if column.signal in SIGNALS]
    if not wanted:
        at_once = "--unit mm, or " if any(signal == "position" for signal, _ in guessed(record, "mm")) else ""
        cure = f"write {at_once}for example --column 'position.x=NAME [mm]', or name a file of columns with --columns"
        unknown = f"no column matches a signal: {cure}. The columns are {quoted(record.names)}"
        raise LogError("; ".join([*(doubt.text for doubt in doubtful), unknown]), file=record.file)
    times, time_findings = _times(record, columns, given)
    names = dict.fromkeys(column.column for column in wanted)
    raw = {name: _raw(record, name, times, given.period, doubtful) for name in names}
    blocks = record.blocks or _blocks_of(record, given, times, given.period)
    timed = _timed(record, raw, blocks, given)
    clock = common_clock([(channel.report, float(channel.time[0]), float(channel.time[-1])) for channel in timed.values()], record.file)
    signals, uneven = _signals(record, {column: timed[column.column] for column in wanted}, units, clock)
    places = {letter: place for place, letter in enumerate(AXIS_LETTERS)}
    axes = tuple(sorted({column.axis for column in wanted}, key=lambda axis: (places.get(axis.lower(), len(places)), axis)))
    attributes = {**record.attributes, "log": record.file.name, "format": record.format}
    result = Result(record.file.stem, axes, clock[0], _stacked(signals, axes), attributes=attributes)
    by_name = [f"{column.target} = {column.column}" for column in guesses if column.signal in SIGNALS and column.column != column.target]
    named = [finding("CL430", columns=by_name)] if by_name else []
    named += _not_used(record, columns, given)
    clocks = {channel.channel.name: channel.report for channel in timed.values()}
    log = Log(result, record, columns, clocks, start=clock[1], doubtful=tuple(doubtful), given=given, blocks=blocks)
    first, n = clock[1] - start_of(time for _, time in raw.values()), result.n_sample
    read = finding("CL416", window=str(given.window), samples=n, first=first, last=first + (n - 1) * clock[0])
    part = [] if given.window is None else [read]
    findings = (*record.findings, *named, *doubtful, *time_findings, *unit_findings, *part, *log.clock_findings(), *uneven)
    return replace(log, findings=findings)


def _not_used(record: Record, columns: Sequence[Column], given: Columns) -> list[Finding]:
    """Return a finding on the columns whose names mean nothing, if there are some; a result of contourlab has signals of its own."""
    known = {channel.name for channel in record.channels_of(column.column for column in columns)}
    known |= {name for names in guessed(record, given.unit or record.unit).values() for name in names}
    others = [c.name for c in record.channels if c.name not in known and not c.is_timestamp and c.name.casefold() not in LINES]
    if not others or record.format == "contourlab":
        return []
    more = [f"{len(others) - MOST_NAMES} more"] if len(others) > MOST_NAMES else []
    return [finding("CL441", columns=[*others[:MOST_NAMES], *more])]


def _guesses(record: Record, given: Columns) -> tuple[list[Column], list[Finding]]:
    """Return the columns identified by name besides those given, and a finding for each ambiguous signal."""
    named = {(column.signal, column.axis) for column in given.columns}
    taken = {channel.name for channel in record.channels_of(column.column for column in given.columns)}
    guesses, doubtful = [], []
    for target, candidates in guessed(record, given.unit or record.unit).items():
        names = [name for name in candidates if name not in taken]
        if target not in named and len(names) == 1:
            guesses.append(Column(*target, names[0]))
        elif target not in named and names:
            doubtful.append(finding("CL431", signal=Column(*target, "").target, columns=" or ".join(map(repr, names))))
    return guesses, doubtful


def _times(record: Record, columns: Sequence[Column], given: Columns) -> tuple[Array | None, list[Finding]]:
    """Return the times [s] for channels without their own (None: count samples by the period), and findings."""
    findings = list[Finding]()
    column = next((c for c in columns if c.signal == TIME), None)
    if column is not None and any(record.channel(c.column).time is None for c in columns if c.signal in SIGNALS):
        try:
            return _times_in(record.channel(column.column), column, record)
        except LogError as error:
            if given.period is None or column in given.columns:
                raise
            findings = [finding("CL432", reason=error.message.removesuffix(f": {CURE}"))]
    numbered = next((c for c in record.channels if c.name == "sample" and record.format == "halsampler"), None)
    period = given.period or record.period
    return (np.asarray(numbered.values * period), findings) if numbered is not None and period is not None else (None, findings)


def _times_in(channel: Channel, column: Column, record: Record) -> tuple[Array, list[Finding]]:
    if channel.fault is not None:
        raise channel.fault
    missing = np.isnan(channel.values)
    refuse(missing.all(), LogError, f"column {channel.name!r} contains no times: {CURE}", file=record.file)
    if repeats_too_often(channel.values[~missing]):
        raise LogError(f"too many times in column {channel.name!r} repeat: {CURE}", file=record.file)
    if channel.is_timestamp and column.unit:
        raise LogError(f"column {channel.name!r} contains dates and times of day: leave out {column.unit}", file=record.file)
    unit = column.unit or channel.unit
    findings = [*channel.findings] if unit else [finding("CL433")]
    if missing.any():
        findings.append(finding("CL434", missing=int(missing.sum()), rows=missing.size))
    return _in_si(channel, column, unit or "s", "s", record) * column.factor, findings


@dataclass(eq=False)
class Timed:
    """A channel without gaps, its times [s], its clock report, and whether its times are counted by the given period."""

    channel: Channel
    time: Array
    report: ClockReport
    is_counted: bool = False


def _raw(record: Record, name: str, times: Array | None, period: float | None, doubtful: Sequence[Finding]) -> tuple[Channel, Array]:
    """Return a channel and its times, both as read."""
    channel = record.channel(name)
    if channel.fault is not None:
        raise channel.fault
    time = channel.time if channel.time is not None else times
    period = period or record.period
    if time is None:
        if period is None:
            doubt = "".join(f"{doubt.text}; " for doubt in doubtful if doubt.values["signal"] == TIME)
            cure = 'give the period, as --period "1 ms", or the column, as --column time=NAME'
            raise LogError(f"{doubt}has no sample times: {cure}", file=record.file)
        time = np.asarray(np.arange(channel.values.size) * period)
    if time.size != channel.values.size:
        raise LogError(f"column {channel.name!r} has {channel.values.size} values for {time.size} times", file=record.file)
    refuse(not np.isfinite(channel.values).any(), LogError, f"column {channel.name!r} contains no numbers", file=record.file)
    return channel, time


def _blocks_of(record: Record, given: Columns, times: Array | None, period: float | None) -> Blocks | None:
    """Return the blocks that a column of program lines shows; a column that is only guessed may be unusable."""
    named = next((column for column in given.columns if column.signal == LINE), None)
    name = named.column if named else next((c.name for c in record.channels if c.name.casefold() in LINES), None)
    if name is None:
        return None
    try:
        channel, time = _raw(record, name, times, period, ())
        if not np.abs(channel.values).max() < 1e7 or np.isnan(time).any():
            raise LogError(f"column {name!r} does not have a line number for each sample", file=record.file)
    except LogError:
        if named:
            raise
        return None
    return Blocks(np.maximum.accumulate(time), np.maximum(np.rint(channel.values), 0.0).astype(np.int64))


def _timed(record: Record, raw: dict[str, tuple[Channel, Array]], blocks: Blocks | None, given: Columns) -> dict[str, Timed]:
    """Return the part of each channel in the window, without missing values."""
    times = {name: time for name, (_, time) in raw.items()}
    chosen, is_table, start = inside(given.window, times, blocks, record), share_rows(times.values()), start_of(times.values())
    stated = given.period or record.period
    timed = {}
    for name, (channel, time) in raw.items():
        valid = chosen[name] & np.isfinite(channel.values) & ~np.isnan(time)
        rows = np.flatnonzero(valid) if is_table else None
        report, kept = look_at_clock(time[valid], channel.name, record.file, stated, rows=rows, start=start)
        is_counted = given.period is not None and report.jitter_peak > EVEN * given.period
        even = counted_times(time[valid][kept], report) if is_counted else time[valid][kept]
        timed[name] = Timed(replace(channel, values=channel.values[valid][kept]), even, report, is_counted)
    return timed


def _in_si(channel: Channel, column: Column, unit: str, expected: str, record: Record) -> Array:
    try:
        size = to_si(f"1 {unit}", expected or unit)
        # Dividing by a whole number keeps 20 mm exactly 0.02 m.
        return channel.values / from_si(1.0, unit) if size < 1.0 else channel.values * size
    except UnitError as error:
        example = f", such as {USUAL.get(expected, expected)}" if expected else ""
        raise LogError(f"column {channel.name!r} is in {unit}: write a unit of {column.signal}{example}", file=record.file) from error


def _signals(
    record: Record, timed: dict[Column, Timed], units: dict[Column, str], clock: tuple[float, float, int]
) -> tuple[dict[str, dict[str, tuple[Array, str]]], list[Finding]]:
    """Return values on the clock and unit of each signal and axis, and findings."""
    signals: dict[str, dict[str, tuple[Array, str]]] = {}
    added: list[tuple[float, float]] = []
    for column, channel in timed.items():
        unit, expected = units[column], SIGNALS[column.signal]
        values = _in_si(channel.channel, column, unit, expected, record) if unit else channel.channel.values
        values = values * column.factor
        _check_size(values, column, channel, unit, record)
        even, between = resampled(channel.time, values, channel.report, clock)
        if between:
            channel.report = replace(channel.report, resampled=True)
            if expected == "m" and channel.report.jitter_peak > UNEVEN * channel.report.period and not channel.is_counted:
                added.append(resampling_error(channel.time, values, channel.report.period))
        signals.setdefault(column.signal, {})[column.axis] = (even, expected or si_unit(unit))
    return signals, [finding("CL437", rms=max(rms for rms, _ in added), largest=max(peak for _, peak in added))] if added else []


def _units(record: Record, given: Columns, guesses: Sequence[Column]) -> tuple[dict[Column, str], list[Column], list[Finding]]:
    """Return the units of columns, the guesses that are left out, and findings.

    Angles and their speeds are left out beside lengths.
    A velocity identified by name is left out if it has no unit or holds words; so is any such column if the user names columns.
    """
    columns = [column for column in (*given.columns, *guesses) if column.signal in SIGNALS]
    channels = {column: record.channel(column.column) for column in columns}
    own = {column: column.unit or channel.unit for column, channel in channels.items()}
    units, shared = dict(own), []
    for column in [column for column in columns if SIGNALS[column.signal] and not own[column]]:
        alike = [other for other in columns if (other.axis, SIGNALS[other.signal]) == (column.axis, SIGNALS[column.signal]) and own[other]]
        if alike:
            units[column] = own[alike[0]]
            shared.append(finding("CL435", signal=column.signal, unit=units[column], other=alike[0].signal))
    usual = given.unit or record.unit
    for column in [column for column in columns if usual and not units[column] and SIGNALS[column.signal] in USUAL]:
        units[column] = usual if SIGNALS[column.signal] == "m" else f"{usual}/s"
        shared += [] if given.unit else [finding("CL438", unit=usual)]
    without = [column for column in columns if SIGNALS[column.signal] and not units[column]]
    is_named = any(column.signal in SIGNALS for column in given.columns)
    doubted = [column for column in guesses if column.signal in SIGNALS and (is_named or SIGNALS[column.signal] != "m")]
    spare = [column for column in doubted if column in without or channels[column].fault is not None]
    lengths = [column for column in columns if SIGNALS[column.signal] in USUAL]
    angles = [column for column in lengths if column in guesses and _ANGLE.match(plain(units[column]))]
    angles = [] if len(angles) == len(lengths) else angles
    if missing := [column for column in without if column not in spare]:
        names = quoted((channels[column].name for column in missing), len(missing))
        these = f"column {names} has" if len(missing) == 1 else f"columns {names} have"
        options = " ".join(f"--column '{c.target}={channels[c].name} [{USUAL.get(SIGNALS[c.signal], SIGNALS[c.signal])}]'" for c in missing)
        at_once = "--unit mm, or " if all(SIGNALS[column.signal] in USUAL for column in missing) else ""
        raise LogError(f"{these} no unit: write {at_once}{options}", file=record.file)
    left_out = [finding("CL436", columns=[channels[column].name for column in spare])] if spare else []
    left_out += [finding("CL442", columns=[channels[column].name for column in angles])] if angles else []
    return units, [*spare, *angles], [*(one for k, one in enumerate(shared) if one not in shared[:k]), *left_out]


def _check_size(values: Array, column: Column, channel: Timed, unit: str, record: Record) -> None:
    """Refuse implausible values: wrong units, wrapped counters, two records. References may jump."""
    si, name = SIGNALS[column.signal], channel.channel.name
    limit, largest = {"m": FARTHEST, "m/s": FASTEST}.get(si, np.inf), float(np.abs(values).max())
    if largest > limit:
        raise LogError(f"column {name!r} reaches {show(largest, si, 4)}, beyond any machine: check the unit {unit}", file=record.file)
    if si != "m" or column.signal == "reference":
        return
    speed = np.abs(np.diff(values)) / np.maximum(np.diff(channel.time), channel.report.period)
    k = int(np.argmax(speed))
    if speed[k] > FASTEST:
        jump = f"goes from {show(values[k], 'mm')} to {show(values[k + 1], 'mm')} at t = {channel.time[k]:.6g} s"
        cure = f"check the unit {unit}, a wrapped counter, or two records"
        raise LogError(f"column {name!r} {jump}, {show(float(speed[k]), 'm/s', 3)}, faster than any machine: {cure}", file=record.file)


def _stacked(values: dict[str, dict[str, tuple[Array, str]]], axes: tuple[str, ...]) -> dict[str, Signal]:
    """Return each signal as (n_sample, n_axis), NaN for axes without it."""
    signals = {}
    for name, by_axis in values.items():
        missing = np.full(next(iter(by_axis.values()))[0].size, np.nan)
        units = {unit for _, unit in by_axis.values()}
        table = np.column_stack([by_axis.get(axis, (missing, ""))[0] for axis in axes])
        signals[name] = Signal(table, ("sample", "axis"), units.pop() if len(units) == 1 else "")
    return signals


@contextmanager
def about(*files: str | os.PathLike[str], options: Container[str] = ()) -> Iterator[None]:
    """Raise errors about samples as `LogError` with the names of the logs.

    Errors that already name a log, or concern an option, pass unchanged.

    Parameters
    ----------
    options : container of str
        Names of parameters that the user sets, with underscores.

    Raises
    ------
    LogError
        In place of the error, with the names.
    """
    try:
        yield
    except (FeedError, GeometryError, ParameterError, ResultError) as error:
        is_an_option = isinstance(error, ParameterError) and (error.name.startswith("--") or error.name == "LOG" or error.name in options)
        if is_an_option or any(re.search(rf"(?<!\w){re.escape(Path(file).name)}(?!\w)", str(error)) for file in files):
            raise
        raise LogError(str(error), file=join_names([*map(str, files)])) from error
