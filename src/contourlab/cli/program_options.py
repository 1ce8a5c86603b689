"""How `contourlab canon` and `contourlab check` are told to read a part program."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, TypeAlias

import typer

if TYPE_CHECKING:
    from contourlab.program import Reading

Part: TypeAlias = Annotated[Path, typer.Argument(metavar="PART", help="A part program in G-code.", show_default=False)]
Dialect: TypeAlias = Annotated[str, typer.Option(help="linuxcnc, or grbl, which is more lenient and says where.")]
BlockDelete: TypeAlias = Annotated[bool, typer.Option("--block-delete", help="Pass over lines that begin with /.")]
ToolTable: TypeAlias = Annotated[Path | None, typer.Option(help="LinuxCNC tool table, for G43; tools without it have no length.")]


def reading_of(file: Path, dialect: str, block_delete: bool, tools: Path | None) -> Reading:
    """Return how a program is to be read; a missing end is noted only. A drawing is refused."""
    from contourlab.features.run.command import refuse_drawing
    from contourlab.program import Reading

    refuse_drawing(file)
    return Reading(dialect=dialect, require_end=False, block_delete=block_delete, tools=tools)  # type: ignore[arg-type]  # it checks
