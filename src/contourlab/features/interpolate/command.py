"""``contourlab interpolate``: constants, errors and counts from a file of quadrature signals."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from contourlab.analysis.encoder import (
    EllipseFit,
    QuadratureConstants,
    SinusoidTable,
    Subdivisional,
    Tracked,
    fit_ellipse,
    interpolation_order,
    period_count,
    subdivisional_error,
    track_ellipse,
)
from contourlab.app.json_values import HIDDEN, json_text, signed
from contourlab.app.results import spared, write_together
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.arrays import Array
from contourlab.errors import LogError, ParameterError, ResultError, UnitError
from contourlab.features.interpolate.options import Interpolate
from contourlab.findings import Finding, finding
from contourlab.logs import Channel, Record, read_record
from contourlab.logs.load import about
from contourlab.logs.reading import CUT, lines_in, text_of
from contourlab.rendering.charts import Chart, traces_chart
from contourlab.rendering.style import scheme_style
from contourlab.rendering.table import paragraphs
from contourlab.units import to_si

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FILES = {"counts": "interpolated.csv", "picture": "interpolation.png", "summary": "interpolation.json"}
"""Files written into the folder."""
CONSTANTS = ("offset_1", "offset_2", "amplitude", "ratio", "phase_error")
WEAK = 0.5
"""Share of the amplitude below which a signal is weak."""
POINTS = 6000
"""Most points of the signals in the picture."""


@dataclass(frozen=True, eq=False)
class Interpolated(Answer):
    """Interpolated signals of an encoder; as JSON field by field, in SI.

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
    interpolation: Interpolation = field(kw_only=True, repr=False, metadata=HIDDEN)

    @property
    def passed(self) -> bool:
        """Whether no period was missed."""
        return not self.missed["n_sample"]

    @property
    def text(self) -> str:
        """The result for the terminal."""
        return "\n".join(paragraphs([f"  {name:<22}{value}"], indent=" " * 24) if name else value for name, value in _rows(self))

    def _charts(self) -> Iterator[Chart]:
        phase, *errors = self.interpolation.over_phase()
        yield error_chart(self.file, phase, dict(zip(_labels(self), errors, strict=True)))

    def save(self, folder: str | Path | None = "interpolated") -> Interpolated:
        """Write interpolated.csv, interpolation.json and interpolation.png into a folder; all or none.

        Parameters
        ----------
        folder : str or Path, optional
            None writes nothing.

        Returns
        -------
        Interpolated
            With the names of its files.

        Raises
        ------
        OutputError
            If a result cannot be written; then nothing is written.
        """
        if folder is None:
            return self
        saved = replace(self, files={key: str(Path(folder) / name) for key, name in FILES.items()})
        contents: dict[str, str | bytes] = {"counts": _table(self), "picture": _picture(self), "summary": signed(json_text(saved)) + "\n"}
        write_together({Path(saved.files[key]): content for key, content in contents.items()})
        return saved

    def _next(self, asked: Asked) -> Sequence[object]:
        """Save the counts, or use the encoder."""
        return ["components", "quadrature-encoder"] if self.files else asked.again("--out", "interpolated")


