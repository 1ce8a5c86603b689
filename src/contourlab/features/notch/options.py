"""Options of ``contourlab notch``."""

from __future__ import annotations

from pathlib import Path

from contourlab.app.options import option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Changed, LogColumns, Margins, OfScenario, Shown, WrittenController


@options
class Notch(Margins, Changed, LogColumns):
    """Propose a notch filter for each resonance that spoils a loop; write a controller file."""

    log: Path | None = option(None, "Log of an accelerometer on the axis: its resonance counts, in place of the plant's.", objects="Log")
    scheme: str | None = option(None, "Scheme of the scenario; by default the scenario itself.")
    axes: tuple[str, ...] = option((), "Axes, with commas; by default those whose margins are too small.", listed=True)


COMMANDS = {"notch": Command("contourlab.features.notch.command:notch", Notch, OfScenario, WrittenController, Shown)}
