"""What a user must not lose or be misled by: old results, names, travel, interrupts at any moment."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from typed_commands import CIRCLE, COMMAND, DRAG, ON_XYZ, PART, POSIX, Run, contents, environment

from contourlab.app.results import LIST, check_file


def test_a_program_beyond_the_travel_of_an_axis_is_2(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "far.ngc").write_text("G21 G90\nG0 X100\nG1 X151 F6000\nM2\n", encoding="utf-8")
    said = contourlab("run", "far.ngc", *ON_XYZ, "--out", "results").refusal
    assert re.search(r"far\.ngc:3: axis x .*151 mm.*-150 (mm )?to 150 mm", said)
    assert not (tmp_path / "results").exists()


def test_a_contour_beyond_the_travel_of_an_axis_is_2(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "far.toml").write_text(CIRCLE.replace("20 mm", "60 mm").replace("0.5 Hz", "0.1 Hz"), encoding="utf-8")
    said = contourlab("run", "far.toml", "--out", "results").refusal  # axis 3 has 50 mm each way
    assert "axis 3" in said


@POSIX
@pytest.mark.slow
def test_a_disk_that_fills_up_late_keeps_the_old_results(contourlab: Run, old_results: Path, tmp_path: Path) -> None:
    import resource

    (tmp_path / "other.toml").write_text(CIRCLE.replace("0.5 Hz", "1 Hz").replace("laps = 2", "laps = 1"), encoding="utf-8")
    before, full = contents(old_results), 400_000  # room for the signals
    said = contourlab("run", "other.toml", "--out", "results", before=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (full, full)))
    assert said.code == 2
    assert "report.html: " in said.err and said.err.count("\n") == 1
    assert contents(old_results) == before


@POSIX
@pytest.mark.slow
def test_an_interrupt_while_results_are_written_keeps_the_old_ones(old_results: Path, tmp_path: Path) -> None:
    (tmp_path / "other.toml").write_text(CIRCLE.replace("20 mm", "19 mm"), encoding="utf-8")
    before = contents(old_results)
    process = subprocess.Popen([COMMAND, "run", "other.toml", "--out", "results"], cwd=tmp_path, stderr=subprocess.PIPE, env=environment())
    try:
        # The first file of the new results has appeared, in its temporary place.
        while not [name for _, _, files in os.walk(old_results) for name in files if name == "base.nc"]:
            time.sleep(0.002)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
    finally:
        process.kill()
    assert (process.returncode, err) == (130, b"contourlab: interrupted: no result is kept\n")
    assert contents(old_results) == before


@POSIX
@pytest.mark.parametrize("renames", [0, 4, 8])  # each one: tests/unit/app/test_results.py
@pytest.mark.slow
def test_what_a_killed_run_left_is_undone_by_the_next(old_results: Path, tmp_path: Path, renames: int) -> None:
    (tmp_path / "other.toml").write_text(CIRCLE.replace("20 mm", "19 mm"), encoding="utf-8")
    before = contents(old_results)
    # The process ends at once at a rename: of a finished file in the temporary folder, of an older result, or of a new one.
    script = (
        "import os, pathlib, sys\nfrom contourlab.cli.main import main\nplain, left = pathlib.Path.replace, [int(sys.argv.pop(1))]\n"
        "def replace(self, target):\n    left[0] -= '.contourlab-' in f'{self}{target}'\n    if left[0] < 0: os._exit(9)\n"
        "    return plain(self, target)\npathlib.Path.replace = replace\nsys.exit(main())"
    )
    words = [sys.executable, "-c", script, str(renames), "run", "other.toml", "--out", "results"]
    assert subprocess.run(words, cwd=tmp_path, env=environment(), check=False).returncode == 9
    assert list(old_results.glob(".contourlab-*"))
    check_file(old_results / "any.txt")
    assert contents(old_results) == before


def test_the_journal_of_an_exchange_cannot_move_other_files(tmp_path: Path) -> None:
    stage, other = tmp_path / "results" / ".contourlab-x", tmp_path / "mine.txt"
    stage.mkdir(parents=True)
    (stage / "held").touch()
    (stage / "previous-0").write_text("foreign", encoding="utf-8")
    (stage / "exchange.json").write_text(json.dumps({"away": ["../mine.txt"], "new": [], "list": None}), encoding="utf-8")
    check_file(tmp_path / "results" / "any.txt")
    assert not stage.exists() and not other.exists()


def test_an_empty_argument_is_2(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "circle.toml").write_text(CIRCLE, encoding="utf-8")
    assert contourlab("run", "circle.toml", "--out", "").code == 2
    assert not (tmp_path / "report.html").exists()


def test_older_results_are_replaced_whole_and_other_files_are_left_alone(contourlab: Run, old_results: Path, tmp_path: Path) -> None:
    (tmp_path / "other.toml").write_text(CIRCLE.replace("20 mm", "19 mm"), encoding="utf-8")
    (old_results / "notes.txt").write_text("of the user", encoding="utf-8")
    (old_results / "signals" / "bench.nc").write_text("of the user", encoding="utf-8")
    assert (old_results / "signals" / "all-of-it.nc").exists()
    assert contourlab("run", "other.toml", "--out", "results").code == 0
    assert set(contents(old_results)) == {LIST, "report.html", "summary.json", "signals/base.nc", "signals/bench.nc", "notes.txt"}


def test_a_scheme_that_runs_away_takes_nothing_from_the_others(contourlab: Run, tmp_path: Path) -> None:
    wild = '[schemes.wild]\naxes.3.drive.limit = "1e6 full_scale"\ncontroller.axes.3.controller.position_gain = "4000 full_scale/mm"\n'
    (tmp_path / "circle.toml").write_text(CIRCLE + wild + "[schemes.tame]\n", encoding="utf-8")
    said = contourlab("run", "circle.toml", "--out", "results")
    assert said.code == 3
    assert re.fullmatch(r"contourlab: wild: .*\(axis \S+, sample \d+, t = \S+ s\)\n", said.err)
    assert "tame: PASS" in said.out
    summary = json.loads((tmp_path / "results" / "summary.json").read_text(encoding="utf-8"))
    assert summary["passed"] is False
    assert summary["schemes"]["wild"].keys() == {"status"} and summary["schemes"]["wild"]["status"]["ok"] is False
    assert summary["schemes"]["tame"]["verdict"]["passed"] is True
    assert {name for name in contents(tmp_path / "results") if name.startswith("signals/")} == {"signals/tame.nc"}


def test_a_failed_run_leaves_no_empty_folder(contourlab: Run, tmp_path: Path) -> None:
    wild = '\n[schemes.wild]\naxes.3.drive.limit = "1e6 full_scale"\ncontroller.axes.3.controller.position_gain = "4000 full_scale/mm"\n'
    (tmp_path / "wild.toml").write_text(CIRCLE + wild, encoding="utf-8")
    said = contourlab("run", "wild.toml", "--out", "results/below")
    assert said.code == 3
    assert said.err.startswith("contourlab: wild: ")  # the scheme that failed
    assert not (tmp_path / "results").exists()


def test_schemes_whose_names_look_alike_have_a_file_each(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "c.toml").write_text(CIRCLE + '[schemes."a b"]\n[schemes."a-b"]\n[schemes."A-b"]\n', encoding="utf-8")
    assert contourlab("run", "c.toml", "--out", "results").code == 0
    assert len({name.casefold() for name in contents(tmp_path / "results") if name.startswith("signals/")}) == 3


@pytest.mark.parametrize("words", [["--plots", "gif"], ["--signals", "positon"]])
def test_a_wrong_choice_is_found_before_the_run(contourlab: Run, tmp_path: Path, words: list[str]) -> None:
    (tmp_path / "circle.toml").write_text(CIRCLE, encoding="utf-8")
    said = contourlab("run", "circle.toml", "--out", "results", *words).refusal
    assert words[0] in said
    assert words[1] in said
    assert not (tmp_path / "results").exists()


@POSIX
def test_an_interrupt_at_the_start_shows_no_traceback(tmp_path: Path) -> None:
    """During imports: Python lists the modules, and the interrupt comes at the first one of the command line, or a little later."""
    words = [sys.executable, "-X", "importtime", "-m", "contourlab", "run", "builtin:demo-part"]
    with subprocess.Popen(words, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment(), text=True) as process:
        assert process.stderr
        said = []
        for line in process.stderr:
            said.append(line)
            if "argparse" in line or "typer" in line or "click" in line:
                process.send_signal(signal.SIGINT)
                break
        said += process.stderr.readlines()
    assert process.returncode == 130
    assert said[-1] == "contourlab: interrupted: no result is kept\n"
    assert "Traceback" not in "".join(said)


def test_the_package_can_be_run_as_a_module(tmp_path: Path) -> None:
    done = subprocess.run([sys.executable, "-m", "contourlab", "--version"], cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("contourlab ")


@pytest.mark.parametrize(("chosen", "threads"), [({}, "1"), ({"OPENBLAS_NUM_THREADS": "3"}, "3")])
def test_linear_algebra_has_one_thread_unless_the_user_says_otherwise(chosen: dict[str, str], threads: str) -> None:
    """NumPy reads the setting once, so it is set before NumPy loads."""
    text = """
