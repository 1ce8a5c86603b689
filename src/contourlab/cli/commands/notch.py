"""``contourlab notch``: notch filters for the structural resonances of a scenario."""

from __future__ import annotations

from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import show_result, suggest, suggest_again


def notch(
    file: shared.ScenarioFile,
    scheme: Annotated[str | None, typer.Option(help="Scheme of the scenario; by default the scenario itself.", show_default=False)] = None,
    axes: Annotated[
        str | None, typer.Option(help="Axes, with commas; by default those whose margins are too small.", show_default=False)
    ] = None,
    gain_margin: shared.GainMargin = 6.0,
    phase_margin: shared.PhaseMargin = 30.0,
    write: shared.Write = None,
    as_json: shared.Json = False,
    plugin: shared.Plugins = None,
) -> int:
    """Propose a notch filter for each resonance that spoils a loop; write a controller file."""
    from contourlab.features.notch.command import notch_scenario
    from contourlab.study.guards import Bounds

    bounds = Bounds(gain_margin, phase_margin)
    notched = notch_scenario(file, scheme=scheme, axes=shared.listed(axes), bounds=bounds, out=write, plugins=tuple(plugin or ()))
    show_result(notched, as_json)
    if write is None and notched.designs:
        suggest_again(as_json, "--write", "notched.toml")
    else:
        suggest(as_json, "analyse", file)
    return 0 if notched.passed else 1
