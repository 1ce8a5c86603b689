"""Frequency response at one frequency, from a run with a sine: least squares with harmonics, and tests of the result.

On top of a steady motion, a sine does not reverse friction, so the response is that of the drive. It is not if the axis stops during the
sine, at an end stop or by sticking.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from contourlab.analysis.identification.frequency_response import Measured, MeasuredResponse
from contourlab.analysis.identification.output_error import coloured_deviations, lasting_window
from contourlab.arrays import Array, Complex, Flags, true_spans
from contourlab.errors import ParameterError
from contourlab.findings import Finding, finding

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
    order = np.arange(1, most + 1)
    speed = np.abs(y) * order
    steps = np.diff(run.position[first:last])
    still = float(np.mean(_still(steps)))
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


def _still(steps: Array) -> Flags:
    """Return whether the axis is at rest at each sample: its mean step over ten samples is small beside the median step."""
    usual = float(np.median(np.abs(steps)))
    count = min(10, steps.size)
    average = np.convolve(steps, np.ones(count) / count, "same")
    return np.asarray(np.abs(average) < 0.02 * max(usual, float(np.abs(average).max())))


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
    points: list[SinePoint] = []
    findings: list[Finding] = []
    periods: list[float] = []
    for run, name in zip(runs, names, strict=True):
        stretch = sine_stretch(run.command if run.outside is None else run.outside, run.period)
        if stretch is None:
            findings.append(finding("CL518", name))
            continue
        point = sine_point(run, *stretch)
        if point.still > STILL:
            findings.append(finding("CL519", name, share=float(point.still)))
            continue
        if point.distortion > DISTORTED:
            findings.append(finding("CL524", name, share=float(point.distortion), frequency=float(point.frequency)))
        if point.periods < 1.9:
            findings.append(finding("CL529", name, periods=float(point.periods), frequency=float(point.frequency)))
        points.append(point)
        periods.append(run.period)
    if not points:
        raise ParameterError("logs", f"{len(runs)} of them", "one with a sine in it: " + "; ".join(note.text for note in findings))
    # The shortest period is the servo period: a log of every tenth sample does not change how long a command is held.
    period = min(periods)
    if max(periods) > 1.001 * period:
        findings.append(finding("CL542", shortest=period, longest=max(periods)))
    points.sort(key=lambda p: p.frequency)
    columns = [np.array([getattr(p, key) for p in points]) for key in ("frequency", "response", "deviation", "coherence", "distortion")]
    frequency, response, deviation, coherence, distortion = columns
    return MeasuredResponse(frequency, response, deviation, coherence, "one sine a run, least squares", period, distortion, tuple(findings))
