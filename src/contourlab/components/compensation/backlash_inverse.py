"""The inverse of backlash, with a given or a learned gap."""

from __future__ import annotations

from typing import Any

import numpy as np

from contourlab.components.compensation.backlash_offset import limited_jump, pushed_side
from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.errors import ParameterError
from contourlab.primitives import clip, fabs, maximum, minimum, select

JUMP_VELOCITY = param(default=0.01, unit="m/s", minimum=0.0, exclusive=True, display="mm/s", doc="speed of the shift across the gap")
DEAD_BAND = param(default=1e-6, unit="m/s", minimum=0.0, display="mm/s", doc="speed below which the pushed side is kept")
LOAD_TIME_CONSTANT = param(default=0.0, unit="s", minimum=0.0, display="ms", doc="load mass over viscous friction; 0: friction dominates")
INITIAL_DIRECTION = param(default=0.0, minimum=-1.0, maximum=1.0, whole=True, doc="first side pushed: 1 forwards, -1 backwards, 0 unknown")


class BacklashInverse(Component):
    """Shift of the reference by half the gap in the direction of motion: +b/2 forwards, -b/2 backwards, b the total gap.

    Use it with position feedback from the motor side: the load is half the gap behind the motor on the pushed side, so that r + b/2 or
    r - b/2 at the motor puts the load at r. With feedback from the load side the gap would count twice.

    The shift keeps its sign at standstill. At a reversal it moves to the other side with `jump_velocity`, because no motor follows a jump:
    this takes b/jump_velocity, and the load waits where it turned. The shift is zero at the first tick and ramps up when the axis first
    moves, or at once if `initial_direction` gives the side of the load.

    The reference decides which side is pushed: the speed v + T a, T = `load_time_constant`, has the sign of the force c v + m a on a load
    of mass m and viscous friction c, with T = m/c. The default T = 0 is for friction that outweighs inertia. Within `dead_band` the side is
    kept, so that noise at standstill has no effect.

    An observed gap replaces `backlash_gap` as soon as it is above zero.

    References
    ----------
    G. Tao & P. V. Kokotovic, "Adaptive control of systems with backlash", Automatica 29(2), 1993, 323-335: the backlash inverse, here with
    slope 1 and a ramp in place of the jump.
    """

    family = "compensation"
    kind = "backlash-inverse"
    reference = "Tao & Kokotovic 1993, backlash inverse"
    example = {"backlash_gap": 0.02, "jump_velocity": 0.5, "dead_band": 5e-4, "load_time_constant": 0.3, "initial_direction": -1.0}
    states = (Port("side"), Port("shift"))
    inputs = (Port("reference_velocity"), Port("reference_acceleration"), Port("gap_estimate"))
    outputs = (Port("reference_shift"),)

    backlash_gap: float = param(unit="m", minimum=0.0, maximum=0.1, display="um", doc="total gap between motor and load, b")
    jump_velocity: float = JUMP_VELOCITY
    dead_band: float = DEAD_BAND
    load_time_constant: float = LOAD_TIME_CONSTANT
    initial_direction: float = INITIAL_DIRECTION

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        before = select(x.side == 0.0, par.initial_direction, x.side)
        side = pushed_side(inp.reference_velocity + par.load_time_constant * inp.reference_acceleration, par.dead_band, before)
        gap = select(inp.gap_estimate > 0.0, inp.gap_estimate, par.backlash_gap)
        shift = limited_jump(x.shift, 0.5 * gap * side, par.jump_velocity * clock.dt)
        return (side, shift), (shift,)


COUNTED = 1.25
"""The motor's travel counts up to this times the largest gap, so that noise and small reversals within the excess do not end a contact."""


