"""Friction of a screw that is uneven over a turn, with a constant part."""

from __future__ import annotations

import math
from typing import Any

from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.primitives import cos, floor, sin

_TURN = 2.0 * math.pi


class ScrewRipple(Component):
    """Force over a turn of the screw: F = F_0 + a_1 sin(w p) + b_1 cos(w p) + a_n sin(n w p) + b_n cos(n w p), w = 2 pi/l.

    F_0 is gravity, or half of what friction differs by between the two directions. Once a turn a screw that is bent or set askew grips
    harder; n times a turn a motor cogs. Every part is a number of its own, sines and cosines rather than amplitude and phase, so that a fit
    is linear in them and a batch can vary them; a ripple with many harmonics is "force-ripple".
    """

    family = "disturbance"
    kind = "screw-ripple"
    reference = "Fourier series over a turn, first and one further term"
    example = {"lead": 0.7, "offset": 0.5, "sine": 1.0, "cosine": -0.6, "order": 5.0, "order_sine": 0.4, "order_cosine": 0.3}
    unbounded = ("offset", "sine", "cosine", "order_sine", "order_cosine")
    inputs = (Port("position"),)
    outputs = (Port("force"),)
    derived = ("inverse_lead",)

    lead: float = param(unit="m", minimum=0.0, exclusive=True, display="mm", doc="travel per turn, l")
    offset: float = param(default=0.0, unit="{force}", doc="force at every place, F_0")
    sine: float = param(default=0.0, unit="{force}", doc="once a turn, a_1")
    cosine: float = param(default=0.0, unit="{force}", doc="once a turn, b_1")
    order: float = param(default=2.0, minimum=1.0, maximum=1000.0, whole=True, doc="how often a turn the second term repeats, n")
    order_sine: float = param(default=0.0, unit="{force}", doc="n times a turn, a_n")
    order_cosine: float = param(default=0.0, unit="{force}", doc="n times a turn, b_n")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (1.0 / par.lead,)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        turns = inp.position * par.inverse_lead
        angle = _TURN * (turns - floor(turns))
        force = par.offset + par.sine * sin(angle) + par.cosine * cos(angle)
        angle = par.order * angle
        return (), (force + par.order_sine * sin(angle) + par.order_cosine * cos(angle),)
