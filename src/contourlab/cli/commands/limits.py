"""``contourlab limits``: commanded motion against the limits of a machine."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import say, show_result


def limits(
    file: Annotated[Path, typer.Argument(metavar="LOG|PROGRAM", help="A log, or a part program to plan.", show_default=False)],
    machine: Annotated[
        str | None, typer.Option(help="Machine whose limits hold; by default a program keeps those given, else of xyz.", show_default=False)
    ] = None,
    velocity: Annotated[str | None, typer.Option(help='Limit, e.g. "200 mm/s" or "x=200 mm/s, y=100 mm/s".', show_default=False)] = None,
    acceleration: Annotated[str | None, typer.Option(help='Limit, e.g. "2 m/s^2".', show_default=False)] = None,
    jerk: Annotated[str | None, typer.Option(help='Limit, e.g. "50 m/s^3".', show_default=False)] = None,
    tolerance: Annotated[
        str | None, typer.Option(help='By how much a limit may be exceeded; by default "0.5 %".', show_default=False)
    ] = None,
    program: Annotated[Path | None, typer.Option(help="Program of the log: places get its lines.", show_default=False)] = None,
    line_column: Annotated[str | None, typer.Option(help="Column of the log with program lines.", show_default=False)] = None,
    annotate: Annotated[
        Path | None, typer.Option(help="Program to write: times, limits and errors as comments, same moves.", show_default=False)
    ] = None,
    axes: Annotated[str | None, typer.Option(help="Axes of the log, e.g. x,y; by default all.", show_default=False)] = None,
    column: shared.ColumnTexts = None,
    columns: shared.ColumnFile = None,
    format: shared.LogFormat = None,  # noqa: A002
    period: shared.SamplePeriod = None,
    dialect: shared.Dialect = "linuxcnc",
    block_delete: shared.BlockDelete = False,
    tools: shared.ToolTable = None,
    most_moves: shared.MostMoves = None,
    as_json: shared.Json = False,
) -> int:
    """Compare commanded velocity, acceleration and jerk with the limits of a machine; show the worst program lines."""
    from contourlab.features.limits.command import LimitOptions, check_limits
    from contourlab.features.measure.log_choice import LogChoice

    choice = LogChoice(file, tuple(column or ()), columns, format, period, shared.listed(axes))
    options = LimitOptions(machine, velocity, acceleration, jerk, tolerance, program, line_column, annotate)
    test = check_limits(choice, options, shared.reading_of(program or Path("log"), dialect, block_delete, tools, most_moves))
    show_result(test, as_json)
    if not as_json:
        say(f"\nnext: {test.next_command}")
    return 1 if test.passed is False else 0
