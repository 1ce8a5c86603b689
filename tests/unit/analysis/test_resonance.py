"""A resonance from an acceleration alone, against one that an exact discrete-time oscillator has, whatever excites it."""

from __future__ import annotations

import math

import numpy as np
import pytest
from refusals import refuses
from scipy.signal import cont2discrete, lfilter

from contourlab.analysis.identification.resonance import ResonanceFit, identify_resonance
from contourlab.arrays import Array
from contourlab.errors import ParameterError

PERIOD = 1.0 / 1600.0
CASES = [(47.3, 0.06), (80.0, 0.02), (35.0, 0.15)]


def heard(base: Array, frequency: float, damping: float) -> Array:
    """Return the acceleration of a mass on a spring whose foot has an acceleration (n,), linear between samples."""
    w = math.tau * frequency
    top, bottom, _ = cont2discrete(([2.0 * damping * w, w * w], [1.0, 2.0 * damping * w, w * w]), PERIOD, "foh")
    return np.asarray(lfilter(np.ravel(top), bottom, base))


def noise(rng: np.random.Generator, n: int) -> tuple[Array, float]:
    return rng.standard_normal(n), 0.05


def sweep(rng: np.random.Generator, n: int) -> tuple[Array, float]:
    """Return a sweep from 5 to 133 Hz whose acceleration grows with the frequency, as firmware for printers makes it."""
    frequency = np.linspace(5.0, 133.0, n)
    return 0.075 * frequency * np.sin(math.tau * np.cumsum(frequency) * PERIOD), 0.3


def blow(rng: np.random.Generator, n: int) -> tuple[Array, float]:
    base = np.zeros(n)
    base[100:104] = 5.0
    return base, 0.002


def fit_of(excite: object, seed: int, n: int, frequency: float, damping: float) -> ResonanceFit:
    rng = np.random.default_rng(seed)
    base, level = excite(rng, n)  # type: ignore[operator]
    return identify_resonance(heard(base, frequency, damping) + level * rng.standard_normal(n), PERIOD)


@pytest.mark.parametrize(("frequency", "damping"), CASES)
@pytest.mark.parametrize(("excite", "n"), [(noise, 24_000), (sweep, 60_000), (blow, 6_400)])
def test_frequency_and_damping_within_their_deviations(excite: object, n: int, frequency: float, damping: float) -> None:
    fit = fit_of(excite, 1, n, frequency, damping)
    assert fit.usable
    for name, true in (("frequency", frequency), ("damping_ratio", damping)):
        assert abs(fit[name] - true) < 3.0 * fit.deviation(name)


@pytest.mark.slow
@pytest.mark.parametrize(("frequency", "damping"), CASES)
def test_the_deviations_are_those_of_repeated_records(frequency: float, damping: float) -> None:
    """Of 40 records: the scatter is the deviation, within a third, and so is the root mean square of the errors."""
    fits = [fit_of(noise, seed, 12_000, frequency, damping) for seed in range(40)]
    for name, true in (("frequency", frequency), ("damping_ratio", damping)):
        errors = np.array([(fit[name] - true) / fit.deviation(name) for fit in fits])
        assert 0.67 < math.sqrt(float(np.mean(errors**2))) < 1.33
        assert 0.67 < float(errors.std()) < 1.33


def test_what_shows_no_resonance_is_refused() -> None:
    rng, time = np.random.default_rng(0), PERIOD * np.arange(16_000)
    for acceleration, word in (
        (rng.standard_normal(16_000), "excited"),
        (np.sin(math.tau * 50.0 * time) + 0.01 * rng.standard_normal(16_000), "forced"),
        (heard(rng.standard_normal(400), 40.0, 0.05), "longer"),
        (np.full(16_000, np.nan), "finite"),
        (np.zeros(16_000), "excited"),
        (np.ones(5), "excited"),
    ):
        with refuses(ParameterError, word, name="acceleration"):
            identify_resonance(acceleration, PERIOD)
