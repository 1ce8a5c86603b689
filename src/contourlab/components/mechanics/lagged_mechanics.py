"""Friction inside the integration of a plant whose drive's force lags behind its command.

What is linear, the lag and its back-action included, moves exactly (`propagator`): an electrical time constant
far below the servo period needs no sub-steps. Friction acts on it as a push that is a polynomial in time over the step:

- *smooth*: the exponential Runge-Kutta method of fourth order of Krogstad, which without decay and lag is the classical one;
- *sticking*: the same while the axis slides one way. The instant of a reversal is located on the motion itself; from there the axis is held
  while the force goes on, and breaks away at the instant at which the force passes the breakaway friction;
- *bristle*: bristles and their force implicitly, extrapolated to second order.

References
----------
Krogstad, "Generalized integrating factor methods for stiff PDEs", J. Comput. Phys. 203 (2005), eq (51).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from contourlab.components.mechanics.laws import friction_of
from contourlab.components.mechanics.propagator import DOUBLINGS, land, propagator, speed
from contourlab.primitives import clip, exp, fabs, log, maximum, select


def _full(par: Any) -> Any:
    diagonal = (par.full_v0, par.full_v1, par.full_v2, par.full_v3, par.full_v4)
    return (*diagonal, par.full_x0, par.full_x1, par.full_x2, par.full_x3, par.full_x4, par.full_f0, par.full_f1)


def _half(par: Any) -> Any:
    diagonal = (par.half_v0, par.half_v1, par.half_v2, par.half_v3, par.half_v4)
    return (*diagonal, par.half_x0, par.half_x1, par.half_x2, par.half_x3, par.half_x4, par.half_f0, par.half_f1)


def _over(par: Any, h: float) -> Any:
    """Return the propagator of a part of a step."""
    decay, rate = par.decay_value, par.rate_value
    return propagator(decay, rate, decay * rate + par.mobility_value * par.back_value, h, DOUBLINGS)


@cache
def _stages_of(friction: Any) -> Callable[..., Any]:
    """Return ``stages(par, full, half, h, v, f, w, load, way)``: the push at the start of a step one way, its rise and its bend."""
    resistance = friction_of(friction)[0]

    def stages(par: Any, full: Any, half: Any, h: float, v: float, f: float, w: float, load: float, way: float) -> Any:
        m = par.mobility_value
        n1 = load - resistance(par, v, way)
        n2 = load - resistance(par, speed(half, m, 0.5 * h, v, f, w, n1, 0.0), way)
        n3 = load - resistance(par, speed(half, m, 0.5 * h, v, f, w, n1, 2.0 * (n2 - n1)), way)
        n4 = load - resistance(par, speed(full, m, h, v, f, w, n1, 2.0 * (n3 - n1)), way)
        return n1, 2.0 * (n2 + n3) - 3.0 * n1 - n4, 4.0 * (n1 - n2 - n3 + n4)

    return stages


@cache
def lagged_smooth(plant: Any, friction: Any) -> Callable[..., Any]:
    """Return the step of a plant with a friction that is a force of velocity."""
    stages = _stages_of(friction)

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        h, p, v, f, load = clock.dt, x.position, x.velocity, x.force, inp.load
        w, full = par.rate_value * par.gain_value * inp.command, _full(par)
        n, rise, bend = stages(par, full, _half(par), h, v, f, w, load, 1.0)
        p1, v1, f1 = land(full, par.mobility_value, par.back_value, h, p, v, f, w, n, rise, bend)
        return (p1, v1, f1), (p1, v1, (v1 - v) / h)

    return step


@cache
def lagged_sticking(plant: Any, friction: Any) -> Callable[..., Any]:
    """Return the step of a plant with a friction that holds it at rest."""
    held, slide = friction.held, _stages_of(friction)

    def turn(par: Any, h: float, v: float, f: float, w: float, n: float, q: float, c: float, v_end: float) -> float:
        # The part of the step at which the velocity passes zero: Newton's steps on the motion itself, held between two of opposite sign.
        low, high, u = 0.0, 1.0, v / (v - v_end)
        for _ in range(6):
            _, vu, fu = land(_over(par, u * h), par.mobility_value, par.back_value, u * h, 0.0, v, f, w, n, u * q, u * u * c)
            slope = h * (par.mobility_value * (fu + n + u * (q + 0.5 * u * c)) - par.decay_value * vu)
            low, high = select(vu * v > 0.0, u, low), select(vu * v > 0.0, high, u)
            nearer = u - vu / select(slope == 0.0, 1.0, slope)
            inside = (nearer >= low) and (nearer <= high) and slope != 0.0
            # At the root itself rounding decides on which side it lies: no step from there.
            found = fabs(vu) <= 1e-14 * fabs(v - v_end)
            u = select(found, u, select(inside, nearer, 0.5 * (low + high)))
        return u

    def from_rest(par: Any, p: float, f: float, w: float, load: float, h: float) -> Any:
        # Held, the force goes to its own level on an exponential: the instant at which it passes what is held has a closed form.
        rate, hold = par.rate_value, held(par)
        level = w / rate
        f_end = level + (f - level) * exp(-rate * h)
        loose = fabs(f + load) > hold
        p1, v1, f1 = p, 0.0, f_end
        if loose or fabs(f_end + load) > hold:
            way = select(select(loose, f, f_end) + load > 0.0, 1.0, -1.0)
            edge = select(loose, f, way * hold - load)
            gap = level - edge
            ratio = maximum((level - f) / select(gap == 0.0, 1.0, gap), 1.0)
            rest = h - clip(select(loose, 0.0, log(ratio) / rate), 0.0, h)
            full = _over(par, rest)
            n, q, c = slide(par, full, _over(par, 0.5 * rest), rest, 0.0, edge, w, load, way)
            p1, v1, f1 = land(full, par.mobility_value, par.back_value, rest, p, 0.0, edge, w, n, q, c)
            # Stopped again within the same step: held, to be looked at anew in the next one.
            v1 = select(way * v1 < 0.0, 0.0, v1)
        return p1, v1, f1

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        h, p, v, f, load = clock.dt, x.position, x.velocity, x.force, inp.load
        w = par.rate_value * par.gain_value * inp.command
        p1, v1, f1, left = p, v, f, h
        if v != 0.0:
            full, way = _full(par), select(v > 0.0, 1.0, -1.0)
            n, q, c = slide(par, full, _half(par), h, v, f, w, load, way)
            p1, v1, f1 = land(full, par.mobility_value, par.back_value, h, p, v, f, w, n, q, c)
            left = 0.0
            if way * v1 < 0.0:
                u = turn(par, h, v, f, w, n, q, c, v1)
                p1, _, f1 = land(_over(par, u * h), par.mobility_value, par.back_value, u * h, p, v, f, w, n, u * q, u * u * c)
                left = (1.0 - u) * h
                v1 = 0.0
        if v == 0.0 or left > 0.0:
            p1, v1, f1 = from_rest(par, p1, f1, w, load, left)
        return (p1, v1, f1), (p1, v1, (v1 - v) / h)

    return step


@cache
def lagged_bristle(plant: Any, friction: Any) -> Callable[..., Any]:
    """Return the step of a plant with a friction of bristles."""
    level = friction.level

    def advance(par: Any, phi: Any, h: float, p: float, v: float, f: float, z: float, w: float, load: float) -> Any:
        # Bristles by backward Euler with the slip rate taken at the start: linear in the new velocity, so solved in closed form.
        m = par.mobility_value
        keep = 1.0 / (1.0 + h * par.stiffness * fabs(v) / level(par, v))
        fixed = par.stiffness * keep * z + par.bristle_damping * (keep - 1.0) * z / h
        per_velocity = keep * (par.stiffness * h + par.bristle_damping) + par.viscous
        free = speed(phi, m, h, v, f, w, load - fixed, 0.0)
        # phi_1 of the velocity is below zero only where the lag rings within the step.
        resisted = free / (1.0 + m * h * maximum(phi[1], 0.0) * per_velocity)
        p1, v1, f1 = land(phi, m, par.back_value, h, p, v, f, w, load - fixed - per_velocity * resisted, 0.0, 0.0)
        return p1, v1, f1, keep * (z + h * v1)

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        h, p, v, f, z, load = clock.dt, x.position, x.velocity, x.force, x.bristle, inp.load
        w = par.rate_value * par.gain_value * inp.command
        full, half = _full(par), _half(par)
        p1, v1, f1, z1 = advance(par, full, h, p, v, f, z, w, load)
        pa, va, fa, za = advance(par, half, 0.5 * h, p, v, f, z, w, load)
        pb, vb, fb, zb = advance(par, half, 0.5 * h, pa, va, fa, za, w, load)
        # Extrapolation over the step size cancels the first-order error.
        p_next, v_next, f_next, z_next = 2.0 * pb - p1, 2.0 * vb - v1, 2.0 * fb - f1, 2.0 * zb - z1
        return (p_next, v_next, f_next, z_next), (p_next, v_next, (v_next - v) / h)

    return step
