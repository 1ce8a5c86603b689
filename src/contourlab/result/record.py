"""Records: files of ours that are read back, each with a digest; the type of each value is checked."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict, is_dataclass
from pathlib import Path
from types import NoneType, UnionType
from typing import Any, TypeVar, Union, get_args, get_origin, get_type_hints

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ResultError, error_text, refuse
from contourlab.result.atomic import write_text_atomic

RecordT = TypeVar("RecordT")


def digest(*parts: bytes) -> str:
    """Return a digest; only the last part may have line ends."""
    return hashlib.sha256(b"\n".join(parts)).hexdigest()[:16]


def covered(fields: Mapping[str, Any]) -> bytes:
    """Return the bytes that the digest of a record covers."""
    return json.dumps(fields, sort_keys=True).encode()


def write_record(file: Path, record: Any) -> None:
    """Write the fields of a dataclass and a digest of them; its field ``schema`` holds form and version.

    Raises
    ------
    OutputError
        If the file cannot be written.
    """
    fields = asdict(record)
    write_text_atomic(file, json.dumps({**fields, "digest": digest(covered(fields))}, indent=1, allow_nan=False) + "\n")


def read_record(file: Path, kind: type[RecordT], cure: str, older: str = "") -> RecordT:
    """Read what `write_record` wrote; check the digest and the type of each value. The form `older` has no digest.

    Raises
    ------
    ResultError
        If the file is not there, damaged or edited; gives file and key.
    """
    try:
        fields = json.loads(file.read_bytes(), parse_constant=_refused)
        seal = fields.pop("digest", None) if isinstance(fields, dict) else None
        record: RecordT = typed(fields, kind)
        refuse(fields["schema"] != older and seal != digest(covered(fields)), ValueError, "was edited or is damaged")
    except (OSError, ValueError, ArithmeticError, RecursionError) as error:
        raise ResultError(f"{file}: {error_text(error)}: {cure}") from error
    return record


def _refused(word: str) -> None:
    raise ValueError(f"{word} is not a number of JSON")


def typed(value: Any, kind: Any, place: str = "") -> Any:
    """Return a value of JSON as one of a type: a dataclass, a dict, a list, a tuple of any length, or plain types; an array stays.

    Raises
    ------
    ValueError
        If it is not of this type; gives the key.
    """
    origin, inner = get_origin(kind), get_args(kind)
    if hasattr(origin, "__value__"):  # an alias, which NumPy's arrays are from 2.5 on
        origin = get_origin(origin.__value__)
    if origin in (Union, UnionType) and value is not None:
        kind = next((each for each in inner if each is not NoneType and (each is type(value) or is_dataclass(each))), float)
    if isinstance(kind, type) and is_dataclass(kind):
        hints = get_type_hints(kind)
        if type(value) is dict:
            if wrong := sorted(value.keys() ^ hints.keys()):
                raise ValueError(f"{place}{', '.join(wrong)}: is missing or unknown")
            return kind(**{name: typed(value[name], hint, f"{place}{name}: ") for name, hint in hints.items()})
    elif origin is dict and type(value) is dict:
        return {key: typed(item, inner[1], f"{place}{key}: ") for key, item in value.items()}
    elif origin in (list, tuple) and type(value) is list:
        return origin(typed(item, inner[0], place) for item in value)
    elif type(value) in (kind, origin) or (value is None and NoneType in inner):
        return value
    elif type(value) is int and float in (kind, *inner):
        return float(value)
    raise ValueError(f"{place}is not what was written")


def packed(record: Any) -> dict[str, NDArray[Any]]:
    """Return a dataclass, which may hold arrays, as the arrays of a piece of a `Checkpoint`."""
    arrays: dict[str, NDArray[Any]] = {}

    def named(array: NDArray[Any]) -> dict[str, str]:
        refuse(array.ndim == 0, TypeError, f"{array!r}: must be a number of Python")
        arrays[name := str(len(arrays))] = array
        return {"array": name}

    return {"about": np.array(json.dumps(asdict(record), default=named)), **arrays}


def unpacked(arrays: Mapping[str, NDArray[Any]], kind: type[RecordT]) -> RecordT:
    """Return what `packed` took; ValueError or KeyError if it is of another type."""
    held = json.loads(str(arrays["about"]), object_hook=lambda value: arrays[value["array"]] if value.keys() == {"array"} else value)
    return typed(held, kind)  # type: ignore[no-any-return]
