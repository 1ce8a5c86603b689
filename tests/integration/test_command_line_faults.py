"""Mistakes of a user: one line that says where, what, and what would be right; exit code 2; nothing written."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from typed_commands import CIRCLE, ON_XYZ, PART, Run, contents

from contourlab.app.results import LIST, staged

RUBBISH = bytes(range(128, 256)) * 8

SCENARIOS = {
    "malformed": (CIRCLE.replace('name = "circle"', "name = [,,", 1), r"bad\.toml: .*line 1, column 9"),
    "unknown key": (CIRCLE.replace("radius", "radios"), r"bad\.toml: contour\.radios: .*did you mean 'radius'\?"),
    "unknown table": (CIRCLE + "[runs]\nseed = 1\n", r"bad\.toml: runs: unknown key.*run"),
    "missing key": (CIRCLE.replace('frequency = "0.5 Hz"\n', ""), r'bad\.toml: feed: key frequency is missing: .*"0\.5 Hz"'),
    "wrong unit": (CIRCLE.replace("20 mm", "20 kg"), r"bad\.toml: contour\.radius: '20 kg' "),
    "no unit": (CIRCLE.replace('"20 mm"', "20"), r'bad\.toml: contour\.radius: 20 .*unit.*mm"'),
    "zero length": (CIRCLE.replace("20 mm", "0 mm"), r"bad\.toml: contour: radius = 0\.0: must be > 0"),
    "nan": (CIRCLE.replace('"20 mm"', "nan"), r"bad\.toml: contour\.radius: nan "),
    "nan in text": (CIRCLE.replace("20 mm", "nan mm"), r"bad\.toml: contour\.radius: 'nan mm' "),
    "negative mass": (
        'controller = "builtin:xyz-controller"\nprogram = "part.ngc"\nmachine = {file = "builtin:xyz"}\n[axes.x]\nplant.mass = "-1 kg"\n',
        r"bad\.toml: axes\.x\.plant\.mass: '-1 kg' .*>=? 0 kg",
    ),
    "unknown component": (
        CIRCLE + '[schemes.a.controller]\ncoupling.kind = "cross-coupling"\n',
        r"bad\.toml: schemes\.a\.controller\.coupling\.kind: .*'cross-coupled'",
    ),
    "unknown part of a scheme": (
        CIRCLE + "[schemes.a]\ncontour.radius = 3\n",
        r"bad\.toml: schemes\.a\.contour: .*controller",
    ),
    "no such machine": (CIRCLE.replace("ghaffari/a3a1", "ghaffari/a3a9"), r"bad\.toml: machine: .*did you mean 'ghaffari/a3a"),
    "no such program": (
        'machine = "builtin:xyz"\ncontroller = "builtin:xyz-controller"\nprogram = "none.ngc"\n',
        r"bad\.toml: program: none\.ngc: ",
    ),
    "binary": (RUBBISH, r"bad\.toml: .*UTF-8"),
    "nothing in it": (b"\n", r"bad\.toml: .*machine, controller"),
}

PROGRAMS = {
    "unknown G-word": ("G21 G90\nG1 X1 F100\nG77 X3\nM2\n", r"bad\.ngc:3:1: G77 "),
    "radii that differ": ("G21 G90\nG0 X0 Y0\nG2 X10 Y0 I4 J0 F100\nM2\n", r"bad\.ngc:3:\d+: .*4 mm .*6 mm"),
    "nan": ("G21 G90\nG1 Xnan F100\nM2\n", r"bad\.ngc:2:4: X "),
    "no feedrate": ("G21 G90\nG1 X1\nM2\n", r"bad\.ngc:2:1: G1 .*F"),
    "no end": ("G21 G90\nG1 X1 F100\n", r"bad\.ngc:2: .*M2 or M30"),
    "empty": ("\n", r"bad\.ngc: .*motion"),
    "no motion": ("G21 G90\nM2\n", r"bad\.ngc: .*motion"),
    "zero length": ("G21 G90\nG1 X0 Y0 F100\nM2\n", r"bad\.ngc: .*motion"),
    "rubbish": (RUBBISH, r"bad\.ngc:1:1: "),
}


def one_line(text: str) -> str:
    """Return the error line on standard error; one line of advice may follow."""
    assert text.startswith("contourlab: ")
    assert text.endswith("\n")
    assert text.count("\n") <= 2, text
    return text.splitlines()[0]


@pytest.mark.parametrize("name", SCENARIOS)
def test_a_wrong_scenario_is_one_line_and_2(contourlab: Run, tmp_path: Path, name: str) -> None:
    content, pattern = SCENARIOS[name]
    (tmp_path / "part.ngc").write_text(PART, encoding="utf-8")
    (tmp_path / "bad.toml").write_bytes(content if isinstance(content, bytes) else content.encode())
    said = contourlab("run", "bad.toml", "--out", "results").refusal
    assert re.search(pattern, one_line(said)), said
    assert sorted(contents(tmp_path)) == ["bad.toml", "part.ngc"]
    assert not (tmp_path / "results").exists()


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_wrong_program_is_one_line_and_2(contourlab: Run, tmp_path: Path, name: str) -> None:
    content, pattern = PROGRAMS[name]
    (tmp_path / "bad.ngc").write_bytes(content if isinstance(content, bytes) else content.encode())
    said = contourlab("run", "bad.ngc", *ON_XYZ, "--out", "results").refusal
    assert re.search(pattern, one_line(said)), said
    assert [path.name for path in tmp_path.iterdir()] == ["bad.ngc"]


WRONG_NAMES = [
    (["none.toml"], r"none\.toml: "),
    (["folder.toml"], r"folder\.toml: "),
    (["folder.ngc", *ON_XYZ], r"folder\.ngc: "),
    (["part.ngc", "--machine", "xyz"], r"part\.ngc: .*--machine and --controller"),
    (["circle.toml", "--machine", "xyz"], r"calibrated\.toml: controller\.axes\.1: "),
    (["part.ngc", "--machine", "xyzz", "--controller", "xyz-controller"], r"machine: .*xyzz.*did you mean 'xyz'"),
    (["circle.toml", "--plugin", "none.py"], r"none\.py: "),
    (["circle.toml", "--plugin", "empty.py"], r"empty\.py: .*component"),
]


@pytest.mark.parametrize(
    ("words", "pattern"),
    [
        (["none.ngc", *ON_XYZ], r"none\.ngc: "),
        (["part.ngc"], r"part\.ngc: .*--machine and --controller"),
        *WRONG_NAMES,
    ],
)
def test_wrong_names_are_one_line_and_2(contourlab: Run, tmp_path: Path, words: list[str], pattern: str) -> None:
    for folder in ("folder.toml", "folder.ngc"):
        (tmp_path / folder).mkdir()
    (tmp_path / "circle.toml").write_text(CIRCLE, encoding="utf-8")
    (tmp_path / "part.ngc").write_text(PART, encoding="utf-8")
    (tmp_path / "empty.py").write_text("import math\n", encoding="utf-8")
    said = contourlab("run", *words, "--out", "results").refusal
    assert re.search(pattern, one_line(said)), said
    assert not (tmp_path / "results").exists()


@pytest.mark.parametrize(
    ("words", "wrong"),
    [
        (["run", "circle.toml", "--outt", "results"], "--outt"),
        (["run"], "SCENARIO|PART"),
        (["run", "circle.toml", "another.toml"], "another.toml"),
        (["runn"], "runn"),
        (["run", "circle.toml", "--out"], "--out"),
        (["demo", "now"], "now"),
    ],
)
def test_wrong_usage_says_where_help_is(contourlab: Run, tmp_path: Path, words: list[str], wrong: str) -> None:
    message, advice = contourlab(*words).refusal.splitlines()
    assert wrong in message
    assert re.fullmatch(r"Try 'contourlab( run| demo)? --help'\.", advice)
    assert not any(tmp_path.iterdir())


@pytest.mark.parametrize("out", ["file/below", *(pytest.param(name, marks=pytest.mark.slow) for name in ("file", "file/below/that"))])
def test_an_invalid_output_folder_is_found_before_the_run(contourlab: Run, tmp_path: Path, out: str) -> None:
    (tmp_path / "circle.toml").write_text(CIRCLE, encoding="utf-8")
    (tmp_path / "file").write_text("the user's", encoding="utf-8")
    assert re.search(rf"{re.escape(str(Path(out)))}: .*--out", one_line(contourlab("run", "circle.toml", "--out", out).refusal))
    assert (tmp_path / "file").read_text(encoding="utf-8") == "the user's"


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self").exists(), reason="no file system here that is read-only for every user")
def test_a_file_system_that_refuses_files_is_2(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "circle.toml").write_text(CIRCLE, encoding="utf-8")
    assert "/proc/self/results: " in one_line(contourlab("run", "circle.toml", "--out", "/proc/self/results").refusal)


@pytest.mark.skipif(os.name == "nt" or not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write anywhere")
def test_a_folder_without_permission_is_2(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "circle.toml").write_text(CIRCLE, encoding="utf-8")
    (tmp_path / "locked").mkdir(mode=0o500)
    said = contourlab("run", "circle.toml", "--out", "locked")
    assert said.code == 2
    assert "locked: " in one_line(said.err)


WILD = """
[schemes.wild]
machine = {file = "builtin:ghaffari/a3a1"}
axes.3.drive.limit = "1e6 full_scale"
axes.3.limits.following_error = "5 mm"
controller.axes.3.controller.position_gain = "4000 full_scale/mm"
"""


@pytest.mark.parametrize("words", [[], pytest.param(["--json"], marks=pytest.mark.slow)])
def test_a_loop_that_runs_away_is_3_and_leaves_the_old_results(contourlab: Run, tmp_path: Path, words: list[str]) -> None:
    (tmp_path / "wild.toml").write_text(CIRCLE + WILD, encoding="utf-8")
    old = tmp_path / "results" / "summary.json"
    with staged(old.parent, "summary.json") as stage:
        (stage / "summary.json").write_text("older", encoding="utf-8")
    said = contourlab("run", "wild.toml", "--out", "results", *words)
    assert said.code == 3 and bool(said.out) == ("--json" in words)
    assert not words or [problem["message"] in one_line(said.err) for problem in json.loads(said.out)["problems"]] == [True]
    found = re.search(r"([\d.]+) mm .*\b5 mm .*axis 3, sample (\d+), t = ([\d.]+) s", one_line(said.err))
    assert found
    gap, sample, time = (float(group) for group in found.groups())
    assert gap > 5.0
    assert time == pytest.approx(sample * 1e-3)
    assert 0 < sample < 100  # it runs away at once
    assert contents(old.parent).keys() == {LIST, "summary.json"}
    assert old.read_text(encoding="utf-8") == "older"


@pytest.mark.parametrize("words", [["run", "--help"], ["machines"]])
@pytest.mark.slow
def test_a_reader_that_closes_early_is_no_fault(words: list[str]) -> None:
    """As in ``contourlab run --help | head``."""
    read, write = os.pipe()
    os.close(read)
    done = subprocess.run([sys.executable, "-m", "contourlab", *words], stdout=write, stderr=subprocess.PIPE, check=False)
    os.close(write)
    assert (done.returncode, done.stderr) == (0, b"")
