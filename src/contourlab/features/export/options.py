"""Options of ``contourlab export``."""

from __future__ import annotations

from pathlib import Path

from contourlab.app.options import REQUIRED, argument, option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Plugins, Saved

LANGUAGES = ("c99", "hal", "st", "fmu")


@options
class Export(Plugins):
    """Write the controller of each axis as code for a control."""

    to: str = option(REQUIRED, "Language: c99, hal (LinuxCNC), st (IEC 61131-3) or fmu (FMI 2.0 and 3.0).", choices=LANGUAGES)
    machine: str | None = option(None, "Machine of the controller: a file, a folder, or the name of a shipped one.")
    scheme: str | None = option(None, "Scheme of the scenario; by default the scenario itself.")
    axis: tuple[str, ...] = option((), "Axes, with commas; by default all.", listed=True)


@options
class Files(Saved):
    """The argument, and what is saved."""

    file: str = argument("SCENARIO|CONTROLLER", "A scenario, or a controller with --machine.")
    out: Path = option(Path("export"), "Folder for the results; created if missing.")


COMMANDS = {"export": Command("contourlab.features.export.command:export", Export, Files)}
