"""Values with units: read exactly, or refused with a message that names the valid forms."""

from __future__ import annotations

import math

import pytest
from each import each
from hypothesis import given
from hypothesis import strategies as st

from contourlab.errors import UnitError
from contourlab.scenario.dump import quantity
from contourlab.scenario.quantities import read_list, read_number, show_bound


@each(
    "text, unit, si",
    [
        ("20 mm", "m", 0.02),
        ("8000 mm/min", "m/s", 8.0 / 60.0),
        ("4 full_scale/mm", "full_scale/m", 4000.0),
        ("0.1 full_scale*s/mm", "full_scale*s/m", 100.0),
        ("25 rad/s", "rad/s", 25.0),
        ("25 1/s", "rad/s", 25.0),
        ("60 rpm", "rad/s", 2.0 * math.pi),
        ("2 kg*cm^2", "kg*m^2", 2e-4),
        ("20 um/m", "rad", 2e-5),
        ("5 %", "", 0.05),
        (3, "", 3.0),
        ("2ms", "s", 2e-3),
        ("-1.5e3mm/min", "m/s", -0.025),
        ("1e3m", "m", 1000.0),
        ("4full_scale/mm", "full_scale/m", 4000.0),
        (".5%", "", 0.005),
        ("2e3", "", 2000.0),
    ],
)
def test_quantities_come_out_in_si(text: str, unit: str, si: float) -> None:
    assert read_number(text, unit) == pytest.approx(si, rel=1e-14)


@each(
    "value", ["20", "20 kg", "20 mm/s", "mm", "", "nan mm", "inf mm", "1e999 mm", "2e", "2e mm", "20 mm#", "20 mm\x00", 20, True, None, []]
)
def test_non_lengths_are_refused(value: object) -> None:
    with pytest.raises(UnitError):
        read_number(value, "m", "mm")


@pytest.mark.parametrize("text", ["2e", "2E", "1e3e3", "2eV"])
def test_an_exponent_that_may_be_a_unit_needs_a_space(text: str) -> None:
    with pytest.raises(UnitError, match="space"):
        read_number(text, "J")
    assert read_number("2 eV", "J") == pytest.approx(3.204353268e-19)


@pytest.mark.parametrize("text", ["1 (", "1 mm/", "1 €", "1 m**0", "1 mm**99999", "1 " + "m*" * 60, "1 'a'", "1 __class__"])
def test_failures_of_the_unit_parser_become_unit_errors(text: str) -> None:
    with pytest.raises(UnitError):
        read_number(text, "m")


def test_hertz_is_not_taken_for_radians() -> None:
    with pytest.raises(UnitError, match=r"157\.08 rad/s"):
        read_number("25 Hz", "rad/s")
    with pytest.raises(UnitError, match=r"'60 rpm'.*Hz"):
        read_number("60 rpm", "Hz")
    assert read_number("0.5 Hz", "Hz") == 0.5


@given(st.text(max_size=40), st.sampled_from(["", "m", "rad/s", "full_scale/m"]))
def test_any_text_is_a_number_or_a_unit_error(text: str, unit: str) -> None:
    try:
        assert math.isfinite(read_number(text, unit))
    except UnitError as error:
        assert str(error)


@given(
    st.floats(min_value=1e-12, max_value=1e12),
    st.sampled_from(
        [
            ("m", "mm"),
            ("m", "um"),
            ("m/s", "mm/min"),
            ("m/s^2/full_scale", "mm/s^2/full_scale"),
            ("kg*m^2", "kg*cm^2"),
            ("N", "N"),
            ("1/s", ""),
        ]
    ),
)
def test_written_values_read_back_to_the_same_bits(value: float, units: tuple[str, str]) -> None:
    assert read_number(quantity(value, *units), units[0]) == value


def test_lists_are_lists_of_quantities_or_share_a_unit() -> None:
    assert read_list(["0 mm", "2 cm"], "m") == (0.0, 0.02)
    assert read_list({"unit": "um", "values": [0, 1.5]}, "m") == (0.0, 1.5e-6)
    for wrong in (
        "0 mm",
        ["0 mm", 2],
        {"unit": "mm"},
        {"unit": "mm", "values": ["1 mm"]},
        {"unit": "kg", "values": [1]},
        {"unit": "mm", "values": 3},
    ):
        with pytest.raises(UnitError):
            read_list(wrong, "m")
    with pytest.raises(UnitError, match="item 2"):
        read_list(["1 mm", "x"], "m")


def test_bounds_are_shown_in_the_unit_of_the_file() -> None:
    assert show_bound(0.0, 0.05, True, "mm") == "> 0 and <= 50 mm"
    assert show_bound(-math.inf, math.inf, False, "mm") == "finite"
