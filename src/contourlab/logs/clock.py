"""Check the sample times of channels, and resample all channels onto one even clock."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.errors import LogError, refuse
from contourlab.findings import Finding, finding
from contourlab.logs.window import FEW, between_gaps
from contourlab.units import show

GAP = 1.5
"""Longest step without missing samples, in periods."""
SHORT = 0.75
"""Steps below, in periods, show that times jitter."""
MOST_MISSING = 0.05
"""Largest accepted share of missing samples."""
EVEN = 1e-3
"""Jitter over period below which samples are even: times are rounded when written."""
UNEVEN = 0.1
"""Jitter over period above which the error of resampling is stated."""
WINDOW, NEAR = 250, 15
"""Samples over which period and phase of a jittering clock are found, and over which its lost samples must agree."""
REPEATS = 3
"""Times that samples are assigned to periods again after a fit."""
LEAST = 95
"""Fewest samples that tell lost samples from jitter: 100, of which 5 % are lost."""
PHASES = np.arange(16) / 16
"""Phases of a clock that are tried, in periods."""


@dataclass(frozen=True)
class Gap:
    """Missing samples.

    Attributes
    ----------
    time : float [s]
        Of the sample before.
    missing : int
        How many.
    """

    time: float
    missing: int


@dataclass(frozen=True)
class ClockReport:
    """Regularity of the times of a channel.

    Attributes
    ----------
    period : float [s]
        Sample period.
    n_sample : int
    jitter_rms, jitter_peak : float [s]
        Deviation from an even clock between gaps.
    gaps : tuple of Gap
    repeated : int
        Omitted samples, which repeat the time before.
    resampled : bool
        Whether values were interpolated.
    windows : tuple of str
        The parts between its gaps, as options to type.
    """

    json_derived: ClassVar = ("missing",)

    period: float
    n_sample: int
    jitter_rms: float
    jitter_peak: float
    gaps: tuple[Gap, ...] = ()
    repeated: int = 0
    resampled: bool = False
    windows: tuple[str, ...] = ()

    @property
    def missing(self) -> int:
        """Number of samples that are missing."""
        return sum(gap.missing for gap in self.gaps)

    def findings(self, period: float | None = None, place: str = "") -> list[Finding]:
        """Return the findings on uneven times; none for an even clock.

        Parameters
        ----------
        period : float [s], optional
            Period of the common clock; by default the channel's own.
        place : str
            Names of the channels.
        """
        samples, clock = self.n_sample + self.missing, self.period if period is None else period
        rows = (
            (self.jitter_peak > EVEN * self.period, "CL426", {"rms": self.jitter_rms, "peak": self.jitter_peak}),
            (self.gaps, "CL427", {"missing": self.missing, "samples": samples, "gaps": self._gaps(), "windows": self.windows}),
            (self.repeated, "CL428", {"samples": self.repeated}),
            (self.resampled, "CL429", {"own": self.period, "clock": clock}),
        )
        return [finding(code, place, **values) for is_so, code, values in rows if is_so]

    def _gaps(self) -> str:
        """Describe the number of gaps and the longest one."""
        worst = max(self.gaps, key=lambda gap: gap.missing, default=Gap(0.0, 0))
        end = worst.time + (worst.missing + 1) * self.period
        longest = f"{worst.missing} from t = {worst.time:.6g} s to {end:.6g} s"
        return f"in 1 gap of {longest}" if len(self.gaps) == 1 else f"in {len(self.gaps)} gaps; the longest of {longest}"


def look_at_clock(
    time: Array, name: str, file: Path, period: float | None = None, *, rows: Index | None = None, start: float = 0.0
) -> tuple[ClockReport, Flags]:
    """Return the clock report of a channel, and a mask of the samples to keep.

    Parameters
    ----------
    time : ndarray (n,) [s]
    name : str
        Name of the channel, for messages.
    period : float [s], > 0, optional
        Stated period; by default that of the line through the times.
    rows : ndarray (n,) of int, optional
        Numbers of the samples in the file, in which windows are printed; by default windows are in times.
    start : float [s]
        Time from which windows count.

    Raises
    ------
    LogError
        If there are fewer than three samples, a time is not finite or goes back, too many times repeat, the period does not fit the
        times, or too many samples are missing.
    """
    kept = _kept(time, name, file, rows)
    even = time[kept]
    step = np.diff(even)
    usual = float(np.median(step))
    if period is not None:
        if period > GAP * usual:
            apart = f"the times of {name!r} are {show(usual, 'us')} apart, but the given period is {show(period, 'us')}"
            raise LogError(f"{apart}: correct the period, or leave it out", file=file)
        usual = period
    wide = step > GAP * usual
    count = np.where(wide, np.maximum(np.rint(step / usual), 1.0), 1.0)
    # A lost sample makes a long step; jitter makes short ones as well.
    if even.size >= LEAST and wide.any() and (step < SHORT * usual).any():
        count = _jittering_count(even, period)
    lost = [(int(k), int(count[k]) - 1) for k in np.flatnonzero(count > 1.0)]
    gaps = tuple(Gap(float(even[k]), missing) for k, missing in lost)
    windows = between_gaps(lost, even, None if rows is None else rows[kept], start) if lost else ()
    if period is None:
        usual = _period(even, count)
    jitter = _jitter(even, count, usual)
    rms, peak = float(np.sqrt(np.mean(jitter**2))), float(np.abs(jitter).max())
    report = ClockReport(usual, even.size, rms, peak, gaps, int((~kept).sum()), windows=windows)
    if report.missing > MOST_MISSING * (report.n_sample + report.missing):
        share = f"{report.missing} of {report.n_sample + report.missing} samples of {name!r}"
        # A few gaps are lost samples; many mean a wrong clock.
        cut = f"cut the log there{', with ' if windows else ''}{' or '.join(windows)}"
        cure = cut if len(report.gaps) <= FEW else "check the period; the sampling may be uneven"
        raise LogError(f"{share} are missing at a period of {show(usual, 'us')}, {report._gaps()}: {cure}", file=file)
    return report, kept


def _kept(time: Array, name: str, file: Path, rows: Index | None) -> Flags:
    """Return a mask of the samples later than the one before; refuse times that go back, stand still or are not finite."""
    if not np.isfinite(time).all():
        raise LogError(f"the time of {name!r} is not finite at sample {int(np.argmin(np.isfinite(time)))}: delete or correct it", file=file)
    step = np.diff(time)
    if (step < 0.0).any():
        k = int(np.argmax(step < 0.0))
        where = f"from {time[k]:.9g} s to {time[k + 1]:.9g} s at sample {k + 1} ({name!r})"
        parts = "" if rows is None or rows[k] < 2 else f' (--window "..{rows[k]}" reads the first)'
        raise LogError(f"time goes back {where}: check for two records in one file{parts}, or a column that is not the time", file=file)
    kept = np.append(True, step > 0.0)
    n = int(np.count_nonzero(kept))
    refuse(n < 3, LogError, f"has too few samples of {name!r} at different times, {n}: at least three are needed", file=file)
    if repeats_too_often(time):
        count = f"{time.size - n} of {time.size} samples of {name!r}"
        raise LogError(f"{count} repeat the previous time: write the times with more digits", file=file)
    return np.asarray(kept)


def repeats_too_often(time: Array) -> bool:
    """Tell whether too many times (n,) repeat the one before to show the sampling."""
    return bool(np.count_nonzero(np.diff(time) == 0.0) > MOST_MISSING * time.size)


def _jittering_count(time: Array, period: float | None) -> Array:
    """Return the periods between samples (n - 1,) whose times jitter by up to about half a period.

    Lost samples do not change the phase of the clock. It is found over many samples, and may drift slowly.
    """
    from scipy.ndimage import median_filter, uniform_filter1d

    n, size = time.size, min(WINDOW, time.size)
    if period is None:
        usual = float(np.median(np.diff(time)))
        starts = np.linspace(0, n - size, min(3, n // size)).astype(int)
        period = float(np.median([_jittering_period(time[first : first + size], usual) for first in starts]))
    turns = (time - time[0]) / period
    # The more uneven the steps at a phase, the nearer to it the edges of the jitter: the clock is opposite.
    uneven = sum(_uneven(turns - phase) * np.exp(2j * np.pi * phase) for phase in PHASES)
    total = np.append(0.0, np.cumsum(np.append(uneven, 0.0)))
    places = np.arange(n)
    around = total[np.minimum(places + size // 2, n)] - total[np.maximum(places - size // 2, 0)]
    phase = np.unwrap(np.angle(-around)) / (2.0 * np.pi)
    for _ in range(REPEATS):
        phase = uniform_filter1d(turns - np.rint(turns - phase), size // 2)
    lost = np.maximum.accumulate(median_filter(np.rint(turns - phase) - places, NEAR, mode="nearest"))
    return np.asarray(1.0 + np.diff(lost))


def _jittering_period(time: Array, usual: float) -> float:
    """Return the period [s] near `usual` whose best phase leaves the fewest uneven steps, fitted to the times."""
    turns = time - time[0]
    # Lost samples lengthen the median of the steps. A grid point is at most a twentieth of a period off at the last sample.
    periods = usual * np.arange(0.8, 1.08, 0.1 / time.size)
    counts = np.array([_uneven(turns / period - PHASES[:, None]).sum(-1) for period in periods])
    best, phase = np.unravel_index(np.argmin(counts), counts.shape)
    index = np.rint(turns / periods[best] - PHASES[phase])
    for _ in range(REPEATS):
        slope, start = np.polyfit(index, turns, 1)
        index = np.rint((turns - start) / slope)
    return float(slope)


def _uneven(turns: Array) -> Array:
    """Return the cost of the steps (..., n - 1) between times in periods: 1 if samples are lost, 3 if two share a period, else 0."""
    step = np.diff(np.rint(turns))
    return np.where(step < 1.0, 3.0, step > 1.0)


def counted_times(time: Array, report: ClockReport) -> Array:
    """Return the times (n,) of samples that follow each other by the report's period, with its gaps."""
    step = np.ones(time.size)
    for gap in report.gaps:
        step[np.searchsorted(time, gap.time) + 1] += gap.missing
    even = np.cumsum(step) * report.period
    return np.asarray(even + np.mean(time - even))


