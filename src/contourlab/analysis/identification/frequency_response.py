"""Frequency response of an axis, position over command, from measured runs: random, periodic, swept or with sines, open or closed loop.

In a closed loop noise returns in the command and biases position over command towards minus one over the controller. The reference is free
of that noise: the plant is the ratio of two cross-spectra, reference to position over reference to command. Position is differenced first,
since an axis drifts; the result is then divided exactly by the response of the difference.

A sweep passes each frequency once, so there are no segments to average, and the ends of the record leak into every frequency. Over a few
neighbouring lines response and leakage are smooth: a parabola is fitted to each, and the residual is the noise.

A sine is fitted by least squares with its harmonics, and tested. On top of a steady motion, a sine does not reverse friction, so the
response is that of the drive. It is not if the axis stops during the sine, at an end stop or by sticking.

References
----------
Bendat & Piersol, "Random Data", 4th ed., sections 6.2 and 9.2, for H1, coherence and their deviations; Ljung, "System Identification",
2nd ed., section 13.5, for joint input-output identification; Pintelon & Schoukens, "System Identification: a frequency domain approach",
2nd ed., section 2.7, for periodic excitation, and chapter 7 for the local polynomial method.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from contourlab.analysis.identification.filtered_motion import require_finite
from contourlab.analysis.identification.least_squares import coloured_deviations, lasting_window
from contourlab.arrays import Array, Complex, true_spans
from contourlab.errors import ParameterError, refuse
from contourlab.findings import Finding, finding

SEGMENTS = 8
"""Segments of a record, not counting overlap, over which spectra are averaged."""
EXCITED = 1e-5
"""Share of the largest power of the excitation below which a frequency counts as not excited."""
REPEATS = 1e-3
"""Largest difference between the periods of a periodic excitation, over its size."""
HANN_OVERLAP = 1.0 / 1.056
"""Independent averages per segment of Hann windows that overlap by half."""


@dataclass(frozen=True, eq=False)
class Measured:
    """An evenly sampled run: command, position [m] and, in closed loop, the reference or another external signal."""

    period: float
    command: Array
    position: Array
    outside: Array | None = None

    def part(self, stretch: slice) -> Measured:
        """Return a part of the run."""
        outside = None if self.outside is None else self.outside[stretch]
        return Measured(self.period, self.command[stretch], self.position[stretch], outside)

    def __post_init__(self) -> None:
        for name in ("command", "position", "outside"):
            values = getattr(self, name)
            if values is None:
                continue
            if values.shape != self.position.shape or values.ndim != 1:
                raise ParameterError(name, f"shape {values.shape}", f"as long as the position, {self.position.shape}")
            require_finite(name, values)
            if not np.ptp(values) > 0.0:
                raise ParameterError(name, f"{values[0]:g} throughout", "a record in which it changes")


@dataclass(frozen=True, eq=False)
class MeasuredResponse:
    """Position over command at some frequencies.

    Attributes
    ----------
    frequency : ndarray (n,) [Hz]
    response : complex ndarray (n,) [m per command]
        Between samples: it includes the hold of the command.
    deviation : ndarray (n,)
        Relative standard deviation of the magnitude; also the standard deviation of the phase [rad].
    coherence : ndarray (n,)
        Between 0 and 1: share of the motion that is linear in the excitation.
    period : float [s]
        Sample period.
    distortion : ndarray (n,)
        For sines, harmonics of the velocity over its fundamental; otherwise nan.
    """

    frequency: Array
    response: Complex
    deviation: Array
    coherence: Array
    method: str
    period: float
    distortion: Array
    findings: tuple[Finding, ...] = ()

    @property
    def velocity(self) -> Complex:
        """Velocity over command, (n,) [m/s per command]."""
        return np.asarray(2j * np.pi * self.frequency * self.response)


def _of_velocity(run: Measured, frequency: Array, velocity: Complex, deviation: Array, coherence: Array, method: str) -> MeasuredResponse:
    """Return the response of the position from that of its difference over a sample."""
    difference = (1.0 - np.exp(-2j * np.pi * frequency * run.period)) / run.period
    missing = np.full(frequency.size, np.nan)
    return MeasuredResponse(frequency, velocity / difference, deviation, coherence, method, run.period, missing)


def repeating(excitation: Array) -> tuple[int, slice] | None:
    """Return period [samples] and stretch of an excitation that repeats at least three times; None if it does not.

    Parameters
    ----------
    excitation : ndarray (n,)
        Free of noise, such as a reference or an open-loop command.
    """
    n, x = excitation.size, excitation - excitation.mean()
    size = 1 << (2 * n - 1).bit_length()
    power = np.fft.irfft(np.abs(np.fft.rfft(x, size)) ** 2, size)[:n]
    own = power / (power[0] * (1.0 - np.arange(n) / n) + 1e-300)
    peaks = np.flatnonzero((own[1:-1] > own[:-2]) & (own[1:-1] >= own[2:]) & (own[1:-1] > 0.9)) + 1
    spread = float(np.sqrt(np.mean(x**2)))
    for lag in peaks[peaks <= n // 3]:
        # Short times before the excitation began, and after it ended, do not repeat: their transients would bias all frequencies.
        other = np.flatnonzero(np.abs(x[lag:] - x[:-lag]) > REPEATS * spread)
        ends = np.r_[-1, other, n - lag]
        longest = int(np.argmax(np.diff(ends)))
        stretch = slice(int(ends[longest]) + 1, int(ends[longest + 1]) + int(lag))
        if other.size / (n - lag) < 0.25 * lag / n and stretch.stop - stretch.start >= 3 * lag:
            return int(lag), stretch
    return None


def periodic_response(run: Measured, period: int) -> MeasuredResponse:
    """Return the response to a periodic excitation (multisine), averaged over all periods but the first, free of leakage.

    Parameters
    ----------
    period : int
        Samples of a period, at least three times in the run.

    Raises
    ------
    ParameterError
        If the run is too short.
    """
    count = run.position.size // period - 1
    refuse(count < 2, ParameterError, "record", f"{run.position.size} samples", f"three periods of {period} or more")
    start = run.position.size - count * period
    v = np.diff(run.position) / run.period

    def spectra(signal: Array) -> Complex:
        return np.asarray(np.fft.rfft(signal.reshape(count, period), axis=1)[:, 1:])

    y, u = spectra(v[start - 1 :]), spectra(run.command[start:])
    x = u if run.outside is None else spectra(run.outside[start:])
    power = np.mean(np.abs(x) ** 2, axis=0)
    kept = power > EXCITED * power.max()
    kept[int(0.45 * period) :] = False
    y, u, x = y[:, kept], u[:, kept], x[:, kept]
    frequency = (np.flatnonzero(kept) + 1) / (period * run.period)
    top, below = y.mean(axis=0), u.mean(axis=0)
    # Noise of the mean over periods; in closed loop the noises of both signals are correlated.
    response = top / below
    left = (y - top) - response * (u - below)
    spread = np.sqrt(np.sum(np.abs(left) ** 2, axis=0) / max(count - 1, 1) / count / 2.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        coherence = np.abs(np.mean(y * np.conj(x), axis=0)) ** 2 / (np.mean(np.abs(y) ** 2, axis=0) * np.mean(np.abs(x) ** 2, axis=0))
        deviation = spread / np.abs(top)
    method = f"periods of {period * run.period:.4g} s, {count} of them averaged" + _closed(run)
    return _of_velocity(run, frequency, response, deviation, np.nan_to_num(coherence), method)


def spectral_response(runs: Sequence[Measured]) -> MeasuredResponse:
    """Return the response from averaged spectra (Welch's method, H1), or with an external signal from the ratio of cross-spectra.

    Parameters
    ----------
    runs : sequence of Measured
        All with the same period, all with or all without an external signal.

    Raises
    ------
    ParameterError
        If the runs differ in period or signals, or are too short.
    """
    from scipy.signal import csd

    period, closed = runs[0].period, runs[0].outside is not None
    if any(abs(run.period - period) > 1e-3 * period or (run.outside is not None) != closed for run in runs):
        raise ParameterError("runs", f"{len(runs)} of them", "at one period, all with a reference or all without")
    length = min(run.position.size for run in runs) // SEGMENTS
    if length < 32:
        raise ParameterError("record", f"{min(run.position.size for run in runs)} samples", f"at least {32 * SEGMENTS} to average over")
    names = ("yx", "ux", "xx", "yy", "uu")
    total = {name: np.zeros(length // 2 + 1, dtype=complex) for name in names}
    averages = 0
    for run in runs:
        y, u = np.diff(run.position) / period, run.command[1:]
        signals = {"y": y, "u": u, "x": u}
        if run.outside is not None:
            t, outside = np.arange(y.size), run.outside[1:]
            signals["x"] = np.asarray(outside - np.polyval(np.polyfit(t, outside, 1), t))
        count = (y.size - length // 2) // (length - length // 2)
        for name in names:
            # scipy conjugates the first of the two.
            spectrum = csd(signals[name[1]], signals[name[0]], 1.0 / period, "hann", length, length // 2, detrend="constant")[1]
            total[name] += count * spectrum
        averages += count
    frequency = np.arange(length // 2 + 1) / (length * period)
    power = total["xx"].real
    kept = (power > EXCITED * power[2:].max()) & (frequency < 0.45 / period) & (np.arange(frequency.size) >= 2)
    part = {name: values[kept] for name, values in total.items()}
    response = part["yx"] / part["ux"]
    coherence = _coherence(part["yx"], part["xx"], part["yy"])
    of_command = _coherence(part["ux"], part["xx"], part["uu"])
    independent = max(averages * HANN_OVERLAP, 1.0)
    variance = sum((1.0 - c) / (2.0 * np.maximum(c, 1e-9) * independent) for c in (coherence, of_command))
    method = f"{averages} segments of {length * period:.4g} s averaged" + _closed(runs[0])
    return _of_velocity(runs[0], frequency[kept], response, np.sqrt(np.asarray(variance, dtype=float)), coherence, method)


def _closed(run: Measured) -> str:
    return "" if run.outside is None else "; reference to position over reference to command"


def _coherence(cross: Complex, power: Complex, other_power: Complex) -> Array:
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(np.clip(np.nan_to_num(np.abs(cross) ** 2 / (power.real * other_power.real)), 0.0, 1.0))


FEWEST_LINES, WIDTH = 15, 0.08
"""Smallest number of lines of a window, and width of a window as a share of its frequency."""
SWEPT = 1e-2
"""Share of the largest power below which the sweep does not reach a frequency."""
MIXED = 3.0
"""Largest variance over that without leakage: near its ends the spectrum of a sweep is as smooth as the leakage."""
PARTS, APART = 8, 0.25
"""Parts of an excitation whose mean frequencies are compared, and relative spread of these above which it is a sweep."""


def is_sweep(excitation: Array) -> bool:
    """Return whether the frequency of an excitation changes over time, rather than all frequencies being present at all times."""
    parts = np.array_split(excitation - excitation.mean(), PARTS)
    powers = [np.abs(np.fft.rfft(part * np.hanning(part.size), parts[0].size)) ** 2 for part in parts]
    means = np.array([float(np.sum(np.arange(p.size) * p) / max(float(p.sum()), 1e-300)) for p in powers])
    return bool(means.std() > APART * means.mean())


def swept_response(run: Measured) -> MeasuredResponse:
    """Return the response of an axis from one run with a sweep.

    Raises
    ------
    ParameterError
        If the run is too short.
    """
    n = run.position.size - 1
    refuse(n < 40 * FEWEST_LINES, ParameterError, "record", f"{n + 1} samples", f"at least {40 * FEWEST_LINES + 1} for a sweep")
    signals = {"y": np.diff(run.position) / run.period, "u": run.command[1:]}
    signals["x"] = signals["u"] if run.outside is None else run.outside[1:]
    spectra = {name: np.fft.rfft(values - values.mean()) for name, values in signals.items()}
    level = np.convolve(np.abs(spectra["x"]) ** 2, np.ones(FEWEST_LINES) / FEWEST_LINES, "same")
    top, centres, rows = float(level.max()), [], []
    at = 1 + FEWEST_LINES // 2
    while (half := max(FEWEST_LINES // 2, round(0.5 * WIDTH * at))) + at < 0.45 * n:
        if level[at] > SWEPT * top:
            window = slice(at - half, at + half + 1)
            row = _local(spectra["x"][window], spectra["y"][window], spectra["u"][window], run.outside is not None)
            rows += [] if row is None else [row]
            centres += [] if row is None else [at]
        at += max(FEWEST_LINES // 2, half)
    refuse(not rows, ParameterError, "record", "a sweep", "slower: leakage from the ends of the record covers all of it")
    method = f"sweep of {n * run.period:.4g} s, local polynomials" + ("" if run.outside is None else ", reference to position over command")
    response, deviation, coherence = (np.array(column) for column in zip(*rows, strict=True))
    return _of_velocity(run, np.array(centres) / (n * run.period), response, deviation, coherence, method)


def _local(x: Complex, y: Complex, u: Complex, closed: bool) -> tuple[complex, float, float] | None:
    """Return the response in the middle of a window, its relative deviation, and the coherence; None if leakage cannot be separated."""
    r = np.linspace(-1.0, 1.0, x.size)
    powers = np.column_stack([np.ones_like(r), r, r**2]).astype(complex)
    size = float(np.sqrt(np.mean(np.abs(x) ** 2)))
    columns = np.column_stack([powers * (x / size)[:, None], powers])
    inverse = np.linalg.pinv(columns)
    spread = float(np.sum(np.abs(inverse[0]) ** 2))
    if spread * x.size > MIXED * 2.25:  # a parabola alone has 9/4 over the lines in its middle
        return None

    def solved(signal: Complex) -> tuple[complex, float, float]:
        solution = inverse @ signal
        left = float(np.sum(np.abs(signal - columns @ solution) ** 2))
        variance = left / (x.size - 6)
        explained = float(np.sum(np.abs(columns[:, :3] @ solution[:3]) ** 2))
        return complex(solution[0]), spread * variance / 2.0, explained / (explained + left)

    top, top_variance, coherence = solved(y)
    if not closed:
        return top / size, float(np.sqrt(top_variance)) / abs(top), coherence
    below, below_variance, _ = solved(u)
    return top / below, float(np.sqrt(top_variance / abs(top) ** 2 + below_variance / abs(below) ** 2)), coherence


COHERENT = 0.5
"""Smallest coherence of a usable point."""
FEWEST = 4
"""Smallest number of points that separates mass and spring."""
WIDE, RISING = 5.0, 0.5
"""Smallest ratio of frequencies to test the slope, and slope, in powers of the frequency, above which the response is not an axis."""


def response_findings(measured: MeasuredResponse) -> list[Finding]:
    """Return reasons why a response cannot be that of an axis; empty for a plausible one.

    At low frequencies the force per velocity of an axis is B + j (M w - K/w): damping, mass, and stiffness if a spring holds it, none below
    zero. A command or position with the wrong sign reverses the sign of the largest term.

    Parameters
    ----------
    measured : MeasuredResponse
        Points with a coherence below one half are ignored.
    """
    h = measured.response
    good = (measured.coherence >= COHERENT) & np.isfinite(h) & (np.abs(h) > 0.0)
    f, h = measured.frequency[good], h[good]
    if not f.size:
        return []
    if f[-1] >= WIDE * f[0] and np.polyfit(np.log(f), np.log(np.abs(h)), 1)[0] > RISING:
        return [finding("CL508")]
    return [finding("CL509")] if _goes_against(f, h, measured.period) else []


def _goes_against(f: Array, h: Complex, period: float) -> bool:
    """Return whether the largest part of the force per velocity is below zero, over the lower half of the points."""
    low = slice(None) if f.size < 2 * FEWEST else slice(f.size // 2)
    w = 2.0 * np.pi * f[low]
    # Remove the half-sample delay of the hold.
    force = np.exp(-0.5j * w * period) / (1j * w * h[low])
    parts = [np.ones_like(force), 1j * w] + ([-1j / w] if w.size >= FEWEST else [])
    columns = np.column_stack(parts) / np.abs(force)[:, None]
    wanted = force / np.abs(force)
    found = np.linalg.lstsq(np.vstack([columns.real, columns.imag]), np.r_[wanted.real, wanted.imag], rcond=None)[0]
    sizes = np.linalg.norm(columns, axis=0) * np.abs(found)
    return bool(found[int(np.argmax(sizes))] < 0.0)


PURE = 0.03
"""Largest residual of an excitation that counts as a sine, over the size of the sine."""
HARMONICS = 5
LEAST_PERIODS = 0.9
DISTORTED = 0.1
"""Harmonics of the velocity over its fundamental above which a response is not linear."""
STILL = 0.03
"""Share of samples at rest above which a point is left out."""


@dataclass(frozen=True)
class SinePoint:
    """A point of a frequency response.

    Attributes
    ----------
    frequency : float [Hz]
    response : complex [m per command]
    deviation : float
        Relative.
    distortion : float
        Harmonics of the velocity over its fundamental.
    still : float
        Share of the fitted samples at which the axis is at rest.
    coherence : float
        Share of the fundamental in the power of the velocity.
    """

    frequency: float
    response: complex
    deviation: float
    periods: float
    distortion: float
    still: float
    coherence: float


def sine_stretch(excitation: Array, period: float) -> tuple[int, int, float] | None:
    """Return the longest span [start, stop) of samples in which an excitation is one sine, and its frequency [Hz]; None if there is none.

    Parameters
    ----------
    excitation : ndarray (n,)
        Free of noise: a reference, or an open-loop command. It is constant between sines.
    period : float [s]
    """
    size = float(np.ptp(excitation))
    if size == 0.0:
        return None
    moves = np.abs(np.diff(excitation)) > 1e-6 * size
    # A sine hardly moves for a sample or two at its peaks.
    filled = np.convolve(moves, np.ones(5), "same") > 0.0
    best: tuple[int, int, float] | None = None
    for start, stop in true_spans(filled):
        if stop - start < 20 or (best is not None and stop - start <= best[1] - best[0]):
            continue
        first, last = start + 3, stop - 3
        frequency = _frequency(excitation[first:last], period)
        if frequency is not None and frequency * (last - first) * period >= LEAST_PERIODS:
            best = (first, last, frequency)
    return best


def _frequency(part: Array, period: float) -> float | None:
    """Return the frequency [Hz] of a sine plus a constant; None for any other signal."""
    from scipy.optimize import minimize_scalar

    t = period * np.arange(part.size)
    spread = float(np.sum((part - part.mean()) ** 2))

    def left(frequency: float) -> float:
        w = 2.0 * math.pi * frequency
        columns = np.column_stack([np.ones_like(t), np.sin(w * t), np.cos(w * t)])
        solution = np.linalg.lstsq(columns, part, rcond=None)[0]
        return float(np.sum((part - columns @ solution) ** 2))

    size = 8 * part.size
    spectrum = np.abs(np.fft.rfft((part - part.mean()) * np.hanning(part.size), size))
    peak = max(int(np.argmax(spectrum[4:])) + 4, 4) / (size * period)
    step = 1.0 / (part.size * period)
    candidates = np.linspace(max(peak - 1.5 * step, 0.5 * step), peak + 1.5 * step, 25)
    start = float(candidates[int(np.argmin([left(float(f)) for f in candidates]))])
    optimum = minimize_scalar(left, bounds=(start - 0.2 * step, start + 0.2 * step), method="bounded", options={"xatol": 1e-7 * start})
    return float(optimum.x) if float(optimum.fun) < PURE**2 * spread else None


def sine_point(run: Measured, start: int, stop: int, frequency: float) -> SinePoint:
    """Return the response at the frequency of a sine, from the samples `start` to `stop` in which it is on.

    Parameters
    ----------
    frequency : float [Hz]

    Raises
    ------
    ParameterError
        If there are too few samples.
    """
    cycle = 1.0 / (frequency * run.period)
    periods = (stop - start) / cycle
    # With enough periods, leave the first quarter, at least one whole period, to the transient.
    skip = round(max(1.0, math.floor(0.25 * periods)) * cycle) if periods >= 2.9 else 0
    first = start + skip
    whole = math.floor((stop - first) / cycle + 1e-6)
    last = min(stop, first + round(whole * cycle)) if whole >= 1 else stop
    if last - first < 12:
        raise ParameterError("record", f"{last - first} samples of a sine of {frequency:.4g} Hz", "at least 12: sample faster")
    t = np.asarray(run.period * np.arange(first, last), dtype=float)
    w = 2.0 * math.pi * frequency
    most = min(HARMONICS, max(1, int(0.45 / (frequency * run.period))))
    y, y_deviation, y_rest = _harmonics(run.position[first:last], t, w, most, 2 if whole >= 2 else 1)
    u, _, _ = _harmonics(run.command[first:last], t, w, most, 0)
    speed = np.abs(y) * np.arange(1, most + 1)
    # The axis is at rest where its mean step over ten samples is small beside the median step.
    steps = np.diff(run.position[first:last])
    count = min(10, steps.size)
    average = np.abs(np.convolve(steps, np.ones(count) / count, "same"))
    still = float(np.mean(average < 0.02 * max(float(np.median(np.abs(steps))), float(average.max()))))
    fundamental = 0.5 * (w * abs(y[0])) ** 2
    rest = float(np.sum(0.5 * (w * speed[1:]) ** 2)) + float(np.var(np.diff(y_rest) / run.period))
    return SinePoint(
        frequency,
        complex(y[0] / u[0]),
        y_deviation / abs(y[0]),
        (last - first) / cycle,
        float(np.linalg.norm(speed[1:]) / speed[0]),
        still,
        fundamental / (fundamental + rest),
    )


def _harmonics(values: Array, t: Array, w: float, most: int, trend: int) -> tuple[Complex, float, Array]:
    """Return complex amplitudes of the harmonics, the deviation of the first, and the residual."""
    middle = t - t.mean()
    polynomial = [(middle / (abs(middle[0]) or 1.0)) ** k for k in range(trend + 1)]
    waves = [part for h in range(1, most + 1) for part in (np.cos(h * w * t), -np.sin(h * w * t))]
    columns = np.column_stack([*polynomial, *waves])
    solution, *_ = np.linalg.lstsq(columns, values, rcond=None)
    left = values - columns @ solution
    inverse = np.linalg.pinv(columns.T @ columns)
    enough = left.size > 2 * columns.shape[1]
    spread = coloured_deviations(columns, left, inverse, lasting_window(left)) if enough else np.zeros(columns.shape[1])
    k = trend + 1
    amplitudes = solution[k::2] + 1j * solution[k + 1 :: 2]
    return amplitudes, float(np.hypot(spread[k], spread[k + 1]) / math.sqrt(2.0)), left


def sine_responses(runs: Sequence[Measured], names: Sequence[str]) -> MeasuredResponse:
    """Return the frequency response from several runs, each with one sine.

    Parameters
    ----------
    runs : sequence of Measured
        Each with a sine as command, or as the external signal.

    Raises
    ------
    ParameterError
        If no run has a usable sine.
    """
    points, findings, periods = list[SinePoint](), list[Finding](), list[float]()
    for run, name in zip(runs, names, strict=True):
        stretch = sine_stretch(run.command if run.outside is None else run.outside, run.period)
        if stretch is None:
            findings.append(finding("CL518", name))
            continue
        point = sine_point(run, *stretch)
        if point.still > STILL:
            findings.append(finding("CL519", name, share=float(point.still)))
            continue
        at = {"frequency": float(point.frequency)}
        findings += [finding("CL524", name, share=float(point.distortion), **at)] if point.distortion > DISTORTED else []
        findings += [finding("CL529", name, periods=float(point.periods), **at)] if point.periods < 1.9 else []
        points.append(point)
        periods.append(run.period)
    if not points:
        raise ParameterError("logs", f"{len(runs)} of them", "one with a sine in it: " + "; ".join(note.text for note in findings))
    # The shortest period is the servo period: a log of every tenth sample does not change how long a command is held.
    period = min(periods)
    findings += [finding("CL542", shortest=period, longest=max(periods))] if max(periods) > 1.001 * period else []
    points.sort(key=lambda p: p.frequency)
    keys = ("frequency", "response", "deviation", "coherence", "distortion")
    frequency, response, deviation, coherence, distortion = (np.array([getattr(p, key) for p in points]) for key in keys)
    return MeasuredResponse(frequency, response, deviation, coherence, "one sine a run, least squares", period, distortion, tuple(findings))


def measured_response(runs: Sequence[Measured], names: Sequence[str]) -> MeasuredResponse:
    """Return the frequency response by the method that fits the excitation of runs, each with its name.

    Raises
    ------
    ParameterError
        If a run is too short, or the runs do not fit together.
    """
    excitations = [run.command if run.outside is None else run.outside for run in runs]
    if any(sine_stretch(excitation, run.period) is not None for excitation, run in zip(excitations, runs, strict=True)):
        return sine_responses(runs, names)
    if len(runs) == 1 and (repeated := repeating(excitations[0])) is not None:
        lap, stretch = repeated
        return periodic_response(runs[0].part(stretch), lap)
    return swept_response(runs[0]) if len(runs) == 1 and is_sweep(excitations[0]) else spectral_response(runs)
