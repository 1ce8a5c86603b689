"""Write the pages that are made from the code, when the site is built."""

from __future__ import annotations

import os.path
import re
import shutil
from itertools import groupby
from pathlib import Path
from typing import Any

import typer
from api import api_page
from keys import keys_page
from markup import plain
from ports import ports_page

from contourlab.app.json_schema import json_schema
from contourlab.cli.look_up import results
from contourlab.cli.main import root
from contourlab.cli.parse import PANEL_OF
from contourlab.components.contract import Component
from contourlab.components.registry import components
from contourlab.features.components.description import describe, parameter_cells
from contourlab.findings import catalogue

HERE = Path(__file__).resolve().parent
LINK = re.compile(r"(\]\()([^)\s#:]+)(?=[)#])")
FINDINGS = """\
# Findings

Every remark, warning and conclusion of contourlab about a result has a code. `contourlab explain CODE` shows an entry of this page.
"""
JSON = """\
# Results as JSON

`--json` prints the result of a command as one JSON document. Commands that write a folder keep it there as `summary.json`, `swap` as
`swap.json`. `contourlab schema COMMAND` prints the JSON Schema, from which this page is made.

Numbers are in SI units (m, s, rad); `null` means a non-finite number, or no value. Later versions may add keys.
"""
COMPONENTS = """\
# Components

The parts of a machine and its controllers. In a file a table names the `kind` and its parameters:
`friction = {kind = "coulomb", coulomb = "20 N"}` ([scenario files](scenario-files.md)). *command* and *force* stand for the plant's own
units. `contourlab components NAME` prints an entry of this page.
"""
COMMANDS = """\
# Commands

`contourlab COMMAND --help` prints an entry of this page. Exit codes: 0 done, 1 verdict failed, 2 bad input, 3 the loop diverged, 70 a
fault in contourlab, 130 interrupted.
"""
BAR = "\\"


def findings_page() -> str:
    """Return the page of all findings."""
    parts = [FINDINGS]
    for entry in catalogue().values():
        text = f"*{entry.severity}*: {re.sub('[<>]', '*', entry.outline)}"
        parts.append(f"## {entry.code} {entry.name}\n\n{text}\n\n{entry.meaning}\n\nWhat to do: {entry.remedy}\n")
    return "\n".join(parts)


def json_page() -> str:
    """Return the page of all results: first what each command prints, then each object once."""
    parts, objects = [JSON, "| command | prints |\n|---|---|"], {}
    for command, result in sorted(results().items()):
        schema = json_schema(result)
        objects |= schema["$defs"]
        parts[1] += f"\n| `{command}` | {_form(schema)} |"
    for name, schema in sorted(objects.items()):
        rows = [f"| `{key}` | {_form(value)} | {plain(value.get('description', ''))} |" for key, value in schema["properties"].items()]
        parts.append("\n".join([f"\n## {name}\n\n{plain(schema['description'])}\n", "| key | value | meaning |\n|---|---|---|", *rows]))
    return "\n".join(parts) + "\n"


def _form(schema: dict[str, Any]) -> str:
    """Describe the type of a value."""
    if "$ref" in schema:
        name = schema["$ref"].rpartition("/")[2]
        return f"[{name}](#{name.lower().replace('.', '')})"
    if "anyOf" in schema:
        return " or ".join(map(_form, schema["anyOf"]))
    if "enum" in schema:
        return ", ".join(f"`{value}`" for value in schema["enum"])
    if "items" in schema:
        return f"list of {_form(schema['items'])}"
    if "prefixItems" in schema:
        return f"[{', '.join(map(_form, schema['prefixItems']))}]"
    if isinstance(schema.get("additionalProperties"), dict):
        return f"object: name to {_form(schema['additionalProperties'])}"
    kinds = schema.get("type", "any")
    if kinds == ["number", "null"]:
        return "number"
    return kinds if isinstance(kinds, str) else " or ".join(kinds)


