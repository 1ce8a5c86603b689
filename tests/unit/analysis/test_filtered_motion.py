"""Zero-phase filters, differences, and decimation with the phase of MATLAB's."""

from __future__ import annotations

import math

import numpy as np
import pytest
from refusals import refuses

from contourlab.analysis.identification.filtered_motion import decimate, filtered_motion
from contourlab.errors import ParameterError

PERIOD = 1e-3


@pytest.mark.parametrize("n", range(400, 411))
@pytest.mark.parametrize("factor", [2, 7, 10])
def test_decimation_keeps_the_same_samples_as_matlab(n: int, factor: int) -> None:
    """MATLAB counts from 1: the first is r - (r ceil(n/r) - n), so the last is n."""
    kept = decimate(np.arange(n, dtype=float), factor)
    gain = 10.0 ** (-2.0 * 0.05 / 20.0)  # at rest an even Chebyshev filter is at the bottom of its ripple; here it runs twice
    middle = slice(kept.size // 3, -kept.size // 3)
    first = factor - (factor * math.ceil(n / factor) - n) - 1
    wanted = np.arange(first, n, factor)
    assert kept.size == wanted.size == math.ceil(n / factor)
    assert wanted[-1] == n - 1
    np.testing.assert_allclose(kept[middle] / gain, wanted[middle], atol=0.2)


def test_decimation_removes_aliases_and_little_else() -> None:
    t = PERIOD * np.arange(5000)
    low, high = (decimate(np.sin(2.0 * math.pi * f * t), 10) for f in (10.0, 60.0))
    inside = slice(20, -20)
    assert np.abs(low).max() == pytest.approx(1.0, abs=0.02)
    assert np.abs(high[inside]).max() < 2e-3
    np.testing.assert_allclose(low[inside], np.sin(2.0 * math.pi * 10.0 * t[9::10])[inside], atol=0.02)


def test_columns_are_decimated_alike_and_a_factor_of_one_changes_nothing() -> None:
    values = np.random.default_rng(1).normal(size=(300, 3))
    np.testing.assert_array_equal(decimate(values, 5)[:, 1], decimate(values[:, 1], 5))
    np.testing.assert_array_equal(decimate(values, 1), values)


def test_filtered_motion_has_no_lag_and_half_its_amplitude_at_the_cut_off() -> None:
    t = PERIOD * np.arange(4000)
    inside = slice(200, -200)
    w = 2.0 * math.pi * 3.0
    motion = filtered_motion(np.sin(w * t), PERIOD, cutoff=100.0)
    # Differences over two periods miss (w T)^2/6 = 6e-5 of the velocity, twice that of the acceleration.
    np.testing.assert_allclose(motion.velocity[inside], w * np.cos(w * t)[inside], atol=1e-4 * w)
    np.testing.assert_allclose(motion.acceleration[inside], -w * w * np.sin(w * t)[inside], atol=2e-4 * w * w)
    at_edge = filtered_motion(np.sin(2.0 * math.pi * 100.0 * t), PERIOD, cutoff=100.0).position[inside]
    assert math.sqrt(2.0 * np.mean(at_edge**2)) == pytest.approx(0.5, abs=1e-3)


@pytest.mark.parametrize(
    ("options", "word"),
    [({"cutoff": 500.0}, "Nyquist.* 500"), ({"cutoff": 0.0}, "> 0")],
)
def test_an_invalid_filter_is_refused(options: dict[str, float], word: str) -> None:
    with pytest.raises(ParameterError, match=word):
        filtered_motion(np.zeros(100), PERIOD, **options)  # type: ignore[arg-type]


def test_records_shorter_than_a_filter_are_refused() -> None:
    with refuses(ParameterError, r"the 12\b", name="position", value="12 samples"):
        filtered_motion(np.zeros(12), PERIOD, cutoff=50.0)
    with refuses(ParameterError, name="record", value="24 samples"):
        decimate(np.zeros(24), 2)
