"""The XY table of the course MECH 467 (University of British Columbia): its measured runs, and the machine found from them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from bands import check_each_row_can_fail
from once import once
from reference_data import reference_file

from contourlab.cli.main import main
from contourlab.errors import LogError
from contourlab.features.refine.study import CrossValidation
from contourlab.papers.rows import Row, read_bands
from contourlab.papers.run import run_parts
from contourlab.papers.ubc import study
from contourlab.papers.ubc.runs import left_out
from contourlab.papers.ubc.study import MEASURED, parts_of

Table = dict[tuple[str, str], Row]


@pytest.fixture(scope="module")
def folder() -> Path:
    return reference_file("data/ubc-xy-table/line_circle_lli.mat").parent


@pytest.fixture(scope="module")
def table(folder: Path, computed: Any) -> Table:
    return {(row.name, row.case): row for row in computed("ubc", parts_of(folder, with_unseen=False))}


@pytest.mark.slow
def test_measured_runs_are_as_known_within_a_hundredth(table: Table) -> None:
    names = ("measured tracking rms, x", "measured tracking rms, y", "measured contour rms", "measured contour maximum")
    for run, known in MEASURED.items():
        for name, value in zip(names, known, strict=True):
            assert table[name, run].here == pytest.approx(value, rel=0.01)


@pytest.mark.slow
def test_the_machine_explains_the_tracking_errors(table: Table) -> None:
    for run, least in (("lead-lag", 80.0), ("pole-placement", 99.0)):
        for axis in "xy":
            row = table["variance explained", f"{run}, {axis}"]
            assert least < row.here < 100.0 and row.passed


@pytest.mark.slow
def test_its_contour_errors_are_those_measured(table: Table) -> None:
    for run, share in (("lead-lag", 0.25), ("pole-placement", 0.15)):
        for name in ("simulated contour rms", "simulated contour maximum"):
            row = table[name, run]
            assert row.here == pytest.approx(row.paper, rel=share)
            assert row.paper == pytest.approx(MEASURED[run][2 if "rms" in name else 3], rel=0.01)


@pytest.mark.slow
def test_the_library_keeps_its_documented_figures(table: Table) -> None:
    """As documented in docs/how-to/refinement.md; a change of the engine or the files shows here."""
    kept = {("lead-lag", "x"): 98.70, ("lead-lag", "y"): 98.29, ("pole-placement", "x"): 99.998, ("pole-placement", "y"): 99.995}
    for (run, axis), value in kept.items():
        assert table["variance explained", f"{run}, {axis}"].here == pytest.approx(value, abs=0.02)
    assert table["simulated contour rms", "lead-lag"].here == pytest.approx(84.6, abs=0.3)
    assert table["simulated contour rms", "pole-placement"].here == pytest.approx(46.1, abs=0.3)


@pytest.mark.slow
def test_every_row_can_fail_and_what_was_fitted_is_an_input(table: Table) -> None:
    check_each_row_can_fail([*table.values()])
    assert {row.kind for row in table.values() if row.paper is not None} == {"identity", "input"}


Unseen = tuple[list[Row], CrossValidation]


@pytest.fixture(scope="module")
def unseen(folder: Path, tmp_path_factory: pytest.TempPathFactory, worker_id: str) -> Unseen:
    """The rows of unseen runs, and what left out each run."""

    def made() -> Unseen:
        found = list[CrossValidation]()
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(study, "left_out", lambda runs: found.append(left_out(runs)) or found[0])  # type: ignore[func-returns-value]
            rows = run_parts(parts_of(folder)[len(parts_of(folder, with_unseen=False)) :], read_bands("ubc"))
        return rows, found[0]

    both: Unseen = once(tmp_path_factory, worker_id, "unseen runs of ubc", made)
    return both


@pytest.mark.slow
def test_the_machine_also_explains_unseen_runs(unseen: Unseen) -> None:
    found = unseen[0]
    check_each_row_can_fail(found)
    rows = [row for row in found if row.name.startswith("unseen")]
    explained = [row.here for row in rows if row.name == "unseen: variance explained"]
    assert len(explained) == 12
    contour = [row for row in rows if row.name == "unseen: contour rms"]
    assert len(contour) == 6 and all(row.paper > 0.0 and row.here > 0.0 for row in contour)


LATER = {"rms": (-3.6, 23.7, -8.9, -3.4, 29.5), "maximum": (-12.0, 30.0, -5.0)}
"""Simulated against measured [percent] for runs that no fit has seen, as documented in docs/how-to/refinement.md."""


@pytest.mark.slow
def test_the_interval_of_runs_left_out_covers_later_runs(unseen: Unseen) -> None:
    found = unseen[1]
    assert found.level == 2.0 / 3.0 and all(one.second_half for one in found.held_out)
    ratios = [one.simulated_rms / one.measured_rms for one in found.held_out]
    assert ratios == pytest.approx([1.053, 1.352], abs=0.01)
    for percent, factor in ((LATER["rms"], found.rms_factor), (LATER["maximum"], found.max_factor)):
        assert all(1.0 / factor < 1.0 + 0.01 * one < factor for one in percent)


@pytest.mark.slow
def test_the_command_prints_json_and_draws(
    table: Table, folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    parts = {(folder, False): [("rows", table.values)]}
    monkeypatch.setattr(study, "parts_of", lambda place, with_unseen, stage: parts[place, with_unseen])
    words = ["reproduce", "ubc", "--log-folder", str(folder), "--no-unseen", "--json", "--plots", "svg", "--out", str(tmp_path / "seen")]
    assert main(words) == 0
    rows = json.loads(capsys.readouterr().out)
    assert not [row for row in rows if row["pass"] is False]
    drawn = {file.name for file in (tmp_path / "seen").iterdir()}
    assert drawn == {f"ubc-{run}-{what}.svg" for run in MEASURED for what in ("x", "y", "contour")}


def test_without_logs_the_error_names_the_missing_ones(tmp_path: Path) -> None:
    with pytest.raises(LogError, match="folder"):
        parts_of(None)
    with pytest.raises(LogError, match=r"line_circle_lli\.mat.*line_circle_pp\.mat"):
        parts_of(tmp_path)
