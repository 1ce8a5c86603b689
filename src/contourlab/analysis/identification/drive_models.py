"""Models of a drive over frequency: one mass with damping and delay, or two masses.

The command is held between samples and the position is sampled: a model's response is summed over its aliases, so that points near half
the sample frequency are usable too.

References
----------
Altintas, Verl, Brecher, Uriarte & Pritschow, "Machine tool feed drives", CIRP Annals 60 (2011), for the two-inertia drive.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import numpy as np

from contourlab.arrays import Array, Complex

Parameters = Mapping[str, float]

ALIASES = 4
"""Aliases on either side; the rest is below 1e-3 of the response of a position."""


def linear_motor(x: Parameters, s: Complex) -> Complex:
    """Return position over force of a mass M with damping B and a delay."""
    return np.asarray(np.exp(-s * x.get("delay", 0.0)) / (s * (x["M"] * s + x["B"])))


def two_inertia(x: Parameters, s: Complex, side: str = "motor") -> Complex:
    """Return position over force of two masses with a shaft between them, with the position of motor or load."""
    shaft = x["shaft_damping"] * s + x["stiffness"]
    load = x["load_mass"] * s * s + shaft
    # motor load - shaft^2, without the terms that cancel at low frequencies.
    whole = (x["motor_mass"] * s + x["damping"]) * load + x["load_mass"] * s * shaft
    return np.asarray(np.exp(-s * x.get("delay", 0.0)) * (load if side == "motor" else shaft) / (s * whole))


def load_side(x: Parameters, s: Complex) -> Complex:
    """Return position over force at the load, from parameters visible there: total mass, resonance [Hz], damping ratio, damping, delay.

    Notes
    -----
    Seen from the load, a drive is (1 + s d/k)/(s (M s + c)) times one resonance; the division of the mass M into motor m and load l is not
    visible. The damping ratio of the resonance is, to first order,

        zeta = d/(2 w m l/M) + c l/(2 w m M),

    whose shaft and motor parts cannot be separated without m and l. The lead d/k is taken as 2 zeta/w, as if all damping were in the
    shaft; damping of the motor then makes the delay too large, by less than 2 zeta/w.
    """
    w = 2.0 * math.pi * x["resonance"]
    lead = 2.0 * x["damping_ratio"] / w
    rigid = s * (x["mass"] * s + x["damping"])
    return np.asarray(np.exp(-s * x["delay"]) * (1.0 + lead * s) / (rigid * (1.0 + lead * s + (s / w) ** 2)))


def two_mass(x: Parameters, s: Complex) -> Complex:
    """Return position over force of the plant "two-mass", whose two modes do not couple: at the motor, or at the load without `load_share`.

    Parameters
    ----------
    x : mapping of str to float
        mass, resonance [Hz], damping_ratio, damping, delay; at the motor also load_share.
    s : ndarray (n,)

    Notes
    -----
    At the load the share is not visible: (1/(s^2 + s c/m) - 1/(s^2 + s (2 D w + c/m) + w^2))/m.
    """
    w, decay = 2.0 * math.pi * x["resonance"], x["damping"] / x["mass"]
    part = x["load_share"] / (1.0 - x["load_share"]) if "load_share" in x else -1.0
    modes = 1.0 / (s * (s + decay)) + part / (s * s + (2.0 * x["damping_ratio"] * w + decay) * s + w * w)
    return np.asarray(np.exp(-s * x["delay"]) * modes / x["mass"])


def held_response(model: Callable[[Complex], Complex], frequency: Array, period: float) -> Complex:
    """Return the sampled response of a continuous model: command held, position sampled, aliases summed.

    Parameters
    ----------
    model : callable
        From s (n,) to the response.
    frequency : ndarray (n,) [Hz]
        Below half the sample frequency.
    period : float [s]
    """
    total = np.zeros(frequency.size, dtype=complex)
    for k in range(-ALIASES, ALIASES + 1):
        s = np.asarray(2j * np.pi * (frequency + k / period), dtype=complex)
        total += model(s) * -np.expm1(-s * period) / (s * period)
    return total


def resonances(x: Parameters) -> tuple[float, float]:
    """Return resonance and antiresonance [Hz] of two masses, without damping."""
    k, motor, load = x["stiffness"], x["motor_mass"], x["load_mass"]
    return math.sqrt(k * (1.0 / motor + 1.0 / load)) / (2.0 * math.pi), math.sqrt(k / load) / (2.0 * math.pi)


def damping_ratio(x: Parameters) -> float:
    """Return the damping ratio of the resonance of two masses, from the damping of shaft and motor."""
    motor, load, shaft, c = x["motor_mass"], x["load_mass"], x["shaft_damping"], x["damping"]
    powers = [motor * load, (motor + load) * shaft + load * c, (motor + load) * x["stiffness"] + c * shaft, c * x["stiffness"]]
    pole = max(np.roots(powers), key=lambda root: abs(root.imag))
    return float(-pole.real / abs(pole))
