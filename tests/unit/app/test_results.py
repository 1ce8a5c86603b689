"""Where results go: impossible targets are refused before the work; older results, inputs and foreign files are protected."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from contourlab.app.results import LIST, check_file, staged
from contourlab.errors import OutputError, ParameterError

OLD = {"report.html": "old", "summary.json": "old", "plots/path.svg": "old"}
NOTES = {"notes.txt": "of the user", "plots/path-old.svg": "of the user", "signals/bench.nc": "of the user"}


@pytest.fixture
def used(tmp_path: Path) -> Path:
    folder = tmp_path / "results"
    with staged(folder, "summary.json") as stage:
        write(stage, OLD)
    write(folder, NOTES)
    return folder


def write(folder: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


def read(folder: Path) -> dict[str, str]:
    return {path.relative_to(folder).as_posix(): path.read_text() for path in folder.rglob("*") if path.is_file() and path.name != LIST}


def listed(folder: Path) -> set[str]:
    return {name for names in json.loads((folder / LIST).read_text())["files"].values() for name in names}


def test_new_results_replace_all_older_ones_and_nothing_else(used: Path) -> None:
    with staged(used, "summary.json") as stage:
        write(stage, {"summary.json": "new"})
        assert read(used).items() >= OLD.items()
    assert read(used) == {"summary.json": "new", **NOTES}
    assert listed(used) == {"summary.json"}


def test_pictures_alone_replace_only_files_of_the_same_name(used: Path) -> None:
    with staged(used) as stage:
        write(stage, {"plots/path.svg": "new", "plots/other.png": "new"})
    assert read(used) == OLD | NOTES | {"plots/path.svg": "new", "plots/other.png": "new"}
    with staged(used, "summary.json") as stage:
        write(stage, {"summary.json": "new"})
    assert read(used).keys() == {"summary.json", "plots/path.svg", "plots/other.png", *NOTES}


def test_results_of_another_kind_and_products_are_kept(used: Path) -> None:
    swap = {"swap.json": "swap", "controllers/shared.toml": "swap", "plots/swap.png": "swap"}
    with staged(used, "swap.json") as stage:
        write(stage, swap)
    with staged(used, "summary.json") as stage:
        write(stage, {"summary.json": "new", "learned/a.nc": "table"})
    with staged(used, "summary.json") as stage:
        write(stage, {"summary.json": "newer"})
    assert read(used) == {**swap, "summary.json": "newer", "learned/a.nc": "table", **NOTES}
    with staged(used, "swap.json") as stage:
        write(stage, {"swap.json": "newer"})
    assert read(used) == {"swap.json": "newer", "summary.json": "newer", "learned/a.nc": "table", **NOTES}


@pytest.mark.parametrize("file", ["summary.json", "signals/bench.nc"])
def test_files_not_written_by_contourlab_are_not_replaced(tmp_path: Path, file: str) -> None:
    write(tmp_path, {file: "of the user"})
    ahead = pytest.raises(OutputError, match=rf"{file}: would be replaced.*another folder with --to")
    with ahead, staged(tmp_path, "summary.json", file, option="--to"):
        pytest.fail("it is told ahead of the work")
    with pytest.raises(OutputError, match=file), staged(tmp_path) as stage:
        write(stage, {file: "new", "plots/a.png": "new"})
    assert read(tmp_path) == {file: "of the user"}


@pytest.mark.parametrize("names", ["", '[["signals/a.nc"]]', '["../mine.nc", "notes.txt"]'])
def test_a_damaged_list_claims_no_files(tmp_path: Path, names: str) -> None:
    folder = tmp_path / "results"
    mine = {"../mine.nc": "of the user", "notes.txt": "of the user", "signals/a.nc": "of the user"}
    write(folder, {**mine, LIST: f'{{"files": {{"summary.json": {names}}}}}'})
    with staged(folder, "summary.json") as stage:
        write(stage, {"summary.json": "new"})
    assert {name: (folder / name).read_text() for name in mine} == mine


@pytest.mark.parametrize("spelling", ["results/plots/path.svg", "results/../results/plots/path.svg", "link/plots/path.svg"])
def test_an_input_in_the_results_folder_is_not_replaced_under_any_spelling(used: Path, spelling: str) -> None:
    (used.parent / "link").symlink_to(used, target_is_directory=True)
    before = read(used)
    ahead = pytest.raises(ParameterError, match=r"a different folder: .* would be replaced")
    with ahead, staged(used, "summary.json", inputs=[used.parent / spelling]):
        pytest.fail("it is told ahead of the work")
    with pytest.raises(ParameterError, match="command reads"), staged(used, inputs=[used.parent / spelling]) as stage:
        write(stage, {"plots/path.svg": "new"})
    assert read(used) == before
    with staged(used, "summary.json", inputs=[used / "signals" / "bench.nc", "builtin:xyz"]) as stage:
        write(stage, {"summary.json": "new"})
    assert read(used) == {"summary.json": "new", **NOTES}


def test_an_input_file_is_not_overwritten_under_any_spelling(tmp_path: Path) -> None:
    (tmp_path / "log.csv").write_text("of the user")
    (tmp_path / "link.csv").symlink_to(tmp_path / "log.csv")
    for name in ("log.csv", "link.csv", f"../{tmp_path.name}/log.csv"):
        with pytest.raises(ParameterError, match=r"--write = .*: must be a different file: .*log\.csv"):
            check_file(tmp_path / name, ["nowhere.csv", tmp_path / "log.csv"])
    check_file(tmp_path / "other.csv", [tmp_path / "log.csv", "builtin:xyz"])


def test_a_block_that_writes_nothing_removes_nothing(used: Path) -> None:
    """As when a command only checks whether it may write there."""
    with staged(used, "summary.json"):
        pass
    check_file(used / "machine.toml")
    assert read(used) == OLD | NOTES


def test_a_failed_move_keeps_the_older_results(used: Path) -> None:
    """A file of the user is in the place of a folder."""
    write(used, {"switches": "of the user"})
    before = {path: path.read_bytes() for path in used.rglob("*") if path.is_file()}
    new = {"report.html": "new", "switches/base.csv": "new", "plots/path.svg": "new"}
    with pytest.raises(OutputError, match="cannot be written"), staged(used, "summary.json") as stage:
        write(stage, new)
    with pytest.raises(OutputError, match="cannot be written"), staged(used) as stage:
        write(stage, new)
    assert {path: path.read_bytes() for path in used.rglob("*") if path.is_file()} == before


@pytest.mark.parametrize("reached", range(6))
def test_a_kill_during_replacement_leaves_no_unknown_file(used: Path, reached: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """All files afterwards are known as ours, so that the next run replaces them."""
    replace, done = Path.replace, []

    def until_killed(path: Path, target: Path) -> Path:
        done.append(target)
        if len(done) > reached:
            raise SystemExit
        return replace(path, target)

    with monkeypatch.context() as patched, pytest.raises(SystemExit), staged(used, "summary.json") as stage:
        write(stage, {"summary.json": "new", "report.html": "new", "plots/more.svg": "new"})
        patched.setattr(Path, "replace", until_killed)
    assert read(used).keys() - NOTES.keys() <= listed(used)
    with staged(used, "summary.json") as stage:
        write(stage, {"summary.json": "newer"})
    assert read(used) == {"summary.json": "newer", **NOTES}


@pytest.mark.parametrize("reached", range(6))
def test_an_interrupt_during_replacement_leaves_everything_unchanged(used: Path, reached: int, monkeypatch: pytest.MonkeyPatch) -> None:
    before, listed_before = read(used), (used / LIST).read_bytes()
    replace, done = Path.replace, []

    def interrupted(path: Path, target: Path) -> Path:
        done.append(target)
        moved = replace(path, target)
        if len(done) == reached + 1:
            raise KeyboardInterrupt
        return moved

    with monkeypatch.context() as patched, pytest.raises(KeyboardInterrupt), staged(used, "summary.json") as stage:
        write(stage, {"summary.json": "new", "report.html": "new", "plots/more.svg": "new"})
        patched.setattr(Path, "replace", interrupted)
    assert (read(used), (used / LIST).read_bytes()) == (before, listed_before)


@pytest.mark.parametrize(("place", "said"), [("folder.toml", "is a folder"), ("file/below.toml", "choose another folder with --to")])
def test_an_impossible_file_is_refused(place: str, said: str, tmp_path: Path) -> None:
    (tmp_path / "folder.toml").mkdir()
    (tmp_path / "file").write_text("of the user")
    with pytest.raises(OutputError, match=said):
        check_file(tmp_path / place, option="--to")


def test_missing_folders_are_accepted_and_not_left_behind(tmp_path: Path) -> None:
    check_file(tmp_path / "some" / "where" / "machine.toml")
    assert list(tmp_path.iterdir()) == []


MOST = 99
KILLED = """
import os, sys
from pathlib import Path
from contourlab.app.results import staged

