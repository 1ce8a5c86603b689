"""One clock for all channels: report on the samples' own times, and resample onto an even one."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import LogError
from contourlab.units import show

Array = NDArray[np.float64]
GAP = 1.5
"""Distance of two samples, in periods, above which samples are missing."""
MOST_MISSING = 0.05
"""Largest share of missing samples; beyond it a log is refused."""
FEW = 3
"""Most gaps of a record that is otherwise even."""
EVEN = 1e-3
"""Jitter over the period below which samples count as even, because written times are rounded."""


@dataclass(frozen=True)
class Gap:
    """Where samples are missing: the time of the one before [s], and how many."""

    time: float
    missing: int


@dataclass(frozen=True)
class ClockReport:
    """Regularity of the times of a channel.

    Attributes
    ----------
    period : float [s]
        The median of the differences.
    n_sample : int
    jitter_rms, jitter_peak : float [s]
        Of the times about an even clock between gaps.
    gaps : tuple of Gap
    repeated : int
        Samples with the time of the one before, which were left out.
    resampled : bool
        Whether values had to be interpolated between samples.
    """

    period: float
    n_sample: int
    jitter_rms: float
    jitter_peak: float
    gaps: tuple[Gap, ...] = ()
    repeated: int = 0
    resampled: bool = False

    @property
    def missing(self) -> int:
        """Number of samples that are missing."""
        return sum(gap.missing for gap in self.gaps)

    def lines(self, period: float | None = None) -> list[str]:
        """Return notes; none for an even clock.

        Parameters
        ----------
        period : float [s], optional
            Of the clock that the values were put on; by default their own.
        """
        onto = self.period if period is None else period
        found = []
        if self.jitter_peak > EVEN * self.period:
            found.append(f"times jitter by {show(self.jitter_rms, 'us', 3)} rms, {show(self.jitter_peak, 'us', 3)} at most")
        if self.gaps:
            found.append(f"{self.missing} of {self.n_sample + self.missing} samples are missing, {self._gaps()}")
        if self.repeated:
            many = "samples repeat" if self.repeated > 1 else "sample repeats"
            found.append(f"{self.repeated} {many} the time of the one before: left out")
        if self.resampled:
            own = f"a sample every {show(self.period, 'us')}, " if abs(onto - self.period) > EVEN * onto else ""
            found.append(f"{own}interpolated to an even clock of {show(onto, 'us')}")
        return found

    def _gaps(self) -> str:
        """Return how many gaps there are, and between which samples the longest is."""
        worst = max(self.gaps, key=lambda gap: gap.missing)
        end = worst.time + (worst.missing + 1) * self.period
        longest = f"{worst.missing} from t = {worst.time:.6g} s to {end:.6g} s"
        return f"in 1 gap of {longest}" if len(self.gaps) == 1 else f"in {len(self.gaps)} gaps; the longest of {longest}"


def look_at_clock(time: Array, name: str, file: Path, period: float | None = None) -> tuple[ClockReport, NDArray[np.bool_]]:
    """Return the regularity of a channel's times, and which of its samples to keep.

    Parameters
    ----------
    time : ndarray (n,) [s]
    name : str
        Of the channel, for messages.
    file : Path
    period : float [s], > 0, optional
        As the file says; by default the median of the differences.

    Raises
    ------
    LogError
        If there are fewer than three samples, a time is not finite, time goes back or stands still, more than a twentieth of the samples
        have the time of the one before, the period is not that of the times, or too much is missing.
    """
    kept = _kept(time, name, file)
    even = time[kept]
    step = np.diff(even)
    usual = float(np.median(step))
    if period is not None:
        if period > GAP * usual:
            raise LogError(f"the times of {name!r} are {show(usual, 'us')} apart, the given period is {show(period, 'us')}", file=file)
        usual = period
    count = np.maximum(np.rint(step / usual), 1.0)
    wide = step > GAP * usual
    gaps = tuple(Gap(float(even[k]), int(count[k]) - 1) for k in np.flatnonzero(wide) if count[k] > 1)
    if period is None:
        usual = _period(even, count)
    jitter = _jitter(even, count, usual)
    report = ClockReport(usual, even.size, float(np.sqrt(np.mean(jitter**2))), float(np.abs(jitter).max()), gaps, int((~kept).sum()))
    if report.missing > MOST_MISSING * (report.n_sample + report.missing):
        lost = f"{report.missing} of {report.n_sample + report.missing} samples of {name!r}"
        # A few gaps are in the record, many are in its clock.
        cure = "cut the log there" if len(report.gaps) <= FEW else "that is no even sampling, or the wrong period"
        raise LogError(f"{lost} are missing at a period of {show(usual, 'us')}, {report._gaps()}: {cure}", file=file)
    return report, kept


def _kept(time: Array, name: str, file: Path) -> NDArray[np.bool_]:
    """Return which samples have a time later than the one before; refuse times that go back, stand still or are not finite."""
    if not np.isfinite(time).all():
        raise LogError(f"the time of {name!r} is not finite at sample {int(np.argmin(np.isfinite(time)))}", file=file)
    step = np.diff(time)
    if (step < 0.0).any():
        k = int(np.argmax(step < 0.0))
        where = f"from {time[k]:.9g} s to {time[k + 1]:.9g} s at sample {k + 1} ({name!r})"
        raise LogError(f"time goes back {where}: are two records in one file, or is the column no time?", file=file)
    kept = np.append(True, step > 0.0)
    n = int(np.count_nonzero(kept))
    repeated = time.size - n
    if n >= 3 and repeats_too_often(time):
        count = f"{repeated} of {time.size} samples of {name!r}"
        raise LogError(f"{count} repeat the time of the one before: times are written too coarsely", file=file)
    if n < 3:
        raise LogError(f"holds {n} samples of {name!r} at different times: three or more are wanted", file=file)
    return np.asarray(kept)


def repeats_too_often(time: Array) -> bool:
    """Tell whether so many times (n,) are that of the sample before that they tell no sampling."""
    return bool(np.count_nonzero(np.diff(time) == 0.0) > MOST_MISSING * time.size)


def _period(time: Array, count: Array) -> float:
    """Return the period [s] of times that are so many periods apart."""
    # The median of rounded differences would drift away from the times: the slope of all of them is better.
    index = np.append(0.0, np.cumsum(count))
    index -= index.mean()
    slope = float(index @ (time - time.mean()) / (index @ index))
    # Times are rounded when they are written: 0.1 ms it was, not 0.0999999997 ms, where that makes no difference over the record.
    short = float(f"{slope:.6g}")
    return short if abs(short - slope) * count.sum() < 0.1 * EVEN * slope else slope


def _jitter(time: Array, count: Array, period: float) -> Array:
    """Return the times less those of an even clock, which starts anew behind each gap."""
    index = np.append(0.0, np.cumsum(count))
    off = time - time[0] - index * period
    breaks = np.append(0, np.flatnonzero(count > 1.0) + 1)
    lengths = np.diff(np.append(breaks, time.size))
    return np.asarray(off - np.repeat([off[a : a + n].mean() for a, n in zip(breaks, lengths, strict=True)], lengths))


def common_clock(reports: list[tuple[ClockReport, float, float]], file: Path) -> tuple[float, float, int]:
    """Return period [s], start [s] and number of samples of the clock that all channels are put on.

    Parameters
    ----------
    reports : list of (ClockReport, float, float)
        Of each channel, with its first and last time [s].

    Notes
    -----
    The shortest period of all, over the time that all channels cover: nothing is invented before or behind.
    """
    period = min(report.period for report, _, _ in reports)
    start, stop = max(first for _, first, _ in reports), min(last for _, _, last in reports)
    n = int(np.floor((stop - start) / period + EVEN)) + 1
    if n < 3:
        raise LogError(f"its channels have less than three samples in common: from {start:.6g} s to {stop:.6g} s", file=file)
    return period, start, n


def resampled(time: Array, values: Array, report: ClockReport, clock: tuple[float, float, int]) -> tuple[Array, bool]:
    """Return values (n,) on the clock, and whether they had to be interpolated.

    An even channel of the clock's own period is taken sample by sample; anything else is interpolated on a line between its samples.
    """
    period, start, n = clock
    same = abs(report.period - period) <= 1e-9 * period and not report.gaps and report.jitter_peak <= EVEN * period
    first = round((start - time[0]) / period)
    if same and abs(time[0] + first * period - start) <= EVEN * period and first + n <= values.size:
        return values[first : first + n], False
    return np.interp(start + np.arange(n) * period, time, values), True
