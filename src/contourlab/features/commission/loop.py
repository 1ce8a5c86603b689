"""HAL's ``pid`` and one axis, sample by sample as in LinuxCNC's servo thread.

The law is that of ``src/hal/components/pid.c``: the error of the same period is in the integral, derivatives are differences over a period,
and with ``error-previous-target`` (on by default since 2.8) the error is counted from the command of the period before.

The axis is v' = -damping v + gain u - offset - friction sign(v) under a held output, exact between samples, and sticks where it turns. Its
output arrives after a whole number of periods; the rest of the delay is a shift of the measured position, x - rest v. The rest may be
negative, down to about half a period: an axis simulated in the servo thread is ahead of a held output.

A resonance adds q'' + 2 zeta w q' + w^2 q = share v' of the undamped motor: two masses with a shaft between them, seen from the motor.
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


@dataclass(frozen=True)
class AxisModel:
    """An axis in SI.

    Attributes
    ----------
    gain : float [m/s^2 per unit of output], > 0
    damping : float [1/s], >= 0
    friction, offset : float [m/s^2]
    delay : float [s]
        From the output to the measured position, beyond the hold.
    resonance : float [Hz]
        0 for a rigid axis.
    damping_ratio : float, below 1
    share : float
        Mass behind the shaft over the mass at the motor.
    """

    gain: float
    damping: float
    friction: float = 0.0
    offset: float = 0.0
    delay: float = 0.0
    resonance: float = 0.0
    damping_ratio: float = 0.0
    share: float = 0.0

    def row(self, period: float) -> list[float]:
        """Return the numbers that the kernels need: decay, velocity and travel per acceleration, the parameters, and `mode`."""
        x = max(self.damping * period, 1e-8)  # below it the formulas lose digits
        gained = -math.expm1(-x) / x * period
        travel = (period - gained) / x * period
        whole = max(math.floor(self.delay / period + 0.5), 0)
        rigid = [math.exp(-x), gained, travel, self.gain, self.friction, self.offset, float(whole), self.delay - whole * period]
        return rigid + self.mode(period)

    def mode(self, period: float) -> list[float]:
        """Return transition (2, 2), row by row, and input (2,) of the resonance's deflection and its velocity over a period."""
        if not self.share:
            return [0.0] * 6
        w, zeta = 2.0 * math.pi * self.resonance, self.damping_ratio
        damped = w * math.sqrt(1.0 - zeta**2)
        faded = math.exp(-zeta * w * period)
        cosine, sine = faded * math.cos(damped * period), faded * math.sin(damped * period) / damped
        kept = cosine + zeta * w * sine
        return [kept, sine, -w * w * sine, cosine - zeta * w * sine, self.share * (1.0 - kept) / w**2, self.share * sine]


def step(axis: Array, i: int, v: float, u: float) -> tuple[float, float, float]:
    """Return velocity and travel after a period under an output, and the acceleration by output and friction."""
    push = axis[i, 3] * u - axis[i, 5]
    friction = axis[i, 4]
    if v > 0.0 or (v == 0.0 and push > friction):
        push -= friction
    elif v < 0.0 or push < -friction:
        push += friction
    else:
        return 0.0, 0.0, 0.0
    after = axis[i, 0] * v + axis[i, 1] * push
    if v * after < 0.0:
        # It turns within the period; damping does not matter in what is left of it.
        turn = v / (v - after)
        left, travel = (1.0 - turn) * axis[i, 1], 0.5 * v * turn * axis[i, 1]
        push = axis[i, 3] * u - axis[i, 5]
        if abs(push) <= friction:
            return 0.0, travel, 0.0
        push -= friction if push > 0.0 else -friction
        return push * left, travel + 0.5 * push * left * left, push
    return after, axis[i, 1] * v + axis[i, 2] * push, push


def deflect(axis: Array, i: int, q: float, w: float, push: float) -> tuple[float, float]:
    """Return deflection and velocity of the resonance after a period."""
    return axis[i, 8] * q + axis[i, 9] * w + axis[i, 12] * push, axis[i, 10] * q + axis[i, 11] * w + axis[i, 13] * push


@kernel("f8[:] f8[:,:] f8[:] f8[:]")
def _driven(output: Array, axis: Array, start: Array, position: Array) -> None:
    """Move an axis by a recorded output."""
    v, x, q, w = start[1], start[0], 0.0, 0.0
    whole, rest = int(axis[0, 6]), axis[0, 7]
    for k in range(output.size):
        position[k] = x + q - rest * (v + w)
        v, travel, push = step(axis, 0, v, output[max(k - whole, 0)])
        x += travel
        q, w = deflect(axis, 0, q, w, push)


@kernel("f8[:] f8[:] f8[:,:] f8[:,:] f8[:] f8[:] f8[:,:] f8[:,:]")
def _closed(command: Array, noise: Array, gains: Array, axis: Array, law: Array, memory: Array, figures: Array, trace: Array) -> None:
    """Run the loop for each row of gains and axis; `law` is (period, previous target, limit, free); the last lane leaves its trace."""
    period, previous, limit, free = law[0], law[1] > 0.0, law[2], int(law[3])
    for i in range(gains.shape[0]):
        p, integral, d = gains[i, 0], gains[i, 1], gains[i, 2]
        whole, rest = int(axis[i, 6]), axis[i, 7]
        x, v, q, w, summed, held = command[0], 0.0, 0.0, 0.0, 0.0, 0.0
        last, last_rate, last_second, last_measured, last_output = command[0], 0.0, 0.0, command[0], 0.0
        largest, square, most, rough, limited, shift = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        for k in range(memory.size):
            memory[k] = 0.0
        for k in range(command.size):
            measured = x + q - rest * (v + w) + noise[k]
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
            v, travel, push = step(axis, i, v, memory[(k - whole) % memory.size] if k >= whole else 0.0)
            x += travel
            q, w = deflect(axis, i, q, w, push)
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
    decay, gained, travel, gain, _, _, whole, rest, *mode = model.row(period)
    above = np.array([travel - rest * gained, gained**2 - travel * decay + rest * gained])
    below = np.polymul([1.0, -decay], [1.0, -1.0])
    if model.share:
        m11, m12, m21, m22, b1, b2 = mode
        ratio = [1.0, -m11 - m22, m11 * m22 - m12 * m21]
        deflected = [b1 - rest * b2, m12 * b2 - m22 * b1 - rest * (m21 * b1 - m11 * b2)]
        above, below = np.polyadd(np.polymul(above, ratio), np.polymul(deflected, below)), np.polymul(below, ratio)
    return gain * above, np.concatenate([below, np.zeros(int(whole))])


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
