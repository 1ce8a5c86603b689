"""Quadrant-peak compensation: pulses on the command where an axis reverses, alone or with a backlash offset."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.components.compensation.backlash_offset import BacklashOffset, offset_after, pushed_side
from contourlab.components.contract import Component, param, text_param
from contourlab.engine.step import Port
from contourlab.errors import ParameterError
from contourlab.primitives import clip, exp, fabs, select


def slopes(par: Any) -> tuple[Any, ...]:
    """Return the slopes of the characteristic below a_1 and from a_2 to a_3, and the start of the latter."""
    first, second, third = (np.asarray(a, dtype=float) for a in (par.acceleration_1, par.acceleration_2, par.acceleration_3))
    rise = np.where(first > 0.0, 1.0 / np.where(first > 0.0, first, 1.0), 0.0)
    # An infinite a_3 gives no fall, equal a_2 and a_3 no line.
    line = np.isfinite(third) & (third > second)
    knee = np.where(line, second, 0.0)
    fall = np.where(line, (par.fast_ratio - 1.0) / (np.where(line, third, 1.0) - knee), 0.0)
    return rise, fall, knee


def check_characteristic(part: Any) -> None:
    """Raise unless the accelerations of a characteristic ascend.

    Raises
    ------
    ParameterError
        With the acceleration that is below the one before it.
    """
    if math.isinf(part.acceleration_2) and not math.isinf(part.acceleration_3):
        raise ParameterError("acceleration_2", "not given", "given together with acceleration_3", "m/s^2")
    for low, high in (("acceleration_1", "acceleration_2"), ("acceleration_2", "acceleration_3")):
        if not getattr(part, low) <= getattr(part, high):
            raise ParameterError(high, f"{getattr(part, high):g}", f">= {low}, {getattr(part, low):g}", "m/s^2")


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


def pulse_states(par: Any, x: Any, side: float, acceleration: float, clock: Any) -> tuple[float, float]:
    """Return time and pulse strength of the last reversal; the strength is 0 before the first one."""
    turned = x.side * side < 0.0
    return select(turned, clock.t, x.reversed_at), select(turned, strength(par, acceleration), x.strength)


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
        check_characteristic(self)

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return slopes(par)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, shape: str) -> Any:
        side = pushed_side(inp.reference_velocity, par.reversal_velocity, x.side)
        moment, size = pulse_states(par, x, side, inp.reference_acceleration, clock)
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