def components_page() -> str:
    """Return the page of all components by family, with their parameters."""
    parts = [COMPONENTS]
    for family, kinds in groupby(components(), key=lambda kind: kind.family):
        parts.append(f"## {family}\n")
        parts += [_component(kind) for kind in kinds]
    return "\n".join(parts)


def _component(kind: type[Component]) -> str:
    about = describe(kind)
    lines = [f"### {kind.kind}\n\n{plain(about.doc)}\n"]
    if about.reference:
        lines.append(f"Source: {plain(about.reference)}.\n")
    for head, parameters in (("parameter", about.parameters), ("`gains`", about.gains)):
        if parameters:
            rows = [["`" + parameter.name + "`", *map(plain, parameter_cells(parameter))] for parameter in parameters]
            lines.append(_table([head, "unit", "bounds", "default", "meaning", "source"], rows))
    return "\n".join(lines)


def commands_page() -> str:
    """Return the page of all commands, grouped as ``contourlab --help`` groups them."""
    parts, panels = [COMMANDS], {}
    for name, sub in root().whole().items():
        panels.setdefault(PANEL_OF[name], []).append((name, sub))
    for panel, members in panels.items():
        parts.append(f"## {panel}\n")
        parts += [_command(name, sub) for name, sub in members]
    return "\n".join(parts)


def _command(name: str, command: Any) -> str:
    context = typer.Context(command, info_name=f"contourlab {name}")
    usage = command.get_usage(context).removeprefix("Usage: ")
    lines = [f"### {name}\n\n{plain(command.help)}\n\n```text\n{' '.join(usage.split())}\n```\n"]
    records = [record for parameter in command.params if (record := parameter.get_help_record(context))]
    if records:
        rows = [[f"`{names.replace('|', BAR + '|')}`", plain(text.replace(BAR + "[", "["))] for names, text in records]
        lines.append(_table(["option", "meaning"], rows))
    members = command.whole().items() if hasattr(command, "whole") else ()
    return "\n".join([*lines, *(_command(f"{name} {sub}", member).replace("### ", "#### ", 1) for sub, member in members)])


def _table(head: list[str], rows: list[list[str]]) -> str:
    """Return a Markdown table without its empty columns."""
    kept = [n for n in range(len(head)) if any(row[n] for row in rows)]
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(line[n] for n in kept)} |" for line in lines) + "\n"


def relinked(text: str, file: Path, page: Path) -> str:
    """Return the text of a file as that of a page elsewhere, with its relative links changed, and those to copied files."""

    def link(found: re.Match[str]) -> str:
        goal = (file.parent / found[2]).resolve()
        return found[1] + os.path.relpath(COPIED.get(goal, goal), page.parent)

    return LINK.sub(link, text)


COPIED = {
    HERE.parent / name: HERE / "development" / page
    for name, page in (("CONTRIBUTING.md", "contributing.md"), ("CHANGELOG.md", "changelog.md"), ("benchmarks/README.md", "benchmarks.md"))
}
"""Files outside of this folder that are pages of the site."""
PORTS = HERE / "reference" / "ports.md"
"""The one generated page that is committed, because CONTRIBUTING sends readers of the repository there."""
PAGES = {
    HERE / "reference" / "findings.md": findings_page,
    HERE / "reference" / "json.md": json_page,
    HERE / "reference" / "components.md": components_page,
    HERE / "reference" / "keys.md": keys_page,
    PORTS: ports_page,
    HERE / "reference" / "commands.md": commands_page,
    HERE / "reference" / "api.md": api_page,
    **{page: lambda file=file, page=page: relinked(file.read_text("utf-8"), file, page) for file, page in COPIED.items()},
}


def write() -> None:
    """Write the pages that changed, and remove those whose source is gone."""
    shutil.rmtree(HERE / "reference" / "api", ignore_errors=True)
    for page in (HERE / "examples").glob("*.rst"):
        if page.stem != "index" and not (HERE.parent / "examples" / f"{page.stem}.py").exists():
            page.unlink()
    for file, content in PAGES.items():
        text = content()
        if not file.exists() or file.read_text("utf-8") != text:
            file.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    write()
