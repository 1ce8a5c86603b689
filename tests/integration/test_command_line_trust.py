"""How far to trust a run, and the machines library, as typed."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typed_commands import AsJson, Refused

from contourlab.cli.main import main
from contourlab.result import Result
from contourlab.scenario import builtin_names, dump, load_scenario, parse_scenario

RUN = """\
name = "circle"
controller = "builtin:emps/controller"
[machine]
name = "two of them"
servo_period = "1 ms"
axes = ["x", "y"]
[axes."*"]
file = "builtin:emps/axis"
[contour]
name = "circle"
radius = "50 mm"
offset = ["120 mm", "120 mm"]
[feed]
law = "uniform"
frequency = "0.25 Hz"
laps = 2
[run]
tolerance = "60 um"
"""
SURE = """\
[schemes.fitted]
[schemes."without deviations"]
axes."*".plant = {mass = "95.1163 kg", damping = "203.373 N*s/m"}
axes."*".friction.coulomb = "20.409 N"
axes."*".disturbance.force = "3.17003 N"
"""

LEARNING = """
[learning]
law = {kind = "zero-phase", gain = 0.2, half_width = 11}
trials = 1
"""


def run(folder: Path, text: str, *words: str) -> dict[str, Any]:
    (folder / "scenario.toml").write_text(text, encoding="utf-8")
    main(["run", str(folder / "scenario.toml"), "--out", str(folder / "out"), *words])
    found: dict[str, Any] = json.loads((folder / "out" / "summary.json").read_text(encoding="utf-8"))
    return found


@pytest.fixture(scope="module")
def done(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict[str, Any]]:
    folder = tmp_path_factory.mktemp("trust")
    return folder, run(folder, RUN + SURE)


def test_the_interval_lies_about_the_run_itself(done: tuple[Path, dict[str, Any]]) -> None:
    folder, found = done
    trust = found["schemes"]["fitted"]["trust"]
    interval = trust["interval"]
    assert (interval["samples"], interval["failed"]) == (64, 0)
    result = Result.load(folder / "out" / "signals" / "fitted.nc")
    judged = round(found["schemes"]["fitted"]["metrics"]["judged_time"] / result.servo_period)
    start, stop = result.n_sample - judged, result.n_sample
    error = 0.05 - np.hypot(*(result["axis_position"][start:stop] - [0.12, 0.12]).T)
    for name, here in (("rms", np.sqrt(np.mean(error**2))), ("max", np.abs(error).max())):
        spread = interval[name]
        assert spread["low"] < spread["median"] < spread["high"]
        assert spread["low"] < here < spread["high"]
        assert 0.001 < (spread["high"] - spread["low"]) / here < 0.2
    assert interval["beyond_tolerance"] == 0
    assert interval["main"] in {one["name"] for one in interval["ranks"]}
    drawn = {one["name"] for one in trust["provenance"] if one["drawn"]}
    assert {one["name"] for one in interval["ranks"]} == drawn
    assert drawn == {
        f"axes.{axis}.{name}" for axis in "xy" for name in ("plant.mass", "plant.damping", "friction.coulomb", "disturbance.force")
    }


def test_provenance_is_in_the_summary(done: tuple[Path, dict[str, Any]]) -> None:
    entries = {one["name"]: one for one in done[1]["schemes"]["fitted"]["trust"]["provenance"]}
    mass = entries["axes.x.plant.mass"]
    assert mass == {
        "name": "axes.x.plant.mass",
        "value": 95.1163,
        "unit": "kg",
        "source": "fitted",
        "deviation": 0.244,
        "range": None,
        "reference": "DATA_EMPS.mat",
        "note": "",
        "drawn": True,
    }
    assert entries["controller.axes.x.controller.position_gain"]["source"] == "design"
    assert "machine.servo_period" in done[1]["schemes"]["fitted"]["trust"]["not_stated"]


def test_a_scheme_with_other_values_has_no_deviations(done: tuple[Path, dict[str, Any]]) -> None:
    scheme = done[1]["schemes"]["without deviations"]
    trust = scheme["trust"]
    assert "CL220" in [finding["code"] for finding in scheme["findings"]]
    assert trust["interval"]["rms"] is None
    assert "axes.x.plant.mass" in trust["not_stated"]


def test_the_page_shows_provenance_and_interval(done: tuple[Path, dict[str, Any]]) -> None:
    page = (done[0] / "out" / "report.html").read_text(encoding="utf-8")
    part = page[page.index('<section id="trust">') : page.index("</section>", page.index('<section id="trust">'))]
    for words in ("± 0.244 (0.26 %)", "DATA_EMPS.mat", "N*s/m", "0 of 64", "differ from the schemes above"):
        assert words in part
    interval = done[1]["schemes"]["fitted"]["trust"]["interval"]
    assert f"<code>{interval['main']}</code>" in part
    assert f"{interval['rms']['median'] * 1e6:.1f}" in part


def test_the_report_holds_a_scenario_that_reads_back_with_its_deviations(done: tuple[Path, dict[str, Any]]) -> None:
    scenario = load_scenario(done[0] / "scenario.toml")
    again = parse_scenario(dump(scenario))
    for name in ("fitted", "without deviations"):
        one, other = (found.case(name).machine.axes[1] for found in (scenario, again))
        assert (one.plant.origins, one.correlations) == (other.plant.origins, other.correlations)
    assert len(again.case("fitted").machine.axes[1].correlations) == 6


@pytest.mark.slow
def test_the_interval_is_printed_and_can_be_left_out(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    run(tmp_path, RUN)
    said = capsys.readouterr().out
    assert "CL225" in said
    assert "CL228" in said
    found = run(tmp_path, RUN, "--no-interval")
    assert "CL225" not in capsys.readouterr().out
    assert found["schemes"]["base"]["trust"]["interval"] is None
    assert found["schemes"]["base"]["trust"]["provenance"]
    assert 'id="trust"' not in (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert found["command"].endswith("--no-interval")


@pytest.mark.parametrize("words", [("compare", "run.toml"), ("learn", "run.toml", "--trials", "1")])
@pytest.mark.slow
def test_every_command_with_schemes_can_leave_the_interval_out(
    words: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, as_json: AsJson
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "run.toml").write_text(RUN + LEARNING, encoding="utf-8")
    for option, known in (("--interval", True), ("--no-interval", False)):
        found = as_json(*words, option, code=(0, 1))
        assert option in found["command"].split()
        assert all((scheme["trust"]["interval"] is not None) == known for scheme in found["schemes"].values())


def test_without_deviations_one_line_says_so(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    run(tmp_path, RUN + SURE.replace("[schemes.fitted]\n", ""))
    assert "CL220" in capsys.readouterr().out


# --- the library ---------------------------------------------------------------------------------------------------------------------


def test_every_shipped_file_is_listed_with_its_kind(as_json: AsJson, capsys: pytest.CaptureFixture[str]) -> None:
    found = {one["name"]: one for one in as_json("machines")}
    assert set(found) == set(builtin_names())
    assert all(one["about"] for one in found.values())
    assert found["emps/axis"]["kind"] == "axis" and found["emps/axis"]["references"][0] == "DATA_EMPS.mat"
    assert found["ubc/table"]["references"] == ["Gigahawk/mech467", "line_circle_lli.mat", "line_circle_pp.mat"]
    assert found["gecer-ulu/stage"]["references"] == ["Gecer Ulu, Ulu & Cakmakci"]
    assert found["ghaffari/a3a1"]["axes"] == ["1", "3"] and found["ghaffari/a3a1"]["sources"]["fitted"] == 4
    assert found["emps/circle"]["kind"] == "scenario" and found["ghaffari/initial"]["kind"] == "controller"
    assert main(["machines"]) == 0
    assert "ghaffari/axis1" in capsys.readouterr().out


def test_a_shipped_file_is_shown(refused: Refused, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["machines", "emps/axis"]) == 0
    said = capsys.readouterr().out
    assert "plant.mass" in said and "0.244 (0.26 %)" in said and "4 fitted" in said
    assert main(["machines", "ghaffari/calibrated"]) == 0
    assert "modified-reference" in capsys.readouterr().out
    assert "'emps/axis'" in refused("machines", "emps/axes")


@pytest.mark.parametrize("name", ["emps/there-and-back", "backlash/part", "gecer-ulu/contour"])
def test_a_copy_of_a_shipped_file_runs(
    name: str, tmp_path: Path, as_json: AsJson, refused: Refused, capsys: pytest.CaptureFixture[str]
) -> None:
    first = as_json("machines", name, "--copy", tmp_path)[0]
    assert main(["run", first, "--check"]) == 0
    capsys.readouterr()
    assert "already contains" in refused("machines", name, "--copy", tmp_path)
    assert main(["machines", name, "--copy", str(tmp_path), "--force"]) == 0
    assert main(["machines", "--copy", str(tmp_path)]) == 2


def test_the_emps_tracks_in_simulation_as_it_was_measured(tmp_path: Path) -> None:
    """One period of the log's reference, as a part program: 0.578 mm rms and 0.852 mm at most were measured over all of it."""
    main(["run", "builtin:emps/there-and-back", "--out", str(tmp_path)])
    tracking = json.loads((tmp_path / "summary.json").read_text(encoding="utf-8"))["schemes"]["base"]["metrics"]["tracking_error"][0]
    assert tracking["rms"] == pytest.approx(0.578e-3, rel=0.01)
    assert tracking["max"] == pytest.approx(0.852e-3, rel=0.01)
