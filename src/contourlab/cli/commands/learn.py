"""``contourlab learn``: drive the same motion again and again, and learn from trial to trial."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import conclude


def learn(
    file: shared.ScenarioFile,
    schemes: shared.Schemes = None,
    trials: shared.Trials = None,
    judge: shared.Judge = None,
    table: Annotated[Path | None, typer.Option(help="A learned table to start with.", show_default=False)] = None,
    out: shared.Out = Path("results"),
    as_json: shared.Json = False,
    plots: shared.Plots = None,
    pdf: shared.Pdf = False,
    signals: shared.Signals = None,
    interval: shared.WithInterval = None,
    plugin: shared.Plugins = None,
) -> int:
    """Repeat the motion of a scenario, learn from each trial, keep the result; predicts whether it converges."""
    from contourlab.features.run.schemes import learn_schemes

    options = shared.options_of(out, as_json, plugin, plots, signals, interval, pdf)
    return conclude(learn_schemes(file, options, schemes=shared.listed(schemes), trials=trials, judge=judge, table=table), as_json)
