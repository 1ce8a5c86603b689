"""Two sinusoids in quadrature, as code of steps: angle, correction, and its recursive fit.

The distorted signals lie on an ellipse A v1^2 + B v2^2 + C v1 v2 + D v1 + E v2 = 1 whose coefficients theta = (A, B, C, D, E) are linear in
the measured products; the constants of the correction follow from them.

References
----------
P. L. M. Heydemann, "Determination and correction of quadrature fringe measurement errors in interferometers", Applied Optics 20 (1981).
E. Ulu, N. Gecer Ulu, M. Cakmakci, "Development and validation of an adaptive method to generate high-resolution quadrature encoder
signals", Journal of Dynamic Systems, Measurement, and Control 136 (2014).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.engine.step import Port
from contourlab.primitives import clip, copysign, dot, fabs, lincomb, lookup, maximum, minimum, rint, select, sqrt

INTERVALS = 1024.0
TINY = 1e-300
PER_TURN = 1.0 / (2.0 * math.pi)
LEAST = 0.01
"""Lower bound of A and B: an amplitude ten times the nominal one. The upper bound is the inverse."""
STEEPEST = 0.9
"""Upper bound of the sine of the phase error."""
FURTHEST = 0.9
"""Upper bound of an offset over the nominal amplitude: the origin stays inside the ellipse."""
IDENTITY = (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0)
"""Upper triangle of the unit matrix, row by row, as covariances are stored."""
PLAY = 0.5
"""Half the travel, in pitches, within which an axis may dither without an update: more travel shows all phases."""
LEAST_COVARIANCE = 40.0
"""Least initial covariance over (1 - lambda): well above the steady trace, 18 (1 - lambda)."""
STATES = (Port("begun"), Port("turns"), Port("play"), Port("used"), Port("theta", 5), Port("covariance", 15))
DERIVED = ("theta_a", "theta_b", "theta_c", "theta_d", "theta_e")
TUNING = ("forgetting", "initial_covariance", "update_travel")
TABLES = ("arctangent",)
"""States, derived constants, parameters and tables of a step that calls `followed`."""


def arctangents() -> Array:
    """Return the table that `in_turns` reads: arctan(i/1024) [rad], i = 0 .. 1024."""
    return np.arctan(np.arange(INTERVALS + 1.0) / INTERVALS)


def in_turns(table: Any, u1: float, u2: float) -> float:
    """Return the angle of (u1, u2) in turns, -1/2 to 1/2, from quadrant and ratio; to rounding, and 0 at the origin.

    Between two entries the difference of angles is arctan((t - ti)/(1 + t ti)), below 1/2048: two terms of its series are exact.
    """
    across, along = fabs(u2), fabs(u1)
    t = minimum(across, along) / maximum(maximum(across, along), TINY)
    i = rint(INTERVALS * t)
    ti = i / INTERVALS
    d = (t - ti) / (1.0 + t * ti)
    angle = (lookup(table, i) + (d - d * d * d / 3.0)) * PER_TURN
    angle = select(across > along, 0.25 - angle, angle)
    angle = select(u1 < 0.0, 0.5 - angle, angle)
    return copysign(angle, u2)


def ellipse(offset_1: Any, offset_2: Any, ratio: Any, sine: Any, amplitude: Any) -> tuple[Any, ...]:
    """Return A .. E for the constants: offsets p and q, amplitude ratio r, sine of the phase error, amplitude R; numbers or arrays."""
    k = amplitude**2 * (1.0 - sine**2) - offset_1**2 - (ratio * offset_2) ** 2 - 2.0 * ratio * sine * offset_1 * offset_2
    a, b, c = 1.0 / k, ratio**2 / k, 2.0 * ratio * sine / k
    return a, b, c, -(2.0 * a * offset_1 + c * offset_2), -(2.0 * b * offset_2 + c * offset_1)


def constants(theta: Any) -> tuple[float, float, float, float, float]:
    """Return offsets p and q, ratio r, sine and cosine of the phase error from A .. E.

    Coefficients that do not describe an ellipse around the origin are clipped to their bounds, so that the result is always finite.
    """
    a, b = clip(theta[0], LEAST, 1.0 / LEAST), clip(theta[1], LEAST, 1.0 / LEAST)
    root = sqrt(a * b)
    sine = clip(theta[2] / (2.0 * root), -STEEPEST, STEEPEST)
    c = 2.0 * root * sine
    scale = 1.0 / (c * c - 4.0 * a * b)
    p = clip((2.0 * b * theta[3] - theta[4] * c) * scale, -FURTHEST, FURTHEST)
    q = clip((2.0 * a * theta[4] - theta[3] * c) * scale, -FURTHEST, FURTHEST)
    return p, q, sqrt(b / a), sine, sqrt(1.0 - sine * sine)


def corrected(errors: tuple[float, float, float, float, float], v1: float, v2: float) -> tuple[float, float]:
    """Return the signals without their errors: u1 = v1 - p, u2 = (u1 sin al + r (v2 - q))/cos al."""
    p, q, r, sine, cosine = errors
    u1 = v1 - p
    return u1, (u1 * sine + r * (v2 - q)) / cosine


def updated(theta: Any, covariance: Any, v1: float, v2: float, forgetting: float, start: float, gate: float) -> tuple[Any, Any]:
    """Return coefficients and covariance after one sample: recursive least squares with exponential forgetting and resetting.

    Parameters
    ----------
    theta : tuple of 5
    covariance : tuple of 15
        Upper triangle, row by row.
    v1, v2 : float
        Measured signals over the nominal amplitude.
    forgetting : float, 0 < lambda <= 1
    start : float, > 0
        The initial covariance is this times the unit matrix. If the trace grows beyond the initial one, the covariance is reset: forgetting
        lets it grow without bound in directions that are not excited.
    gate : float
        1 to use the sample, 0 to change nothing.
    """
    w = (v1 * v1, v2 * v2, v1 * v2, v1, v2)
    p = covariance
    g0 = dot((p[0], p[1], p[2], p[3], p[4]), w)
    g1 = dot((p[1], p[5], p[6], p[7], p[8]), w)
    g2 = dot((p[2], p[6], p[9], p[10], p[11]), w)
    g3 = dot((p[3], p[7], p[10], p[12], p[13]), w)
    g4 = dot((p[4], p[8], p[11], p[13], p[14]), w)
    g = (g0, g1, g2, g3, g4)
    scale = gate / (forgetting + maximum(dot(w, g), 0.0))
    upper = (g0 * g0, g0 * g1, g0 * g2, g0 * g3, g0 * g4, g1 * g1, g1 * g2, g1 * g3, g1 * g4)
    products = (*upper, g2 * g2, g2 * g3, g2 * g4, g3 * g3, g3 * g4, g4 * g4)
    growth = 1.0 + gate * (1.0 / forgetting - 1.0)
    next_covariance = lincomb(growth, p, -growth * scale, products)
    trace = next_covariance[0] + next_covariance[5] + next_covariance[9] + next_covariance[12] + next_covariance[14]
    reset = select(trace > 5.0 * start, 1.0, 0.0)
    next_covariance = lincomb(1.0 - reset, next_covariance, reset * start, IDENTITY)
    return lincomb(1.0, theta, scale * (1.0 - dot(w, theta)), g), next_covariance


def followed(par: Any, x: Any, v1: float, v2: float, near: float) -> tuple[tuple[Any, ...], tuple[float, float]]:
    """Correct a sample and update the fit; return the next states and the corrected signals.

    The fit ignores dither within a pitch and takes one sample per `update_travel`. It thus forgets with travel, not with time.

    Parameters
    ----------
    par
        Has the names of DERIVED (initial knowledge), TUNING and TABLES.
    x
        Has the names of STATES; all zero at the start.
    v1, v2 : float
        Measured signals over the nominal amplitude.
    near : float
        Position of the axis in pitches, to within half a pitch.
    """
    known = (par.theta_a, par.theta_b, par.theta_c, par.theta_d, par.theta_e)
    theta = lincomb(x.begun, x.theta, 1.0 - x.begun, known)
    covariance = lincomb(x.begun, x.covariance, (1.0 - x.begun) * par.initial_covariance, IDENTITY)
    u1, u2 = corrected(constants(theta), v1, v2)
    angle = in_turns(par.arctangent, u1, u2)
    turns = angle + rint(near - angle)
    play = select(x.begun > 0.0, clip(x.play, turns - PLAY, turns + PLAY), turns)
    moved = select(x.begun > 0.0, play - x.used, par.update_travel)
    gate = select(fabs(moved) >= par.update_travel, 1.0, 0.0)
    theta, covariance = updated(theta, covariance, v1, v2, par.forgetting, par.initial_covariance, gate)
    return (1.0, turns, play, select(gate > 0.0, play, x.used), theta, covariance), (u1, u2)
