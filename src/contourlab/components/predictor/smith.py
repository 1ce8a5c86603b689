"""The Smith predictor of a transport delay."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.components.contract import Component, param
from contourlab.components.mechanics.propagator import doublings_for, propagator
from contourlab.engine.step import Port
from contourlab.primitives import delayed


class SmithPredictor(Component):
    """The measured position and what the commands on their way will add to it, so that the loop is controlled as if it had no delay.

    The model is G w^2/(s (s^2 + 2 zeta w s + w^2)) e^(-s tau), held commands integrated exactly. What is added is the model's position
    without the delay less that with it; both follow from the same commands, so that one set of states, driven by the command less the late
    command, holds the difference. Its integral is the sum of the commands on their way, taken anew at each tick: nothing drifts, and a tick
    costs about a nanosecond for each servo period of the delay. The delay may be any fraction of periods; the command between two ticks is
    the mean that `delayed-saturation` gives.

    With the model and the delay of the axis the loop has the poles of the loop without delay, besides those of the model's own velocity.
    It wants the command ahead of the delay, behind the limit. A controller that uses a velocity has to take it from the predicted position
    ("filtered-difference"): the true velocity knows nothing of the commands on their way.

    On an axis that integrates, a steady load or friction held up by the command u is taken for a motion to come: the axis settles
    G tau u away from its reference, with any integral in the controller (Astrom, Hang & Lim 1994). A disturbance observer or
    friction feedforward does not help, since their part of the command passes through the drive as well; learning does.

    References
    ----------
    Smith, "Closer control of loops with dead time", Chemical Engineering Progress 53 (1957) 217-219; Astrom, Hang & Lim, "A new Smith
    predictor for controlling a process with an integrator and long dead-time", IEEE Trans. Automatic Control 39(2), 1994. The model is that
    of Gecer Ulu, Ulu & Cakmakci, eq (4).
    """

    family = "predictor"
    kind = "smith"
    reference = "Smith 1957; model of Gecer Ulu et al., eq 4"
    example = {"dc_gain": 0.9, "damping_ratio": 1.1, "natural_frequency": 150.0, "delay": 0.0123}
    states = (Port("velocity"), Port("acceleration"))
    inputs = (Port("position"), Port("applied"))
    outputs = (Port("position"),)
    derived = ("whole", "fraction", "v0", "x0", "vu", "f0", "xb", "fu", "gain_step", "of_velocity", "of_acceleration")
    ring = "applied"

    dc_gain: float = param(unit="m/s/{command}", minimum=0.0, exclusive=True, display="mm/s/{command}", doc="steady speed per command, G")
    damping_ratio: float = param(minimum=0.0, doc="zeta")
    natural_frequency: float = param(unit="rad/s", minimum=0.0, exclusive=True, doc="w")
    delay: float = param(unit="s", minimum=0.0, maximum=10.0, display="ms", doc="time from command to effect, tau")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        periods = par.delay / dt
        # As the drive takes it: a delay that is whole but for rounding is whole.
        whole = np.floor(periods + 1e-9)
        w, rate = par.natural_frequency, 2.0 * par.damping_ratio * par.natural_frequency
        phi = propagator(0.0 * rate, rate, w * w, dt, doublings_for(float(np.max((rate + w) * dt))))
        v0, _, _, _, _, x0, x1, _, _, _, f0, f1 = phi
        push = par.dc_gain * w * w * dt
        return (
            *(whole, np.maximum(periods - whole, 0.0)),
            *(v0, x0, push * x1, f0, -w * w * x0, push * f1),
            *(par.dc_gain * dt, 2.0 * par.damping_ratio / w, 1.0 / (w * w)),
        )

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        # The input of this tick is the command held until now.
        total, i = 0.0, 0.0
        while i < par.whole:
            total += delayed(par.ring, clock, i)
            i += 1.0
        newer, older = delayed(par.ring, clock, par.whole), delayed(par.ring, clock, par.whole + 1.0)
        surplus = inp.applied - (newer + par.fraction * (older - newer))
        velocity = par.v0 * x.velocity + par.x0 * x.acceleration + par.vu * surplus
        acceleration = par.xb * x.velocity + par.f0 * x.acceleration + par.fu * surplus
        # From w^2 p' + 2 zeta w p'' + p''' = G w^2 u, integrated once.
        ahead = par.gain_step * (total + par.fraction * newer) - par.of_velocity * velocity - par.of_acceleration * acceleration
        return (velocity, acceleration), (inp.position + ahead,)

    def ring_length(self, dt: float) -> int:
        return math.floor(self.delay / dt + 1e-9) + 2
