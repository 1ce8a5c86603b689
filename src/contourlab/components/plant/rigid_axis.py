"""A servo axis with an identified velocity response: gain and damping."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import param
from contourlab.components.plant.plant import SingleMass


class RigidAxis(SingleMass):
    """Rigid axis with a normalised drive: p' = v, v' = -b v + a (u + d).

    The command u and the disturbance d, friction included, are fractions of the drive's full scale. The steady velocity per command is a/b,
    the time constant 1/b. Valid below the first resonance of the drive train.

    References
    ----------
    Ghaffari & Ulsoy, "Component swapping modularity for distributed precision contouring", eqs (1) and (2).
    """

    kind = "rigid-axis"
    example = {"gain": 1.695, "damping": 10.1}
    reference = "Ghaffari & Ulsoy, eqs 1-2"
    command_unit = "full_scale"
    force_unit = "full_scale"

    gain: float = param(
        unit="m/s^2/full_scale",
        minimum=0.0,
        exclusive=True,
        display="mm/s^2/full_scale",
        doc="acceleration at full command, a",
        source="Ghaffari & Ulsoy, eq 2",
    )
    damping: float = param(default=0.0, unit="1/s", minimum=0.0, doc="decay rate of a free motion, b", source="Ghaffari & Ulsoy, eq 2")

    @staticmethod
    def mobility(par: Any) -> float:
        return par.gain  # type: ignore[no-any-return]

    @staticmethod
    def decay(par: Any) -> float:
        return par.damping  # type: ignore[no-any-return]

    @staticmethod
    def drive_force(par: Any, command: float) -> float:
        return command
