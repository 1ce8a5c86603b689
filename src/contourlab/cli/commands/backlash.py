"""``contourlab backlash``: gaps, limit cycles, compensation."""

from __future__ import annotations

from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import show_result, suggest, wants_progress

Quick = Annotated[bool, typer.Option("--quick", help="Answer within a minute, from the beginning of a long motion.")]


def backlash(
    file: shared.ScenarioFile,
    schemes: shared.Schemes = None,
    quick: Quick = False,
    as_json: shared.Json = False,
    plugin: shared.Plugins = None,
) -> int:
    """Estimate the backlash of each axis, predict limit cycles, and find the best compensation."""
    from contourlab.features.backlash.command import backlash_scenario

    given = {"schemes": shared.listed(schemes), "plugins": tuple(plugin or ()), "quick": quick, "progress": wants_progress(as_json)}
    outcome = backlash_scenario(file, **given)  # type: ignore[arg-type]
    show_result(outcome, as_json)
    suggest(as_json, "compare", file)
    return 0