def resampling_error(time: Array, values: Array, period: float) -> tuple[float, float]:
    """Return rms and largest difference between values (n,) and the lines through their neighbours in time, gaps left out.

    An upper estimate of the error of linear interpolation, also if the times are wrong by their jitter.
    """
    span = time[2:] - time[:-2]
    share = (time[1:-1] - time[:-2]) / span
    off = (values[1:-1] - (1.0 - share) * values[:-2] - share * values[2:])[span < 3.0 * period]
    return (float(np.sqrt(np.mean(off**2))), float(np.abs(off).max())) if off.size else (0.0, 0.0)


def _period(time: Array, count: Array) -> float:
    """Return the period [s] of times that are `count` periods apart."""
    # The median of rounded steps drifts away from the times: fit a line.
    index = np.append(0.0, np.cumsum(count))
    index -= index.mean()
    slope = float(index @ (time - time.mean()) / (index @ index))
    # Written times are rounded: take 0.1 ms for 0.0999999997 ms if it makes no difference over the record.
    short = float(f"{slope:.6g}")
    return short if abs(short - slope) * count.sum() < 0.1 * EVEN * slope else slope


def _jitter(time: Array, count: Array, period: float) -> Array:
    """Return the times minus an even clock that restarts after each gap."""
    index = np.append(0.0, np.cumsum(count))
    off = time - time[0] - index * period
    breaks = np.append(0, np.flatnonzero(count > 1.0) + 1)
    lengths = np.diff(np.append(breaks, time.size))
    return np.asarray(off - np.repeat([off[a : a + n].mean() for a, n in zip(breaks, lengths, strict=True)], lengths))


