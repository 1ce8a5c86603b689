"""``contourlab analyse``: margins, coupling and convergence of learning, before anything runs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli.options import Json, Out, Plots, Plugins, ScenarioFile, Schemes, listed
from contourlab.cli.output import show_result


def analyse(
    file: ScenarioFile,
    schemes: Schemes = None,
    out: Out = Path("results"),
    as_json: Json = False,
    plots: Plots = None,
    plugin: Plugins = None,
    whole: Annotated[
        bool, typer.Option("--whole", help="Look at laps and trials as a whole too, on the very path: up to minutes.")
    ] = False,
) -> int:
    """Say before anything runs how far each loop and the coupling are from instability, and whether learning converges."""
    from contourlab.features.analyse.command import analyse_scenario

    found = analyse_scenario(file, schemes=listed(schemes), plugins=tuple(plugin or ()), plots=tuple(plots or ()), out=out, whole=whole)
    show_result(found, as_json)
    return 0 if found.good else 1
