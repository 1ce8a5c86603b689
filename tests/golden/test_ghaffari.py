"""Figures of Ghaffari & Ulsoy, from the paper and from its equations, against the reproduction."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from bands import check_each_row_can_fail, check_page
from ghaffari_loop import TABLE_2, TABLE_3, Open, sampled_poles
from numpy.typing import NDArray

from contourlab.papers.rows import Row

Rows = dict[tuple[str, str], dict[str, Any]]


# --- Tables II and III ---------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("n", [1, 2, 3])
def test_gains_of_table_ii_are_those_of_eqs_21_to_23_within_the_last_printed_digit(rows: Rows, n: int) -> None:
    """Section IV: w_n = 25 rad/s, zeta = 0.7, alpha = 35 rad/s; a' and b' of Table II."""
    line = TABLE_2[n]
    wanted = {
        "K_V": (line.kv, (35.0 + 2.0 * 0.7 * 25.0 - line.b) / line.a, 1e-3),
        "K_P": (line.kp, (2.0 * 35.0 * 0.7 * 25.0 + 25.0**2) / line.a, 1e-2),
        "K_I": (line.ki, 35.0 * 25.0 / (2.0 * 35.0 * 0.7 + 25.0), 1e-2),
    }
    for symbol, (printed, equation, digit) in wanted.items():
        row = rows[f"Table II {symbol}", f"axis {n}"]
        assert row["paper"] == printed
        assert row["here"] == pytest.approx(equation, rel=1e-12)
        assert abs(row["here"] - printed) < digit


# --- the observer, eqs 10 to 14 ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("n", [1, 2, 3])
def test_steady_gains_and_attenuation(rows: Rows, n: int) -> None:
    """a_hat/b_hat and 0 from eqs 10 to 13; a slow load leaves a_hat/(b_hat w_d) of its rate.

    Sampled, the estimate gains w = 1 - exp(-w_d T) of its residual each tick. Under a load that grows by g T a tick the estimate has to
    grow by as much, so w b_hat v/a_hat = g T: the velocity per rate is a_hat T/(b_hat w).
    """
    line, case = TABLE_3[n], f"axis {n}, Table III"
    ratio = line.ah / line.bh
    assert rows["DC gain u_c to v", case]["here"] == pytest.approx(ratio, rel=1e-9)
    assert rows["DC gain d to v", case]["here"] < 1e-9 * ratio
    sampled = rows["attenuation of disturbance, sampled", case]
    assert sampled["paper"] == pytest.approx(ratio / 200.0, rel=1e-12)
    assert sampled["here"] == pytest.approx(ratio * 1e-3 / (1.0 - math.exp(-0.2)), rel=1e-9)


def test_the_fit_of_more_than_95_percent_needs_the_observer(rows: Rows) -> None:
    """Section III."""
    fit = rows["identification fit", "all axes, Table II, eq 18"]
    assert fit["paper"] == 95.0 < fit["here"] < 100.0 and fit["pass"]
    assert rows["identification fit", "best axis, observer off"]["here"] < 90.0


def test_identified_after_the_calibration_axes_2_and_3_have_the_printed_ratio(rows: Rows) -> None:
    """a'/b' of Table II against a_hat/b_hat of the observer; axis 1 stays open."""
    name = "identified a'/b'"
    for n, line in TABLE_2.items():
        before, after, fitted = (
            rows[f"{name}{tail}", f"axis {n}, {case}"]
            for tail, case in (
                ("", "Table II, eq 18"),
                (" over what the paper leaves open", "Table III"),
                (" over what the paper leaves open", "Table III, fitted filters"),
            )
        )
        assert before["paper"] == after["paper"] == pytest.approx(line.a / line.b, rel=1e-12)
        assert before["here"] > 2.0 * before["paper"]
        assert after["here"] == pytest.approx(TABLE_3[n].ah / TABLE_3[n].bh, rel=0.07)
        assert abs(fitted["here"] / fitted["paper"] - 1.0) < 0.011 or n == 1
    # Table III's observers are the same on axes 1 and 2, so the models identified behind them are nearly equal.
    alike = [rows["identified b' over what the paper leaves open", f"axis {m}, Table III, servo period 0.1 ms"]["here"] for m in (1, 2)]
    assert alike[0] == pytest.approx(alike[1], rel=0.2)


def test_axis_1_against_axis_2_in_open_loop(rows: Rows) -> None:
    faster = rows["response of axis 1 faster than axis 2", "open loop"]
    larger = rows["DC gain of axis 1 larger than axis 2", "open loop"]
    assert (faster["paper"], larger["paper"]) == (55.0, 70.0)
    assert faster["here"] == pytest.approx(100.0 * (10.1 / 6.5 - 1.0), abs=1e-2)
    assert larger["here"] == pytest.approx(100.0 * ((1695.0 / 10.1) / (648.0 / 6.5) - 1.0), abs=1e-6)


@pytest.mark.parametrize(("axis", "percent"), [("axis 1", 5.5), ("axis 2", 8.8), ("axis 3", 7.7)])
def test_stiction_found_by_a_slow_ramp(rows: Rows, axis: str, percent: float) -> None:
    """The ramp grows by 0.0019 % of full scale a tick: the axis leaves with the first command that passes its stiction."""
    assert rows["stiction", axis]["paper"] == percent
    assert percent < rows["stiction", axis]["here"] < percent + 0.0019


# --- the position loop ---------------------------------------------------------------------------------------------------------------


def test_fig_8_is_eq_16_under_variation(rows: Rows) -> None:
    s = 1j * np.linspace(1.0, 25.0, 2401)

    def closed(a: float, b: float) -> NDArray[np.complex128]:
        return np.asarray(4.0 * 11.8 * a / np.polyval([1.0, b + 0.1 * a, 4.0 * a, 4.0 * 11.8 * a], s))

    changes = {(a, b): closed(a, b) / closed(800.0, 20.0) for a in (600, 800, 1000) for b in (15, 20, 25)}
    sides = {"magnitude": lambda x: np.abs(20.0 * np.log10(np.abs(x))).max(), "phase": lambda x: np.abs(np.degrees(np.angle(x))).max()}
    for name, side in sides.items():
        a, b = max(changes, key=lambda case: side(changes[case]))
        # The two grids miss a largest value inside the band by a little.
        here = rows[f"Fig 8 change of {name}", f"a' {a}, b' {b}"]["here"]
        assert here == pytest.approx(side(changes[a, b]), rel=1e-3)


@pytest.mark.parametrize("n", [1, 2, 3])
@pytest.mark.parametrize(("symbol", "field"), [("K_P", "kp"), ("K_I", "ki")])
def test_the_loop_oscillates_from_the_stated_gain_on(rows: Rows, n: int, symbol: str, field: str) -> None:
    """The poles of the independent second loop cross the unit circle at that gain and at no lower one."""
    row = rows[f"{symbol} at which the loop oscillates", f"axis {n}, Table III"]
    start = getattr(TABLE_3[n], field)

    def radius(value: float) -> float:
        return float(np.abs(sampled_poles(n, TABLE_3[n]._replace(**{field: value}), Open())).max())

    assert radius(row["here"] * 0.9999) < 1.0 < radius(row["here"] * 1.0001)
    assert all(radius(value) < 1.0 for value in np.geomspace(start, 0.999 * row["here"], 20))
    if symbol == "K_I":  # Routh on eq 16: (b' + a' K_V) a' K_P > a' K_P K_I
        assert f"K_I = b' + a' K_V = {TABLE_3[n].b + 0.1 * 900.0:g} 1/s" in row["note"]


# --- what is claimed -----------------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="session")
def whole(rows: Rows) -> list[Row]:
    """All rows as the reproduction makes them."""
    made = []
    for row in rows.values():
        low, high = map(number, row["band"])
        values = {name: value for name, value in row.items() if name not in ("pass", "verdict")}
        made.append(Row(**values | {"here": number(row["here"]), "band": (low, high)}))
    return made


def number(value: float | None) -> float:
    """Return a number of JSON, which has no nan."""
    return math.nan if value is None else value


def test_every_row_can_fail_and_the_page_shows_the_table(whole: list[Row]) -> None:
    check_each_row_can_fail(whole)
    check_page("explanation/ghaffari.md", whole)


def test_only_numbers_that_were_computed_count(rows: Rows) -> None:
    kinds = {name: {row["kind"] for (its, _), row in rows.items() if its == name} for name, _ in rows}
    assert kinds["stiction"] == {"input"} and kinds["Table II K_V"] == {"derived"}
    for name, found in kinds.items():
        assert found == {"identity"} or not name.startswith(("V/", "DC gain u_c", "DC gain d ", "Fig 8 P", "time of the spike")), name


def test_the_verdict_on_the_swap(rows: Rows) -> None:
    """The observer removes most of the swap loss; one local parameter of the axis brings the rest within the limit."""
    case = "A3-A1 against A3-A2"
    loss = {words: rows[f"swap loss {words}", case]["here"] for words in ("with observer", "without observer")}
    assert 0.03 < loss["with observer"] < 0.06 and 0.2 < loss["without observer"] < 0.25
    needed = {words: rows[f"local parameters needed {words}", case]["here"] for words in loss}
    assert needed == {"with observer": 1.0, "without observer": 2.0}
    # Full modularity, as the paper says: with its own J as J_tol, or with margins that admit its gains.
    for words in ("J_tol 18.4 um s", "4.5 dB and 24 deg", "servo period 0.5 ms"):
        assert rows["local parameters needed under other terms", f"{case}, {words}"]["here"] == 0.0
    assert rows["swap loss under other terms", f"{case}, J_tol 18.4 um s"]["here"] == pytest.approx(0.00487, abs=5e-4)
    assert rows["gain margin of Table III", "A3-A2"]["here"] == pytest.approx(4.57, abs=0.01)
    assert rows["phase margin of Table III", "A3-A2"]["here"] == pytest.approx(24.7, abs=0.05)


def test_the_loss_of_the_same_gains_belongs_to_the_model(rows: Rows) -> None:
    """Half the servo period makes the shared design lose 115 %; 2 % force noise lets it beat the optimum of A3-A1."""
    loss = {
        case.removeprefix("A3-A1 against A3-A2, ").removesuffix(", J_tol 2 um s"): row
        for (name, case), row in rows.items()
        if name == "swap loss of the same gains" and case.endswith("J_tol 2 um s")
    }
    assert loss["servo period 0.5 ms"]["here"] == pytest.approx(1.15, abs=0.05)
    assert loss["force noise 2 %"]["here"] == pytest.approx(0.043, abs=0.003)
    assert float(loss["force noise 2 %"]["note"].split()[2]) < 0.0
