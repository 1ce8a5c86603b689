"""``contourlab canon``: print the moves of a part program."""

from __future__ import annotations

import sys
from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import silence, suggest


def canon(
    file: shared.Part,
    as_json: Annotated[bool, typer.Option("--json", help='Print only one JSON document on standard output, {"moves": [...]}.')] = False,
    dialect: shared.Dialect = "linuxcnc",
    block_delete: shared.BlockDelete = False,
    tools: shared.ToolTable = None,
    most_moves: shared.MostMoves = None,
) -> None:
    """Print the moves of a part program: tool tip in mm in machine coordinates, feed in mm/min."""
    from contourlab.features.check.canon import write_canon

    reading = shared.reading_of(file, dialect, block_delete, tools, most_moves)
    try:
        notices = write_canon(file, sys.stdout, as_json=as_json, reading=reading)
    except BrokenPipeError:
        silence()
        return
    for notice in notices:
        print(notice, file=sys.stderr)
    if sys.stdout.isatty():
        keys = shared.program_keys(False, block_delete, tools, False, most_moves, None)
        suggest(as_json, "check", file, "--dialect", dialect if dialect != "linuxcnc" else None, *shared.typed_keys(keys))
