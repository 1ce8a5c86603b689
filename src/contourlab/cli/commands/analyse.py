"""``contourlab analyse``: margins, coupling and convergence of learning, before anything runs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli.options import Json, Out, Plots, Plugins, ScenarioFile, Schemes, listed
from contourlab.cli.output import show_result, suggest


def analyse(
    file: ScenarioFile,
    schemes: Schemes = None,
    out: Out = Path("results"),
    as_json: Json = False,
    plots: Plots = None,
    plugin: Plugins = None,
    whole: Annotated[
        bool, typer.Option("--whole", help="Also analyse whole laps and trials on the exact path; takes up to minutes.")
    ] = False,
) -> int:
    """Print the margins of each loop and of the coupling, and whether learning converges; simulates nothing."""
    from contourlab.features.analyse.command import analyse_scenario

    analysis = analyse_scenario(file, schemes=listed(schemes), plugins=tuple(plugin or ()), plots=tuple(plots or ()), out=out, whole=whole)
    show_result(analysis, as_json)
    suggest(as_json, "compare", file, "--schemes", schemes)
    return 0 if analysis.good else 1
