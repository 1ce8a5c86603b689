"""``contourlab run``: simulate a scenario or a part program and judge it."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from contourlab.cli.options import (
    AnyDialect,
    BlockDelete,
    Fit,
    Json,
    Judge,
    MostMoves,
    NoRequireEnd,
    Out,
    Pdf,
    Plots,
    Plugins,
    Signals,
    ToolTable,
    WithInterval,
    options_of,
    program_keys,
)
from contourlab.cli.output import conclude


def run(
    file: Annotated[
        Path, typer.Argument(metavar="SCENARIO|PART", help="A scenario (.toml), or a part program in G-code.", show_default=False)
    ],
    machine: Annotated[str | None, typer.Option(help="Machine: a file, or the name of a shipped one.")] = None,
    controller: Annotated[str | None, typer.Option(help="Controller: a file, or the name of a shipped one.")] = None,
    tolerance: Annotated[str | None, typer.Option(help='Largest part error that passes, e.g. "25 um"; a scenario has its own.')] = None,
    judge: Judge = None,
    fit: Fit = False,
    block_delete: BlockDelete = False,
    tools: ToolTable = None,
    no_require_end: NoRequireEnd = False,
    most_moves: MostMoves = None,
    dialect: AnyDialect = None,
    out: Out = Path("results"),
    as_json: Json = False,
    check: Annotated[bool, typer.Option("--check", help="Read and check everything, simulate nothing.")] = False,
    plots: Plots = None,
    pdf: Pdf = False,
    signals: Signals = None,
    interval: WithInterval = None,
    plugin: Plugins = None,
) -> int:
    """Simulate a scenario or a part program, judge the contour, write a report."""
    from contourlab.features.run.command import run_scenario

    program = program_keys(fit, block_delete, tools, no_require_end, most_moves, dialect)
    options = options_of(out, as_json, plugin, plots, signals, interval, pdf)
    parts: dict[str, Any] = {"machine": machine, "controller": controller, "tolerance": tolerance, "judge": judge}
    outcome = run_scenario(file, options, **parts, program=program, check=check)
    return conclude(outcome, as_json)
