"""What made a file: one line of text, the same in files of every kind, without a date, so that the same run gives the same bytes."""

from __future__ import annotations

import json
import platform
import re
from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from contextvars import ContextVar
from dataclasses import fields, is_dataclass
from functools import cache
from importlib.metadata import version
from os import PathLike
from pathlib import Path, PurePath
from typing import Any, TypeVar

from contourlab.errors import ResultError, error_text
from contourlab.result.record import digest

MARK = "made by contourlab"
_WORDS = re.compile(r"made by contourlab (\d[\w.+-]*)((?: [a-z]+=[\w.,+-]+)*);")
_now: ContextVar[str] = ContextVar("stamp", default="")
_told: ContextVar[list[Any]] = ContextVar("told")
ValueT = TypeVar("ValueT")


def stamp(**parts: str) -> str:
    """Return the line that says what made a file, with the versions of contourlab, Python, NumPy, SciPy and Numba.

    Parameters
    ----------
    **parts : str
        Digests of `identity`: ``machine``, ``controller``, ``program``; and ``cites``, keys of references. Empty ones are left out.

    >>> stamp(machine="0123456789abcdef", program="").split()[3::5]
    ['0.1.0', 'machine=0123456789abcdef;']
    """
    said = {**_libraries(), **parts}
    return f"{MARK} {said.pop('contourlab')}{''.join(f' {key}={text}' for key, text in said.items() if text)};"


@cache
def _libraries() -> dict[str, str]:
    return {"python": platform.python_version(), **{name: version(name) for name in ("contourlab", "numpy", "scipy", "numba")}}


def identity(*values: Any) -> str:
    """Return a digest of values: of all that comparisons see, so neither of sources nor of the files that they come from."""
    return digest(json.dumps({"": values}, default=_plain, sort_keys=True).encode())


def _plain(value: Any) -> Any:
    """Return what JSON holds of a value that it does not know."""
    if hasattr(value, "family"):  # a component
        return [value.family, value.kind, value.values()]
    if is_dataclass(value) and not isinstance(value, type):
        return [type(value).__name__, {each.name: _keyed(getattr(value, each.name)) for each in fields(value) if each.compare}]
    if isinstance(value, Mapping):
        return _keyed(value)
    return value.name if isinstance(value, PurePath) else value.tolist() if hasattr(value, "tolist") else repr(value)


def _keyed(value: Any) -> Any:
    """Return a mapping with texts as its keys, which may be pairs of axes; any other value as it is."""
    return {str(key): item for key, item in value.items()} if isinstance(value, Mapping) else value


@contextmanager
def _during(variable: ContextVar[ValueT], value: ValueT) -> Iterator[ValueT]:
    token = variable.set(value)
    try:
        yield value
    finally:
        variable.reset(token)


def gathered() -> AbstractContextManager[list[Any]]:
    """Gather what `tell` is given inside: the scenarios, machines and programs of a question."""
    return _during(_told, [])


def stamped(text: str) -> AbstractContextManager[str]:
    """Let all files that are written inside say `text`."""
    return _during(_now, text)


def tell(value: ValueT) -> ValueT:
    """Tell what the question being asked is about; return it."""
    if (told := _told.get(None)) is not None:
        told.append(value)
    return value


def current(other: object = None) -> str:
    """Return the stamp of the files that are being written: `other` where none is set, else that of contourlab alone."""
    return _now.get() or str(other or stamp())


def read_stamp(file: str | PathLike[str]) -> dict[str, str]:
    """Return what made a file: ``contourlab`` and libraries with their versions, and the digests of `stamp`.

    Raises
    ------
    ResultError
        If the file cannot be read, or says nothing.
    """
    try:
        content = Path(file).read_bytes()
    except (OSError, ValueError) as error:
        raise ResultError(f"{file}: cannot be read: {error_text(error)}") from error
    return parse_stamp(content.decode("latin-1"), file)


def parse_stamp(text: str, file: object = "<text>") -> dict[str, str]:
    """Return what a text says that made it, as `read_stamp`; `file` is named in the error."""
    found = _WORDS.search(text)
    if found is None:
        raise ResultError(f"{file}: does not say what made it, as files of contourlab do")
    return {"contourlab": found[1], **dict(word.split("=", 1) for word in found[2].split())}
