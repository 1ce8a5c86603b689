"""Quadrature signals from a text file of numbers: counts, and the errors within a pitch before and after the correction."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from contourlab.analysis.encoder import (
    EllipseFit,
    QuadratureConstants,
    SinusoidTable,
    Subdivisional,
    Tracked,
    fit_ellipse,
    period_count,
    subdivisional_error,
    track_ellipse,
)
from contourlab.arrays import Array
from contourlab.errors import LogError, ParameterError, ResultError, UnitError
from contourlab.logs import Channel, Record, read_record
from contourlab.logs.reading import CUT, lines_in, text_of
from contourlab.units import to_si

SCALE = 0.01
"""Largest relative difference between the travels of signals and reference; beyond it the pitch is wrong."""
SETTLING = 2.0
"""Settling time of the recursive fit in memory lengths, 1/(1 - lambda) updates each."""
BINS = 180

PAIRS = (("u1", "u2"), ("cos", "sin"), ("a", "b"))
"""Names of signals that are found without an option, the cosine first."""
TIMES = ("t", "time")
REFERENCE = "reference"


@dataclass(frozen=True, eq=False)
class QuadratureRecord:
    """The signals of a file.

    Attributes
    ----------
    names : (str, str)
        Names of the signals, the cosine first.
    unit : str
        Unit of the signals, as in the file.
    u1, u2 : ndarray (n,)
        Signals in that unit.
    time : ndarray (n,) [s] or None
    reference : ndarray (n,) [m] or None
        True position.
    """

    source: Record
    names: tuple[str, str]
    unit: str
    u1: Array
    u2: Array
    time: Array | None
    reference: Array | None
    reference_name: str


def read_quadrature(file: str | Path, columns: str | None = None, reference: str | None = None) -> QuadratureRecord:
    """Read quadrature signals.

    Parameters
    ----------
    file : str or Path
        A table of numbers; see `contourlab.logs.delimited.read`.
    columns : str, optional
        Names or numbers of the signals, ``"u1,u2"``; by default u1 and u2, cos and sin, a and b, or the only two columns.
    reference : str, optional
        Column of the true position; by default "reference", if present.

    Raises
    ------
    LogError
        If a column is missing or cannot be read; with the line.
    """
    record = read_record(file, "csv")
    known = {channel.name.lower(): channel for channel in record.channels}
    names = columns.split(",") if columns is not None else next((pair for pair in PAIRS if known.keys() >= set(pair)), ())
    if columns is not None and len(names) != 2:
        raise LogError(f"{columns}: two names separated by a comma, the cosine first, such as u1,u2", file="--columns")
    if not names and len(record.channels) != 2:
        raise LogError(f"unknown signal columns: give --columns u1,u2; there are: {', '.join(record.names)}", file=record.file)
    first, second = (_column(record, name) for name in names) if names else record.channels
    if first is second:
        raise LogError(f"column {first.name} is given twice: an encoder has two signals", file=record.file)
    if first.unit != second.unit:
        units = f"{first.name} is in {first.unit or 'no unit'}, {second.name} in {second.unit or 'no unit'}"
        raise LogError(units, file=record.file)
    true = _column(record, reference) if reference is not None else known.get(REFERENCE)
    clock = next((known[name] for name in TIMES if name in known), None)
    for channel in (first, second, clock, true):
        if channel is not None and channel.fault is not None:
            raise channel.fault
        if channel is not None and not np.isfinite(channel.values).all():
            sample = int(np.argmin(np.isfinite(channel.values)))
            raise LogError(f"column {channel.name} has no finite number here", file=record.file, line=line_of(record, sample))
    return QuadratureRecord(
        record,
        (first.name, second.name),
        first.unit,
        first.values,
        second.values,
        None if clock is None else clock.values * (_factor(record, clock, "s") if clock.unit else 1.0),
        None if true is None else true.values * _factor(record, true, "m"),
        "" if true is None else true.name,
    )


def line_of(record: Record, sample: int) -> int:
    """Return the line number (from 1) of a sample (from 0)."""
    lines = [i for i, line in lines_in(text_of(record.file), record.file) if line.strip()[0] not in "#%"]
    return lines[len(lines) - len(record.channels[0].values) - (CUT in record.findings) + sample]


def _column(record: Record, name: str) -> Channel:
    """Return a column by its name (case is ignored) or its number (from 1)."""
    wanted = name.strip().lower()
    if (channel := next((channel for channel in record.channels if channel.name.lower() == wanted), None)) is not None:
        return channel
    if wanted.isdecimal() and 1 <= int(wanted) <= len(record.channels):
        return record.channels[int(wanted) - 1]
    raise LogError(f"no column {name!r}; there are: {', '.join(record.names)}", file=record.file)


def _factor(record: Record, channel: Channel, unit: str) -> float:
    """Return the size of a column's unit in SI."""
    if not channel.unit:
        example = f"{channel.name} [{unit}]"
        raise LogError(f"column {channel.name} has no unit: write it in the header, such as {example}", file=record.file)
    try:
        return to_si(f"1 {channel.unit}", unit)
    except UnitError as error:
        raise LogError(f"column {channel.name}: {error}", file=record.file) from error


