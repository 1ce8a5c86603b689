"""Whole programs as files in ``whole``: what is typed, the files that it names, its exit code, lines on standard error, and the JSON."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from typed_commands import invoke

CASES = sorted((Path(__file__).parent / "whole").glob("*.toml"))


def wrong(found: Any, wanted: Any, place: str = "") -> Iterator[str]:
    """Yield where an output lacks something that is wanted; keys that are not named may be anything."""
    if isinstance(wanted, dict) and wanted.keys() == {"least", "most"}:
        if not wanted["least"] <= found <= wanted["most"]:
            yield f"{place} = {found}"
    elif isinstance(wanted, dict):
        for key, value in wanted.items():
            yield from wrong(found[key], value, f"{place}.{key}") if key in found else [f"{place}.{key} is missing"]
    elif isinstance(wanted, list):
        if len(found) != len(wanted):
            yield f"{place} has {len(found)} items: {found}"
        for k, (one, other) in enumerate(zip(found, wanted, strict=False)):
            yield from wrong(one, other, f"{place}[{k}]")
    elif found != (pytest.approx(wanted, rel=1e-9, abs=1e-12) if isinstance(wanted, float) else wanted):
        yield f"{place} = {found}"


def codes_in(found: Any) -> set[str]:
    """Return the codes of all findings of an output."""
    if isinstance(found, dict):
        here = {one["code"] for one in found.get("findings", ())}
        return here.union(*map(codes_in, found.values()))
    return set().union(*map(codes_in, found)) if isinstance(found, list) else set()


@pytest.mark.parametrize("file", CASES, ids=lambda file: file.stem)
def test_a_whole_program(file: Path, tmp_path: Path) -> None:
    case = tomllib.loads(file.read_text(encoding="utf-8"))
    assert case.keys() <= {"words", "exit_code", "error_lines", "codes", "files", "expected"}
    for name, text in case["files"].items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    said = invoke(tmp_path, *case["words"], "--json")
    assert (said.code, len(said.err.splitlines())) == (case.get("exit_code", 0), case.get("error_lines", 0)), said
    found = json.loads(said.out)
    assert list(wrong(found, case["expected"])) == []
    if "codes" in case:
        assert codes_in(found) == set(case["codes"])
