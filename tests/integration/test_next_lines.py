"""Each `next:` line, executed as printed: it runs, and it is never refused."""

from __future__ import annotations

import shlex
import shutil
from pathlib import Path

import numpy as np
import pytest
from made_controls import made_control
from reference_data import reference_file
from typed_commands import Run

from contourlab.scenario import builtin_file

STAGE = "builtin:ghaffari/demo-stage"
PART = ("part.ngc", "--machine", "xyz", "--controller", "xyz-controller")
QUICK = [
    ("check", "part.ngc"),
    ("canon", "part.ngc"),
    ("limits", "part.ngc", "--machine", "xyz"),
    ("run", *PART, "--no-interval", "--tolerance", "1 mm"),
    ("components", "coulomb"),
    ("explain", "CL104"),
    ("check", "inch.ngc", "--machine", "m.ini"),
    ("check", "inch.ngc", "--machine", "grbl.txt"),
    ("run", "inch.ngc", "--machine", "m.ini", "--no-require-end", "--tolerance", "1 mm"),
    ("measure", "capture.json", "--axes", "X1,Y1", "--window", "0..1493"),
    ("limits", "bare.csv", "--machine", "m.ini", "--axes", "x,y"),
    ("interpolate", "signals.csv", "--pitch", "20 um", "--resolution", "25 nm"),
]
SLOW = [
    ("run", *PART, "--no-interval"),
    ("analyse", STAGE),
    ("notch", STAGE),
    ("machines",),
    ("circle", "circle.csv", "--unit", "mm"),
    ("circle", "bare.csv", "--machine", "m.ini", "--tolerance", "1 um"),
    ("measure", "bare.csv", "--machine", "m.ini", "--tolerance", "1 um"),
    ("run", *PART, "--no-interval", "--tolerance", "0.5 um"),
    ("compare", STAGE),
    ("tune", STAGE, "--budget", "64"),
    ("sweep", "study.toml", "--yes"),
    ("learn", "builtin:gecer-ulu/contour-simulated", "--trials", "3"),
]
"""Studies whose next step takes minutes are left out."""
SILENT = {"analyse", "canon", "compare", "explain", "measure", "notch", "run"}
"""Commands whose answer may propose nothing."""


@pytest.fixture
def folder(tmp_path: Path, files: Path) -> Path:
    """Return a folder with a part, machines of controls and a log."""
    return Path(shutil.copytree(files, tmp_path, dirs_exist_ok=True))


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The files of that folder; nobody changes them."""
    tmp_path = tmp_path_factory.mktemp("files")
    shutil.copy(builtin_file("programs/circle_diamond_square.ngc"), tmp_path / "part.ngc")
    (tmp_path / "inch.ngc").write_text("G20 G90\nG0 X1 Y1\nG1 X2 F30\nG1 Y2\nG1 X1\n")
    for reader in ("linuxcnc", "grbl"):
        made_control(tmp_path, reader)
    time = 1e-3 * np.arange(8001)
    circle = 50.0 * np.column_stack([np.cos(time), np.sin(time)])
    lagging = 50.0 * np.column_stack([np.cos(time - 0.002), np.sin(time - 0.003)])
    np.savetxt(
        tmp_path / "circle.csv",
        np.column_stack([time, circle, lagging]),
        header="time [s],x cmd,y cmd,x pos,y pos",
        comments="",
        delimiter=",",
    )
    bare = np.column_stack([time, circle / 50.0, np.column_stack([lagging[:, 0] / 50.0, lagging[:, 1] / 49.0])])  # the machine has the unit
    np.savetxt(tmp_path / "bare.csv", bare, header="time [s],reference.x,reference.y,position.x,position.y", comments="", delimiter=",")
    np.savetxt(tmp_path / "signals.csv", np.column_stack([np.cos(10.0 * time), 1.05 * np.sin(10.0 * time)]), delimiter=",")
    (tmp_path / "study.toml").write_text(
        f'scenario = "{STAGE}"\nvariants = 4\n[vary]\n"axes.*.friction.coulomb" = {{ values = ["50 %", "150 %"] }}\n'
    )
    return tmp_path


def follow(contourlab: Run, folder: Path, words: tuple[str, ...]) -> list[list[str]]:
    """Run a command, what it proposes and what that proposes; return what was run."""
    if words[1:2] == ("capture.json",):
        (folder / "capture.json").symlink_to(reference_file("data", "sinumerik", "capture-840d.json"))
    proposed: list[list[str]] = []
    typed = list(words)
    for _ in range(3):
        said = contourlab(*typed)
        assert said.code in (0, 1), (typed, said.err)
        lines = [line.removeprefix("next: contourlab ") for line in said.out.splitlines() if line.startswith("next: contourlab ")]
        if not lines:
            break
        typed = shlex.split(lines[-1])
        if any(word.isupper() for word in typed):  # a name to fill in
            break
        if typed in proposed:
            break
        proposed.append([*typed])
        if typed[0] == "tune":  # a whole search takes minutes
            typed += ["--budget", "32", "--method", "global", "--starts", "1"]
    return proposed


@pytest.mark.parametrize("words", QUICK, ids=" ".join)
def test_what_a_quick_command_proposes_runs(contourlab: Run, folder: Path, words: tuple[str, ...]) -> None:
    assert follow(contourlab, folder, words) or words[0] in SILENT


@pytest.mark.parametrize("command", [*(pytest.param(name, marks=pytest.mark.slow) for name in ("measure", "circle")), "limits"])
def test_the_unit_of_a_machine_goes_on(contourlab: Run, folder: Path, command: str) -> None:
    log = np.loadtxt(folder / "circle.csv", delimiter=",", skiprows=1) / [1.0, *[25.4] * 4]
    np.savetxt(folder / "circle.csv", log, header="time [s],x cmd,y cmd,x pos,y pos", comments="", delimiter=",")
    limit = [] if command == "limits" else ["--tolerance", "5 um"]
    first = contourlab(command, "circle.csv", "--machine", "m.ini", *limit, "--window", "..7000")
    (line,) = (line for line in first.out.splitlines() if line.startswith("next: contourlab "))
    assert shlex.split(line)[2] != "explain" and contourlab(*shlex.split(line)[2:]).code == 0
    assert {*shlex.split(line)} >= {"--window", "..7000"}


def test_no_run_is_proposed_that_lacks_a_plant(contourlab: Run, folder: Path) -> None:
    (folder / "m.ini").write_text((folder / "m.ini").read_text().replace("HALCMD", "#"))
    said = contourlab("check", "inch.ngc", "--machine", "m.ini")
    assert said.code == 0 and "CL988" in said.out and "next:" not in said.out


@pytest.mark.slow
@pytest.mark.parametrize("words", SLOW, ids=" ".join)
def test_what_a_study_proposes_runs(contourlab: Run, folder: Path, words: tuple[str, ...]) -> None:
    assert follow(contourlab, folder, words) or words[0] in SILENT
