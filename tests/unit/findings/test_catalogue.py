"""The catalogue of findings, and the code that uses it."""

from __future__ import annotations

import ast
import re
import string
from pathlib import Path

import pytest
from each import each

import contourlab
from contourlab.app.json_values import json_values
from contourlab.figures import FACTORS
from contourlab.findings import SEVERITIES, catalogue, finding

SOURCE = Path(contourlab.__file__).parent
FIELDS = {code: {name: spec for _, name, spec, _ in string.Formatter().parse(entry.text) if name} for code, entry in catalogue().items()}


def made() -> list[tuple[str, str, set[str]]]:
    """Return the places that make each finding: file and line, code, names of its values (if literal)."""
    calls = []
    for file in sorted(SOURCE.rglob("*.py")):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "finding" and node.args:
                code = node.args[0]
                names = {word.arg for word in node.keywords if word.arg not in (None, "place")}
                starred = any(word.arg is None for word in node.keywords)
                if isinstance(code, ast.Constant):
                    calls.append((f"{file.relative_to(SOURCE)}:{node.lineno}", str(code.value), {"*"} if starred else names))
    return calls


@each("code", catalogue())
def test_an_entry_is_complete(code: str):
    entry = catalogue()[code]
    assert re.fullmatch(r"CL[1-9]\d\d", code)
    assert re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", entry.name)
    assert entry.severity in SEVERITIES
    assert entry.meaning
    assert entry.remedy
    assert set(FIELDS[code].values()) <= FACTORS.keys()


def test_names_are_unique():
    names = [entry.name for entry in catalogue().values()]
    assert len(set(names)) == len(names)


@pytest.mark.slow
def test_every_finding_in_the_code_has_its_entry_and_values():
    wrong = []
    for where, code, names in made():
        if code not in FIELDS or (names != {"*"} and names < set(FIELDS[code])):
            wrong.append((where, code, names))
    assert not wrong


def test_every_entry_is_used_somewhere():
    text = "\n".join(file.read_text(encoding="utf-8") for file in SOURCE.rglob("*.py"))
    assert catalogue().keys() - set(re.findall(r'"(CL\d{3})[" ]', text)) == set()


def test_every_fault_of_a_program_has_a_code():
    """It stands before the message; `ProgramError` takes it off."""
    without = []
    for file in sorted((SOURCE / "program").glob("*.py")):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in ("BlockError", "EndMarkError", "refuse"):
                texts = [part.value for part in ast.walk(node) if isinstance(part, ast.Constant) and isinstance(part.value, str)]
                if any(len(text) > 20 for text in texts) and not any(re.match(r"CL8[0-4]\d ", text) for text in texts):
                    without.append(f"{file.name}:{node.lineno}")
    assert without == []


def test_a_finding_in_print_and_in_json():
    late = finding("CL104", place="scheme a", time=2.0, end=0.5)
    assert json_values(late)["values"] == {"time": 2.0, "end": 0.5}
    assert json_values(late)["code"] == "CL104"
    assert "0.5 s" in late.text
    assert late.text.startswith("scheme a: ")
