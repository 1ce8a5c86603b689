"""The controller of an axis that closes its own position loop."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import param
from contourlab.components.controller.law import ControlLaw
from contourlab.engine.step import ports


class Steps(ControlLaw):
    """Pass the reference on as position, for a plant that takes positions.

    The count reaches the reference of a servo period at the end of that period, as with LinuxCNC's hostmot2. `age` delays it further: by
    half a period with LinuxCNC's own component ``stepgen``. The same age on all axes only moves the motion in time.
    """

    kind = "steps"
    command_unit = "m"
    reference = "position commands of a control to its step generators"
    example = {"age": 0.5}
    inputs = ports("reference", "reference_velocity")

    age: float = param(default=0.0, minimum=0.0, maximum=1.0, doc="age of the reference in servo periods; LinuxCNC's stepgen: 0.5")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (inp.reference - par.age * clock.dt * inp.reference_velocity,)