def common_clock(reports: list[tuple[ClockReport, float, float]], file: Path) -> tuple[float, float, int]:
    """Return period [s], start [s] and number of samples of the common clock.

    Parameters
    ----------
    reports : list of (ClockReport, float, float)
        Report, first and last time [s] of each channel.

    Notes
    -----
    The shortest period, over the time that all channels cover.
    """
    period = min(report.period for report, _, _ in reports)
    start, stop = max(first for _, first, _ in reports), min(last for _, _, last in reports)
    n = int(np.floor((stop - start) / period + EVEN)) + 1
    if n < 3:
        overlap = f"from {start:.6g} s to {stop:.6g} s"
        raise LogError(f"its channels overlap by fewer than three samples, {overlap}: check their times", file=file)
    return period, start, n


def resampled(time: Array, values: Array, report: ClockReport, clock: tuple[float, float, int]) -> tuple[Array, bool]:
    """Return values (n,) on the clock, and whether they were interpolated.

    An even channel with the clock's period is copied; others are interpolated linearly.
    """
    period, start, n = clock
    is_even = float(np.ptp(time - np.arange(time.size) * period)) <= 2.0 * EVEN * period
    same = abs(report.period - period) <= 1e-9 * period and not report.gaps and is_even
    first = round((start - time[0]) / period)
    if same and abs(time[0] + first * period - start) <= EVEN * period and first + n <= values.size:
        return values[first : first + n], False
    return np.interp(start + np.arange(n) * period, time, values), True
