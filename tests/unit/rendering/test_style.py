"""The scale of drawings goes in steps of 1, 2 and 5."""

from __future__ import annotations

import math

from hypothesis import given
from hypothesis import strategies as st

from contourlab.rendering.style import magnification, round_down


@given(st.floats(1e-9, 1e9))
def test_round_down_is_the_next_step_below(value):
    step = round_down(value)
    assert step <= value * (1 + 1e-9) and value < step * 2.5 * (1 + 1e-9)


@given(st.floats(1e-3, 10.0), st.floats(1e-9, 1e-3))
def test_magnified_error_covers_about_a_tenth_of_the_drawing(extent, largest):
    factor = magnification(extent, largest)
    assert factor >= 1.0
    assert factor == 1.0 or 0.039 * extent < factor * largest <= 0.1001 * extent


def test_magnification_without_errors_is_one():
    assert magnification(0.1, 0.0) == magnification(0.0, 1e-6) == magnification(0.1, math.inf) == 1.0
