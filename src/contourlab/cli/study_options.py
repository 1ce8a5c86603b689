"""Options shared by `contourlab sensitivity`, `tune` and `swap`: parameters to vary, margins to keep, seeds and threads."""

from __future__ import annotations

from typing import Annotated, TypeAlias

import typer

Parameters: TypeAlias = Annotated[
    list[str] | None,
    typer.Option(
        "--parameter",
        metavar="NAME[=LOW..HIGH]",
        help='Parameter to vary, as "3.position_gain=2 full_scale/mm..8 full_scale/mm"; repeatable; by default all that is calibrated.',
        show_default=False,
    ),
]
Width: TypeAlias = Annotated[float, typer.Option(help="Range of a parameter without bounds: its value divided and multiplied by this.")]
GainMargin: TypeAlias = Annotated[float, typer.Option(help="Least gain margin of an axis, in dB.")]
PhaseMargin: TypeAlias = Annotated[float, typer.Option(help="Least phase margin of an axis, in degrees.")]
Seed: TypeAlias = Annotated[int, typer.Option(help="Of samplings and searches; the same seed gives the same result.")]
Threads: TypeAlias = Annotated[
    int | None, typer.Option(help="By default one per processor; results do not depend on it.", show_default=False)
]
