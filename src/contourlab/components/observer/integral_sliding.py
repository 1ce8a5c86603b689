"""Integral sliding mode as an observer of the disturbance on an axis."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.components.contract import Component, LinearModel, param
from contourlab.components.mechanics.propagator import low_pass_weight
from contourlab.engine.step import Port
from contourlab.primitives import clip


class IntegralSliding(Component):
    """Integral sliding mode with a boundary layer: its estimate of the disturbance is subtracted from the command.

    Notes
    -----
    Model: v' = a (u + d) - b v. With the applied command u, the sliding variable s starts at zero, so that there is no reaching phase:

        s = (v - z)/a,   z' = a (u + d_hat) - b v,   d_hat = M sat(s/phi),   phi = M/w_d;   hence s' = d - d_hat.

    While abs(d) < M the layer is not left; there this is `disturbance-observer` by backward Euler without w_z. A larger disturbance moves s
    out of the layer, and d_hat stays at M until s has come back as far: M has to cover what the model gets wrong, too.

    Sampled: d_hat = clip(g s, -M, M), g = w_d/(1 + w_d T). For w_d -> inf this is the relay M sgn(s) by implicit Euler (Acary & Brogliato
    2010), whose layer is M T: the estimate is d one tick ago and does not chatter. Any omitted lag limits w_d as it does for
    `disturbance-observer`.

    References
    ----------
    Utkin & Shi, "Integral sliding mode in systems operating under uncertainty conditions", IEEE Conference on Decision and Control 1996.
    Acary & Brogliato, "Implicit Euler numerical scheme and chattering-free implementation of sliding mode systems", Systems & Control
    Letters 59 (2010).
    """

    family = "observer"
    kind = "integral-sliding"
    calibrated = ("model_damping", "model_gain")
    example = {"model_gain": 0.6, "model_damping": 20.0, "limit": 0.3}
    reference = "Utkin & Shi 1996"
    states = (Port("previous_velocity"), Port("sliding"), Port("estimate"))
    inputs = (Port("velocity"), Port("applied"))
    derived = ("slope", "inverse_gain")

    limit: float = param(default=math.inf, unit="{command}", minimum=0.0, exclusive=True, doc="largest estimate, M; inf: none")
    bandwidth: float = param(default=200.0, unit="rad/s", minimum=0.0, exclusive=True, doc="inside the layer, w_d = M/phi")
    model_gain: float = param(unit="m/s^2/{command}", minimum=0.0, exclusive=True, display="mm/s^2/{command}", doc="of the model, a")
    model_damping: float = param(default=0.0, unit="1/s", minimum=0.0, doc="decay of the model's velocity, b")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return low_pass_weight(par.bandwidth, dt, "backward-euler") / dt, 1.0 / par.model_gain

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        gained = (inp.velocity - x.previous_velocity + clock.dt * par.model_damping * inp.velocity) * par.inverse_gain
        sliding = x.sliding + gained - clock.dt * (inp.applied + x.estimate)
        estimate = clip(par.slope * sliding, -par.limit, par.limit)
        return (inp.velocity, sliding, estimate), (estimate,)

    def linearize(self) -> LinearModel:
        """Return the model inside the layer."""
        w, a, b = self.bandwidth, self.model_gain, self.model_damping
        # State d_hat - w v/a: no derivative of the velocity.
        inputs, through = np.array([[w * (b - w) / a, -w]]), np.array([[w / a, 0.0]])
        return LinearModel(np.array([[-w]]), inputs, np.array([[1.0]]), through, ("velocity", "applied"), ("disturbance_estimate",))
