"""Write the generated pages findings.md and json.md. ``make check`` fails if one is out of date."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from contourlab.app.json_schema import json_schema
from contourlab.cli.commands.schema import results
from contourlab.findings import catalogue

HERE = Path(__file__).parent
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
        rows = [f"| `{key}` | {_form(value)} | {_plain(value.get('description', ''))} |" for key, value in schema["properties"].items()]
        parts.append("\n".join([f"\n## {name}\n\n{_plain(schema['description'])}\n", "| key | value | meaning |\n|---|---|---|", *rows]))
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


def _plain(text: str) -> str:
    """Escape characters that Markdown takes for markup."""
    return " ".join(text.replace("|", "\\|").replace("``", "`").replace("<", "&lt;").replace("_", "\\_").replace("*", "\\*").split())


PAGES = {HERE / "reference" / "findings.md": findings_page, HERE / "reference" / "json.md": json_page}

if __name__ == "__main__":
    for file, page in PAGES.items():
        file.write_text(page(), encoding="utf-8")
