"""Folders of results: new results replace those of the previous run all at once, and only if the run succeeds.

A run writes into a temporary folder inside the folder of results, and its files are then renamed into place. A list in the folder holds
the files that contourlab wrote, each with its summary. No other file is ever replaced. What a killed run left is undone and removed by the
next one.
"""

from __future__ import annotations

import json
import logging
import os
import re
import shutil
import sys
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import BinaryIO

from contourlab.errors import OutputError, ParameterError, ResultError, refuse
from contourlab.figures import grouped
from contourlab.result.atomic import replacing
from contourlab.result.record import read_record, write_record
from contourlab.result.stamp import current

SAFETY = "contourlab is no safety function: test on the machine with its own limits active."
"""What all proposed gains and exported controllers say."""
LIST = ".contourlab.json"
"""File name of the list."""
SCHEMA, OLDER = "contourlab-files/2", "contourlab-files/1"
"""Form of the list, and the one before, which had no digest."""
_STAGE = ".contourlab-"
"""Prefix of temporary folders."""
_HELD = "held"
"""File in a temporary folder that its process keeps locked."""
_JOURNAL = "exchange.json"
"""File in a temporary folder from the first rename to the last: what `_undo` needs."""
_RESULTS = (
    *("report.html", "report.pdf", "signals/*.nc", "switches/*.csv", "learned/*.nc", "proposed/*.toml", "controllers/*.toml"),
    *("plots/*.png", "plots/*.svg", "plots/*.pdf"),
    *("axis_*.*", "tuned.toml", "swap.json", "export-*.json", "summary.json"),
)
"""All files that a run may write. Summaries are last: if one is in place, the rest is complete."""
_SINGLE = "single"
"""Summary in the list for files written without one."""
_PRODUCTS = "learned/"
"""Folder of files that stay when the next run replaces their summary."""


def proposed(head: str, text: str) -> str:
    """Return a TOML file of proposed gains, with a first line, what made it and the note on safety."""
    return f"# {' '.join(head.split())}\n# {current()}\n# {SAFETY}\n\n{text}"


def filled(file: Path, values: Mapping[str, str]) -> str:
    """Return the text of a file of ours with a value in place of each ``@NAME@``."""
    return re.sub("@([A-Z]+)@", lambda match: values[match[1]], file.read_text(encoding="utf-8"))


def check_file(file: str | Path, inputs: Iterable[str | os.PathLike[str]] = (), option: str = "--write") -> None:
    """Check before the work that a file can be written, and leave nothing behind.

    Parameters
    ----------
    file : str or Path
        Missing parent folders are allowed; writing the file creates them.
    inputs : iterable of str or Path
        Files that the command reads and must not overwrite.
    option : str
        Option that names the file, for messages.

    Raises
    ------
    ParameterError
        If it is one of `inputs`.
    OutputError
        If it is a folder or a device, or cannot be created or replaced.
    """
    target = Path(file)
    refuse(target.exists() and not target.is_file(), OutputError, f"{target}: is a folder or a device; name a file with {option}")
    spared(target, inputs, option)
    with _temporary(target.parent, option):
        pass


def write_together(files: Mapping[Path, str | bytes], inputs: Iterable[str | os.PathLike[str]] = (), option: str = "--out") -> None:
    """Write files, all or none; parameters and errors as in `check_file`."""
    with ExitStack() as stack:
        for file, content in files.items():
            check_file(file, inputs, option)
            data = content if isinstance(content, bytes) else content.encode("utf-8", "replace")
            stack.enter_context(replacing(file)).write_bytes(data)


def spared(file: str | Path, inputs: Iterable[str | os.PathLike[str]], option: str = "--out") -> None:
    """Refuse to write a file that the command reads, also under another name, such as a link.

    Names in `inputs` that are not files, such as built-in scenarios, are ignored.

    Raises
    ------
    ParameterError
        If it is one of `inputs`.
    """
    for given in inputs:
        refuse(_is_same(file, given), ParameterError, option, repr(str(file)), f"a different file: the command reads {given}")


def _is_same(one: str | os.PathLike[str], other: str | os.PathLike[str]) -> bool:
    try:
        return Path(one).samefile(other)
    except (OSError, ValueError):  # one of them does not exist, or is not a file name
        return False


