"""Names of files: relative ones, and those that are shipped with contourlab; and the reading of parts from files of their own."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path

import contourlab
from contourlab.errors import ScenarioError
from contourlab.scenario.tree import DEFAULT, Leaf, Node, Table, hint, located, merge, read_tree

BUILTIN = "builtin:"
"""Prefix of the names of files that are shipped."""
EVERY = "*"
"""Stands for every axis, as in ``[controller.axes."*"]``."""


def _shipped() -> Path:
    return Path(contourlab.__file__).parent / "machines"


@cache
def builtin_names() -> tuple[str, ...]:
    """Return the names of the shipped files: TOML without its ending, part programs with it.

    >>> "xyz" in builtin_names()
    True
    """
    root = _shipped()
    found = [path.relative_to(root) for path in root.rglob("*") if path.suffix in (".toml", ".ngc")]
    return tuple(sorted(str((name.with_suffix("") if name.suffix == ".toml" else name).as_posix()) for name in found))


def builtin_file(name: str) -> Path:
    """Return a shipped file by its name, with or without the prefix ``builtin:`` and the ending ``.toml``.

    Raises
    ------
    ScenarioError
        If there is none; says the nearest name.
    """
    short = name.removeprefix(BUILTIN).removesuffix(".toml")
    if short not in builtin_names():
        raise ScenarioError(f"no file of that name is shipped: {hint(short, builtin_names())}", file=name)
    return _shipped() / (short if short.endswith(".ngc") else short + ".toml")


def locate(reference: str, folder: Path) -> Path:
    """Return the file that a name in a file of `folder` stands for."""
    if reference.startswith(BUILTIN):
        return builtin_file(reference)
    return folder / reference


def named_in(table: Table, key: str) -> Path:
    """Return the file that an entry names, relative to the file it stands in."""
    node = table.entries[key]
    with located(table, key):
        return locate(str(node.plain()), Path(node.file).parent)


@dataclass(frozen=True)
class Reader:
    """Joins the files of a scenario.

    Parameters
    ----------
    names : tuple of str
        Axes of the machine, where known: what ``"*"`` stands for.
    open_files : tuple of Path
        Files that are being read, outermost first, to find cycles.
    seen : list of Path
        Every file that was read, by this reader and by those made from it.
    """

    names: tuple[str, ...] = ()
    open_files: tuple[Path, ...] = ()
    seen: list[Path] = field(default_factory=list)

    def file(self, path: Path) -> Table:
        """Read a file."""
        self.seen.append(path)
        return read_tree(path)

    def include(self, leaf: Leaf, part: Callable[[Reader, Table], Table]) -> Table:
        """Return what the file that `leaf` names holds, read by `part`, marked as read afresh.

        Raises
        ------
        ScenarioError
            If it cannot be read, or is one of the files that lead to it.
        """
        if not isinstance(leaf.value, str) or not leaf.value.strip():
            raise leaf.error(f'{leaf.value!r} is no file name: write for example "machine.toml" or "{BUILTIN}xyz"')
        try:
            path = locate(leaf.value, Path(leaf.file).parent)
            resolved = path.resolve()
            there = path.is_file()
        except ScenarioError as error:
            raise leaf.error(f"{leaf.value!r}: {error.message}") from error
        except (OSError, ValueError) as error:
            raise leaf.error(f"{leaf.value!r} is no file name: {error}") from error
        if not there:
            raise leaf.error(f"no file {leaf.value!r} in {Path(leaf.file).parent.as_posix()}")
        if resolved in self.open_files:
            names = " -> ".join(p.name for p in (*self.open_files, resolved))
            raise leaf.error(f"the files name each other in a circle: {names}")
        inner = replace(self, open_files=(*self.open_files, resolved))
        return replace(part(inner, inner.file(path)), afresh=True)

    # --- parts -------------------------------------------------------------------------------------------------------------------

    def _filled(self, node: Node, part: Callable[[Reader, Table], Table]) -> Node:
        """Return a part with the file that it names read in: ``x = "file"``, or ``x = {file = "file", ...}`` with changes to it."""
        base, own = self._split(node, part)
        if base is None:
            return node
        if not isinstance(own, Table):
            return base
        return replace(join(base, own, self.names), afresh=True)

    def _split(self, node: Node, part: Callable[[Reader, Table], Table]) -> tuple[Table | None, Node | None]:
        """Return the content of the file that a part names, if any, and the rest of the part."""
        if isinstance(node, Leaf):
            return (None, node) if node.value == DEFAULT else (self.include(node, part), None)
        reference = node.get("file")
        if reference is None:
            return None, node
        if isinstance(reference, Table):
            raise reference.error("the name of a file is wanted, in quotes")
        rest = node.without("file")
        return self.include(reference, part), rest if rest.entries else None

    def axes(self, table: Table) -> Table:
        """Return tables of axes with the files that they name read in."""
        return replace(table, entries={name: self._filled(node, Reader.axis_file) for name, node in table.entries.items()})

    def axis_file(self, content: Table) -> Table:
        """Read an axis' own file: plant, friction, drive ... stand at its top."""
        for name in ("machine", "axes"):
            if name in content.entries:
                raise content.error("this is not the file of an axis: its parts stand at the top of its own file", name)
        return content

    def machine(self, content: Table) -> Table:
        """Return the machine part of a file, ``machine`` and ``axes``, with the files that they name read in."""
        entries: dict[str, Node] = {}
        base: Table | None = None
        if "machine" in content.entries:
            base, rest = self._split(content.entries["machine"], Reader.machine_file)
            if rest is not None:
                entries["machine"] = rest
        if "axes" in content.entries:
            entries["axes"] = self.axes(content.table("axes"))
        own = Table(entries, content.file, content.key)
        names = listed(merge(base, own) if base else own)
        if base is not None:
            return replace(join(base, own, names), afresh=True)
        return join(own, Table({}, own.file, own.key), names)

    def machine_file(self, content: Table) -> Table:
        """Read a machine's own file."""
        refuse_others(content, ("machine", "axes"), "a machine")
        return self.machine(content)

    def controller(self, node: Node) -> Node:
        """Return the controller with the files that it names read in."""
        base, own = self._split(node, Reader.controller_file)
        if isinstance(own, Leaf):
            return own
        if own is not None and "axes" in own.entries:
            axes = own.table("axes")
            own = own.having(axes=replace(axes, entries={k: self._filled(v, Reader.axis_file) for k, v in axes.entries.items()}))
        if base is None:
            assert own is not None  # a table either names a file or says something itself
            return own
        return base if own is None else replace(join(base, own, self.names), afresh=True)

    def controller_file(self, content: Table) -> Table:
        """Read a controller's own file."""
        refuse_others(content, ("controller",), "a controller")
        if "controller" not in content.entries:
            raise content.error("key controller is missing: a controller's file has [controller] and [controller.axes.x]")
        found = self.controller(content.entries["controller"])
        if isinstance(found, Leaf):
            raise found.error("a table [controller] is wanted")
        return found


