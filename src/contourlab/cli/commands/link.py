"""``contourlab link``: controllers divided between base and axes, and what the network between them costs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import say, show_result, suggest, wants_progress


def link(
    file: shared.ScenarioFile,
    schemes: shared.Schemes = None,
    division: Annotated[
        str | None, typer.Option(help="What moves into the axis, with commas: drive, observer, controller.", show_default=False)
    ] = None,
    ways: Annotated[str | None, typer.Option(help="Messages in both directions or in one: both or one.", show_default=False)] = None,
    vary: Annotated[
        str | None, typer.Option(help="What to vary, with commas: message-period, delay, jitter, loss; by default all.", show_default=False)
    ] = None,
    axes: Annotated[
        str | None, typer.Option(help="Axes whose controllers are divided, with commas; by default all.", show_default=False)
    ] = None,
    figure: Annotated[str, typer.Option(help="Figure of the contour error: rms, max or integral.")] = "rms",
    within: Annotated[
        str | None, typer.Option(help="Allowed error above that of the undivided loop; by default 10 %.", show_default=False)
    ] = None,
    tolerance: Annotated[str | None, typer.Option(help='Largest allowed error instead, e.g. "15 um".', show_default=False)] = None,
    message_period: Annotated[
        str | None, typer.Option(help="Message period while another quantity varies; by default the servo period.")
    ] = None,
    delay: Annotated[str | None, typer.Option(help="Delay in each direction while another quantity varies; by default none.")] = None,
    jitter: Annotated[str | None, typer.Option(help="Jitter while another quantity varies; by default none.")] = None,
    loss: Annotated[str | None, typer.Option(help="Share of lost messages while another quantity varies; by default none.")] = None,
    extrapolate: Annotated[
        bool, typer.Option("--extrapolate", help="Extrapolate from the last two messages instead of holding the last.")
    ] = False,
    longest: Annotated[str | None, typer.Option(help="Longest time to test; by default 100 ms.", show_default=False)] = None,
    seeds: Annotated[int | None, typer.Option(help="Runs with jitter or loss; the worst counts; by default 8.", show_default=False)] = None,
    quick: Annotated[bool, typer.Option("--quick", help="Answer within a minute: few values, a limit lies between two.")] = False,
    out: shared.Out = Path("results"),
    as_json: shared.Json = False,
    plots: shared.Plots = None,
    plugin: shared.Plugins = None,
) -> int:
    """Divide controllers between base and axes: find the lowest message rate that holds."""
    from contourlab.features.link.command import LinkOptions, link_scenario

    network = {"message_period": message_period, "delay": delay, "jitter": jitter, "loss": loss}
    options = LinkOptions(
        divisions=shared.listed(division),
        ways=shared.listed(ways),
        quantities=shared.listed(vary),
        axes=shared.listed(axes),
        figure=figure,
        within=within,
        tolerance=tolerance,
        network={name: text for name, text in network.items() if text is not None},
        extrapolate=extrapolate,
        longest=longest,
        seeds=seeds,
        quick=quick,
    )
    given = {"schemes": shared.listed(schemes), "plugins": tuple(plugin or ()), "plots": tuple(plots or ()), "folder": out}
    result = link_scenario(file, options, **given, progress=wants_progress(as_json))  # type: ignore[arg-type]
    show_result(result, as_json)
    if not as_json:
        say(f"\nresults: {out}")
    suggest(as_json, "sensitivity", file)
    return 0
