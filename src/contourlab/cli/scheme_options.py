"""Options that commands on a scenario share."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, TypeAlias

import typer

from contourlab.cli.output import wants_progress

if TYPE_CHECKING:
    from contourlab.features.run.command import RunOptions

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
Trials: TypeAlias = Annotated[int | None, typer.Option(help="Largest number of trials after the first [default: as in the scenario].")]
Out: TypeAlias = Annotated[Path, typer.Option(help="Folder for the results; created if missing.")]
Json: TypeAlias = Annotated[bool, typer.Option("--json", help="Print JSON alone on standard output.")]
Plots: TypeAlias = Annotated[list[str] | None, typer.Option(help="Also write plots as png, svg or pdf; repeatable.")]
Signals: TypeAlias = Annotated[list[str] | None, typer.Option(help="Write this signal only; repeatable [default: all].")]
Plugins: TypeAlias = Annotated[list[Path] | None, typer.Option("--plugin", help="Load components from a Python file; repeatable.")]

WithInterval: TypeAlias = Annotated[
    bool | None,
    typer.Option(
        "--interval/--no-interval",
        help="Compute the interval of the contour error from the stated deviations [default: where it is quick].",
        show_default=False,
    ),
]


def options_of(
    out: Path, as_json: bool, plugin: list[Path] | None, plots: list[str] | None, signals: list[str] | None, interval: bool | None
) -> RunOptions:
    """Return the options that run, compare and learn share."""
    from contourlab.features.run.command import RunOptions

    return RunOptions(out, tuple(plugin or ()), tuple(plots or ()), tuple(signals or ()), wants_progress(as_json), interval)


def listed(schemes: str | None) -> tuple[str, ...]:
    """Return the names in a list with commas."""
    return tuple(name.strip() for name in schemes.split(",")) if schemes else ()
