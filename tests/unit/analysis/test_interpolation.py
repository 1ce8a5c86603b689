"""Higher-order sinusoids and counts, against their definitions."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.special import eval_chebyt, eval_chebyu

from contourlab.analysis.encoder import SinusoidTable, interpolation_order
from contourlab.errors import ParameterError

TURN = 2.0 * math.pi


def test_one_micron_becomes_25_and_10_nanometres() -> None:
    """A scale of 1 um after the fourfold count has a pitch of 4 um."""
    assert interpolation_order(4e-6, 1e-6) == 1
    assert interpolation_order(4e-6, 25e-9) == 40
    assert interpolation_order(4e-6, 10e-9) == 100
    assert interpolation_order(20e-6, 25e-9) == 200


@pytest.mark.parametrize("resolution", [30e-9, 3e-6, 4e-6, 1e-15])
def test_other_resolutions_are_refused_with_the_nearest_valid_one(resolution: float) -> None:
    with pytest.raises(ParameterError, match="such as"):
        interpolation_order(4e-6, resolution)
    for bad in (0.0, -1.0, math.inf, math.nan):
        with pytest.raises(ParameterError, match="pitch"):
            interpolation_order(bad, 1e-6)


@given(order=st.integers(1, 200), seed=st.integers(0, 99), size=st.floats(1e-6, 1e6))
def test_the_table_holds_chebyshev_polynomials(order: int, seed: int, size: float) -> None:
    """sin(n phi) = sin(phi) U_{n-1}(cos phi), cos(n phi) = T_n(cos phi), within 1/(8 64^2) of linear interpolation (n = 1: finer)."""
    phase = np.random.default_rng(seed).uniform(-math.pi, math.pi, 500)
    c, s = SinusoidTable(order).sinusoids(size * np.cos(phase), size * np.sin(phase))
    np.testing.assert_allclose(s, np.sin(phase) * eval_chebyu(order - 1, np.cos(phase)), rtol=0.0, atol=4e-5)
    np.testing.assert_allclose(c, eval_chebyt(order, np.cos(phase)), rtol=0.0, atol=4e-5)


def test_the_error_of_a_finer_table_falls_with_its_square() -> None:
    phase = np.linspace(-math.pi, math.pi, 5000)
    worst = []
    for entries in (640, 1280, 2560):
        _, s = SinusoidTable(10, entries).sinusoids(np.cos(phase), np.sin(phase))
        worst.append(float(np.abs(s - np.sin(10.0 * phase)).max()))
    assert worst[0] / worst[1] == pytest.approx(4.0, rel=0.1)
    assert worst[1] / worst[2] == pytest.approx(4.0, rel=0.1)
    with pytest.raises(ParameterError, match="entries"):
        SinusoidTable(10, 39)
    with pytest.raises(ParameterError, match="order"):
        SinusoidTable(0)


@given(order=st.integers(1, 250), speed=st.floats(-0.499, 0.499), start=st.floats(-0.49, 0.49))
def test_counts_are_the_position_over_the_resolution(order: int, speed: float, start: float) -> None:
    """Over many pitches, both ways, up to half a pitch from one sample to the next."""
    turns = start + speed * np.arange(600)
    counted = SinusoidTable(order).count(np.cos(TURN * turns), np.sin(TURN * turns))
    exact = 4 * order * turns
    sure = np.abs(exact - np.floor(exact) - 0.5) > 1e-4  # at the border between two counts the table's 3e-5 decides
    assert np.array_equal(counted.counts[sure], np.rint(exact[sure]))
    assert not counted.missed.any()


def test_the_count_continues_over_a_long_motion_with_reversals() -> None:
    time = np.arange(200_000)
    turns = 2500.0 * np.sin(TURN * time / 60_000.0)
    counted = SinusoidTable(40).count(np.cos(TURN * turns), np.sin(TURN * turns))
    exact = 160.0 * turns
    sure = np.abs(exact - np.floor(exact) - 0.5) > 1e-3
    assert np.array_equal(counted.counts[sure], np.rint(exact[sure]))
    assert not counted.missed.any()
    assert counted.counts.max() == 400_000 and counted.counts.min() == -400_000


@given(top=st.floats(0.52, 0.9), order=st.sampled_from([1, 5, 40]))
def test_the_start_of_excessive_speed_is_marked(top: float, order: int) -> None:
    speed = np.concatenate([np.linspace(0.0, top, 200), np.full(50, top), np.linspace(top, 0.0, 200)])
    turns = np.cumsum(speed)
    counted = SinusoidTable(order).count(np.cos(TURN * turns), np.sin(TURN * turns))
    assert counted.missed.any()
    first = int(np.argmax(counted.missed))
    # The speed rises by 1/199 of its maximum per sample.
    assert 0.5 <= float(speed[first]) <= 0.5 + top / 199.0
    right = np.abs(counted.counts[: first - 1] / (4.0 * order) - turns[: first - 1]) <= 0.5 / (4 * order) + 1e-6
    assert right.all()
    lost = turns[-1] - counted.counts[-1] / (4.0 * order)
    assert lost > 0.9


def test_a_slow_motion_is_counted_completely() -> None:
    turns = 3.0 * np.sin(TURN * np.arange(40_000) / 30_000.0)
    found = SinusoidTable(100).count(np.cos(TURN * turns), np.sin(TURN * turns))
    assert not found.missed.any()
    assert found.counts.max() == 1200 and found.counts.min() == -1200


def test_zero_signals_give_a_count_of_zero() -> None:
    """Both signals at zero have no angle: the table returns one, and nothing fails."""
    assert SinusoidTable(40).in_period([0.0], [0.0]).tolist() == [0]
