"""Options of ``contourlab notch``."""

from __future__ import annotations

from contourlab.app.options import option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Margins, OfScenario, Plugins, Shown, WrittenController


@options
class Notch(Margins, Plugins):
    """Propose a notch filter for each resonance that spoils a loop; write a controller file."""

    scheme: str | None = option(None, "Scheme of the scenario; by default the scenario itself.")
    axes: tuple[str, ...] = option((), "Axes, with commas; by default those whose margins are too small.", listed=True)


COMMANDS = {"notch": Command("contourlab.features.notch.command:notch", Notch, OfScenario, WrittenController, Shown)}
