"""``contourlab compare``: schemes of a scenario side by side, with what each costs at run time; or runs from files."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.app.command_line import as_typed
from contourlab.cli import options as shared
from contourlab.cli.output import conclude


def compare(
    file: shared.ScenarioFile,
    others: Annotated[
        list[str] | None,
        typer.Argument(metavar="[RUN]...", help="To compare finished runs, name at least two: logs, results (.nc) or folders of results."),
    ] = None,
    schemes: shared.Schemes = None,
    trials: shared.Trials = None,
    judge: shared.Judge = None,
    out: shared.Out = Path("results"),
    as_json: shared.Json = False,
    plots: shared.Plots = None,
    pdf: shared.Pdf = False,
    signals: shared.Signals = None,
    interval: shared.WithInterval = None,
    plugin: shared.Plugins = None,
) -> int:
    """Run schemes of a scenario side by side; or compare finished runs from their files."""
    if others:
        from contourlab.features.measure.command import compare_runs

        for_scenario = {"--schemes": schemes, "--trials": trials, "--judge": judge, "--signals": signals, "--interval": interval}
        for option, value in {**for_scenario, "--plugin": plugin}.items():
            if value is not None:
                raise typer.BadParameter("applies to a scenario only: omit it when you compare runs from files", param_hint=option)
        runs = [str(file), *others]
        outcome = compare_runs(runs, out, plots=tuple(plots or ()), command=as_typed(["contourlab", "compare", *runs]))
        return conclude(outcome, as_json)
    from contourlab.features.run.schemes import compare_schemes

    options = shared.options_of(out, as_json, plugin, plots, signals, interval, pdf)
    return conclude(compare_schemes(file, options, schemes=shared.listed(schemes), trials=trials, judge=judge), as_json)
