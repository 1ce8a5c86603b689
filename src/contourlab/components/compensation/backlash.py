"""Compensation at reversals: the offset of numerical controls, the inverse of backlash, and pulses against quadrant peaks.

The pushed side, and the moves of a shift from one side of the gap to the other, serve them all.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.components.contract import Component, param, text_param
from contourlab.engine.step import Port
from contourlab.errors import ParameterError
from contourlab.primitives import clip, copysign, exp, fabs, floor, maximum, minimum, select, sqrt


def pushed_side(speed: float, band: float, before: float) -> float:
    """Return the side on which the load is pushed: +1 or -1, and `before` inside the speed band.

    Standstill keeps the side: a motor that stops keeps its contact.
    """
    return select(speed > band, 1.0, select(speed < -band, -1.0, before))


def limited_jump(now: float, target: float, most: float) -> float:
    """Return `now` moved towards the target by `most` at most; the last move lands on it exactly."""
    left = target - now
    return select(fabs(left) <= most, target, now + clip(left, -most, most))


def limited_ramp(now: float, speed: float, target: float, most_speed: float, most_rise: float, dt: float) -> tuple[float, float]:
    """Return offset and speed after one tick towards a target, with limits of speed and acceleration.

    `most_rise` is the largest change of speed in a tick, a dt. In units of a dt and a dt^2, an offset with speed v that brakes by 1 per
    tick stops after n ticks and a distance v + (v - 1) + ... = n v - n (n - 1)/2, where n - 1 < v <= n. Solved for v, with the least n for
    which n (n + 1)/2 is at least the distance left, this is the highest speed from which it can stop at the target.
    """
    left = target - now
    ticks = fabs(left) / (most_rise * dt)
    n = maximum(-floor(0.5 - sqrt(0.25 + 2.0 * ticks)), 1.0)
    stopping = most_rise * (ticks / n + 0.5 * (n - 1.0))
    wanted = copysign(minimum(most_speed, stopping), left)
    after = clip(wanted, speed - most_rise, speed + most_rise)
    moved = now + after * dt
    # Rounding must not keep it from the target.
    return select(fabs(target - moved) <= 1e-9 * most_rise * dt, target, moved), after


def offset_after(par: Any, x: Any, side: float, clock: Any) -> tuple[float, float]:
    """Return offset and its speed after one tick towards half the gap on `side`."""
    rise = par.backlash_acceleration * clock.dt
    return limited_ramp(x.offset, x.offset_speed, 0.5 * par.backlash_gap * side, par.backlash_velocity, rise, clock.dt)


class BacklashOffset(Component):
    """Offset of +b/2 or -b/2 on the commanded position by its direction, changed with limited velocity and acceleration.

    The direction is the sign of the reference velocity; standstill keeps it, and nothing is measured. Before the first motion the offset is
    zero, as after switch-on. The change from one side to the other takes b/v + v/a if the velocity v is reached (b >= v^2/a), else
    2 sqrt(b/a), to within one or two servo periods.

    LinuxCNC gives the offset half of the axis limits and leaves the other half for the motion.

    References
    ----------
    LinuxCNC, src/emc/motion/control.c, compute_screw_comp: backlash_corr and its trapezoidal filter (parameter BACKLASH of a joint).
    Beckhoff TwinCAT CNC, P-AXIS-00103 (size of backlash) and P-AXIS-00243 (its distribution over control cycles).
    """

    family = "compensation"
    kind = "backlash-offset"
    reference = "LinuxCNC, compute_screw_comp; numerical controls in general"
    example = {"backlash_gap": 0.02, "backlash_velocity": 0.3, "backlash_acceleration": 30.0, "reversal_velocity": 5e-4}
    states = (Port("side"), Port("offset"), Port("offset_speed"))
    inputs = (Port("reference_velocity"),)
    outputs = (Port("reference_shift"),)

    backlash_gap: float = param(unit="m", minimum=0.0, maximum=0.1, display="um", doc="total gap between motor and load, b")
    backlash_velocity: float = param(default=0.01, unit="m/s", minimum=0.0, exclusive=True, display="mm/s", doc="top speed of the offset")
    backlash_acceleration: float = param(default=2.0, unit="m/s^2", minimum=0.0, exclusive=True, doc="top acceleration of the offset, a")
    reversal_velocity: float = param(default=0.0, unit="m/s", minimum=0.0, display="mm/s", doc="speed below which the side is kept")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        side = pushed_side(inp.reference_velocity, par.reversal_velocity, x.side)
        offset, speed = offset_after(par, x, side, clock)
        return (side, offset, speed), (offset,)


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


def strength(par: Any, acceleration: float) -> float:
    """Return the factor on all pulses for the acceleration at the reversal, by the characteristic."""
    a = fabs(acceleration)
    slow = select(a < par.acceleration_1, a * par.rise, 1.0)
    fast = select(a >= par.acceleration_3, par.fast_ratio, 1.0 + par.fall * (a - par.knee))
    return select(a > par.acceleration_2, fast, slow)


def rectangle(since: float, width: float, slack: float) -> float:
    """Return 1 from 0 to `width`, else 0; both edges may be early by `slack`."""
    return select(since >= -slack, select(since < width - slack, 1.0, 0.0), 0.0)


def decay(since: float, width: float, slack: float) -> float:
    """Return exp(-t/width) from 0 on, else 0; the start may be early by `slack`."""
    return select(since >= -slack, exp(-clip(since / width, 0.0, 1000.0)), 0.0)


SHAPES = {"rectangle": rectangle, "decay": decay}


def pulses(par: Any, side: float, reversed_at: float, strength: float, clock: Any, shape: str) -> tuple[float, float]:
    """Return the additions to command and reference."""
    # The slack keeps rounding from moving an edge by a tick.
    since, slack = clock.t - reversed_at, 1e-6 * clock.dt
    first = SHAPES[shape](since - par.first_delay, par.first_width, slack)
    second = SHAPES[shape](since - par.second_delay, par.second_width, slack)
    signed = side * strength
    return signed * (par.first_amplitude * first + par.second_amplitude * second), signed * par.position_pulse * first


class QuadrantPulses(Component):
    """Pulses in the new direction of motion after each reversal of the reference, to overcome static friction and lost motion.

    Stage 1 begins `first_delay` after the reversal, for friction on the motor side; stage 2 begins `second_delay` after the reversal, for
    friction of the machine beyond the gap. With ``shape = "rectangle"`` a stage lasts its width; with ``"decay"`` it begins at its
    amplitude and decays with its width as time constant. `position_pulse` also adds stage 1 to the reference: in a cascade with position
    gain K_v this is a velocity pulse K_v times as large.

    A factor multiplies all amplitudes. It depends on the acceleration |a| at the reversal (v^2/r at the quadrants of a circle): |a|/a_1
    below a_1, 1 from a_1 to a_2, linear to `fast_ratio` at a_3, and `fast_ratio` beyond. By default it is 1.

    The first motion is not a reversal; standstill in between is ignored. A new reversal ends the pulses of the last one.

    References
    ----------
    Siemens, SINUMERIK 840D sl Function Manual Extended Functions, K3: friction compensation (quadrant error compensation) with adaptation
    characteristic, MD32510 to MD32570. FANUC, AC servo motor parameter manual B-65270EN: two-stage backlash acceleration function.
    """

    family = "compensation"
    kind = "quadrant-pulses"
    reference = "SINUMERIK friction compensation; FANUC two-stage backlash acceleration"
    example = {
        "first_amplitude": 0.8,
        "first_width": 0.01,
        "first_delay": 0.002,
        "second_amplitude": 0.4,
        "second_width": 0.02,
        "second_delay": 0.005,
        "position_pulse": 1e-3,
        "acceleration_1": 0.9,
        "acceleration_2": 0.95,
        "acceleration_3": 1.2,
        "fast_ratio": 0.4,
        "reversal_velocity": 1e-4,
    }
    states = (Port("side"), Port("reversed_at"), Port("strength"))
    inputs = (Port("reference_velocity"), Port("reference_acceleration"))
    outputs = (Port("reference_shift"), Port("command"))
    derived = ("rise", "fall", "knee")

    first_amplitude: float = param(unit="{command}", minimum=-1e6, maximum=1e6, doc="amplitude of stage 1; positive: new direction")
    first_width: float = param(default=0.02, unit="s", minimum=0.0, exclusive=True, display="ms", doc="length or time constant of stage 1")
    first_delay: float = param(default=0.0, unit="s", minimum=0.0, display="ms", doc="delay from reversal to stage 1")
    second_amplitude: float = param(default=0.0, unit="{command}", minimum=-1e6, maximum=1e6, doc="of stage 2; positive: new direction")
    second_width: float = param(default=0.02, unit="s", minimum=0.0, exclusive=True, display="ms", doc="length or time constant of stage 2")
    second_delay: float = param(default=0.02, unit="s", minimum=0.0, display="ms", doc="delay from reversal to stage 2")
    position_pulse: float = param(default=0.0, unit="m", minimum=-0.01, maximum=0.01, display="um", doc="size of stage 1 on the reference")
    acceleration_1: float = param(default=0.0, unit="m/s^2", minimum=0.0, doc="acceleration up to which pulses grow, a_1")
    acceleration_2: float = param(default=math.inf, unit="m/s^2", minimum=0.0, doc="acceleration up to which pulses stay constant, a_2")
    acceleration_3: float = param(default=math.inf, unit="m/s^2", minimum=0.0, doc="acceleration from which factor is `fast_ratio`, a_3")
    fast_ratio: float = param(default=1.0, minimum=0.0, maximum=10.0, doc="pulse factor beyond a_3")
    reversal_velocity: float = param(default=0.0, unit="m/s", minimum=0.0, display="mm/s", doc="speed below which the side is kept")
    shape: str = text_param(default="rectangle", choices=tuple(SHAPES), doc="a stage lasts its width, or decays with it")

    def check_values(self) -> None:
        if self.acceleration_2 == math.inf != self.acceleration_3:
            raise ParameterError("acceleration_2", "not given", "given together with acceleration_3", "m/s^2")
        for low, high in (("acceleration_1", "acceleration_2"), ("acceleration_2", "acceleration_3")):
            if not getattr(self, low) <= getattr(self, high):
                raise ParameterError(high, f"{getattr(self, high):g}", f">= {low}, {getattr(self, low):g}", "m/s^2")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        # The slopes of the characteristic below a_1 and from a_2 to a_3, and the start of the latter.
        first, second, third = par.acceleration_1, par.acceleration_2, par.acceleration_3
        rise = np.where(first > 0.0, 1.0 / np.where(first > 0.0, first, 1.0), 0.0)
        # An infinite a_3 gives no fall, equal a_2 and a_3 no line.
        line = np.isfinite(third) & (third > second)
        knee = np.where(line, second, 0.0)
        fall = np.where(line, (par.fast_ratio - 1.0) / (np.where(line, third, 1.0) - knee), 0.0)
        return rise, fall, knee

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, shape: str) -> Any:
        side = pushed_side(inp.reference_velocity, par.reversal_velocity, x.side)
        turned = x.side * side < 0.0
        moment = select(turned, clock.t, x.reversed_at)
        size = select(turned, strength(par, inp.reference_acceleration), x.strength)
        command, shift = pulses(par, side, moment, size, clock, shape)
        return (side, moment, size), (shift, command)


class CncBacklash(QuadrantPulses):
    """Backlash offset and two-stage quadrant pulses on one reversal of the command.

    An axis has one slot for compensation, but a control has both. Parameters are those of `backlash-offset` and `quadrant-pulses`; the
    shifts are added. The offset compensates the gap, the pulses the friction beyond it.

    References
    ----------
    Those of `backlash-offset` and `quadrant-pulses`.
    """

    kind = "cnc-backlash"
    reference = "numerical controls: backlash offset with quadrant error compensation"
    example = {**QuadrantPulses.example, **BacklashOffset.example}
    parameters = {**BacklashOffset.parameters, **QuadrantPulses.parameters}
    states = (*QuadrantPulses.states, Port("offset"), Port("offset_speed"))  # type: ignore[assignment]

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, shape: str) -> Any:
        kept, (shift, command) = QuadrantPulses.step(par, x, inp, clock, shape=shape)
        offset, speed = offset_after(par, x, kept[0], clock)
        return (*kept, offset, speed), (offset + shift, command)
