"""Find files by name, relative or shipped with contourlab, and join the files of a scenario."""

from __future__ import annotations

import difflib
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path

from contourlab.controls import ControlFile, control_file
from contourlab.errors import ScenarioError, hint, refuse
from contourlab.file_kinds import kind_of, mistaken
from contourlab.scenario.tree import DEFAULT, Leaf, Node, Table, from_mapping, located, merge, read_tree

BUILTIN = "builtin:"
"""Prefix of shipped files."""
_SHIPPED = Path(__file__).parents[1] / "machines"
EVERY = "*"
"""Name for every axis, as in ``[controller.axes."*"]``."""


_MACHINES = "name a file with [machine], the INI file of a LinuxCNC, what $$ of grbl prints, or the config.yaml of FluidNC"
_NO_MACHINES = {
    "a file of LinuxCNC": "is not the INI file of a LinuxCNC: name that",
    "the settings of a control": "lacks settings of the axes: save all that $$ prints, or the whole config.yaml",
}
_KINDS = {
    "machine_file": ("a machine",),
    "controller_file": ("a controller",),
    "axis_file": ("an axis", "a controller"),  # the file of one axis of a controller may name its controller
}
"""Method of `Reader` that reads a part -> kinds of file."""


@cache
def builtin_names() -> tuple[str, ...]:
    """Return the names of the shipped files: TOML without its ending, part programs with it.

    >>> "xyz" in builtin_names()
    True
    """
    names = [path.relative_to(_SHIPPED) for path in _SHIPPED.rglob("*") if path.suffix in (".toml", ".ngc")]
    return tuple(sorted(str((name.with_suffix("") if name.suffix == ".toml" else name).as_posix()) for name in names))


def builtin_file(name: str) -> Path:
    """Return a shipped file by its name, with or without the prefix ``builtin:`` and the ending ``.toml``.

    Raises
    ------
    ScenarioError
        If no shipped file has that name.
    """
    short = name.removeprefix(BUILTIN).removesuffix(".toml")
    if short not in builtin_names():
        near = difflib.get_close_matches(short, builtin_names(), n=1, cutoff=0.6)
        cure = f"did you mean {near[0]!r}?" if near else "contourlab machines lists them"
        raise ScenarioError(f"no shipped file has this name: {cure}", file=name)
    return _SHIPPED / (short if short.endswith(".ngc") else short + ".toml")


def shipped_hint(file: str | Path) -> str:
    """Return the end of a message on a file that is not there, if a shipped file has its name; else nothing."""
    return f": the shipped one is {BUILTIN}{file}" if str(file) in builtin_names() else ""


def locate(reference: str, folder: Path) -> Path:
    """Return the file that a reference names; relative names start at `folder`."""
    if reference.startswith(BUILTIN):
        return builtin_file(reference)
    return folder / reference


def named_in(table: Table, key: str) -> Path:
    """Return the file that an entry names."""
    node = table.entries[key]
    with located(table, key):
        return locate(str(node.plain()), Path(node.file).parent)


