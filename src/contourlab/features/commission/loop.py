"""HAL's ``pid`` and one axis, sample by sample as in LinuxCNC's servo thread.

The law is that of ``src/hal/components/pid.c``: the error of the same period is in the integral, derivatives are differences over a period,
and with ``error-previous-target`` (on by default since 2.8) the error is counted from the command of the period before.

The axis is v' = -damping v + gain u - offset - friction sign(v) under a held output, exact between samples, and sticks where it stops. Its
output arrives after a whole number of periods; the rest of the delay is a shift of the measured position, x - rest v. The rest may be
negative, down to about half a period: an axis simulated in the servo thread is ahead of a held output.

With a resonance there are two masses with a shaft and play between them, each with its part of friction and damping: while friction holds
the motor, the load rings at another frequency than with the motor free.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from contourlab.arrays import Array, Complex, Flags
from contourlab.engine.runner import groups_of
from contourlab.engine.step import Late, Node, Schedule, Step, ports
from contourlab.features.tune.drive_terms import LinuxCNCGains, linuxcnc_law
from contourlab.primitives import clip, delayed, fabs, maximum, select

GAINS = ("Pgain", "Igain", "Dgain", "FF0", "FF1", "FF2", "FF3")
"""Gains in the columns of `run_lanes`, under HAL's names."""
SETTINGS = (*GAINS, "deadband", "bias")
"""What a file may set of a ``pid``, and the model has."""
MOST_DELAY = 64
"""Largest delay of an output in periods."""
SUBSTEPS = 4
"""Steps in a period in which a shaft turns."""


@dataclass(frozen=True)
class AxisModel:
    """An axis in SI.

    Attributes
    ----------
    gain : float [m/s^2 per unit of output], > 0
    damping : float [1/s], >= 0
    friction, offset : float [m/s^2]
        Friction of motor and load together.
    delay : float [s]
        From the output to the measured position, beyond the hold.
    resonance : float [Hz]
        Of the free masses; 0 for a rigid axis.
    damping_ratio : float, below 1
    share : float
        Mass behind the shaft over the mass at the motor.
    behind, damped : float, 0 to 1
        Part of the friction, and of the damping, behind the shaft.
    play : float [m]
        Between the masses.
    regulated : float [1/s]
        Part of the damping that is the velocity loop of the drive; 0 for a drive that takes torque.
    reset : float [1/s]
        Integral gain of that loop over its proportional gain.
    """

    gain: float
    damping: float
    friction: float = 0.0
    offset: float = 0.0
    delay: float = 0.0
    resonance: float = 0.0
    damping_ratio: float = 0.0
    share: float = 0.0
    behind: float = 0.0
    damped: float = 0.0
    play: float = 0.0
    regulated: float = 0.0
    reset: float = 0.0

    @property
    def per_speed(self) -> float:
        """Output for a steady speed, without friction [per m/s]."""
        return (self.regulated if self.reset else self.damping) / self.gain

    def scaled(self, factor: float) -> AxisModel:
        """Return the axis with another gain: of the drive's velocity loop, if it has one, which leaves its speed; else of the axis."""
        loop = factor * self.regulated
        return replace(self, gain=factor * self.gain, damping=self.damping - self.regulated + loop, regulated=loop)

    def delayed(self, period: float) -> tuple[int, float]:
        """Return the delay as whole periods and a rest [s]."""
        whole = max(math.floor(self.delay / period + 0.5), 0)
        return whole, self.delay - whole * period

    def motion(self, time: float) -> Array:
        """Return (4, 6): position, velocity, twist and its rate at the motor after a time, from these and the forces at motor and load."""
        rates, share = np.zeros((6, 6)), self.share
        damping = self.damping * (1.0 - self.damped if share else 1.0)
        rates[0, 1] = 1.0
        rates[1, [1, 4]] = -(1.0 + share) * damping, 1.0 + share
        if share:
            w, load = 2.0 * math.pi * self.resonance, share / (1.0 + share)
            spring, loss, rear = w**2, 2.0 * self.damping_ratio * w, self.damped * self.damping / load
            rates[1, 2:4], rates[2, 3] = [-load * spring, -load * loss], 1.0
            # The load moves with the velocity of the motor less the rate of the twist.
            rates[3] = [0.0, rates[1, 1] + rear, -spring, -loss - rear, 1.0 + share, -1.0 / load]
        # The exponential by its series over a 256th of the time: SciPy's takes longer than a run.
        part, term = np.eye(6), np.eye(6)
        for k in range(1, 9):
            term = term @ (time / 256.0 * rates) / k
            part = part + term
        return np.asarray(np.linalg.matrix_power(part, 256)[:4])

    def block(self, period: float) -> dict[str, float | Array]:
        """Return the parameters of the step of the axis."""
        time, back = period / self.steps, self.behind if self.share else 0.0
        whole, rest = self.delayed(period)
        w, reduced = 2.0 * math.pi * self.resonance, self.share / (1.0 + self.share) ** 2
        return {
            "gain": self.gain,
            "offset": self.offset,
            "friction": (1.0 - back) * self.friction,
            "friction_behind": back * self.friction,
            "whole": float(whole),
            "rest": rest,
            "half_play": 0.5 * self.play,
            "spring": reduced * w**2,
            "loss": 2.0 * self.damping_ratio * reduced * w / time,
            "regulated": self.regulated,
            "reset": self.reset,
            **dict(zip(MOTION, self.motion(time)[:, 1:].ravel().tolist(), strict=True)),
        }

    @property
    def steps(self) -> int:
        """Steps in a period."""
        return SUBSTEPS if self.share else 1


