"""Write TOML, which the standard library only reads."""

from __future__ import annotations

import json
import math
import re
import textwrap
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

BARE = re.compile(r"[A-Za-z0-9_-]+\Z")
_WIDTH = 80


@dataclass(frozen=True)
class Noted:
    """A value with a comment, which comparisons ignore."""

    value: Any
    note: str = field(default="", compare=False)


def _text(value: str) -> str:
    # TOML escapes like JSON, but escapes DEL too.
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def _key(name: str) -> str:
    return name if BARE.match(name) else _text(name)


def _number(value: float) -> str:
    if not math.isfinite(value):
        raise ValueError(f"{value!r}: TOML files hold finite numbers only")
    text = repr(value)
    return text if "." in text or "e" in text else text + ".0"


def _inline(value: Any) -> str:
    if isinstance(value, Noted):
        return _inline(value.value)
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, int):
        return json.dumps(value)
    if isinstance(value, float):
        return _number(value)
    if isinstance(value, list | tuple):
        items = [_inline(item) for item in value]
        line = f"[{', '.join(items)}]"
        return line if len(line) <= _WIDTH else "[\n" + "".join(f"    {item},\n" for item in items) + "]"
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_key(k)} = {_inline(v)}" for k, v in value.items()) + "}"
    raise TypeError(f"TOML has no {type(value).__name__}")


def toml(content: Mapping[str, Any]) -> str:
    """Return a mapping as TOML text.

    Parameters
    ----------
    content : mapping
        Text, numbers, booleans, lists, and mappings for tables; any of them `Noted`.

    Raises
    ------
    ValueError
        If a number is not finite.

    >>> print(toml({"name": "stage", "axes": {"x": {"gain": 2.0}}}), end="")
    name = "stage"
    <BLANKLINE>
    [axes.x]
    gain = 2.0
    """
    return "\n\n".join([block for block in _blocks(content, ()) if block]) + "\n"


def _blocks(table: Mapping[str, Any], place: tuple[str, ...]) -> list[str]:
    """Return the text of a table and of the tables below it."""
    lines, below = [], []
    for name, value in table.items():
        if isinstance(value, Mapping):
            below += _blocks(value, (*place, name))
            continue
        lines += _noted(f"{_key(name)} = {_inline(value)}", value.note if isinstance(value, Noted) else "")
    # A table that only holds tables needs no header.
    if place and (lines or not table):
        lines.insert(0, "[" + ".".join(_key(name) for name in place) + "]")
    return ["\n".join(lines), *below]


def _noted(line: str, note: str) -> list[str]:
    """Return a line with its comment behind it, or above it if both do not fit."""
    comment = f"  # {' '.join(note.split())}" if note else ""
    if not comment or len(line.rpartition("\n")[2] + comment) <= _WIDTH:
        return [line + comment]
    return [*textwrap.wrap(note, _WIDTH, initial_indent="# ", subsequent_indent="# ", break_long_words=False), line]