class AdaptiveBacklashInverse(Component):
    """Shift of the reference by half the gap in the direction of motion, as `backlash-inverse`, with a learned gap.

    Motor minus load position is c_r while the motor pushes the load forwards, and c_l while it pushes backwards. The gap is c_r - c_l; an
    offset between the two scales cancels. With the regressor phi = (1, 0) or (0, 1) of the pushed side and e = (motor - load) - phi.(c_r,
    c_l), the law is the normalised gradient

        (c_r, c_l) <- (c_r, c_l) + (1 - exp(-dt/T)) phi d(e)/(phi.phi),   then projected onto 0 <= c_r - c_l <= largest_gap,

    with the dead zone d(e) = e - clip(e, -d0, d0), T the `adaptation_time` and phi.phi = 1. While learning, each side converges to its
    measured value as exp(-t/T), to within d0; the gap thus to within 2 d0. It starts from `backlash_gap`. Readings at rest, and noise and
    drift within d0, change nothing.

    It learns only in certain contact. For `settling_time` the reference must be faster than `learning_velocity`, and the motor must have
    moved more than the largest gap since its last reversal, towards the side that the reference pushes. It learns lost motion at speed: the
    gap plus twice the force on the load over the stiffness between them. With T longer than a stroke this is the mean force, the friction;
    with a shorter T braking at the end of the stroke dominates.

    The pushed side is that of `backlash-inverse`. For a load with more inertia than friction set `load_time_constant`, or it learns while
    the load runs ahead of the motor.

    References
    ----------
    G. Tao & P. V. Kokotovic, "Adaptive control of systems with backlash", Automatica 29(2), 1993, 323-335: adaptive inverse with the
    crossings c_r and c_l as parameters, gradient law with normalisation, dead zone and projection; here with the error of the measured load
    position instead of a plant's output.
    """

    family = "compensation"
    kind = "adaptive-backlash-inverse"
    reference = "Tao & Kokotovic 1993, adaptive backlash inverse"
    example = {
        "backlash_gap": 0.01,
        "largest_gap": 0.05,
        "jump_velocity": 0.5,
        "dead_band": 5e-4,
        "load_time_constant": 0.3,
        "initial_direction": -1.0,
        "adaptation_time": 0.05,
        "dead_zone": 2e-4,
        "learning_velocity": 0.05,
        "settling_time": 0.003,
    }
    states = tuple(Port(name) for name in ("side", "shift", "right", "left", "motor", "rise", "fall", "unsure_at", "begun", "known"))
    inputs = tuple(Port(name) for name in ("reference_velocity", "reference_acceleration", "motor_position", "load_position"))
    outputs = (Port("reference_shift"),)
    derived = ("weight",)

    backlash_gap: float = param(default=0.0, unit="m", minimum=0.0, maximum=0.1, display="um", doc="initial total gap, b")
    largest_gap: float = param(unit="m", minimum=0.0, exclusive=True, maximum=0.1, display="um", doc="upper bound of the gap")
    adaptation_time: float = param(default=0.5, unit="s", minimum=0.0, exclusive=True, doc="time in which an error falls to 1/e, T")
    dead_zone: float = param(default=1e-7, unit="m", minimum=0.0, display="um", doc="error that is ignored, d0: a count of the scales")
    learning_velocity: float = param(
        default=1e-3, unit="m/s", minimum=0.0, exclusive=True, display="mm/s", doc="reference speed below which nothing is learned"
    )
    settling_time: float = param(default=0.02, unit="s", minimum=0.0, display="ms", doc="time of certain contact before it learns")
    jump_velocity: float = JUMP_VELOCITY
    dead_band: float = DEAD_BAND
    load_time_constant: float = LOAD_TIME_CONSTANT
    initial_direction: float = INITIAL_DIRECTION

    def check_values(self) -> None:
        if np.any(self.backlash_gap > self.largest_gap):
            raise ParameterError("backlash_gap", f"{self.backlash_gap:g}", f"<= largest_gap, {self.largest_gap:g}", "m")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (-np.expm1(-dt / par.adaptation_time),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        before = select(x.side == 0.0, par.initial_direction, x.side)
        speed = inp.reference_velocity + par.load_time_constant * inp.reference_acceleration
        side = pushed_side(speed, par.dead_band, before)

        motor, most = inp.motor_position, COUNTED * par.largest_gap
        moved = x.begun * (motor - x.motor)
        rise, fall = clip(x.rise + moved, 0.0, most), clip(x.fall - moved, 0.0, most)
        slowest = minimum(fabs(speed), fabs(inp.reference_velocity))
        # Each condition is a number that is positive if it holds; the least of them decides.
        gone = select(side > 0.0, rise, fall) - par.largest_gap
        sure = minimum(minimum(gone, slowest - par.learning_velocity), inp.reference_velocity * side)
        unsure_at = select(sure > 0.0, x.unsure_at, clock.t)
        learning = select(clock.t - unsure_at > par.settling_time + 1e-6 * clock.dt, 1.0, 0.0)
        right, left, known = learnt(par, x, motor - inp.load_position, side, learning)
        gap = select(known > 0.0, right - left, par.backlash_gap)

        shift = limited_jump(x.shift, 0.5 * gap * side, par.jump_velocity * clock.dt)
        return (side, shift, right, left, motor, rise, fall, unsure_at, 1.0, known), (shift,)


def learnt(par: Any, x: Any, apart: float, side: float, learning: float) -> tuple[float, float, float]:
    """Return c_r, c_l and whether they are known, after a tick; `apart` is motor minus load position."""
    # The first contact sets the pushed side to the reading, the other side by the initial gap.
    first = learning * (1.0 - x.known)
    right = select(first > 0.0, apart + select(side > 0.0, 0.0, par.backlash_gap), x.right)
    left = select(first > 0.0, apart - select(side > 0.0, par.backlash_gap, 0.0), x.left)
    of_right, of_left = apart - right, apart - left
    rate = learning * par.weight
    right += rate * select(side > 0.0, of_right - clip(of_right, -par.dead_zone, par.dead_zone), 0.0)
    left += rate * select(side < 0.0, of_left - clip(of_left, -par.dead_zone, par.dead_zone), 0.0)
    # Projection onto the bounds.
    beyond = 0.5 * (right - left - clip(right - left, 0.0, par.largest_gap))
    return right - beyond, left + beyond, maximum(x.known, learning)