# --- the axis ------------------------------------------------------------------------------------------------------------------------

MOTION = tuple(f"{to}_{of}" for to in "pvtr" for of in "vtrml")
"""Position, velocity, twist and its rate after a step, by velocity, twist and rate before it and the forces at motor and load."""


def _moved(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    p, v, t, r, rear = x.p, x.v, x.t, x.r, x.rear
    asked, slack = par.gain * delayed(par.ring, clock, par.whole) - par.offset, 0.0
    # The integral of the drive's velocity loop is that over the whole step, and acts as at its middle.
    push = asked + x.held + 0.5 * clock.dt * par.reset * (asked - par.regulated * v)
    if par.half_play > 0.0:
        # Within the play the shaft exerts no force: what it would exert there, a mean over the step, is taken back.
        gone, loose = clock.dt * r, clip(t, -par.half_play, par.half_play)
        after = clip(t + gone, -par.half_play, par.half_play)
        mean = loose
        if fabs(gone) > 1e-15:
            mean = (after * (t + gone - 0.5 * after) - loose * (t - 0.5 * loose)) / gone
        slack = par.spring * mean + par.loss * (after - loose)
    coasting = par.v_v * v + par.v_t * t + par.v_r * r
    force = _rubbed(v, coasting + par.v_l * rear, par.v_m, push + slack, par.friction)
    driven, rate = coasting + par.v_m * force, par.r_v * v + par.r_t * t + par.r_r * r + par.r_m * force
    if par.spring > 0.0:
        rear = _rubbed(v - r, driven - rate, par.v_l - par.r_l, -slack, par.friction_behind)
    position = p + par.p_v * v + par.p_t * t + par.p_r * r + par.p_m * force + par.p_l * rear
    twist = par.t_v * v + par.t_t * t + par.t_r * r + par.t_m * force + par.t_l * rear
    speed = driven + par.v_l * rear
    held = x.held + par.reset * (clock.dt * asked - par.regulated * (position - p))
    measured = position - par.rest * speed
    return (position, speed, twist, rate + par.r_l * rear, rear, held), (measured, measured - twist)


def _rubbed(v: float, coasting: float, reach: float, push: float, friction: float) -> float:
    """Return the mean force on a body with friction over a step: it sticks where it stops, unless it is pushed on.

    Parameters
    ----------
    v : float [m/s]
    coasting : float [m/s]
        Velocity after the step without push and friction.
    reach : float [s]
        Velocity after the step per m/s^2.
    push, friction : float [m/s^2]
    """
    if v == 0.0:
        return clip(-coasting / reach, push - friction, push + friction)
    drag = select(v > 0.0, -friction, friction)
    after = coasting + reach * (push + drag)
    if select(v > 0.0, after, -after) >= 0.0:  # no product with v: where the body sticks, rounding leaves a little of it
        return push + drag
    if fabs(push + (coasting - v) / reach) <= friction:
        return -coasting / reach
    return push + drag * (2.0 * v / (v - after) - 1.0)


NUMBERS = ("gain", "offset", "friction", "friction_behind", "whole", "rest", "half_play", "spring", "loss", "regulated", "reset", *MOTION)
AXIS = Step("axis", _moved, NUMBERS, (), "output", ports("p", "v", "t", "r", "rear", "held"), ports("output"), ports("measured", "load"))
"""Position and velocity of the motor, twist of the shaft and its rate, friction of the load, and integral of the drive's velocity loop."""


def _axis_node(models: Sequence[AxisModel], period: float, output: str, at: float, speed: float = 0.0) -> Node:
    """Return the node of axes that begin at a position; all have a shaft, or none."""
    assert len({model.steps for model in models}) == 1
    blocks = [model.block(period) for model in models]
    parameters = blocks[0] if len(blocks) == 1 else {name: np.array([block[name] for block in blocks]) for name in NUMBERS}
    first, wires, steps = {"measured": at}, {"output": output}, models[0].steps
    return Node("axis", AXIS, wires, parameters, initial={"p": at, "v": speed}, start=first, ring_length=MOST_DELAY + 1, repeat=steps)


def driven(output: Array, models: Sequence[AxisModel], period: float, at: float = 0.0, speed: float = 0.0) -> Array:
    """Return the measured positions (m, n) [m] of axes under a recorded output (n,), from a position and velocity on."""
    schedule = Schedule((_axis_node(models, period, "in.output", at, speed),), ports("output"), period, 0)
    row, parts = schedule.row("axis.measured"), []
    for group in groups_of(schedule, np.arange(len(models)), True):
        group.rings[0][:] = output[0]
        parts.append(group.run(output[:, None], [row])[:, 0].T)
    return np.concatenate(parts)[: len(models)]


# --- the loop ------------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Law:
    """What the loop has besides its gains.

    Attributes
    ----------
    period : float [s]
    previous_target : bool
        HAL's ``error-previous-target``.
    limit : float
        ``maxoutput``; 0 for none.
    deadband : float [m]
    bias : float
    """

    period: float
    previous_target: bool = True
    limit: float = 0.0
    deadband: float = 0.0
    bias: float = 0.0


@dataclass(frozen=True, eq=False)
class Runs:
    """Runs of n sets of gains.

    Attributes
    ----------
    largest, rms : ndarray (n,) [m]
        Of command - measured position.
    output, rough, limited : ndarray (n,)
        Largest output, rms of its change from sample to sample, and share of samples at the limit.
    position, command_output, load : ndarray (n_sample,)
        Measured position [m] and output of the last run, and position of its load [m], if asked for; else empty.
    """

    largest: Array
    rms: Array
    output: Array
    rough: Array
    limited: Array
    position: Array
    command_output: Array
    load: Array


LEFT = 1e3
"""Error [m] at which a run has diverged, and ends."""
SUMS = ("largest", "square", "most", "rough", "limited")
_PID_STATES = (*SUMS, "summed", "held", "shift", "last", "last_rate", "last_second", "last_measured", "last_output")


def _pid(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    measured = inp.position + inp.noise
    shift = select(clock.k < par.free, measured - inp.command, x.shift)
    target = inp.command + shift
    error = select(par.previous > 0.5, x.last, target) - measured
    error = error - clip(error, -par.deadband, par.deadband)
    summed = x.summed + select(error * x.held <= 0.0, error * clock.dt, 0.0)
    rate = (target - x.last) / clock.dt
    second = (rate - x.last_rate) / clock.dt
    third = (second - x.last_second) / clock.dt
    u = par.Pgain * error + par.Igain * summed + par.Dgain * (rate - (measured - x.last_measured) / clock.dt)
    u = u + par.bias + par.FF0 * target + par.FF1 * rate + par.FF2 * second + par.FF3 * third
    bound = select(par.limit > 0.0, par.limit, fabs(u))
    held = select(u > bound, 1.0, select(u < -bound, -1.0, 0.0))
    u = clip(u, -bound, bound)
    off, change = target - measured, u - x.last_output
    largest = select(fabs(off) <= x.largest, x.largest, fabs(off))  # what is not a number, too
    figures = (largest, x.square + off * off, maximum(x.most, fabs(u)), x.rough + change * change, x.limited + fabs(held))
    after = (*figures, summed, held, shift, target, rate, second, measured, u)
    if x.largest < LEFT:
        return after, (measured, u)
    return x, (measured, 0.0)


_TAKES, _GIVES = ports("command", "noise", "position"), ports("measured", "output")
PID = Step("pid", _pid, (*SETTINGS, "previous", "limit", "free"), (), "", ports(*_PID_STATES), _TAKES, _GIVES)
"""HAL's pid, with the sums of its figures; a run that has diverged stays as it is."""


def run_lanes(
    command: Array, noise: Array, gains: Array, models: Sequence[AxisModel], law: Law, *, trace: bool = False, free: int = 0
) -> Runs:
    """Run the closed loop once for each row of gains.

    Parameters
    ----------
    command : ndarray (n,) [m]
    noise : ndarray (n,) [m]
        Of the encoder.
    gains : ndarray (m, 7)
        In the order of `GAINS`, per metre.
    models : sequence of AxisModel
        One, or one for each row, all with a shaft or all without.
    law : Law
    trace : bool
        Return position and output of the last row.
    free : int
        Number of samples at the start in which LinuxCNC is off and the command follows the position; later commands are shifted.
    """
    settings = {"previous": float(law.previous_target), "limit": law.limit, "deadband": law.deadband, "bias": law.bias, "free": float(free)}
    parameters = {**dict(zip(GAINS, gains.T, strict=True)), **settings}
    wires: dict[str, Any] = {"command": "in.command", "noise": "in.noise", "position": Late("axis.measured")}
    at = float(command[0])
    initial = {"last": at, "last_measured": at}
    nodes = Node("pid", PID, wires, parameters, initial=initial), _axis_node(models, law.period, "pid.output", at)
    schedule = Schedule(nodes, ports("command", "noise"), law.period, 1)
    log_rows = [schedule.row(name) for name in ("pid.measured", "pid.output", "axis.load")] if trace else []
    sums, last, external = [], np.zeros((3, 0)), np.column_stack([command, noise])
    for group in groups_of(schedule, np.arange(len(gains)), True):
        log = group.run(external, log_rows)
        last = log[:, :, -1].T if trace else last  # lanes to spare have the last one's parameters
        sums.append(group.state_of("pid")[: len(SUMS)])
    figures = np.concatenate(sums, axis=1)[:, : len(gains)]
    # What a run that diverged leaves may be no number.
    figures = np.where(figures[0] < LEFT, figures, np.array([np.inf, np.inf, 0.0, 0.0, 0.0])[:, None])
    largest, square, output, rough, limited = figures
    return Runs(largest, np.sqrt(square / command.size), output, np.sqrt(rough / command.size), limited / command.size, *last)


def law_output(command: Array, measured: Array, gains: Sequence[float], law: Law) -> Array:
    """Return the output (n,) of ``pid`` for recorded signals, up to limits, bias, and a constant of the integral."""
    p, i, d, ff0, ff1, ff2, ff3 = gains
    output = linuxcnc_law(LinuxCNCGains(p, i, d, ff0, ff1, ff2, ff3), command, measured, law.period)
    target = np.concatenate([command[:1], command[:-1]]) if law.previous_target else command
    missed = command - target + np.clip(target - measured, -law.deadband, law.deadband)
    return np.asarray(output - p * missed - i * law.period * np.cumsum(missed))


# --- margins, without friction -------------------------------------------------------------------------------------------------------

GRID = 500
"""Frequencies of the quick check of many sets of gains."""
ROBUST = (0.75, 1.0, 1.25)
"""Factors of the axis gain at which the loop must be stable."""


def _axis_ratio(model: AxisModel, period: float) -> tuple[Array, Array]:
    """Return numerator and denominator in z of the measured position over the output."""
    whole, rest = model.delayed(period)
    size = 4 if model.share else 2
    motion = model.motion(period)
    ahead, pushed = motion[:size, :size], motion[:size, 4]
    if model.reset:  # one state more, as in `_moved`
        ahead = np.pad(ahead, (0, 1))
        pushed = np.append(pushed * (1.0 + 0.5 * period * model.reset), model.reset * period)
        ahead[:size, -1] = motion[:size, 4]
        ahead[:size, 1] -= 0.5 * period * model.reset * model.regulated * motion[:size, 4]
        back = model.reset * model.regulated
        ahead[-1] = np.eye(size + 1)[-1] + back * (np.eye(size + 1)[0] - ahead[0])
        pushed[-1] -= back * pushed[0]
    size = pushed.size
    below = np.poly(ahead)
    above = np.poly(ahead - np.outer(pushed, np.eye(size)[0] - rest * np.eye(size)[1])) - below
    return model.gain * above, np.concatenate([below, np.zeros(whole)])


def loop_gain(gains: Array, model: AxisModel, period: float, z: Complex) -> Complex:
    """Return the loop gain (n, k) of sets of gains (n, 7) at points z (k,)."""
    p, i, d = (gains[:, k, None] for k in range(3))
    above, below = _axis_ratio(model, period)
    law = p + i * period * z / (z - 1.0) + d * (z - 1.0) / (period * z)
    return np.asarray(law * (np.polyval(above, z) / np.polyval(below, z)))


def _largest_poles(gains: Array, model: AxisModel, period: float) -> Array:
    """Return the largest magnitude (n,) of the poles of the closed loops, from the polynomials of law and axis in z."""
    above, below = _axis_ratio(model, period)
    p, i, d = gains[:, :3].T
    law = np.stack([p + i * period + d / period, -p - 2.0 * d / period, d / period])
    whole = np.polymul(below, [1.0, -1.0, 0.0])
    polynomials = np.repeat(whole[None], len(gains), axis=0)
    for k, part in enumerate(law):
        polynomials[:, whole.size - above.size - 2 + k : whole.size - 2 + k] += part[:, None] * above
    companions = np.repeat(np.eye(whole.size - 1, k=-1)[None], len(gains), axis=0)
    companions[:, 0] = -polynomials[:, 1:] / polynomials[:, :1]
    return np.asarray(np.abs(np.linalg.eigvals(companions)).max(axis=1))


def robustly_stable(gains: Array, model: AxisModel, period: float) -> Flags:
    """Return which loops (n, 7) are stable with the gain of the axis a quarter smaller, as identified, and a quarter larger."""
    scaled = map(model.scaled, ROBUST)
    return np.asarray(np.all([_largest_poles(gains, one, period) < 1.0 - 1e-9 for one in scaled], axis=0))


def keep_margins(gains: Array, model: AxisModel, period: float, gain_margin: float, phase_margin: float) -> Flags:
    """Return which sets of gains (n, 7) are stable and keep the margins [dB, deg], on a grid of frequencies."""
    w = np.geomspace(1e-4, 1.0, GRID) * math.pi / period
    z = np.exp(1j * w * period)
    loop = loop_gain(gains, model, period, z)
    size, angle = np.log(np.abs(loop)), np.angle(-loop)
    crosses = (size[:, 1:] > 0.0) != (size[:, :-1] > 0.0)
    phase = np.minimum(np.abs(angle[:, 1:]), np.abs(angle[:, :-1]))
    enough = ~(crosses & (phase < math.radians(phase_margin))).any(axis=1)
    # The angle to -1 passes zero; a jump by a turn is no crossing.
    meets = ((angle[:, 1:] > 0.0) != (angle[:, :-1] > 0.0)) & (np.abs(np.diff(angle, axis=1)) < math.pi)
    near = np.minimum(np.abs(size[:, 1:]), np.abs(size[:, :-1])) < gain_margin * math.log(10.0) / 20.0
    enough &= ~(meets & near).any(axis=1)
    # At half the sample rate the loop is real: it meets the axis without crossing it.
    enough &= ~((loop[:, -1].real < 0.0) & (np.abs(size[:, -1]) < gain_margin * math.log(10.0) / 20.0))
    enough[enough] = robustly_stable(gains[enough], model, period)
    return np.asarray(enough)
