"""A log of a motor and a load with play and an elastic shaft between them, simulated without the model that `commission` fits."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array
from contourlab.native.kernel import kernel

SUBSTEPS = 50
STRIBECK = 2e-3
"""Velocity [m/s]."""


@dataclass(frozen=True)
class TwoMasses:
    """Motor and load; masses are over the moved mass, forces over it in m/s^2.

    Attributes
    ----------
    gain : float [m/s^2 per unit of output]
    damping : float [1/s]
    load : float
        Mass of the load; the motor has the rest of 1.
    frequency : float [Hz]
        Resonance without play.
    damping_ratio : float
    frictions : tuple of float [m/s^2]
        At motor and load.
    play : float [m]
    damped : float
        Part of the damping at the motor; the load has the rest.
    breakaway : float
        Friction at rest over that in motion, less 1; it fades over `STRIBECK`.
    count : float [m]
        Step of the encoder.
    delay : int
        Substeps by which the output acts late.
    """

    gain: float = 2.0
    damping: float = 25.0
    load: float = 0.5
    frequency: float = 60.0
    damping_ratio: float = 0.03
    frictions: tuple[float, float] = (0.01, 0.02)
    play: float = 0.0
    damped: float = 1.0
    breakaway: float = 0.0
    count: float = 0.0
    delay: int = 0

    def measured(self, command: Array, gains: dict[str, float], period: float, noise: Array) -> tuple[Array, Array]:
        """Return motor position (n,) [m] and output (n,) under HAL's pid, with gains per mm."""
        return self.with_load(command, gains, period, noise)[:2]

    def with_load(self, command: Array, gains: dict[str, float], period: float, noise: Array) -> tuple[Array, Array, Array]:
        """Return motor position (n,) [m], output (n,), and load position (n,) [m] under HAL's pid, with gains per mm."""
        motor, reduced = 1.0 - self.load, (1.0 - self.load) * self.load
        w = 2.0 * np.pi * self.frequency
        parts = [self.gain, self.damping, motor, self.load, reduced * w**2, 2.0 * self.damping_ratio * reduced * w, self.play]
        law = [1e3 * gains[name] for name in ("Pgain", "Igain", "Dgain", "FF1", "FF2")]
        out = np.zeros((command.size, 3))
        more = [*self.frictions, self.damped, self.breakaway, self.count, float(self.delay)]
        _run(command, noise, np.array([*parts, *more]), np.array([*law, period]), out)
        return out[:, 0], out[:, 1], out[:, 2]


def drawn(seed: int) -> tuple[TwoMasses, float]:
    """Return a random axis, and the largest noise of its encoder [m]."""
    generator = np.random.default_rng([24, seed])

    def between(low: float, high: float) -> float:
        return float(np.exp(generator.uniform(np.log(low), np.log(high))))

    plant = TwoMasses(
        gain=between(0.8, 6.0),
        damping=between(5.0, 80.0),
        load=float(generator.uniform(0.2, 0.6)),
        frequency=between(30.0, 250.0),
        damping_ratio=between(0.01, 0.08),
        frictions=(between(0.005, 0.06), between(0.0005, 0.03)),
        play=float(generator.choice([0.0, between(5e-6, 5e-5)])),
        damped=float(generator.uniform()),
        breakaway=float(generator.choice([0.0, generator.uniform(0.0, 0.5)])),
        count=between(1e-7, 2e-6),
        delay=int(generator.integers(SUBSTEPS)),
    )
    return plant, between(2e-8, 5e-7)


def _rubbed(v: float, force: float, mass: float, level: float, breakaway: float, h: float) -> float:
    """Return the velocity after a step with friction that falls with the speed."""
    friction = level * (1.0 + breakaway * math.exp(-abs(v) / STRIBECK))
    if v == 0.0:
        if abs(force) <= friction:
            return 0.0
        return h * (force - (friction if force > 0.0 else -friction)) / mass
    after = v + h * (force - (friction if v > 0.0 else -friction)) / mass
    return 0.0 if after * v < 0.0 else after


@kernel("f8[:] f8[:] f8[:] f8[:] f8[:,:]")
def _run(command: Array, noise: Array, axis: Array, law: Array, out: Array) -> None:
    gain, damping, motor, load, stiffness, shaft, play = axis[0], axis[1], axis[2], axis[3], axis[4], axis[5], axis[6]
    period, summed = law[5], 0.0
    h, count, late, before = period / SUBSTEPS, axis[11], int(axis[12]), 0.0
    at_motor, at_load = axis[9] * damping, (1.0 - axis[9]) * damping
    x, v, y, w = command[0], 0.0, command[0], 0.0
    last, rate, back = command[0], 0.0, command[0]
    for k in range(command.size):
        seen = x + noise[k]
        if count > 0.0:
            seen = count * math.floor(seen / count + 0.5)
        error = last - seen
        summed += error * period
        now = (command[k] - last) / period
        u = law[0] * error + law[1] * summed + law[2] * (now - (seen - back) / period) + law[3] * now + law[4] * (now - rate) / period
        out[k, 0], out[k, 1], out[k, 2] = seen, u, y
        last, rate, back = command[k], now, seen
        for part in range(SUBSTEPS):
            bent = x - y
            force = 0.0
            if abs(bent) >= 0.5 * play:
                force = stiffness * (bent - (0.5 * play if bent > 0.0 else -0.5 * play)) + shaft * (v - w)
            push = gain * (before if part < late else u)
            v = _rubbed(v, push - at_motor * v - force, motor + 0.5 * h * at_motor, axis[7], axis[10], h)
            w = _rubbed(w, force - at_load * w, load + 0.5 * h * at_load, axis[8], axis[10], h)
            x += h * v
            y += h * w
        before = u
