"""The step generator of a control, which turns positions into a step count."""

from __future__ import annotations

import math
from typing import Any

from contourlab.components.contract import Component, param
from contourlab.engine.step import ports
from contourlab.primitives import clip, fabs, select


class StepGenerator(Component):
    """Step generator with limits of its own: where they are below those of the motion, the count lags.

    Once in a period T it chooses the rate of the pulses. Let w be the speed of the command, and e the error that the count will have a
    period after it has reached this speed. If it can within the period, the rate is w - e/(2 T); else it ramps towards w, or the other way
    where that makes e smaller. Without limits the count reaches the command at the end of the period. With a limit of the acceleration, but
    far from it, it is ahead by a T^2/2 at an acceleration a: 0.5 um for 1 m/s^2 and 1 ms.

    The pulses themselves, whole steps spread evenly over the period, are in the plant: a count rounded once in a period would shake it.

    References
    ----------
    LinuxCNC, position mode of the step generators of hostmot2 and of its own component stepgen.
    """

    family = "drive"
    kind = "step-generator"
    command_unit = "m"
    example = {"velocity_limit": 3.0, "acceleration_limit": 60.0}
    reference = "position mode of LinuxCNC's step generators"
    states = ports("count", "rate", "last_command")

    velocity_limit: float = param(
        default=math.inf, unit="m/s", minimum=0.0, exclusive=True, display="mm/min", doc="LinuxCNC's maxvel; inf: none"
    )
    acceleration_limit: float = param(default=math.inf, unit="m/s^2", minimum=0.0, exclusive=True, doc="LinuxCNC's maxaccel; inf: none")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        dt = clock.dt
        wanted = (inp.command - x.last_command) / dt
        short = wanted - x.rate
        most = par.acceleration_limit * dt
        # Time to reach the speed of the command, and the error at the end of the period after that, in which LinuxCNC takes the mean
        # speed of the ramp if it has a limit.
        time, mean = fabs(short) / par.acceleration_limit, 0.5 * (wanted + x.rate)
        after = select(par.acceleration_limit < math.inf, mean, wanted)
        error = x.count + mean * time + after * dt - inp.command - wanted * time
        if fabs(short) < most:
            rate = clip(wanted - 0.5 * error / dt, x.rate - most, x.rate + most)
        else:
            way = select(short > 0.0, 1.0, -1.0)
            # A period of ramp the other way changes the error by twice this.
            back = -2.0 * way * most * time
            rate = x.rate + select(fabs(error + 2.0 * back) < fabs(error), -way, way) * most
        rate = clip(rate, -par.velocity_limit, par.velocity_limit)
        count = x.count + rate * dt
        return (count, rate, inp.command), (count,)

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        return {"count": position, "last_command": position}, {"applied": position}
