"""The shell around the commands: exit codes, messages and output streams."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from contourlab import __version__
from contourlab.app.json_values import json_values
from contourlab.cli.main import main
from contourlab.components import registry
from contourlab.errors import DivergenceError, OutputError, ParameterError

LAUNCH = [sys.executable, "-c", "from contourlab.__main__ import run; run()"]


def fail_with(monkeypatch: pytest.MonkeyPatch, error: BaseException) -> None:
    """Let `contourlab components` raise an error."""

    def components(family: str | None = None) -> None:
        raise error

    monkeypatch.setattr(registry, "components", components)


def test_an_error_without_a_readable_text_is_internal(monkeypatch, capsys):
    class Mute(BaseException):
        def __str__(self):
            raise SystemExit(0)

    fail_with(monkeypatch, Mute())
    assert main(["components"]) == 70
    assert "Mute" in capsys.readouterr().err


def test_the_version_is_printed(capsys):
    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"contourlab {__version__}\n"


def test_no_arguments_show_the_commands(capsys):
    assert main([]) == 0
    shown = capsys.readouterr().out
    for command in ("demo", "run", "reproduce", "components", "new"):
        assert command in shown


@pytest.mark.parametrize("command", ["demo", "run", "reproduce ghaffari", "components", "new machine"])
def test_each_command_has_a_help_text(command, capsys):
    assert main([*command.split(), "--help"]) == 0
    assert f"contourlab {command}" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "said", "place"),
    [
        (["--nonsense"], "--nonsense", "contourlab --help"),
        (["run"], "SCENARIO", "contourlab run --help"),
        (["componets"], "'components'", "contourlab --help"),
        (["components", "--jsn"], "--json", "contourlab components --help"),
        (["new", "house"], "house", "contourlab new --help"),
    ],
)
def test_wrong_usage_is_two_lines_and_2(arguments, said, place, capsys):
    assert main(arguments) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    message, hint = shown.err.splitlines()
    assert message.startswith("contourlab: ")
    assert said in message
    assert place in hint


def test_an_error_is_one_message_without_traceback(capsys):
    assert main(["components", "anvil"]) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert "anvil" in shown.err
    assert "plant, " in shown.err
    assert "Traceback" not in shown.err


@pytest.mark.parametrize("arguments", [["--debug", "components", "anvil"], ["components", "anvil", "--debug"]])
def test_debug_shows_the_traceback(arguments, capsys):
    assert main(arguments) == 2
    shown = capsys.readouterr().err
    assert "Traceback" in shown
    assert "ComponentError" in shown


def test_debug_after_two_dashes_is_an_argument(capsys):
    assert main(["components", "--", "--debug"]) == 2
    assert "'--debug'" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("error", "code", "said"),
    [
        (OutputError("results: cannot be written"), 2, "contourlab: results: cannot be written"),
        (DivergenceError("ran away", sample=7, time=0.007, axis="y"), 3, "axis y, sample 7"),
        (PermissionError(13, "Permission denied", "results/report.html"), 2, "results/report.html: Permission denied"),
        (KeyboardInterrupt(), 130, "contourlab: interrupted"),
        (ZeroDivisionError("division by zero"), 70, "internal error: ZeroDivisionError: division by zero"),
    ],
)
def test_every_kind_of_failure_has_its_exit_code(error, code, said, monkeypatch, capsys):
    fail_with(monkeypatch, error)
    assert main(["components"]) == code
    shown = capsys.readouterr()
    assert shown.out == ""
    assert said in shown.err
    assert "Traceback" not in shown.err


def test_a_parameter_is_named_as_it_was_typed(monkeypatch, capsys):
    for words in (["--gain-margin", "-5"], ["--gain-margin=-5"]):
        assert main(["tune", "builtin:ghaffari/demo-stage", *words]) == 2
        assert re.fullmatch(r"contourlab: --gain-margin = -5 dB: .*\b0 to 60 dB\n", capsys.readouterr().err)
    fail_with(monkeypatch, ParameterError("gain_margin", "-5", "0 to 60", "dB"))
    assert main(["components"]) == 2
    assert re.fullmatch(r"contourlab: gain_margin = -5 dB: .*\b0 to 60 dB\n", capsys.readouterr().err)


def test_an_interrupted_command_names_what_it_kept(monkeypatch, capsys):
    error = KeyboardInterrupt()
    error.add_note("kept: results/baseline.nc")
    fail_with(monkeypatch, error)
    assert main(["components"]) == 130
    assert capsys.readouterr().err == "contourlab: interrupted\nkept: results/baseline.nc\n"


@pytest.mark.skipif(os.name == "nt", reason="pipes close differently on Windows")
@pytest.mark.parametrize("arguments", [["components", "--json"], ["components"]])
@pytest.mark.slow
def test_a_closed_pipe_is_no_error(arguments):
    reading, writing = os.pipe()
    os.close(reading)
    done = subprocess.run([*LAUNCH, *arguments], stdout=writing, stderr=subprocess.PIPE, text=True, timeout=60)
    os.close(writing)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
@pytest.mark.parametrize("arguments", [["components", "--json"], ["--version"], ["--help"]])
def test_output_that_cannot_be_written_is_2(arguments):
    with open("/dev/full", "w") as full:  # noqa: PTH123
        done = subprocess.run([*LAUNCH, *arguments], stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
    assert done.returncode == 2
    assert done.stderr.startswith("contourlab: standard output: ") and done.stderr.count("\n") == 1


@pytest.mark.slow
def test_a_terminal_without_greek_letters_is_no_error():
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    done = subprocess.run([*LAUNCH, "components"], capture_output=True, env=environment, timeout=60)
    assert (done.returncode, done.stderr) == (0, b"")
    assert b"rigid-axis" in done.stdout


def test_values_without_a_json_form_become_null_or_are_refused():
    np = pytest.importorskip("numpy")
    given = {"a": float("nan"), "b": np.array([1.0, np.inf]), "c": (np.float64(2.0), np.int64(3), True), "d": Path("x"), "e": None}
    clean = json_values(given)
    assert clean == {"a": None, "b": [1.0, None], "c": [2.0, 3, True], "d": "x", "e": None}
    assert json.loads(json.dumps(clean, allow_nan=False)) == clean
    with pytest.raises(TypeError, match="object"):
        json_values({"f": object()})
