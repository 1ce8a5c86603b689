"""Options of ``contourlab circle``."""

from __future__ import annotations

from pathlib import Path

from contourlab.app.options import argument, option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import OnMachine, Saved


@options
class Circle(OnMachine):
    """Find what shapes a measured circle: backlash, spikes, servo mismatch, squareness, scale, cyclic error, vibration."""

    tolerance: str | None = option(None, 'Largest circular deviation that passes, e.g. "8 um".', unit="m")
    radius: str | None = option(None, 'Nominal radius, e.g. "50 mm"; by default as commanded.', unit="m")
    feed: str | None = option(None, 'Feed of a file of angles, e.g. "1000 mm/min": gives times and frequencies.', unit="m/s")
    pitch: str | None = option(None, 'Pitch of the cyclic error, e.g. "10 mm"; by default searched.', unit="m")
    axes: tuple[str, ...] = option((), "The two axes, e.g. x,y; by default the first two.", listed=True)


@options
class Files(Saved):
    """Arguments, and what is saved."""

    logs: tuple[Path, ...] = argument("LOG...", "Logs of a circle, or files of angle and radius: one, or one per sense.")


COMMANDS = {"circle": Command("contourlab.features.circle.command:circle", Circle, Files)}
