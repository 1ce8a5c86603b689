"""Options that commands on a scenario share."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, TypeAlias

import typer

ScenarioFile: TypeAlias = Annotated[
    str, typer.Argument(metavar="SCENARIO", help="A scenario (.toml), or the name of a shipped one.", show_default=False)
]
Schemes: TypeAlias = Annotated[
    str | None,
    typer.Option(
        help="Names with commas between: schemes of the scenario, or fb, ccc, mr, me, ilc joined by +, as in fb,ccc,ilc,ccc+ilc.",
        show_default=False,
    ),
]
Trials: TypeAlias = Annotated[int | None, typer.Option(help="Largest number of trials after the first; the scenario has its own.")]
Out: TypeAlias = Annotated[Path, typer.Option(help="Folder for the results; made if it is not there.")]
Json: TypeAlias = Annotated[bool, typer.Option("--json", help="Print JSON alone on standard output.")]
Plots: TypeAlias = Annotated[list[str] | None, typer.Option(help="Also write plots as png, svg or pdf; may be given again.")]
Signals: TypeAlias = Annotated[list[str] | None, typer.Option(help="Write this signal only; may be given again; all by default.")]
Plugins: TypeAlias = Annotated[list[Path] | None, typer.Option("--plugin", help="Load components from a Python file; may be given again.")]

WithInterval: TypeAlias = Annotated[
    bool | None,
    typer.Option(
        "--interval/--no-interval",
        help="Draw machines from the stated deviations, for the interval of the contour error; by default where it is quick.",
        show_default=False,
    ),
]


def listed(schemes: str | None) -> tuple[str, ...]:
    """Return the names in a list with commas."""
    return tuple(name.strip() for name in schemes.split(",")) if schemes else ()
