"""Table III from Table II: the rows of the calibration, and its gains in the independent second loop."""

from __future__ import annotations

from typing import Any

import pytest
from ghaffari_loop import TABLE_2, Line, Open, ellipse, run

from contourlab.papers.ghaffari.calibration import calibrate

Rows = dict[tuple[str, str], dict[str, Any]]
CIRCLE = ellipse(20.0, 20.0)
CASES = {1: "A3-A1, Table II and the sequential procedure", 2: "A3-A2, Table II and the sequential procedure"}


@pytest.mark.parametrize("first", [1, 2])
def test_the_calibrated_gains_give_the_same_integral_in_the_second_loop(rows: Rows, first: int) -> None:
    """The integral is a hundredth of the first one, so encoder counts that round the other way are a larger share of it."""
    table = {n: Line(*vars(gains).values()) for n, gains in calibrate(first).gains.items()}
    again = run(first, table, CIRCLE, 0.5, Open()).integral
    assert rows["integral after the calibration", CASES[first]]["here"] == pytest.approx(again, rel=0.05)
    before = run(first, TABLE_2, CIRCLE, 0.5, Open()).integral
    assert rows["calibration gain", CASES[first]]["here"] == pytest.approx(before / again, rel=0.05)


@pytest.mark.parametrize("case", [*CASES.values(), "A3-A1, Table II, all numbers, within margins"])
def test_the_calibration_gains_more_than_a_factor_of_ten(rows: Rows, case: str) -> None:
    assert rows["calibration gain", case]["here"] > 10.0


def test_every_number_of_table_iii_is_compared_and_says_why_it_differs(rows: Rows) -> None:
    numbers = [row for (name, case), row in rows.items() if name.startswith("Table III: ") and "sequential" in case]
    printed = [row for row in numbers if row["source"] == "printed"]
    assert len(printed) == 21 and len(numbers) == 27
    assert {row["verdict"] for row in numbers} == {"agrees", "differs"}
    assert all(row["tolerance"] == pytest.approx(0.25 * row["paper"]) for row in numbers)
    assert all(row["note"] for row in numbers)


def test_the_order_is_the_printed_one() -> None:
    short = [step.variable.short for step in calibrate(2).path.steps]
    observer, loop = ("observer.model_damping", "observer.model_gain"), ("velocity_gain", "position_gain", "integral_gain")
    ahead = ("model_damping", "model_gain")
    assert short == [f"{axis}.{name}" for group in (observer, loop, ahead) for axis in ("3", "2") for name in group]
    assert [step.variable.short for step in calibrate(1).path.steps] == [f"1.{name}" for name in (*observer, *loop, *ahead)]
    assert calibrate(1).gains[3] == calibrate(2).gains[3]


def test_the_feedforward_fits_the_compensated_axis(rows: Rows) -> None:
    """The error depends on the ratio, so many gains do equally well."""
    for number in (1, 2, 3):
        case = f"axis {number}, from Table II by the sequential procedure"
        observer, ahead = (rows[f"Table III: {name}", case]["here"] for name in ("a_hat/b_hat", "a'/b'"))
        assert observer == pytest.approx(ahead, rel=0.12)
