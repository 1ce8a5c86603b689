"""Observers of the disturbance on an axis."""

from __future__ import annotations

from typing import Any

import numpy as np

from contourlab.components.contract import Component, LinearModel, param, text_param
from contourlab.components.mechanics.propagator import RULES, low_pass_weight
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
    reference = "Ghaffari & Ulsoy 2017, eqs 6-13"
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


class LoadObserver(Component):
    """Reduced-order observer of speed and load; the load, in command units, is subtracted from the command.

    Notes
    -----
    Model: p'' = a (u + d) - b p' with d' = 0. Position p and applied command u are known, speed and load d are observed:

        v' = a (u + d) - b v + l_1 (p' - v),   d' = l_2 (p' - v),   l_1 = 2 w_0 - b,   l_2 = w_0^2/a.

    Both errors decay with the double pole w_0: d_hat = w_0^2/(s + w_0)^2 [s (s + b) p/a - u]. `disturbance-observer` filters its command
    by one pole, its position by that and the filters of its two derivatives; their different lag costs margin. Here both pass the same two
    poles: with an exact model the estimate does not react to the command, and the position loop keeps the margins that it has without.

    Sampled exactly: u is constant over a tick. One count q of the encoder moves the estimate by about q w_0^2/a. An omitted lag limits w_0.

    References
    ----------
    Luenberger, "An introduction to observers", IEEE Trans. Automatic Control 16 (1971): order 3 - 1 = 2, poles at will, so that with both
    at z = 0 the load is exact two ticks after its step. Johnson, "Accommodation of external disturbances in linear regulator and
    servomechanism problems", ibid.: the load as a state. Use in motion control: Hsu, Houng & Yeh, "Design of an optimal unknown input
    observer for load compensation in motion systems", Asian J. Control 3 (2001), reference 5 of Gecer Ulu et al.
    """

    family = "observer"
    kind = "load-observer"
    calibrated = ("model_damping", "model_gain")
    example = {"model_gain": 0.6, "model_damping": 20.0}
    reference = "Luenberger 1971; Johnson 1971"
    states = (Port("previous_position"), Port("speed"), Port("estimate"))
    inputs = (Port("position"), Port("applied"))
    derived = ("decay", "speed_gain", "travel", "travel_gain", "speed_correction", "load_correction")

    bandwidth: float = param(default=400.0, unit="rad/s", minimum=0.0, exclusive=True, doc="both poles of the estimate, w_0")
    model_gain: float = param(unit="m/s^2/{command}", minimum=0.0, exclusive=True, display="mm/s^2/{command}", doc="of the model, a")
    model_damping: float = param(default=0.0, unit="1/s", minimum=0.0, doc="decay of the model's velocity, b")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        x = np.multiply(par.model_damping, dt)
        small = x < 1e-3
        # (x - 1 + exp(-x))/x^2 without cancellation.
        second = np.where(small, 0.5 - x / 6.0 + x * x / 24.0, (x + np.expm1(-x)) / np.where(small, 1.0, x * x))
        decay, travel = np.exp(-x), dt * (1.0 - x * second)
        travel_gain, pole = par.model_gain * dt * dt * second, np.exp(np.multiply(par.bandwidth, -dt))
        load_correction = (1.0 - pole) ** 2 / (par.model_gain * dt * travel)
        speed_correction = (1.0 + decay - 2.0 * pole - load_correction * travel_gain) / travel
        return decay, par.model_gain * travel, travel, travel_gain, speed_correction, load_correction

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        return {"previous_position": position}, {}

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        push = inp.applied + x.estimate
        surprise = inp.position - x.previous_position - par.travel * x.speed - par.travel_gain * push
        speed = par.decay * x.speed + par.speed_gain * push + par.speed_correction * surprise
        estimate = x.estimate + par.load_correction * surprise
        return (inp.position, speed, estimate), (estimate,)

    def linearize(self) -> LinearModel:
        w, a, b = self.bandwidth, self.model_gain, self.model_damping
        # States v - l_1 p and d - l_2 p: no derivative of the position.
        matrix, corrections = np.array([[-2.0 * w, a], [-w * w / a, 0.0]]), np.array([2.0 * w - b, w * w / a])
        inputs = np.column_stack([matrix @ corrections, [a, 0.0]])
        through = np.array([[corrections[1], 0.0]])
        return LinearModel(matrix, inputs, np.array([[0.0, 1.0]]), through, ("position", "applied"), ("disturbance_estimate",))
