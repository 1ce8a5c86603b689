"""``contourlab canon``: print the moves of a part program."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli.output import silence

__all__ = ["canon"]


def canon(
    file: Annotated[Path, typer.Argument(metavar="PART", help="A part program in G-code.", show_default=False)],
    as_json: Annotated[bool, typer.Option("--json", help='Print one JSON document, {"moves": [...]}, alone on standard output.')] = False,
    dialect: Annotated[str, typer.Option(help="linuxcnc, or grbl, which is more lenient and says where.")] = "linuxcnc",
    block_delete: Annotated[bool, typer.Option("--block-delete", help="Pass over lines that begin with /.")] = False,
    tools: Annotated[Path | None, typer.Option(help="LinuxCNC tool table, for G43; tools without it have no length.")] = None,
) -> None:
    """Print the moves of a part program: positions of the tool's tip in mm, in machine coordinates, feed in mm/min."""
    from contourlab.program import Reading
    from contourlab.session.canon import write_canon
    from contourlab.session.run import refuse_drawing

    refuse_drawing(file)
    reading = Reading(dialect=dialect, require_end=False, block_delete=block_delete, tools=tools)  # type: ignore[arg-type]  # it checks
    try:
        notices = write_canon(file, sys.stdout, as_json=as_json, reading=reading)
    except BrokenPipeError:
        silence()
        return
    for notice in notices:
        print(notice, file=sys.stderr)
