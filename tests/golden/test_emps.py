"""Janot, Gautier & Brunot, "Data set and reference models of EMPS", 2019: the published digits from the published log."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bands import check_each_row_can_fail
from reference_data import reference_file

from contourlab.cli.main import main
from contourlab.papers.emps import study
from contourlab.papers.emps.simulation import axis_of, simulate_emps, simulate_in_engine
from contourlab.papers.emps.study import identified, parts_of
from contourlab.papers.rows import Row, read_bands
from contourlab.papers.run import run_parts

Table = dict[tuple[str, str], Row]
ALIKE, DIRECTED = "friction alike in both directions", "friction by direction"
PUBLISHED = """
M                            95.1089
Fv                          203.5034
Fc                           20.3935
offset                       -3.1648
condition_number             25.9883
residual_norm               108.7569
relative_error                4.0834
residual_deviation            2.1843
asymmetric_M                 95.1540
asymmetric_Fv+              166.7061
asymmetric_Fc+               20.1440
asymmetric_Fv-              240.4236
asymmetric_Fc-               20.6277
asymmetric_condition_number  26.0197
asymmetric_residual_norm     82.8778
asymmetric_relative_error     3.1117
"""
DEVIATIONS = {"M": 0.1085, "Fv": 1.1460, "Fc": 0.1012, "offset": 0.0444}
DEVIATIONS_DIRECTED = {"M": 0.0827, "Fv+": 1.2326, "Fc+": 0.1088, "Fv-": 1.2346, "Fc-": 0.1091}


@pytest.fixture(scope="module")
def log() -> Path:
    return reference_file("data/emps/DATA_EMPS.mat")


@pytest.fixture(scope="module")
def table(log: Path, computed: Any) -> Table:
    return {(row.name, row.case): row for row in computed("emps", parts_of(log))}


@pytest.mark.parametrize("line", PUBLISHED.split("\n")[1:-1])
@pytest.mark.slow
def test_identification_agrees_to_the_last_printed_digit(table: Table, line: str) -> None:
    name, printed = line.split()
    (row,) = (row for (held, _), row in table.items() if held == name.replace("_", " "))
    assert row.paper == float(printed)
    assert f"{row.here:.4f}" == printed
    assert row.agrees


@pytest.mark.parametrize(("case", "printed"), [(ALIKE, DEVIATIONS), (DIRECTED, DEVIATIONS_DIRECTED)])
def test_deviations_agree_to_the_last_printed_digit(table: Table, case: str, printed: dict[str, float]) -> None:
    for name, paper in printed.items():
        row = table["standard deviation", f"{name}, {case}"]
        assert (row.paper, f"{row.here:.4f}", row.agrees) == (paper, f"{paper:.4f}", True)


def test_relative_deviations_are_those_of_the_published_listing(table: Table) -> None:
    for name, paper in {"M": "0.1141", "Fv": "0.5631", "Fc": "0.4964", "offset": "1.4021"}.items():
        assert f"{table['relative standard deviation', f'{name}, {ALIKE}'].here:.4f}" == paper


def test_the_residual_is_reported_as_coloured(table: Table) -> None:
    """The residual contains direction-dependent friction, so plain deviations are too small by a factor of two or more."""
    for name, plain in DEVIATIONS.items():
        assert 2.0 < table["standard deviation, residual as it is", f"{name}, {ALIKE}"].here / plain < 3.0
    assert "white" in table["M", ALIKE].note


def test_the_published_simulation_is_reproduced_with_its_clock_and_solver(table: Table) -> None:
    for name, paper in {"position": 0.013752, "velocity": 0.22911, "acceleration": 8.6036, "force": 5.848}.items():
        row = table[f"simulated {name}", "the published clock, delay and solver"]
        assert row.paper == paper
        assert row.here == pytest.approx(paper, rel=2e-3)
        assert row.agrees


@pytest.mark.parametrize(
    ("case", "percent"),
    [
        ("one tick of control delay", {"position": 0.0016, "velocity": 0.230, "acceleration": 8.51, "force": 5.86}),
        ("no control delay", {"position": 0.0011, "velocity": 0.126, "acceleration": 6.08, "force": 4.58}),
        ("no control delay, friction by direction", {"position": 0.00083, "velocity": 0.125, "acceleration": 6.08, "force": 3.72}),
    ],
)
def test_the_simulated_loop_follows_the_log(table: Table, case: str, percent: dict[str, float]) -> None:
    for name, bound in percent.items():
        assert 0.9 * bound < table[f"simulated {name}", case].here < 1.01 * bound


@pytest.mark.slow
@pytest.mark.parametrize("height", [0.0, 5.0])
@pytest.mark.parametrize("delay", [0, 1])
def test_the_engine_runs_the_same_loop(log: Path, delay: int, height: float) -> None:
    """The engine starts at rest, the log in motion; half a second later the difference has decayed. Pulses as in DATA_EMPS_PULSES.mat."""
    found = identified(log)
    record = replace(found.log, pulses=height * ((found.log.time - 0.344) % 1.0 < 0.5) * (found.log.time > 0.3))
    axis = axis_of(found.symmetric)
    own, engine = simulate_emps(record, axis, delay=delay), simulate_in_engine(record, axis, delay=delay)
    assert np.abs(own.position - engine.position)[500:].max() < 1e-12
    assert np.abs(own.velocity - engine.velocity)[500:].max() < 1e-10
    assert np.abs(own.force - engine.force)[500:].max() < 1e-6


def test_the_engine_follows_the_log_as_closely(table: Table) -> None:
    for case in ("one tick of control delay", "no control delay"):
        for name in ("position", "velocity", "acceleration", "force"):
            here = table[f"simulated {name}", f"contourlab's engine, {case}"].here
            assert here == pytest.approx(table[f"simulated {name}", case].here, rel=0.02)


def test_the_measured_loop_has_no_delay_of_a_tick(table: Table) -> None:
    assert table["controller law", "no control delay"].here == pytest.approx(3.7, abs=0.05)
    assert table["controller law", "one tick of control delay"].here > 50.0


def test_tracking_error_as_measured_and_simulated(table: Table) -> None:
    for name, measured, apart in (("tracking error rms", 0.578, 5e-4), ("tracking error peak", 0.852, 2.5e-3)):
        assert table[name, "measured"].here == pytest.approx(measured, abs=5e-4)
        for case in ("simulated, no control delay", "simulated, one tick of control delay"):
            assert table[name, case].here == pytest.approx(measured, abs=apart)


def test_every_row_can_fail_and_those_that_differ_say_why(table: Table) -> None:
    check_each_row_can_fail([*table.values()])
    assert all(row.note and not row.main for row in table.values() if row.verdict == "differs")


@pytest.mark.slow
def test_a_second_log_is_validated_with_the_parameters_of_the_first(table: Table, log: Path) -> None:
    """The same log gives its own error again. The published second log is not in the shared data."""
    second = [part for part in parts_of(log, log) if "second record" in part[0]]
    rows = table | {(row.name, row.case): row for row in run_parts(second, read_bands("emps"))}
    assert len(second) == 2 and len(rows) > len(table)
    assert rows["cross-validation relative error", ALIKE].here == pytest.approx(rows["relative error", ALIKE].here, rel=1e-12)
    assert rows["cross-validation relative error", ALIKE].paper == 5.9824
    assert rows["cross-validation relative error", DIRECTED].here == pytest.approx(3.1117, abs=5e-5)
    own, again = (rows["simulated force", f"{prefix}no control delay"] for prefix in ("", "validation: "))
    assert (own.here, own.paper, again.paper) == (again.here, 5.848, 8.9409)


def test_the_published_validation_agrees_where_its_log_is_there(log: Path) -> None:
    pulses = log.with_name("DATA_EMPS_PULSES.mat")
    if not pulses.is_file():
        pytest.skip("the EMPS log with pulses, DATA_EMPS_PULSES.mat, is not among the shared reference data")
    rows = {(row.name, row.case): row for row in run_parts(parts_of(log, pulses), read_bands("emps"))}
    for name, printed in {"condition number": "26.0217", "residual norm": "169.4876", "residual deviation": "3.4039"}.items():
        assert f"{rows[f'cross-validation {name}', ALIKE].here:.4f}" == printed
    assert rows["cross-validation relative error", ALIKE].here == pytest.approx(5.9824, abs=5e-5)
    for name, paper in {"position": 0.0080248, "velocity": 0.47888, "acceleration": 19.8152, "force": 8.9409}.items():
        row = rows[f"simulated {name}", "validation: the published clock, delay and solver"]
        assert row.here == pytest.approx(paper, rel=5e-3) and row.agrees
        for case in ("one tick of control delay", "no control delay"):
            own, engine = (rows[f"simulated {name}", f"validation: {solver}{case}"].here for solver in ("", "contourlab's engine, "))
            assert engine == pytest.approx(own, rel=5e-3)
    assert rows["simulated force", "validation: contourlab's engine, one tick of control delay"].here == pytest.approx(8.707, abs=2e-3)


@pytest.mark.slow
def test_the_command_prints_json_and_draws(
    table: Table, log: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    parts = {(log, None): [("rows", table.values)]}
    monkeypatch.setattr(study, "parts_of", lambda *logs: parts[logs])
    assert main(["reproduce", "emps", "--log", str(log), "--json", "--plots", "svg", "--out", str(tmp_path / "seen")]) == 0
    rows = json.loads(capsys.readouterr().out)
    for name in ("M", "Fv", "Fc", "offset", "relative error"):
        (row,) = (row for row in rows if row["name"] == name)
        assert row["pass"] is True
    drawn = {file.name for file in (tmp_path / "seen").iterdir()}
    assert drawn == {f"emps-{name}.svg" for name in ("force", "force-left", "friction", "error", "error-left")}
