"""Controllers for the contact zone and the gap of a drive with backlash: they move the motor to the flank that it must press on.

All compare the motor's position with a target (reference or load) shifted by half the backlash gap towards that flank. Laws are in angles
of the motor: 2 pi/l times the lengths at the table.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any, ClassVar

import numpy as np

from contourlab.components.contract import BOTH_SIDES, REFERENCE, LinearModel, param, text_param
from contourlab.components.controller.law import ANTI_WINDUP, RISES, TRACKING_TIME, ControlLaw, recovery_part
from contourlab.engine.step import Port, ports
from contourlab.primitives import select

DIRECTIONS: dict[str, Callable[[Any], Any]] = {
    "none": lambda inp: 0.0,
    "difference": lambda inp: inp.motor_position - inp.load_position,
    "velocity": lambda inp: inp.reference_velocity,
    "acceleration": lambda inp: inp.reference_acceleration,
}


class ZoneLaw(ControlLaw):
    """Base of the laws: ports and common parameters.

    `direction` chooses the flank: the sign of motor minus load, as in the paper, or of the reference's velocity (where friction holds the
    load against the driving flank) or acceleration (where inertia does). Where it is zero, the last flank holds. With
    ``direction = "none"`` the law ignores the gap.

    `shift` moves the target to that flank, so that the load stays on the reference. The paper prints the other sign, theta_m - r + beta
    where theta_m - theta_l is positive: ``shift = "from-flank"`` keeps the load a whole gap off the reference.

    The printed types I and II also have the half gap in the rate term, where it has the wrong dimension: ``reading = "literal"``. It stands
    for the derivative of the shifted target, which is zero except at its jumps; by default it is left out. A gap observer's estimate takes
    precedence over `backlash_gap`.

    References
    ----------
    Shahin, ElMaraghy & ElBeheiry, "On nonlinearity control of CNC feed drives".
    """

    reference = "Shahin, ElMaraghy & ElBeheiry 2005, eqs 10 and 12-16"
    per_inertia: ClassVar[bool] = False
    # Without these parameters a law follows the reference, as corrected, and has no integral.
    target = "reference"
    reading = "corrected"
    integral_of = ""
    anti_windup = ""
    states = (Port("integral"), Port("flank"), Port("load_velocity"), Port("last_command"))
    inputs = (*REFERENCE, *BOTH_SIDES, *ports("gap_estimate", "disturbance_estimate", "feedforward", "accepted"))
    derived: ClassVar[tuple[str, ...]] = ("turn",)

    motor_inertia: float = param(unit="kg*m^2", minimum=0.0, exclusive=True, display="kg*cm^2", doc="motor inertia of the feedforward, J_m")
    lead: float = param(unit="m", minimum=0.0, exclusive=True, display="mm", doc="travel per turn of the screw, l")
    backlash_gap: float = param(default=0.0, unit="m", minimum=0.0, display="um", doc="total gap, 2 beta")
    direction: str = text_param(default="difference", choices=tuple(DIRECTIONS), doc="what chooses the flank")
    shift: str = text_param(
        default="to-flank",
        choices=("to-flank", "from-flank"),
        doc="where half the gap moves the motor's target; the paper prints from-flank",
        source="Shahin, ElMaraghy & ElBeheiry, eqs 10 and 12-16: sign of beta",
    )

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (2.0 * math.pi / par.lead,)

    @staticmethod
    def step(
        par: Any,
        x: Any,
        inp: Any,
        clock: Any,
        *,
        per_inertia: bool,
        target: str,
        reading: str,
        direction: str,
        shift: str,
        integral_of: str,
        anti_windup: str,
    ) -> Any:
        sign = DIRECTIONS[direction](inp)
        flank = select(sign > 0.0, 1.0, select(sign < 0.0, -1.0, x.flank)) if direction != "none" else 0.0
        side = 0.5 if shift == "to-flank" else -0.5
        half = side * par.turn * flank * select(inp.gap_estimate > 0.0, inp.gap_estimate, par.backlash_gap)
        goal, goal_rate, ahead = inp.reference, inp.reference_velocity, inp.reference_acceleration
        if target == "load":
            goal, goal_rate = inp.load_position, inp.load_velocity
            ahead = (inp.load_velocity - x.load_velocity) / clock.dt
        rate = par.turn * (inp.motor_velocity - goal_rate)
        if reading == "literal":
            rate = rate - half
        back = par.rate_gain * rate + par.position_gain * (par.turn * (inp.motor_position - goal) - half)
        if per_inertia:
            back = par.motor_inertia * back
        integral = x.integral
        if integral_of:
            short = par.turn * (inp.reference - inp.motor_position) + (half if integral_of == "flank" else 0.0)
            integral = integral + RISES[anti_windup](clock.dt * par.integral_gain * short, x.last_command - inp.accepted, par.recovery)
        command = par.motor_inertia * par.turn * ahead - back + integral + inp.feedforward - inp.disturbance_estimate
        return (integral, flank, inp.load_velocity, command), (command,)

    def linearize(self) -> LinearModel | None:
        """Return the model of a law without the gap and with the reference as target; other laws are not linear."""
        if self.direction != "none" or self.target == "load":
            return None
        turn, scale = 2.0 * math.pi / self.lead, self.motor_inertia if self.per_inertia else 1.0
        rate, off = scale * self.rate_gain * turn, scale * self.position_gain * turn  # type: ignore[attr-defined]
        names = tuple(port.name for port in (*self.inputs[:5], *self.inputs[8:10]))
        through = np.array([[off, rate, self.motor_inertia * turn, -off, -rate, -1.0, 1.0]])
        n = 1 if hasattr(self, "integral_gain") else 0
        summed = getattr(self, "integral_gain", 0.0) * turn * np.array([[1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0]])[:n]
        return LinearModel(np.zeros((n, n)), summed, np.ones((1, n)), through, names, ("command",))

    def linear(self) -> Any:
        return self.replace(direction="none", **({"target": "reference"} if "target" in self.parameters else {}))


READING = text_param(
    default="corrected",
    choices=("corrected", "literal"),
    doc="literal: the rate term contains the half gap too",
    source="Shahin, ElMaraghy & ElBeheiry, eqs 10, 12, 14 and 15",
)


class InertiaGains(ZoneLaw):
    """Laws of type I: gains per inertia of the motor."""

    per_inertia = True

    reading: str = READING
    rate_gain: float = param(unit="1/s", minimum=0.0, doc="gain on the motor's rate error")
    position_gain: float = param(unit="1/s^2", minimum=0.0, doc="gain on the motor's angle error")


class TorqueGains(ZoneLaw):
    """Laws of types II and III: gains are torques.

    `designed` places the poles of a rigid drive of the given inertia (all that moves in contact, or the motor alone in the gap):
    s^2 + 2 zeta w s + w^2, times s + p with the integral.
    """

    rate_gain: float = param(unit="N*m*s/rad", minimum=0.0, doc="gain on the motor's rate error")
    position_gain: float = param(unit="N*m/rad", minimum=0.0, doc="gain on the motor's angle error")

    wishes: ClassVar[dict[str, Any]] = {
        "inertia": param(unit="kg*m^2", minimum=0.0, exclusive=True, display="kg*cm^2", doc="inertia that the motor moves"),
        "natural_frequency": param(unit="rad/s", minimum=0.0, exclusive=True, doc="natural frequency of two poles, w"),
        "damping": param(default=0.7, minimum=0.0, exclusive=True, doc="damping ratio of these two poles, zeta"),
    }

    @staticmethod
    def designed(wishes: Mapping[str, float], model_gain: float, model_damping: float) -> dict[str, float]:
        inertia, w, zeta = wishes["inertia"], wishes["natural_frequency"], wishes["damping"]
        return {"rate_gain": 2.0 * zeta * w * inertia, "position_gain": w * w * inertia}


class Integral(TorqueGains):
    """Laws of type III: with an integral.

    The printed law integrates the motor's distance from the reference: in the long run it moves the motor to the reference, off the flank,
    and the load stays half a gap behind. With ``integral_of = "flank"`` it integrates the distance from the shifted target.
    """

    derived: ClassVar[tuple[str, ...]] = ("turn", "recovery")

    integral_gain: float = param(unit="N*m/rad/s", minimum=0.0, doc="gain on the integral of the motor's distance")
    integral_of: str = text_param(
        default="reference",
        choices=("reference", "flank"),
        doc="zero of the integrated distance",
        source="Shahin, ElMaraghy & ElBeheiry, eqs 13 and 16",
    )
    anti_windup: str = text_param(default="back-calculation", choices=ANTI_WINDUP, doc="what the integral does at a limit, or if inactive")
    tracking_time: float = TRACKING_TIME

    wishes: ClassVar[dict[str, Any]] = {
        **TorqueGains.wishes,
        "pole": param(unit="rad/s", minimum=0.0, exclusive=True, doc="a third, real pole for the integral, p"),
    }

    @staticmethod
    def designed(wishes: Mapping[str, float], model_gain: float, model_damping: float) -> dict[str, float]:
        inertia, w, zeta, p = wishes["inertia"], wishes["natural_frequency"], wishes["damping"], wishes["pole"]
        two = 2.0 * zeta * w
        return {"rate_gain": (two + p) * inertia, "position_gain": (w * w + two * p) * inertia, "integral_gain": w * w * p * inertia}

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return 2.0 * math.pi / par.lead, recovery_part(par.tracking_time, dt)


class ContactZone1(InertiaGains):
    """u = J_m (r_a - K_1 (w_m - r_v) - K_2 (theta_m - r -+ beta)): the motor follows the reference, shifted to the flank it presses on.

    It is Tao & Kokotovic's law for a stiff drive.
    """

    kind = "contact-zone-1"
    reference = "Shahin, ElMaraghy & ElBeheiry 2005, eq 10"
    example = {"rate_gain": 400.0, "position_gain": 2000.0, "motor_inertia": 5.2e-3, "lead": 0.016, "backlash_gap": 0.05}


class ContactZone2(TorqueGains):
    """u = J_m r_a - K_1' (w_m - r_v) - K_2' (theta_m - r -+ beta): type I with the gains K' = J_m K, which are torques."""

    kind = "contact-zone-2"
    reference = "Shahin, ElMaraghy & ElBeheiry 2005, eq 12"
    example = {**ContactZone1.example, "rate_gain": 10.0, "position_gain": 200.0}

    reading: str = READING


