"""Where results go: seen to be writable ahead of the work, newer ones replacing older ones together, or not at all."""

from __future__ import annotations

import os
import shutil
import signal
import tempfile
import threading
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from contourlab.app.written_files import LIST, OURS, SINGLE, WrittenFiles
from contourlab.errors import OutputError, ParameterError


def check_file(file: str | Path, inputs: Iterable[str | Path] = (), option: str = "--out") -> None:
    """See that a file can be written, ahead of the work that it is to hold; nothing is left behind, and an older one stays as it is.

    Parameters
    ----------
    file : str or Path
        Folders above it that are not there yet are no fault: they are made when it is written.
    inputs : iterable of str or Path
        What the command reads, which it must not write over.
    option : str
        What named it.

    Raises
    ------
    ParameterError
        If it is one of `inputs`, by whatever name.
    OutputError
        If it is a folder, or cannot be made or replaced.
    """
    target = Path(file)
    if target.is_dir():
        raise OutputError(f"{target}: is a folder; name a file with {option}")
    spared(target, inputs, option)
    with _made(target.parent, option):
        pass


def spared(file: str | Path, inputs: Iterable[str | Path], option: str = "--out") -> None:
    """Refuse a file to write that is one to read, by whatever name: a link, another spelling.

    Parameters
    ----------
    file : str or Path
    inputs : iterable of str or Path
        Names of files that are not there, such as those of shipped ones, are passed over.
    option : str
        What named the file.

    Raises
    ------
    ParameterError
        If it is.
    """
    for given in inputs:
        if _is_same(file, given):
            raise ParameterError(option, repr(str(file)), f"another file than {given}, which is read")


def _is_same(one: str | Path, other: str | Path) -> bool:
    try:
        return Path(one).samefile(other)
    except (OSError, ValueError):  # one of them is not there, or is no name of a file
        return False


@contextmanager
def staged(out: str | Path, *names: str, inputs: Iterable[str | Path] = (), option: str = "--out") -> Iterator[Path]:
    """Give a folder to write results into; when the block ends well they take the place of older ones in `out`.

    Older ones are those that contourlab itself wrote into `out` together with the same summary, as a list there says. Whatever else is
    there stays, and all of it where the block has written nothing. After an error or an interrupt `out` is as it was.

    Parameters
    ----------
    out : str or Path
        Made if it is not there.
    names : str
        What is sure to be written, the summary first, so that what stands in its way is told ahead of the work. Without any the results go
        with no summary, as pictures by themselves, and replace their namesakes only.
    inputs : iterable of str or Path
        What the command reads, which must not be replaced.
    option : str
        What named the folder.

    Yields
    ------
    Path

    Raises
    ------
    ParameterError
        If something in `out` that is to be replaced is one of `inputs`.
    OutputError
        If the folder cannot be made or written to, or a file is in the way that contourlab did not write.
    """
    folder, summary, given = Path(out), names[0] if names else "", tuple(inputs)
    _check(folder, summary, names, given, option)
    with _made(folder, option) as stage:
        yield stage
        new = [path.relative_to(stage).as_posix() for pattern in OURS for path in sorted(stage.glob(pattern))]
        if new:
            _check(folder, summary, new, given, option)
            with _undisturbed():
                _exchange(stage, folder, summary, new)


def _check(folder: Path, summary: str, names: Iterable[str], inputs: Iterable[str | Path], option: str) -> None:
    """Refuse to replace what is read, and what contourlab did not write."""
    written = WrittenFiles.of(folder)
    for name in (*names, *written.beside(summary)):
        for given in inputs:
            if _is_same(folder / name, given):
                raise ParameterError(option, repr(str(folder)), f"another folder: {given} is read, and would be replaced")
    for name in names:
        if name not in written.names and os.path.lexists(folder / name):
            cure = f"choose another folder with {option}, or move it away"
            raise OutputError(f"{folder / name}: would be replaced, and is not known to be contourlab's: {cure}")


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


def _exchange(stage: Path, folder: Path, summary: str, new: Iterable[str]) -> None:
    """Move older results into the stage, which is thrown away, and newer ones out of it: renames on one disk, a matter of milliseconds."""
    before = WrittenFiles.of(folder)
    old, after = before.beside(summary), before.after(summary, new)
    moved: list[tuple[Path, Path]] = []

    def move(path: Path, target: Path) -> None:
        moved.append((path, path.replace(target)))

    def put_away(path: Path) -> None:
        if os.path.lexists(path):
            move(path, stage / f"old-{len(moved)}")

    try:
        after.save(stage / "list")
        # Whenever it all ends, be it in the middle, whatever is there of the older and the newer results is listed.
        with _relisted(stage, folder, after.with_more(summary or SINGLE, old)):
            for name in old:
                put_away(folder / name)
            for name in new:
                (folder / name).parent.mkdir(exist_ok=True)
                put_away(folder / name)
                move(stage / name, folder / name)
            (stage / "list").replace(folder / LIST)
    except OSError as error:
        for path, target in reversed(moved):
            with suppress(OSError):
                target.replace(path)
        raise OutputError(f"{folder}: cannot be written: {error.strerror or error}") from error
    finally:
        _remove(folder / name for name in {pattern.partition("/")[0] for pattern in OURS if "/" in pattern})


@contextmanager
def _relisted(stage: Path, folder: Path, files: WrittenFiles) -> Iterator[None]:
    """Put a list into a folder while the block runs; where that fails the former one is put back."""
    had = (folder / LIST).exists()
    if had:
        shutil.copyfile(folder / LIST, stage / "list-before")
    files.save(stage / "list-meanwhile")
    (stage / "list-meanwhile").replace(folder / LIST)
    try:
        yield
    except OSError:
        with suppress(OSError):
            (stage / "list-before").replace(folder / LIST) if had else (folder / LIST).unlink()
        raise


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
