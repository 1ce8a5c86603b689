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

import numpy as np
from numpy.typing import NDArray

from contourlab.arrays import Array, Flags
from contourlab.features.tune.drive_terms import LinuxCNCGains, linuxcnc_law
from contourlab.native.kernel import kernel

GAINS = ("Pgain", "Igain", "Dgain", "FF0", "FF1", "FF2", "FF3")
"""Gains in the columns of `run_lanes`, under HAL's names."""
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

    def row(self, period: float) -> list[float]:
        """Return the numbers that the kernels need: parameters, delay, steps in a period, and the motion in one of them."""
        steps, back = (SUBSTEPS, self.behind) if self.share else (1, 0.0)
        frictions = (1.0 - back) * self.friction, back * self.friction
        parameters = [self.gain, self.offset, *frictions, *self.delayed(period), float(steps)]
        w, reduced = 2.0 * math.pi * self.resonance, self.share / (1.0 + self.share) ** 2
        slack = [0.5 * self.play, period / steps, reduced * w**2, 2.0 * self.damping_ratio * reduced * w * steps / period]
        return [*parameters, *self.motion(period / steps)[:, 1:].ravel(), *slack]


State = tuple[float, float, float, float, float]
"""Position and velocity of the motor, twist of the shaft and its rate, and the friction of the load."""


def step(axis: Array, i: int, state: State, u: float) -> State:
    """Return the state of an axis after a period under an output."""
    x, v, s, r, behind = state
    push = axis[i, 0] * u - axis[i, 1]
    for _ in range(int(axis[i, 6])):
        coasting = axis[i, 12] * v + axis[i, 13] * s + axis[i, 14] * r
        # Within the play the shaft exerts no force: what it would exert there, a mean over the step, is taken back.
        gone, loose = axis[i, 28] * r, min(max(s, -axis[i, 27]), axis[i, 27])
        after = min(max(s + gone, -axis[i, 27]), axis[i, 27])
        mean = loose if abs(gone) < 1e-15 else (after * (s + gone - 0.5 * after) - loose * (s - 0.5 * loose)) / gone
        slack = axis[i, 29] * mean + axis[i, 30] * (after - loose)
        force = rubbed(v, coasting + axis[i, 16] * behind, axis[i, 15], push + slack, axis[i, 2])
        rate = axis[i, 22] * v + axis[i, 23] * s + axis[i, 24] * r + axis[i, 25] * force
        after = coasting + axis[i, 15] * force
        if axis[i, 29] > 0.0:
            behind = rubbed(v - r, after - rate, axis[i, 16] - axis[i, 26], -slack, axis[i, 3])
        x += axis[i, 7] * v + axis[i, 8] * s + axis[i, 9] * r + axis[i, 10] * force + axis[i, 11] * behind
        s = axis[i, 17] * v + axis[i, 18] * s + axis[i, 19] * r + axis[i, 20] * force + axis[i, 21] * behind
        v, r = after + axis[i, 16] * behind, rate + axis[i, 26] * behind
    return x, v, s, r, behind


def rubbed(v: float, coasting: float, reach: float, push: float, friction: float) -> float:
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
    held = -coasting / reach
    if v == 0.0:
        return min(max(held, push - friction), push + friction)
    drag = -friction if v > 0.0 else friction
    after = coasting + reach * (push + drag)
    if v * after >= 0.0:
        return push + drag
    if abs(push + (coasting - v) / reach) <= friction:
        return held
    return push + drag * (2.0 * v / (v - after) - 1.0)


@kernel("f8[:] f8[:,:] f8[:] f8[:]")
def _driven(output: Array, axis: Array, start: Array, position: Array) -> None:
    """Move an axis by a recorded output."""
    state = start[0], start[1], 0.0, 0.0, 0.0
    whole, rest = int(axis[0, 4]), axis[0, 5]
    for k in range(output.size):
        position[k] = state[0] - rest * state[1]
        state = step(axis, 0, state, output[max(k - whole, 0)])


@kernel("f8[:] f8[:] f8[:,:] f8[:,:] f8[:] f8[:] f8[:,:] f8[:,:]")
def _closed(command: Array, noise: Array, gains: Array, axis: Array, law: Array, memory: Array, figures: Array, trace: Array) -> None:
    """Run the loop for each row of gains and axis; `law` is (period, previous target, limit, free); the last lane leaves its trace."""
    period, previous, limit, free = law[0], law[1] > 0.0, law[2], int(law[3])
    for i in range(gains.shape[0]):
        p, integral, d = gains[i, 0], gains[i, 1], gains[i, 2]
        whole, rest = int(axis[i, 4]), axis[i, 5]
        state, summed, held = (command[0], 0.0, 0.0, 0.0, 0.0), 0.0, 0.0
        last, last_rate, last_second, last_measured, last_output = command[0], 0.0, 0.0, command[0], 0.0
        largest, square, most, rough, limited, shift = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        for k in range(memory.size):
            memory[k] = 0.0
        for k in range(command.size):
            measured = state[0] - rest * state[1] + noise[k]
            if k < free:
                shift = measured - command[k]
            target = command[k] + shift
            error = (last if previous else target) - measured
            if error * held <= 0.0:
                summed += error * period
            rate = (target - last) / period
            second = (rate - last_rate) / period
            third = (second - last_second) / period
            slope = (measured - last_measured) / period
            u = p * error + integral * summed + d * (rate - slope)
            u += gains[i, 3] * target + gains[i, 4] * rate + gains[i, 5] * second + gains[i, 6] * third
            held = 0.0
            if limit > 0.0 and (u > limit or u < -limit):
                held = 1.0 if u > limit else -1.0
                u = held * limit
                limited += 1.0
            memory[k % memory.size] = u
            last, last_rate, last_second, last_measured = target, rate, second, measured
            off = target - measured
            largest = max(largest, abs(off))
            square += off * off
            most = max(most, abs(u))
            rough += (u - last_output) * (u - last_output)
            last_output = u
            if i == gains.shape[0] - 1 and k < trace.shape[0]:
                trace[k, 0] = measured
                trace[k, 1] = u
            if not largest < 1e3:
                break
            state = step(axis, i, state, memory[(k - whole) % memory.size] if k >= whole else 0.0)
        figures[i, 0] = largest
        figures[i, 1] = math.sqrt(square / command.size)
        figures[i, 2] = most
        figures[i, 3] = math.sqrt(rough / command.size)
        figures[i, 4] = limited / command.size


