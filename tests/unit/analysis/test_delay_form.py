"""Responses with delays extracted, against the solution of the whole system."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from contourlab.analysis.linear.tick_map import DelayForm

Z = np.exp(1j * np.array([1e-3, 0.1, 0.9, 2.0, np.pi]))


def whole(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
    return np.array([c @ np.linalg.solve(z * np.eye(len(a)) - a, b.astype(complex)) for z in Z])


@settings(max_examples=100, deadline=None)
@given(seed=st.integers(0, 2**32 - 1), dense=st.integers(1, 4), chains=st.integers(0, 3), length=st.integers(1, 9))
def test_equals_the_whole_system(seed: int, dense: int, chains: int, length: int) -> None:
    """A few coupled states, and delay chains with any start and taps, in any order."""
    rng = np.random.default_rng(seed)
    n = dense + chains * length
    a, b, c = np.zeros((n, n)), np.zeros((n, 2)), rng.normal(size=(3, n)) * rng.integers(0, 2, size=(3, n))
    a[:dense, :dense] = 0.4 * rng.normal(size=(dense, dense)) / dense
    b[:dense] = rng.normal(size=(dense, 2))
    for k in range(chains):
        first = dense + k * length
        a[first, rng.integers(0, first)] = 1.0
        for i in range(first + 1, first + length):
            a[i, i - 1] = 1.0
        a[rng.integers(0, dense), rng.integers(first, first + length)] += 0.1 * rng.normal()
    order = rng.permutation(n)
    a, b, c = a[np.ix_(order, order)], b[order], c[:, order]
    wanted = whole(a, b, c)
    assert np.abs(DelayForm(a, b, c)(Z) - wanted).max() < 1e-12 * (1.0 + np.abs(wanted).max())


def test_a_pure_delay() -> None:
    """An input through 40 states: z^-40; only the first state is left to solve."""
    a, b, c = np.diag(np.ones(39), -1), np.eye(40, 1), np.eye(1, 40, 39)
    form = DelayForm(a, b, c)
    assert form.longest == 39
    assert np.abs(form(Z)[:, 0, 0] - Z**-40.0).max() < 1e-13


def test_a_ring_of_states() -> None:
    """A ring without input has no first state; the rest of the system is unaffected."""
    a, b, c = np.zeros((3, 3)), np.zeros((3, 1)), np.array([[1.0, 0.0, 1.0]])
    a[0, 1] = a[1, 0] = 1.0
    a[2, 2], b[2] = 0.5, 1.0
    points = Z[1:4]  # the ring's own poles are at 1 and -1
    assert np.abs(DelayForm(a, b, c)(points)[:, 0, 0] - 1.0 / (points - 0.5)).max() < 1e-12


def test_an_input_makes_a_state_more_than_a_delay() -> None:
    a, b = np.array([[0.5, 0.0], [1.0, 0.0]]), np.array([[1.0], [2.0]])
    c = np.eye(2)
    assert np.abs(DelayForm(a, b, c)(Z) - whole(a, b, c)).max() < 1e-12


def test_an_output_that_nothing_reaches() -> None:
    for a in (0.5 * np.eye(2), np.zeros((2, 2))):
        found = DelayForm(a, np.ones((2, 1)), np.zeros((1, 2)))(Z)
        assert found.shape == (Z.size, 1, 1)
        assert not found.any()
