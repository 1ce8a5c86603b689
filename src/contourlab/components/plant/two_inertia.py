"""A two-inertia feed drive: motor and load, joined by a shaft with backlash."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import param, text_param
from contourlab.components.families import TWO_SIDED
from contourlab.components.plant.two_sided import TwoSided, even_gap
from contourlab.errors import ParameterError
from contourlab.primitives import clip, floor, lookup, select

CONTACT_MODEL = text_param(
    default="physical", choices=("physical", "dead-zone"), doc="how a damped shaft leaves a flank", source="Nordin, Galic & Gutman 1997"
)


class TwoInertia(TwoSided):
    """Two-inertia feed drive: J_m w_m' + c_m w_m = g u - T, J_l w_l' + c_l w_l = T; the table moves by the lead in a turn.

    The shaft transmits T = k_s theta_s + d_s theta_s', theta_s its twist beyond the gap. All states are lengths at the table: an angle of
    the motor is 2 pi/l times its length, a mass (2 pi/l)^2 times its inertia. The total gap between the two flanks is
    `backlash_gap` + l/(2 pi) `backlash_angle`; `gap_profile` varies it along the table. Loads, frictions and forces on the motor are given
    at the table.

    In the physical model the twist decays in
    the gap; in the dead-zone model a damped shaft can also pull. The path refers to the load's position. Lost motion is the gap plus the
    twist due to guide friction, 2 F_c/k_s.

    References
    ----------
    Shahin, ElMaraghy & ElBeheiry, "On nonlinearity control of CNC feed drives", eqs (1)-(4); Nordin, Galic & Gutman, "New models for
    backlash and gear play", Int. J. Adaptive Control and Signal Processing 11 (1997) 49-63.
    """

    kind = "two-inertia"
    reference = "Shahin, ElMaraghy & ElBeheiry 2005, eqs 1-4; Nordin, Galic & Gutman 1997"
    command_unit = "N*m"
    rest_depends = ("backlash_gap", "backlash_angle", "start_in_gap", "lead", "profile_start", "profile_step")
    derived = (*TWO_SIDED, "profile_rate")
    tables = ("profile",)
    example = {
        "motor_inertia": 5.2e-3,
        "load_inertia": 4.4e-3,
        "mass": 30.0,
        "lead": 0.016,
        "motor_damping": 2e-3,
        "load_damping": 3e-3,
        "stiffness": 950.0,
        "shaft_damping": 0.1,
        "backlash_gap": 20e-6,
        "backlash_angle": 1e-3,
        "start_in_gap": 0.5,
        "gap_profile": (1.0, 0.5, 0.8),
        "profile_start": -0.01,
        "profile_step": 0.5,
    }
    without_effect = ("start_in_gap",)  # it sets the initial state
    motor_inertia: float = param(unit="kg*m^2", minimum=0.0, exclusive=True, display="kg*cm^2", doc="inertia on the motor shaft, J_m")
    load_inertia: float = param(
        default=0.0, unit="kg*m^2", minimum=0.0, display="kg*cm^2", doc="load inertia at the shaft, without `mass`, J_l"
    )
    mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="mass of the table; adds (l/2 pi)^2 of it to load_inertia")
    carried_mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="additional mass on the axis")
    lead: float = param(unit="m", minimum=0.0, exclusive=True, display="mm", doc="travel per turn of the screw, l")
    stiffness: float = param(unit="N*m/rad", minimum=0.0, exclusive=True, doc="stiffness of shaft, coupling and nut, k_s")
    shaft_damping: float = param(default=0.0, unit="N*m*s/rad", minimum=0.0, doc="damping of shaft, coupling and nut, d_s")
    motor_damping: float = param(default=0.0, unit="N*m*s/rad", minimum=0.0, doc="viscous damping on the motor side, c_m")
    load_damping: float = param(default=0.0, unit="N*m*s/rad", minimum=0.0, doc="viscous damping on the load side, at the shaft, c_l")
    torque_gain: float = param(default=1.0, minimum=0.0, exclusive=True, doc="actual over commanded torque, g")
    backlash_gap: float = param(default=0.0, unit="m", minimum=0.0, display="um", doc="total gap, as a length at the table")
    backlash_angle: float = param(default=0.0, unit="rad", minimum=0.0, doc="gap of the coupling, as a motor angle")
    start_in_gap: float = param(default=0.0, minimum=-1.0, maximum=1.0, doc="initial position in the gap; 1: flank that drives forwards")
    contact_model: str = CONTACT_MODEL
    gap_profile: tuple[float, ...] = param(default=(1.0,), vector=True, minimum=0.0, doc="relative gap at even positions; (1,): constant")
    profile_start: float = param(default=0.0, unit="m", display="mm", doc="position of the first value of gap_profile; ends hold beyond")
    profile_step: float = param(default=1.0, unit="m", minimum=0.0, exclusive=True, display="mm", doc="spacing of gap_profile")
    unbounded = ("profile_start",)

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        turn = 2.0 * math.pi / par.lead
        motor = par.motor_inertia * turn * turn
        load = par.load_inertia * turn * turn + par.mass + par.carried_mass
        stiffness, damper = par.stiffness * turn * turn, par.shaft_damping * turn * turn
        gap = par.backlash_gap + par.backlash_angle / turn
        damped = damper > 0.0
        # Without damping the shaft unwinds at once, and there is no twist to follow.
        unwinding = np.where(damped, stiffness / np.where(damped, damper, 1.0), 0.0)
        return (
            par.torque_gain * turn,
            1.0 / motor,
            par.motor_damping * turn * turn / motor,
            1.0 / load,
            par.load_damping * turn * turn / load,
            stiffness,
            damper,
            0.5 * gap,
            np.where(gap > 0.0, 0.0, 1.0),
            unwinding,
            1.0 / par.profile_step,
        )

    def check_values(self) -> None:
        if np.any(self.load_inertia + self.mass + self.carried_mass <= 0.0):
            raise ParameterError("load_inertia", "0", "> 0 unless a mass is given", "kg*m^2")

    def table_values(self) -> dict[str, Array]:
        return {"profile": np.array(self.gap_profile)}

    def gap_function(self) -> Any:
        """Return ``gap(par, position)``: half the gap at the load's position, and its slope."""
        return _varying(len(self.gap_profile)) if len(self.gap_profile) > 1 else even_gap

    @property
    def physical(self) -> bool:  # type: ignore[override]
        """Whether the contact is that of the physical model."""
        return bool(self.contact_model == "physical")

    def gap_at(self, position: float) -> float:
        """Return the total gap [m] with the load at `position` [m]."""
        places = self.profile_start + self.profile_step * np.arange(len(self.gap_profile))
        return self._whole_gap * float(np.interp(position, places, self.gap_profile))

    @property
    def widest_gap(self) -> float:
        """Largest total gap [m]."""
        return self._whole_gap * float(np.max(self.gap_profile))

    @property
    def _whole_gap(self) -> float:
        return self.backlash_gap + self.backlash_angle * self.lead / (2.0 * math.pi)

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        places = {"position": position, "motor_position": position + 0.5 * self.start_in_gap * self.gap_at(position)}
        return places, places

    def stiffened(self, resonance: float) -> Any:
        ratio = 2.0 * math.pi * resonance / self.shaft_rate
        if ratio <= 1.0:
            return self
        stiffness = ratio**2 * self.stiffness
        return self.replace(stiffness=stiffness, shaft_damping=1.4 * stiffness / (2.0 * math.pi * resonance))

    def linear(self) -> Any:
        return self.replace(backlash_gap=0.0, backlash_angle=0.0)


@cache
def _varying(n: int) -> Any:
    last = float(n - 1)

    def gap(par: Any, position: float) -> tuple[float, float]:
        u = (position - par.profile_start) * par.profile_rate
        i = clip(floor(u), 0.0, last - 1.0)
        low, high = lookup(par.profile, i), lookup(par.profile, i + 1.0)
        inside = select(u < 0.0, 0.0, select(u > last, 0.0, 1.0))
        slope = inside * (high - low)
        return par.half_gap * (low + (clip(u, 0.0, last) - i) * (high - low)), par.half_gap * slope * par.profile_rate

    return gap
