"""Feedforward of inertia and friction, zero-phase-error tracking, and a test signal in the command."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import Component, LinearModel, param
from contourlab.engine.step import Port
from contourlab.errors import ParameterError
from contourlab.primitives import clip, delayed, dot, exp, floor, lookup, sin, tanh


class InverseDynamics(Component):
    """Command that a rigid axis needs to follow the reference: u = k_v r_v + k_a r_a + k_f tanh(r_v/v_e).

    For v' = a u - b v that is k_a = 1/a, k_v = b/a; for m v' = K_f u - c v it is k_a = m/K_f, k_v = c/K_f. k_f is the friction in command
    units. The learning law `basis-functions` finds all three on the machine. With a controller that has its own feedforward they add to it
    and may be negative.

    References
    ----------
    Pritschow, "On the influence of the velocity gain factor on the path deviation", CIRP Annals 45(1), 1996.
    """

    family = "feedforward"
    kind = "inverse-dynamics"
    calibrated_ahead = ("velocity_gain", "acceleration_gain")
    reference = "Newton's second law, solved for the command; Pritschow 1996"
    example = {"velocity_gain": 3.0, "acceleration_gain": 0.5, "friction": 0.2, "smoothing_velocity": 1e-3}
    unbounded = ("velocity_gain", "acceleration_gain", "friction")
    inputs = (Port("reference_velocity"), Port("reference_acceleration"))
    outputs = (Port("command"),)
    derived = ("inverse_smoothing",)

    velocity_gain: float = param(default=0.0, unit="{command}*s/m", display="{command}*s/mm", doc="command per reference velocity, k_v")
    acceleration_gain: float = param(unit="{command}*s^2/m", display="{command}*s^2/mm", doc="per reference acceleration, k_a")
    friction: float = param(default=0.0, unit="{command}", doc="command against the friction, k_f")
    smoothing_velocity: float = param(
        default=3e-4, unit="m/s", minimum=0.0, exclusive=True, display="mm/s", doc="speed scale on which the friction changes its sign, v_e"
    )

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (1.0 / par.smoothing_velocity,)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        v = inp.reference_velocity
        rigid = par.velocity_gain * v + par.acceleration_gain * inp.reference_acceleration
        return (), (rigid + par.friction * tanh(v * par.inverse_smoothing),)

    def linearize(self) -> LinearModel | None:
        """Return the linear model; None with friction."""
        if self.friction:
            return None
        through = np.array([[self.velocity_gain, self.acceleration_gain]])
        names = tuple(port.name for port in self.inputs)
        return LinearModel(np.zeros((0, 0)), np.zeros((0, 2)), np.zeros((1, 0)), through, names, ("command",))


class FrictionFeedforward(Component):
    """Friction compensation: u = [(F_c + (F_s - F_c) exp(-(v/v_s)^2)) tanh(v/v_e) + c v]/K_f, v the reference velocity.

    The change of sign is spread over v_e. If v_e is too small, the command jumps at a reversal before the axis has turned; if it is too
    large, the command comes late. A good compromise is the speed that the reference reaches within the lag time of the axis.
    `force_constant` converts forces to commands, so that identified friction parameters can be used unchanged.

    References
    ----------
    Armstrong-Helouvry, Dupont & Canudas de Wit, "A survey of models, analysis tools and compensation methods for the control of machines
    with friction", Automatica 30(7), 1994, section 5 (feedforward compensation).
    """

    family = "feedforward"
    kind = "friction"
    calibrated_ahead = ("viscous", "coulomb", "breakaway")
    reference = "Armstrong-Helouvry, Dupont & Canudas de Wit 1994, section 5"
    example = {
        "coulomb": 0.2,
        "breakaway": 0.3,
        "stribeck_velocity": 2e-3,
        "viscous": 2.0,
        "smoothing_velocity": 1e-3,
        "force_constant": 1.5,
    }
    inputs = (Port("reference_velocity"),)
    outputs = (Port("command"),)
    derived = ("inverse_stribeck", "inverse_smoothing", "inverse_constant")

    coulomb: float = param(unit="{force}", minimum=0.0, doc="friction at speed, F_c")
    breakaway: float = param(unit="{force}", minimum=0.0, doc="friction near rest, F_s; F_c: no Stribeck effect")
    stribeck_velocity: float = param(default=1e-3, unit="m/s", minimum=0.0, exclusive=True, display="mm/s", doc="of the fall to F_c, v_s")
    viscous: float = param(default=0.0, unit="{force}*s/m", minimum=0.0, doc="rise of friction with speed, c")
    smoothing_velocity: float = param(
        default=1e-4, unit="m/s", minimum=0.0, exclusive=True, display="mm/s", doc="speed scale on which the command changes its sign, v_e"
    )
    force_constant: float = param(default=1.0, unit="{force}/{command}", minimum=0.0, exclusive=True, doc="force per command, K_f")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return 1.0 / par.stribeck_velocity, 1.0 / par.smoothing_velocity, 1.0 / par.force_constant

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        v = inp.reference_velocity
        ratio = v * par.inverse_stribeck
        level = par.coulomb + (par.breakaway - par.coulomb) * exp(-ratio * ratio)
        return (), (par.inverse_constant * (level * tanh(v * par.inverse_smoothing) + par.viscous * v),)


MAX_ORDER = 8
"""Highest order of the denominator: the most closed-loop zeros that can be cancelled."""


class ZPETC(Component):
    """Shift of the reference by F(z) r - r, F(z) = z^L (n_0 + n_1 z^-1 + ...)/(d_0 + d_1 z^-1 + ...), from the reference L ticks ahead.

    `contourlab.analysis.linear.zpetc.zpetc_design` computes the coefficients for a closed loop, so that position over reference has zero
    phase at all frequencies. The step computes the shift from differences to the current reference: F is 1 at rest, so large coefficients
    of opposite sign lose no digits at rest.

    The shift is zero until the window of the filter is filled, and is then faded in over as many ticks.

    References
    ----------
    Tomizuka, "Zero phase error tracking algorithm for digital control", J. Dynamic Systems, Measurement, and Control 109 (1987) 65-68.
    """

    family = "feedforward"
    kind = "zpetc"
    reference = "Tomizuka 1987"
    example = {"numerator": (1.5, -0.9, 0.3, -0.1), "denominator": (1.0, -0.3, 0.1, 0.0), "lead": 3}
    unbounded = ("numerator", "denominator")
    states = tuple(Port(f"shift_{i}") for i in range(1, MAX_ORDER + 1))
    inputs = (Port("reference_ahead"),)
    outputs = (Port("reference_shift"),)
    derived = ("lead_ticks", "n_tap", *(f"d_{i}" for i in range(1, MAX_ORDER + 1)))
    tables = ("taps_table",)
    ring = "reference_ahead"

    numerator: tuple[float, ...] = param(vector=True, doc="n_0, n_1 ... of the reference ahead, in falling powers of z")
    denominator: tuple[float, ...] = param(vector=True, doc="d_0, d_1 ..., with zeros inside the unit circle; (1,) for none")
    lead: float = param(minimum=0.0, maximum=1000.0, whole=True, structural=True, doc="look-ahead in servo periods, L")

    def check_values(self) -> None:
        n, d = np.array(self.numerator), np.array(self.denominator)
        if d.size > MAX_ORDER + 1:
            raise ParameterError("denominator", f"of order {d.size - 1}", f"of order {MAX_ORDER} or less")
        if d[0] == 0.0 or np.abs(np.roots(d)).max(initial=0.0) >= 1.0:
            raise ParameterError("denominator", f"{list(self.denominator)}", "with d_0 not 0 and all zeros inside the unit circle")
        if not abs(n.sum() - d.sum()) <= 1e-6 * abs(d.sum()):
            raise ParameterError("numerator", f"a list with sum {n.sum():.9g}", f"one with sum {d.sum():.9g}, as the denominator has")

    @property
    def taps(self) -> Array:
        """Weights of the shift on the reference L, L - 1, ... ticks ahead: numerator minus the denominator delayed by L, over d_0."""
        lead = int(self.lead)
        found = np.zeros(max(len(self.numerator), lead + len(self.denominator)))
        found[: len(self.numerator)] += self.numerator
        found[lead : lead + len(self.denominator)] -= self.denominator
        return found / self.denominator[0]

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        back = np.zeros(MAX_ORDER)
        back[: len(self.denominator) - 1] = np.array(self.denominator[1:]) / self.denominator[0]
        return self.lead, float(self.taps.size), *back.tolist()

    def table_values(self) -> dict[str, Array]:
        return {"taps_table": self.taps}

    def ring_length(self, dt: float) -> int:
        return int(self.taps.size)

    def ahead(self, dt: float) -> int:
        return int(self.lead)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        now = delayed(par.ring, clock, par.lead_ticks)
        drive, i = 0.0, 0.0
        while i < par.n_tap:
            drive += lookup(par.taps_table, i) * (delayed(par.ring, clock, i) - now)
            i += 1.0
        known = clock.k - (par.n_tap - 1.0)
        drive = drive if known >= 0.0 else 0.0
        back = (par.d_1, par.d_2, par.d_3, par.d_4, par.d_5, par.d_6, par.d_7, par.d_8)
        past = (x.shift_1, x.shift_2, x.shift_3, x.shift_4, x.shift_5, x.shift_6, x.shift_7, x.shift_8)
        shift = drive - dot(back, past)
        return (shift, *past[:7]), (shift * clip(known / par.n_tap, 0.0, 1.0),)


class Sweep(Component):
    """Sine of rising or falling frequency, over and over: u = A sin(2 pi (f_0 t + (f_1 - f_0) t^2/(2 T))), t from 0 to T.

    For the identification of an axis from its log. Choose A well above friction and below the drive's limit. With several whole periods
    the response is free of leakage.
    """

    family = "feedforward"
    kind = "sweep"
    example = {"amplitude": 2.0, "first_frequency": 30.0, "last_frequency": 90.0, "duration": 0.1}
    reference = "Pintelon & Schoukens 2012, section 5.2 (swept sine)"
    outputs = (Port("command"),)
    derived = ("rate",)

    amplitude: float = param(unit="{command}", minimum=0.0, doc="A")
    first_frequency: float = param(default=2.0, unit="Hz", minimum=0.0, doc="at the start of a period, f_0")
    last_frequency: float = param(unit="Hz", minimum=0.0, doc="at its end, f_1")
    duration: float = param(unit="s", minimum=0.0, exclusive=True, doc="of a period, T")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return ((par.last_frequency - par.first_frequency) / par.duration,)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        # Rounding must not begin a period a tick late.
        t = clock.t - par.duration * floor(clock.t / par.duration + 1e-9)
        return (), (par.amplitude * sin(2.0 * math.pi * (par.first_frequency + 0.5 * par.rate * t) * t),)
