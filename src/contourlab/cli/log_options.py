"""Options that commands on a log share."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, TypeAlias

import typer

ColumnTexts: TypeAlias = Annotated[
    list[str] | None,
    typer.Option("--column", help="What a column is, as position.x='NAME \\[mm]'; may be given again.", show_default=False),
]
ColumnFile: TypeAlias = Annotated[
    Path | None, typer.Option("--columns", help="A TOML file that says what the columns are.", show_default=False)
]
LogFormat: TypeAlias = Annotated[
    str | None, typer.Option("--format", help="Format, where it is not told from the file.", show_default=False)
]
SamplePeriod: TypeAlias = Annotated[
    str | None, typer.Option("--period", help='Time between samples, as "1 ms", where the log has none.', show_default=False)
]
