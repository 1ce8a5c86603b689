"""Ideal parts: what goes in comes out. The loop runs no node for them."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import Component
from contourlab.engine.step import Port


class _Identity(Component):
    reference = "identity"

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (inp[0],)


class IdealSensor(_Identity):
    """The controller sees the axis' position as it is."""

    family = "sensor"
    kind = "ideal"
    inputs = (Port("position"),)
    outputs = (Port("position"),)


class TrueVelocity(_Identity):
    """The controller sees the plant's velocity itself, as from an ideal tachometer."""

    family = "velocity"
    kind = "true"
    inputs = (Port("velocity"),)
    outputs = (Port("velocity"),)


class IdealLink(_Identity):
    """The other side sees the signal as it is, at the same tick."""

    family = "link"
    kind = "ideal"
    inputs = (Port("sent"),)
    outputs = (Port("received"),)
