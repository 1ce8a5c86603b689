"""A random force of limited bandwidth: the part of a disturbance that no trial repeats."""

from __future__ import annotations

from typing import Any

import numpy as np

from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.primitives import normal, select, sqrt


def next_noise(last: float, rms: float, keep: float, stream: float, k: float) -> float:
    """Return the next value of normal noise of a given rms with the autocorrelation keep**|n|, stationary from tick 0 on."""
    fresh = rms * normal(stream, k)
    return select(k == 0.0, fresh, keep * last + sqrt(1.0 - keep * keep) * fresh)


class LowPassedNoise(Component):
    """Normal noise behind a low-pass of first order: E[F(t) F(t + T)] = rms^2 exp(-w |T|) at the ticks, held between them.

    It has its rms at any servo period and from the first tick on. Other axes, seeds and trials give other noise: it is the non-repeatable
    disturbance of learning, beside which all other disturbances repeat. Where both act, "force-ripple" takes noise along.

    References
    ----------
    Ornstein-Uhlenbeck process, sampled exactly: Gillespie, Physical Review E 54 (1996), eq (1.9).
    """

    family = "disturbance"
    kind = "low-passed-noise"
    reference = "Ornstein-Uhlenbeck process, sampled exactly: Gillespie 1996, eq 1.9"
    example = {"rms": 2.0, "bandwidth": 200.0, "stream": 7.0}
    states = (Port("noise"),)
    inputs = (Port("position"),)
    outputs = (Port("force"),)
    derived = ("keep",)

    rms: float = param(unit="{force}", minimum=0.0, doc="root mean square of the force")
    bandwidth: float = param(unit="rad/s", minimum=0.0, exclusive=True, doc="corner of the low-pass, w")
    stream: float = param(
        default=0.0,
        minimum=0.0,
        maximum=2.0**53,
        whole=True,
        doc="number of the noise stream; set by the run from its seed",
    )

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (np.exp(-par.bandwidth * dt),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        force = next_noise(x.noise, par.rms, par.keep, par.stream, clock.k)
        return (force,), (force,)
