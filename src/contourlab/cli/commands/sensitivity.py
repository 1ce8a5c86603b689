"""``contourlab sensitivity``: what the contour error depends on."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli.output import emit_json, say, wants_progress
from contourlab.cli.scheme_options import Json, Out, Plots, Plugins, ScenarioFile, listed
from contourlab.cli.study_options import Parameters, Seed, Threads, Width


def sensitivity(
    file: ScenarioFile,
    parameter: Parameters = None,
    scheme: Annotated[str, typer.Option(help="A scheme of the scenario; the scenario without any by default.", show_default=False)] = "",
    figure: Annotated[str, typer.Option(help="integral, rms or max of the contour error.")] = "integral",
    width: Width = 2.0,
    parts: Annotated[
        str | None, typer.Option(help="With commas between: curves, local, morris, sobol; all by default.", show_default=False)
    ] = None,
    values: Annotated[int, typer.Option(help="Values of each curve.")] = 41,
    base: Annotated[int, typer.Option(help="N of Saltelli's sampling, a power of two: N (numbers + 2) runs.")] = 512,
    second_order: Annotated[bool, typer.Option("--second-order", help="Sobol's indices of pairs too: N (2 numbers + 2) runs.")] = False,
    trajectories: Annotated[int, typer.Option(help="Of Morris' design: each takes one run more than there are numbers.")] = 32,
    distribution: Annotated[str, typer.Option(help="uniform, log-uniform or normal between the bounds, for morris and sobol.")] = "uniform",
    deviation: Annotated[
        list[str] | None,
        typer.Option(
            metavar="[NAME=]DEVIATION",
            help='Standard deviation, as "5 %" or "3.model_gain=20 mm/s^2/full_scale": that number is normal; may be given again.',
            show_default=False,
        ),
    ] = None,
    transform: Annotated[
        str, typer.Option(help="log or none: morris and sobol look at the figure's decimal logarithm, or at itself.")
    ] = "log",
    servo_period: Annotated[str, typer.Option(help='In place of the machine\'s own, as "0.1 ms".', show_default=False)] = "",
    seed: Seed = 0,
    threads: Threads = None,
    out: Out = Path("results/sensitivity"),
    as_json: Json = False,
    plots: Plots = None,
    plugin: Plugins = None,
) -> int:
    """Say which numbers of a machine and its controller the contour error depends on: one at a time, a little, and all at once.

    Runs are kept in the folder of the results: after an interrupt the same command goes on where it stopped.
    """
    from contourlab.features.sensitivity.command import Request, sensitivity_of

    request = Request(
        scheme,
        tuple(parameter or ()),
        width,
        figure,
        listed(parts),
        values,
        base,
        trajectories,
        second_order,
        distribution,
        tuple(deviation or ()),
        transform,
        servo_period,
        seed,
        threads,
    )
    found = sensitivity_of(file, out, request, plugins=tuple(plugin or ()), plots=tuple(plots or ()), progress=wants_progress(as_json))
    if as_json:
        emit_json(found.summary)
    else:
        say(found.text)
    return 0