@question(Interpolate)
def interpolate(file: str | Path, *, settings: Interpolate, session: Session = QUIET) -> Interpolated:
    """Correct, interpolate and count quadrature signals, and measure their errors.

    Parameters
    ----------
    file : str or Path
        A table of numbers; see `contourlab.logs.delimited.read`.

    Returns
    -------
    Interpolated

    Raises
    ------
    LogError, ResultError
        If the file has no quadrature signals, or they do not form an ellipse; with the line if known.
    ParameterError, UnitError
        If pitch, resolution or forgetting are out of range.
    """
    period = settings.si("pitch")
    order = interpolation_order(period, settings.si("resolution"))
    if session.saving.get("out") is not None:
        for name in FILES.values():
            spared(session.folder / name, [file])
    record = read_quadrature(file, settings.columns, settings.reference)
    with about(record.source.file, options=("forgetting",)):
        interpolation = Interpolation(record, period, order, settings.forgetting)
    before, after = interpolation.subdivisional()
    tracked, counts, constants = interpolation.tracked, interpolation.counted.counts, interpolation.constants
    marked = np.flatnonzero(interpolation.missed)
    first_line = line_of(record.source, int(marked[0])) if marked.size else None
    weak = int(np.count_nonzero(np.hypot(*interpolation.after)[interpolation.settled :] < WEAK))
    conditions = {
        "CL450": first_line is not None,
        "CL451": weak > 0,
        "CL452": before is None or after is None,
        "CL453": record.reference is None,
        "CL454": interpolation.settled > 0,
    }
    values: dict[str, Any] = {"samples": int(marked.size), "line": first_line, "weak": weak, "settled": interpolation.settled}
    return Interpolated(
        file=str(record.source.file),
        n_sample=int(counts.size),
        columns=record.names,
        pitch=period,
        resolution=interpolation.resolution,
        order=order,
        method="all samples" if tracked is None else "recursive",
        forgetting=settings.forgetting,
        updates=None if tracked is None else int(tracked.updated.sum()),
        settled_from_sample=interpolation.settled,
        constants={**{name: getattr(constants, name) for name in CONSTANTS}, "unit": record.unit},
        scatter=interpolation.fit.scatter,
        subdivisional_error={
            "against": "shape" if record.reference is None else "reference",
            "before": _figures(before),
            "after": _figures(after),
        },
        counts={"first": int(counts[0]), "last": int(counts[-1]), "least": int(counts.min()), "greatest": int(counts.max())},
        travel=float(np.ptp(counts)) * interpolation.resolution,
        fastest=float(np.abs(np.diff(counts, prepend=counts[:1])).max()) / (4 * order),
        missed={"n_sample": int(marked.size), "first_line": first_line},
        weak_samples=weak,
        findings=tuple(finding(code, **values) for code, holds in conditions.items() if holds),
        interpolation=interpolation,
    )


def _figures(error: Subdivisional | None) -> dict[str, Any] | None:
    return None if error is None else {"peak": error.peak, "orders": list(error.orders), "rest_rms": error.rest}


def _rows(r: Interpolated) -> Iterator[tuple[str, str]]:
    constants, errors, counts = r.constants, r.subdivisional_error, r.counts
    unit = f" {constants['unit']}".rstrip()
    yield "", f"{r.file}: {r.n_sample} samples of {' and '.join(r.columns)}"
    yield "pitch", f"{1e6 * r.pitch:.6g} um; travel {r.travel / r.pitch:.5g} pitches ({1e3 * r.travel:.6g} mm)"
    yield "resolution", f"{1e9 * r.resolution:.6g} nm: {r.order} sine periods per pitch, counted fourfold"
    if r.method == "recursive":
        yield "fit", f"recursive, forgetting {r.forgetting:g}, {r.updates} updates; final constants:"
    else:
        yield "fit", "one ellipse through all samples:"
    yield "  offsets", f"{constants['offset_1']:.5g} and {constants['offset_2']:.5g}{unit}"
    yield "  amplitude", f"{constants['amplitude']:.5g}{unit}, {constants['ratio']:.6g} times that of the second signal"
    yield "  phase error", f"{math.degrees(constants['phase_error']):.4g} deg"
    yield "  scatter", f"{100.0 * r.scatter:.3g} % of the radius, rms around the ellipse through all samples"
    for name in ("before", "after"):
        if (error := errors[name]) is not None:
            orders = ", ".join(f"{1e9 * value:.3g}" for value in error["orders"][:4])
            yield f"error {name}", f"{1e9 * error['peak']:.4g} nm peak within a pitch; orders 1 to 4 of a pitch: {orders} nm"
    yield "counts", f"from {counts['first']} to {counts['last']}, smallest {counts['least']}, largest {counts['greatest']}"
    yield "fastest", f"{r.fastest:.3g} pitches per sample; counting works up to 0.5"
    for file in r.files.values():
        yield "written", file
    if r.findings:
        yield "", paragraphs(map(str, r.findings))


