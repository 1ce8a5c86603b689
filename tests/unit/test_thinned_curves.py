"""Decimation keeps the visible: ends and extremes."""

from __future__ import annotations

import time

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from contourlab.errors import ParameterError
from contourlab.rendering.samples import share
from contourlab.thinning import keep_extremes

FINITE = st.floats(-1e6, 1e6)


@settings(deadline=None, max_examples=200)
@given(arrays(np.float64, st.integers(1, 400), elements=FINITE), st.integers(4, 64))
def test_extremes_and_ends_survive_within_the_budget(values, budget):
    kept = keep_extremes(values, budget)
    assert kept.size <= max(budget, 1)
    assert kept[0] == 0 and kept[-1] == values.size - 1
    assert np.all(np.diff(kept) > 0)
    assert values[kept].max() == values.max() and values[kept].min() == values.min()


@settings(deadline=None, max_examples=100)
@given(arrays(np.float64, st.tuples(st.integers(1, 300), st.just(3)), elements=FINITE), st.integers(12, 90))
def test_every_column_keeps_its_extremes(values, budget):
    kept = keep_extremes(values, budget)
    assert kept.size <= budget or kept.size == len(values)
    np.testing.assert_array_equal(values[kept].max(axis=0), values.max(axis=0))
    np.testing.assert_array_equal(values[kept].min(axis=0), values.min(axis=0))


@settings(deadline=None, max_examples=100)
@given(arrays(np.float64, st.integers(5, 300), elements=st.one_of(FINITE, st.just(np.nan))), st.integers(4, 40))
def test_gaps_are_never_taken_for_extremes(values, budget):
    kept = keep_extremes(values, budget)
    if np.isfinite(values).any():
        assert np.nanmax(values[kept]) == np.nanmax(values)
        assert np.nanmin(values[kept]) == np.nanmin(values)


@settings(deadline=None, max_examples=100)
@given(arrays(np.float64, st.integers(200, 900), elements=FINITE), st.integers(8, 64))
def test_each_interval_keeps_its_own_extremes(values, budget):
    kept = set(keep_extremes(values, budget).tolist())
    width = -(-values.size // (budget // 4))
    for start in range(0, values.size, width):
        part = values[start : start + width]
        chosen = [values[k] for k in range(start, start + part.size) if k in kept]
        assert max(chosen) == part.max() and min(chosen) == part.min()


def test_short_signals_are_kept_whole():
    np.testing.assert_array_equal(keep_extremes(np.arange(10.0), 10), np.arange(10))


def test_a_single_spike_in_a_million_samples_survives():
    values = np.zeros(1_000_000)
    values[123_457] = 1.0
    assert 123_457 in keep_extremes(values, 2000)


def test_too_small_a_budget_names_the_minimum():
    with pytest.raises(ParameterError, match=r"\b4\b.*\b12\b"):
        keep_extremes(np.zeros((100, 3)), 11)


def test_the_total_is_shared_and_each_curve_bounded():
    assert share(1000, 3, 4000) == 333
    assert share(1_000_000, 3, 4000) == 4000


def test_cost_is_linear():
    def seconds(n):
        values = np.random.default_rng(0).standard_normal(n)
        best = np.inf
        for _ in range(5):
            start = time.perf_counter()
            keep_extremes(values, 4000)
            best = min(best, time.perf_counter() - start)
        return best

    assert seconds(4_000_000) < 8 * 4 * max(seconds(1_000_000), 5e-4)
