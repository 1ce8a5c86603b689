"""Figures of Ghaffari & Ulsoy, typed in from the paper, against what the reproduction gives."""

from __future__ import annotations

from typing import Any

import pytest

from contourlab.studies.reproduce.ghaffari import reproduce

Rows = dict[tuple[str, str], dict[str, Any]]


@pytest.fixture(scope="module")
def rows() -> Rows:
    return {(row["name"], row["case"]): row for row in reproduce()}


@pytest.mark.parametrize(
    ("axis", "velocity_gain", "position_gain", "integral_gain"),
    [("axis 1", 0.057, 2.12, 11.82), ("axis 2", 0.060, 2.45, 11.82), ("axis 3", 0.062, 2.31, 11.82)],
)
def test_gains_of_table_ii_within_the_last_printed_digit(
    rows: Rows, axis: str, velocity_gain: float, position_gain: float, integral_gain: float
) -> None:
    for name, printed, digit in (("K_V", velocity_gain, 1e-3), ("K_P", position_gain, 1e-2), ("K_I", integral_gain, 1e-2)):
        assert abs(rows[f"Table II {name}", axis]["here"] - printed) < digit


@pytest.mark.parametrize(("configuration", "printed"), [("A3-A1", 18.37), ("A3-A2", 18.46)])
def test_contour_error_integral(rows: Rows, configuration: str, printed: float) -> None:
    here = rows[f"contour error integral {configuration}", f"{configuration}, Table III"]["here"]
    assert here == pytest.approx(printed, rel=0.02)


def test_one_controller_serves_both_configurations(rows: Rows) -> None:
    one, other = (rows[f"contour error integral {c}", f"{c}, Table III"]["here"] for c in ("A3-A1", "A3-A2"))
    assert abs(other - one) / one < 0.03


def test_the_observer_earns_a_factor_of_about_ten(rows: Rows) -> None:
    for c in ("A3-A1", "A3-A2"):
        on = rows[f"contour error integral {c}", f"{c}, Table III"]["here"]
        assert 8.0 < rows["contour error integral, observer off", f"{c}, Table III"]["here"] / on < 12.0


def test_most_of_the_integral_is_a_radius_error(rows: Rows) -> None:
    """The signed mean over the two seconds of a period is most of the integral of the magnitude."""
    for c in ("A3-A1", "A3-A2"):
        integral = rows[f"contour error integral {c}", f"{c}, Table III"]["here"]
        assert 2.0 * abs(rows["signed mean of contour error", f"{c}, Table III"]["here"]) > 0.9 * integral
        assert rows["contour error integral with a' = 960", c]["here"] < 0.5 * integral


@pytest.mark.parametrize(("axis", "percent"), [("axis 1", 5.5), ("axis 2", 8.8), ("axis 3", 7.7)])
def test_stiction_found_by_a_slow_ramp(rows: Rows, axis: str, percent: float) -> None:
    assert rows["stiction", axis]["here"] == pytest.approx(percent, abs=0.01)


def test_dc_gain_and_attenuation_follow_the_model(rows: Rows) -> None:
    """Table I: a_hat = 1695, 648, 1116 mm/s^2 and b_hat = 10.1, 6.5, 5.8 1/s; w_d = 200 rad/s."""
    for axis, gain, damping in (("axis 1", 1695.0, 10.1), ("axis 2", 648.0, 6.5), ("axis 3", 1116.0, 5.8)):
        assert rows["DC gain u_c to v", f"{axis}, Table II"]["here"] == pytest.approx(gain / damping, rel=1e-6)
        attenuation = rows["attenuation of disturbance", f"{axis}, Table II"]["here"]
        assert attenuation == pytest.approx(gain / (200.0 * damping), rel=1e-6)
        assert rows["DOB identity (10)-(13), largest relative difference", f"{axis}, Table II"]["here"] < 1e-9


def test_spikes_at_the_four_reversals(rows: Rows) -> None:
    for time in ("2", "2.5", "3", "3.5"):
        for c in ("A3-A1", "A3-A2"):
            assert 2.0 < abs(rows[f"reversal spike at {time} s", f"{c}, Table III"]["here"]) < 10.0


def test_no_figure_that_is_claimed_disagrees(rows: Rows) -> None:
    claimed = [row for row in rows.values() if row["pass"] is not None]
    assert len(claimed) >= 45
    assert [f"{row['name']}, {row['case']}" for row in claimed if not row["pass"]] == []


def test_the_readings_left_open_span_what_is_said(rows: Rows) -> None:
    assert rows["smallest of these", "reading"]["here"] < 13.0
    assert rows["largest of these", "reading"]["here"] > 19.0
