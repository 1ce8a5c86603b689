"""JSON Schema (draft 2020-12) of results, derived from their types by the rules of `contourlab.app.json_values`."""

from __future__ import annotations

import inspect
import re
from collections.abc import Collection, Mapping
from dataclasses import is_dataclass
from pathlib import Path
from types import NoneType, UnionType
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints, is_typeddict

import numpy as np

from contourlab.app.json_values import json_keys
from contourlab.findings import SEVERITIES, Finding

_SIMPLE: dict[Any, Any] = {
    float: ["number", "null"],  # null: not finite
    int: "integer", bool: "boolean", str: "string", Path: "string", NoneType: "null", np.ndarray: "array",
}  # fmt: skip
_Definitions = dict[str, tuple[type, dict[str, Any]]]
_FIELDS = re.compile(r"^(\w[\w, ]*) : (.*)\n((?:[ ]{4}.*\n?|\n)*)", re.MULTILINE)
_FINDING = {
    "type": "object",
    "description": "A remark, a warning or an error; `contourlab explain CODE` explains it.",
    "properties": {
        "code": {"type": "string"},
        "name": {"type": "string"},
        "severity": {"enum": list(SEVERITIES)},
        "place": {"type": "string", "description": "What it is about; empty for the whole."},
        "values": {"type": "object", "description": "In SI."},
        "text": {"type": "string"},
    },
    "required": ["code", "name", "severity", "place", "values", "text"],
}


def json_schema(result: Any, title: str = "") -> dict[str, Any]:
    """Return the JSON Schema of a type's values as `json_values` gives them.

    Later versions may add keys, so the schema permits others.

    Parameters
    ----------
    result : type
        A dataclass or TypedDict, or a union or collection of these.
    title : str

    Raises
    ------
    TypeError
        If the type has no form in JSON.
    """
    definitions: _Definitions = {}
    schema = _schema(result, definitions)
    named = {name: definition for name, (_, definition) in sorted(definitions.items())}
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": title, **schema, "$defs": named}


def _schema(kind: Any, definitions: _Definitions) -> dict[str, Any]:
    origin, arguments = get_origin(kind) or kind, get_args(kind)
    if hasattr(origin, "__value__"):  # an alias, which NumPy's arrays are from 2.5 on
        origin = get_origin(origin.__value__)
    if kind is Any:
        return {}
    if origin is Literal:
        return {"enum": list(arguments)}
    if origin in (Union, UnionType):
        return _union([_schema(item, definitions) for item in arguments])
    if origin in _SIMPLE:
        return {"type": _SIMPLE[origin]}
    if is_typeddict(origin) or (isinstance(origin, type) and is_dataclass(origin)):
        return {"$ref": f"#/$defs/{_define(origin, definitions)}"}
    if not isinstance(origin, type) or not issubclass(origin, Collection):
        raise TypeError(f"{kind} has no JSON Schema")
    if issubclass(origin, Mapping):
        return {"type": "object", "additionalProperties": _schema(arguments[1], definitions)}
    if hasattr(origin, "_fields"):
        arguments = tuple(get_type_hints(origin).values())
    elif not issubclass(origin, tuple) or arguments[1:] == (...,):
        return {"type": "array", "items": _schema(arguments[0], definitions)}
    count = len(arguments)
    return {"type": "array", "prefixItems": [_schema(item, definitions) for item in arguments], "minItems": count, "maxItems": count}


def _define(kind: type, definitions: _Definitions) -> str:
    """Add the definition of a dataclass if missing, and return its name, prefixed by its module if another class has the same name."""
    name = kind.__name__
    if name in definitions and definitions[name][0] is not kind:
        name = f"{kind.__module__.rpartition('.')[2]}.{name}"
    if name not in definitions:
        definitions[name] = (kind, {})  # ends the recursion for a type that contains itself
        definitions[name] = (kind, _FINDING if kind is Finding else _object(kind, definitions))
    return name


def _union(schemas: list[dict[str, Any]]) -> dict[str, Any]:
    if {} in schemas:
        return {}
    if any(set(schema) != {"type"} for schema in schemas):
        return {"anyOf": schemas}
    names = dict.fromkeys(name for schema in schemas for name in np.atleast_1d(schema["type"]).tolist())
    return {"type": list(names)}


def _object(kind: type, definitions: _Definitions) -> dict[str, Any]:
    text = inspect.getdoc(kind) or ""
    about = {}
    for names, form, lines in _FIELDS.findall(text + "\n"):
        unit = re.search(r"\[[^\]]*\]", form)
        about.update(dict.fromkeys(names.split(", "), " ".join([*lines.split(), *([unit[0]] if unit else [])])))
    properties = {}
    keys = {name: (name, hint) for name, hint in get_type_hints(kind).items()} if is_typeddict(kind) else json_keys(kind)
    for key, (name, hint) in keys.items():
        description = about.get(name) or about.get(key) or _derived(kind, name)
        properties[key] = _schema(hint, definitions) | ({"description": description} if description else {})
    summary = " ".join(text.split("\n\n")[0].split())
    return {"type": "object", "description": summary, "properties": properties, "required": list(properties)}


def _derived(kind: type, name: str) -> str:
    """Return the help of an option, or the first paragraph of a property's docstring."""
    if name in getattr(kind, "PARTS", {}):
        return str(kind.PARTS[name].option.help)  # type: ignore[attr-defined]
    value = getattr(kind, name, None)
    return " ".join((inspect.getdoc(value) or "").split("\n\n")[0].split()) if isinstance(value, property) else ""
