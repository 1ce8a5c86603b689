"""Velocity by differences of the measured position."""

from __future__ import annotations

from typing import Any

import numpy as np

from contourlab.components.contract import Component, LinearModel, param, text_param
from contourlab.components.mechanics.discretise import RULES, low_pass_weight
from contourlab.engine.step import Port


class FilteredDifference(Component):
    """First difference of the measured position behind a first-order low-pass: V = s w/(s + w) P."""

    family = "velocity"
    kind = "filtered-difference"
    example = {"bandwidth": 800.0}
    reference = "dirty derivative, backward Euler"
    states = (Port("previous"), Port("velocity"))
    inputs = (Port("position"),)
    outputs = (Port("velocity"),)
    derived = ("weight",)

    bandwidth: float = param(unit="rad/s", minimum=0.0, exclusive=True, doc="corner of the low-pass, w")
    discretisation: str = text_param(default="backward-euler", choices=RULES, doc="how the low-pass is sampled")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (low_pass_weight(par.bandwidth, dt, self.discretisation),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        difference = (inp.position - x.previous) / clock.dt
        velocity = x.velocity + par.weight * (difference - x.velocity)
        return (inp.position, velocity), (velocity,)

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        return {"previous": position}, {}

    def linearize(self) -> LinearModel:
        w = self.bandwidth
        # w s/(s + w) = w - w^2/(s + w)
        return LinearModel(np.array([[-w]]), np.array([[1.0]]), np.array([[-w * w]]), np.array([[w]]), ("position",), ("velocity",))
