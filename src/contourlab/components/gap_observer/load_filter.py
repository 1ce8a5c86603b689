"""An extended Kalman filter of a two-inertia drive with backlash that measures the motor alone.

The state is (p, v, q, w, g, a, b, f): position and velocity of the motor and of the load, the total gap, and the relative errors of the
model's torque, load inertia and load friction. The covariance is the upper triangle, 36 numbers row by row. Lengths are at the table.

The twist of the shaft has a standard deviation s. Its force is therefore the mean of the dead zone over a normal distribution,
K s (phi(z) + z Phi(z)) for each flank, with slope K Phi(z); the variance that the slope does not explain counts as correlated noise.
Friction stops a mass if it can take up its speed within a sub-step: the same dead zone, of speed.
"""

from __future__ import annotations

from typing import Any

from contourlab.primitives import clip, dot, exp, fabs, log, maximum, minimum, select, sqrt

N_STATE = 8
N_COVARIANCE = 36
CORRELATION = 1e-3
"""Correlation time of unmodelled forces [s]."""
TAIL = 2.5
"""Distance from a flank, in deviations, beyond which the flank is ignored: the gap's distribution reaches below zero there."""
SURPRISE = 25.0
"""Limit of the squared deviations of one reading: an outlier must not decide."""

Vector = tuple[float, ...]


def normal_law(z: float) -> tuple[float, float]:
    """Return density and distribution of the standard normal law (Abramowitz & Stegun 26.2.17, to 7.5e-8)."""
    density = 0.3989422804014327 * exp(-0.5 * z * z)
    t = 1.0 / (1.0 + 0.2316419 * fabs(z))
    tail = density * t * (0.319381530 + t * (-0.356563782 + t * (1.781477937 + t * (-1.821255978 + t * 1.330274429))))
    return density, select(z > 0.0, 1.0 - tail, tail)


def _flank(x: float, s: float, tail: float) -> tuple[float, float, float]:
    """Return mean of max(x + s n, 0) over the normal distribution, its slope, and the residual variance; zeros beyond `tail`."""
    z = x / s
    density, below = normal_law(z)
    mean = maximum(density + z * below, 0.0)
    square = (z * z + 1.0) * below + z * density
    # Far inside the contact the difference is rounding alone.
    rest = select(z < 6.0, maximum(square - mean * mean - below * below, 0.0), 0.0)
    near = select(z > -tail, 1.0, 0.0)
    return near * s * mean, near * below, near * s * s * rest


def _rubbed(speed: float, threshold: float, s: float) -> tuple[float, float, float, float]:
    """Return the mean speed after friction, its slopes in speed and threshold, and the residual variance.

    Friction stops speeds within `threshold`, so that sticking is exact.
    """
    ahead, in_ahead, rest_ahead = _flank(speed - threshold, s, 40.0)
    behind, in_behind, rest_behind = _flank(-speed - threshold, s, 40.0)
    # The two exclude each other, so they are not independent; without friction they cancel.
    both = 2.0 * (ahead * behind - s * s * in_ahead * in_behind)
    return ahead - behind, in_ahead + in_behind, in_behind - in_ahead, maximum(rest_ahead + rest_behind + both, 0.0)


def touching(x: Vector, c: Vector) -> tuple[float, float, float]:
    """Return twist p - q, and its standard deviation against the forward and the backward flank."""
    twist = c[0] + c[15] - 2.0 * c[2] + 0.25 * c[26]
    tilt = c[4] - c[17]
    # A picometre keeps the quotient finite when the covariance is zero.
    return x[0] - x[2], sqrt(maximum(twist - tilt, 0.0) + 1e-24), sqrt(maximum(twist + tilt, 0.0) + 1e-24)


