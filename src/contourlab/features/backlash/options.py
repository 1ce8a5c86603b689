"""Options of ``contourlab backlash``."""

from __future__ import annotations

from contourlab.app.options import option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import OfScenario, Schemes, Shown


@options
class Backlash(Schemes):
    """Estimate the backlash of each axis, predict limit cycles, and find the best compensation."""

    quick: bool = option(False, "Answer within a minute, from the beginning of a long motion.")


COMMANDS = {"backlash": Command("contourlab.features.backlash.command:backlash", Backlash, OfScenario, Shown)}
