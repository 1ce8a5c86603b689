"""``contourlab analyse``: margins, coupling and convergence of learning, before anything runs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import show_result, suggest


def analyse(
    file: shared.ScenarioFile,
    schemes: shared.Schemes = None,
    out: shared.Out = Path("results"),
    as_json: shared.Json = False,
    plots: shared.Plots = None,
    plugin: shared.Plugins = None,
    whole: Annotated[
        bool, typer.Option("--whole", help="Also analyse whole laps and trials on the exact path; takes up to minutes.")
    ] = False,
) -> int:
    """Print the margins of each loop and of the coupling, and whether learning converges; simulates nothing."""
    from contourlab.features.analyse.command import analyse_scenario

    chosen, plugins = shared.listed(schemes), tuple(plugin or ())
    analysis = analyse_scenario(file, schemes=chosen, plugins=plugins, plots=tuple(plots or ()), out=out, whole=whole)
    show_result(analysis, as_json)
    suggest(as_json, "compare", file, "--schemes", schemes)
    return 0 if analysis.good else 1
