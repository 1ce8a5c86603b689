"""Results as JSON: one serialiser for all commands."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from operator import attrgetter
from typing import Any, get_type_hints

from contourlab.findings import Finding

HIDDEN: Mapping[str, Any] = {"json": False}
"""Metadata of a field that JSON leaves out."""


def json_text(value: Any) -> str:
    """Return a value as strict JSON, without NaN or infinity; see `json_values`."""
    return json.dumps(json_values(value), indent=2, allow_nan=False)


def signed(text: str) -> str:
    """Return the text of a JSON object with the key ``made_by``; of another value, the text itself."""
    from contourlab.result.stamp import current  # would double the start of every command

    return f'{text[:-2]},\n  "made_by": "{current()}"\n}}' if text.startswith("{\n") else text


def write_json(file: str | os.PathLike[str], value: Any) -> None:
    """Write a value as a JSON file, whole or not at all; see `json_values`."""
    from contourlab.result import write_text_atomic  # would double the start of every command

    write_text_atomic(os.fspath(file), signed(json_text(value)) + "\n")


def json_values(value: Any) -> Any:
    """Return a value that JSON can hold.

    Dataclasses become objects, see `json_keys`. Findings become objects of code, name, severity, place, values and text. NumPy numbers
    become Python numbers. nan and infinities become null.

    >>> json_values({"gain": float("inf"), "axes": ("x", "y")})
    {'gain': None, 'axes': ['x', 'y']}
    """
    if isinstance(value, Finding):
        entry = value.entry
        return {
            "code": value.code,
            "name": entry.name,
            "severity": entry.severity,
            "place": value.place,
            "values": json_values(value.values),
            "text": value.text,
        }
    if is_dataclass(value) and not isinstance(value, type):
        return {key: json_values(attrgetter(path)(value)) for key, path in _paths(type(value)).items()}
    if isinstance(value, Mapping):
        return {str(key): json_values(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [json_values(item) for item in value]
    if isinstance(value, set | frozenset):
        return sorted(json_values(item) for item in value)
    if hasattr(value, "tolist"):
        return json_values(value.tolist())
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if value is None or isinstance(value, str | bool | int):
        return value
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError(f"{type(value).__name__} cannot be written as JSON: {value!r}")


@cache
def _paths(kind: type) -> dict[str, str]:
    """Return the JSON keys of a dataclass, each with its attribute, which may be one of an attribute: ``result.axes``."""
    if "json_form" in vars(kind):
        return dict(vars(kind)["json_form"])
    derived = getattr(kind, "json_derived", {})
    derived = derived if isinstance(derived, dict) else {name: name for name in derived}
    keys = {part.name: part.metadata.get("json", part.name) for part in fields(kind)}
    return {key: name for name, key in keys.items() if key} | derived


def json_keys(kind: type) -> dict[str, tuple[str, Any]]:
    """Return the JSON keys of a dataclass, each with its attribute and type.

    Keys are the names of the fields, except those marked ``field(metadata={"json": False})``; the metadata may also give another name. Then
    follow the properties in the class variable ``json_derived``: a sequence of names, or a mapping of keys to names. The class variable
    ``json_form``, a mapping of keys to attributes, replaces both; it may name attributes of attributes, as ``result.axes``.
    """
    return {key: (path.split(".")[-1], _type_at(kind, path)) for key, path in _paths(kind).items()}


def _type_at(kind: Any, path: str) -> Any:
    """Return the type of an attribute, or of an attribute's attribute."""
    for name in path.split("."):
        part = getattr(kind, name, None)
        kind = get_type_hints(part.fget)["return"] if isinstance(part, property) else get_type_hints(kind)[name]
    return kind
