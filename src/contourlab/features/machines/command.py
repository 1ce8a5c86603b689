"""``contourlab machines``: list, show and copy the shipped machines, axes, controllers, scenarios and programs."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar

from contourlab.app.json_values import HIDDEN
from contourlab.controls import reader_of
from contourlab.errors import OutputError, refuse
from contourlab.findings import Finding
from contourlab.rendering.judgement import NOT_STATED, Number
from contourlab.rendering.origins import numbers_of_axis, numbers_of_machine, stated
from contourlab.result import write_bytes_atomic
from contourlab.scenario import BUILTIN, builtin_file, builtin_names, load_axis, load_machine, load_scenario
from contourlab.scenario.tree import read_tree

KINDS = ("machine", "axis", "controller", "scenario", "program")
"""Kinds of shipped files, in the order of the list."""


@dataclass(frozen=True)
class Shipped:
    """A shipped file.

    Attributes
    ----------
    name : str
        Name as after ``builtin:``.
    kind : str
        One of `KINDS`.
    axes : tuple of str
        Axes of a machine or a scenario; empty otherwise.
    about : str
        First sentence of the file.
    numbers : tuple of Number
        Parameters of a machine or an axis, with their sources.
    findings : tuple of Finding
        Those on a control's own file.
    """

    json_derived: ClassVar = ("sources", "references", "provenance", "text")

    name: str
    kind: str
    axes: tuple[str, ...]
    about: str
    file: Path
    numbers: tuple[Number, ...] = field(default=(), metadata=HIDDEN)
    findings: tuple[Finding, ...] = ()

    @property
    def sources(self) -> dict[str, int]:
        """Number of parameters by source."""
        counts = Counter(number.source for number in self.numbers)
        return dict(sorted(counts.items(), key=lambda item: (item[0] == NOT_STATED, -item[1])))

    @property
    def references(self) -> tuple[str, ...]:
        """Logs, papers and tables from which the parameters come."""
        named = (name for number in self.numbers if number.is_stated for name in _names(number.reference))
        return tuple(dict.fromkeys(named))

    @property
    def provenance(self) -> tuple[Number, ...]:
        """Parameters with a stated source."""
        return stated(self.numbers)

    @property
    def text(self) -> str:
        """Text of the file."""
        return self.file.read_text(encoding="utf-8", errors="replace")


def shipped() -> list[Shipped]:
    """Return all shipped files: machines first, then axes, controllers, scenarios and programs."""
    return sorted(map(shipped_one, builtin_names()), key=lambda file: (KINDS.index(file.kind), file.name))


def shipped_one(name: str) -> Shipped:
    """Return a shipped file by its name, with or without ``builtin:``, or a file of one's own by its path.

    Raises
    ------
    ScenarioError
        If there is no such file; suggests the nearest name.
    """
    own = Path(name).is_file()
    file = Path(name) if own else builtin_file(name)
    short = name if own else name.removeprefix(BUILTIN).removesuffix(".toml")
    if reader_of(file) is not None:
        machine = load_machine(file)
        control = machine.control
        assert control is not None
        about, numbers = f"Read from a file of {control.control}", numbers_of_machine(machine)
        return Shipped(short, "machine", machine.axis_names, about, file, numbers, control.findings)
    about = _about(file)
    if file.suffix == ".ngc":
        return Shipped(short, "program", (), about, file)
    content = set(read_tree(file).entries)
    if "controller" in content and "machine" in content:
        return Shipped(short, "scenario", load_scenario(file).machine.axis_names, about, file)
    if "machine" in content:
        machine = load_machine(file)
        return Shipped(short, "machine", machine.axis_names, about, file, numbers_of_machine(machine))
    if "plant" in content:
        return Shipped(short, "axis", (), about, file, numbers_of_axis(load_axis(file)))
    return Shipped(short, "controller", (), about, file)


def _names(reference: str) -> list[str]:
    """Return the authors or files at the start of a reference, without page or column."""
    first, *others = reference.split(", ")
    names = [first] if first else []
    for part in others:
        if " & " in part:  # the last of several authors
            names[-1] += f", {part}"
        elif re.search(r"\.\w+\Z", part):
            names.append(part)
        else:
            break
    return names


def _about(file: Path) -> str:
    """Return the first sentence of the comment at the start of a file."""
    words: list[str] = []
    for text in map(str.strip, file.read_text(encoding="utf-8").splitlines()):
        if text.startswith(("#", "(")) and text.strip("#() "):
            words += text.strip("#()").split()
        elif words or text not in ("", "%"):
            break
    # A full stop after a single letter does not end a sentence.
    return re.split(r"(?<!(?<!\S)[^\W\d_])\. ", " ".join(words), maxsplit=1)[0].rstrip(".")


def copy_shipped(name: str, folder: str | Path, *, force: bool = False) -> list[Path]:
    """Copy a shipped file and the files that it names into a folder.

    Parameters
    ----------
    name : str
        With or without ``builtin:``.
    folder : str or Path
        Created if missing.
    force : bool
        Whether to overwrite existing files.

    Returns
    -------
    list of Path
        The copies, the file itself first.

    Raises
    ------
    ScenarioError
        If there is no such file.
    OutputError
        If a file exists (raised before anything is written) or cannot be written.
    """
    files = list(dict.fromkeys(_with_parts(builtin_file(name).resolve())))
    base = os.path.commonpath([file.parent for file in files])  # keep the folders between the files
    targets = {Path(folder) / file.relative_to(base): file for file in files}
    refuse_existing(targets, folder, force)
    for target, file in targets.items():
        write_bytes_atomic(target, file.read_bytes())
    return list(targets)


def refuse_existing(targets: Iterable[Path], folder: str | Path, force: bool) -> None:
    """Raise OutputError if a target exists, unless `force` is set."""
    existing = [target.name for target in targets if target.exists()]
    refuse(existing and not force, OutputError, f"{folder}: already contains {', '.join(existing)}. Choose another folder, or use --force")


def _with_parts(file: Path) -> Iterator[Path]:
    yield file
    if file.suffix == ".toml":
        for text in _texts(read_tree(file).plain()):
            part = (file.parent / text).resolve()
            if Path(text).suffix in (".toml", ".ngc", ".csv") and part.is_file():
                yield from _with_parts(part)


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, Mapping):
        for item in value.values():
            yield from _texts(item)
    elif isinstance(value, list):
        for item in value:
            yield from _texts(item)
