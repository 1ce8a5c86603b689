"""``contourlab measure``: contour error of a measured run."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.app.command_line import as_typed
from contourlab.cli import options as shared
from contourlab.cli.output import conclude


def measure(
    log: Annotated[
        Path, typer.Argument(metavar="LOG", help="A log: .mat, .csv, .parquet, .xml, .nc, or text from a scope.", show_default=False)
    ],
    reference: Annotated[
        str | None, typer.Option(help="Columns of the reference, separated by commas, or a part program.", show_default=False)
    ] = None,
    shift: Annotated[
        str | None,
        typer.Option(help='Zero of the part in the log: "fit", or lengths, e.g. "10 mm, 5 mm".', show_default=False),
    ] = None,
    column: shared.ColumnTexts = None,
    columns: shared.ColumnFile = None,
    format: shared.LogFormat = None,  # noqa: A002
    period: shared.SamplePeriod = None,
    axes: Annotated[str | None, typer.Option(help="Axes of the contour, e.g. x,y; by default all.", show_default=False)] = None,
    tolerance: Annotated[str | None, typer.Option(help='Largest contour error that passes, e.g. "25 um".', show_default=False)] = None,
    out: shared.Out = Path("results"),
    as_json: shared.Json = False,
    plots: shared.Plots = None,
) -> int:
    """Judge a measured run like a simulated one: contour error, tracking, reversals."""
    from contourlab.features.measure.command import measure_log
    from contourlab.features.measure.log_choice import LogChoice

    words = ["contourlab", "measure", str(log)]
    options = {
        "--reference": reference,
        "--shift": shift,
        "--columns": columns,
        "--format": format,
        "--period": period,
        "--axes": axes,
        "--tolerance": tolerance,
    }
    words += [word for name, value in options.items() if value is not None for word in (name, str(value))]
    words += [word for text in column or () for word in ("--column", text)]
    choice = LogChoice(log, tuple(column or ()), columns, format, period, shared.listed(axes))
    asked = {"reference": reference, "shift": shift, "tolerance": tolerance}
    outcome = measure_log(choice, out, **asked, plots=tuple(plots or ()), command=as_typed(words))
    return conclude(outcome, as_json)
