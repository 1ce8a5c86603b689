"""``contourlab sensitivity`` as typed: from a scenario to its important parameters, with saved runs."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from typed_commands import CIRCLE, SCHEMES, Run, drag

from contourlab.cli.main import main
from contourlab.errors import ParameterError
from contourlab.features.sensitivity.options import Plan
from contourlab.study import runner

TWO = ["--parameter", "3.model_gain", "--parameter", "3.velocity_gain=0.05 full_scale*s/mm..0.2 full_scale*s/mm"]
SMALL = [*TWO, "--values", "9", "--base", "16", "--trajectories", "4"]


@pytest.fixture
def circle(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    file = tmp_path / "circle.toml"
    file.write_text(CIRCLE, encoding="utf-8")
    return file


@pytest.mark.slow
def test_a_quick_study_agrees_with_the_full_one_within_its_intervals(
    circle: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    fits = 1280.0  # fewer than the full study has
    monkeypatch.setattr("contourlab.features.sensitivity.command.affordable_candidates", lambda *_: fits)
    words = ["sensitivity", str(circle), *TWO, "--parts", "sobol,morris", "--json"]
    found = []
    for more in (["--quick", "--out", "quick"], ["--out", "full"]):
        assert main([*words, *more]) == 0
        found.append(json.loads(capsys.readouterr().out)["study"])
    quick, full = found
    assert full["sobol_sample"]["runs"] == 4 * quick["sobol_sample"]["runs"]
    for part, name in (("sobol", "total"), ("sobol", "first"), ("morris", "mu_star")):
        for one, other, within in zip(quick[part][name], full[part][name], quick[part][f"{name}_interval"], strict=True):
            assert abs(one - other) < 1.5 * within


def test_a_quick_study_takes_what_fits_and_refuses_what_does_not() -> None:
    plan, n = Plan(), 21

    def runs(plan: Plan) -> int:
        return sum(count for _, count in plan.work(n))

    assert plan.quickly(n, 1e9) == plan
    least = plan.quickly(n, runs(plan) - 1.0)
    assert (least.base, least.values, least.trajectories) == (128, 11, 16)
    for fits in (6000.0, 4000.0, 2000.0):
        taken = plan.quickly(n, fits)
        assert runs(taken) <= fits
    assert plan.quickly(n, 4000.0).chosen == plan.chosen and "local" not in plan.quickly(n, 2000.0).chosen
    with pytest.raises(ParameterError):
        plan.quickly(n, 1000.0)


def test_a_study_says_what_matters_and_keeps_its_runs(circle: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["sensitivity", str(circle), *SMALL, "--second-order", "--out", "out", "--json"]
    assert main([*words, "--plots", "svg"]) == 0
    found = json.loads(capsys.readouterr().out)
    study = found["study"]
    names = [one["name"] for one in study["space"]["numbers"]]
    assert names == ["controller.axes.3.controller.model_gain", "controller.axes.3.controller.velocity_gain"]
    assert study["present"] == pytest.approx(18.31e-6, rel=1e-3)
    assert study["curves"][0]["minimum"]["value"] == pytest.approx(1.05, rel=0.01)
    assert study["curves"][1]["flat"] is not None
    assert study["local"]["slopes"][0]["sensitivity"] == pytest.approx(-6.2, rel=0.02)
    assert list(found["ranking"]["matter"]) == ["3.model_gain"] and "3.velocity_gain" in found["ranking"]["negligible"]
    assert study["sobol"]["total"][0] > 0.8 and study["sobol_sample"]["runs"] == 16 * 6 and study["sobol_sample"]["failed"] == 0
    assert found["runs_reused"] == 0
    assert {file.name for file in Path("out/plots").iterdir()} == {"curves.svg", "interactions.svg", "morris.svg", "sobol.svg"}
    assert json.loads(Path("out/summary.json").read_text()) == found
    assert main([*words, "--workers", "1"]) == 0
    again = json.loads(capsys.readouterr().out)
    assert (again["runs_made"], again["runs_reused"]) == (0, found["runs_made"])
    assert again["study"] == study and again["ranking"] == found["ranking"]
    assert "CL900" in {one["code"] for one in again["findings"]}


def test_the_text_has_one_table_and_the_parts_have_theirs(circle: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["sensitivity", str(circle), *SMALL, "--figure", "max", "--deviation", "3.model_gain=5 %"]
    assert main(words) == 0
    said = capsys.readouterr().out
    assert "CL656" in said and "CL667" in said and "Morris" not in said and len(said.splitlines()) < 40
    assert main([*words, "--parts", "curves,local,morris,sobol", "--values", "9"]) == 0
    assert capsys.readouterr().out.splitlines()[-8:] == said.splitlines()[-8:]
    for part, mark in (("curves", "9 values"), ("local", "Interactions"), ("morris", "mu*"), ("sobol", "0 failed")):
        assert main([*words, "--parts", part]) == 0
        assert mark in capsys.readouterr().out


def test_an_interrupted_study_continues(circle: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    words = ["sensitivity", str(circle), *SMALL, "--json"]
    whole, calls = runner.simulate_batch, 0

    def stopped(*given: Any, **options: Any) -> Any:
        nonlocal calls
        calls += 1
        if calls == 5:
            raise KeyboardInterrupt
        return whole(*given, **options)

    with monkeypatch.context() as patch:
        patch.setattr(runner, "simulate_batch", stopped)
        assert main([*words, "--out", "out"]) == 130
    assert "Traceback" not in capsys.readouterr().err
    assert not Path("out/summary.json").exists()
    assert main([*words, "--out", "out"]) == 0
    resumed = json.loads(capsys.readouterr().out)
    assert main([*words, "--out", "fresh"]) == 0
    fresh = json.loads(capsys.readouterr().out)
    assert resumed["runs_reused"] > 0 and fresh["runs_reused"] == 0
    assert resumed["study"] == fresh["study"]


def test_runs_of_another_scenario_are_not_used_and_reported(circle: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["sensitivity", str(circle), *TWO, "--parts", "local", "--out", "out"]
    assert main(words) == 0
    circle.write_text(CIRCLE.replace('frequency = "0.5 Hz"', 'frequency = "0.4 Hz"'), encoding="utf-8")
    capsys.readouterr()
    assert main(words) == 0
    said = capsys.readouterr().out
    assert "CL901" in said and "CL900" not in said


def test_runs_of_a_changed_plugin_are_not_reused(contourlab: Run, circle: Path) -> None:
    circle.write_text(
        CIRCLE + '[axes.3]\nfriction = {kind = "drag-of-sensitivity", coefficient = "0.02 full_scale*s/m"}\n', encoding="utf-8"
    )
    words = ["sensitivity", circle, "--plugin", "drag.py", "--parameter", "3.model_gain", "--parts", "local", "--out", "out", "--json"]
    found = []
    for factor in (1.0, 1.0, 20.0):  # each in its own process, because a plugin is loaded once
        circle.with_name("drag.py").write_text(drag("drag-of-sensitivity", factor), encoding="utf-8")
        said = contourlab(*words)
        assert (said.code, said.err) == (0, "")
        found.append(json.loads(said.out))
    assert [one["runs_reused"] > 0 for one in found] == [False, True, False]
    assert found[1]["study"] == found[0]["study"] != found[2]["study"]


def test_one_scheme_is_studied_and_the_period_may_be_another(circle: Path, capsys: pytest.CaptureFixture[str]) -> None:
    circle.write_text(CIRCLE + SCHEMES, encoding="utf-8")
    assert main(["sensitivity", str(circle), *TWO, "--parts", "local"]) == 0
    said = capsys.readouterr().out
    assert "CL650" in said
    words = ["--scheme", "all of it", "--servo-period", "0.5 ms", "--json"]
    assert main(["sensitivity", str(circle), *TWO, "--parts", "local", *words]) == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["scheme"], found["servo_period"]) == ("all of it", 5e-4)
    assert found["request"]["servo_period"] == "0.5 ms" and found["request"]["plan"]["parts"] == ["local"]


def test_a_scenario_that_runs_away_says_where(circle: Path, capsys: pytest.CaptureFixture[str]) -> None:
    machine = '[axes."*".limits]\nfollowing_error = "1 um"\n'
    circle.write_text(CIRCLE + machine, encoding="utf-8")
    assert main(["sensitivity", str(circle), *TWO, "--parts", "local"]) == 3
    assert "sample" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--parameter", "3.nothing"], "such as"),
        (["--parameter", "3.model_gain=1 mm..2 mm"], "mm/s^2"),
        ([*TWO, "--base", "100"], "64 or 128"),
        ([*TWO, "--deviation", "nan %"], "above 0, such as 5 %"),
        ([*TWO, "--deviation", "-5 %"], "above 0, such as 5 %"),
        ([*TWO, "--plots", "gif"], "--plots"),
        ([*TWO, "--values", "3"], "5 or more"),
        ([*TWO, "--trajectories", "1"], "4 or more"),
        ([*TWO, "--figure", "mean"], "integral, rms, max"),
        ([*TWO, "--parts", "curves,all"], "curves, local, morris, sobol"),
        ([*TWO, "--distribution", "normal"], "--deviation"),
        ([*TWO, "--deviation", "x=5 %"], "with a varied parameter"),
        ([*TWO, "--transform", "square"], "log or none"),
        ([*TWO, "--servo-period", "1 mm"], "--servo-period"),
        ([*TWO, "--workers", "0"], "1 or more"),
        ([*TWO, "--seed", "-1"], "0 or more"),
        ([*TWO, "--width", "0.5"], "a factor either side"),
        ([*TWO, "--scheme", "none such"], "none such"),
        ([*TWO, "--plots", "bmp"], "png, svg, pdf"),
        (["--parameter", "3.model_gain"], "two or more"),
    ],
)
def test_invalid_options_are_refused(circle: Path, words: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["sensitivity", str(circle), *words]) == 2
    streams = capsys.readouterr()
    assert said in streams.err and "Traceback" not in streams.err and not streams.out
    assert not Path("results").exists()
