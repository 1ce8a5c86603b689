"""The raw content of TOML files: a tree in which each value keeps its file and key.

`merge` joins files before anything is interpreted, so a message can name the place to edit.
"""

from __future__ import annotations

import json
import tomllib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, TypeAlias

from contourlab.components.contract import FAMILIES
from contourlab.errors import ContourlabError, ScenarioError
from contourlab.file_kinds import mistaken, toml_of
from contourlab.scenario.toml_text import BARE

DEFAULT = "default"
"""Resets an inherited value."""

DESIGNED = ("velocity_gain", "position_gain", "integral_gain", "integral_time", "gain", "lead_time", "lag_time", "rate_gain")
"""Parameters that gains = {...} computes; new gains reset inherited values of these."""

STATED = "value"
"""Key of the value in a table of a number and its source."""

MAX_DEPTH = 12
_TEXTS = ("name", "file")


@dataclass(frozen=True, slots=True)
class Leaf:
    """A value as TOML gives it, with its file and dotted key."""

    value: Any
    file: str
    key: str

    def plain(self) -> Any:
        """Return the bare value."""
        return self.value

    def error(self, message: str) -> ScenarioError:
        """Return an error that names this value."""
        return ScenarioError(message, file=self.file, key=self.key)


@dataclass(frozen=True, slots=True)
class Table:
    """A table of values and tables.

    `afresh` marks the content of an included file: it replaces an inherited table instead of being merged with it.
    """

    entries: Mapping[str, Node] = field(default_factory=dict)
    file: str = "<scenario>"
    key: str = ""
    afresh: bool = False

    def plain(self) -> dict[str, Any]:
        """Return the content without files and keys."""
        return {name: node.plain() for name, node in self.entries.items()}

    def get(self, name: str) -> Node | None:
        """Return an entry, or None."""
        return self.entries.get(name)

    def at(self, name: str) -> str:
        """Return the dotted key of an entry, present or not."""
        return dotted(self.key, name)

    def table(self, name: str) -> Table:
        """Return the table of that name, empty if missing.

        Raises
        ------
        ScenarioError
            If the entry is not a table.
        """
        node = self.entries.get(name)
        if node is None:
            return Table({}, self.file, self.at(name))
        if isinstance(node, Leaf):
            raise node.error(f"{node.value!r} is not a table: write [{node.key}] and its keys below it")
        return node

    def error(self, message: str, name: str = "") -> ScenarioError:
        """Return an error that names this table, or an entry of it."""
        node = self.entries.get(name) if name else None
        if node is not None:
            return ScenarioError(message, file=node.file, key=node.key)
        return ScenarioError(message, file=self.file, key=self.at(name) if name else self.key)

    def having(self, **changes: Node) -> Table:
        """Return a copy with other entries."""
        return replace(self, entries={**self.entries, **changes})

    def without(self, *names: str) -> Table:
        """Return a copy without some entries."""
        return replace(self, entries={k: v for k, v in self.entries.items() if k not in names})

    def only(self, *names: str) -> Table:
        """Return a copy with these entries only."""
        return replace(self, entries={k: v for k, v in self.entries.items() if k in names})


Node: TypeAlias = Leaf | Table


def same_table(a: Node, b: Node) -> bool:
    """Tell whether two nodes belong to the same table of the same file."""
    return (a.file, a.key.rpartition(".")[0]) == (b.file, b.key.rpartition(".")[0])


@contextmanager
def located(table: Table, name: str = "") -> Iterator[None]:
    """Add file and key to errors about a value."""
    try:
        yield
    except ScenarioError:
        raise
    except ContourlabError as error:
        raise table.error(str(error), name) from error


def dotted(key: str, name: str) -> str:
    """Return the dotted key of `name` below `key`, quoted if TOML requires it.

    >>> dotted("axes", "x")
    'axes.x'
    """
    shown = name if BARE.match(name) else json.dumps(name, ensure_ascii=False)
    return f"{key}.{shown}" if key else shown


def from_mapping(values: Mapping[str, Any], file: str, key: str = "", depth: int = 0) -> Table:
    """Return the tree of a mapping.

    Raises
    ------
    ScenarioError
        If it is nested more than `MAX_DEPTH` deep, or holds None.
    """
    if depth > MAX_DEPTH:
        raise ScenarioError(f"tables are nested more than {MAX_DEPTH} deep: flatten them", file=file, key=key[:80])
    entries: dict[str, Node] = {}
    for name, value in values.items():
        place = dotted(key, name)
        if isinstance(value, Mapping):
            entries[name] = from_mapping(value, file, place, depth + 1)
        elif value is None:
            raise ScenarioError("is None: delete the key", file=file, key=place)
        else:
            entries[name] = Leaf(value, file, place)
    return Table(entries, file, key)


def read_tree(file: Path, *wanted: str) -> Table:
    """Read a TOML file of one of the kinds wanted, see `contourlab.file_kinds.mistaken`.

    Raises
    ------
    ScenarioError
        If it cannot be read, is not TOML, or of another kind.
    """
    name = str(file)
    if words := mistaken(file, *wanted):
        raise ScenarioError(words, file=name)
    try:
        text = file.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise ScenarioError(f"is not UTF-8 text (byte {error.start}): save it as UTF-8", file=name) from error
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise ScenarioError(f"cannot be read: {reason}", file=name) from error
    return parse_tree(text, name)


def parse_tree(text: str, name: str) -> Table:
    """Read TOML text; messages call it `name`."""
    try:
        values = toml_of(text)
    except tomllib.TOMLDecodeError as error:
        raise ScenarioError(f"is not valid TOML: {error}", file=name) from error
    except (RecursionError, ValueError) as error:
        # tomllib passes on errors of int() and of deep nesting.
        raise ScenarioError(f"cannot be read as TOML: {error}", file=name) from error
    return from_mapping(values, name)


def _joined(name: str, base: Node, over: Node) -> Node:
    if isinstance(over, Leaf) or over.afresh or STATED in over.entries:
        return over
    if isinstance(base, Leaf):
        if "source" in over.entries and name != "file":
            return over.having(**{STATED: base})  # the source of an inherited number
        # `drive = "saturation"` is short for a table with that kind; more of its keys may follow.
        short = name in FAMILIES and isinstance(base.value, str) and base.value != "none"
        return over.having(kind=base) if short and "kind" not in over.entries else over
    kinds = [getattr(table.get("kind"), "value", None) for table in (over, base)]
    return over if "kind" in over.entries and kinds[0] != kinds[1] else merge(base, over)


def merge(base: Table, over: Table) -> Table:
    """Return `base` overridden by `over`, table by table.

    A component of another kind replaces the inherited one, and so does a table read from a file. Gains by pole placement replace
    inherited gains.
    """
    entries = dict(base.entries)
    if "gains" in over.entries:
        for name in DESIGNED:
            entries.pop(name, None)
    for name, node in over.entries.items():
        entries[name] = _joined(name, entries[name], node) if name in entries else node
    return replace(base, entries=entries) if base.entries else replace(base, entries=entries, file=over.file, key=over.key)


def settle(table: Table) -> Table:
    """Return the tree without values reset by ``"default"``."""
    entries: dict[str, Node] = {}
    for name, node in table.entries.items():
        if isinstance(node, Table):
            entries[name] = settle(node)
        elif node.value != DEFAULT or name in _TEXTS:
            entries[name] = node
    return replace(table, entries=entries)