import os, sys
from contourlab.__main__ import run
assert "numpy" not in sys.modules
sys.argv = ["contourlab", "--version"]
try:
    run()
except SystemExit as left:
    print(left.code, os.environ["OPENBLAS_NUM_THREADS"])
"""
    bare = {name: value for name, value in environment().items() if name != "OPENBLAS_NUM_THREADS"}
    done = subprocess.run([sys.executable, "-c", text], env={**bare, **chosen}, capture_output=True, encoding="utf-8", timeout=60)
    assert done.stdout.splitlines()[-1:] == [f"0 {threads}"], done.stderr


@pytest.mark.skipif(sys.platform != "linux", reason="file names of any bytes")
@pytest.mark.slow
def test_file_names_need_not_be_utf8(tmp_path: Path) -> None:
    (tmp_path / os.fsdecode(b"c\xe9.toml")).write_text(CIRCLE.split("\n", 1)[1], encoding="utf-8")
    words = [os.fsencode(COMMAND), b"run", b"c\xe9.toml", b"--out", b"r\xe9"]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, env=environment(), timeout=60)
    assert (done.returncode, done.stderr) == (0, b"")
    assert json.loads((tmp_path / os.fsdecode(b"r\xe9") / "summary.json").read_text(encoding="utf-8"))["name"] == "c?"


def test_the_name_of_a_program_may_be_long(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / f"{'a' * 240}.ngc").write_text(PART, encoding="utf-8")
    assert contourlab("run", f"{'a' * 240}.ngc", *ON_XYZ, "--check").code == 0


@pytest.mark.parametrize("name", ["none.ngc", "empty.ngc"])
def test_a_program_named_on_the_command_line_is_named_first(contourlab: Run, tmp_path: Path, name: str) -> None:
    (tmp_path / "empty.ngc").write_text("", encoding="utf-8")
    assert contourlab("run", name, *ON_XYZ).err.startswith(f"contourlab: {name}: ")


MUTE = "type('Mute', (BaseException,), {'__str__': lambda self: exec('raise SystemExit')})()"


@pytest.mark.parametrize("error", ["SystemExit(0)", "type('Odd', (BaseException,), {})('boo')", MUTE])
def test_a_plugin_that_exits_is_a_fault_of_the_plugin(contourlab: Run, tmp_path: Path, error: str) -> None:
    (tmp_path / "leaves.py").write_text(f"raise {error}\n", encoding="utf-8")
    said = contourlab("components", "--plugin", "leaves.py")
    assert said.code == 2
    assert said.err.startswith("contourlab: leaves.py:1: ") and said.err.count("\n") == 1


@pytest.mark.parametrize("force", ["math.nan", "par.coeficient * v", "par.coefficient * v"])
def test_the_components_of_a_plugin_are_checked(contourlab: Run, tmp_path: Path, force: str) -> None:
    good = force == "par.coefficient * v"
    (tmp_path / "drag.py").write_text("import math\n" + DRAG.replace("par.coefficient * v", force), encoding="utf-8")
    said = contourlab("components", "--plugin", "drag.py", "open-drag")
    assert said.code == (0 if good else 2)
    assert good or re.fullmatch(r"contourlab: drag\.py:\d+: Drag: .+\n", said.err)


def test_the_recorded_command_can_be_typed_again(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "drag.py").write_text(DRAG, encoding="utf-8")
    (tmp_path / "part.ngc").write_text(PART, encoding="utf-8")
    said = contourlab("run", "part.ngc", *ON_XYZ, "--plugin", "drag.py", "--out", "results", "--json")
    assert "--plugin drag.py" in json.loads(said.out)["command"]


def test_an_unknown_file_ending_is_refused(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "circle.txt").write_text(CIRCLE, encoding="utf-8")
    said = contourlab("run", "circle.txt")
    assert said.code == 2
    assert ".toml" in said.err  # the message names the missing ending
