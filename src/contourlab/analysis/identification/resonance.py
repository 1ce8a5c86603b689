"""Identify a resonance from a measured acceleration alone: its frequency and its damping ratio, with deviations.

References
----------
Whittle, "The analysis of multiple stationary time series", Journal of the Royal Statistical Society B, 15:125, 1953: likelihood of spectra.
Au, "Operational modal analysis", Springer 2017, chapters 10 and 13: one mode in a band of the spectrum, from a response alone.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.identification import least_squares
from contourlab.analysis.identification.least_squares import Estimate, deviation_findings
from contourlab.arrays import Array
from contourlab.errors import ParameterError, refuse
from contourlab.findings import Finding

NAMES = ("frequency", "damping_ratio")
RESOLUTION = 1.0
"""Resolution [Hz] of the spectrum in which the largest peak is looked for."""
LOWEST, HIGHEST = 4.0, 0.8
"""Range of the search: lines of that spectrum from zero, and share of the Nyquist frequency."""
BAND = 1.5
"""The fit covers the peak's frequency over this, up to this times it."""
DAMPINGS = (0.003, 0.01, 0.03, 0.1, 0.3)
"""Damping ratios to start from; the range of the fit is 3 times wider at both ends."""
FEWEST_LINES = 30
"""Fewest lines of the spectrum in the band."""
RESOLVED = 3.0
"""Fewest lines of the spectrum in the width of the resonance; a forced vibration has one."""
FORM = np.array([2e-4, 0.02])
"""Least relative deviations of frequency and damping ratio: excitation and neighbouring modes shape a peak, too."""
CLEAR = 15.0
"""Least gain of log likelihood by the resonance, over a spectrum without one."""
EXCITED = "a record in which a resonance is excited"


@dataclass(frozen=True, eq=False)
class ResonanceFit(Estimate):
    """The largest resonance of a record.

    Attributes
    ----------
    spectrum_frequency : ndarray (n,) [Hz]
        Lines of the band.
    spectrum, predicted : ndarray (n,)
        Measured power at each, and its expectation from the model.
    usable : bool
        Whether frequency and damping are known to within a tenth and a half.
    findings : tuple of Finding
    """

    spectrum_frequency: Array
    spectrum: Array
    predicted: Array
    usable: bool
    findings: tuple[Finding, ...]


