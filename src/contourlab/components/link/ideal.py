"""A wire in place of a network."""

from __future__ import annotations

from contourlab.components.contract import Component
from contourlab.engine.step import Port


class IdealLink(Component):
    """The other side sees the signal as it is, at the same tick; no node is run for it."""

    family = "link"
    kind = "ideal"
    reference = "identity"
    inputs = (Port("sent"),)
    outputs = (Port("received"),)

    @staticmethod
    def step(par, x, inp, clock):  # type: ignore[no-untyped-def]
        return (), (inp.sent,)
