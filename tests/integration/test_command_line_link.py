"""``contourlab link`` as typed."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from typed_commands import contents

from contourlab.app import quick
from contourlab.app.results import LIST
from contourlab.cli.main import main
from contourlab.features.link import command
from contourlab.features.link.cost import division_cost

CIRCLE = """
name = "circle"
machine = "builtin:ghaffari/a3a1"
controller = {file = "builtin:ghaffari/calibrated"LINK}
[contour]
name = "circle"
radius = "20 mm"
[feed]
law = "uniform"
frequency = "0.5 Hz"
laps = 2
"""
OWN = ', axes = {"*" = {link = {division = "observer", down = {kind = "network", message_period = "2 ms"}, up = "ideal"}}}'


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Results go into a folder of the test by default."""
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def circle(tmp_path: Path) -> str:
    (tmp_path / "circle.toml").write_text(CIRCLE.replace("LINK", ""), encoding="utf-8")
    return str(tmp_path / "circle.toml")


def output(capsys: pytest.CaptureFixture[str], *words: str, code: int = 0) -> str:
    assert main(["link", *words]) == code
    said = capsys.readouterr()
    return said.err if code else said.out


def scheme(capsys: pytest.CaptureFixture[str], *words: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(output(capsys, *words))["schemes"]["base"]
    return found


@pytest.mark.slow
def test_the_smallest_message_rate_is_printed(circle: str, capsys: pytest.CaptureFixture[str]) -> None:
    said = output(capsys, circle, "--division", "observer", "--vary", "message-period,delay", "--longest", "20 ms")
    assert "9.986 um undivided, 10.98 um allowed" in said
    both, one = (line for line in said.splitlines() if line.startswith("observer") and "Hz" in line)
    assert both.startswith("observer, both ways") and "(125 Hz)" in both and one.startswith("observer, one way")


def test_an_interrupt_keeps_the_divisions_that_ended(
    circle: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    given = iter(range(9))

    def one_division(*words: Any) -> Any:
        if next(given):
            raise KeyboardInterrupt
        return division_cost(*words)

    monkeypatch.setattr(command, "division_cost", one_division)
    words = (circle, "--division", "drive,controller", "--ways", "both", "--vary", "delay", "--longest", "5 ms", "--out", "kept")
    assert "drive, both ways" in output(capsys, *words, code=130)
    kept = json.loads(Path("kept/summary.json").read_text(encoding="utf-8"))
    assert [one["division"] for one in kept["schemes"]["base"]["divisions"]] == ["drive"]


@pytest.mark.slow
def test_json_alone_holds_curves_and_limits(circle: str, capsys: pytest.CaptureFixture[str]) -> None:
    words = (
        circle,
        "--division",
        "drive,controller",
        "--ways",
        "both",
        "--vary",
        "delay,loss",
        "--longest",
        "10 ms",
        "--seeds",
        "2",
        "--json",
    )
    found = json.loads(output(capsys, *words))["schemes"]["base"]
    assert found["allowed"] == pytest.approx(1.1 * found["undivided"])
    drive, controller = found["divisions"]
    assert (drive["division"], controller["division"]) == ("drive", "controller")
    sweep = drive["sweeps"]["delay"]
    assert sweep["most"] == sweep["stable_linear"] == sweep["stable_simulated"] == pytest.approx(1e-3)
    assert sweep["error"][0] == pytest.approx(found["undivided"])
    assert len(sweep["values"]) == len(sweep["error"]) == len(sweep["growth"]) == 11
    assert controller["sweeps"]["delay"]["stable_linear"] is None  # stable at every tested value
    assert 0.0 < drive["sweeps"]["loss"]["most"] < 1.0
    assert controller["local_parameters"]["1"]


@pytest.mark.slow
def test_a_sweep_that_ends_early_says_so(circle: str, capsys: pytest.CaptureFixture[str]) -> None:
    """A delay beyond 1 ms never holds here: the sweep need not test every delay up to --longest."""
    words = (circle, "--division", "observer", "--ways", "both", "--vary", "delay", "--json", "--longest")
    found = {longest: scheme(capsys, *words, longest) for longest in ("50 ms", "80 ms")}
    codes = {longest: {one["code"] for one in answer["findings"]} for longest, answer in found.items()}
    assert codes == {"50 ms": {"CL759"}, "80 ms": {"CL759", "CL761"}}
    sweep = found["80 ms"]["divisions"][0]["sweeps"]["delay"]
    assert (sweep["asked"], sweep["ended_early"], sweep["values"][-1]) == (pytest.approx(0.08), True, pytest.approx(0.063))
    assert sweep["limited_by"] == "error"


def test_a_sweep_of_a_single_value_is_reported_too(circle: str, capsys: pytest.CaptureFixture[str]) -> None:
    words = (circle, "--division", "drive", "--ways", "both", "--vary", "message-period,delay", "--longest", "1 ms", "--json")
    assert [one["code"] for one in scheme(capsys, *words)["findings"]] == ["CL759"]


@pytest.mark.slow
def test_a_quick_limit_lies_around_that_of_the_whole_sweep(circle: str, capsys: pytest.CaptureFixture[str]) -> None:
    words = (circle, "--division", "observer", "--vary", "message-period,delay,loss", "--longest", "30 ms", "--seeds", "2", "--json")
    coarse, whole = scheme(capsys, *words, "--quick"), scheme(capsys, *words)
    for few, all_values in zip(coarse["divisions"], whole["divisions"], strict=True):
        for quantity, sweep in all_values["sweeps"].items():
            found = few["sweeps"][quantity]
            assert found["most"] - 1e-9 <= sweep["most"] < found["fails"] and found["coarse"]
            assert len(found["values"]) < len(sweep["values"])
    assert [one["code"] for one in coarse["findings"]] == ["CL765"]


@pytest.mark.slow
def test_a_scheme_that_does_not_fit_into_a_minute_is_refused(circle: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(quick, "PLANNED", 1e-3)
    assert main(["link", circle, "--quick"]) == 2


def test_if_nothing_holds_the_reason_is_reported(circle: str, capsys: pytest.CaptureFixture[str]) -> None:
    words = (circle, "--division", "controller", "--ways", "one", "--vary", "message-period", "--longest", "4 ms")
    (found,) = (one for one in scheme(capsys, *words, "--tolerance", "1 um", "--json")["findings"] if one["code"] == "CL762")
    assert found["values"] == {"least": "1 ms", "error": "9.907 um", "allowed": "1 um"}


@pytest.mark.parametrize("chance", [("--jitter", "0.3 ms"), ("--loss", "1 %")])
@pytest.mark.slow
def test_no_margin_under_jitter_and_loss_is_explained(circle: str, chance: tuple[str, str], capsys: pytest.CaptureFixture[str]) -> None:
    words = (circle, "--division", "observer", "--vary", "delay", "--longest", "3 ms", "--seeds", "1", *chance)
    said = output(capsys, *words)
    assert said.count("- / -") == 2
    assert said.count("CL754") == 1  # a finding that all divisions share is printed once


def test_one_lap_alone_does_not_show_stability(circle: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "once.toml").write_text(CIRCLE.replace("LINK", "").replace("laps = 2", "laps = 1"), encoding="utf-8")
    said = output(capsys, str(tmp_path / "once.toml"), "--division", "observer", "--vary", "delay", "--longest", "3 ms")
    assert "1 ms / -" in said and "CL755" in said


def test_unstable_from_the_smallest_value_on_is_none_not_unknown(circle: str, capsys: pytest.CaptureFixture[str]) -> None:
    words = (circle, "--division", "observer", "--ways", "both", "--vary", "delay", "--longest", "3 ms", "--message-period", "20 ms")
    assert "none / none" in output(capsys, *words)


def test_a_tolerance_in_place_of_a_part_and_another_figure(circle: str, capsys: pytest.CaptureFixture[str]) -> None:
    words = (circle, "--division", "observer", "--ways", "both", "--vary", "message-period", "--longest", "20 ms", "--json")
    largest = json.loads(output(capsys, *words, "--figure", "max", "--tolerance", "30 um"))["schemes"]["base"]
    assert (largest["figure"], largest["allowed"]) == ("contour_error_max", pytest.approx(30e-6))
    within = json.loads(output(capsys, *words, "--figure", "integral", "--within", "50 %"))["schemes"]["base"]
    assert within["undivided"] == pytest.approx(18.31e-6, rel=5e-3)
    assert within["allowed"] == pytest.approx(1.5 * within["undivided"])


def test_a_scenario_with_links_keeps_its_own_division(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "own.toml").write_text(CIRCLE.replace("LINK", OWN), encoding="utf-8")
    found = json.loads(output(capsys, str(tmp_path / "own.toml"), "--vary", "delay", "--longest", "8 ms", "--json"))["schemes"]["base"]
    (division,) = found["divisions"]
    assert (division["division"], division["ways"]) == ("observer", "one")
    assert division["sweeps"]["delay"]["error"][0] == division["error"] != found["undivided"]


@pytest.mark.slow
def test_plots_are_written_where_they_are_asked_for(circle: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = (circle, "--division", "observer", "--vary", "delay,loss", "--longest", "4 ms", "--seeds", "1")
    said = output(capsys, *words, "--plots", "svg", "--out", str(tmp_path / "out"))
    assert sorted(contents(tmp_path / "out")) == [LIST, "plots/link-delay.svg", "plots/link-loss.svg", "summary.json"]
    assert said.count("plot: ") == 2
    output(capsys, *words, "--out", str(tmp_path / "out"))  # results replace older ones together
    assert sorted(contents(tmp_path / "out")) == [LIST, "summary.json"]


def test_the_saved_results_equal_the_printed_ones(circle: str, capsys: pytest.CaptureFixture[str]) -> None:
    words = (circle, "--division", "observer", "--ways", "both", "--vary", "delay", "--longest", "2 ms")
    printed = json.loads(output(capsys, *words, "--json"))
    assert json.loads(Path("results/summary.json").read_text(encoding="utf-8")) == printed


@pytest.mark.parametrize("place", ["file", "file/below"])
def test_an_invalid_folder_is_refused_before_anything_runs(
    circle: str, place: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("of the user")
    monkeypatch.setattr("contourlab.features.link.command.undivided_error", lambda *_, **__: pytest.fail("it ran"))
    assert "cannot be written" in output(capsys, circle, "--out", place, code=2)
    assert (tmp_path / "file").read_text() == "of the user"


def test_messages_that_never_arrive_are_reported(circle: str, capsys: pytest.CaptureFixture[str]) -> None:
    words = (circle, "--division", "observer", "--ways", "both", "--vary", "message-period", "--longest", "2 ms")
    late, lost = (output(capsys, *words, *more) for more in (("--delay", "9 s"), ("--loss", "1", "--seeds", "1")))
    assert "CL752" in late and "none" in late and "CL751" in lost


def test_a_loop_that_runs_away_undivided_is_3_and_says_where(circle: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "wild.toml").write_text(
        CIRCLE.replace("LINK", "") + '[schemes.wild]\naxes.3.drive.limit = "1e6 full_scale"\n'
        'controller.axes.3.controller.position_gain = "4000 full_scale/mm"\n',
        encoding="utf-8",
    )
    said = output(capsys, str(tmp_path / "wild.toml"), code=3)
    assert "axis 3" in said and "Scheme 'wild' diverges without links" in said
    assert not Path("results").exists()


@pytest.mark.slow
def test_one_axis_may_be_divided_alone(circle: str, capsys: pytest.CaptureFixture[str]) -> None:
    """The swapped axis has a network, the others are wired."""
    words = (circle, "--division", "observer", "--ways", "both", "--vary", "delay", "--longest", "8 ms", "--json")
    both, one = (json.loads(output(capsys, *words, *more))["schemes"]["base"]["divisions"][0] for more in ((), ("--axes", "1")))
    assert one["local_parameters"]["3"] == [] and one["local_parameters"]["1"]
    assert one["sweeps"]["delay"]["stable_linear"] >= both["sweeps"]["delay"]["stable_linear"] > 0.0
    assert one["sweeps"]["delay"]["error"][0] == both["sweeps"]["delay"]["error"][0]
    assert one["sweeps"]["delay"]["error"][1] != both["sweeps"]["delay"]["error"][1]
    assert "'7'" in output(capsys, circle, "--division", "observer", "--axes", "7", code=2)


def test_extrapolated_messages_have_no_linear_model(circle: str, capsys: pytest.CaptureFixture[str]) -> None:
    words = (circle, "--division", "observer", "--ways", "both", "--vary", "delay", "--longest", "4 ms")
    said = output(capsys, *words, "--extrapolate")
    assert "CL757" in said


LATE = OWN.replace('up = "ideal"', 'up = {kind = "network", delay = "20 ms"}')


@pytest.mark.slow
def test_analyse_says_whether_the_messages_leave_it_stable(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name, link, code in (("own", OWN, 0), ("late", LATE, 1)):
        (tmp_path / f"{name}.toml").write_text(CIRCLE.replace("LINK", link), encoding="utf-8")
        assert main(["analyse", str(tmp_path / f"{name}.toml")]) == code
        assert ("CL352" if code == 0 else "CL353") in capsys.readouterr().out
    assert main(["analyse", str(tmp_path / "late.toml"), "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["schemes"]["base"]["link_growth"] > 1.0


@pytest.mark.slow
def test_the_network_is_named_as_a_cause(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "late.toml").write_text(CIRCLE.replace("LINK", LATE) + '[run]\ntolerance = "16 um"\n', encoding="utf-8")
    assert main(["run", str(tmp_path / "late.toml"), "--out", str(tmp_path / "out")]) == 1
    assert "causes there: network" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "wanted"),
    [
        (("--division", "half"), "drive, observer, controller"),
        (("--ways", "three"), "both, one"),
        (("--division", "drive,drive"), "drive is given twice"),
        (("--ways", "both,one,both"), "both is given twice"),
        (("--vary", "message-period,delay,message-period"), "message-period is given twice"),
        (("--division", "drive", "--axes", "1,1"), "1 is given twice"),
        (("--vary", "colour"), "message-period"),
        (("--figure", "mood"), "rms"),
        (("--within", "often"), "10 %"),
        (("--within", "5"), 'in %: "5 %" or "500 %"'),
        (("--tolerance", "15 s"), "15 um"),
        (("--tolerance", "0 um"), "> 0"),
        (("--delay", "5 mm"), "2 ms"),
        (("--delay", "-2 ms"), ">= 0"),
        (("--loss", "2"), "<= 1"),
        (("--longest", "0.1 ms"), "servo period"),
        (("--seeds", "0"), ">= 1"),
        (("--seeds", "100000"), "<= 256"),
        (("--delay", "11 s"), "<= 10 s"),
        (("--plots", "bmp", "--vary", "delay", "--longest", "2 ms"), "png"),
        (("--within", "10 %", "--tolerance", "15 um"), "one of the two"),
        (("--longest", "20 ms", "--vary", "loss"), "tests the loss only"),
        (("--seeds", "4", "--vary", "delay,message-period", "--delay", "1 ms"), "nothing else is random"),
    ],
)
def test_bad_input_is_2_in_one_line(circle: str, words: tuple[str, ...], wanted: str, capsys: pytest.CaptureFixture[str]) -> None:
    said = output(capsys, circle, *words, code=2)
    assert wanted in said
    assert said.count("\n") == 1


@pytest.mark.parametrize(
    "words", [("--ways", "both"), ("--axes", "1"), ("--delay", "1 ms"), ("--message-period", "2 ms"), ("--extrapolate",)]
)
def test_dividing_a_scheme_with_its_own_links_is_refused(
    tmp_path: Path, words: tuple[str, ...], capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "own.toml").write_text(CIRCLE.replace("LINK", OWN), encoding="utf-8")
    said = output(capsys, str(tmp_path / "own.toml"), *words, code=2)
    assert words[0] in said and "given with --division: without it, scheme 'base' keeps its own links" in said
    assert not Path("results").exists()


def test_the_links_of_a_scheme_may_be_random(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    drawn = OWN.replace('"2 ms"}', '"2 ms", jitter = "0.4 ms"}')
    (tmp_path / "own.toml").write_text(CIRCLE.replace("LINK", drawn), encoding="utf-8")
    words = (str(tmp_path / "own.toml"), "--vary", "delay", "--longest", "2 ms", "--seeds", "2")
    assert "CL754" in output(capsys, *words)
    assert "nothing else is random" in output(capsys, *words, "--division", "drive", code=2)