def identify_resonance(acceleration: ArrayLike, period: float) -> ResonanceFit:
    """Identify the largest resonance in an acceleration, excited by anything with a smooth spectrum: noise, a sweep, a blow.

    Parameters
    ----------
    acceleration : array_like (n,) [m/s^2]
        Evenly sampled.
    period : float [s], > 0

    Returns
    -------
    ResonanceFit
        With the frequency [Hz] of the undamped resonance, and its damping ratio.

    Raises
    ------
    ParameterError
        If the record is too short or not finite, or its spectrum has no resonance that it resolves.

    Notes
    -----
    Around the peak the power is ``A r^p / ((1 - r^2)^2 + (2 D r)^2) + B`` with r = f/f_r: slope p and level B take in what excites and
    what else moves. Each line of the periodogram scatters like an exponential variable about it. The robust deviations take
    the scatter that is there, correlated over neighbouring lines: that of a sweep or a blow is smaller. They are `FORM` at least.
    """
    a = np.asarray(acceleration, dtype=float)
    refuse(not np.isfinite(a).all(), ParameterError, "acceleration", "not finite", "finite")
    lines = np.asarray(np.fft.rfftfreq(a.size, period), dtype=float)
    power = np.asarray(np.abs(np.fft.rfft(a - a.mean())) ** 2, dtype=float)
    peak = _peak(a, period)
    band = (lines > peak / BAND) & (lines < peak * BAND)
    f, p = lines[band], power[band]
    if f.size < FEWEST_LINES or not p.max(initial=0.0) > 0.0:
        raise ParameterError("acceleration", f"{a.size * period:.3g} s", f"longer, for {FEWEST_LINES} lines around {peak:.4g} Hz")
    scale = float(p.mean())
    values, gain = _fitted(f, p / scale, peak)
    frequency, damping = math.exp(values[0]), math.exp(values[1])
    width = 2.0 * damping * frequency * a.size * period
    refuse(gain < CLEAR, ParameterError, "acceleration", f"no clear peak near {peak:.4g} Hz", EXCITED)
    wide = f"{RESOLVED:g} lines or wider: a forced vibration is narrower; a resonance needs a longer record"
    refuse(width < RESOLVED, ParameterError, "acceleration", f"a peak at {frequency:.4g} Hz, {width:.2g} lines wide", wide)
    steps, expected = 1e-5 * np.eye(values.size), np.exp(_log(f, values))
    slopes = np.column_stack([(_log(f, values + step) - _log(f, values - step)) / 2e-5 for step in steps])
    inverse = np.asarray(np.linalg.pinv(slopes.T @ slopes), dtype=float)
    residual = np.asarray(p / (scale * expected) - 1.0, dtype=float)
    white = np.sqrt(np.diag(inverse))
    faded = least_squares.memory(residual, least_squares.FADED, f.size // least_squares.LONGEST)
    window = least_squares.bartlett(max(least_squares.usual_lags(f.size), 2 * faded))
    robust = least_squares.coloured_deviations(slopes, residual, inverse, window)
    physical = np.array([frequency, damping])
    known = physical * np.hypot(robust[:2], FORM)
    findings = *deviation_findings(NAMES[0], frequency, known[0]), *deviation_findings(NAMES[1], damping, known[1])
    usable = bool(known[0] < 0.1 * frequency and known[1] < 0.5 * damping and peak / BAND < frequency < peak * BAND)
    estimate = NAMES, physical, physical * white[:2], known, least_squares.correlation_of(inverse[:2, :2])
    return ResonanceFit(*estimate, f, p, scale * expected, usable, findings)


def _peak(a: Array, period: float) -> float:
    """Return the frequency [Hz] of the largest peak of the averaged spectrum."""
    from scipy.signal import welch

    f, power = welch(a, 1.0 / period, nperseg=min(a.size, max(round(1.0 / (RESOLUTION * period)), 16)))
    inner = np.arange(1, f.size - 1)
    inner = inner[(power[inner] >= power[inner - 1]) & (power[inner] > power[inner + 1])]
    inner = inner[(f[inner] >= LOWEST * f[1]) & (f[inner] <= HIGHEST * f[-1])]
    refuse(not inner.size, ParameterError, "acceleration", "no peak in its spectrum", EXCITED)
    return float(f[inner[np.argmax(power[inner])]])


def _log(f: Array, values: Array) -> Array:
    """Return the logarithm of the expected power (n,)."""
    centre, damping, level, slope, floor = values
    r = f / math.exp(centre)
    return np.asarray(np.logaddexp(level + slope * np.log(r) - np.log((1.0 - r**2) ** 2 + (2.0 * math.exp(damping) * r) ** 2), floor))


def _fitted(f: Array, power: Array, peak: float) -> tuple[Array, float]:
    """Return the parameters of the largest likelihood, and its gain over a spectrum without a resonance."""
    from scipy.optimize import minimize

    def fit(law: Callable[[Array], Array], start: list[float], bounds: list[tuple[float, float]]) -> Any:
        def cost(values: Array) -> float:
            expected = law(values)
            return float(np.sum(expected + power * np.exp(-expected)))

        return minimize(cost, start, method="L-BFGS-B", bounds=bounds)

    low = math.log(f[0]), math.log(DAMPINGS[0] / 3.0), -40.0, -8.0, -40.0
    high = math.log(f[-1]), math.log(DAMPINGS[-1] * 3.0), 20.0, 8.0, 5.0
    starts = [[math.log(peak), math.log(d), math.log(float(power.max()) * d**2), 0.0, -3.0] for d in DAMPINGS]
    fits = [fit(lambda values: _log(f, values), start, [*zip(low, high, strict=True)]) for start in starts]
    best = min(fits, key=lambda one: one.fun)
    plain = fit(lambda line: line[0] + line[1] * np.log(f / peak), [0.0, 0.0], [(-20.0, 20.0)] * 2)
    return np.asarray(best.x), float(plain.fun - best.fun)
