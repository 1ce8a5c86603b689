"""Machines from a control's own file: what it sets becomes the tables of a scenario.

A reader is one module of this package, or of the entry-point group ``contourlab.controls``, with two functions:

    matches(file, head) -> bool     from the name of a file and its first bytes
    read(file) -> ControlFile
"""

from __future__ import annotations

import importlib
import importlib.metadata
import pkgutil
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Protocol

from contourlab.controls.contract import ControlFile, computed, guessed, read_from

__all__ = ["ENTRY_POINT_GROUP", "ControlFile", "Reader", "computed", "control_file", "guessed", "read_from", "reader_of", "readers"]

ENTRY_POINT_GROUP = "contourlab.controls"
_HEAD = 1 << 16
"""Bytes from which a file is recognised."""


class Reader(Protocol):
    """A module that reads one kind of file."""

    matches: Callable[[Path, bytes], bool]
    read: Callable[[Path], ControlFile]


@cache
def readers() -> dict[str, Reader]:
    """Return the readers by name; a module that cannot be imported is an error."""
    import contourlab.controls as package

    names = (info.name for info in pkgutil.iter_modules(package.__path__) if info.name != "contract")
    own = {name: importlib.import_module(f"{package.__name__}.{name}") for name in names}
    return {**own, **{entry.name: entry.load() for entry in importlib.metadata.entry_points(group=ENTRY_POINT_GROUP)}}


def reader_of(file: Path) -> Reader | None:
    """Return the reader that knows a file; None if none does."""
    if file.suffix == ".toml" or not file.is_file():
        return None
    with file.open("rb") as stream:
        head = stream.read(_HEAD)
    return next((reader for reader in readers().values() if reader.matches(file, head)), None)


def control_file(file: Path) -> ControlFile | None:
    """Return what a control's own file says; None if no reader knows it.

    Raises
    ------
    ScenarioError
        If a reader knows it, but it is faulty; has file and line.
    """
    reader = reader_of(file)
    return None if reader is None else reader.read(file)
