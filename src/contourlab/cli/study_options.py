"""Options that `contourlab sensitivity`, `contourlab tune` and `contourlab swap` share: what is moved, what is to be kept, runs."""

from __future__ import annotations

from typing import Annotated, TypeAlias

import typer

Parameters: TypeAlias = Annotated[
    list[str] | None,
    typer.Option(
        "--parameter",
        metavar="NAME[=LOW..HIGH]",
        help='A number to move, as "3.position_gain=2 full_scale/mm..8 full_scale/mm"; may be given again; by default all that is '
        "calibrated.",
        show_default=False,
    ),
]
Width: TypeAlias = Annotated[float, typer.Option(help="Bounds are the value divided and multiplied by this where none are given.")]
GainMargin: TypeAlias = Annotated[float, typer.Option(help="Least gain margin of an axis, in dB.")]
PhaseMargin: TypeAlias = Annotated[float, typer.Option(help="Least phase margin of an axis, in degrees.")]
Seed: TypeAlias = Annotated[int, typer.Option(help="Of samplings and searches: the same seed gives the same answer.")]
Threads: TypeAlias = Annotated[
    int | None, typer.Option(help="One for each processor by default; results do not hang on it.", show_default=False)
]
