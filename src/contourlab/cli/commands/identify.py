"""``contourlab identify``: the model of an axis from logs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import show, suggest, suggest_again

MODEL = "rigid, rigid-by-direction, friction, stiction, first-order, closed-loop, frequency-response, linear-motor, two-mass, two-inertia."


def identify(
    log: Annotated[list[Path], typer.Argument(metavar="LOG...", help="Logs of runs that excite the axis.", show_default=False)],
    model: Annotated[str, typer.Option(help=MODEL)] = "rigid",
    axis: Annotated[str | None, typer.Option(help="The axis, if the log has several.", show_default=False)] = None,
    gain: Annotated[str | None, typer.Option(help='Force per command, e.g. "35 N/V", if the log has no force.', show_default=False)] = None,
    full_scale: Annotated[
        str | None, typer.Option(help='Full scale of the command, e.g. "10 V", if the force is unknown.', show_default=False)
    ] = None,
    column: shared.ColumnTexts = None,
    columns: shared.ColumnFile = None,
    format: shared.LogFormat = None,  # noqa: A002
    period: shared.SamplePeriod = None,
    cutoff: Annotated[str, typer.Option(help="rigid: cut-off of the low-pass, five times the loop's bandwidth.")] = "100 Hz",
    slowest: Annotated[str | None, typer.Option(help='rigid: drop samples below this speed, e.g. "1 mm/s".', show_default=False)] = None,
    decimation: Annotated[int, typer.Option(help="rigid: use every N-th sample.")] = 10,
    validation: Annotated[Path | None, typer.Option(help="rigid: a second log for validation.", show_default=False)] = None,
    position_gain: Annotated[str | None, typer.Option(help='closed-loop: K_P, e.g. "4 full_scale/mm".', show_default=False)] = None,
    velocity_gain: Annotated[str | None, typer.Option(help='closed-loop: K_V, e.g. "0.1 full_scale*s/mm".', show_default=False)] = None,
    lead: Annotated[
        str | None,
        typer.Option(help='Travel per turn, e.g. "10 mm": converts torques to forces; two-inertia needs it.', show_default=False),
    ] = None,
    motor_inertia: Annotated[
        str | None,
        typer.Option(help='two-inertia at the load: inertia of motor and screw, e.g. "2 kg*cm^2"; for an axis file.', show_default=False),
    ] = None,
    side: Annotated[str, typer.Option(help="two-mass, two-inertia: where the position is measured, motor or load.")] = "motor",
    excitation: Annotated[
        str, typer.Option(help="Frequency response: reference, where it moves; or command, if a test signal is added to it.")
    ] = "reference",
    write: shared.Write = None,
    out: shared.Out = Path("results"),
    as_json: shared.Json = False,
    plots: shared.Plots = None,
) -> int:
    """Identify a model of an axis from logs; write an axis file with uncertainties."""
    from contourlab.features.identify.command import identify_log
    from contourlab.features.identify.request import Request
    from contourlab.features.measure.log_choice import LogChoice

    request = Request(
        model=model,
        choices=tuple(LogChoice(file, tuple(column or ()), columns, format, period) for file in log),
        axis=axis,
        gain=gain,
        full_scale=full_scale,
        cutoff=cutoff,
        decimation=decimation,
        slowest=slowest,
        validation=validation,
        position_gain=position_gain,
        velocity_gain=velocity_gain,
        lead=lead,
        motor_inertia=motor_inertia,
        side=side,
        excitation=excitation,
    )
    identification = identify_log(request, out=write, plots=tuple(plots or ()), folder=out)
    show(identification.summary, identification.text, as_json)
    if write is None:
        suggest_again(as_json, "--write", "axis.toml")
    else:
        suggest(as_json, "machines", write)
    return 0 if identification.done else 1
