"""Numbers in print keep their value and their unit."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from contourlab.report.text import magnification, nominal, number, plain_unit, quantity, round_down, shown_unit
from contourlab.units import from_si


@given(st.floats(1e-12, 1e12), st.booleans(), st.integers(1, 8))
def test_a_number_reads_back_to_its_digits(value, negative, digits):
    value = -value if negative else value
    shown = float(number(value, digits).replace("−", "-"))
    assert shown == pytest.approx(value, rel=0.51 * 10.0 ** (1 - digits))


@given(st.floats(1e-5, 1e6), st.integers(2, 6))
def test_a_number_never_shows_more_than_its_digits(value, digits):
    shown = number(value, digits).lstrip("0.").replace(".", "")
    assert len(shown) <= max(digits, len(str(round(value))))


@pytest.mark.parametrize(("value", "text"), [(0.0, "0"), (math.nan, "–"), (math.inf, "∞"), (-math.inf, "−∞"), (9.996, "10.0")])
def test_particular_numbers(value, text):
    assert number(value) == text


def test_a_missing_quantity_has_no_unit():
    assert quantity(math.nan, "µm", 1e6) == "–"


@pytest.mark.parametrize("unit", ["m", "m/s", "rad"])
def test_print_units_agree_with_the_unit_registry(unit):
    factor, shown = shown_unit(unit)
    assert factor == pytest.approx(from_si(1.0, shown))


def test_plain_units_are_ascii():
    assert plain_unit("µm·s").isascii() and plain_unit("m/s²") == "m/s^2"


def test_given_values_have_no_trailing_zeros():
    assert nominal(5e-6, "µm", 1e6) == "5 µm"
    assert nominal(-0.02, "mm", 1e3) == "−20 mm"


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
