"""What is between the positions of a control and the plant that takes them: a step generator, or a delay and a lag."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.components.contract import Component, param
from contourlab.components.transport import Transport
from contourlab.engine.step import ports
from contourlab.errors import ParameterError
from contourlab.primitives import clip, delayed, fabs, select


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


class PositionLag(Transport):
    """Delay of positions, whole and fractional, and a resonance or another lag of second order, w^2/(s^2 + 2 D w s + w^2).

    These are what a log of commanded and actual position shows of a control and its axis besides the position loop itself. A motion at
    constant speed is late by the delay and, w far below the servo frequency, 2 D/w. The lag is sampled by the bilinear rule, exact at w.

    References
    ----------
    Gross, Hamann & Wiegartner, "Electrical Feed Drives in Automation", 2001 (filters of second order).
    """

    family = "drive"
    kind = "position-lag"
    command_unit = "m"
    example = {"delay": 0.0077, "frequency": 40.0, "damping_ratio": 0.3}
    reference = "transport delay of sampled positions; lag of second order: Gross, Hamann & Wiegartner 2001"
    states = ports("start", "input_1", "input_2", "output_1", "output_2")
    derived = (*Transport.derived, "b0", "a1", "a2")
    ring = "command"

    delay: float = param(
        default=0.0, unit="s", minimum=0.0, maximum=1.0, display="ms", doc="from command to count, besides the servo period"
    )
    frequency: float = param(default=math.inf, unit="Hz", minimum=0.0, exclusive=True, doc="of the lag, w/2 pi; inf: no lag")
    damping_ratio: float = param(default=1.0, minimum=0.0, maximum=10.0, exclusive=True, doc="of the lag, D")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        lags = par.frequency < math.inf
        turn = np.where(lags, par.frequency, 0.0) * dt
        if np.any(turn >= 0.5):
            raise ParameterError(
                f"{self.kind}.frequency", f"{float(np.max(turn)) / dt:g}", f"below half of the servo frequency, {0.5 / dt:g}", "Hz"
            )
        k, wide = np.tan(math.pi * turn), 2.0 * par.damping_ratio * np.tan(math.pi * turn)
        size = 1.0 + wide + k * k
        filtered = k * k / size, 2.0 * (k * k - 1.0) / size, (1.0 - wide + k * k) / size
        return *super().derive(par, dt), *(np.where(lags, value, 0.0) for value in filtered)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        # Before the first command the axis stands where it starts.
        newer = select(clock.k >= par.whole, delayed(par.ring, clock, par.whole), x.start)
        older = select(clock.k > par.whole, delayed(par.ring, clock, par.whole + 1.0), x.start)
        u = newer + par.fraction * (older - newer)
        y = par.b0 * (u + 2.0 * x.input_1 + x.input_2) - par.a1 * x.output_1 - par.a2 * x.output_2
        applied = select(par.b0 > 0.0, y, u)
        return (x.start, u, x.input_1, applied, x.output_1), (applied,)

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        return dict.fromkeys(("start", "input_1", "input_2", "output_1", "output_2"), position), {"applied": position}
