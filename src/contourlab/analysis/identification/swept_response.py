"""Frequency response from a sweep, by local polynomials over the spectrum of the whole record.

A sweep passes each frequency once, so that there is nothing to average over segments, and what the axis still does at the ends of the
record leaks into every frequency. Over a few neighbouring lines both the response and that leakage are smooth: parabolas for the two are
fitted together, and what they leave is the noise.

References
----------
Pintelon & Schoukens, "System Identification: a frequency domain approach", 2nd ed., chapter 7 (the local polynomial method).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.identification.frequency_response import Measured, MeasuredResponse, difference_gain
from contourlab.errors import ParameterError

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
FEWEST_LINES, WIDTH = 15, 0.08
"""Lines of a window: at least so many, and so large a share of its frequency."""
EXCITED = 1e-2
"""Share of the largest power below which the sweep has not come to a frequency."""
MIXED = 3.0
"""How much larger than without leakage the variance may be: where the sweep begins and ends its spectrum is as smooth as the leakage."""
PARTS, APART = 8, 0.25
"""Parts of an excitation whose mean frequencies are compared, and their spread over their mean from which it is a sweep."""


def is_sweep(excitation: Array) -> bool:
    """Tell whether an excitation passes from frequency to frequency, rather than holding all of them at all times."""
    parts = np.array_split(excitation - excitation.mean(), PARTS)
    powers = [np.abs(np.fft.rfft(part * np.hanning(part.size), parts[0].size)) ** 2 for part in parts]
    means = np.array([float(np.sum(np.arange(p.size) * p) / max(float(p.sum()), 1e-300)) for p in powers])
    return bool(means.std() > APART * means.mean())


def swept_response(run: Measured) -> MeasuredResponse:
    """Return the response of an axis from one run with a sweep in it.

    Parameters
    ----------
    run : Measured

    Raises
    ------
    ParameterError
        If the run is too short.
    """
    n = run.position.size - 1
    if n < 40 * FEWEST_LINES:
        raise ParameterError("record", f"{n + 1} samples", f"at least {40 * FEWEST_LINES + 1} for a sweep")
    signals = {"y": np.diff(run.position) / run.period, "u": run.command[1:]}
    signals["x"] = signals["u"] if run.outside is None else run.outside[1:]
    spectra = {name: np.fft.rfft(values - values.mean()) for name, values in signals.items()}
    power = np.abs(spectra["x"]) ** 2
    level = np.convolve(power, np.ones(FEWEST_LINES) / FEWEST_LINES, "same")
    top, centres, rows = float(level.max()), [], []
    at = 1 + FEWEST_LINES // 2
    while (half := max(FEWEST_LINES // 2, round(0.5 * WIDTH * at))) + at < 0.45 * n:
        if level[at] > EXCITED * top:
            window = slice(at - half, at + half + 1)
            row = _local(spectra["x"][window], spectra["y"][window], spectra["u"][window], run.outside is not None)
            rows += [] if row is None else [row]
            centres += [] if row is None else [at]
        at += max(FEWEST_LINES // 2, half)
    if not rows:
        raise ParameterError("record", "a sweep", "slower: nothing of it is told apart from what leaks from the ends of the record")
    frequency = np.array(centres) / (n * run.period)
    response, deviation, coherence = (np.array(column) for column in zip(*rows, strict=True))
    own = response / difference_gain(frequency, run.period)
    method = f"sweep of {n * run.period:.4g} s, local polynomials" + ("" if run.outside is None else ", reference to position over command")
    return MeasuredResponse(frequency, own, deviation, coherence, method, run.period, np.full(frequency.size, np.nan))


def _local(x: Complex, y: Complex, u: Complex, closed: bool) -> tuple[complex, float, float] | None:
    """Return the response in the middle of a window, its relative deviation, and the coherence; None where leakage mixes with it."""
    r = np.linspace(-1.0, 1.0, x.size)
    powers = np.column_stack([np.ones_like(r), r, r**2]).astype(complex)
    size = float(np.sqrt(np.mean(np.abs(x) ** 2)))
    columns = np.column_stack([powers * (x / size)[:, None], powers])
    inverse = np.linalg.pinv(columns)
    spread = float(np.sum(np.abs(inverse[0]) ** 2))
    if spread * x.size > MIXED * 2.25:  # 9/4 over the lines is what a parabola alone has in its middle
        return None

    def solved(signal: Complex) -> tuple[complex, float, float]:
        found = inverse @ signal
        left = float(np.sum(np.abs(signal - columns @ found) ** 2))
        variance = left / (x.size - 6)
        explained = float(np.sum(np.abs(columns[:, :3] @ found[:3]) ** 2))
        return complex(found[0]), spread * variance / 2.0, explained / (explained + left)

    top, top_variance, coherence = solved(y)
    if not closed:
        return top / size, float(np.sqrt(top_variance)) / abs(top), coherence
    below, below_variance, _ = solved(u)
    return top / below, float(np.sqrt(top_variance / abs(top) ** 2 + below_variance / abs(below) ** 2)), coherence
