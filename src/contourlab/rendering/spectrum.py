"""Spectra of the error and of the commands over the judged moves, with their peaks and what is known to cause them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import cache, partial
from typing import NamedTuple

import numpy as np

from contourlab.arrays import Array
from contourlab.components.plant.plant import resonance_of
from contourlab.figures import figure, number, shown_unit
from contourlab.rendering.charts import Chart, Curve, Panel, Tick
from contourlab.rendering.data import JudgedRun, ReportData
from contourlab.rendering.samples import signal
from contourlab.result import Result
from contourlab.thinning import keep_extremes

LONGEST, FEWEST = 2.0, 256
"""Longest segment [s], and its fewest samples."""
DEPTH = 1e-4
"""Smallest amplitude drawn, as a share of the largest."""
PEAKS, NEAR, RINGS = 3, 0.05, 1.25
"""Most peaks of a panel; how far from it a known frequency may be, and another peak; and the least peak of a closed loop."""
ROUNDING = 1e-9
"""Amplitudes below this share of the largest value are rounding."""
CHANCE = 1e-4
"""Probability of a level that chance alone makes so high, or so low, at one frequency."""


class _Spectrum(NamedTuple):
    """Frequencies (m,) [Hz] > 0, amplitudes (m,) of a sine there, and the number of segments of which it is the mean."""

    hertz: Array
    amplitude: Array
    segments: int


def spectrum_charts(data: ReportData, points: int) -> tuple[Chart, ...]:
    """Return the amplitude spectrum of the part error and of each command; nothing where the judged moves are too short.

    The error is the vector from the path to the tool: the squares of its axes' amplitudes are added, so that no direction counts more.
    """
    found: dict[str, list[tuple[JudgedRun, _Spectrum]]] = {}
    for scheme in data.schemes:
        columns: dict[str, Callable[[int, int], Array]] = {"part error [um]": partial(_error, scheme)}
        if "command" in scheme.result:
            factor, unit = shown_unit(str(scheme.result.signals["command"].unit))
            labels = (f"command {axis} [{unit or '1'}]" for axis in data.axes)
            columns |= {label: partial(_command, scheme.result, i, factor) for i, label in enumerate(labels)}
        for label, values in columns.items():
            if spectrum := _spectrum(scheme, values):
                found.setdefault(label, []).append((scheme, spectrum))
    panels = [_panel(data, label, spectra, points) for label, spectra in found.items()]
    if not panels:
        return ()
    longest = max(1.0 / spectrum.hertz[0] for spectra in found.values() for _, spectrum in spectra)
    caption = "Amplitude of a sine at each frequency: mean over segments of the judged moves, Hann window, half overlapped, "
    caption += f"{figure(longest, 's')} long. "
    peaks = [f"{panel.y_label.split(' [')[0]} at {'; '.join(tick.label for tick in panel.ticks)}" for panel in panels if panel.ticks]
    caption += f"Triangles mark what stands out by more than chance: {'. '.join(peaks)}." if peaks else ""
    return (Chart("spectrum", "Spectrum of error and commands", caption.strip(), tuple(panels)),)


def _error(scheme: JudgedRun, start: int, stop: int) -> Array:
    """Return the vector from the path to the tool (n, n_axis) [um] at samples [start, stop)."""
    tool, foot = (signal(scheme.result, name)[start:stop] for name in ("tool_position", "foot_arc_length"))
    return np.asarray(1e6 * (tool - scheme.reference.programmed.position(foot)))


def _command(result: Result, axis: int, factor: float, start: int, stop: int) -> Array:
    """Return the command of an axis (n, 1) at samples [start, stop)."""
    return np.asarray(factor * signal(result, "command")[start:stop, [axis]])


def _spectrum(scheme: JudgedRun, values: Callable[[int, int], Array]) -> _Spectrum | None:
    """Return the spectrum of a vector (n, n_column) at samples [start, stop); None without enough finite samples, or if it is constant.

    A segment is as long as the stretches that hold at least half of the judged samples, up to `LONGEST`.
    """
    ranges, period = scheme.metrics.judged.ranges, scheme.result.servo_period
    lengths = np.sort([stop - start for start, stop in ranges])[::-1]
    size = min(int(lengths[np.searchsorted(np.cumsum(lengths), 0.5 * lengths.sum())]), round(LONGEST / period))
    if size < FEWEST:
        return None
    stretches = [(start, stop) for start, stop in ranges if stop - start >= size]
    counts = [1 + (stop - start - size) // (size - size // 2) for start, stop in stretches]
    squares, largest = zip(*(_squares(values, start, stop, size) for start, stop in stretches), strict=True)
    amplitude = np.sqrt(np.average(squares, axis=0, weights=counts))[1:]
    if not np.max(amplitude) > ROUNDING * max(largest):  # not a number, if a sample is none
        return None
    return _Spectrum(np.arange(1, amplitude.size + 1) / (size * period), amplitude, sum(counts))


def _squares(values: Callable[[int, int], Array], start: int, stop: int, size: int) -> tuple[Array, float]:
    """Return squared amplitudes (size // 2 + 1,), and the largest value: mean over segments, Hann window, half overlapped (Welch)."""
    window = 0.5 - 0.5 * np.cos(2.0 * np.pi / size * np.arange(size)[:, None])
    total, largest = np.zeros(size // 2 + 1), 0.0
    starts = range(start, stop - size + 1, size - size // 2)
    for at in starts:
        part = values(at, at + size)
        largest = max(largest, float(np.abs(part).max()))
        total += (np.abs(np.fft.rfft(window * (part - part.mean(axis=0)), axis=0)) ** 2).sum(axis=1)
    total[-1] /= 1.0 if size % 2 else 4.0  # at half the sampling rate, one frequency is both
    return np.asarray(total * (2.0 / window.sum()) ** 2 / len(starts)), largest


def _panel(data: ReportData, label: str, spectra: Sequence[tuple[JudgedRun, _Spectrum]], points: int) -> Panel:
    """Return the spectra of one quantity, the low frequencies unthinned; its largest peaks are marked."""
    curves, peaks = [], list[tuple[float, Tick]]()
    for scheme, spectrum in spectra:
        hertz, amplitude, _ = spectrum
        low = points // 2
        kept = np.append(np.arange(len(hertz))[:low], low + keep_extremes(amplitude[low:], points - low)).astype(int)
        curves.append(Curve(hertz[kept], np.where(amplitude[kept] > 0.0, amplitude[kept], np.nan), *data.looks[scheme.name]))
        peaks += _peaks(scheme, spectrum, label.split("[")[-1].rstrip("]"))
    top = max(float(np.nanmax(curve.y)) for curve in curves)
    ticks: list[Tick] = []
    for size, tick in sorted(peaks, key=lambda peak: -peak[0]):
        if size > DEPTH * top and len(ticks) < PEAKS and all(abs(tick.x - other.x) > NEAR * tick.x for other in ticks):
            ticks.append(tick)
    marks = tuple(sorted(ticks, key=lambda tick: tick.x))
    return Panel("frequency [Hz]", label, tuple(curves), ticks=marks, log_x=True, log_y=True, y_range=(DEPTH * top, 1.5 * top))


def _peaks(scheme: JudgedRun, spectrum: _Spectrum, unit: str) -> Iterator[tuple[float, Tick]]:
    """Yield the peaks with their amplitudes, each with its causes if some are known there.

    A mean of K spectra of noise is spread like chi-square with 2 K degrees of freedom: a peak must stand out by more than that.
    """
    hertz, amplitude, segments = spectrum
    low, high = _quantile(segments, CHANCE), _quantile(segments, 1.0 - CHANCE)
    known = list(_known(scheme))
    for at in np.flatnonzero((amplitude[1:-1] > amplitude[:-2]) & (amplitude[1:-1] > amplitude[2:])) + 1:
        higher = np.flatnonzero(amplitude > amplitude[at])
        split = np.searchsorted(higher, at)
        begin, end = higher[split - 1] if split else 0, higher[split] if split < higher.size else None
        if amplitude[at] ** 2 <= high / low * max(amplitude[begin:at].min(), amplitude[at:end].min()) ** 2:
            continue
        own = [cause for frequency, cause in known if abs(hertz[at] - frequency) <= NEAR * frequency]
        label = f"{figure(hertz[at], 'Hz')}, {number(amplitude[at])} {unit}"
        yield float(amplitude[at]), Tick(float(hertz[at]), label + (f" ({', '.join(own)})" if own else ""), "peak")


@cache
def _quantile(count: int, probability: float) -> float:
    """Return half of the quantile of chi-square with ``2 count`` degrees of freedom, by halving."""
    low, high = 0.0, 10.0 * count + 50.0
    while high - low > 1e-12 * high:
        middle = 0.5 * (low + high)
        below = 1.0 - sum(math.exp(i * math.log(middle) - middle - math.lgamma(i + 1.0)) for i in range(count))
        low, high = (middle, high) if below < probability else (low, middle)
    return high


def _known(scheme: JudgedRun) -> Iterator[tuple[float, str]]:
    """Yield known frequencies [Hz] with what they are."""
    if (machine := scheme.machine) is not None:
        for axis in machine.axis_names:
            if ringing := resonance_of(machine.loaded_plant(axis)):
                yield ringing[0], f"resonance of {axis}"
    for axis, loop in scheme.bode.items():
        size = np.abs(loop.response)
        if loop.margins.stable and np.max(size) > RINGS:
            yield float(loop.frequency[np.argmax(size)]), f"the closed loop of {axis} peaks"
