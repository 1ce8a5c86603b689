"""Ideal parts: the output equals the input. The loop runs no node for them."""

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
    """Ideal sensor: the controller sees the true position."""

    family = "sensor"
    kind = "ideal"


class TrueVelocity(_Identity):
    """Ideal tachometer: the controller sees the plant's velocity."""

    family = "velocity"
    kind = "true"
    inputs = (Port("velocity"),)


class IdealLink(_Identity):
    """Ideal link: the receiver sees the signal unchanged, at the same tick."""

    family = "link"
    kind = "ideal"
