"""Shahin, ElMaraghy & ElBeheiry: figures derived by hand and by independent code, against the reproduction."""

from __future__ import annotations

import json
import math
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bands import check_each_row_can_fail, check_page

from contourlab.arrays import Array
from contourlab.cli.main import main
from contourlab.errors import MissingPackageError
from contourlab.papers.rows import Row
from contourlab.papers.run import conclusion
from contourlab.papers.shahin import common_lyapunov, study, theory
from contourlab.papers.shahin import setup as setup
from contourlab.papers.shahin.common_lyapunov import common_quadratic
from contourlab.papers.shahin.runs import Figures, circular, measured
from contourlab.papers.shahin.setup import TO_FLANK, Setting
from contourlab.papers.shahin.study import PARTS
from contourlab.papers.shahin.theory import DRIVE, LAWS
from contourlab.papers.shahin.two_inertia_loop import two_inertia_loop

UM = 1e6


def briefly(name: str, setting: Setting) -> Figures:
    """Return the figures of two laps after the first second; the table of the reproduction evaluates seven."""
    return circular(name, setting, until=3.5)


@pytest.fixture(scope="module")
def contact() -> dict[str, Array]:
    """Largest axis errors [um] with the target at the flank, 25 um of gap, motors on the forward flanks at the start."""
    return {name: circular(name, TO_FLANK).axis_error * UM for name in setup.SCHEMES}


@pytest.mark.slow
def test_schemes_two_and_three_agree_with_a_continuous_control_law(contact: dict[str, Array]) -> None:
    """By Runge-Kutta at 1 us with the law evaluated in its stages: II 37.4 and 31.8, III 37.2 and 31.6 um on x and y; here it is held."""
    assert contact["II"] == pytest.approx([37.4, 31.8], abs=0.5)
    assert contact["III"] == pytest.approx([37.2, 31.6], abs=0.5)


@pytest.mark.parametrize("start", [1.0, 0.0])
@pytest.mark.slow
def test_word_for_word_the_printed_errors_come_out_wherever_the_motors_start(start: float) -> None:
    """By Runge-Kutta at 4 us: I 67.6, II 31.3, III 29.2 and 29.7 um; printed 32.6 um, and reductions that make I 70.3 um."""
    found = {name: circular(name, Setting(start_in_gap=start)).axis_error * UM for name in setup.SCHEMES}
    assert found["I"] == pytest.approx([67.6, 67.6], abs=0.1)
    assert found["II"] == pytest.approx([31.3, 31.3], abs=0.4)
    assert found["III"] == pytest.approx([29.5, 29.5], abs=0.4)


@pytest.mark.slow
def test_cross_coupling_divides_the_contour_error_by_three_and_more() -> None:
    for name in setup.SCHEMES:
        alone, coupled = (circular(kind, Setting()).contour_error for kind in (name, setup.COUPLED[name]))
        assert coupled < alone / 3.0


@pytest.mark.slow
def test_from_mid_gap_the_same_two_are_better() -> None:
    """By the same independent code: 24.1 and 22.2 um for both."""
    for name in ("II", "III"):
        assert circular(name, replace(TO_FLANK, start_in_gap=0.0)).axis_error * UM == pytest.approx([24.1, 22.2], abs=0.8)


@pytest.mark.slow
def test_twice_the_gap_about_doubles_the_error(contact: dict[str, Array]) -> None:
    for name in ("II", "III"):
        assert briefly(name, replace(TO_FLANK, gap=50e-6)).axis_error * UM == pytest.approx(2.0 * contact[name], rel=0.25)


@pytest.mark.slow
def test_scheme_one_as_printed_runs_away_and_with_the_reference_it_does_not() -> None:
    assert 0.1 < circular("I", Setting(follows_load=True)).diverged < 2.0
    assert 0.1 < circular("I", replace(TO_FLANK, follows_load=True)).diverged < 2.0
    assert math.isinf(circular("I", Setting()).diverged)


@pytest.mark.slow
def test_the_cascade_lags_by_its_gain_and_backlash_adds_half_of_the_gap() -> None:
    """|1/(1 + L)| at 5.33 rad/s is v/K_v but for the velocity loop, v w/(2 zeta w_n K_v) and less."""
    without, with_gap = circular("PI", Setting(gap=0.0)).largest, circular("PI", Setting()).largest
    assert without == pytest.approx(setup.PRINTED_PI, rel=2e-3)
    assert with_gap - without == pytest.approx(12.5e-6, rel=0.05)


@pytest.mark.slow
def test_closed_over_the_loads_the_cascade_hunts_in_proportion_to_the_gap() -> None:
    smooth, loose, looser = (briefly("PI on the load", Setting(gap=gap)).contour_error for gap in (0.0, 25e-6, 50e-6))
    assert smooth < 20e-6
    assert loose > 5.0 * smooth
    assert looser == pytest.approx(2.0 * loose, rel=0.1)


@pytest.mark.slow
def test_a_free_load_is_caught_at_the_speed_of_its_closed_form() -> None:
    """A stiff law keeps the motor on the reference. The load leaves its flank, and the ripple is its flight through the gap."""
    found = briefly("I", replace(TO_FLANK, shaft_damping=1.0))
    assert found.feed_ripple == pytest.approx(setup.free_flight(25e-6), rel=0.05)