def driven(output: Array, model: AxisModel, period: float, start: tuple[float, float] = (0.0, 0.0)) -> Array:
    """Return the measured position (n,) [m] of an axis under a recorded output, from a position and a velocity."""
    position = np.empty(output.size)
    _driven(np.ascontiguousarray(output), np.array([model.row(period)]), np.array(start), position)
    return position


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
    """

    period: float
    previous_target: bool = True
    limit: float = 0.0


@dataclass(frozen=True, eq=False)
class Runs:
    """Runs of n sets of gains.

    Attributes
    ----------
    largest, rms : ndarray (n,) [m]
        Of command - measured position.
    output, rough, limited : ndarray (n,)
        Largest output, rms of its change from sample to sample, and share of samples at the limit.
    position, command_output : ndarray (n_sample,)
        Measured position [m] and output of the last run, if asked for; else empty.
    """

    largest: Array
    rms: Array
    output: Array
    rough: Array
    limited: Array
    position: Array
    command_output: Array


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
        One, or one for each row.
    law : Law
    trace : bool
        Return position and output of the last row.
    free : int
        Number of samples at the start in which LinuxCNC is off and the command follows the position; later commands are shifted.
    """
    rows = [model.row(law.period) for model in models]
    axis = np.array(rows * len(gains) if len(rows) == 1 else rows)
    figures, kept = np.empty((len(gains), 5)), np.zeros((command.size if trace else 0, 2))
    settings = np.array([law.period, float(law.previous_target), law.limit, float(free)])
    parts = [np.ascontiguousarray(part) for part in (command, noise, gains)]
    _closed(*parts, axis, settings, np.empty(MOST_DELAY + 1), figures, kept)
    largest, rms, output, rough, limited = figures.T
    return Runs(largest, rms, output, rough, limited, kept[:, 0], kept[:, 1])


def law_output(command: Array, measured: Array, gains: Sequence[float], law: Law) -> Array:
    """Return the output (n,) of ``pid`` for recorded signals, in the order of `GAINS`, up to a constant of the integral and its limits."""
    p, i, d, ff0, ff1, ff2, ff3 = gains
    output = linuxcnc_law(LinuxCNCGains(p, i, d, ff0, ff1, ff2, ff3), command, measured, law.period)
    if law.previous_target:  # the error lags by the last step, and its integral by all of them
        output -= p * np.diff(command, prepend=command[:1]) + i * law.period * (command - command[0])
    return output


# --- margins, without friction -------------------------------------------------------------------------------------------------------

GRID = 500
"""Frequencies of the quick check of many sets of gains."""
ROBUST = (0.75, 1.0, 1.25)
"""Factors of the axis gain at which the loop must be stable."""
Complex = NDArray[np.complex128]


def _axis_ratio(model: AxisModel, period: float) -> tuple[Array, Array]:
    """Return numerator and denominator in z of the measured position over the output."""
    whole, rest = model.delayed(period)
    size = 4 if model.share else 2
    motion = model.motion(period)
    below = np.poly(motion[:size, :size])
    seen = np.outer(motion[:size, 4], np.eye(size)[0] - rest * np.eye(size)[1])
    above = np.poly(motion[:size, :size] - seen) - below
    return model.gain * above, np.concatenate([below, np.zeros(whole)])


def loop_gain(gains: Array, model: AxisModel, period: float, z: Complex) -> Complex:
    """Return the loop gain (n, k) of sets of gains (n, 7) at points z (k,)."""
    p, i, d = (gains[:, k, None] for k in range(3))
    above, below = _axis_ratio(model, period)
    law = p + i * period * z / (z - 1.0) + d * (z - 1.0) / (period * z)
    return np.asarray(law * (np.polyval(above, z) / np.polyval(below, z)))


def _poles(gains: Array, model: AxisModel, period: float) -> Complex:
    """Return the poles of the closed loop, from the polynomials of law and axis in z."""
    above, below = _axis_ratio(model, period)
    p, i, d = gains[:3]
    law = np.array([p + i * period + d / period, -p - 2.0 * d / period, d / period])
    return np.asarray(np.roots(np.polyadd(np.polymul(below, [1.0, -1.0, 0.0]), np.polymul(above, law))))


def robustly_stable(gains: Array, model: AxisModel, period: float) -> bool:
    """Return whether the loop is stable with the gain of the axis a quarter smaller, as identified, and a quarter larger."""
    scaled = (replace(model, gain=share * model.gain) for share in ROBUST)
    return all(float(np.abs(_poles(gains, one, period)).max()) < 1.0 - 1e-9 for one in scaled)


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
    enough[enough] = [robustly_stable(row, model, period) for row in gains[enough]]
    return np.asarray(enough)