def started(place: float, speed: float, gap: float, gap_deviation: float, noise: float, dt: float) -> tuple[Vector, Vector]:
    """Return mean and covariance from two encoder readings: load anywhere in the gap at the motor's speed, no model error."""
    slope, square = noise / dt, 2.0 * noise / (dt * dt)
    first = (noise, slope, 0.0, slope, 0.0, 0.0, 0.0, 0.0)
    motor = (square, 0.0, square, 0.0, 0.0, 0.0, 0.0)
    load = (0.25 * gap * gap, 0.0, 0.0, 0.0, 0.0, 0.0, square + 1e-10, 0.0, 0.0, 0.0, 0.0)
    others = (gap_deviation * gap_deviation, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    return (place, speed, place, speed, gap, 0.0, 0.0, 0.0), (*first, *motor, *load, *others)


def restarted(x: Vector, c: Vector, side: float, gap: float, gap_deviation: float, part: float, keep: float) -> tuple[Vector, Vector]:
    """Return mean and covariance of a filter for another gap, from a filter in contact at a flank (`side` 1 or -1).

    Both share the position of that flank, q + side g/2, and all motion. `keep` is 1 to share the model errors too, or 0 to reset them to
    zero with standard deviation `part`.
    """
    p, v, q, w, g, a, b, f = x
    pp, pv, pq, pw, pg, pa, pb, pf, vv, vq, vw, vg, va, vb, vf = c[:15]
    qq, qw, qg, qa, qb, qf, ww, wg, wa, wb, wf = c[15:26]
    gg, ga, gb, gf, aa, ab, af, bb, bf, ff = c[26:]
    h, spread, fresh = 0.5 * side, gap_deviation * gap_deviation, (1.0 - keep) * part * part
    flank = maximum(qq + 2.0 * h * qg + h * h * gg, 0.0)
    mean = (p, v, q + h * (g - gap), w, gap, keep * a, keep * b, keep * f)
    first = (pp, pv, pq + h * pg, pw, 0.0, keep * pa, keep * pb, keep * pf)
    motor = (vv, vq + h * vg, vw, 0.0, keep * va, keep * vb, keep * vf)
    load = (flank + h * h * spread, qw + h * wg, -h * spread, keep * (qa + h * ga), keep * (qb + h * gb), keep * (qf + h * gf))
    others = (keep * aa + fresh, keep * ab, keep * af, keep * bb + fresh, keep * bf, keep * ff + fresh)
    return mean, (*first, *motor, *load, ww, 0.0, keep * wa, keep * wb, keep * wf, spread, 0.0, 0.0, 0.0, *others)


def advance(par: Any, x: Vector, c: Vector, command: float, dt: float) -> tuple[Vector, Vector]:
    """Return mean and covariance a sub-step later: half a drift, a kick by the forces, half a drift (second order, symplectic)."""
    x, c = _drifted(x, 0.5 * dt), _drift(c, 0.5 * dt)
    p, v, q, w, g, a, b, f = x
    shaft, k, d, k_gap, rest = _shaft(par, x, c)
    m, n = dt * par.motor_mobility, dt * par.load_mobility / (1.0 + b)
    torque = par.force_value * command
    free = v + m * ((1.0 + a) * torque - par.motor_drag * v - shaft)
    v, keeps, _, rest_motor = _rubbed(free, m * par.motor_coulomb, sqrt(maximum(c[8], 0.0) + 1e-24))
    m = keeps * m
    of_motor = (-m * k, keeps - m * (d + par.motor_drag), m * k, m * d, -m * k_gap, m * torque, 0.0, 0.0)
    drag = (1.0 + f) * par.load_drag
    push, threshold = n * (shaft - drag * w), n * (1.0 + f) * par.coulomb
    left, keeps, stops, rest_load = _rubbed(w + push, threshold, sqrt(maximum(c[21], 0.0) + 1e-24))
    # Derivatives of the speed by inverse inertia and by friction.
    lighter, rubs = keeps * push + stops * threshold, n * (stops * par.coulomb - keeps * par.load_drag * w)
    n = keeps * n
    of_load = (n * k, n * d, -n * k, keeps - n * (d + drag), n * k_gap, 0.0, -lighter / (1.0 + b), rubs)
    # Friction also holds masses that stick against noise forces.
    shaken, other = rest * maximum(CORRELATION / dt, 1.0), par.force_noise / dt
    noise = (m * m * (shaken + other) + rest_motor, -m * n * shaken, n * n * (shaken + other) + rest_load)
    c = _kick(c, of_motor, of_load, noise)
    return _drifted((p, v, q, left, g, a, b, f), 0.5 * dt), _drift(c, 0.5 * dt)


def _shaft(par: Any, x: Vector, c: Vector) -> tuple[float, float, float, float, float]:
    """Return mean force of the shaft, its slopes in twist, twist rate and gap, and the residual variance."""
    twist, s_forward, s_backward = touching(x, c)
    ahead, in_ahead, rest_ahead = _flank(twist - 0.5 * x[4], s_forward, TAIL)
    behind, in_behind, rest_behind = _flank(-twist - 0.5 * x[4], s_backward, TAIL)
    # Contact at one flank excludes the other, even while the gap is hardly known.
    one, other = 1.0 - in_behind, 1.0 - in_ahead
    k, d = par.stiffness_value, par.damper_value * (one * in_ahead + other * in_behind)
    force = k * (one * ahead - other * behind) + d * (x[1] - x[3])
    slope, tilt = k * (one * in_ahead + other * in_behind), 0.5 * k * (other * in_behind - one * in_ahead)
    return force, slope, d, tilt, k * k * (one * rest_ahead + other * rest_behind)


def _drifted(x: Vector, dt: float) -> Vector:
    p, v, q, w, g, a, b, f = x
    return p + dt * v, v, q + dt * w, w, g, a, b, f


def _drift(c: Vector, dt: float) -> Vector:
    """Return the covariance after p += dt v, q += dt w."""
    pp, pv, pq, pw, pg, pa, pb, pf, vv, vq, vw, vg, va, vb, vf = c[:15]
    qq, qw, qg, qa, qb, qf, ww, wg, wa, wb, wf = c[15:26]
    first = (
        pp + dt * (2.0 * pv + dt * vv),
        pv + dt * vv,
        pq + dt * (pw + vq + dt * vw),
        pw + dt * vw,
        pg + dt * vg,
        pa + dt * va,
        pb + dt * vb,
        pf + dt * vf,
    )
    motor = (vv, vq + dt * vw, vw, vg, va, vb, vf)
    load = (qq + dt * (2.0 * qw + dt * ww), qw + dt * ww, qg + dt * wg, qa + dt * wa, qb + dt * wb, qf + dt * wf)
    return (*first, *motor, *load, ww, wg, wa, wb, wf, *c[26:])


def _kick(c: Vector, m: Vector, n: Vector, noise: Vector) -> Vector:
    """Return the covariance after v and w became the linear forms `m` and `n` of the state."""
    pp, pv, pq, pw, pg, pa, pb, pf, vv, vq, vw, vg, va, vb, vf = c[:15]
    qq, qw, qg, qa, qb, qf, ww, wg, wa, wb, wf = c[15:26]
    gg, ga, gb, gf, aa, ab, af, bb, bf, ff = c[26:]
    of_p, of_v = (pp, pv, pq, pw, pg, pa, pb, pf), (pv, vv, vq, vw, vg, va, vb, vf)
    of_q, of_w = (pq, vq, qq, qw, qg, qa, qb, qf), (pw, vw, qw, ww, wg, wa, wb, wf)
    of_g, of_a = (pg, vg, qg, wg, gg, ga, gb, gf), (pa, va, qa, wa, ga, aa, ab, af)
    of_b, of_f = (pb, vb, qb, wb, gb, ab, bb, bf), (pf, vf, qf, wf, gf, af, bf, ff)
    v = (dot(m, of_p), dot(m, of_v), dot(m, of_q), dot(m, of_w), dot(m, of_g), dot(m, of_a), dot(m, of_b), dot(m, of_f))
    w = (dot(n, of_p), dot(n, of_v), dot(n, of_q), dot(n, of_w), dot(n, of_g), dot(n, of_a), dot(n, of_b), dot(n, of_f))
    first = (pp, v[0], pq, w[0], pg, pa, pb, pf)
    motor = (dot(m, v) + noise[0], v[2], dot(n, v) + noise[1], v[4], v[5], v[6], v[7])
    load = (qq, w[2], qg, qa, qb, qf, dot(n, w) + noise[2], w[4], w[5], w[6], w[7])
    return (*first, *motor, *load, *c[26:])


def corrected(par: Any, x: Vector, c: Vector, measured: float) -> tuple[Vector, Vector, float, float]:
    """Return mean and covariance after an encoder reading, its log-likelihood, and its squared deviations."""
    pp, pv, pq, pw, pg, pa, pb, pf, vv, vq, vw, vg, va, vb, vf = c[:15]
    qq, qw, qg, qa, qb, qf, ww, wg, wa, wb, wf = c[15:26]
    gg, ga, gb, gf, aa, ab, af, bb, bf, ff = c[26:]
    inverse = 1.0 / (maximum(pp, 0.0) + par.encoder_noise)
    error = measured - x[0]
    p, v, q, w, g, a, b, f = inverse * pp, inverse * pv, inverse * pq, inverse * pw, inverse * pg, inverse * pa, inverse * pb, inverse * pf
    # At most five deviations, so that no wrong gap makes an inertia negative.
    most = 5.0 * par.uncertainty
    mean = (
        x[0] + p * error,
        x[1] + v * error,
        x[2] + q * error,
        x[3] + w * error,
        clip(x[4] + g * error, 0.0, 4.0 * par.largest_gap),
        clip(x[5] + a * error, -most, most),
        clip(x[6] + b * error, -most, most),
        clip(x[7] + f * error, -most, most),
    )
    # fmt: off
    covariance = (
        maximum(pp - p * pp, 0.0), pv - p * pv, pq - p * pq, pw - p * pw, pg - p * pg, pa - p * pa, pb - p * pb, pf - p * pf,
        maximum(vv - v * pv, 0.0), vq - v * pq, vw - v * pw, vg - v * pg, va - v * pa, vb - v * pb, vf - v * pf,
        maximum(qq - q * pq, 0.0), qw - q * pw, qg - q * pg, qa - q * pa, qb - q * pb, qf - q * pf,
        maximum(ww - w * pw, 0.0), wg - w * pg, wa - w * pa, wb - w * pb, wf - w * pf,
        maximum(gg - g * pg, 0.0), ga - g * pa, gb - g * pb, gf - g * pf,
        maximum(aa - a * pa, 0.0), ab - a * pb, af - a * pf,
        maximum(bb - b * pb, 0.0), bf - b * pf,
        maximum(ff - f * pf, 0.0),
    )
    # fmt: on
    surprise = minimum(inverse * error * error, SURPRISE)
    return mean, covariance, 0.5 * (log(inverse) - surprise), surprise


def sane(x: Vector, c: Vector) -> float:
    """Return 1, or 0 for a filter that has diverged."""
    size = maximum(maximum(fabs(x[2] - x[0]), 1e-4 * fabs(x[1])), 1e-4 * fabs(x[3]))
    spread = maximum(maximum(c[0], c[15]), 1e-8 * maximum(c[8], c[21]))
    return select(maximum(size, spread) < 1.0, 1.0, 0.0)


def flanks(x: Vector, c: Vector) -> tuple[float, float]:
    """Return the probabilities of contact at the flank that drives forwards, and at the other."""
    twist, s_forward, s_backward = touching(x, c)
    _, ahead = normal_law((twist - 0.5 * x[4]) / s_forward)
    _, behind = normal_law((-twist - 0.5 * x[4]) / s_backward)
    return ahead, behind


def faded(par: Any, x: Vector, c: Vector) -> Vector:
    """Return the covariance after forgetting a little of gap and model errors; the position of the touched flank stays known."""
    qq, qw, qg, qa, qb, qf, ww, wg, wa, wb, wf, gg, ga, gb, gf, aa, ab, af, bb, bf, ff = c[15:]
    ahead, behind = flanks(x, c)
    rate, part, half = 2.0 * par.fading, par.uncertainty * par.uncertainty, 0.5 * (ahead - behind)
    first = par.spacing * x[4] + par.resolution
    more = rate * maximum(gg * (1.0 - gg / (first * first)), 0.0)
    load = (qq + half * half * more, qw, qg - half * more, qa, qb, qf, ww, wg, wa, wb, wf)
    gap = (gg + more, ga, gb, gf)
    torque, inertia = aa + rate * maximum(part - aa, 0.0), bb + rate * maximum(part - bb, 0.0)
    return (*c[:15], *load, *gap, torque, ab, af, inertia, bf, ff + rate * maximum(part - ff, 0.0))
