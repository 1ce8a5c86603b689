"""Options of ``contourlab measure``."""

from __future__ import annotations

from pathlib import Path

from contourlab.app.options import argument, option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Drawn, OnMachine


@options
class Measure(OnMachine):
    """Judge a measured run like a simulated one: contour error, tracking, reversals."""

    program: Path | None = option(None, "Part program of the run: its path counts.")
    reference: str | None = option(None, "Columns of the reference, separated by commas; or a part program, as --program.")
    shift: str | None = option(None, 'Zero of the part in the log: "fit", or lengths, e.g. "10 mm, 5 mm".')
    axes: tuple[str, ...] = option((), "Axes of the contour, e.g. x,y; by default all.", listed=True)
    tolerance: str | None = option(None, 'Largest contour error that passes, e.g. "25 um".', unit="m")


@options
class Files(Drawn):
    """The argument, and what is saved."""

    log: Path = argument("LOG", "A log: .mat, .csv, .parquet, .xml, .nc, or text from a scope.")


COMMANDS = {"measure": Command("contourlab.features.measure.command:measure", Measure, Files)}
