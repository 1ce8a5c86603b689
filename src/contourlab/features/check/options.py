"""Options of ``contourlab check`` and ``canon``."""

from __future__ import annotations

from contourlab.app.options import option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Dialect, OfPart, Planned, Shown


@options
class Check(Planned, Dialect):
    """List every fault of a part program with line and column; print its box, feeds and cycle time."""

    machine: str | None = option(
        None,
        "Machine for cycle time and travel: a file, or the name of a shipped one. By default builtin:xyz; "
        "moves beyond its travel are then not faults.",
        objects="Machine",
    )


@options
class Canon(Dialect):
    """Print the moves of a part program: tool tip in mm in machine coordinates, feed in mm/min."""


COMMANDS = {
    "check": Command("contourlab.features.check.program_check:check", Check, OfPart, Shown),
    "canon": Command("contourlab.features.check.canon:canon", Canon, OfPart, Shown),
}
