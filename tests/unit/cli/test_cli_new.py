"""`contourlab new machine`: answers, typed or from a file, become files that run."""

import io
import tomllib

import pytest
from reference_data import reference_file

from contourlab.cli.main import main
from contourlab.scenario import load_machine

ANSWERS = """
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
TYPED = [
    *("x, y", "", "x on y", "", "1.3", "0.5", "0.6", "", "20 kg", "", "", "", "", ""),
    *("no", "", "2400 mNm", "500 mNm/A", "1.2", "0.5 cm", "40", "", "", "", "", "", ""),
]
"""The same answers in other words, as typed; an empty line takes the default."""


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


def machine_files(folder):
    """Return the files but for the answers, which keep their words."""
    return {name: content for name, content in read_all(folder).items() if name != "answers.toml"}


def test_answers_in_a_file_make_a_valid_machine(answers, tmp_path, capsys):
    out = tmp_path / "mill"
    assert main(["new", "machine", "--answers", str(answers), "--out", str(out)]) == 0
    shown = capsys.readouterr().out
    made = read_all(out)
    assert made["machine.toml"]["machine"]["name"] == "mill"
    assert made["machine.toml"]["axes"]["x"]["mounted_on"] == "y"
    assert made["axis-y.toml"]["plant"]["lead"] == {"value": "5 mm", "source": "datasheet", "from": "as given"}
    guess = made["axis-x.toml"]["plant"]["lead"]
    assert (guess["value"], guess["source"], guess["range"]) == ("10 mm", "assumed", ["5 mm", "15 mm"])
    assert {made["axis-x.toml"]["friction"][name]["source"] for name in ("coulomb", "breakaway", "stribeck_velocity")} == {"assumed"}
    controller = made["controller.toml"]["controller"]
    assert set(controller) == {"axes"}  # no coupling
    assert set(controller["axes"]["x"]) == {"velocity", "controller"}  # no observer
    assert controller["axes"]["x"]["controller"]["kind"] == "cascade"
    for name in made:
        assert str(out / name) in shown
    assert main(["run", str(out), "--check"]) == 0


def test_the_folder_of_a_machine_stands_for_its_files(answers, tmp_path, capsys):
    out = tmp_path / "mill"
    assert main(["new", "machine", "--answers", str(answers), "--out", str(out)]) == 0
    (tmp_path / "part.ngc").write_text("G21 G1 X5 F600\nM2\n", encoding="utf-8")
    part = ["run", str(tmp_path / "part.ngc"), "--machine", str(out), "--check"]
    assert main(part) == 0
    assert main([*part, "--controller", str(tmp_path / "none.toml")]) == 2


@pytest.mark.parametrize("preset", ["router", "mill", "stage"])
def test_a_preset_asks_nothing_and_runs(preset, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("sys.stdin", None)
    out = tmp_path / preset
    assert main(["new", "machine", "--preset", preset, "--out", str(out)]) == 0
    assert capsys.readouterr().err == ""
    assert main(["run", str(out), "--check"]) == 0


def test_a_template_is_printed_and_nothing_written(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["new", "machine", "--template"]) == 0
    assert tomllib.loads(capsys.readouterr().out)["x"]["rated_torque"] == ""
    assert main(["new", "machine", "--template", "--preset", "stage"]) == 0
    assert tomllib.loads(capsys.readouterr().out)["x"]["drive"] == "linear"
    assert not any(tmp_path.iterdir())


@pytest.mark.parametrize("words", [["--preset", "lathe"], ["--preset", "mill", "--answers", "a.toml"], ["--out", "mill.toml"]])
def test_impossible_options_are_refused_before_any_question(words, monkeypatch, capsys):
    monkeypatch.setattr("sys.stdin", None)
    assert main(["new", "machine", *words]) == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_typed_answers_make_the_same_files(answers, tmp_path, monkeypatch, capsys):
    assert main(["new", "machine", "--answers", str(answers), "--out", str(tmp_path / "file" / "mill")]) == 0
    monkeypatch.setattr("sys.stdin", io.StringIO("\n".join(TYPED) + "\n"))
    assert main(["new", "machine", "--out", str(tmp_path / "typed" / "mill")]) == 0
    assert machine_files(tmp_path / "typed" / "mill") == machine_files(tmp_path / "file" / "mill")
    shown = capsys.readouterr()
    assert "Rated torque" in shown.err
    assert "Rated torque" not in shown.out


def test_invalid_answers_are_explained_and_asked_again(tmp_path, monkeypatch, capsys):
    wrong_first = ["x, x", *TYPED[:4], "much", *TYPED[4:], ""]
    monkeypatch.setattr("sys.stdin", Terminal("\n".join(wrong_first) + "\n"))
    assert main(["new", "machine", "--out", str(tmp_path / "mill")]) == 0
    shown = capsys.readouterr().err
    assert "'x'" in shown
    assert "much" in shown
    assert "machine.toml" in read_all(tmp_path / "mill")


@pytest.mark.parametrize(
    ("stdin", "code", "said"),
    [
        (io.StringIO("x, y\n"), 2, "servo_period: the input ends"),
        (io.StringIO("x, x\n"), 2, "axis 'x' is given twice"),
        (Terminal("x, y\n"), 130, "interrupted"),
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
        (ANSWERS.replace("lead =", "led ="), "y.led: no question"),
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


def test_answers_typed_before_there_was_a_question_name_it(tmp_path, monkeypatch, capsys):
    """A file of answers that ends early is refused with the question it lacks; with the rest the machine is made."""
    file = reference_file("repro/trial3/ans.txt")
    lines = file.read_text(encoding="utf-8").splitlines()
    for more, key in (([], "z.unbalanced_mass"), (["6"], "travel")):
        monkeypatch.setattr("sys.stdin", io.StringIO("\n".join([*lines, *more]) + "\n"))
        assert main(["new", "machine", "--out", str(tmp_path / "t")]) == 2
        assert f"standard input: {key}: " in capsys.readouterr().err
    monkeypatch.setattr("sys.stdin", io.StringIO("\n".join([*lines, "6", "750, 750, 120"]) + "\n"))  # backlash was no question
    assert main(["new", "machine", "--out", str(tmp_path / "t")]) == 0
    machine = load_machine(tmp_path / "t" / "machine.toml")
    assert [axis.limits.extent for axis in machine.axes] == [0.75, 0.75, 0.12]
    assert "backlash" in capsys.readouterr().err and not any(axis.error.backlash for axis in machine.axes)
    assert all(20.0 < axis.friction.values()["coulomb"] < 100.0 for axis in machine.axes)  # a tenth of its motor's force is 249 N
