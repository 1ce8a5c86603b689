"""Deviations for a coloured residual: one sum under several windows."""

from __future__ import annotations

import numpy as np
import pytest

from contourlab.analysis.identification.least_squares import (
    bartlett,
    coloured_deviations,
    flat_top,
    lasting_window,
    long_run,
    memory,
    parzen,
)

WINDOWS = {"bartlett": bartlett(7), "parzen": parzen(9), "flat": flat_top(4), "longer than the record": bartlett(500), "none": bartlett(0)}


@pytest.mark.parametrize("window", WINDOWS.values(), ids=WINDOWS)
@pytest.mark.parametrize("n", [40, 127, 128])
def test_the_sum_equals_its_definition(window: np.ndarray, n: int) -> None:
    rows = np.random.default_rng(n).standard_normal((n, 3))
    wanted = rows.T @ rows
    for lag in range(1, min(window.size, n)):
        ahead = rows[lag:].T @ rows[:-lag]
        wanted += window[lag] * (ahead + ahead.T)
    assert long_run(rows, window) == pytest.approx(wanted, rel=1e-10, abs=1e-9)


@pytest.mark.parametrize("window", [bartlett(9), parzen(9), flat_top(5)])
def test_windows_begin_at_one_and_end_near_zero(window: np.ndarray) -> None:
    assert window[0] == 1.0 and np.all(np.diff(window) <= 0.0) and 0.0 < window[-1] <= 0.2


def test_memory_is_the_lag_beyond_which_little_correlation_is_left() -> None:
    from scipy.signal import lfilter

    noise = lfilter([1.0], [1.0, -0.9], np.random.default_rng(0).standard_normal(200_000))
    assert memory(noise, 0.1, 1000) == pytest.approx(np.log(0.1) / np.log(0.9), rel=0.1)
    assert memory(np.ones(100), 0.1, 20) == 20 and memory(np.zeros(100), 0.1, 20) == 0


def test_deviations_match_the_scatter_under_coloured_noise() -> None:
    """A slow regressor under correlated noise: white deviations would be three times too small."""
    from scipy.signal import lfilter

    rng, n = np.random.default_rng(1), 4000
    slow = np.column_stack([np.ones(n), lfilter([1.0], [1.0, -0.97], rng.standard_normal(n))])
    inverse = np.linalg.inv(slow.T @ slow)
    found, told, white = [], [], []
    for _ in range(200):
        noise = lfilter([1.0], [1.0, -0.9], rng.standard_normal(n))
        x = inverse @ slow.T @ noise
        left = noise - slow @ x
        found.append(x[1])
        told.append(coloured_deviations(slow, left, inverse, lasting_window(left))[1])
        white.append(np.sqrt(inverse[1, 1] * left.var()))
    assert np.median(told) == pytest.approx(np.std(found), rel=0.2)
    assert np.median(white) < 0.4 * np.std(found)
