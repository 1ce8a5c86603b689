"""``contourlab identify``: mass and friction of an axis from a log."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli.log_options import ColumnFile, ColumnTexts, LogFormat, SamplePeriod
from contourlab.cli.output import emit_json, say
from contourlab.cli.scheme_options import Json, Plots

__all__ = ["identify"]


def identify(
    log: Annotated[Path, typer.Argument(metavar="LOG", help="A log of a run that excites the axis.", show_default=False)],
    model: Annotated[str, typer.Option(help="rigid, or rigid-by-direction with friction of its own each way.")] = "rigid",
    axis: Annotated[str | None, typer.Option(help="Which axis, where the log has several.", show_default=False)] = None,
    gain: Annotated[
        str | None, typer.Option(help='Force per command, as "35 N/V", where the log has no force.', show_default=False)
    ] = None,
    column: ColumnTexts = None,
    columns: ColumnFile = None,
    format: LogFormat = None,  # noqa: A002
    period: SamplePeriod = None,
    cutoff: Annotated[str, typer.Option(help="Of the low-pass of the position: five times the loop's bandwidth is usual.")] = "100 Hz",
    decimation: Annotated[int, typer.Option(help="Every how-many-th sample makes an equation.")] = 10,
    validation: Annotated[Path | None, typer.Option(help="A second log, to see what the figures are worth.", show_default=False)] = None,
    out: Annotated[Path | None, typer.Option(help="The axis file to write.", show_default=False)] = None,
    as_json: Json = False,
    plots: Plots = None,
) -> int:
    """Find mass, friction and offset of an axis from a log, with their deviations; write an axis file."""
    from contourlab.session.identify import identify_log
    from contourlab.session.log_choice import LogChoice

    choice = LogChoice(log, tuple(column or ()), columns, format, period)
    fitting = {"model": model, "axis": axis, "gain": gain, "cutoff": cutoff, "decimation": decimation, "validation": validation}
    found = identify_log(choice, **fitting, out=out, plots=tuple(plots or ()))  # type: ignore[arg-type]
    if as_json:
        emit_json(found.summary)
    else:
        say(found.text)
    return 0 if found.usable else 1
