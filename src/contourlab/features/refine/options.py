"""Options of ``contourlab refine``."""

from __future__ import annotations

from pathlib import Path

from contourlab.app.options import REQUIRED, argument, option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Drawn, LogColumns, Plugins, Written


@options
class Refine(Plugins, LogColumns):
    """Fit parameters of a machine and its controllers until the simulation follows a log."""

    log: tuple[Path, ...] = option(REQUIRED, "Log of a run; repeatable.", objects="Log")
    parameter: tuple[str, ...] = option(REQUIRED, 'Parameter to refine: "axes.*.plant.damping" or "NAME=50 N..200 N"; repeatable.')
    also: tuple[str, ...] = option((), "Scenario of the next log, with the same machine and another controller; repeatable.")
    window: tuple[str, ...] = option((), 'Part to fit, e.g. "0.8 s..1.6 s"; one for all logs, or one for each. The whole log is simulated.')
    validation: Path | None = option(None, "Log for validation, under the first scenario.", objects="Log")
    starts: int = option(3, "Number of searches, from the scenario's values and from points around them.", advanced=True)


@options
class Files(Written, Drawn):
    """The argument, and what is saved."""

    scenario: str = argument("SCENARIO", "A scenario (.toml), or the name of a shipped one.")


COMMANDS = {"refine": Command("contourlab.features.refine.command:refine", Refine, Files)}
