"""A sinusoidal force."""

from __future__ import annotations

import math
from typing import Any

from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.primitives import sin


class SineLoad(Component):
    """A force A sin(2 pi f t + phase): an unbalanced spindle, a tooth-passing force."""

    family = "disturbance"
    kind = "sine"
    reference = "harmonic load"
    example = {"amplitude": 2.0, "frequency": 12.0, "phase": 0.3}
    unbounded = ("phase",)
    inputs = (Port("position"),)
    outputs = (Port("force"),)
    derived = ("angular_frequency",)

    amplitude: float = param(unit="{force}", minimum=0.0, doc="amplitude, A")
    frequency: float = param(unit="Hz", minimum=0.0, doc="frequency, f")
    phase: float = param(default=0.0, unit="rad", doc="phase at time 0")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (2.0 * math.pi * par.frequency,)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (par.amplitude * sin(par.angular_frequency * clock.t + par.phase),)
