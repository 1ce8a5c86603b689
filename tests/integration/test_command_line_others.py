"""The other commands as a user types them: help, components, new machine, reproduce."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
from typed_commands import Run, contents

import contourlab as package
from contourlab.components.contract import FAMILIES

ANSWERS = """\
axes = ["x", "y"]
mounting = "x on y"
[x]
rated_torque = "1.3 N*m"
torque_constant = "0.5 N*m/A"
rotor_inertia = "0.6 kg*cm^2"
moved_mass = "20 kg"
[y]
rated_torque = "2.4 N*m"
torque_constant = 0.5
rotor_inertia = 1.2
moved_mass = 40
lead = "5 mm"
"""
TYPED_X = ["", "1.3", "0.5", "0.6", "", "20", "", "", "", "", ""]
TYPED_Y = ["x except rated_torque, rotor_inertia, lead, moved_mass", "2400 mN*m", "1.2", "5 mm", "40"]
TYPED = "\n".join(["x, y", "", "x on y", *TYPED_X, *TYPED_Y, "", ""])
"""The same answers as a person types them: an empty line takes the default."""


def test_help_names_every_command_and_what_it_does(contourlab: Run) -> None:
    said = contourlab("--help").answer
    for command in ("demo", "run", "components", "reproduce", "new"):
        (line,) = (line for line in said.splitlines() if line.startswith(f"│ {command} "))
        assert len(line.strip("│ ").removeprefix(command).split()) > 2


@pytest.mark.parametrize("word", ["new", "reproduce"])
def test_an_incomplete_command_shows_what_is_missing(contourlab: Run, word: str) -> None:
    said = contourlab(word)
    assert said.code == 2
    assert {"new": "machine", "reproduce": "ghaffari"}[word] in said.out
    assert said.err.startswith("contourlab: ") and f"contourlab {word} --help" in said.err


def test_version_is_that_of_the_package(contourlab: Run) -> None:
    said = contourlab("--version")
    assert (said.code, said.out, said.err) == (0, f"contourlab {package.__version__}\n", "")


@pytest.mark.skipif(os.name == "nt", reason="Windows does not report the processor time of a child")
def test_help_shows_units_in_brackets(contourlab: Run) -> None:
    for word in ("measure", "identify", "refine"):
        assert "[mm]" in contourlab(word, "--help").out


def test_help_takes_less_than_half_a_second(contourlab: Run) -> None:
    def spent() -> float:
        before = os.times()
        contourlab("--help")
        after = os.times()
        return after.children_user - before.children_user + after.children_system - before.children_system

    assert min(spent() for _ in range(3)) < 0.5


def test_components_lists_each_family_and_describes_one(contourlab: Run) -> None:
    kinds = {(entry["family"], entry["kind"]): entry for entry in json.loads(contourlab("components", "--json").answer)}
    assert {family for family, _ in kinds} == set(FAMILIES)
    said = contourlab("components", "lugre").answer
    for parameter in kinds["friction", "lugre"]["parameters"]:
        assert parameter["name"] in said
        assert parameter["doc"].split()[0] in said
    assert "friction/coulomb" not in said


def test_an_unknown_component_is_exit_code_2_and_lists_the_known_ones(contourlab: Run) -> None:
    said = contourlab("components", "lugree").refusal
    assert said.count("\n") == 1
    assert "'lugree'" in said
    assert "'lugre'" in said


def test_typed_answers_give_a_machine_that_runs_at_once(contourlab: Run, tmp_path: Path) -> None:
    made = contourlab("new", "machine", "--out", "mill", typed=TYPED)
    assert made.code == 0
    axes = {"axis-x.toml", "axis-y.toml"}
    assert set(contents(tmp_path / "mill")) == {"machine.toml", *axes, "controller.toml", "scenario.toml", "answers.toml"}
    # Questions go to standard error, so standard output can be saved.
    assert "Rated torque" in made.err
    assert "Rated torque" not in made.out
    (following,) = (line for line in made.out.splitlines() if line.startswith("next: "))
    said = contourlab(*following.removeprefix("next: contourlab ").split(), "--json")
    assert said.err == ""
    found = json.loads(said.out)["schemes"]["base"]
    assert said.code == (0 if found["verdict"]["passed"] else 1)
    assert found["axes"] == ["x", "y"]
    assert found["metrics"]["saturation"] == [0.0, 0.0]  # the limits were checked against the motors
    assert min(margins["phase"] for margins in found["margins"].values()) > 0.52  # 30 degrees


@pytest.mark.slow
def test_typed_answers_and_those_of_a_file_give_the_same_machine(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "answers.toml").write_text(ANSWERS, encoding="utf-8")
    typed = contourlab("new", "machine", "--out", "typed/mill", typed=TYPED)
    asked = contourlab("new", "machine", "--out", "asked/mill", "--answers", "answers.toml")
    assert (typed.code, asked.code, asked.err) == (0, 0, "")
    by_hand, by_file = (contents(tmp_path / folder / "mill") for folder in ("typed", "asked"))
    assert by_hand.pop("answers.toml") != by_file.pop("answers.toml")  # they keep the words
    assert by_hand == by_file
    assert typed.out.replace("typed", "asked") == asked.out


@pytest.mark.slow
def test_a_new_machine_overwrites_nothing_unasked(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "answers.toml").write_text(ANSWERS, encoding="utf-8")
    (tmp_path / "mill").mkdir()
    (tmp_path / "mill" / "axis-x.toml").write_text("mine", encoding="utf-8")
    words = ["new", "machine", "--out", "mill", "--answers", "answers.toml"]
    said = contourlab(*words).refusal
    assert "axis-x.toml" in said
    assert "--force" in said
    assert contents(tmp_path / "mill").keys() == {"axis-x.toml"}
    assert contourlab(*words, "--force").code == 0
    assert len(contents(tmp_path / "mill")) == 6


def test_a_new_machine_does_not_write_over_its_answers(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "controller.toml").write_text(ANSWERS, encoding="utf-8")
    said = contourlab("new", "machine", "--out", ".", "--answers", "controller.toml", "--force").refusal
    assert "controller.toml" in said and said.count("\n") == 1
    assert (tmp_path / "controller.toml").read_text(encoding="utf-8") == ANSWERS
    assert len(contents(tmp_path)) == 1


SLOW = pytest.mark.slow


@pytest.mark.parametrize(
    ("before", "after", "key"),
    [
        ('"20 kg"', '"-20 kg"', "x.moved_mass"),
        pytest.param('"20 kg"', '"20 mm"', "x.moved_mass", marks=SLOW),
        pytest.param('"20 kg"', "nan", "x.moved_mass", marks=SLOW),
        pytest.param('moved_mass = "20 kg"', 'moved_mass = "20 kg"\npeak_torque = 0.1', "x.peak_torque", marks=SLOW),
        ("lead =", "leed =", "y.leed"),
        pytest.param("x on y", "x on z", "mounting", marks=SLOW),
    ],
)
def test_impossible_answers_are_one_line(contourlab: Run, tmp_path: Path, before: str, after: str, key: str) -> None:
    assert before in ANSWERS
    (tmp_path / "answers.toml").write_text(ANSWERS.replace(before, after, 1), encoding="utf-8")
    said = contourlab("new", "machine", "--out", "mill", "--answers", "answers.toml").refusal
    assert said.startswith(f"contourlab: answers.toml: {key}: ")
    assert said.count("\n") == 1
    assert not (tmp_path / "mill").exists()


def test_answers_that_end_early_are_2_and_write_nothing(contourlab: Run, tmp_path: Path) -> None:
    said = contourlab("new", "machine", "--out", "mill", typed="\n".join(TYPED.splitlines()[:8])).refusal
    assert "standard input: x.lead: " in said.splitlines()[-1]
    assert not any(tmp_path.iterdir())


def test_the_papers_integrals_are_reproduced_by_name(reproduction: tuple[int, str, str]) -> None:
    """Fig 9 of Ghaffari & Ulsoy: 18.37 and 18.46 um s, within 3 % of each other under one controller."""
    code, out, err = reproduction
    assert (code, err) == (0, "")
    rows = json.loads(out)
    keys = {"name", "case", "paper", "here", "unit", "tolerance", "pass", "note"}
    keys |= {"source", "verdict", "kind", "reading", "main", "limit", "band", "missing"}
    assert all(set(row) == keys for row in rows)
    found = {row["name"]: row for row in rows if row["name"] in ("contour error integral A3-A1", "contour error integral A3-A2")}
    assert [row["paper"] for row in found.values()] == [18.37, 18.46]
    first, second = (row["here"] for row in found.values())
    assert (first, second) == (pytest.approx(18.31, abs=0.05), pytest.approx(18.54, abs=0.05))
    assert second == pytest.approx(first, rel=0.03)
    for row in rows:
        if row["pass"] is not None:
            assert row["pass"] == (abs(row["here"] - row["paper"]) <= row["tolerance"])
