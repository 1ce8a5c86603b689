"""``contourlab check``: faults, extent and cycle time of a part program."""

from __future__ import annotations

from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import show_result, suggest, wants_progress

FAULTY = 2


def check(
    file: shared.Part,
    machine: Annotated[
        str | None,
        typer.Option(
            help="Machine for cycle time and travel: a file, or the name of a shipped one. By default builtin:xyz; "
            "moves beyond its travel are then not faults.",
            show_default=False,
        ),
    ] = None,
    as_json: shared.Json = False,
    dialect: shared.Dialect = "linuxcnc",
    block_delete: shared.BlockDelete = False,
    tools: shared.ToolTable = None,
    most_moves: shared.MostMoves = None,
) -> int:
    """List every fault of a part program with line and column; print its box, feeds and cycle time."""
    from contourlab.features.check.program_check import check_program
    from contourlab.program import Reading

    reading = shared.reading_of(file, dialect, block_delete, tools, most_moves)
    checked = check_program(file, machine, reading=reading, progress=wants_progress(as_json))
    show_result(checked, as_json)
    if not checked.faults:
        other = None if dialect == Reading.dialect else dialect
        keys = shared.program_keys(False, block_delete, tools, not checked.has_end, most_moves, other)
        words = ("--machine", machine or "xyz", "--controller", None if machine else "xyz-controller")
        suggest(as_json, "run", file, *words, *shared.typed_keys(keys))
    return FAULTY if checked.faults else 0
