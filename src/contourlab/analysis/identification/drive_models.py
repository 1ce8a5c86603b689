"""Models of a drive over frequency: a mass with damping and delay, and two inertias with a shaft between them.

References
----------
Altintas, Verl, Brecher, Uriarte & Pritschow, "Machine tool feed drives", CIRP Annals 60 (2011), for the two-inertia drive.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Parameters = Mapping[str, float]
ALIASES = 4
"""Of the sampled response on either side: a position falls off so fast that the rest is below 1e-3 of it."""


def linear_motor(x: Parameters, s: Complex) -> Complex:
    """Return position over force of a mass M with damping B behind a delay."""
    return np.asarray(np.exp(-s * x.get("delay", 0.0)) / (s * (x["M"] * s + x["B"])))


def two_inertia(x: Parameters, s: Complex, side: str = "motor") -> Complex:
    """Return position over force of two masses with a shaft between them, at the motor's or the load's side."""
    shaft = x["shaft_damping"] * s + x["stiffness"]
    load = x["load_mass"] * s * s + shaft
    # (motor load - shaft^2), with what cancels at low frequencies taken out beforehand.
    whole = (x["motor_mass"] * s + x["damping"]) * load + x["load_mass"] * s * shaft
    return np.asarray(np.exp(-s * x.get("delay", 0.0)) * (load if side == "motor" else shaft) / (s * whole))


def load_side(x: Parameters, s: Complex) -> Complex:
    """Return position over force at the load's side by what is told there: the whole mass, resonance [Hz], damping ratio, damping, delay.

    Notes
    -----
    Seen from the load a drive is (1 + s d/k)/(s (M s + c)) times one resonance; how motor m and load l share the mass M is not in it. The
    damping ratio is the resonance's own, to first order

        zeta = d/(2 w m l/M) + c l/(2 w m M),

    of which the shaft's part and the motor's are not told apart without the share. The lead d/k is taken as 2 zeta/w, as if all were the
    shaft's; what is the motor's lets the delay come out larger, by less than 2 zeta/w.
    """
    w = 2.0 * math.pi * x["resonance"]
    lead = 2.0 * x["damping_ratio"] / w
    rigid = s * (x["mass"] * s + x["damping"])
    return np.asarray(np.exp(-s * x["delay"]) * (1.0 + lead * s) / (rigid * (1.0 + lead * s + (s / w) ** 2)))


def held_response(model: Callable[[Complex], Complex], frequency: Array, period: float) -> Complex:
    """Return the response of a continuous model between samples: its command held, its position sampled, aliases summed.

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
    """Return the damping ratio of the resonance of two masses, by what both their shaft and the motor damp."""
    motor, load, shaft, c = x["motor_mass"], x["load_mass"], x["shaft_damping"], x["damping"]
    powers = [motor * load, (motor + load) * shaft + load * c, (motor + load) * x["stiffness"] + c * shaft, c * x["stiffness"]]
    pole = max(np.roots(powers), key=lambda root: abs(root.imag))
    return float(-pole.real / abs(pole))