def refuse_others(content: Table, known: tuple[str, ...], what: str) -> None:
    """Refuse a key that has no place in a file."""
    for name in content.entries:
        if name not in known:
            raise content.error(f"unknown key in the file of {what}: {hint(name, known)}", name)


def listed(machine: Table) -> tuple[str, ...]:
    """Return the names that ``machine.axes`` lists; `build_machine` reports faults of the list."""
    node = machine.get("machine")
    names = node.get("axes") if isinstance(node, Table) else None
    if not isinstance(names, Leaf) or not isinstance(names.value, list):
        return ()
    return tuple(name for name in names.value if isinstance(name, str))


def join(base: Table, over: Table, names: tuple[str, ...]) -> Table:
    """Merge two machines, or two controllers, whose ``axes`` may have an entry for every axis.

    ``"*"`` in `over` has priority over an axis by name in `base`.
    """
    return merge(_spread(base, names), _spread(over, names))


def _spread(part: Table, names: tuple[str, ...]) -> Table:
    """Put what ``axes."*"`` says under each axis of `names`; it is kept, for axes that come later."""
    axes = part.get("axes")
    if not isinstance(axes, Table) or EVERY not in axes.entries:
        return part
    every = axes.entries[EVERY]
    if isinstance(every, Leaf):
        raise every.error("a table is wanted: what all axes have in common")
    entries = dict(axes.entries)
    for name in names:
        own = entries.get(name)
        if own is None:
            entries[name] = every
        elif isinstance(own, Table):
            afresh = own.afresh or every.afresh
            entries[name] = replace(merge(every, own), file=own.file, key=own.key, afresh=afresh)
    return part.having(axes=replace(axes, entries=entries))
