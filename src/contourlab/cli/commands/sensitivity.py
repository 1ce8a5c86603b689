"""``contourlab sensitivity``: what the contour error depends on."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import show, suggest, wants_progress


def sensitivity(
    file: shared.ScenarioFile,
    parameter: shared.Parameters = None,
    scheme: Annotated[str, typer.Option(help="Scheme of the scenario; by default the scenario itself.", show_default=False)] = "",
    figure: Annotated[str, typer.Option(help="integral, rms or max of the contour error.")] = "integral",
    width: shared.Width = 2.0,
    parts: Annotated[
        str | None, typer.Option(help="Analyses, separated by commas: curves, local, morris, sobol; by default all.", show_default=False)
    ] = None,
    values: Annotated[int, typer.Option(help="Values of each curve.")] = 41,
    base: Annotated[int, typer.Option(help="N of Saltelli's sampling, a power of two: N (parameters + 2) runs.")] = 512,
    second_order: Annotated[bool, typer.Option("--second-order", help="Add Sobol indices of pairs: N (2 parameters + 2) runs.")] = False,
    trajectories: Annotated[int, typer.Option(help="Trajectories of Morris' design; each takes one run per parameter and one more.")] = 32,
    distribution: Annotated[str, typer.Option(help="For morris and sobol between the bounds: uniform, log-uniform or normal.")] = "uniform",
    deviation: Annotated[
        list[str] | None,
        typer.Option(
            metavar="[NAME=]DEVIATION",
            help='Standard deviation, e.g. "5 %" or "3.model_gain=20 mm/s^2/full_scale": the parameter is then normal; repeatable.',
            show_default=False,
        ),
    ] = None,
    transform: Annotated[str, typer.Option(help="log or none: whether morris and sobol use the logarithm of the figure.")] = "log",
    servo_period: Annotated[str, typer.Option(help='Servo period in place of the machine\'s, e.g. "0.1 ms".', show_default=False)] = "",
    quick: Annotated[
        bool, typer.Option("--quick", help="Answer within a minute; what does not fit is made smaller: --values, --base, --trajectories.")
    ] = False,
    judge: shared.Judge = None,
    seed: shared.Seed = 0,
    executor: shared.ExecutorKind = "threads",
    workers: shared.Workers = None,
    out: shared.Out = Path("results"),
    as_json: shared.Json = False,
    plots: shared.Plots = None,
    plugin: shared.Plugins = None,
) -> int:
    """Find the parameters that the contour error depends on, and in which order to calibrate them.

    It keeps its runs in the folder of the results: after an interrupt repeat the command, and it continues.
    """
    from contourlab.features.sensitivity.command import Request, sensitivity_of
    from contourlab.features.sensitivity.study import PARTS, Plan
    from contourlab.study.executors import Executor

    plan = Plan(shared.listed(parts) or PARTS, figure, values, base, second_order, trajectories, transform, seed)
    given = (tuple(parameter or ()), width, distribution, tuple(deviation or ()), servo_period, Executor(executor, workers), judge, quick)
    request = Request(plan, scheme, *given)
    result = sensitivity_of(file, out, request, plugins=tuple(plugin or ()), plots=tuple(plots or ()), progress=wants_progress(as_json))
    show(result, f"{result.text()}\n\nresults: {out}", as_json)
    suggest(as_json, "tune", file, "--scheme", scheme or None)
    return 0
