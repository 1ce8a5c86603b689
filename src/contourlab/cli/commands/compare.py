"""``contourlab compare``: schemes of a scenario side by side, with what each costs at run time."""

from __future__ import annotations

from pathlib import Path

from contourlab.cli.output import conclude, wants_progress
from contourlab.cli.scheme_options import Json, Out, Plots, Plugins, ScenarioFile, Schemes, Signals, Trials, listed

__all__ = ["compare"]


def compare(
    file: ScenarioFile,
    schemes: Schemes = None,
    trials: Trials = None,
    out: Out = Path("results"),
    as_json: Json = False,
    plots: Plots = None,
    signals: Signals = None,
    plugin: Plugins = None,
) -> int:
    """Run schemes of a scenario side by side, those that learn trial after trial; say what each costs per servo tick."""
    from contourlab.session.schemes import compare_schemes

    outcome = compare_schemes(
        file,
        out,
        schemes=listed(schemes),
        trials=trials,
        plugins=tuple(plugin or ()),
        plots=tuple(plots or ()),
        signals=tuple(signals or ()),
        progress=wants_progress(as_json),
    )
    return conclude(outcome, as_json)
