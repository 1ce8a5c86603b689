"""Where results go: seen to be writable ahead of the work, newer ones replacing older ones together, or not at all."""

from __future__ import annotations

import shutil
import signal
import tempfile
import threading
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from contourlab.errors import OutputError

__all__ = ["check_file", "staged"]

KEPT = "learned/*.nc"
"""What is no report but a product: each replaces an older one of its own name only."""
_PLOTS = ("plots/*.png", "plots/*.svg", "plots/*.pdf")
OURS = ("report.html", "signals/*.nc", "switches/*.csv", KEPT, "controllers/*.toml", *_PLOTS, "swap.json", "summary.json")
"""What a run writes; the summary comes last, so that where it is the rest is complete."""


def check_file(file: str | Path, option: str = "--out") -> None:
    """See that a file can be written, ahead of the work that it is to hold; nothing is left behind, and an older one stays as it is.

    Parameters
    ----------
    file : str or Path
        Folders above it that are not there yet are no fault: they are made when it is written.
    option : str
        What named it.

    Raises
    ------
    OutputError
        If it is a folder, or cannot be made or replaced.
    """
    target = Path(file)
    if target.is_dir():
        raise OutputError(f"{target}: is a folder; name a file with {option}")
    with _made(target.parent, option):
        pass


@contextmanager
def staged(out: str | Path, *, alone: bool = True, option: str = "--out") -> Iterator[Path]:
    """Give a folder to write results into; when the block ends well they take the place of older ones in `out`.

    Files that no run writes are left alone, and all of them where the block has written nothing. After an error or an interrupt `out` is as
    it was.

    Parameters
    ----------
    out : str or Path
        Made if it is not there.
    alone : bool
        Whether the results are all that is to be in `out`, so that older ones of other names go; else they replace their namesakes only.
    option : str
        What named the folder.

    Yields
    ------
    Path

    Raises
    ------
    OutputError
        If the folder cannot be made or written to; found before the block begins.
    """
    folder = Path(out)
    with _made(folder, option) as stage:
        yield stage
        with _undisturbed():
            _exchange(stage, folder, alone)


@contextmanager
def _made(folder: Path, option: str) -> Iterator[Path]:
    """Give a temporary folder in one that is made if it is not there; both are gone afterwards, the outer one if it is empty."""
    made = [path for path in (folder, *folder.parents) if not path.exists()]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        stage = Path(tempfile.mkdtemp(dir=folder, prefix=".contourlab-"))
    except OSError as error:
        _remove(made)
        raise OutputError(f"{folder}: cannot be written: {error.strerror or error}; choose another folder with {option}") from error
    try:
        yield stage
    finally:
        shutil.rmtree(stage, ignore_errors=True)
        _remove(made)


def _remove(folders: Iterable[Path]) -> None:
    for path in folders:
        with suppress(OSError):
            path.rmdir()  # goes only where it is empty


def _exchange(stage: Path, folder: Path, alone: bool) -> None:
    """Move older results into the stage, which is thrown away, and newer ones out of it: renames on one disk, a matter of milliseconds."""
    new = [path for pattern in OURS for path in sorted(stage.glob(pattern))]
    if not new:
        return
    old = [path for pattern in OURS if alone and pattern != KEPT for path in sorted(folder.glob(pattern))]
    moved: list[tuple[Path, Path]] = []
    try:
        for number, path in enumerate(old):
            moved.append((path, path.replace(stage / f"old-{number}")))
        for path in new:
            target = folder / path.relative_to(stage)
            target.parent.mkdir(exist_ok=True)
            moved.append((path, path.replace(target)))
    except OSError as error:
        for path, target in reversed(moved):
            with suppress(OSError):
                target.replace(path)
        raise OutputError(f"{folder}: cannot be written: {error.strerror or error}") from error
    finally:
        _remove(folder / name for name in ("signals", "switches", "learned", "controllers", "plots"))


@contextmanager
def _undisturbed() -> Iterator[None]:
    """Hold an interrupt back until the block has ended."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    held: list[Any] = []
    before = signal.signal(signal.SIGINT, lambda *told: held.append(told))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
    if held:
        raise KeyboardInterrupt
