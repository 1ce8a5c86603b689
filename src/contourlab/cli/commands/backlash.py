"""``contourlab backlash``: gaps, limit cycles, compensation."""

from __future__ import annotations

from contourlab.cli.options import Json, Plugins, ScenarioFile, Schemes, listed
from contourlab.cli.output import show_result, suggest, wants_progress


def backlash(file: ScenarioFile, schemes: Schemes = None, as_json: Json = False, plugin: Plugins = None) -> int:
    """Estimate the backlash of each axis, predict limit cycles, and find the best compensation."""
    from contourlab.features.backlash.command import backlash_scenario

    outcome = backlash_scenario(file, schemes=listed(schemes), plugins=tuple(plugin or ()), progress=wants_progress(as_json))
    show_result(outcome, as_json)
    suggest(as_json, "compare", file)
    return 0
