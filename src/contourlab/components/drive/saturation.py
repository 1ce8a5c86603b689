"""Drives with a limit on the command, without and with a transport delay."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.components.contract import Component, LinearModel, param
from contourlab.components.transport import Transport
from contourlab.engine.step import Port
from contourlab.primitives import clip, delayed


class Saturation(Component):
    """Ideal amplifier with a limit on its command; the command is held over the servo period."""

    family = "drive"
    kind = "saturation"
    example = {"limit": 0.5}
    reference = "zero-order hold with saturation"

    limit: float = param(default=math.inf, unit="{command}", minimum=0.0, exclusive=True, doc="largest command in either direction")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (clip(inp.command, -par.limit, par.limit),)

    def linearize(self) -> LinearModel:
        none = np.zeros((0, 0))
        return LinearModel(none, np.zeros((0, 1)), np.zeros((1, 0)), np.ones((1, 1)), ("command",), ("applied",))


class DelayedSaturation(Transport):
    """Amplifier with a command limit and a transport delay of any length.

    The delay is n servo periods and a fraction f of one. The applied command is the mean of two neighbouring commands weighted by f, which
    is exactly the average of the delayed held command over the period. ``accepted`` is the command after the limit and before the delay, so
    that anti-windup does not take the delay for a limit.
    """

    family = "drive"
    kind = "delayed-saturation"
    example = {"limit": 0.5, "delay": 0.0123}
    reference = "transport delay of a sampled command"
    outputs = (Port("applied"), Port("accepted"))
    ring = "command"

    limit: float = param(default=math.inf, unit="{command}", minimum=0.0, exclusive=True, doc="largest command in either direction")
    delay: float = param(unit="s", minimum=0.0, maximum=10.0, display="ms", doc="time from command to effect")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        # The limit comes before the delay: the mean is that of the accepted commands.
        newer = clip(delayed(par.ring, clock, par.whole), -par.limit, par.limit)
        older = clip(delayed(par.ring, clock, par.whole + 1.0), -par.limit, par.limit)
        return (), (newer + par.fraction * (older - newer), clip(inp.command, -par.limit, par.limit))
