"""``contourlab run``: simulate a scenario or a part program and judge it."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from contourlab.cli.output import conclude, wants_progress
from contourlab.cli.scheme_options import WithInterval


def run(
    file: Annotated[
        Path, typer.Argument(metavar="SCENARIO|PART", help="A scenario (.toml), or a part program in G-code.", show_default=False)
    ],
    machine: Annotated[str | None, typer.Option(help="Machine: a file, or the name of one that is shipped.")] = None,
    controller: Annotated[str | None, typer.Option(help="Controller: a file, or the name of one that is shipped.")] = None,
    tolerance: Annotated[str | None, typer.Option(help='Largest part error that passes, as "25 um"; a scenario has its own.')] = None,
    fit: Annotated[bool, typer.Option("--fit", help="Scale and move a part program into the machine's travel; says how.")] = False,
    block_delete: Annotated[bool, typer.Option("--block-delete", help="Pass over lines of a part program that begin with /.")] = False,
    tools: Annotated[Path | None, typer.Option(help="LinuxCNC tool table, for G43 in a part program.", show_default=False)] = None,
    no_require_end: Annotated[
        bool, typer.Option("--no-require-end", help="A part program without M2, M30 or % ends with its last line.")
    ] = False,
    dialect: Annotated[str | None, typer.Option(help="Of a part program: linuxcnc (the default), or grbl.")] = None,
    out: Annotated[Path, typer.Option(help="Folder for the results; made if it is not there.")] = Path("results"),
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON alone on standard output.")] = False,
    check: Annotated[bool, typer.Option("--check", help="Read and check everything, simulate nothing.")] = False,
    plots: Annotated[list[str] | None, typer.Option(help="Also write plots as png, svg or pdf; may be given again.")] = None,
    signals: Annotated[list[str] | None, typer.Option(help="Write this signal only; may be given again; all by default.")] = None,
    interval: WithInterval = None,
    plugin: Annotated[list[Path] | None, typer.Option(help="Load components from a Python file; may be given again.")] = None,
) -> int:
    """Simulate a scenario or a part program, judge the contour, write report and results."""
    from contourlab.features.run.command import run_scenario

    options: dict[str, Any] = {
        "fit": fit or None,
        "block_delete": block_delete or None,
        "tools": None if tools is None else str(tools),
        "require_end": False if no_require_end else None,
        "dialect": dialect,
    }
    outcome = run_scenario(
        file,
        out,
        machine=machine,
        controller=controller,
        tolerance=tolerance,
        options={name: value for name, value in options.items() if value is not None},
        plugins=tuple(plugin or ()),
        check=check,
        plots=tuple(plots or ()),
        signals=tuple(signals or ()),
        progress=wants_progress(as_json),
        interval=interval,
    )
    return conclude(outcome, as_json)
