"""The first zero of a cubic within a step, against all of its zeros."""

from __future__ import annotations

import numpy as np
from hypothesis import assume, example, given
from hypothesis import strategies as st
from numpy.typing import NDArray

from contourlab.components.mechanics.laws import NEVER, first_dip, first_zero, hermite

SIZES = st.floats(-6.0, 0.0).map(lambda e: 10.0**e)
SLOPES = st.floats(-10.0, 10.0)


def zeros(y0: float, y1: float, d0: float, d1: float) -> NDArray[np.float64]:
    """Return the zeros within the step, in order; sign changes on a fine grid, polished by halving."""
    grid = np.linspace(0.0, 1.0, 4001)
    values = np.array([hermite(float(u), y0, y1, d0, d1) for u in grid])
    found = []
    for i in np.flatnonzero((values[:-1] > 0.0) != (values[1:] > 0.0)):
        low, high = grid[i], grid[i + 1]
        for _ in range(60):
            middle = 0.5 * (low + high)
            same = (hermite(middle, y0, y1, d0, d1) > 0.0) == (values[i] > 0.0)
            low, high = (middle, high) if same else (low, middle)
        found.append(high)
    return np.array(found)


@given(y0=SIZES, y1=SIZES, d0=SLOPES, d1=SLOPES)
@example(y0=1.0, y1=1.0, d0=-1.0, d1=-1.0)  # Newton's method goes from one end to the other and back
def test_the_first_fall_through_zero_is_found(y0: float, y1: float, d0: float, d1: float) -> None:
    u = first_zero(y0, -y1, d0, d1)
    # As accurate as the rounding of the cubic allows.
    assert abs(hermite(u, y0, -y1, d0, d1)) <= 1e-14 * (y0 + y1 + abs(d0) + abs(d1))
    every = zeros(y0, -y1, d0, d1)
    assume(np.diff(every).min(initial=1.0) > 1e-3)
    ahead = np.linspace(0.0, max(u - 1e-6, 0.0), 50)
    assert (np.array([hermite(float(x), y0, -y1, d0, d1) for x in ahead]) > -1e-12).all()


@given(y0=SIZES, y1=SIZES, d0=SLOPES, d1=SLOPES)
def test_a_dip_below_zero_is_found(y0: float, y1: float, d0: float, d1: float) -> None:
    u = first_dip(y0, y1, d0, d1)
    deepest = min(hermite(float(x), y0, y1, d0, d1) for x in np.linspace(0.0, 1.0, 2001))
    if d0 < 0.0 < d1 and deepest < -1e-9:
        assert abs(hermite(u, y0, y1, d0, d1)) <= 1e-13 * (y0 + y1 + abs(d0) + abs(d1))
        assert u < 1.0
    elif deepest > 1e-9 or d0 >= 0.0 or d1 <= 0.0:
        assert u == NEVER


def test_a_cubic_that_starts_at_zero_falls_later_or_at_once() -> None:
    """x (1/2 - x) starts at zero and falls through it half way; -x falls at once."""
    assert abs(first_zero(0.0, -0.5, 0.5, -1.5) - 0.5) < 1e-15
    assert first_zero(0.0, -1.0, -1.0, -1.0) < 1e-15
