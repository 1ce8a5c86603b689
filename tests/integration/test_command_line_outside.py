"""The environment of the command: interrupts, full disks, closed readers, folders in use, odd names, all kinds of terminals."""

from __future__ import annotations

import json
import os
import re
import select
import signal
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from typed_commands import CIRCLE, COMMAND, ON_XYZ, PART, POSIX, Finished, Run, contents, environment

from contourlab.result import Result

ESCAPE = "\x1b"


def read_until_closed(handle: int, knock: Callable[[], None], patience: float = 60.0) -> str:
    """Return the output of a terminal; call `knock` at the first output, and again whenever it pauses, as a person would."""
    parts: list[bytes] = []
    begun = time.monotonic()
    while time.monotonic() < begun + patience:
        if not select.select([handle], [], [], 2.0)[0]:
            if parts:
                knock()
            continue
        try:
            part = os.read(handle, 65536)
        except OSError:  # Linux raises this when the other side has closed
            part = b""
        if not part:
            return b"".join(parts).decode()
        if not parts:
            knock()
        parts.append(part)
    raise TimeoutError(b"".join(parts).decode())


def on_terminal(folder: Path, *words: str, width: int = 80, interrupted: bool = False, **changes: str) -> tuple[int, str]:
    """Run the command on a terminal; return its exit code and its output. An interrupt comes with the first output."""
    import fcntl
    import pty
    import struct
    import termios

    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, width, 0, 0))
    env = environment({"TERM": "xterm-256color", **changes})
    process = subprocess.Popen([COMMAND, *words], cwd=folder, stdin=theirs, stdout=theirs, stderr=theirs, env=env)
    os.close(theirs)
    try:
        shown = read_until_closed(ours, lambda: process.send_signal(signal.SIGINT) if interrupted else None)
        return process.wait(timeout=60), shown
    finally:
        process.kill()
        os.close(ours)


@POSIX
@pytest.mark.slow
def test_an_interrupt_in_the_middle_is_130_and_keeps_the_old_results(old_results: Path, tmp_path: Path) -> None:
    (tmp_path / "long.toml").write_text(CIRCLE.replace("laps = 2", "laps = 50"), encoding="utf-8")
    before = contents(old_results)
    # On a terminal a bar shows that the simulation has begun.
    code, shown = on_terminal(tmp_path, "run", "long.toml", "--out", "results", interrupted=True)
    assert code == 130
    assert shown.splitlines()[-1].endswith("contourlab: interrupted: no result is kept")
    assert "Traceback" not in shown
    assert contents(old_results) == before


@POSIX
@pytest.mark.slow
def test_questions_that_are_interrupted_are_130(tmp_path: Path) -> None:
    code, shown = on_terminal(tmp_path, "new", "machine", interrupted=True)
    assert code == 130
    assert "contourlab: interrupted" in shown
    assert "Traceback" not in shown
    assert not any(tmp_path.iterdir())


@pytest.mark.slow
@POSIX
@pytest.mark.parametrize("words", [[], ["--json"]])
def test_a_closed_reader_is_no_error_and_the_verdict_stays(tmp_path: Path, words: list[str]) -> None:
    (tmp_path / "circle.toml").write_text(CIRCLE.replace("16 um", "1 um").replace("laps = 2", "laps = 1"), encoding="utf-8")
    reading, writing = os.pipe()
    os.close(reading)
    command = [COMMAND, "run", "circle.toml", "--out", "results", *words]
    done = subprocess.run(command, cwd=tmp_path, stdout=writing, stderr=subprocess.PIPE, env=environment(), timeout=60)
    os.close(writing)
    assert (done.returncode, done.stderr) == (1, b"")
    assert "report.html" in contents(tmp_path / "results")


@pytest.mark.slow
@POSIX
@pytest.mark.parametrize("closed", [1, 2])
def test_streams_may_be_closed(tmp_path: Path, closed: int) -> None:
    (tmp_path / "part.ngc").write_text(PART, encoding="utf-8")
    command = [COMMAND, "run", "part.ngc", *ON_XYZ, "--out", "results"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, env=environment(), timeout=60, preexec_fn=lambda: os.close(closed))
    assert (done.returncode, done.stderr) == (0, b"")
    # A file that took the place of standard output would hold what is printed.
    assert Result.load(tmp_path / "results" / "signals" / "base.nc").n_sample > 1000