def check_folder(out: str | Path, *names: str, inputs: Iterable[str | os.PathLike[str]] = (), option: str = "--out") -> None:
    """Check before the work that results can be written into a folder, and leave nothing behind; see `staged`."""
    folder = Path(out)
    _check(folder, names[0] if names else "", names, tuple(inputs), option)
    with _temporary(folder, option):
        pass


@contextmanager
def staged(out: str | Path, *names: str, inputs: Iterable[str | os.PathLike[str]] = (), option: str = "--out") -> Iterator[Path]:
    """Yield a temporary folder for results; if the block succeeds, they replace the previous results in `out`.

    Files that contourlab wrote into `out` with the same summary are replaced. All other files stay. If the block fails, is interrupted or
    writes nothing, `out` does not change.

    Parameters
    ----------
    out : str or Path
        Created if missing.
    names : str
        Files that are certain to be written, the summary first; conflicts are reported before the work. Without names the results have no
        summary (pictures alone, for example), and replace only files of the same name.
    inputs : iterable of str or Path
        Files that the command reads and must not replace.
    option : str
        Option that names the folder, for messages.

    Raises
    ------
    ParameterError
        If one of `inputs` would be replaced.
    OutputError
        If the folder cannot be written to, or contourlab did not write a file that would be replaced.
    """
    folder, summary, given = Path(out), names[0] if names else "", tuple(inputs)
    _check(folder, summary, names, given, option)
    with _temporary(folder, option) as stage:
        yield stage
        new = [path.relative_to(stage).as_posix() for pattern in _RESULTS for path in sorted(stage.glob(pattern))]
        if new:
            _check(folder, summary, new, given, option)
            _exchange(stage, folder, summary, new)


def _check(folder: Path, summary: str, names: Iterable[str], inputs: Iterable[str | os.PathLike[str]], option: str) -> None:
    """Refuse to replace input files, and files that contourlab did not write."""
    listed = _listed(folder)
    for name in (*names, *_written_with(summary, listed)):
        for given in inputs:
            if _is_same(folder / name, given):
                raise ParameterError(option, repr(str(folder)), f"a different folder: the command reads {given}, which would be replaced")
    for name in names:
        if name not in listed and os.path.lexists(folder / name):
            cure = f"choose another folder with {option}, or move the file"
            raise OutputError(f"{folder / name}: would be replaced, but contourlab did not write it: {cure}")


@dataclass(frozen=True)
class FileList:
    """The files that contourlab wrote into a folder, by their summary."""

    schema: str
    files: dict[str, list[str]]


def _listed(folder: Path) -> dict[str, str]:
    """Return the existing files that contourlab wrote, each with its summary; none if the list is missing, damaged or edited."""
    try:
        sets = read_record(folder / LIST, FileList, "none of its files is replaced", OLDER).files
    except ResultError:
        return {}
    there = {path.relative_to(folder).as_posix() for pattern in _RESULTS for path in folder.glob(pattern)}
    return {name: summary for summary, names in sets.items() for name in names if name in there}


def _save_list(listed: Mapping[str, str], stage: Path, folder: Path) -> None:
    write_record(stage / LIST, FileList(SCHEMA, grouped((summary, name) for name, summary in sorted(listed.items()))))
    (stage / LIST).replace(folder / LIST)


def _written_with(summary: str, listed: Mapping[str, str]) -> list[str]:
    return [name for name, its in listed.items() if summary and its == summary]


def _exchange(stage: Path, folder: Path, summary: str, new: Iterable[str]) -> None:
    """Swap the previous results in `folder` for the new ones in `stage` by renaming; undo everything on an error or interrupt."""
    before, new = _listed(folder), list(new)
    previous = _written_with(summary, before)
    added = {name: _SINGLE if not summary or name.startswith(_PRODUCTS) else summary for name in new}
    away = [name for name in dict.fromkeys([*previous, *new]) if os.path.lexists(folder / name)]
    listed = (folder / LIST).read_text(encoding="utf-8") if (folder / LIST).exists() else None
    (stage / _JOURNAL).write_text(json.dumps({"away": away, "new": new, "list": listed}), encoding="utf-8")
    try:
        _save_list({**before, **added}, stage, folder)
        for path, target in _moves(stage, folder, away, new):
            target.parent.mkdir(exist_ok=True)
            path.replace(target)
        _save_list({name: its for name, its in before.items() if name not in previous} | added, stage, folder)
        (stage / _JOURNAL).unlink()
    except BaseException as error:
        _undo(stage, folder)
        if isinstance(error, OSError):
            raise OutputError(f"{folder}: cannot be written: {error.strerror or error}") from error
        raise
    finally:
        _remove_empty(folder / name for name in {pattern.partition("/")[0] for pattern in _RESULTS if "/" in pattern})


