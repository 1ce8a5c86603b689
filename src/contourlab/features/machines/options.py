"""Options of ``contourlab new``."""

from __future__ import annotations

from pathlib import Path

from contourlab.app.options import Options, option, options
from contourlab.app.session import Command, Commands
from contourlab.errors import ParameterError


@options
class NewMachine(Options):
    """Ask for data-sheet values; write a machine and a controller that fits it."""

    out: Path = option(Path("machine"), "Folder for the files.")
    answers: Path | None = option(None, "Take the answers from a TOML file and ask nothing.", metavar="FILE")
    from_: Path | None = option(
        None, "Ask only what a control's own file lacks: INI of LinuxCNC, $$ of grbl, yaml of FluidNC.", metavar="FILE"
    )
    preset: str | None = option(None, "Take typical answers and ask nothing: router, mill or stage.", metavar="CLASS")
    template: bool = option(False, "Print a file of answers to fill in, and write nothing.")
    force: bool = option(False, "Overwrite existing files.")

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.answers is not None and self.preset is not None:
            raise ParameterError("--preset", repr(self.preset), "left out where --answers is given")


COMMANDS = {"new": Commands("Write files to start from.", {"machine": Command("contourlab.cli.new:machine", NewMachine, Options)})}