@POSIX
@pytest.mark.slow
def test_a_full_disk_is_2_and_keeps_the_old_results(contourlab: Run, old_results: Path, tmp_path: Path) -> None:
    import resource

    (tmp_path / "other.toml").write_text(CIRCLE.replace("20 mm", "19 mm"), encoding="utf-8")
    before = contents(old_results)
    full = 50_000  # largest file size in bytes; the signals of 4 s need more
    said = contourlab("run", "other.toml", "--out", "results", before=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (full, full)))
    assert (said.code, said.out) == (2, "")
    assert re.fullmatch(r"contourlab: \S+: .*\n", said.err)
    assert contents(old_results) == before


@pytest.mark.slow
def test_newer_results_replace_older_ones(contourlab: Run, old_results: Path, tmp_path: Path) -> None:
    (tmp_path / "other.toml").write_text(CIRCLE.replace("20 mm", "19 mm"), encoding="utf-8")
    before = contents(old_results)
    said = contourlab("run", "other.toml", "--out", "results", "--json")
    assert said.code == 0
    after = contents(old_results)
    assert all(after[name] != before[name] for name in ("summary.json", "report.html"))
    assert json.loads(said.out) == json.loads((old_results / "summary.json").read_text(encoding="utf-8"))
    assert not [name for name in after if ".part" in name or "probe" in name]


def test_names_may_have_spaces_and_letters_of_any_script(contourlab: Run, tmp_path: Path) -> None:
    place = tmp_path / "Fräs teile Ω"
    place.mkdir()
    (place / "część 1.ngc").write_text("(größer)\n" + PART.replace("%\n", ""), encoding="utf-8")
    found = json.loads(contourlab("run", place / "część 1.ngc", *ON_XYZ, "--out", "Ergebnis für 部品", "--json").answer)
    assert found["name"] == "część 1"
    page = (tmp_path / "Ergebnis für 部品" / "report.html").read_text(encoding="utf-8")
    assert "część 1" in page


@pytest.mark.slow
def test_a_scheme_may_have_any_name(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "circle.toml").write_text(CIRCLE + '[schemes."../größer: a|b"]\n', encoding="utf-8")
    said = contourlab("run", "circle.toml", "--out", "results", "--json")
    assert said.code == 0
    assert list(json.loads(said.out)["schemes"]) == ["../größer: a|b"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["circle.toml", "results"]
    assert [path.suffix for path in (tmp_path / "results" / "signals").iterdir()] == [".nc"]


def test_a_pipe_gets_no_colours_and_no_progress(circle: Finished, part: Finished, contourlab: Run) -> None:
    said = [circle.said, part.said, contourlab("components"), contourlab("--help")]
    assert not [one for one in said if ESCAPE in one.out + one.err]
    assert "\r" not in part.said.out + part.said.err


@POSIX
@pytest.mark.slow
def test_a_terminal_may_refuse_colours(tmp_path: Path) -> None:
    colour = re.compile(r"\x1b\[[0-9;]*3[0-9][0-9;]*m")
    assert colour.search(on_terminal(tmp_path, "--help")[1])
    for words in (["--help"], ["components", "plant"]):
        code, shown = on_terminal(tmp_path, *words, NO_COLOR="1")
        assert code == 0
        assert not colour.search(shown)


@POSIX
@pytest.mark.slow
def test_tables_fit_a_narrow_terminal(tmp_path: Path) -> None:
    for words in (["--help"], ["run", "--help"], ["components", "coulomb"]):
        code, shown = on_terminal(tmp_path, *words, width=60)
        plain = re.sub(r"\x1b\[[0-9;?]*[a-zA-Z]", "", shown)
        assert code == 0
        assert max(len(line.rstrip()) for line in plain.splitlines()) <= 60
    assert "coulomb" in plain


def test_help_fits_the_columns_asked_for(contourlab: Run) -> None:
    said = contourlab("--help", env={"COLUMNS": "60"})
    assert max(map(len, said.out.splitlines())) <= 60


@pytest.mark.slow
def test_without_a_terminal_nothing_is_asked(tmp_path: Path) -> None:
    (tmp_path / "circle.toml").write_text(CIRCLE, encoding="utf-8")
    command = [COMMAND, "run", "circle.toml", "--check"]
    done = subprocess.run(command, cwd=tmp_path, stdin=subprocess.DEVNULL, capture_output=True, env=environment(), timeout=60)
    assert (done.returncode, done.stderr) == (0, b"")
