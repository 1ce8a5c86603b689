"""``contourlab refine``: a machine and its controllers brought to what logs have measured."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli.log_options import ColumnFile, ColumnTexts, LogFormat, SamplePeriod
from contourlab.cli.output import emit_json, say
from contourlab.cli.scheme_options import Json, Plots, Plugins, ScenarioFile


def refine(
    scenario: ScenarioFile,
    log: Annotated[list[Path], typer.Option(help="A log of such a run; may be given again.", show_default=False)],
    parameter: Annotated[
        list[str],
        typer.Option(help='What is refined: "axes.*.plant.damping" or "NAME=50 N..200 N"; may be given again.', show_default=False),
    ],
    also: Annotated[
        list[str] | None, typer.Option(help="Scenario of the next log, the same machine under another controller.", show_default=False)
    ] = None,
    column: ColumnTexts = None,
    columns: ColumnFile = None,
    format: LogFormat = None,  # noqa: A002
    period: SamplePeriod = None,
    window: Annotated[
        list[str] | None, typer.Option(help='Times that are fitted, as "0.8 s..1.6 s"; once for all logs, or for each.', show_default=False)
    ] = None,
    validation: Annotated[Path | None, typer.Option(help="A log that is not fitted, under the first scenario.", show_default=False)] = None,
    starts: Annotated[int, typer.Option(help="Descents, from the scenario's numbers and from others around them.")] = 3,
    plugin: Plugins = None,
    machine: Annotated[
        Path | None,
        typer.Option("--out", help="The machine's file to write, controllers beside it; folders above are made.", show_default=False),
    ] = None,
    folder: Annotated[Path, typer.Option(help="Folder of the pictures; made if it is not there.")] = Path("results"),
    as_json: Json = False,
    plots: Plots = None,
) -> int:
    """Refine a machine and its controllers until their simulated run follows a log, with deviations and what stands against them."""
    from contourlab.features.measure.log_choice import LogChoice
    from contourlab.features.refine.command import refine_logs

    def choice(file: Path) -> LogChoice:
        return LogChoice(file, tuple(column or ()), columns, format, period)

    def progress(words: str) -> None:
        sys.stderr.write(words + "\n")

    found = refine_logs(
        [scenario, *(also or ())],
        [choice(file) for file in log],
        parameter,
        windows=tuple(window or ()),
        validation=choice(validation) if validation is not None else None,
        starts=starts,
        plugins=tuple(plugin or ()),
        out=machine,
        plots=tuple(plots or ()),
        folder=folder,
        progress=progress if sys.stderr.isatty() else None,
    )
    if as_json:
        emit_json(found.summary)
    else:
        say(found.text)
    return 0 if found.usable else 1
