"""Table III from Table II: the rows of the calibration, and its gains in the independent second loop."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from ghaffari_loop import TABLE_2, TABLE_3, Line, Open, ellipse, run

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


def test_only_numbers_of_table_iii_that_the_calibration_had_to_reach_count(rows: Rows) -> None:
    """The untouched Table II is within 20 % of Table III in 9 of 21 numbers."""
    tables = {1: (TABLE_2[1], TABLE_3[1]), 2: (TABLE_2[2], TABLE_3[2]), 3: (TABLE_2[3], TABLE_3[3])}
    symbols = ("a_hat", "b_hat", "K_V", "K_P", "K_I", "a'", "b'")
    for number, (before, after) in tables.items():
        case = f"axis {number}, from Table II by the sequential procedure"
        for symbol, start, end in zip(symbols, before, after, strict=True):
            row = rows[f"Table III: {symbol}", case]
            assert row["paper"] == end
            assert (row["kind"] == "computed") == (max(abs(start / end - 1.0), abs(row["here"] / end - 1.0)) > 0.2)
        here = [rows[f"Table III: {symbol}", case]["here"] for symbol in symbols]
        left, whole = (np.log(np.array(values) / np.array(after)) for values in (here, before))
        way = 1.0 - float(np.linalg.norm(left) / np.linalg.norm(whole))
        assert rows["Table III: way covered", case]["here"] == pytest.approx(way, rel=1e-6)


@pytest.mark.slow
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
