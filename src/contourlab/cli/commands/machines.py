"""``contourlab machines``: what is shipped, where its numbers are from, and copies to start from."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from contourlab.cli.output import emit_json, say, show
from contourlab.cli.scheme_options import Json

if TYPE_CHECKING:
    from contourlab.features.machines.command import Shipped

FOOT = (
    "contourlab machines NAME tells all of one, --copy FOLDER copies it with the files that it names. In a scenario: "
    'machine = "builtin:NAME"; contourlab run builtin:NAME runs a scenario.'
)


def machines(
    name: Annotated[str | None, typer.Argument(metavar="NAME", help="One of them, as ghaffari/a3a1.", show_default=False)] = None,
    copy: Annotated[
        Path | None, typer.Option(help="Copy it into this folder, with the files that it names.", metavar="FOLDER", show_default=False)
    ] = None,
    force: Annotated[bool, typer.Option("--force", help="Overwrite files that are there.")] = False,
    as_json: Json = False,
) -> int:
    """List the shipped machines, axes, controllers and runs with where their numbers are from; show or copy one."""
    from contourlab.features.machines.command import copy_shipped, shipped, shipped_one

    if copy is not None:
        if name is None:
            raise typer.BadParameter("wants the name of what is to be copied", param_hint="--copy")
        written = copy_shipped(name, copy, force=force)
        if as_json:
            emit_json([str(file) for file in written])
        else:
            say("\n".join(f"wrote {file}" for file in written))
        return 0
    if name is None:
        found = shipped()
        if as_json:
            emit_json([one.as_dict() for one in found])
        else:
            _list(found)
        return 0
    one = shipped_one(name)
    if as_json:
        emit_json(one.as_dict() | {"text": one.file.read_text(encoding="utf-8")})
    else:
        _details(one)
    return 0


def _list(found: list[Shipped]) -> None:
    from rich.table import Table
    from rich.text import Text

    table = Table("what", "name", "axes", "what it is", "numbers are from")
    last = ""
    for one in found:
        if last and one.kind != last:
            table.add_section()
        cells = (one.kind if one.kind != last else "", one.name, ", ".join(one.axes), one.about, "; ".join(one.references))
        table.add_row(*(Text(cell) for cell in cells))
        last = one.kind
    show(table, FOOT)


def _details(one: Shipped) -> None:
    from rich.table import Table
    from rich.text import Text

    head = [f"builtin:{one.name}, {one.kind}" + (f" with the axes {', '.join(one.axes)}" if one.axes else ""), f"file: {one.file}"]
    if not one.numbers:
        say("\n".join([*head, "", one.file.read_text(encoding="utf-8").rstrip()]))
        return
    said = ", ".join(f"{count} {source}" for source, count in one.sources.items())
    table = Table("number", "value", "unit", "source", "deviation", "from", "note")
    for number in one.numbers:
        cells = (number.value_text, number.display, number.source, number.deviation_text, number.reference, number.note)
        table.add_row(*map(Text, (number.name, *cells)))
    show(Text("\n".join([*head, f"{one.about}.", f"numbers: {said}"])), table)
