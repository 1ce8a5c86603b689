"""Where results go: refused before the work where they cannot, and never at the cost of older ones."""

from __future__ import annotations

from pathlib import Path

import pytest

from contourlab.errors import OutputError
from contourlab.session.folder import check_file, staged

OLD = {"report.html": "old", "summary.json": "old", "plots/path.svg": "old", "notes.txt": "of the user"}


@pytest.fixture
def used(tmp_path: Path) -> Path:
    folder = tmp_path / "results"
    write(folder, OLD)
    return folder


def write(folder: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


def read(folder: Path) -> dict[str, str]:
    return {path.relative_to(folder).as_posix(): path.read_text() for path in folder.rglob("*") if path.is_file()}


def test_newer_results_replace_all_older_ones(used: Path) -> None:
    with staged(used) as stage:
        write(stage, {"summary.json": "new"})
        assert read(used).items() >= OLD.items()
    assert read(used) == {"summary.json": "new", "notes.txt": "of the user"}


def test_pictures_by_themselves_replace_their_namesakes_only(used: Path) -> None:
    with staged(used, alone=False) as stage:
        write(stage, {"plots/path.svg": "new", "plots/other.png": "new"})
    assert read(used) == OLD | {"plots/path.svg": "new", "plots/other.png": "new"}


def test_a_block_that_writes_nothing_takes_nothing_away(used: Path) -> None:
    """As of a command that only sees whether it may write there."""
    with staged(used):
        pass
    check_file(used / "machine.toml")
    assert read(used) == OLD


def test_what_cannot_be_moved_in_leaves_the_older_results(used: Path) -> None:
    """A file of the user stands where a folder is wanted."""
    write(used, {"signals": "of the user"})
    with pytest.raises(OutputError, match="cannot be written"), staged(used) as stage:
        write(stage, {"report.html": "new", "signals/base.nc": "new"})
    assert read(used) == OLD | {"signals": "of the user"}


@pytest.mark.parametrize(("place", "said"), [("folder.toml", "is a folder"), ("file/below.toml", "choose another folder with --to")])
def test_a_file_that_cannot_be_is_refused(place: str, said: str, tmp_path: Path) -> None:
    (tmp_path / "folder.toml").mkdir()
    (tmp_path / "file").write_text("of the user")
    with pytest.raises(OutputError, match=said):
        check_file(tmp_path / place, "--to")


def test_folders_that_are_not_there_yet_are_no_fault_and_are_not_left_behind(tmp_path: Path) -> None:
    check_file(tmp_path / "some" / "where" / "machine.toml")
    assert list(tmp_path.iterdir()) == []