after = sys.argv[2] == "after"
for number in range(1, int(sys.argv[3]) + 1):  # a process each
    child = os.fork()
    if not child:
        break
    if os.waitpid(child, 0)[1] == 0:
        print(number)
        sys.exit()
place, left = Path(sys.argv[1], str(number)), [number]

def watched(name):
    plain = getattr(os, name)
    def call(path, *more, **named):
        left[0] -= 1
        if left[0] == 0 and not after:
            os._exit(9)
        try:
            return plain(path, *more, **named)
        finally:
            if left[0] == 0 and after:
                os._exit(9)
    setattr(os, name, call)

for name in ("mkdir", "unlink", "rmdir", "replace", "rename"):
    watched(name)
with staged(place, "summary.json") as stage:
    (stage / "plots").mkdir()
    for name in ("summary.json", "report.html", "plots/more.svg"):
        (stage / name).write_text("new")
"""


@pytest.mark.skipif(sys.platform == "win32", reason="no locks")
@pytest.mark.parametrize("when", ["before", "after"])
@pytest.mark.slow
def test_a_kill_at_any_change_of_the_folder_is_cleaned_up(tmp_path: Path, when: str) -> None:
    """A process ends before or after each of its changes in turn; the next run removes its folder and keeps one whole set of results."""
    new = dict.fromkeys(("summary.json", "report.html", "plots/more.svg"), "new")
    for n in range(1, MOST + 1):
        with staged(tmp_path / str(n), "summary.json") as stage:
            write(stage, OLD)
    words = [sys.executable, "-c", KILLED, str(tmp_path), when, str(MOST)]
    whole = int(subprocess.run(words, check=True, capture_output=True, text=True).stdout)
    for n in range(1, whole + 1):
        folder = tmp_path / str(n)
        check_file(folder / "any.txt")
        assert not list(folder.glob(".contourlab-*")), n
        assert read(folder) in (OLD, new), n
    assert read(tmp_path / str(whole)) == new and whole > 10
