"""``contourlab link``: controllers divided between base and axes, and what the network between them costs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli.output import emit_json, say, wants_progress
from contourlab.cli.scheme_options import Json, Out, Plots, Plugins, ScenarioFile, Schemes, listed


def link(
    file: ScenarioFile,
    schemes: Schemes = None,
    division: Annotated[
        str | None, typer.Option(help="What is in the axis: drive, observer, controller; with commas between.", show_default=False)
    ] = None,
    ways: Annotated[str | None, typer.Option(help="Messages both ways or one way: both, one.", show_default=False)] = None,
    vary: Annotated[str | None, typer.Option(help="Of message-period, delay, jitter, loss; all by default.", show_default=False)] = None,
    axes: Annotated[str | None, typer.Option(help="Axes whose controllers are divided; all by default.", show_default=False)] = None,
    figure: Annotated[str, typer.Option(help="Of the contour error: rms, max or integral.")] = "rms",
    within: Annotated[
        str | None, typer.Option(help="How much more than the undivided loop's error is allowed; 10 % by default.", show_default=False)
    ] = None,
    tolerance: Annotated[str | None, typer.Option(help='Largest error in its place, as "15 um".', show_default=False)] = None,
    message_period: Annotated[str | None, typer.Option(help="While another is varied; the servo period by default.")] = None,
    delay: Annotated[str | None, typer.Option(help="Each way, while another is varied; none by default.")] = None,
    jitter: Annotated[str | None, typer.Option(help="The same.")] = None,
    loss: Annotated[str | None, typer.Option(help="Part of the messages, the same.")] = None,
    extrapolate: Annotated[bool, typer.Option("--extrapolate", help="Follow the last two messages instead of holding the last.")] = False,
    longest: Annotated[str | None, typer.Option(help="Up to where times are varied; 100 ms by default.", show_default=False)] = None,
    seeds: Annotated[
        int | None, typer.Option(help="Runs of which the worst counts where chance plays a part; 8 by default.", show_default=False)
    ] = None,
    out: Out = Path("results/link"),
    as_json: Json = False,
    plots: Plots = None,
    plugin: Plugins = None,
) -> int:
    """Divide controllers between base and axes: what the network costs, and the smallest message rate that still holds."""
    from contourlab.features.link.command import LinkOptions, link_scenario

    network = {"message_period": message_period, "delay": delay, "jitter": jitter, "loss": loss}
    options = LinkOptions(
        divisions=listed(division),
        ways=listed(ways),
        quantities=listed(vary),
        axes=listed(axes),
        figure=figure,
        within=within,
        tolerance=tolerance,
        network={name: text for name, text in network.items() if text is not None},
        extrapolate=extrapolate,
        longest=longest,
        seeds=seeds,
    )
    given = {"schemes": listed(schemes), "plugins": tuple(plugin or ()), "plots": tuple(plots or ()), "folder": out}
    found = link_scenario(file, options, **given, progress=wants_progress(as_json))  # type: ignore[arg-type]
    if as_json:
        emit_json(found)
    else:
        say(found.text)
    return 0
