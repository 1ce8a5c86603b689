"""``contourlab commission``: from the files and logs of a control to its gains."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import show_result, suggest, wants_progress
from contourlab.errors import ParameterError

commission = typer.Typer(help="Commission the servo loops of a control: what to run, then the gains.", no_args_is_help=True)


@commission.callback()
def _commission() -> None:
    """Commission the servo loops of a control: what to run, then the gains."""


@commission.command("linuxcnc")
def linuxcnc(
    ini: Annotated[Path, typer.Argument(metavar="INI", help="The machine's INI file.", show_default=False)],
    hal: Annotated[Path, typer.Argument(metavar="HAL", help="The HAL file with its pid components.", show_default=False)],
    log: Annotated[
        list[Path] | None, typer.Option(help="Log of a run with the present gains; repeatable. Without: what to run.", show_default=False)
    ] = None,
    program: Annotated[
        Path | None, typer.Option(help="Part program to tune and predict for; by default what the logs ran.", show_default=False)
    ] = None,
    control: Annotated[
        str | None,
        typer.Option("--for", help="Give the gains in the terms of sinumerik, twincat or generic too.", show_default=False),
    ] = None,
    gain_margin: shared.GainMargin = 6.0,
    phase_margin: shared.PhaseMargin = 30.0,
    seed: shared.Seed = 0,
    out: shared.Out = Path("commissioning"),
    as_json: shared.Json = False,
) -> int:
    """Write an excitation for LinuxCNC; with --log, find the gains of each HAL pid."""
    from contourlab.features.commission.command import commission as commissioned
    from contourlab.features.commission.command import prepare

    if not log:
        if control or program:
            option, value = ("--for", control) if control else ("--program", program)
            raise ParameterError(option, str(value), "given with --log")
        result = prepare(ini, hal, out)
        show_result(result, as_json)
        if result.files:
            suggest(as_json, "commission", "linuxcnc", ini, hal, "--log", "log1.txt", "--out", out)
        return 0 if result.passed else 1
    given = {"margins": (gain_margin, phase_margin), "seed": seed, "progress": wants_progress(as_json)}
    result = commissioned(ini, hal, log, out, program=program, control=control, **given)  # type: ignore[arg-type]
    show_result(result, as_json)
    if result.pid:
        suggest(as_json, "commission", "linuxcnc", ini, hal, "--log", "log2.txt", "--out", out)  # of the safe gains
    return 0 if result.passed else 1
