"""Shahin, ElMaraghy & ElBeheiry: figures derived by hand and by independent code, against the reproduction."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from contourlab.cli.main import main
from contourlab.papers.shahin import setup as setup
from contourlab.papers.shahin.common_lyapunov import common_quadratic
from contourlab.papers.shahin.runs import circular, measured
from contourlab.papers.shahin.setup import Setting
from contourlab.papers.shahin.theory import DRIVE, SCHEME_II, theory_rows
from contourlab.papers.shahin.two_inertia_loop import two_inertia_loop

UM = 1e6


@pytest.fixture(scope="module")
def contact() -> dict[str, np.ndarray]:
    """Largest axis errors [um] with 25 um of gap, motors on the forward flanks at the start."""
    return {name: circular(name, Setting()).axis_error * UM for name in setup.SCHEMES}


def test_schemes_two_and_three_agree_with_a_continuous_control_law(contact: dict[str, np.ndarray]) -> None:
    """By Runge-Kutta at 1 us with the law evaluated in its stages: II 37.4 and 31.8, III 37.2 and 31.6 um on x and y; here it is held."""
    assert contact["II"] == pytest.approx([37.4, 31.8], abs=0.5)
    assert contact["III"] == pytest.approx([37.2, 31.6], abs=0.5)


def test_from_mid_gap_the_same_two_are_better() -> None:
    """By the same independent code: 24.1 and 22.2 um for both."""
    for name in ("II", "III"):
        assert circular(name, Setting(start_in_gap=0.0)).axis_error * UM == pytest.approx([24.1, 22.2], abs=0.8)


def test_twice_the_gap_about_doubles_the_error(contact: dict[str, np.ndarray]) -> None:
    for name in ("II", "III"):
        assert circular(name, Setting(gap=50e-6)).axis_error * UM == pytest.approx(2.0 * contact[name], rel=0.25)


def test_scheme_one_as_printed_runs_away_and_with_the_reference_it_does_not() -> None:
    assert 0.1 < circular("I", Setting(follows_load=True)).diverged < 2.0
    assert math.isinf(circular("I", Setting()).diverged)


def test_the_cascade_lags_by_its_gain_and_backlash_adds_half_of_the_gap() -> None:
    """|1/(1 + L)| at 5.33 rad/s is v/K_v but for the velocity loop, v w/(2 zeta w_n K_v) and less."""
    without, with_gap = circular("PI", Setting(gap=0.0)).largest, circular("PI", Setting()).largest
    assert without == pytest.approx(setup.PRINTED_PI, rel=2e-3)
    assert with_gap - without == pytest.approx(12.5e-6, rel=0.05)


def test_closed_over_the_loads_the_cascade_hunts_in_proportion_to_the_gap() -> None:
    smooth, loose, looser = (circular("PI on the load", Setting(gap=gap)).contour_error for gap in (0.0, 25e-6, 50e-6))
    assert smooth < 20e-6
    assert loose > 5.0 * smooth
    assert looser == pytest.approx(2.0 * loose, rel=0.1)


def test_a_free_load_is_caught_at_the_speed_of_its_closed_form() -> None:
    """A stiff law keeps the motor on the reference. The load leaves its flank, and the ripple is its flight through the gap."""
    found = circular("I", Setting(shaft_damping=1.0))
    assert found.feed_ripple == pytest.approx(setup.free_flight(25e-6), rel=0.05)


def test_a_servo_period_beyond_the_limit_makes_it_diverge() -> None:
    setting = Setting()
    lap = 2.0 * math.pi * setup.RADIUS / setup.FEED
    below, above = lap / round(lap / 9e-6), lap / round(lap / 12e-6)
    assert math.isinf(measured(setup.machine(setting, below), setup.scheme("II", setting), setup.circle(2, below)).diverged)
    assert math.isfinite(measured(setup.machine(setting, above), setup.scheme("II", setting), setup.circle(2, above)).diverged)


def test_no_common_quadratic_function_exists_for_any_gains_of_the_motor() -> None:
    """The certificate is checked here by hand: a vector in the null space of the gap's matrix."""
    loop = two_inertia_loop(DRIVE, SCHEME_II)
    assert sorted(np.linalg.eigvals(loop.gap_matrix).real)[:2] == pytest.approx([-1.92307e5, -0.2], rel=1e-4)
    found = common_quadratic([loop.gap_matrix, loop.contact_matrix])
    assert found.verdict == "infeasible"
    total = sum(m @ z + z @ m.T for m, z in zip((loop.gap_matrix, loop.contact_matrix), found.certificate, strict=True))
    assert np.linalg.eigvalsh(total).min() >= -1e-9
    assert max(np.abs(z).max() for z in found.certificate) > 0.0


@pytest.mark.slow
def test_theory_says_which_function_works_and_which_loops_hunt() -> None:
    rows = {(row.name, row.case): row for row in theory_rows()}
    assert rows["Lur'e-Postnikov function", "scheme II: 1 found, nan not"].here == 1.0
    assert rows["largest stable servo period", "scheme II in the gap"].here == pytest.approx(10.4, abs=1e-3)
    ratios = [row.here for row in rows.values() if row.name.startswith("limit cycle")]
    assert len([r for r in ratios if r > 0.0]) == 6 and len([r for r in ratios if r == 0.0]) == 3
    assert min(r for r in ratios if r > 0.0) < 1.2 and max(ratios) > 24.0


@pytest.mark.slow
def test_the_command_prints_the_expected_rows(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["reproduce", "shahin", "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)
    wanted = {f"{name} max error" for name in ("PI", *setup.SCHEMES)} | {"I feed ripple", "III feed ripple", "I as printed"}
    assert wanted <= {row["name"] for row in rows}
    assert not [row for row in rows if row["pass"] is False]
    assert all(row["note"] for row in rows if row["verdict"] == "differs")
