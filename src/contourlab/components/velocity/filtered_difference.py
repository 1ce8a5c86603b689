"""Velocities from differences of the measured position."""

from __future__ import annotations

from typing import Any

import numpy as np

from contourlab.components.contract import Component, LinearModel, param, text_param
from contourlab.components.mechanics.propagator import RULES, low_pass_weight
from contourlab.engine.step import Port


class Difference(Component):
    """Base: a velocity from differences of the measured position."""

    family = "velocity"


class FilteredDifference(Difference):
    """First difference of the measured position through a first-order low-pass: V = s w/(s + w) P."""

    kind = "filtered-difference"
    example = {"bandwidth": 800.0}
    reference = "dirty derivative, backward Euler"
    states = (Port("previous"), Port("velocity"))
    derived = ("weight",)

    bandwidth: float = param(unit="rad/s", minimum=0.0, exclusive=True, doc="corner of the low-pass, w")
    discretisation: str = text_param(default="backward-euler", choices=RULES, doc="how the low-pass is sampled")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (low_pass_weight(par.bandwidth, dt, self.discretisation),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        velocity = x.velocity + par.weight * ((inp.position - x.previous) / clock.dt - x.velocity)
        return (inp.position, velocity), (velocity,)

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        return {"previous": position}, {}

    def linearize(self) -> LinearModel:
        w = self.bandwidth
        # w s/(s + w) = w - w^2/(s + w)
        return LinearModel(np.array([[-w]]), np.array([[1.0]]), np.array([[-w * w]]), np.array([[w]]), ("position",), ("velocity",))


class TwoTapDifference(Difference):
    """Backward difference of the mean of two neighbouring positions: v_k = (q_k - q_(k-2))/(2 T), one tick late.

    The mean removes errors that alternate from tick to tick.

    References
    ----------
    Janot, Gautier & Brunot, "Data set and reference models of EMPS", 2019 Workshop on Nonlinear System Identification Benchmarks: the
    velocity of the controller of the EMPS.
    """

    kind = "two-tap-difference"
    reference = "Janot, Gautier & Brunot 2019, controller of the EMPS"
    states = (Port("previous"), Port("earlier"))

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (inp.position, x.previous), ((inp.position - x.earlier) / (2.0 * clock.dt),)

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        return {"previous": position, "earlier": position}, {}
