"""The Smith predictor of a transport delay."""

from __future__ import annotations

from typing import Any

import numpy as np

from contourlab.components.contract import param
from contourlab.components.mechanics.propagator import doublings_for, propagator
from contourlab.components.transport import Transport
from contourlab.engine.step import Port
from contourlab.primitives import delayed


class SmithPredictor(Transport):
    """Measured position plus the effect of the commands still in the delay, so that the controller sees a loop without delay.

    The model is G w^2/(s (s^2 + 2 zeta w s + w^2)) e^(-s tau), integrated exactly for held commands. The predictor adds the model's
    position without delay minus that with delay. One set of states, driven by the command minus the delayed command, holds this difference.
    Its integral is the sum of the commands in the delay, taken anew at each tick: nothing drifts, and a tick costs about a nanosecond per
    servo period of delay. The delay may be any fraction of periods; as in `delayed-saturation`, a fraction gives a weighted mean of two
    commands.

    If model and delay match the axis, the loop has the poles of the loop without delay, plus those of the model's velocity. Input
    ``applied`` must be the command after the limit and before the delay. A controller with velocity feedback must derive it from the
    predicted position ("filtered-difference"): the true velocity does not contain the commands in the delay.

    On an integrating axis the predictor takes the command u that balances a steady load or friction for future motion: the axis settles at
    a distance of G tau u from its reference, even with an integral in the controller (Astrom, Hang & Lim 1994). A disturbance observer or
    friction feedforward does not help, since their command also passes through the drive; learning does.

    References
    ----------
    Smith, "Closer control of loops with dead time", Chemical Engineering Progress 53 (1957) 217-219; Astrom, Hang & Lim, "A new Smith
    predictor for controlling a process with an integrator and long dead-time", IEEE Trans. Automatic Control 39(2), 1994. The model is that
    of Gecer Ulu, Ulu & Cakmakci, eq (4).
    """

    family = "predictor"
    kind = "smith"
    reference = "Smith 1957; Astrom, Hang & Lim 1994; model of Gecer Ulu, Ulu & Cakmakci 2016, eq 4"
    example = {"dc_gain": 0.9, "damping_ratio": 1.1, "natural_frequency": 150.0, "delay": 0.0123}
    states = (Port("velocity"), Port("acceleration"))
    derived = (*Transport.derived, "v0", "x0", "vu", "f0", "xb", "fu", "gain_step", "of_velocity", "of_acceleration")
    ring = "applied"

    dc_gain: float = param(unit="m/s/{command}", minimum=0.0, exclusive=True, display="mm/s/{command}", doc="steady speed per command, G")
    damping_ratio: float = param(minimum=0.0, doc="damping ratio, zeta")
    natural_frequency: float = param(unit="rad/s", minimum=0.0, exclusive=True, doc="natural frequency, w")
    delay: float = param(unit="s", minimum=0.0, maximum=10.0, display="ms", doc="time from command to effect, tau")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        w, rate = par.natural_frequency, 2.0 * par.damping_ratio * par.natural_frequency
        phi = propagator(0.0 * rate, rate, w * w, dt, doublings_for(np.max((rate + w) * dt)))
        v0, _, _, _, _, x0, x1, _, _, _, f0, f1 = phi
        push = par.dc_gain * w * w * dt
        return (
            *super().derive(par, dt),
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
