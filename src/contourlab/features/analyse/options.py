"""Options of ``contourlab analyse``."""

from __future__ import annotations

from contourlab.app.options import option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Drawn, OfScenario, Schemes


@options
class Analyse(Schemes):
    """Print the margins of each loop and of the coupling, and whether learning converges; simulates nothing."""

    whole: bool = option(False, "Also analyse whole laps and trials on the exact path; takes up to minutes.")


COMMANDS = {"analyse": Command("contourlab.features.analyse.command:analyse", Analyse, OfScenario, Drawn)}
