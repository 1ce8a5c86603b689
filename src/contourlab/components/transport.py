"""Delays of any length, in whole servo periods and a fraction of one."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from contourlab.components.contract import Component


class Transport(Component):
    """Base of components with a `delay`: `whole` servo periods, and a `fraction` of one."""

    derived: ClassVar[tuple[str, ...]] = ("whole", "fraction")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        periods = par.delay / dt
        # Rounding must not make a whole delay a fraction.
        whole = np.floor(periods + 1e-9)
        return whole, np.maximum(periods - whole, 0.0)

    def ring_length(self, dt: float) -> int:
        return int(Transport.derive(self, self, dt)[0]) + 2
