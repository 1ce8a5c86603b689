"""``contourlab machines``: shipped files, the sources of their numbers, and copies of them."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import show, suggest

if TYPE_CHECKING:
    from contourlab.features.machines.command import Shipped

FOOT = (
    "contourlab machines NAME shows one; --copy FOLDER copies it with the files that it names. In a scenario write "
    'machine = "builtin:NAME"; contourlab run builtin:NAME runs a scenario.'
)


def machines(
    name: Annotated[str | None, typer.Argument(metavar="NAME", help="A shipped file, or your own.", show_default=False)] = None,
    copy: Annotated[
        Path | None, typer.Option(help="Copy it, and the files that it names, into this folder.", metavar="FOLDER", show_default=False)
    ] = None,
    force: Annotated[bool, typer.Option("--force", help="Overwrite existing files.")] = False,
    as_json: shared.Json = False,
) -> int:
    """List the shipped machines, axes, controllers and runs with the sources of their numbers; show or copy one."""
    from contourlab.features.machines.command import copy_shipped, shipped, shipped_one

    if copy is not None:
        if name is None:
            raise typer.BadParameter("name the file to copy", param_hint="--copy")
        written = copy_shipped(name, copy, force=force)
        show(written, "\n".join(f"wrote {file}" for file in written), as_json)
        suggest(as_json, "run" if shipped_one(name).kind == "scenario" else "machines", written[0])
        return 0
    if name is None:
        files = shipped()
        show(files, _list(files), as_json)
        suggest(as_json, "machines", "demo-part")
        return 0
    file = shipped_one(name)
    show(file, _details(file), as_json)
    own, scenario = str(file.file) == name, file.kind == "scenario"
    copied = ("machines",) if own else ("machines", name, "--copy", "mine")
    suggest(as_json, *(("run", name if own else f"builtin:{name}") if scenario else copied))
    return 0


def _list(files: list[Shipped]) -> str:
    from contourlab.rendering.table import Column, Table, paragraphs

    names, prose = ("kind", "name", "axes"), ("description", "sources")
    table = Table([*(Column(head, left=True) for head in names), *(Column(head, prose=True) for head in prose)])
    for file in files:
        table.add(file.kind, file.name, ", ".join(file.axes), file.about, "; ".join(file.references))
    return f"{table.text()}\n\n{paragraphs([FOOT])}"


def _details(file: Shipped) -> str:
    from contourlab.rendering.table import Column, Table

    axes = f" with the axes {', '.join(file.axes)}" if file.axes else ""
    shown = file.name if file.name == str(file.file) else f"builtin:{file.name}"
    head = [f"{shown}, {file.kind}{axes}", f"file: {file.file}"]
    if not file.numbers:
        return "\n".join([*head, "", file.text.rstrip()])
    sources = ", ".join(f"{count} {source}" for source, count in file.sources.items())
    plain = (Column("value"), *(Column(name, left=True) for name in ("unit", "source", "deviation")))
    table = Table([Column("number", left=True), *plain, Column("from", prose=True), Column("note", prose=True)])
    for number in file.numbers:
        table.add(number.name, number.value_text, number.display, number.source, number.deviation_text, number.reference, number.note)
    return "\n".join([*head, f"{file.about}.", f"numbers: {sources}", table.text()])
