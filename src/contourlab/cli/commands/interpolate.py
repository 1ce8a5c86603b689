"""``contourlab interpolate``: correct and interpolate the signals of an encoder."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import show, suggest, suggest_again


def interpolate(
    file: Annotated[Path, typer.Argument(metavar="SIGNALS", help="Table of numbers (.csv) with two signals.", show_default=False)],
    pitch: Annotated[str, typer.Option(help="Travel of one period of the signals.")] = "20um",
    resolution: Annotated[str, typer.Option(help="Travel of a count: the pitch divided by four times a whole number.")] = "25nm",
    columns: Annotated[
        str | None, typer.Option(help="The two signals by name or number, the cosine first, e.g. u1,u2.", show_default=False)
    ] = None,
    reference: Annotated[
        str | None, typer.Option(help="Column with the true position; by default the one named reference.", show_default=False)
    ] = None,
    forgetting: Annotated[
        float | None,
        typer.Option(help="Correct by recursive least squares with this forgetting factor, 0.995 to 0.9995.", show_default=False),
    ] = None,
    out: Annotated[Path | None, typer.Option(help="Folder for counts, constants and picture.", show_default=False)] = None,
    as_json: shared.Json = False,
) -> int:
    """Correct quadrature signals of an encoder, interpolate them to counts, and measure their errors."""
    from contourlab.features.interpolate.command import interpolate_file
    from contourlab.features.interpolate.text import text

    result = interpolate_file(file, out, pitch=pitch, resolution=resolution, columns=columns, reference=reference, forgetting=forgetting)
    show(result, text(result), as_json)
    if out is None:
        suggest_again(as_json, "--out", "interpolated")
    else:
        suggest(as_json, "components", "quadrature-encoder")
    return 1 if result.missed["n_sample"] else 0