class Interpolation:
    """Interpolate a record: counts, errors and missed periods.

    Parameters
    ----------
    pitch : float [m]
    order : int
        The resolution is the pitch over four times the order.
    forgetting : float, optional
        Forgetting factor of the recursive fit; by default one ellipse is fitted to all samples.

    Raises
    ------
    ParameterError
        If the signals do not form an ellipse.
    ResultError
        If the reference contradicts the pitch or the order of the signals.
    """

    def __init__(self, record: QuadratureRecord, pitch: float, order: int, forgetting: float | None) -> None:
        self.record, self.pitch, self.order, self.forgetting = record, pitch, order, forgetting
        self.resolution = pitch / (4 * order)
        self.fit: EllipseFit = fit_ellipse(record.u1, record.u2)
        size = self.fit.constants.amplitude
        self.tracked: Tracked | None = None
        self.constants: QuadratureConstants = self.fit.constants
        if forgetting is None:
            self.after = np.stack(self.constants.corrected(record.u1, record.u2)) / size
        else:
            self.tracked = track_ellipse(record.u1, record.u2, QuadratureConstants(amplitude=size), forgetting=forgetting)
            self.constants = self.tracked.constants()
            self.after = np.stack([self.tracked.u1, self.tracked.u2])
        self.before = np.stack([record.u1, record.u2]) / size
        table = SinusoidTable(order)
        self.counted, self.uncorrected = table.count(*self.after), table.count(*self.before)
        self.settled = self._settled()
        self.missed = self.counted.missed.copy()
        self.errors = None if record.reference is None else self._against_reference(record.reference)

    def _settled(self) -> int:
        """Return the first sample for judging the recursive fit; 0 if less than a quarter of the record would remain."""
        if self.tracked is None or self.forgetting is None:
            return 0
        updates = int(min(SETTLING / max(1.0 - self.forgetting, 1e-4), 1e9))
        reached = np.flatnonzero(np.cumsum(self.tracked.updated) >= updates)
        size = self.record.u1.size
        return int(reached[0]) if reached.size and size - int(reached[0]) >= size // 4 else 0

    def _against_reference(self, true: Array) -> tuple[Array, Array]:
        """Return the position errors before and after correction, whole pitches removed; set `missed`."""
        moved = np.abs(np.diff(true, prepend=true[:1]))
        travel = float(np.ptp(true))
        if 2.0 * float(moved.max()) < self.pitch and travel > 2.0 * self.pitch:
            slope = float(np.polyfit(true - true.mean(), self.resolution * self.counted.counts, 1)[0])
            place = f"{self.record.source.file}: the signals travel {slope:.4g} times {self.record.reference_name}"
            if slope < 0.0:
                raise ResultError(f"{place}: they are in the wrong order: give --columns {self.record.names[1]},{self.record.names[0]}")
            if abs(slope - 1.0) > SCALE:
                raise ResultError(f"{place}: a pitch of {self.pitch / slope * 1e6:.4g} um would fit, not {self.pitch * 1e6:.4g} um")
        errors = []
        for counted in (self.uncorrected, self.counted):
            off = self.resolution * counted.counts - true
            whole = np.rint(np.diff(off, prepend=off[:1]) / self.pitch)
            if counted is self.counted:
                self.missed = whole != 0.0  # the reference is more reliable than the speed of the signals
            errors.append(off - self.pitch * np.cumsum(whole))
        return errors[0], errors[1]

    @cached_property
    def within_pitch(self) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        """Phases [rad] with the errors there [m], before and after correction.

        Against the reference; without one the error that the constants imply, and the distance of the corrected signals from their circle.
        """
        part = slice(self.settled, None)
        if self.record.reference is not None and self.errors is not None:
            phase = 2.0 * np.pi / self.pitch * self.record.reference
            return (phase, self.errors[0]), (phase[part], self.errors[1][part])
        implied = np.linspace(0.0, 12.0 * np.pi, 4320, endpoint=False)
        turns, radius = np.arctan2(self.after[1], self.after[0]) / (2.0 * np.pi), np.hypot(*self.after)
        phase = 2.0 * np.pi * (turns + period_count(turns)[0])
        off = (radius / np.median(radius) - 1.0) * self.pitch / (2.0 * np.pi)
        return (implied, self._implied(implied)), (phase[part], off[part])

    def _implied(self, phase: Array) -> Array:
        """Return the error [m] that follows from the constants."""
        return np.asarray(self.fit.constants.error_without(phase) * self.pitch / (2.0 * np.pi))

    def over_phase(self) -> tuple[Array, Array, Array]:
        """Return phases [deg], and the mean errors before and after correction at these phases [nm]."""
        centre = (np.arange(BINS) + 0.5) * 360.0 / BINS
        before, after = self.within_pitch
        if self.record.reference is None:
            before = np.radians(centre), self._implied(np.radians(centre))
        return centre, _binned(*before), _binned(*after)

    def subdivisional(self) -> tuple[Subdivisional | None, Subdivisional | None]:
        """Return the error that repeats with the pitch, before and after correction; None if the record is too short."""
        (phase, before), (settled, after) = self.within_pitch
        known = None
        try:
            known = subdivisional_error(before, phase)
            return known, subdivisional_error(after, settled)
        except ParameterError:
            return None if self.record.reference is not None else known, None


def _binned(phase: Array, error: Array) -> Array:
    """Return the mean error [nm] in each bin of a turn, for an error [m], minus the mean of all bins; nan for an empty bin."""
    turns = phase / (2.0 * np.pi)
    place = np.clip(((turns - np.floor(turns)) * BINS).astype(np.int64), 0, BINS - 1)
    number = np.bincount(place, minlength=BINS)
    total = np.bincount(place, weights=error, minlength=BINS)
    mean = np.where(number > 0, total / np.maximum(number, 1), np.nan)
    return np.asarray(1e9 * (mean - np.nanmean(mean)), dtype=np.float64)
