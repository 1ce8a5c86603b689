"""Options of ``contourlab commission``."""

from __future__ import annotations

from pathlib import Path

from contourlab.app.options import argument, option, options
from contourlab.app.session import Command, Commands
from contourlab.app.shared_options import LogColumns, LogWindow, Margins, Saved, Seeded, Shown
from contourlab.errors import ParameterError


@options
class LinuxCNC(Seeded, Margins, LogWindow):
    """Write an excitation for LinuxCNC; with --log, find the gains of each HAL pid."""

    log: tuple[Path, ...] = option((), "Log of a run with the present gains; repeatable. Without: what to run.", objects="Log")
    program: Path | None = option(None, "Part program to tune and predict for; by default what the logs ran.")
    drive: str = option("", "What the drives take, torque or velocity; by default as found.", choices=("", "torque", "velocity"))

    def __post_init__(self) -> None:
        super().__post_init__()
        for name in ("program", "drive"):
            if getattr(self, name) and not self.log:
                raise ParameterError(self.PARTS[name].typed, str(getattr(self, name)), "given with --log")


@options
class Files(Saved):
    """The arguments, and what is saved."""

    ini: Path = argument("INI", "The machine's INI file.")
    hal: Path = argument("HAL", "The HAL file with its pid components.")
    out: Path = option(Path("commissioning"), "Folder for the results; created if missing.")


@options
class OfLog(LogColumns):
    """Find gain and feedforward of each position loop from a log of any control."""

    axis: str | None = option(None, 'Axes, e.g. "x,y"; by default all that move.')
    for_: str = option("generic", "Control whose terms to use.", choices=("generic", "sinumerik", "twincat", "cia402"))
    proportional: bool = option(False, "The position controller has no integral; by default both are tried.")
    gain: str | None = option(None, 'Force per drive command, e.g. "35 N/V", if it is a torque.')
    lead: str | None = option(None, 'Travel per turn, e.g. "10 mm": converts torques to forces.', unit="m")


@options
class OfRelay(LogColumns):
    """Find ultimate gain and period of each axis from a log of a relay experiment, and gains by rules."""

    axis: str | None = option(None, 'Axes, e.g. "x,y"; by default all whose command changes.')


@options
class LogFiles(Shown):
    """The argument."""

    log: Path = argument("LOG", "Log of a run, with the signals that the command names.")


COMMANDS = {
    "commission": Commands(
        "Commission the servo loops of a control: what to run, then the gains.",
        {
            "linuxcnc": Command("contourlab.features.commission.command:commission", LinuxCNC, Files),
            "log": Command("contourlab.features.commission.log_command:log", OfLog, LogFiles),
            "relay": Command("contourlab.features.commission.relay_command:relay", OfRelay, LogFiles),
        },
    )
}
