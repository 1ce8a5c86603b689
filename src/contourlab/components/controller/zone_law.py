"""What the controllers of the contact zone and of the gap have in common: a motor led to the flank that it is to press on.

In all of them the motor's place is compared with that of a target, the reference or the load, moved by half of the free travel towards the
flank that is to be pressed on: where the motor is ahead of the load, the forward one. Laws are in angles of the motor, 2 pi/l times the
lengths at the table.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any, ClassVar

import numpy as np

from contourlab.components.contract import Component, LinearModel, param, text_param
from contourlab.components.controller.anti_windup import ANTI_WINDUP, integral_rise, recovery_part
from contourlab.engine.step import Port
from contourlab.primitives import select


def _difference(inp: Any) -> float:
    return inp.motor_position - inp.load_position  # type: ignore[no-any-return]


def _velocity(inp: Any) -> float:
    return inp.reference_velocity  # type: ignore[no-any-return]


def _acceleration(inp: Any) -> float:
    return inp.reference_acceleration  # type: ignore[no-any-return]


def _nothing(inp: Any) -> float:
    return 0.0


DIRECTIONS = {"none": _nothing, "difference": _difference, "velocity": _velocity, "acceleration": _acceleration}


@cache
def _make(
    follows_load: bool, per_inertia: bool, literal: bool, direction: str, rise: Callable[..., float] | None, to_flank: bool
) -> Callable[..., Any]:
    told_by = DIRECTIONS[direction]

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        told = told_by(inp)
        flank = select(told > 0.0, 1.0, select(told < 0.0, -1.0, x.flank)) if told_by is not _nothing else 0.0
        half = 0.5 * par.turn * flank * select(inp.gap_estimate > 0.0, inp.gap_estimate, par.backlash_gap)
        target, target_rate, ahead = inp.reference, inp.reference_velocity, inp.reference_acceleration
        if follows_load:
            target, target_rate = inp.load_position, inp.load_velocity
            ahead = (inp.load_velocity - x.load_velocity) / clock.dt
        rate = par.turn * (inp.motor_velocity - target_rate)
        if literal:
            rate = rate - half
        back = par.rate_gain * rate + par.position_gain * (par.turn * (inp.motor_position - target) - half)
        if per_inertia:
            back = par.motor_inertia * back
        integral = x.integral
        if rise is not None:
            short = par.turn * (inp.reference - inp.motor_position) + (half if to_flank else 0.0)
            integral = integral + rise(clock.dt * par.integral_gain * short, x.last_command - inp.accepted, par.recovery)
        command = par.motor_inertia * par.turn * ahead - back + integral + inp.feedforward - inp.disturbance_estimate
        return (integral, flank, inp.load_velocity, command), (command,)

    return step


ADDED = ("disturbance_estimate", "feedforward")


class ZoneLaw(Component):
    """Base of the laws: ports, and the parameters that all have.

    The flank is told by `direction`: the sign of motor minus load, as the paper says, or that of the reference's velocity (where friction
    holds the load against the flank that drives it) or acceleration (where inertia does); where that is zero, the last one holds. With
    ``direction = "none"`` the law knows no gap.

    Printed, the half gap also stands in the rate term of types I and II, where it has the wrong dimension: ``reading = "literal"``. It is
    meant as the derivative of the moved target, which is zero but for its jumps, and is left out otherwise. A gap observer's estimate
    goes before `backlash_gap`.
    """

    family = "controller"
    reference = "Shahin, ElMaraghy & ElBeheiry, eqs 10 and 12-16"
    per_inertia: ClassVar[bool] = False
    states = (Port("integral"), Port("flank"), Port("load_velocity"), Port("last_command"))
    inputs = (
        Port("reference"),
        Port("reference_velocity"),
        Port("reference_acceleration"),
        Port("motor_position"),
        Port("motor_velocity"),
        Port("load_position"),
        Port("load_velocity"),
        Port("gap_estimate"),
        Port("disturbance_estimate"),
        Port("feedforward"),
        Port("accepted"),
    )
    outputs = (Port("command"),)
    derived: ClassVar[tuple[str, ...]] = ("turn",)

    motor_inertia: float = param(
        unit="kg*m^2", minimum=0.0, exclusive=True, display="kg*cm^2", doc="that the reference's acceleration is multiplied with, J_m"
    )
    lead: float = param(unit="m", minimum=0.0, exclusive=True, display="mm", doc="travel per turn of the screw, l")
    backlash_gap: float = param(default=0.0, unit="m", minimum=0.0, display="um", doc="free travel in all that it reckons with, 2 beta")
    direction: str = text_param(default="difference", choices=tuple(DIRECTIONS), doc="what tells the flank to press on")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (2.0 * math.pi / par.lead,)

    def step_function(self) -> Any:
        return zone_step(self)

    def linearize(self) -> LinearModel | None:
        """Return the model of a law that knows no gap; with one it is not linear."""
        if self.direction != "none" or getattr(self, "target", "reference") == "load":
            return None
        turn, scale = 2.0 * math.pi / self.lead, self.motor_inertia if self.per_inertia else 1.0
        rate, off = scale * self.rate_gain * turn, scale * self.position_gain * turn  # type: ignore[attr-defined]
        names = ("reference", "reference_velocity", "reference_acceleration", "motor_position", "motor_velocity", *ADDED)
        through = np.array([[off, rate, self.motor_inertia * turn, -off, -rate, -1.0, 1.0]])
        n = 1 if hasattr(self, "integral_gain") else 0
        summed = getattr(self, "integral_gain", 0.0) * turn * np.array([[1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0]])[:n]
        return LinearModel(np.zeros((n, n)), summed, np.ones((1, n)), through, names, ("command",))

    def linear(self) -> Any:
        return self.replace(direction="none", **({"target": "reference"} if "target" in self.parameters else {}))


def zone_step(
    law: ZoneLaw, *, follows_load: bool = False, rise: Callable[..., float] | None = None, to_flank: bool = False
) -> Callable[..., Any]:
    """Return the step of a law; `rise` is how its integral is summed up, if it has one, `to_flank` whether that knows the half gap."""
    return _make(follows_load, law.per_inertia, law.values().get("reading") == "literal", law.direction, rise, to_flank)


def _reading() -> Any:
    return text_param(
        default="corrected",
        choices=("corrected", "literal"),
        doc="whether the half gap also stands in the rate term, as printed",
        source="Shahin, ElMaraghy & ElBeheiry, eqs 10, 12, 14 and 15",
    )


class InertiaGains(ZoneLaw):
    """Laws of type I: gains per inertia of the motor."""

    per_inertia = True

    reading: str = _reading()
    rate_gain: float = param(unit="1/s", minimum=0.0, doc="on the motor's rate")
    position_gain: float = param(unit="1/s^2", minimum=0.0, doc="on the motor's angle")


class TorqueGains(ZoneLaw):
    """Laws of types II and III: gains that give a torque themselves.

    From wishes they are placed for a rigid drive of the inertia that is given, that of all that moves in contact or of the motor alone in
    the gap: s^2 + 2 zeta w s + w^2, with the integral times s + p.
    """

    rate_gain: float = param(unit="N*m*s/rad", minimum=0.0, doc="on the motor's rate")
    position_gain: float = param(unit="N*m/rad", minimum=0.0, doc="on the motor's angle")

    wishes: ClassVar[dict[str, Any]] = {
        "inertia": param(unit="kg*m^2", minimum=0.0, exclusive=True, display="kg*cm^2", doc="of what the motor is to move"),
        "natural_frequency": param(unit="rad/s", minimum=0.0, exclusive=True, doc="of two poles, w"),
        "damping": param(default=0.7, minimum=0.0, exclusive=True, doc="of these, zeta"),
    }

    @staticmethod
    def designed(wishes: Mapping[str, float], model_gain: float, model_damping: float) -> dict[str, float]:
        inertia, w, zeta = wishes["inertia"], wishes["natural_frequency"], wishes["damping"]
        return {"rate_gain": 2.0 * zeta * w * inertia, "position_gain": w * w * inertia}


class TypeTwo(TorqueGains):
    """Laws of type II."""

    reading: str = _reading()


class Integral(TorqueGains):
    """Laws of type III: with an integral.

    Printed, it is that of the motor's distance from the reference: in the long run it leads the motor there, off the flank, so that the
    load is left half of the free travel behind. With ``integral_of = "flank"`` it is that of the distance from the moved target.
    """

    derived: ClassVar[tuple[str, ...]] = ("turn", "recovery")

    integral_gain: float = param(unit="N*m/rad/s", minimum=0.0, doc="on the integral of the motor's distance")
    integral_of: str = text_param(
        default="reference",
        choices=("reference", "flank"),
        doc="what the distance that is summed up is from",
        source="Shahin, ElMaraghy & ElBeheiry, eqs 13 and 16",
    )
    anti_windup: str = text_param(default="back-calculation", choices=ANTI_WINDUP, doc="what the integral does at a limit, or not active")
    tracking_time: float = param(
        default=0.01, unit="s", minimum=0.0, exclusive=True, display="ms", doc="time constant of the back-calculation, T_t"
    )

    wishes: ClassVar[dict[str, Any]] = {
        **TorqueGains.wishes,
        "pole": param(unit="rad/s", minimum=0.0, exclusive=True, doc="a third, real one, for the integral, p"),
    }

    @staticmethod
    def designed(wishes: Mapping[str, float], model_gain: float, model_damping: float) -> dict[str, float]:
        inertia, w, zeta, p = wishes["inertia"], wishes["natural_frequency"], wishes["damping"], wishes["pole"]
        two = 2.0 * zeta * w
        return {"rate_gain": (two + p) * inertia, "position_gain": (w * w + two * p) * inertia, "integral_gain": w * w * p * inertia}

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return 2.0 * math.pi / par.lead, recovery_part(par.tracking_time, dt)

    def step_function(self) -> Any:
        return zone_step(self, rise=integral_rise(self.anti_windup), to_flank=self.integral_of == "flank")
