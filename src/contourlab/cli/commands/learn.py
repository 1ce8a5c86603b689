"""``contourlab learn``: drive the same motion again and again, and learn from trial to trial."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli.options import (
    Json,
    Judge,
    Out,
    Pdf,
    Plots,
    Plugins,
    ScenarioFile,
    Schemes,
    Signals,
    Trials,
    WithInterval,
    listed,
    options_of,
)
from contourlab.cli.output import conclude


def learn(
    file: ScenarioFile,
    schemes: Schemes = None,
    trials: Trials = None,
    judge: Judge = None,
    table: Annotated[Path | None, typer.Option(help="A learned table to start with.", show_default=False)] = None,
    out: Out = Path("results"),
    as_json: Json = False,
    plots: Plots = None,
    pdf: Pdf = False,
    signals: Signals = None,
    interval: WithInterval = None,
    plugin: Plugins = None,
) -> int:
    """Repeat the motion of a scenario, learn from each trial, keep the result; predicts whether it converges."""
    from contourlab.features.run.schemes import learn_schemes

    options = options_of(out, as_json, plugin, plots, signals, interval, pdf)
    return conclude(learn_schemes(file, options, schemes=listed(schemes), trials=trials, judge=judge, table=table), as_json)
