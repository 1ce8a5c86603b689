"""Printed figures keep their value and unit."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from contourlab.figures import FACTORS, figure, number, shown_unit
from contourlab.units import from_si


@given(st.floats(1e-12, 1e12), st.booleans(), st.integers(1, 8))
def test_a_number_reads_back_to_its_digits(value, negative, digits):
    value = -value if negative else value
    assert float(number(value, digits)) == pytest.approx(value, rel=0.51 * 10.0 ** (1 - digits))


@given(st.floats(1e-4, 9e5), st.integers(2, 6))
def test_a_number_never_shows_more_than_its_digits(value, digits):
    shown = number(value, digits).lstrip("0.").replace(".", "")
    assert len(shown.rstrip("0")) <= digits


@pytest.mark.parametrize(
    ("value", "text"), [(0.0, "0"), (math.nan, "-"), (math.inf, "inf"), (-math.inf, "-inf"), (9.996, "10"), (-0.02, "-0.02")]
)
def test_particular_numbers(value, text):
    assert number(value) == text


def test_a_missing_figure_has_no_unit():
    assert figure(math.nan, "um") == "-"


@pytest.mark.parametrize("unit", ["m", "m/s", "m/s^2", "m/s^3", "rad"])
def test_print_units_agree_with_the_unit_registry(unit):
    factor, shown = shown_unit(unit)
    assert factor == pytest.approx(from_si(1.0, shown))


def test_units_are_ascii():
    assert all(unit.isascii() for unit in FACTORS)
