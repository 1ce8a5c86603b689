"""Exact motion of a mass behind a lagging force, over any time: the matrix exponential and its integrals, without a matrix.

The velocity v and the force f of the drive follow v' = m (f + n(t)) - d v, f' = w - r f - b v. For X = h [[-d, m], [-b, -r]] every function
of X is a number times I plus a number times X (Cayley and Hamilton), so that the functions phi_k(X), which integrate what acts as t^(k-1),
are pairs of numbers, computed by a Taylor series for X/2^n and n doublings without cancellation: a stiff lag costs no accuracy. The same
code serves NumPy arrays over the variants of a batch and steps.

The weights of sampled first-order low-passes, y += weight (u - y), stand here too.

References
----------
Hochbruck & Ostermann, "Exponential integrators", Acta Numerica 19 (2010), section 2; Higham, "Functions of Matrices" (2008), section 10.7.
"""

from __future__ import annotations

from typing import Any

import numpy as np

RULES = ("backward-euler", "pole-matched")
"""Backward Euler keeps the derivative w (u - y) exact on a ramp; pole matching keeps the filter's own time constant."""


def low_pass_weight(bandwidth: Any, dt: float, rule: str) -> Any:
    """Return the weight for a bandwidth [rad/s], > 0 (a number or an array) at a period [s].

    Notes
    -----
    With pole matching, 1 - exp(-w dt), the derivative w (u - y) of a ramp is scaled by w dt e/(1 - e), e = exp(-w dt): 0.31 at
    w dt = 2. With backward Euler, w dt/(1 + w dt), it is exact. An infinite bandwidth has the weight 1.
    """
    turn = np.multiply(bandwidth, dt)
    return -np.expm1(-turn) if rule == "pole-matched" else 1.0 / (1.0 + 1.0 / turn)


DOUBLINGS = 12
"""Halvings of the time before the series is taken, in a step."""
STIFFEST = 1000.0
"""Largest time, in the lag's own time constants, that `DOUBLINGS` is enough for."""
NAMES = ("v0", "v1", "v2", "v3", "v4", "x0", "x1", "x2", "x3", "x4", "f0", "f1")
"""Results of `propagator`: diagonal entries of phi_0 ... phi_4 for v, off-diagonal factors, and phi_0, phi_1 for f."""


def propagator(decay: Any, rate: Any, product: Any, h: Any, doublings: int) -> Any:
    """Return the functions phi_0 to phi_4 of a motion over the time h, in the order of `NAMES`.

    Parameters
    ----------
    decay, rate : float or ndarray [1/s], >= 0
        d and r.
    product : float or ndarray [1/s^2], >= 0
        d r + m b.
    h : float [s], >= 0
    doublings : int
        Such that h (d + r) / 2**doublings is below 1/2.
    """
    part = h * 0.5**doublings
    trace, det = -(decay + rate) * part, product * part * part
    # Horner's rule for phi_4 of Y = X/2^n, as a I + b Y, where Y^2 = trace Y - det I.
    a4, b4 = 1.0 / 479001600.0, 0.0 * trace
    for inverse in (1.0 / 39916800.0, 1.0 / 3628800.0, 1.0 / 362880.0, 1.0 / 40320.0, 1.0 / 5040.0, 1.0 / 720.0, 1.0 / 120.0, 1.0 / 24.0):
        a4, b4 = inverse - b4 * det, a4 + b4 * trace
    a3, b3 = 1.0 / 6.0 - b4 * det, a4 + b4 * trace
    a2, b2 = 0.5 - b3 * det, a3 + b3 * trace
    a1, b1 = 1.0 - b2 * det, a2 + b2 * trace
    # e^Y - 1, not e^Y: for small Y the sum would lose what matters.
    a0, b0 = -b1 * det, a1 + b1 * trace
    for _ in range(doublings):
        s4, t4 = a0 * a4 - b0 * b4 * det, a0 * b4 + b0 * a4 + b0 * b4 * trace
        s3, t3 = a0 * a3 - b0 * b3 * det, a0 * b3 + b0 * a3 + b0 * b3 * trace
        s2, t2 = a0 * a2 - b0 * b2 * det, a0 * b2 + b0 * a2 + b0 * b2 * trace
        s1, t1 = a0 * a1 - b0 * b1 * det, a0 * b1 + b0 * a1 + b0 * b1 * trace
        s0, t0 = a0 * a0 - b0 * b0 * det, 2.0 * a0 * b0 + b0 * b0 * trace
        a4, b4 = 0.0625 * (2.0 * a4 + s4 + a1 / 6.0 + 0.5 * a2 + a3), 0.03125 * (2.0 * b4 + t4 + b1 / 6.0 + 0.5 * b2 + b3)
        a3, b3 = 0.125 * (2.0 * a3 + s3 + 0.5 * a1 + a2), 0.0625 * (2.0 * b3 + t3 + 0.5 * b1 + b2)
        a2, b2 = 0.25 * (2.0 * a2 + s2 + a1), 0.125 * (2.0 * b2 + t2 + b1)
        a1, b1 = 0.5 * (2.0 * a1 + s1), 0.25 * (2.0 * b1 + t1)
        a0, b0 = 2.0 * a0 + s0, 0.5 * (2.0 * b0 + t0)
        trace, det = 2.0 * trace, 4.0 * det
    dh, rh, a0 = decay * h, rate * h, 1.0 + a0
    diagonal = (a0 - b0 * dh, a1 - b1 * dh, a2 - b2 * dh, a3 - b3 * dh, a4 - b4 * dh)
    return (*diagonal, b0 * h, b1 * h, b2 * h, b3 * h, b4 * h, a0 - b0 * rh, a1 - b1 * rh)


def doublings_for(stiffness: float) -> int:
    """Return how many doublings a motion over h (d + r) = stiffness takes."""
    found = DOUBLINGS
    while stiffness > 0.25 * 2.0**found:
        found += 1
    return found


def speed(phi: Any, m: float, h: float, v: float, f: float, w: float, n: float, q: float) -> float:
    """Return the velocity after h under the push n + q t/h."""
    v0, v1, v2, _, _, x0, x1, _, _, _, _, _ = phi
    return v0 * v + m * (x0 * f + h * (x1 * w + v1 * n + v2 * q))  # type: ignore[no-any-return]


def land(phi: Any, m: float, back: float, h: float, p: float, v: float, f: float, w: float, n: float, q: float, c: float) -> Any:
    """Return position, velocity and force after h under the push n + q t/h + c (t/h)^2/2."""
    v0, v1, v2, v3, v4, x0, x1, x2, x3, _, f0, f1 = phi
    mh = m * h
    p_next = p + h * (v1 * v + m * x1 * f + mh * (x2 * w + v2 * n + v3 * q + v4 * c))
    v_next = v0 * v + m * x0 * f + mh * (x1 * w + v1 * n + v2 * q + v3 * c)
    f_next = f0 * f - back * x0 * v + h * f1 * w - back * mh * (x1 * n + x2 * q + x3 * c)
    return p_next, v_next, f_next