def _moves(stage: Path, folder: Path, away: Iterable[str], new: Iterable[str]) -> list[tuple[Path, Path]]:
    """Return the renames of an exchange: first older files out of the way, then new ones into place."""
    older = [(folder / name, stage / f"previous-{k}") for k, name in enumerate(away)]
    return older + [(stage / name, folder / name) for name in new]


def _undo(stage: Path, folder: Path) -> bool:
    """Undo the renames that were done, by the journal of the exchange; return whether there was one."""
    try:
        journal = json.loads((stage / _JOURNAL).read_text(encoding="utf-8"))
        away, new, listed = journal["away"], journal["new"], journal["list"]
        if not all(map(_is_result, (*away, *new))):  # a journal from elsewhere must not move other files
            return False
    except (OSError, ValueError, KeyError, TypeError):
        return False
    for path, target in reversed(_moves(stage, folder, away, new)):
        if os.path.lexists(target) and not os.path.lexists(path):
            with suppress(OSError):
                target.replace(path)
    (folder / LIST).unlink(missing_ok=True) if listed is None else (folder / LIST).write_text(listed, encoding="utf-8")
    # Once the files of the stage are gone, the journal would take the restored results back.
    (stage / _JOURNAL).unlink()
    return True


def _is_result(name: str) -> bool:
    """Return whether a run may write a file of this name, relative to its folder."""
    path = PurePosixPath(name)
    return ".." not in path.parts and any(len(path.parts) == pattern.count("/") + 1 and path.match(pattern) for pattern in _RESULTS)


def _clean_up(folder: Path) -> None:
    """Undo and remove what processes that were killed have left in a folder."""
    if sys.platform == "win32":  # has no such locks
        return
    for stage in folder.glob(f"{_STAGE}*"):
        with suppress(OSError):
            stage.rmdir()  # only if empty: killed before it was held, or after
        with suppress(OSError), (stage / _HELD).open("r+b") as stream:
            lock(stream)
            undone = _undo(stage, folder)
            _remove(stage)
            what = "the results from before it are back" if undone else "its unfinished results are removed"
            logging.getLogger("contourlab").warning("contourlab: %s: an earlier run was killed: %s", folder, what)


def _remove(stage: Path) -> None:
    """Remove a temporary folder, and last of its files the one that marks it."""
    for path in stage.glob("*"):
        if path.name != _HELD:
            shutil.rmtree(path, ignore_errors=True) if path.is_dir() else path.unlink(missing_ok=True)
    shutil.rmtree(stage, ignore_errors=True)


def lock(stream: BinaryIO) -> None:
    """Lock a file until it is closed or its process ends; OSError if another process holds it, or the file system has no locks."""
    if sys.platform != "win32":
        import fcntl

        fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)


@contextmanager
def _temporary(folder: Path, option: str) -> Iterator[Path]:
    """Yield a temporary folder inside `folder`; create `folder` if missing, and remove it again if it stays empty."""
    made = [path for path in (folder, *folder.parents) if not path.exists()]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        _clean_up(folder)
        stage, stream = _held_stage(folder)
    except OSError as error:
        _remove_empty(made)
        raise OutputError(f"{folder}: cannot be written: {error.strerror or error}; choose another folder with {option}") from error
    try:
        with stream:
            yield stage
    finally:
        with suppress(OSError):
            _remove(stage)
        _remove_empty(made)


def _held_stage(folder: Path) -> tuple[Path, BinaryIO]:
    """Return a new temporary folder and its marking file, locked if the file system has locks."""
    while True:
        stage = folder / Path(tempfile.mkdtemp(dir=folder, prefix=_STAGE)).name  # absolute from Python 3.12 on; messages name it as typed
        with suppress(FileNotFoundError, BlockingIOError):  # another process removes it before it is locked
            stream = (stage / _HELD).open("wb")
            try:
                lock(stream)
            except BlockingIOError:
                stream.close()
                raise
            except OSError:  # no locks
                pass
            if (stage / _HELD).exists():
                return stage, stream
            stream.close()


def _remove_empty(folders: Iterable[Path]) -> None:
    for path in folders:
        with suppress(OSError):
            path.rmdir()
