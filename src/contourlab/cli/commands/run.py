"""``contourlab run``: simulate a scenario or a part program and judge it."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from contourlab.cli.options import Json, Judge, MostMoves, Out, Pdf, Plots, Plugins, Signals, WithInterval, options_of
from contourlab.cli.output import conclude


def run(
    file: Annotated[
        Path, typer.Argument(metavar="SCENARIO|PART", help="A scenario (.toml), or a part program in G-code.", show_default=False)
    ],
    machine: Annotated[str | None, typer.Option(help="Machine: a file, or the name of a shipped one.")] = None,
    controller: Annotated[str | None, typer.Option(help="Controller: a file, or the name of a shipped one.")] = None,
    tolerance: Annotated[str | None, typer.Option(help='Largest part error that passes, e.g. "25 um"; a scenario has its own.')] = None,
    judge: Judge = None,
    fit: Annotated[bool, typer.Option("--fit", help="Scale and move a part program into the machine's travel.")] = False,
    block_delete: Annotated[bool, typer.Option("--block-delete", help="Skip lines of a part program that begin with /.")] = False,
    tools: Annotated[Path | None, typer.Option(help="LinuxCNC tool table, for G43 in a part program.", show_default=False)] = None,
    no_require_end: Annotated[
        bool, typer.Option("--no-require-end", help="Accept a part program without M2, M30 or %: its last line ends it.")
    ] = False,
    most_moves: MostMoves = None,
    dialect: Annotated[str | None, typer.Option(help="Dialect of a part program: linuxcnc (the default), or grbl.")] = None,
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

    program: dict[str, Any] = {
        "fit": fit or None,
        "block_delete": block_delete or None,
        "tools": None if tools is None else str(tools),
        "require_end": False if no_require_end else None,
        "dialect": dialect,
        "most_moves": most_moves,
    }
    given = {name: value for name, value in program.items() if value is not None}
    options = options_of(out, as_json, plugin, plots, signals, interval, pdf)
    parts: dict[str, Any] = {"machine": machine, "controller": controller, "tolerance": tolerance, "judge": judge}
    outcome = run_scenario(file, options, **parts, program=given, check=check)
    return conclude(outcome, as_json)