@pytest.mark.parametrize(("setting", "stable", "unstable"), [(TO_FLANK, 9e-6, 12e-6), (Setting(), 48e-6, 55e-6)])
def test_a_servo_period_beyond_the_limit_makes_it_diverge(setting: Setting, stable: float, unstable: float) -> None:
    """2 J_m/K_1' = 10.4 us with Table 2 as printed, 2 J_m/K_2' = 52 us with its columns exchanged."""
    lap = 2.0 * math.pi * setup.RADIUS / setup.FEED
    below, above = lap / round(lap / stable), lap / round(lap / unstable)
    assert math.isinf(measured(setup.machine(setting, below), setup.scheme("II", setting), setup.circle(2, below)).diverged)
    assert math.isfinite(measured(setup.machine(setting, above), setup.scheme("II", setting), setup.circle(2, above)).diverged)


def test_no_common_quadratic_function_exists_for_any_gains_of_the_motor() -> None:
    """The certificate is checked here by hand: a vector in the null space of the gap's matrix."""
    loop = two_inertia_loop(DRIVE, LAWS["II"])
    assert sorted(np.linalg.eigvals(loop.gap_matrix).real)[:2] == pytest.approx(sorted(np.roots([5.2e-3, 200.0, 1000.0])), rel=1e-6)
    found = common_quadratic([loop.gap_matrix, loop.contact_matrix])
    assert found.verdict == "infeasible"
    total = sum(m @ z + z @ m.T for m, z in zip((loop.gap_matrix, loop.contact_matrix), found.certificate, strict=True))
    assert np.linalg.eigvalsh(total).min() >= -1e-9
    assert max(np.abs(z).max() for z in found.certificate) > 0.0


@pytest.fixture(scope="module")
def rows(computed: Any) -> list[Row]:
    """Every row of the reproduction; takes a minute."""
    made: list[Row] = computed("shahin", PARTS)
    return made


@pytest.mark.slow
def test_theory_says_which_function_works_and_which_loops_hunt(rows: list[Row]) -> None:
    here = {(row.name, row.case): row.here for row in rows}
    assert here["Lur'e-Postnikov function", "scheme II: 1 found, nan not"] == 1.0
    quadratic = [(case, value) for (name, case), value in here.items() if name.startswith("common quadratic")]
    assert [value for case, value in quadratic if "rigid model" in case] == [1.0, 1.0, 1.0]
    assert [value for case, value in quadratic if "gap and contact" in case] == [0.0]
    periods = {case: value for (name, case), value in here.items() if name == "largest stable servo period"}
    assert periods["scheme II in the gap"] == pytest.approx(52.0, abs=1e-3)
    assert periods["scheme II in the gap, Table 2 as printed"] == pytest.approx(10.4, abs=1e-3)
    ratios = [value for (name, _), value in here.items() if name.startswith("limit cycle")]
    assert len([r for r in ratios if r > 0.0]) == 6 and len([r for r in ratios if r == 0.0]) == 3
    assert min(r for r in ratios if r > 0.0) < 1.2 and max(ratios) > 24.0


@pytest.mark.slow
def test_printed_figures_come_out_as_near_as_documented(rows: list[Row]) -> None:
    off = {row.name if row.name != "error reduction against scheme I" else row.case[:3]: row.off for row in rows if row.main}
    for name, near in {"I max error": 0.05, "II max error": 0.05, "III max error": 0.11, "II,": 0.05, "III": 0.05}.items():
        assert abs(off[name]) < near
    for name in ("feedrate error of scheme I", "I feed ripple", "III feed ripple"):
        assert abs(off[name]) > 0.4
    assert off["feedrate fluctuation"] == 0.0
    # A limit that is kept is no figure within 2 %.
    assert [int(digits) for digits in re.findall(r"\d+", conclusion(rows))][:2] == [7, 1]


@pytest.mark.parametrize("words", [[], ["--all"]])
def test_without_the_solver_the_other_rows_are_printed(
    words: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def missing(name: str) -> None:
        raise MissingPackageError(name, "design")

    monkeypatch.setattr(common_lyapunov, "extra_module", missing)
    monkeypatch.setattr(study, "PARTS", (("stability", theory._stability), ("rigid model", theory._rigid)))
    assert main(["reproduce", "shahin", "--json"]) == 0
    here = json.loads(capsys.readouterr().out)
    lacking = {row["name"] for row in here if row["missing"]}
    assert lacking == {"common quadratic Lyapunov function", "alpha_1 of eq (17)", "alpha_2 of eq (17)"}
    assert all(row["here"] is None and row["pass"] is None for row in here if row["missing"])
    assert any(row["name"] == "Lur'e-Postnikov function" and row["here"] == 1.0 for row in here)
    assert main(["reproduce", "shahin", *words]) == 0
    assert 'pip install "contourlab[design]"' in capsys.readouterr().out


@pytest.mark.slow
def test_every_row_can_fail_and_the_page_shows_the_table(rows: list[Row]) -> None:
    check_each_row_can_fail(rows)
    check_page("explanation/shahin.md", rows)
    assert all(row.note for row in rows if row.verdict == "differs")


@pytest.mark.slow
def test_the_command_passes_and_draws(rows: list[Row], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(study, "PARTS", (("rows", lambda: rows),))
    assert main(["reproduce", "shahin", "--json", "--plots", "svg", "--out", str(tmp_path / "seen")]) == 0
    drawn = {file.name for file in (tmp_path / "seen").iterdir()}
    assert drawn == {f"shahin-fig-{number}.svg" for number in ("7-8", 9, 10, 11, 12, 13)}
