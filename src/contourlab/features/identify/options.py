"""Options of ``contourlab identify``."""

from __future__ import annotations

from pathlib import Path

from contourlab.app.options import argument, option, options
from contourlab.app.session import Command
from contourlab.app.shared_options import Drawn, LogColumns, Written

MODELS = (
    "rigid, rigid-by-direction, friction, stiction, first-order, closed-loop, frequency-response, linear-motor, two-mass, two-inertia, "
    "resonance, position-loop."
)


@options
class Identify(LogColumns):
    """Identify a model of an axis from logs; write an axis file with uncertainties."""

    model: str | None = option(
        None, f"By default rigid; position-loop for commanded and actual position alone, resonance for accelerations alone; {MODELS}"
    )
    axis: str | None = option(None, 'The axis, if the log has several; position-loop: several, e.g. "x,y", by default all that move.')
    gain: str | None = option(None, 'Force per command, e.g. "35 N/V", if the log has no force.')
    full_scale: str | None = option(None, 'Full scale of the command, e.g. "10 V", if the force is unknown.')
    cutoff: str | None = option(None, 'rigid: cut-off of the low-pass, e.g. "100 Hz": the default, unless the log is too slow.', unit="Hz")
    slowest: str | None = option(None, 'rigid: drop samples below this speed, e.g. "1 mm/s".', unit="m/s")
    decimation: int | None = option(None, "rigid: use every N-th sample; by default every tenth at most.", least=1, advanced=True)
    validation: Path | None = option(None, "rigid, position-loop: a second log for validation.", objects="Log")
    position_gain: str | None = option(None, 'closed-loop: K_P, e.g. "4 full_scale/mm".')
    velocity_gain: str | None = option(None, 'closed-loop: K_V, e.g. "0.1 full_scale*s/mm".')
    lead: str | None = option(None, 'Travel per turn, e.g. "10 mm": converts torques to forces; two-inertia needs it.', unit="m")
    motor_inertia: str | None = option(
        None, 'two-inertia at the load: inertia of motor and screw, e.g. "2 kg*cm^2"; for an axis file.', unit="kg*m^2"
    )
    side: str = option("motor", "two-mass, two-inertia: where the position is measured, motor or load.", choices=("motor", "load"))
    excitation: str = option(
        "reference",
        "Frequency response: reference, where it moves; or command, if a test signal is added to it.",
        choices=("reference", "command"),
    )


@options
class Files(Written, Drawn):
    """The arguments, and what is saved."""

    log: tuple[Path, ...] = argument("LOG...", "Logs of runs that excite the axis.")


COMMANDS = {"identify": Command("contourlab.features.identify.command:identify", Identify, Files)}
