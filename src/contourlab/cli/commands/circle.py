"""``contourlab circle``: the causes behind measured circles."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from contourlab.app.command_line import as_typed
from contourlab.cli import options as shared
from contourlab.cli.output import say, show_result


def circle(
    logs: Annotated[
        list[Path],
        typer.Argument(metavar="LOG...", help="Logs of a circle, or files of angle and radius: one, or one per sense.", show_default=False),
    ],
    tolerance: Annotated[str | None, typer.Option(help='Largest circular deviation that passes, e.g. "8 um".', show_default=False)] = None,
    radius: Annotated[str | None, typer.Option(help='Nominal radius, e.g. "50 mm"; by default as commanded.', show_default=False)] = None,
    feed: Annotated[
        str | None, typer.Option(help='Feed of a file of angles, e.g. "1000 mm/min": gives times and frequencies.', show_default=False)
    ] = None,
    pitch: Annotated[
        str | None, typer.Option(help='Pitch of the cyclic error, e.g. "10 mm"; by default searched.', show_default=False)
    ] = None,
    axes: Annotated[str | None, typer.Option(help="The two axes, e.g. x,y; by default the first two.", show_default=False)] = None,
    column: shared.ColumnTexts = None,
    columns: shared.ColumnFile = None,
    format: shared.LogFormat = None,  # noqa: A002
    period: shared.SamplePeriod = None,
    out: shared.Out = Path("results"),
    as_json: shared.Json = False,
) -> int:
    """Find what shapes a measured circle: backlash, spikes, servo mismatch, squareness, scale, cyclic error, vibration."""
    from contourlab.features.circle.command import CircleOptions, circle_test
    from contourlab.features.measure.log_choice import LogChoice

    choices = [LogChoice(log, tuple(column or ()), columns, format, period, shared.listed(axes)) for log in logs]
    options = CircleOptions(radius, feed, pitch, tolerance)
    typed = as_typed(["contourlab", *(word for word in sys.argv[1:] if word != "--json")])
    result = circle_test(choices, out, options, typed)
    show_result(result, as_json)
    if not as_json:
        say(f"\nnext: {result.next_command}")
    return 1 if result.passed is False else 0
