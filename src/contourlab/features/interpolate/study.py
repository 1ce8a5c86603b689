"""Quadrature signals from a text file of numbers: counts, and the errors within a pitch before and after the correction."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

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
from contourlab.findings import Finding, finding
from contourlab.logs import Channel, Record, read_record
from contourlab.logs.reading import CUT, lines_in, text_of
from contourlab.units import to_si

WEAK = 0.5
"""Share of the amplitude below which a signal is weak."""
SCALE = 0.01
"""Largest relative difference between the travels of signals and reference; beyond it the pitch is wrong."""
SETTLING = 2.0
"""Settling time of the recursive fit in memory lengths, 1/(1 - lambda) updates each."""
BINS = 180
CONSTANTS = ("offset_1", "offset_2", "amplitude", "ratio", "phase_error")


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
    first, second = _signals(record, columns)
    if first is second:
        raise LogError(f"column {first.name} is given twice: an encoder has two signals", file=record.file)
    if first.unit != second.unit:
        units = f"{first.name} is in {first.unit or 'no unit'}, {second.name} in {second.unit or 'no unit'}"
        raise LogError(units, file=record.file)
    known = {channel.name.lower(): channel for channel in record.channels}
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


def _signals(record: Record, columns: str | None) -> tuple[Channel, Channel]:
    if columns is not None:
        names = columns.split(",")
        if len(names) != 2:
            raise LogError(f"{columns}: two names separated by a comma, the cosine first, such as u1,u2", file="--columns")
        return _column(record, names[0]), _column(record, names[1])
    known = {channel.name.lower(): channel for channel in record.channels}
    for cosine, sine in PAIRS:
        if cosine in known and sine in known:
            return known[cosine], known[sine]
    if len(record.channels) == 2:
        return record.channels[0], record.channels[1]
    raise LogError(f"unknown signal columns: give --columns u1,u2; there are: {', '.join(record.names)}", file=record.file)


def _column(record: Record, name: str) -> Channel:
    """Return a column by its name (case is ignored) or its number (from 1)."""
    wanted = name.strip().lower()
    for channel in record.channels:
        if channel.name.lower() == wanted:
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


@dataclass(frozen=True)
class Interpolated:
    """The result; as JSON field by field, in SI.

    Attributes
    ----------
    columns : (str, str)
    pitch, resolution : float [m]
    order : int
        Order of the sinusoids.
    method : str
        ``"all samples"`` or ``"recursive"``.
    updates : int or None
        Number of updates of the recursive fit.
    constants : dict
        Offsets, amplitude, ratio and phase error; with their unit.
    scatter : float
        Scatter around the ellipse, relative to its radius.
    subdivisional_error : dict
        ``against``: "reference" or "shape". Errors ``before`` and ``after``: peak, orders and rest [m]; None if unknown.
    travel : float [m]
    fastest : float
        Largest travel from one sample to the next [pitches].
    missed : dict
        Number of samples at which a period was missed, and the line of the first.
    files : dict of str to str
        Files that were written.
    """

    file: str
    n_sample: int
    columns: tuple[str, str]
    pitch: float
    resolution: float
    order: int
    method: str
    forgetting: float | None
    updates: int | None
    settled_from_sample: int
    constants: dict[str, Any]
    scatter: float
    subdivisional_error: dict[str, Any]
    counts: dict[str, int]
    travel: float
    fastest: float
    missed: dict[str, int | None]
    weak_samples: int
    findings: tuple[Finding, ...]
    files: dict[str, str] = field(default_factory=dict)


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

    def position(self) -> Array:
        """Return the position [m]."""
        return np.asarray(self.resolution * self.counted.counts, dtype=np.float64)

    def over_phase(self) -> tuple[Array, Array, Array]:
        """Return phases [deg], and the mean errors before and after correction at these phases [nm]."""
        centre = (np.arange(BINS) + 0.5) * 360.0 / BINS
        part = slice(self.settled, None)
        if self.record.reference is not None and self.errors is not None:
            turns = self.record.reference / self.pitch
            return centre, _binned(turns, self.errors[0]), _binned(turns[part], self.errors[1][part])
        length = self.pitch / (2.0 * np.pi)
        turns = np.arctan2(self.after[1], self.after[0]) / (2.0 * np.pi)
        implied = _binned(centre / 360.0, self.fit.constants.error_without(np.radians(centre)) * length)
        return centre, implied, _binned(turns[part], self._radius()[part] * length)

    def _subdivisional(self) -> tuple[Subdivisional | None, Subdivisional | None]:
        """Return the error that repeats with the pitch, before and after correction; None if the record is too short."""
        part = slice(self.settled, None)
        try:
            if self.record.reference is not None and self.errors is not None:
                phase = 2.0 * np.pi / self.pitch * self.record.reference
                return subdivisional_error(self.errors[0], phase), subdivisional_error(self.errors[1][part], phase[part])
            turns = np.arctan2(self.after[1], self.after[0]) / (2.0 * np.pi)
            phase = 2.0 * np.pi * (turns + period_count(turns)[0])
            return self._implied(), subdivisional_error(self._radius()[part] * self.pitch / (2.0 * np.pi), phase[part])
        except ParameterError:
            return (None if self.record.reference is not None else self._implied()), None

    def _radius(self) -> Array:
        """Return the relative deviation of the corrected signals from their circle."""
        radius = np.hypot(*self.after)
        return np.asarray(radius / np.median(radius) - 1.0, dtype=np.float64)

    def _implied(self) -> Subdivisional:
        """Return the error that follows from the constants."""
        phase = np.linspace(0.0, 12.0 * np.pi, 4320, endpoint=False)
        return subdivisional_error(self.fit.constants.error_without(phase) * self.pitch / (2.0 * np.pi), phase)

    def result(self) -> Interpolated:
        """Return the result."""
        record, counts = self.record, self.counted.counts
        before, after = self._subdivisional()
        marked = np.flatnonzero(self.missed)
        first_line = line_of(record.source, int(marked[0])) if marked.size else None
        weak = int(np.count_nonzero(np.hypot(*self.after)[self.settled :] < WEAK))
        conditions = {
            "CL450": first_line is not None,
            "CL451": weak > 0,
            "CL452": before is None or after is None,
            "CL453": record.reference is None,
            "CL454": self.settled > 0,
        }
        values: dict[str, Any] = {"samples": int(marked.size), "line": first_line, "weak": weak, "settled": self.settled}
        return Interpolated(
            file=str(record.source.file),
            n_sample=int(counts.size),
            columns=record.names,
            pitch=self.pitch,
            resolution=self.resolution,
            order=self.order,
            method="all samples" if self.tracked is None else "recursive",
            forgetting=self.forgetting,
            updates=None if self.tracked is None else int(self.tracked.updated.sum()),
            settled_from_sample=self.settled,
            constants={**{name: getattr(self.constants, name) for name in CONSTANTS}, "unit": record.unit},
            scatter=self.fit.scatter,
            subdivisional_error={
                "against": "shape" if record.reference is None else "reference",
                "before": _figures(before),
                "after": _figures(after),
            },
            counts={"first": int(counts[0]), "last": int(counts[-1]), "least": int(counts.min()), "greatest": int(counts.max())},
            travel=float(np.ptp(counts)) * self.resolution,
            fastest=float(np.abs(np.diff(counts, prepend=counts[:1])).max()) / (4 * self.order),
            missed={"n_sample": int(marked.size), "first_line": first_line},
            weak_samples=weak,
            findings=tuple(finding(code, **values) for code, holds in conditions.items() if holds),
        )


def _figures(error: Subdivisional | None) -> dict[str, Any] | None:
    return None if error is None else {"peak": error.peak, "orders": list(error.orders), "rest_rms": error.rest}


def _binned(turns: Array, error: Array) -> Array:
    """Return the mean error [nm] in each bin of a turn, for an error [m], minus the mean of all bins; nan for an empty bin."""
    place = np.clip(((turns - np.floor(turns)) * BINS).astype(np.int64), 0, BINS - 1)
    number = np.bincount(place, minlength=BINS)
    total = np.bincount(place, weights=error, minlength=BINS)
    mean = np.where(number > 0, total / np.maximum(number, 1), np.nan)
    return np.asarray(1e9 * (mean - np.nanmean(mean)), dtype=np.float64)
