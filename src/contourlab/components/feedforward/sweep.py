"""A test signal in the command, as the function generator of a drive adds it."""

from __future__ import annotations

import math
from typing import Any

from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.primitives import floor, sin


class Sweep(Component):
    """Sine of rising or falling frequency, over and over: u = A sin(2 pi (f_0 t + (f_1 - f_0) t^2/(2 T))), t from 0 to T.

    For the identification of an axis from its log. Choose A well above friction and below the drive's limit. With several whole periods
    the response is free of leakage.
    """

    family = "feedforward"
    kind = "sweep"
    example = {"amplitude": 2.0, "first_frequency": 30.0, "last_frequency": 90.0, "duration": 0.1}
    reference = "Pintelon & Schoukens, System Identification, 2nd ed., section 5.2 (swept sine)"
    outputs = (Port("command"),)
    derived = ("rate",)

    amplitude: float = param(unit="{command}", minimum=0.0, doc="A")
    first_frequency: float = param(default=2.0, unit="Hz", minimum=0.0, doc="at the start of a period, f_0")
    last_frequency: float = param(unit="Hz", minimum=0.0, doc="at its end, f_1")
    duration: float = param(unit="s", minimum=0.0, exclusive=True, doc="of a period, T")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return ((par.last_frequency - par.first_frequency) / par.duration,)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        # Rounding must not begin a period a tick late.
        t = clock.t - par.duration * floor(clock.t / par.duration + 1e-9)
        return (), (par.amplitude * sin(2.0 * math.pi * (par.first_frequency + 0.5 * par.rate * t) * t),)
