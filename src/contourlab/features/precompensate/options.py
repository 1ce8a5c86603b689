"""Options of ``contourlab precompensate``."""

from __future__ import annotations

from pathlib import Path

from contourlab.app.options import REQUIRED, option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Dialect, LogAxes, OfPart, Planned, Plugins, Seeded, Shown
from contourlab.errors import ParameterError


@options
class Precompensate(Seeded, Plugins, Planned, Dialect, LogAxes):
    """Correct a part program by the contour error that repeats, so that the same control makes a better part."""

    log: tuple[Path, ...] = option((), "Log of a run of the pass written last; repeatable.", objects="Log")
    passes: Path | None = option(None, "Folder that keeps what was learned, pass after pass.")
    machine: str | None = option(None, "Machine to simulate; with a log, for its play and its limits.")
    controller: str | None = option(None, "Controller to simulate.")
    repeat: int = option(5, "Passes to simulate.", least=1)
    tolerance: str = option("0.5 um", "Largest distance of a written line from the corrected path.", unit="m")
    cap: str = option("1 mm", "Largest displacement of the path.", unit="m")
    lead_in: bool = option(False, "Write a dwell before cuts that begin while the axes still settle.")
    band: str = option("2 %", "By how much cycle time and local speed may grow.")

    def __post_init__(self) -> None:
        super().__post_init__()
        for name, why in {"controller": "the real one is corrected", "planner": "nothing is planned"}.items():
            if self.log and getattr(self, name) is not None:
                raise ParameterError(f"--{name}", repr(getattr(self, name)), f"left out: with --log {why}")
        if not self.log and self.machine is None:
            raise ParameterError("--log", "missing", "the log of a run; or --machine and --controller, to simulate")
        if not self.log and self.passes is not None:
            raise ParameterError("--passes", repr(str(self.passes)), "left out: without --log all passes are simulated here")


@options
class Files(OfPart, Shown):
    """The argument, and what is saved."""

    out: Path = option(REQUIRED, "Program to write.")


COMMANDS = {"precompensate": Command("contourlab.features.precompensate.command:precompensate", Precompensate, Files)}
