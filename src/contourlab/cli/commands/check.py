"""``contourlab check``: find the faults of a part program, and say what it does."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli.output import emit_json, say

__all__ = ["check"]

FAULTY = 2


def check(
    file: Annotated[Path, typer.Argument(metavar="PART", help="A part program in G-code.", show_default=False)],
    machine: Annotated[
        str, typer.Option(help="Machine whose limits give the cycle time: a file, or the name of a shipped one.")
    ] = "builtin:xyz",
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON alone on standard output.")] = False,
    dialect: Annotated[str, typer.Option(help="linuxcnc, or grbl, which is more lenient and says where.")] = "linuxcnc",
    block_delete: Annotated[bool, typer.Option("--block-delete", help="Pass over lines that begin with /.")] = False,
    tools: Annotated[Path | None, typer.Option(help="LinuxCNC tool table, for G43; tools without it have no length.")] = None,
) -> int:
    """List every fault of a part program with line and column; say its box, feeds and cycle time."""
    from contourlab.program import Reading
    from contourlab.session.program_check import check_program
    from contourlab.session.run import refuse_drawing

    refuse_drawing(file)
    reading = Reading(dialect=dialect, require_end=False, block_delete=block_delete, tools=tools)  # type: ignore[arg-type]  # it checks
    found = check_program(file, machine, reading=reading)
    if as_json:
        emit_json(found.summary)
    else:
        say(found.text)
    return 0 if found.good else FAULTY
