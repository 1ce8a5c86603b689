"""A sensor without any error."""

from __future__ import annotations

from contourlab.components.contract import Component
from contourlab.engine.step import Port


class IdealSensor(Component):
    """The controller sees the axis' position as it is; no node is run for it."""

    family = "sensor"
    kind = "ideal"
    reference = "identity"
    inputs = (Port("position"),)
    outputs = (Port("position"),)

    @staticmethod
    def step(par, x, inp, clock):  # type: ignore[no-untyped-def]
        return (), (inp.position,)
