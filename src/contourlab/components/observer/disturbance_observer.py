"""The disturbance observer that makes an axis behave like its model."""

from __future__ import annotations

from typing import Any

import numpy as np

from contourlab.components.contract import Component, LinearModel, param, text_param
from contourlab.components.mechanics.discretise import RULES, low_pass_weight
from contourlab.engine.step import Port


class DisturbanceObserver(Component):
    """Estimate of everything that acts on an axis besides its model; it is subtracted from the command.

    d_hat = w_d/(s + w_d) [ (s w_z/(s + w_z) + b_hat) v / a_hat - u ], u the command that reached the plant. With u = u_c - d_hat the loop
    from u_c to v has the steady gain a_hat/b_hat for any plant, and no steady response to a disturbance; it is stable for all positive
    parameters in continuous time. Choose b << w_d << w_z; the servo period and any delay limit w_d.

    References
    ----------
    Ghaffari & Ulsoy, "Component swapping modularity for distributed precision contouring", eqs (6)-(13); realised so that (10)-(13) hold
    exactly.
    """

    family = "observer"
    kind = "disturbance-observer"
    calibrated = ("model_damping", "model_gain")
    example = {"model_gain": 0.6, "model_damping": 20.0}
    reference = "Ghaffari & Ulsoy, eqs 6-13"
    states = (Port("filtered_velocity"), Port("estimate"))
    inputs = (Port("velocity"), Port("applied"))
    derived = ("velocity_weight", "estimate_weight", "inverse_gain")

    bandwidth: float = param(default=200.0, unit="rad/s", minimum=0.0, exclusive=True, doc="bandwidth of the estimate, w_d")
    filter_bandwidth: float = param(default=2000.0, unit="rad/s", minimum=0.0, exclusive=True, doc="of the velocity's derivative, w_z")
    model_gain: float = param(unit="m/s^2/{command}", minimum=0.0, exclusive=True, display="mm/s^2/{command}", doc="of the model, a_hat")
    model_damping: float = param(default=0.0, unit="1/s", minimum=0.0, doc="decay of the model's velocity, b_hat")
    discretisation: str = text_param(default="backward-euler", choices=RULES, doc="how the two low-passes are sampled")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        rule = self.discretisation
        return (low_pass_weight(par.filter_bandwidth, dt, rule), low_pass_weight(par.bandwidth, dt, rule), 1.0 / par.model_gain)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        filtered = x.filtered_velocity + par.velocity_weight * (inp.velocity - x.filtered_velocity)
        acceleration = par.filter_bandwidth * (inp.velocity - filtered)
        residual = (acceleration + par.model_damping * inp.velocity) * par.inverse_gain - inp.applied
        estimate = x.estimate + par.estimate_weight * (residual - x.estimate)
        return (filtered, estimate), (estimate,)

    def linearize(self) -> LinearModel:
        z, d, a, b = self.filter_bandwidth, self.bandwidth, self.model_gain, self.model_damping
        matrix = np.array([[-z, 0.0], [-d * z / a, -d]])
        inputs = np.array([[z, 0.0], [d * (z + b) / a, -d]])
        return LinearModel(matrix, inputs, np.array([[0.0, 1.0]]), np.zeros((1, 2)), ("velocity", "applied"), ("disturbance_estimate",))
