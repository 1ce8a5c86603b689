"""Forces over time or position: constant, harmonic, from a table, random, and ripple."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import NOISE_STREAM, Component, param, text_param
from contourlab.engine.step import Port
from contourlab.errors import ParameterError
from contourlab.primitives import clip, cos, floor, lookup, normal, select, sin, sqrt


class Disturbance(Component):
    """Base: a force on an axis that is not friction."""

    family = "disturbance"


class ConstantLoad(Disturbance):
    """A constant force from a given time on: gravity on a vertical axis, a steady cutting force."""

    kind = "constant"
    reference = "constant load from a given time"
    example = {"force": 2.0, "start": 0.05}
    unbounded = ("force",)

    force: float = param(unit="{force}", doc="force along the axis")
    start: float = param(default=0.0, unit="s", minimum=0.0, doc="time from which it acts")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (par.force if clock.t >= par.start else 0.0,)


class SineLoad(Disturbance):
    """A force A sin(2 pi f t + phase): an unbalanced spindle, a tooth-passing force."""

    kind = "sine"
    reference = "harmonic load"
    example = {"amplitude": 2.0, "frequency": 12.0, "phase": 0.3}
    unbounded = ("phase",)
    derived = ("angular_frequency",)

    amplitude: float = param(unit="{force}", minimum=0.0, doc="amplitude, A")
    frequency: float = param(unit="Hz", minimum=0.0, doc="frequency, f")
    phase: float = param(default=0.0, unit="rad", doc="phase at time 0")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (2.0 * math.pi * par.frequency,)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (par.amplitude * sin(par.angular_frequency * clock.t + par.phase),)


class TableLoad(Disturbance):
    """A force given at evenly spaced times or positions, linear between them: measured cutting forces, force ripple, cogging.

    With ``beyond = "hold"`` the first and last values hold outside the table. With ``"repeat"`` the table repeats; its last point is the
    first of the next period.
    """

    kind = "table"
    reference = "linear interpolation of a table"
    example = {
        "over": "position",
        "beyond": "hold",
        "start_position": -0.3,
        "position_step": 0.2,
        "time_step": 0.01,
        "forces": (0.0, 1.0, -0.5, 2.0),
    }
    without_effect = ("start_time", "time_step")  # in the example, which is over position
    unbounded = ("start_time", "start_position", "forces")
    tables = ("values_table",)
    derived = ("origin", "inverse_step", "intervals")

    over: str = text_param(default="time", choices=("time", "position"), doc="abscissa of the table")
    beyond: str = text_param(default="hold", choices=("hold", "repeat"), doc="behaviour outside the table")
    start_time: float = param(default=0.0, unit="s", doc="time of the first value")
    time_step: float = param(default=math.inf, unit="s", minimum=0.0, exclusive=True, doc="time between two values; required over time")
    start_position: float = param(default=0.0, unit="m", display="mm", doc="position of the first value")
    position_step: float = param(
        default=math.inf,
        unit="m",
        minimum=0.0,
        exclusive=True,
        display="mm",
        doc='distance between two values; required with over = "position"',
    )
    forces: tuple[float, ...] = param(unit="{force}", vector=True, doc="forces, at least two")

    def check_values(self) -> None:
        if len(self.forces) < 2:
            raise ParameterError("forces", f"{list(self.forces)}", "a list of at least two numbers", "force")
        if getattr(self, f"{self.over}_step") == math.inf:
            raise ParameterError(f"{self.over}_step", "not given", f'given with over = "{self.over}", > 0')

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, over: str, beyond: str) -> Any:
        u = ((clock.t if over == "time" else inp.position) - par.origin) * par.inverse_step
        u = u - par.intervals * floor(u / par.intervals) if beyond == "repeat" else clip(u, 0.0, par.intervals)
        i = clip(floor(u), 0.0, par.intervals - 1.0)
        low = lookup(par.values_table, i)
        return (), (low + (u - i) * (lookup(par.values_table, i + 1.0) - low),)

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        origin, step = (par.start_time, par.time_step) if self.over == "time" else (par.start_position, par.position_step)
        return origin, 1.0 / step, float(len(self.forces) - 1)

    def table_values(self) -> dict[str, Array]:
        return {"values_table": np.array(self.forces)}


def next_noise(last: float, rms: float, keep: float, stream: float, k: float) -> float:
    """Return the next value of normal noise of a given rms with the autocorrelation keep**|n|, stationary from tick 0 on."""
    fresh = rms * normal(stream, k)
    return select(k == 0.0, fresh, keep * last + sqrt(1.0 - keep * keep) * fresh)


class LowPassedNoise(Disturbance):
    """Normal noise through a first-order low-pass: E[F(t) F(t + T)] = rms^2 exp(-w |T|) at the ticks, held between them.

    The rms holds at any servo period and from the first tick on. Noise differs between axes, seeds and trials: for learning it is the
    non-repeatable disturbance; all others repeat. If ripple acts too, use "force-ripple", which includes this noise.

    References
    ----------
    Ornstein-Uhlenbeck process, sampled exactly: Gillespie, Physical Review E 54 (1996), eq (1.9).
    """

    kind = "low-passed-noise"
    reference = "Ornstein-Uhlenbeck process, sampled exactly: Gillespie 1996, eq 1.9"
    example = {"rms": 2.0, "bandwidth": 200.0, "stream": 7.0}
    states = (Port("noise"),)
    derived = ("keep",)

    rms: float = param(unit="{force}", minimum=0.0, doc="root mean square of the force")
    bandwidth: float = param(unit="rad/s", minimum=0.0, exclusive=True, doc="corner of the low-pass, w")
    stream: float = NOISE_STREAM

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (np.exp(-par.bandwidth * dt),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        force = next_noise(x.noise, par.rms, par.keep, par.stream, clock.k)
        return (force,), (force,)


_TURN = 2.0 * math.pi


class ForceRipple(Disturbance):
    """Ripple of a motor's force over its magnets' pitch: F = sum of a_k sin(2 pi k p/P + phi_k), k = 1 ... n, and noise.

    The ripple, from reluctance and uneven magnets, is the same in every trial. The noise is that of "low-passed-noise" and differs in every
    trial.

    References
    ----------
    Gecer Ulu, Ulu & Cakmakci name ripple forces and neglect them in their model (section 2); as a Fourier series over position: Tan, Huang
    & Lee, "Robust adaptive numerical compensation for friction and force ripple in permanent-magnet linear motors", IEEE Trans. Magnetics
    38 (2002).
    """

    kind = "force-ripple"
    reference = "Tan, Huang & Lee 2002: Fourier series over position"
    example = {
        "pitch": 0.7,
        "amplitudes": (1.0, 0.4, 0.2),
        "phases": (0.3, -1.0, 2.0),
        "noise": 0.3,
        "noise_bandwidth": 200.0,
        "stream": 7.0,
    }
    unbounded = ("phases",)
    states = (Port("noise"),)
    derived = ("inverse_pitch", "keep")
    tables = ("in_phase", "quadrature")

    pitch: float = param(unit="m", minimum=0.0, exclusive=True, display="mm", doc="travel after which the ripple repeats, P")
    amplitudes: tuple[float, ...] = param(unit="{force}", minimum=0.0, vector=True, doc="amplitudes of the harmonics, lowest first, a_k")
    phases: tuple[float, ...] = param(unit="rad", vector=True, doc="phases of the harmonics at position 0, phi_k")
    noise: float = param(default=0.0, unit="{force}", minimum=0.0, doc="root mean square of the noise")
    noise_bandwidth: float = param(default=100.0, unit="rad/s", minimum=0.0, exclusive=True, doc="corner of the noise's low-pass")
    stream: float = NOISE_STREAM

    def check_values(self) -> None:
        if len(self.phases) != len(self.amplitudes):
            raise ParameterError("phases", f"{list(self.phases)}", f"as many as the amplitudes, {len(self.amplitudes)}", "rad")

    @property
    def harmonics(self) -> int:
        """Number of harmonics."""
        return len(self.amplitudes)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, harmonics: int) -> Any:
        turns = inp.position * par.inverse_pitch
        angle = _TURN * (turns - floor(turns))
        c, s = cos(angle), sin(angle)
        # Horner's rule for the sum of a_k exp(i phi_k) z^k with |z| = 1: one sine and one cosine for any number of harmonics.
        re, im = 0.0, 0.0
        for k in range(harmonics - 1, -1, -1):
            re, im = re + lookup(par.in_phase, k), im + lookup(par.quadrature, k)
            re, im = re * c - im * s, re * s + im * c
        noise = next_noise(x.noise, par.noise, par.keep, par.stream, clock.k)
        return (noise,), (im + noise,)

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return 1.0 / par.pitch, np.exp(-par.noise_bandwidth * dt)

    def table_values(self) -> dict[str, Array]:
        amplitude, phase = np.array(self.amplitudes), np.array(self.phases)
        return {"in_phase": amplitude * np.cos(phase), "quadrature": amplitude * np.sin(phase)}


class ScrewRipple(Disturbance):
    """Force over a turn of the screw: F = F_0 + a_1 sin(w p) + b_1 cos(w p) + a_n sin(n w p) + b_n cos(n w p), w = 2 pi/l.

    F_0 is gravity, or half the difference of friction between the two directions. A bent or misaligned screw causes the first harmonic,
    motor cogging the n-th. Each sine and cosine amplitude is a parameter, so that a fit is linear in them and a batch can vary them. For
    many harmonics use "force-ripple".
    """

    kind = "screw-ripple"
    reference = "Fourier series over a turn, first and one further term"
    example = {"lead": 0.7, "offset": 0.5, "sine": 1.0, "cosine": -0.6, "order": 5.0, "order_sine": 0.4, "order_cosine": 0.3}
    unbounded = ("offset", "sine", "cosine", "order_sine", "order_cosine")
    derived = ("inverse_lead",)

    lead: float = param(unit="m", minimum=0.0, exclusive=True, display="mm", doc="travel per turn, l")
    offset: float = param(default=0.0, unit="{force}", doc="constant part, F_0")
    sine: float = param(default=0.0, unit="{force}", doc="sine, once a turn, a_1")
    cosine: float = param(default=0.0, unit="{force}", doc="cosine, once a turn, b_1")
    order: float = param(default=2.0, minimum=1.0, maximum=1000.0, whole=True, doc="periods of the second term per turn, n")
    order_sine: float = param(default=0.0, unit="{force}", doc="sine, n times a turn, a_n")
    order_cosine: float = param(default=0.0, unit="{force}", doc="cosine, n times a turn, b_n")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (1.0 / par.lead,)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        turns = inp.position * par.inverse_lead
        angle = _TURN * (turns - floor(turns))
        force = par.offset + par.sine * sin(angle) + par.cosine * cos(angle)
        angle = par.order * angle
        return (), (force + par.order_sine * sin(angle) + par.order_cosine * cos(angle),)
