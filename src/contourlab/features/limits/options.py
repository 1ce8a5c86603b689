"""Options of ``contourlab limits``."""

from __future__ import annotations

from pathlib import Path

from contourlab.app.options import argument, option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Dialect, LogAxes, Planned, Shown


@options
class Limits(Planned, Dialect, LogAxes):
    """Compare commanded velocity, acceleration and jerk with the limits of a machine; show the worst program lines."""

    machine: str | None = option(None, "Machine whose limits hold; by default a program keeps those given, else of xyz.", objects="Machine")
    velocity: str | None = option(None, 'Limit, e.g. "200 mm/s" or "x=200 mm/s, y=100 mm/s".')
    acceleration: str | None = option(None, 'Limit, e.g. "2 m/s^2".')
    jerk: str | None = option(None, 'Limit, e.g. "50 m/s^3".')
    tolerance: str | None = option(None, 'By how much a limit may be exceeded; by default "0.5 %".')
    program: Path | None = option(None, "Program of the log: places get its lines.")
    line_column: str | None = option(None, "Column of the log with program lines.")


@options
class Files(Shown):
    """The argument, and what is saved."""

    file: Path = argument("LOG|PROGRAM", "A log, or a part program to plan.")
    annotate: Path | None = option(None, "Program to write: times, limits and errors as comments, same moves.")


COMMANDS = {"limits": Command("contourlab.features.limits.command:limits", Limits, Files)}
