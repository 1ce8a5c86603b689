"""`contourlab new machine`: answers, typed or from a file, become files that run."""

import io
import tomllib

import pytest

from contourlab.cli.main import main
from contourlab.features.machines.new_machine import questions

ANSWERS = """
name = "Bench mill"
axes = ["x", "y"]
[x]
rated_torque = "1.3 N*m"
peak_torque = 3.9
torque_constant = "0.5 N*m/A"
rotor_inertia = "0.6 kg*cm^2"
moved_mass = "20 kg"
mounted_on = "y"
[y]
rated_torque = "2.4 N*m"
peak_torque = 7.2
torque_constant = 0.5
rotor_inertia = 1.2
moved_mass = 40
lead = "5 mm"
"""
OTHER_WORDS = {"y.peak_torque": "7200 mN*m", "y.lead": "0.5 cm", "x.peak_torque": " 3.9 "}
"""Equivalent answers in other words."""


def typed() -> list[str]:
    """Return the answers of the file as typed; an empty line takes the default."""
    given = tomllib.loads(ANSWERS)
    flat = {f"{axis}.{key}": str(value) for axis in "xy" for key, value in given[axis].items()} | OTHER_WORDS
    return [given["name"], "", "", *(flat.get(question.key, "") for question in questions(["x", "y"]))]


class Terminal(io.StringIO):
    """Standard input that claims to be a terminal."""

    def isatty(self) -> bool:
        return True


@pytest.fixture
def answers(tmp_path):
    file = tmp_path / "answers.toml"
    file.write_text(ANSWERS, encoding="utf-8")
    return file


def read_all(folder):
    return {file.name: tomllib.loads(file.read_text(encoding="utf-8")) for file in sorted(folder.iterdir())}


def test_answers_in_a_file_make_a_valid_machine(answers, tmp_path, capsys):
    out = tmp_path / "mill"
    assert main(["new", "machine", "--answers", str(answers), "--out", str(out)]) == 0
    shown = capsys.readouterr().out
    made = read_all(out)
    assert made["machine.toml"]["machine"]["name"] == "Bench mill"
    assert made["machine.toml"]["axes"]["x"]["mounted_on"] == "y"
    assert made["axis-y.toml"]["plant"]["lead"] == {"value": "5 mm", "source": "datasheet", "from": "as given"}
    assert made["axis-x.toml"]["plant"]["lead"] == {"value": "10 mm", "source": "assumed", "note": "default of the question"}
    assert {made["axis-x.toml"]["friction"][name]["source"] for name in ("coulomb", "breakaway", "stribeck_velocity")} == {"assumed"}
    assert made["controller.toml"]["controller"]["axes"]["x"]["observer"]["model_gain"]["source"] == "design"
    for name in made:
        assert str(out / name) in shown
    assert main(["run", str(out / "scenario.toml"), "--check"]) == 0


def test_typed_answers_make_the_same_files(answers, tmp_path, monkeypatch, capsys):
    assert main(["new", "machine", "--answers", str(answers), "--out", str(tmp_path / "file")]) == 0
    monkeypatch.setattr("sys.stdin", io.StringIO("\n".join(typed()) + "\n"))
    assert main(["new", "machine", "--out", str(tmp_path / "typed")]) == 0
    assert read_all(tmp_path / "typed") == read_all(tmp_path / "file")
    shown = capsys.readouterr()
    assert "Rated torque" in shown.err
    assert "Rated torque" not in shown.out


def test_invalid_answers_are_explained_and_asked_again(tmp_path, monkeypatch, capsys):
    right = typed()
    wrong_first = [right[0], "x, x", *right[1:3], "much", *right[3:]]
    monkeypatch.setattr("sys.stdin", Terminal("\n".join(wrong_first) + "\n"))
    assert main(["new", "machine", "--out", str(tmp_path / "mill")]) == 0
    shown = capsys.readouterr().err
    assert "'x'" in shown
    assert "much" in shown
    assert "machine.toml" in read_all(tmp_path / "mill")


@pytest.mark.parametrize(
    ("stdin", "code", "said"),
    [
        (io.StringIO("Mill\nx, y\n"), 2, "servo_period: the input ends"),
        (io.StringIO("Mill\nx, x\n"), 2, "axis 'x' is given twice"),
        (Terminal("Mill\n"), 130, "interrupted"),
    ],
)
def test_missing_or_wrong_answers_leave_no_files(stdin, code, said, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("sys.stdin", stdin)
    assert main(["new", "machine", "--out", str(tmp_path / "mill")]) == code
    assert said in capsys.readouterr().err
    assert not (tmp_path / "mill").exists()


def test_files_are_overwritten_only_on_request(answers, tmp_path, capsys):
    out = tmp_path / "mill"
    command = ["new", "machine", "--answers", str(answers), "--out", str(out)]
    assert main(command) == 0
    (out / "machine.toml").write_text("mine", encoding="utf-8")
    assert main(command) == 2
    assert "--force" in capsys.readouterr().err
    assert (out / "machine.toml").read_text(encoding="utf-8") == "mine"
    assert main([*command, "--force"]) == 0
    assert (out / "machine.toml").read_text(encoding="utf-8") != "mine"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("axes = [", "is not valid TOML"),
        ("axes = [1, 2]", "axes: [1, 2] is not an answer"),
        ("[x.deep]\nlead = 1", "x.deep: {'lead': 1} is not an answer"),
        ("[x]\nlead = true", "x.lead: True is not an answer"),
        (ANSWERS.replace("moved_mass = 40", "moved_mass = -40"), "y.moved_mass"),
        (ANSWERS.replace("lead =", "led ="), "y.led: no such question"),
    ],
)
def test_an_error_in_the_answers_names_file_and_key(text, said, tmp_path, capsys):
    file = tmp_path / "wrong.toml"
    file.write_text(text, encoding="utf-8")
    assert main(["new", "machine", "--answers", str(file), "--out", str(tmp_path / "mill")]) == 2
    shown = capsys.readouterr().err
    assert f"{file}: " in shown
    assert said in shown
    assert not (tmp_path / "mill").exists()


def test_a_missing_file_of_answers_exits_with_2(tmp_path, capsys):
    assert main(["new", "machine", "--answers", str(tmp_path / "none.toml"), "--out", str(tmp_path)]) == 2
    assert "none.toml: " in capsys.readouterr().err
