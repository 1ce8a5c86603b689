"""Options of commands that read a log."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, TypeAlias

import typer

ColumnTexts: TypeAlias = Annotated[
    list[str] | None,
    typer.Option("--column", help="Signal of a column, as position.x='NAME \\[mm]'; repeatable.", show_default=False),
]
ColumnFile: TypeAlias = Annotated[
    Path | None, typer.Option("--columns", help="A TOML file with the signals of the columns.", show_default=False)
]
LogFormat: TypeAlias = Annotated[
    str | None, typer.Option("--format", help="Format of the file, if it is not recognised.", show_default=False)
]
SamplePeriod: TypeAlias = Annotated[
    str | None, typer.Option("--period", help='Time between samples, as "1 ms", if the log has no times.', show_default=False)
]
