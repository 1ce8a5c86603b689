"""``contourlab precompensate``: a part program corrected by the contour error that repeats."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import show_result, suggest, wants_progress


def precompensate(
    part: shared.Part,
    out: Annotated[Path, typer.Option(help="Program to write.", show_default=False)],
    log: Annotated[list[Path] | None, typer.Option(help="Log of a run of the pass written last; repeatable.", show_default=False)] = None,
    passes: Annotated[Path | None, typer.Option(help="Folder that keeps what was learned, pass after pass.", show_default=False)] = None,
    machine: Annotated[
        str | None, typer.Option(help="Machine to simulate; with a log, for its play and its limits.", show_default=False)
    ] = None,
    controller: Annotated[str | None, typer.Option(help="Controller to simulate.", show_default=False)] = None,
    repeat: Annotated[int, typer.Option(help="Passes to simulate.")] = 5,
    tolerance: Annotated[str, typer.Option(help="Largest distance of a written line from the corrected path.")] = "0.5 um",
    cap: Annotated[str, typer.Option(help="Largest displacement of the path.")] = "1 mm",
    band: Annotated[str, typer.Option(help="By how much cycle time and local speed may grow.")] = "2 %",
    axes: Annotated[str | None, typer.Option(help="Axes of the log, e.g. x,y; by default all.", show_default=False)] = None,
    column: shared.ColumnTexts = None,
    columns: shared.ColumnFile = None,
    format: shared.LogFormat = None,  # noqa: A002
    period: shared.SamplePeriod = None,
    dialect: shared.Dialect = "linuxcnc",
    block_delete: shared.BlockDelete = False,
    tools: shared.ToolTable = None,
    most_moves: shared.MostMoves = None,
    seed: shared.Seed = 0,
    plugin: shared.Plugins = None,
    as_json: shared.Json = False,
) -> int:
    """Correct a part program by the contour error that repeats, so that the same control makes a better part."""
    from contourlab.errors import ParameterError
    from contourlab.features.measure.log_choice import LogChoice
    from contourlab.features.precompensate.command import Options, precompensate_from_logs, precompensate_from_model
    from contourlab.features.run.inputs import scenario_of
    from contourlab.scenario import load_machine
    from contourlab.scenario.load import named_file

    options, reading = Options(tolerance, cap, band, repeat), shared.reading_of(part, dialect, block_delete, tools, most_moves)
    plugins = tuple(plugin or ())
    if log:
        if controller is not None:
            raise ParameterError("--controller", repr(controller), "left out: with --log the real one is corrected")
        choices = [LogChoice(file, tuple(column or ()), columns, format, period, shared.listed(axes)) for file in log]
        known = None if machine is None else load_machine(named_file(machine), plugins=plugins)
        result = precompensate_from_logs(part, choices, out, passes=passes, machine=known, options=options, reading=reading)
    elif machine is None:
        raise ParameterError("--log", "missing", "the log of a run; or --machine and --controller, to simulate")
    else:
        if passes is not None:
            raise ParameterError("--passes", repr(str(passes)), "left out: without --log all passes are simulated here")
        keys = {"require_end": False, "dialect": dialect}
        scenario = scenario_of(part, machine=machine, controller=controller, program=keys, plugins=plugins)

        result = precompensate_from_model(
            part, scenario.machine, scenario.controller, out, options=options, reading=reading, seed=seed, progress=wants_progress(as_json)
        )
    show_result(result, as_json)
    if result.written:
        suggest(as_json, "check", out)
    return 0 if result.passed else 1
