"""``contourlab learn``: drive the same motion again and again, and learn from trial to trial."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli.output import conclude, wants_progress
from contourlab.cli.scheme_options import Json, Out, Plots, Plugins, ScenarioFile, Schemes, Signals, Trials, WithInterval, listed


def learn(
    file: ScenarioFile,
    schemes: Schemes = None,
    trials: Trials = None,
    table: Annotated[Path | None, typer.Option(help="A learned table to start with.", show_default=False)] = None,
    out: Out = Path("results"),
    as_json: Json = False,
    plots: Plots = None,
    signals: Signals = None,
    interval: WithInterval = None,
    plugin: Plugins = None,
) -> int:
    """Repeat the motion of a scenario and learn from trial to trial; say beforehand whether it converges, and keep what was learned."""
    from contourlab.features.run.schemes import learn_schemes

    outcome = learn_schemes(
        file,
        out,
        schemes=listed(schemes),
        trials=trials,
        table=table,
        plugins=tuple(plugin or ()),
        plots=tuple(plots or ()),
        signals=tuple(signals or ()),
        progress=wants_progress(as_json),
        interval=interval,
    )
    return conclude(outcome, as_json)
