"""``contourlab refine``: fit a machine and its controllers to logs."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import show, suggest, suggest_again


def refine(
    scenario: shared.ScenarioFile,
    log: Annotated[list[Path], typer.Option(help="Log of a run; repeatable.", show_default=False)],
    parameter: Annotated[
        list[str],
        typer.Option(help='Parameter to refine: "axes.*.plant.damping" or "NAME=50 N..200 N"; repeatable.', show_default=False),
    ],
    also: Annotated[
        list[str] | None,
        typer.Option(help="Scenario of the next log, with the same machine and another controller; repeatable.", show_default=False),
    ] = None,
    column: shared.ColumnTexts = None,
    columns: shared.ColumnFile = None,
    format: shared.LogFormat = None,  # noqa: A002
    period: shared.SamplePeriod = None,
    window: Annotated[
        list[str] | None, typer.Option(help='Times to fit, e.g. "0.8 s..1.6 s"; once for all logs, or for each.', show_default=False)
    ] = None,
    validation: Annotated[Path | None, typer.Option(help="Log for validation, under the first scenario.", show_default=False)] = None,
    starts: Annotated[int, typer.Option(help="Number of searches, from the scenario's values and from points around them.")] = 3,
    plugin: shared.Plugins = None,
    write: shared.Write = None,
    out: shared.Out = Path("results"),
    as_json: shared.Json = False,
    plots: shared.Plots = None,
) -> int:
    """Fit parameters of a machine and its controllers until the simulation follows a log."""
    from contourlab.features.measure.log_choice import LogChoice
    from contourlab.features.refine.command import refine_logs

    def choice(file: Path) -> LogChoice:
        return LogChoice(file, tuple(column or ()), columns, format, period)

    def progress(line: str) -> None:
        if sys.stderr.isatty():
            sys.stderr.write(line + "\n")

    refinement = refine_logs(
        [scenario, *(also or ())],
        [choice(file) for file in log],
        parameter,
        windows=tuple(window or ()),
        validation=choice(validation) if validation is not None else None,
        starts=starts,
        plugins=tuple(plugin or ()),
        out=write,
        plots=tuple(plots or ()),
        folder=out,
        progress=progress,
    )
    show(refinement, refinement.text(), as_json)
    if write is None:
        suggest_again(as_json, "--write", "machine.toml")
    else:
        suggest(as_json, "sensitivity", scenario)
    return 0 if refinement.result.usable else 1
