"""``contourlab tune``: calibrate the gains of a scenario."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import show, suggest, suggest_again, wants_progress


def tune(
    file: Annotated[str, typer.Argument(metavar="SCENARIO", help="A scenario (.toml), or a part program.", show_default=False)],
    scheme: Annotated[str | None, typer.Option(help="Scheme of the scenario; by default the scenario itself.", show_default=False)] = None,
    machine: Annotated[str | None, typer.Option(help="Machine of a part program: a file, or a shipped name.", show_default=False)] = None,
    controller: Annotated[
        str | None, typer.Option(help="Controller to start from: a file, or a shipped name; a scenario has its own.", show_default=False)
    ] = None,
    tolerance: Annotated[str | None, typer.Option(help='Largest part error of a part program, e.g. "25 um".', show_default=False)] = None,
    judge: shared.Judge = None,
    fit: shared.Fit = False,
    block_delete: shared.BlockDelete = False,
    tools: shared.ToolTable = None,
    no_require_end: shared.NoRequireEnd = False,
    most_moves: shared.MostMoves = None,
    dialect: shared.AnyDialect = None,
    method: Annotated[str, typer.Option(help="sequential, global, or both: the better result.")] = "both",
    start: Annotated[str, typer.Option(help="scenario, or placed: poles as fast as the margins allow.")] = "scenario",
    objective: Annotated[
        str,
        typer.Option(help="part (largest part error, then rms), max, rms, integral, tracking, energy; or a sum, integral=1,energy=0.1."),
    ] = "part",
    parameter: shared.Parameters = None,
    width: shared.Width = 4.0,
    gain_margin: shared.GainMargin = 6.0,
    phase_margin: shared.PhaseMargin = 30.0,
    limited: Annotated[float, typer.Option(help="Largest share of the time at a drive limit, 0 to 1.")] = 0.0,
    command: Annotated[float | None, typer.Option(help="Largest command, relative to the drive limit.", show_default=False)] = None,
    passes: Annotated[int, typer.Option(help="Largest number of passes of the sequential procedure.")] = 1,
    lanes: Annotated[int, typer.Option(help="Values tried per line search.")] = 32,
    plateau: Annotated[str, typer.Option(help="Which of equally good values to take: robust, largest or best.")] = "robust",
    within: Annotated[float, typer.Option(help="Values worse than the best by up to this share count as equally good.")] = 0.01,
    budget: Annotated[int, typer.Option(help="Runs of the global search.")] = 6000,
    starts: Annotated[int, typer.Option(help="Starts of the global search.")] = 5,
    seed: shared.Seed = 0,
    executor: shared.ExecutorKind = "threads",
    workers: shared.Workers = None,
    write: shared.Write = None,
    out: shared.Out = Path("results"),
    as_json: shared.Json = False,
    plots: shared.Plots = None,
    plugin: shared.Plugins = None,
) -> int:
    """Tune gains, innermost loop first, within margins and drive limits; write a controller file."""
    import math

    from contourlab.features.tune.command import tune_scenario
    from contourlab.features.tune.objective import Goal
    from contourlab.features.tune.search import LineRule
    from contourlab.features.tune.study import TuneSettings
    from contourlab.study.executors import Executor
    from contourlab.study.guards import Bounds

    program = shared.program_keys(fit, block_delete, tools, no_require_end, most_moves, dialect)
    settings = TuneSettings(
        goal=Goal.parse(objective),
        bounds=Bounds(gain_margin, phase_margin, limited, math.inf if command is None else command),
        rule=LineRule(lanes, plateau=plateau, within=within),
        method=method,
        start=start,
        parameters=tuple(parameter or ()),
        width=width,
        passes=passes,
        budget=budget,
        starts=starts,
        seed=seed,
        executor=Executor(executor, workers),
    )
    calibration = tune_scenario(
        file,
        settings,
        scheme=scheme,
        machine=machine,
        controller=controller,
        tolerance=tolerance,
        judge=judge,
        program=program,
        out=write,
        plots=tuple(plots or ()),
        folder=out,
        plugins=tuple(plugin or ()),
        progress=wants_progress(as_json),
    )
    show(calibration, calibration.text(), as_json)
    kept = calibration.controller_file
    if kept is not None:
        more = [*shared.typed_keys(program), *(str(word) for one in plugin or () for word in ("--plugin", one))]
        parts = ("--machine", machine, "--controller", kept, "--tolerance", tolerance, "--judge", judge)
        suggest(as_json, "run", file, *parts, *more)
    elif not calibration.result.interrupted:
        suggest_again(as_json, "--start", "placed")
    if calibration.result.interrupted:
        stopped = KeyboardInterrupt()
        if kept is not None:
            stopped.add_note(f"Kept the best gains so far: {kept}")
        raise stopped
    return 0 if calibration.passed else 1