def _table(r: Interpolated) -> str:
    """Return the table of counts and positions, with pitch and constants in its head."""
    counts, time = r.interpolation.counted.counts, r.interpolation.record.time
    constants = ", ".join(f"{name} {value!r}" for name, value in r.constants.items() if name != "unit")
    unit = f" ({r.constants['unit']})" if r.constants["unit"] else ""
    head = [f"# pitch {r.pitch:.12g} m, resolution {r.resolution:.12g} m, fit: {r.method}", f"# {constants}{unit}"]
    rows = [f"{n},{x:.12g}" for n, x in zip(counts.tolist(), (r.resolution * counts).tolist(), strict=True)]
    if time is not None:
        rows = [f"{t:.12g},{row}" for t, row in zip(time.tolist(), rows, strict=True)]
    return "\n".join([*head, "count,position [m]" if time is None else "t [s],count,position [m]", *rows]) + "\n"


def _labels(r: Interpolated) -> list[str]:
    """Return the names of the errors before and after correction, with their peaks."""
    known = r.subdivisional_error["against"] == "reference"
    labels = {"before": "before" if known else "before, by the fitted constants", "after": "after" if known else "after, off the circle"}
    for key, label in labels.items():
        if error := r.subdivisional_error[key]:
            labels[key] = f"{label}: {1e9 * error['peak']:.3g} nm peak"
    return list(labels.values())


def _picture(r: Interpolated) -> bytes:
    """Return the signals against each other before and after correction, and the error over a period."""
    interpolation = r.interpolation
    signals = interpolation.before.T, interpolation.after[:, interpolation.settled :].T
    return lissajous_png(interpolation.record.source.file.name, signals, *r._charts())


def error_chart(title: str, phase: Array, errors: Mapping[str, Array]) -> Chart:
    """Return errors (m,) [nm] by name, over the phase (m,) [deg]."""
    curves = {name: (phase, error) for name, error in errors.items()}
    return traces_chart("error", title, ("phase [deg]", "error within a pitch [nm]"), curves, level=None)


def lissajous_png(title: str, signals: Sequence[Array], errors: Chart) -> bytes:
    """Return the picture as a PNG of 200 dpi; equal data give equal bytes.

    Parameters
    ----------
    title : str
    signals : sequence of ndarray (n, 2)
        As measured, and corrected; both divided by the amplitude.
    errors : Chart
        Over the phase, before and after correction.
    """
    from contourlab.rendering.matplotlib_view import draw_chart, escaped, legend, new_figure, picture_bytes

    def drawn() -> Figure:
        figure = new_figure(3.6)
        left, right = figure.subplots(1, 2, width_ratios=(1.0, 1.25))
        every = max(1, len(signals[0]) // POINTS)
        turn = np.linspace(0.0, 2.0 * np.pi, 361)
        left.plot(np.cos(turn), np.sin(turn), color="#8a949e", linewidth=0.8)
        for i, points in enumerate(signals):
            style = {"linestyle": "none", "marker": ".", "markersize": 1.6, "color": scheme_style(i, 2)[0]}
            left.plot(points[::every, 0], points[::every, 1], **style)
        left.set_aspect("equal", adjustable="datalim")
        left.set(xlabel="u1 / amplitude", ylabel="u2 / amplitude", title=escaped(title))
        draw_chart([errors], place=right).set(xlim=(0.0, 360.0), xticks=range(0, 361, 90))
        legend(figure, 2)
        return figure

    return picture_bytes(drawn, "png")[0]


# --- the signals of a file, their correction and their errors ---


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
