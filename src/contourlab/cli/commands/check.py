"""``contourlab check``: find the faults of a part program, and say what it does."""

from __future__ import annotations

from typing import Annotated

import typer

from contourlab.cli.output import emit_json, say
from contourlab.cli.program_options import BlockDelete, Dialect, Part, ToolTable, reading_of

FAULTY = 2


def check(
    file: Part,
    machine: Annotated[
        str | None,
        typer.Option(
            help="Machine whose limits give the cycle time, and whose travel must not be left: a file, or the name of a shipped one; "
            "by default builtin:xyz, whose travel is told of only.",
            show_default=False,
        ),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON alone on standard output.")] = False,
    dialect: Dialect = "linuxcnc",
    block_delete: BlockDelete = False,
    tools: ToolTable = None,
) -> int:
    """List every fault of a part program with line and column; say its box, feeds and cycle time."""
    from contourlab.features.check.program_check import check_program

    reading = reading_of(file, dialect, block_delete, tools)
    found = check_program(file, machine, reading=reading)
    if as_json:
        emit_json(found.summary)
    else:
        say(found.text)
    return 0 if found.good else FAULTY
