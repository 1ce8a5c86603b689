"""``contourlab swap``: does the controller still hold when an axis is swapped?"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import conclude, suggest, suggest_again, wants_progress


def swap(
    file: shared.ScenarioFile,
    axis: Annotated[list[str], typer.Option(help="Axis to swap; repeat for more axes, each with its --with.", show_default=False)],
    others: Annotated[
        list[str], typer.Option("--with", help="Files of the modules that may replace it, separated by commas.", show_default=False)
    ],
    scheme: Annotated[str | None, typer.Option(help="Scheme of the scenario; by default its base.", show_default=False)] = None,
    objective: Annotated[
        str, typer.Option(help="What to minimise: contour_error_integral, contour_error_rms or contour_error_max.")
    ] = "contour_error_integral",
    floor: Annotated[
        str | None,
        typer.Option(help='J_tol, the floor of J in the loss; by default "2 um*s" for the integral, else "1 um".', show_default=False),
    ] = None,
    parameter: shared.Parameters = None,
    width: shared.Width = 4.0,
    local: Annotated[
        list[str] | None,
        typer.Option(
            help="Test this set of local parameters, separated by commas, without a search; repeat for more sets.", show_default=False
        ),
    ] = None,
    exhaustive: Annotated[
        bool, typer.Option("--exhaustive", help="Try all sets of local parameters by size, instead of backward elimination.")
    ] = False,
    origins: Annotated[
        list[str] | None,
        typer.Option(
            "--from",
            help="Controller file to start each search from, or one for each variant, separated by commas; repeat for more.",
            show_default=False,
        ),
    ] = None,
    budget: Annotated[int, typer.Option(help="Candidates of each search.")] = 8000,
    quick: Annotated[bool, typer.Option("--quick", help="Answer within a minute, with its uncertainty.")] = False,
    seed: shared.Seed = 0,
    executor: shared.ExecutorKind = "threads",
    workers: shared.Workers = None,
    gain_margin: shared.GainMargin = 6.0,
    phase_margin: shared.PhaseMargin = 30.0,
    region: Annotated[
        list[str] | None,
        typer.Option(
            help="Range of a machine parameter for the coverage, e.g. axes.x.plant.gain=LOW..HIGH; repeatable.", show_default=False
        ),
    ] = None,
    tolerance: Annotated[
        str | None, typer.Option(help='Largest J accepted in the region, e.g. "5 um*s"; by default the loss decides.', show_default=False)
    ] = None,
    places: Annotated[
        int | None, typer.Option(help="Points of the region at which to search J*, a power of 2; by default 8.", show_default=False)
    ] = None,
    linear: Annotated[
        list[str] | None,
        typer.Option(help="Add linear designs: direct, three-step or lmi; repeatable.", show_default=False),
    ] = None,
    division: Annotated[
        str | None,
        typer.Option(
            help="Parts that move into the axis: drive, observer or controller; by default as few as possible.",
            show_default=False,
        ),
    ] = None,
    ways: Annotated[str | None, typer.Option(help="Messages in both directions or in one: both or one; by default test each.")] = None,
    within: Annotated[str, typer.Option(help="Allowed loss by the network, as a share of the wired J or of J_tol.")] = "10 %",
    message_period: Annotated[str | None, typer.Option(help="Message period of the network; by default the servo period.")] = None,
    delay: Annotated[str | None, typer.Option(help="Delay of a message in each direction; by default none.")] = None,
    jitter: Annotated[str | None, typer.Option(help="Jitter of a message in each direction; by default none.")] = None,
    loss: Annotated[str | None, typer.Option(help="Share of lost messages; by default none.")] = None,
    longest: Annotated[str, typer.Option(help="Longest message period to test.")] = "100 ms",
    out: shared.Out = Path("results"),
    as_json: shared.Json = False,
    plots: shared.Plots = None,
    plugin: shared.Plugins = None,
) -> int:
    """Find out whether one controller serves all modules of a swapped axis, or which parameters must be local."""
    from contourlab.errors import ParameterError
    from contourlab.features.link.command import LinkOptions
    from contourlab.features.swap.command import SwapOptions, swap_scenario
    from contourlab.study.executors import Executor

    if len(axis) != len(others):
        raise ParameterError("--axis", f"{len(axis)} given", f"given as often as --with, {len(others)}")
    if len(set(axis)) != len(axis):
        raise ParameterError("--axis", ", ".join(axis), "given once for each axis, with all files of the axis in one --with")
    network = {"message_period": message_period, "delay": delay, "jitter": jitter, "loss": loss}
    options = SwapOptions(
        objective=objective,
        floor=floor,
        parameters=tuple(parameter or ()),
        width=width,
        local=tuple(local or ()),
        exhaustive=exhaustive,
        origins=tuple(origins or ()),
        budget=budget,
        quick=quick,
        seed=seed,
        executor=Executor(executor, workers),
        gain_margin=gain_margin,
        phase_margin=phase_margin,
        region=tuple(region or ()),
        tolerance=tolerance,
        places=places,
        linear=tuple(linear or ()),
        network=LinkOptions(
            divisions=shared.listed(division),
            ways=shared.listed(ways),
            within=within,
            network={name: text for name, text in network.items() if text is not None},
            longest=longest,
        ),
        plugins=tuple(plugin or ()),
    )
    swaps = [(name, [one.strip() for one in text.split(",")]) for name, text in zip(axis, others, strict=True)]
    outcome = swap_scenario(file, swaps, out, options, scheme=scheme, plots=tuple(plots or ("png",)), progress=wants_progress(as_json))
    code = conclude(outcome, as_json)
    if quick:
        suggest_again(as_json, without="--quick")
    else:
        suggest(as_json, "link", file)
    return code
