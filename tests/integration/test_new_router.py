"""A router described with the data of its motors and nothing else: the first figures are those of an engineer's controller."""

from __future__ import annotations

import io
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from reference_data import reference_file

import contourlab as cl
from contourlab.cli.main import main
from contourlab.features.machines.answers import read_answers
from contourlab.features.machines.new_machine import new_machine, write_machine
from contourlab.features.run.outcome import run_case
from contourlab.features.run.trust import part_interval
from contourlab.scenario import Case, load_machine, scenario_from_parts
from contourlab.study import Setting

RUBBING = {f"{axis}.{key}": value for axis in "xyz" for key, value in (("friction", "44.9 N"), ("damping", "180 N*s/m"))}
"""Of the machine for which the cascade was made."""


def made(place: Path, **further: str) -> Case:
    folder = reference_file("repro/router/answers.toml").parent
    write_machine(new_machine({**read_answers(folder / "answers.toml"), **further}), place)
    return scenario_from_parts(folder / "part.ngc", place / "machine.toml", place / "controller.toml").cases()[0]


def test_the_error_on_cutting_moves_is_that_of_a_hand_made_cascade(tmp_path: Path) -> None:
    case = made(tmp_path, **RUBBING)
    reference, route = case.reference(), case.route()
    result = cl.judge(cl.simulate(case.machine, case.controller, reference), reference)
    assert route is not None
    rapid = route.rapid[reference.path.curve_index(reference.block(0, reference.n_sample).arc_length)]
    error = np.abs(np.asarray(result["part_error"]))
    assert error[~rapid].max() == pytest.approx(23.8e-6, rel=0.2)


@pytest.mark.slow
def test_the_guesses_give_an_interval(tmp_path: Path) -> None:
    interval = part_interval(Setting.of(made(tmp_path)))
    assert [one.code for one in interval.findings] == ["CL225", "CL228"]
    assert interval.failed == 0
    assert interval.max is not None and interval.max.low < interval.max.high


@pytest.mark.slow
def test_a_router_from_its_ini_runs_and_says_what_it_rests_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The figure of a run follows the file of the control, the answers and the guesses; a share of the error rests on guesses."""
    ini = reference_file("repro/trial3/router.ini")
    typed = ["z on x, x on y", "", "1.9", "0.5", "5", "8", "", "25", "", "6", "6", "20, 20, 10"]
    monkeypatch.setattr("sys.stdin", io.StringIO("\n".join(typed) + "\n"))
    assert main(["new", "machine", "--from", str(ini), "--out", str(tmp_path / "made")]) == 0
    part = ini.parent / "bracket.ngc"
    runs = cl.run(part, machine=tmp_path / "made", tolerance="50 um", interval=False)
    (outcome,) = runs.outcomes
    codes = {note.code: note for note in outcome.findings}
    assert {"CL980", "CL985"} <= set(codes) and "CL984" not in codes
    assert set(runs.machine["origin"].values()) == {"read", "computed", "guessed", "datasheet"}
    causes = {cause.name: cause.contribution for cause in outcome.verdict.causes}
    assert abs(causes["backlash"]) == pytest.approx(10e-6, rel=0.2)  # half of the gap; towards the path or away, as the worst place has it
    assert outcome.verdict.passed


def test_answers_do_not_contradict_the_file_of_the_control(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    dump, answers = tmp_path / "grbl.txt", tmp_path / "answers.toml"
    dump.write_text("$100=200.0\n$110=3000.0\n$120=200.0\n$130=300.0\n", encoding="ascii")
    words = ["new", "machine", "--from", str(dump)]
    assert main([*words, "--template"]) == 0
    template = capsys.readouterr().out
    assert 'holding_torque = ""' in template and "rated_torque" not in template and "[y]" not in template
    filled = template.replace('torque = ""', 'torque = "1"').replace('inertia = ""', 'inertia = "1"').replace('mass = ""', 'mass = "8"')
    for text, code in ((filled, 0), (filled.replace('velocity = "', 'velocity = "1'), 2)):
        answers.write_text(text, encoding="utf-8")
        assert main([*words, "--answers", str(answers), "--out", str(tmp_path / "made"), "--force"]) == code
    assert "x.velocity" in capsys.readouterr().err
    assert main(["new", "machine", "--from", str(tmp_path / "none.ini"), "--template"]) == 2


@pytest.mark.parametrize(("preset", "drive"), [("router", "stepper"), ("mill", "step-drive")])
def test_a_preset_has_the_drives_of_a_control_that_makes_steps(tmp_path: Path, preset: str, drive: str) -> None:
    ini = reference_file("repro/trial3/router.ini")
    assert main(["new", "machine", "--from", str(ini), "--preset", preset, "--out", str(tmp_path)]) == 0
    answers = read_answers(tmp_path / "answers.toml")
    assert {answers[f"{axis}.drive"] for axis in "xyz"} == {drive}
    assert answers.get("x.holding_torque") == ("1.9 N*m" if drive == "stepper" else None)
    assert answers["x.velocity"] == "133 mm/s" and "x.rated_torque" not in answers
    assert load_machine(tmp_path / "machine.toml").axis_names == ("x", "y", "z")


def judged_to_100_um(case: Case) -> Case:
    return replace(case, run=replace(case.run, tolerance=100e-6))


@pytest.mark.slow
def test_a_verdict_on_a_guess_says_so(tmp_path: Path) -> None:
    outcome = run_case(judged_to_100_um(made(tmp_path)))
    (note,) = [note for note in outcome.findings if note.code == "CL229"]
    assert note.values["share"] > 0.8 and "axes.*.friction.coulomb" in note.values["numbers"]
    known = made(tmp_path / "known", **RUBBING)
    told = run_case(judged_to_100_um(known)).findings
    assert "axes.*.friction.coulomb" not in [name for note in told if note.code == "CL229" for name in note.values["numbers"]]
