"""``contourlab run``: simulate a scenario or a part program and judge it."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import conclude


def run(
    file: Annotated[
        Path, typer.Argument(metavar="SCENARIO|PART", help="A scenario (.toml), or a part program in G-code.", show_default=False)
    ],
    machine: Annotated[str | None, typer.Option(help="Machine: a file, or the name of a shipped one.")] = None,
    controller: Annotated[str | None, typer.Option(help="Controller: a file, or the name of a shipped one.")] = None,
    tolerance: Annotated[str | None, typer.Option(help='Largest part error that passes, e.g. "25 um"; a scenario has its own.')] = None,
    judge: shared.Judge = None,
    fit: shared.Fit = False,
    block_delete: shared.BlockDelete = False,
    tools: shared.ToolTable = None,
    no_require_end: shared.NoRequireEnd = False,
    most_moves: shared.MostMoves = None,
    dialect: shared.AnyDialect = None,
    out: shared.Out = Path("results"),
    as_json: shared.Json = False,
    check: Annotated[bool, typer.Option("--check", help="Read and check everything, simulate nothing.")] = False,
    plots: shared.Plots = None,
    pdf: shared.Pdf = False,
    signals: shared.Signals = None,
    interval: shared.WithInterval = None,
    plugin: shared.Plugins = None,
) -> int:
    """Simulate a scenario or a part program, judge the contour, write a report."""
    from contourlab.features.run.command import run_scenario

    program = shared.program_keys(fit, block_delete, tools, no_require_end, most_moves, dialect)
    options = shared.options_of(out, as_json, plugin, plots, signals, interval, pdf)
    parts: dict[str, Any] = {"machine": machine, "controller": controller, "tolerance": tolerance, "judge": judge}
    outcome = run_scenario(file, options, **parts, program=program, check=check)
    return conclude(outcome, as_json)
