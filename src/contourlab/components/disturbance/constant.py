"""A constant force."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import Component, param
from contourlab.engine.step import Port


class ConstantLoad(Component):
    """A force that is there from a given time on: gravity on a vertical axis, a steady cutting force."""

    family = "disturbance"
    kind = "constant"
    reference = "constant load from a given time"
    example = {"force": 2.0, "start": 0.05}
    unbounded = ("force",)
    inputs = (Port("position"),)
    outputs = (Port("force"),)

    force: float = param(unit="{force}", doc="force along the axis")
    start: float = param(default=0.0, unit="s", minimum=0.0, doc="time from which it acts")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (par.force if clock.t >= par.start else 0.0,)
