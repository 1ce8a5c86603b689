"""``contourlab explain``: what a finding means, and what to do about it."""

from __future__ import annotations

from typing import Annotated

import typer

from contourlab.cli import options as shared


def explain(
    code: Annotated[str | None, typer.Argument(metavar="[CODE]", help="Code of a finding, such as CL104. Without it, list all.")] = None,
    as_json: shared.Json = False,
) -> None:
    """Explain a finding: what it means, and what to do about it."""
    from contourlab.cli.output import emit_json, say, suggest
    from contourlab.errors import ParameterError
    from contourlab.findings import catalogue
    from contourlab.rendering.table import Column, Table, page_width, paragraphs

    entries = catalogue()
    code = f"CL{code}" if code is not None and code.isdigit() else code
    if code is not None and code.upper() not in entries:
        raise ParameterError("CODE", repr(code), "a code that `contourlab explain` lists")
    shown = list(entries.values()) if code is None else [entries[code.upper()]]
    if as_json:
        emit_json(shown)
    elif code is None:
        table = Table([Column("code", left=True), Column("severity", left=True), Column("name", left=True), Column("text", prose=True)])
        for entry in shown:
            table.add(entry.code, entry.severity, entry.name, entry.outline)
        say(table.text())
        suggest(as_json, "explain", shown[0].code)
    else:
        entry = shown[0]
        texts = [f"{entry.code} {entry.name} ({entry.severity})", entry.outline, entry.meaning, f"What to do: {entry.remedy}"]
        say("\n\n".join(paragraphs([text], page_width(), indent="") for text in texts))
