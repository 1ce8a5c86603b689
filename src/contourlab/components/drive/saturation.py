"""A drive that gives what it is asked for, up to its limit."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.components.contract import Component, LinearModel, param
from contourlab.engine.step import Port
from contourlab.primitives import clip


class Saturation(Component):
    """Ideal amplifier with a limit on its command; the command is held over the servo period."""

    family = "drive"
    kind = "saturation"
    example = {"limit": 0.5}
    reference = "zero-order hold with saturation"
    inputs = (Port("command"),)
    outputs = (Port("applied"),)

    limit: float = param(default=math.inf, unit="{command}", minimum=0.0, exclusive=True, doc="largest command in either direction")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (clip(inp.command, -par.limit, par.limit),)

    def linearize(self) -> LinearModel:
        none = np.zeros((0, 0))
        return LinearModel(none, np.zeros((0, 1)), np.zeros((1, 0)), np.ones((1, 1)), ("command",), ("applied",))