@dataclass(frozen=True)
class Reader:
    """Joins the files of a scenario.

    Parameters
    ----------
    names : tuple of str
        Axes of the machine, if known; ``"*"`` means all of them.
    open_files : tuple of Path
        Files being read, outermost first, to detect cycles.
    seen : list of Path
        All files read so far; derived readers share it.
    controls : list of ControlFile
        Machines read from a control's own file so far; derived readers share it.
    """

    names: tuple[str, ...] = ()
    open_files: tuple[Path, ...] = ()
    seen: list[Path] = field(default_factory=list)
    controls: list[ControlFile] = field(default_factory=list)

    def file(self, path: Path, *wanted: str) -> Table:
        """Read a file of one of the kinds wanted; a machine may be the file of a control."""
        control = control_file(path) if "a machine" in wanted else None
        self.seen.extend([path] if control is None else [path, *control.files])
        if control is None and "a machine" in wanted and path.suffix.lower() not in (".toml", "") and path.is_file():
            words = _NO_MACHINES.get(kind_of(path)) or mistaken(path, *wanted) or f"is no machine: {_MACHINES}"
            raise ScenarioError(words, file=path)
        if control is None:
            return read_tree(path, *wanted)
        self.controls.append(control)
        return from_mapping({name: control.tables[name] for name in ("machine", "axes")}, str(path))

    def include(self, leaf: Leaf, part: Callable[[Reader, Table], Table]) -> Table:
        """Return the content of the file that `leaf` names, read by `part` and marked `afresh`.

        Raises
        ------
        ScenarioError
            If it cannot be read, or includes itself.
        """
        if not isinstance(leaf.value, str) or not leaf.value.strip():
            raise leaf.error(f'{leaf.value!r} is not a file name: write for example "machine.toml" or "{BUILTIN}xyz"')
        try:
            path = locate(leaf.value, Path(leaf.file).parent)
            resolved = path.resolve()
            exists = path.is_file()
        except ScenarioError as error:
            raise leaf.error(f"{leaf.value!r}: {error.message}") from error
        except (OSError, ValueError) as error:
            raise leaf.error(f"{leaf.value!r} is not a file name: {error}") from error
        if not exists:
            raise leaf.error(f"no file {leaf.value!r} in {Path(leaf.file).parent.as_posix()}")
        if resolved in self.open_files:
            names = " -> ".join(p.name for p in (*self.open_files, resolved))
            raise leaf.error(f"files include each other, {names}: remove one of these references")
        inner = replace(self, open_files=(*self.open_files, resolved))
        return replace(part(inner, inner.file(path, *_KINDS[part.__name__])), afresh=True)

    # --- parts -------------------------------------------------------------------------------------------------------------------

    def _split(self, node: Node, part: Callable[[Reader, Table], Table]) -> tuple[Table | None, Node | None]:
        """Return the content of the file that a part names, if any, and the part's other keys."""
        if isinstance(node, Leaf):
            return (None, node) if node.value == DEFAULT else (self.include(node, part), None)
        reference = node.get("file")
        if reference is None:
            return None, node
        if isinstance(reference, Table):
            raise reference.error("write a file name in quotes")
        rest = node.without("file")
        return self.include(reference, part), rest if rest.entries else None

    def axes(self, table: Table) -> Table:
        """Return the tables of axes, their files joined in."""
        entries = dict(table.entries)
        for name, node in entries.items():
            base, own = self._split(node, Reader.axis_file)
            if base is not None:
                entries[name] = joined(base, own if isinstance(own, Table) else None, self.names)
        return replace(table, entries=entries)

    def axis_file(self, content: Table) -> Table:
        """Check the content of an axis file: plant, friction, drive ... are top-level keys."""
        for name in ("machine", "axes"):
            refuse(name in content.entries, content.error, "not an axis file: write plant, friction, drive ... as top-level keys", name)
        return content

    def machine(self, content: Table) -> Table:
        """Return ``machine`` and ``axes`` of a file, their files joined in."""
        node = content.get("machine")
        base, rest = (None, None) if node is None else self._split(node, Reader.machine_file)
        entries = {} if rest is None else {"machine": rest}
        if "axes" in content.entries:
            entries["axes"] = self.axes(content.table("axes"))
        own = Table(entries, content.file, content.key)
        names = listed(merge(base, own) if base else own)
        return spread(own, names) if base is None else joined(base, own, names)

    def machine_file(self, content: Table) -> Table:
        """Check and join the content of a machine file."""
        refuse_others(content, ("machine", "axes"), "a machine")
        return self.machine(content)

    def controller(self, node: Node) -> Node:
        """Return the controller, its files joined in."""
        base, own = self._split(node, Reader.controller_file)
        if isinstance(own, Leaf):
            return own
        if own is not None and "axes" in own.entries:
            own = own.having(axes=self.axes(own.table("axes")))
        if base is None:
            assert own is not None  # without a file the part itself remains
            return own
        return joined(base, own, self.names)

    def controller_file(self, content: Table) -> Table:
        """Check and join the content of a controller file."""
        refuse_others(content, ("controller",), "a controller")
        if "controller" not in content.entries:
            raise content.error("key controller is missing: a controller file has [controller] and [controller.axes.x]")
        controller = self.controller(content.entries["controller"])
        if isinstance(controller, Leaf):
            raise controller.error("write a table [controller]")
        return controller


def refuse_others(content: Table, known: tuple[str, ...], what: str) -> None:
    """Refuse unknown keys in a file."""
    for name in content.entries:
        if name not in known:
            raise content.error(f"unknown key in {what} file: {hint(name, known)}", name)


def listed(machine: Table) -> tuple[str, ...]:
    """Return the names in ``machine.axes``; `build_machine` reports faults of the list."""
    node = machine.get("machine")
    names = node.get("axes") if isinstance(node, Table) else None
    if not isinstance(names, Leaf) or not isinstance(names.value, list):
        return ()
    return tuple(name for name in names.value if isinstance(name, str))


def join(base: Table, over: Table, names: tuple[str, ...]) -> Table:
    """Merge two machines or two controllers; ``"*"`` in `over` overrides a named axis in `base`."""
    return merge(spread(base, names), spread(over, names))


def joined(base: Table, over: Table | None, names: tuple[str, ...]) -> Table:
    """Return the content of a file with what its table overrides."""
    return base if over is None else replace(join(base, over, names), afresh=True)


def spread(part: Table, names: tuple[str, ...]) -> Table:
    """Apply ``axes."*"`` to each axis of `names`; keep it for axes added later."""
    axes = part.get("axes")
    if not isinstance(axes, Table) or EVERY not in axes.entries:
        return part
    every = axes.entries[EVERY]
    if isinstance(every, Leaf):
        raise every.error("write a table of the keys that all axes share")
    entries = dict(axes.entries)
    for name in names:
        own = entries.get(name)
        if own is None:
            entries[name] = every
        elif isinstance(own, Table):
            entries[name] = replace(merge(every, own), file=own.file, key=own.key, afresh=own.afresh or every.afresh)
    return part.having(axes=replace(axes, entries=entries))
