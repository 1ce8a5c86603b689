"""Options of ``contourlab record``."""

from __future__ import annotations

from pathlib import Path

from contourlab.app.options import Options, argument, option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Saved


@options
class Record(Options):
    """Write a HAL file and a script that record a run of LinuxCNC for measure."""


@options
class Files(Saved):
    """The argument, and what is saved."""

    ini: Path = argument("INI", "The machine's INI file.")
    out: Path = option(Path("recording"), "Folder for the two files; created if missing.")


COMMANDS = {"record": Command("contourlab.features.record.command:record", Record, Files)}
