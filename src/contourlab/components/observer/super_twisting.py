"""Super-twisting observer of the disturbance on an axis."""

from __future__ import annotations

from typing import Any

import numpy as np

from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.primitives import copysign, fabs, maximum, sqrt

PROPORTIONAL, INTEGRAL = 1.5, 1.1
"""k_1 over sqrt(L), k_2 over L: Levant's; Seeber & Horn, Automatica 84 (2017), prove that they suffice."""


class SuperTwisting(Component):
    """Second-order sliding mode: exact in finite time for a disturbance whose rate is bounded; it is subtracted from the command.

    Notes
    -----
    Model: v' = a (u + d) - b v with abs(d') <= L. With the applied command u

        s = (v - z)/a,   z' = a (u + d_hat) - b v,   d_hat = k_1 sqrt(abs(s)) sgn(s) + w,   w' = k_2 sgn(s),

    k_1 = 1.5 sqrt(L), k_2 = 1.1 L. Hence s' = d - d_hat. It needs L alone, no bandwidth. After a jump D, as of Coulomb friction at a
    reversal, the estimate is exact within 34 D/L whatever the disturbance does, by bounds on each half turn around s = 0.

    Sampled by implicit Euler: s^ = s - T d_hat and w + T k_2 sgn(s^) are solved together, a quadratic equation in sqrt(abs(s^)). Where
    abs(s - T w) <= T^2 k_2 its solution is s^ = 0: d_hat is d one tick ago, at most L T off, and a steady d leaves no chatter. What the
    model omits, as lag of drive and velocity, does make the command chatter, the more the larger L.

    It has no linear model, since its gain at s = 0 has no bound, and therefore no margins.

    References
    ----------
    Levant, "Sliding order and sliding accuracy in sliding mode control", Int. J. Control 58 (1993), and "Robust exact differentiation via
    sliding mode technique", Automatica 34 (1998): k_1, k_2. Moreno & Osorio, "Strict Lyapunov functions for the super-twisting algorithm",
    IEEE Trans. Automatic Control 57 (2012). Brogliato, Polyakov & Efimov, "The implicit discretization of the supertwisting sliding-mode
    control algorithm", ibid. 65 (2020).
    """

    family = "observer"
    kind = "super-twisting"
    calibrated = ("model_damping", "model_gain")
    example = {"model_gain": 0.6, "model_damping": 20.0, "disturbance_rate": 2.0}
    reference = "Levant 1993; Moreno & Osorio 2012"
    states = (Port("previous_velocity"), Port("sliding"), Port("integral"), Port("estimate"))
    inputs = (Port("velocity"), Port("applied"))
    derived = ("proportional", "half", "layer", "inverse_gain")

    disturbance_rate: float = param(unit="{command}/s", minimum=0.0, exclusive=True, doc="largest rate of the disturbance, L")
    model_gain: float = param(unit="m/s^2/{command}", minimum=0.0, exclusive=True, display="mm/s^2/{command}", doc="of the model, a")
    model_damping: float = param(default=0.0, unit="1/s", minimum=0.0, doc="decay of the model's velocity, b")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        proportional = PROPORTIONAL * np.sqrt(par.disturbance_rate)
        return proportional, 0.5 * dt * proportional, INTEGRAL * par.disturbance_rate * dt * dt, 1.0 / par.model_gain

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        gained = (inp.velocity - x.previous_velocity + clock.dt * par.model_damping * inp.velocity) * par.inverse_gain
        sliding = x.sliding + gained - clock.dt * (inp.applied + x.estimate)
        free = sliding - clock.dt * x.integral
        root = sqrt(par.half * par.half + maximum(fabs(free) - par.layer, 0.0)) - par.half
        estimate = (sliding - copysign(root * root, free)) / clock.dt
        return (inp.velocity, sliding, estimate - copysign(par.proportional * root, free), estimate), (estimate,)
