"""The manifest of a store: what was studied, with a digest and checked types."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from contourlab.errors import ResultError
from contourlab.features.sweep.study import MOST
from contourlab.result import write_text_atomic

MANIFEST = "manifest.json"
SCHEMA, OLDER = "contourlab-sweep/2", "contourlab-sweep/1"
"""Form of a store, and the one before: its manifest had no digest, and the names of its files had the digest of their bytes alone."""
Count = Annotated[int, Field(ge=1, le=MOST)]


class _Strict(BaseModel):
    model_config = ConfigDict(strict=True, extra="forbid", allow_inf_nan=False)


class _Structure(_Strict):
    choices: dict[str, str | float]
    scenario: str


class _Manifest(_Strict):
    """Keys of a manifest, and their types."""

    form: Annotated[Literal["contourlab-sweep/1", "contourlab-sweep/2"], Field(alias="schema")]
    identity: Annotated[dict[Literal["program", "scenario", "study"], str], Field(min_length=3)]
    seed: int
    design: Literal["random", "sobol", "latin-hypercube", "saltelli", "grid", "list", "search"]
    variants: Count
    chunk: Count
    tolerance: float | None
    group: Count
    modules: dict[str, Count]
    columns: dict[str, str]
    figures: Annotated[dict[str, str], Field(min_length=1)]
    signals: list[str]
    study: str
    structures: Annotated[list[_Structure], Field(min_length=1)]
    digest: str | None = None


def digest(*parts: bytes) -> str:
    """Return a digest; only the last part may have line ends."""
    return hashlib.sha256(b"\n".join(parts)).hexdigest()[:16]


def content_of(fields: Mapping[str, Any]) -> bytes:
    """Return the bytes that a digest covers."""
    return json.dumps({key: value for key, value in fields.items() if key != "digest"}, sort_keys=True).encode()


def write_manifest(folder: Path, fields: Mapping[str, Any]) -> None:
    """Write a manifest with its digest.

    Raises
    ------
    OutputError
        If the folder cannot be written.
    """
    text = json.dumps({**fields, "digest": digest(content_of(fields))}, indent=1, allow_nan=False)
    write_text_atomic(folder / MANIFEST, text + "\n")


def read_manifest(folder: Path) -> dict[str, Any]:
    """Read a manifest; check its digest and the type of each value.

    Raises
    ------
    ResultError
        If there is none, or it is damaged or edited; gives file and key.
    """
    file, cure = folder / MANIFEST, "restore the file, or run the study into another folder"
    try:
        data = file.read_bytes()
        _Manifest.model_validate_json(data)
    except OSError as error:
        raise ResultError(f"{folder}: not a store of contourlab sweep: {MANIFEST} cannot be read") from error
    except ValidationError as error:
        fault = error.errors(include_url=False)[0]
        place = ".".join(map(str, fault["loc"]))
        raise ResultError(f"{file}: {place + ': ' if place else ''}{fault['msg']}: {cure}") from error
    fields: dict[str, Any] = json.loads(data)
    if fields["schema"] == SCHEMA and fields.get("digest") != digest(content_of(fields)):
        raise ResultError(f"{file}: was edited or is damaged: {cure}")
    return fields