class ContactZone3(Integral):
    """u = J_m r_a - K_1' (w_m - r_v) - K_2' (theta_m - r -+ beta) - K_3 int (theta_m - r): type II with an integral."""

    kind = "contact-zone-3"
    reference = "Shahin, ElMaraghy & ElBeheiry 2005, eq 13"
    example = {**ContactZone2.example, "integral_gain": 25.0, "anti_windup": "back-calculation"}


class GapZone1(InertiaGains):
    """u = J_m (a_l - K_4 (w_m - w_l) - K_5 (theta_m - theta_l -+ beta)): the motor goes to a flank of the load.

    The printed law does not contain the reference: in the gap a load without friction is uncontrolled and the axis runs away. With
    ``target = "reference"`` the reference replaces the load.
    """

    kind = "gap-zone-1"
    reference = "Shahin, ElMaraghy & ElBeheiry 2005, eq 14"
    example = {**ContactZone1.example, "target": "load"}

    target: str = text_param(default="reference", choices=("reference", "load"), doc="what the motor follows; the paper prints the load")


class GapZone2(ContactZone2):
    """u = J_m r_a - K_4' (w_m - r_v) - K_5' (theta_m - r -+ beta): the motor follows the reference through the gap.

    With the same gains it equals the contact-zone law of this type.
    """

    kind = "gap-zone-2"
    reference = "Shahin, ElMaraghy & ElBeheiry 2005, eq 15"


class GapZone3(ContactZone3):
    """u = J_m r_a - K_4' (w_m - r_v) - K_5' (theta_m - r -+ beta) - K_6 int (theta_m - r): type II with an integral.

    With the same gains it equals the contact-zone law of this type.
    """

    kind = "gap-zone-3"
    reference = "Shahin, ElMaraghy & ElBeheiry 2005, eq 16"
