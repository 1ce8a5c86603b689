"""``contourlab check``: faults, extent and cycle time of a part program."""

from __future__ import annotations

from typing import Annotated

import typer

from contourlab.cli.options import BlockDelete, Dialect, Json, MostMoves, Part, ToolTable, program_keys, reading_of, typed_keys
from contourlab.cli.output import emit_json, say, suggest, wants_progress

FAULTY = 2


def check(
    file: Part,
    machine: Annotated[
        str | None,
        typer.Option(
            help="Machine for cycle time and travel: a file, or the name of a shipped one. By default builtin:xyz; "
            "moves beyond its travel are then not faults.",
            show_default=False,
        ),
    ] = None,
    as_json: Json = False,
    dialect: Dialect = "linuxcnc",
    block_delete: BlockDelete = False,
    tools: ToolTable = None,
    most_moves: MostMoves = None,
) -> int:
    """List every fault of a part program with line and column; print its box, feeds and cycle time."""
    from contourlab.features.check.program_check import check_program
    from contourlab.program import Reading

    reading = reading_of(file, dialect, block_delete, tools, most_moves)
    checked = check_program(file, machine, reading=reading, progress=wants_progress(as_json))
    if as_json:
        emit_json(checked)
    else:
        say(checked.text)
    if not checked.faults:
        keys = program_keys(False, block_delete, tools, not checked.has_end, most_moves, None if dialect == Reading.dialect else dialect)
        words = ("--machine", machine or "xyz", "--controller", None if machine else "xyz-controller")
        suggest(as_json, "run", file, *words, *typed_keys(keys))
    return FAULTY if checked.faults else 0
