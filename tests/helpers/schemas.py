"""Check results against the JSON Schemas of their commands."""

from __future__ import annotations

import sys
from functools import cache
from typing import Any

import pytest

import contourlab.cli.main as main
from contourlab.app.json_schema import json_schema
from contourlab.app.json_values import json_text, json_values
from contourlab.cli.look_up import results

sys.modules.setdefault("rfc3987_syntax", None)  # type: ignore[arg-type]
"""jsonschema would import it, which takes 0.9 s, for a format that no schema here has."""


@cache
def validator(command: str) -> Any:
    """Return the validator of a command's result; unlike the published schema, it rejects keys that the schema lacks."""
    from jsonschema import Draft202012Validator

    return Draft202012Validator(_closed(json_schema(results()[command])))


_typed = [""]
"""The command that runs; empty for a question asked in Python."""


def checked(result: Any) -> str:
    """Return a result as JSON, and check it. A module that is first imported during a test keeps this function."""
    if _typed[0]:
        problems = [f"{error.json_path}: {error.message[:300]}" for error in validator(_typed[0]).iter_errors(json_values(result))]
        assert not problems, problems
    return json_text(result)


def check_results(monkeypatch: pytest.MonkeyPatch) -> None:
    """Check everything that commands print with --json against their schemas."""
    call = main._call

    def named_call(words: list[str]) -> int:
        _typed[:] = words[:1]
        try:
            return call(words)
        finally:
            _typed[:] = [""]

    monkeypatch.setattr(main, "_call", named_call)
    monkeypatch.setattr("contourlab.app.json_values.json_text", checked)


def _closed(schema: Any) -> Any:
    if isinstance(schema, list):
        return [_closed(item) for item in schema]
    if not isinstance(schema, dict):
        return schema
    closed = {key: _closed(value) for key, value in schema.items()}
    return closed | {"additionalProperties": False} if isinstance(schema.get("properties"), dict) and "type" in schema else closed
