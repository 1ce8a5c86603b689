"""Velocity by the difference of two-tap means of the measured position."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import Component
from contourlab.engine.step import Port


class TwoTapDifference(Component):
    """Backward difference of the mean of two neighbouring positions: v_k = (q_k - q_(k-2))/(2 T), a whole tick behind.

    The mean takes out what alternates from tick to tick; there is nothing to set.

    References
    ----------
    Janot, Gautier & Brunot, "Data set and reference models of EMPS", 2019 Workshop on Nonlinear System Identification Benchmarks: the
    velocity of the controller of the EMPS.
    """

    family = "velocity"
    kind = "two-tap-difference"
    reference = "Janot, Gautier & Brunot 2019, controller of the EMPS"
    states = (Port("previous"), Port("earlier"))
    inputs = (Port("position"),)
    outputs = (Port("velocity"),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (inp.position, x.previous), ((inp.position - x.earlier) / (2.0 * clock.dt),)

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        return {"previous": position, "earlier": position}, {}
