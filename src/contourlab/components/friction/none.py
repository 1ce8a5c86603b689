"""No friction."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import Component


class NoFriction(Component):
    """A guide without friction besides the plant's own damping."""

    family = "friction"
    kind = "none"
    reference = "no friction"
    law = "smooth"

    @staticmethod
    def force(par: Any, v: float) -> float:
        return 0.0
