"""Options of ``contourlab interpolate``."""

from __future__ import annotations

from pathlib import Path

from contourlab.app.options import Options, argument, option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Shown


@options
class Interpolate(Options):
    """Correct quadrature signals of an encoder, interpolate them to counts, and measure their errors."""

    pitch: str = option("20um", "Travel of one period of the signals.", unit="m")
    resolution: str = option("25nm", "Travel of a count: the pitch divided by four times a whole number.", unit="m")
    columns: str | None = option(None, "The two signals by name or number, the cosine first, e.g. u1,u2.")
    reference: str | None = option(None, "Column with the true position; by default the one named reference.")
    forgetting: float | None = option(
        None, "Correct by recursive least squares with this forgetting factor, 0.995 to 0.9995.", advanced=True
    )


@options
class Files(Shown):
    """The argument, and what is saved."""

    file: Path = argument("SIGNALS", "Table of numbers (.csv) with two signals.")
    out: Path | None = option(None, "Folder for counts, constants and picture.")


COMMANDS = {"interpolate": Command("contourlab.features.interpolate.command:interpolate", Interpolate, Files)}
