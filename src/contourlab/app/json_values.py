"""Results as JSON: one serialiser for all commands."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from typing import Any

from contourlab.findings import Finding


def json_values(value: Any) -> Any:
    """Return a value that JSON can hold.

    Dataclasses become objects with their fields as keys, without those marked ``field(metadata={"json": False})`` and with the properties
    that the class names in ``json_derived``. Findings become their code, name, severity, place, values and text; numbers of NumPy become
    Python's; nan and infinities become null.

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
        names = [part.name for part in fields(value) if part.metadata.get("json", True)]
        return {name: json_values(getattr(value, name)) for name in (*names, *getattr(value, "json_derived", ()))}
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
    raise TypeError(f"{type(value).__name__} has no form in JSON: {value!r}")
