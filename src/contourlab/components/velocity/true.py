"""Velocity without any error."""

from __future__ import annotations

from contourlab.components.contract import Component
from contourlab.engine.step import Port


class TrueVelocity(Component):
    """The controller sees the plant's velocity itself, as from an ideal tachometer; no node is run for it."""

    family = "velocity"
    kind = "true"
    reference = "identity"
    inputs = (Port("velocity"),)
    outputs = (Port("velocity"),)

    @staticmethod
    def step(par, x, inp, clock):  # type: ignore[no-untyped-def]
        return (), (inp.velocity,)
