"""A link of periodic messages with delay, jitter and loss."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.components.contract import NOISE_STREAM, Component, param, text_param
from contourlab.engine.step import Port
from contourlab.primitives import delayed, floor, minimum, select, uniform

NEARLY = 1e-9
"""Rounding tolerance of whole numbers of ticks."""


class Network(Component):
    """Signals sampled into messages, one per `message_period`, that arrive after `delay` plus up to `jitter`, or never.

    A message carries the value of the signal at the tick of sending, and that tick as its time stamp. It counts from the first tick at
    which it has arrived: times are rounded up to servo periods, the message period too. If messages overtake each other, the newest stamp
    counts; older messages are ignored. Between messages, and after losses, the last value is held. With ``between = "extrapolate"`` the
    line through the last two messages is followed from the stamp to now, for at most `horizon`; this compensates delay as well as loss.

    Jitter is uniform. Jitter and loss are independent from message to message. Both depend only on message number and stream: all signals
    of one axis in one direction share a message, and the same seed gives the same run. With a message per servo period and no delay, jitter
    or loss, the receiver sees the signal unchanged.

    References
    ----------
    Sampled, delayed and held signals over a network: Nilsson, "Real-time control systems with delays", Lund Institute of Technology
    (1998), chapters 2 and 3; independent losses with hold: Schenato, IEEE Trans. Automatic Control 54(5), 2009. The two sides are those of
    Ghaffari & Ulsoy, Fig 1.
    """

    family = "link"
    kind = "network"
    reference = "sampled, delayed, lost and held messages: Nilsson 1998; Schenato 2009; Ghaffari & Ulsoy 2017, Fig 1"
    example = {
        "message_period": 0.003,
        "delay": 0.0021,
        "jitter": 0.0062,
        "loss": 0.2,
        "between": "extrapolate",
        "horizon": 0.011,
        "stream": 7.0,
    }
    states = (Port("newest"), Port("value"), Port("slope"))
    derived = ("spacing", "soonest", "latest", "delay_ticks", "jitter_ticks", "horizon_ticks")
    ring = "sent"

    message_period: float = param(default=0.0, unit="s", minimum=0.0, maximum=10.0, display="ms", doc="0: the servo period")
    delay: float = param(default=0.0, unit="s", minimum=0.0, maximum=10.0, display="ms", doc="least time from sending to arrival")
    jitter: float = param(default=0.0, unit="s", minimum=0.0, maximum=10.0, display="ms", doc="largest extra delay; uniform from 0")
    loss: float = param(default=0.0, minimum=0.0, maximum=1.0, doc="fraction of messages that never arrive")
    between: str = text_param(default="hold", choices=("hold", "extrapolate"), doc="value used until the next message arrives")
    horizon: float = param(default=0.02, unit="s", minimum=0.0, maximum=10.0, display="ms", doc="longest extrapolation")
    stream: float = NOISE_STREAM

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        delay, jitter = par.delay / dt, par.jitter / dt
        spacing = np.maximum(np.ceil(par.message_period / dt - NEARLY), 1.0)
        return spacing, np.ceil(delay - NEARLY), np.ceil(delay + jitter - NEARLY), delay, jitter, par.horizon / dt

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, between: str) -> Any:
        newest, value, slope = x.newest, x.value, x.slope
        # Messages that may arrive at this tick, newest first, down to the one held.
        number = floor((clock.k - par.soonest) / par.spacing)
        while number > newest and number * par.spacing >= clock.k - par.latest:
            sent_at = number * par.spacing
            taken = -floor(NEARLY - par.delay_ticks - par.jitter_ticks * uniform(par.stream, number, 0.0))
            # Draws lie strictly between 0 and 1: a loss of 0 loses none, a loss of 1 all.
            there = select(sent_at + taken <= clock.k, uniform(par.stream, number, 1.0), 0.0)
            if there > par.loss:
                fresh = delayed(par.ring, clock, clock.k - sent_at)
                if between == "extrapolate":
                    slope = select(newest >= 0.0, (fresh - value) / ((number - newest) * par.spacing), 0.0)
                value, newest = fresh, number
            number -= 1.0
        received = value
        if between == "extrapolate":
            received = value + slope * minimum(clock.k - newest * par.spacing, par.horizon_ticks)
        return (newest, value, slope), (received,)

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        return {"newest": -1.0, "value": position}, {"received": position}

    def ring_length(self, dt: float) -> int:
        return math.ceil((self.delay + self.jitter) / dt - NEARLY) + 1
