"""One step of two masses joined by a shaft with backlash, with bristle friction on one or both.

Bristles are stiff, so the method is implicit: the midpoint rule integrates masses and shaft, and each bristle follows exactly the mean
velocity of its body at a constant slip rate. All forces are then linear in the two mean velocities: two equations. They are solved twice,
with the slip rate at the start and at the mean velocity, which gives second order.

The work of a force is exactly its mean times the mean velocity. The shaft returns the energy it takes, and a bristle z takes at least the
energy it stores, since s0 z' z <= s0 z v at any slip rate. So no step adds energy, as long as the bristle damping is dissipative
(s1 |v| <= 4 g).

The ends of contacts are located as in `two_mass_mechanics`, by repeating the step for each trial. Contacts keep the second order.

References
----------
Canudas de Wit, Olsson, Astrom & Lischinsky, "A new model for control of systems with friction", IEEE TAC 40 (1995); Barahanov & Ortega,
"Necessary and sufficient conditions for passivity of the LuGre friction model", IEEE TAC 45 (2000) (the bound on s1).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from contourlab.components.mechanics.laws import contact_guard_of, shaft_of, unwound
from contourlab.components.mechanics.located import first_zero
from contourlab.primitives import exp, fabs, select

STRETCHES = 6
"""Contacts located within a step; the rest of the step follows in one piece."""

TRIALS = 6
"""Trials for the end of a contact, from a first guess on a cubic; each repeats the step."""

SETTLED = 1e-12
"""Tolerance of the end of a contact, as a part of the step."""

SHORTEST = 1e-12
"""Travel of the load [m] below which the gap's local slope is used."""

SLOWEST = 1e-12
"""Speed [m/s] below which smooth friction is linear."""


def _relaxation(x: float) -> tuple[float, float, float]:
    """Return exp(-x), its mean over [0, x], and (1 - that mean)/x; x >= 0."""
    keep = exp(-x)
    safe = select(x < 0.03, 1.0, x)
    mean = select(x < 0.03, 1.0 - x / 2.0 * (1.0 - x / 3.0 * (1.0 - x / 4.0 * (1.0 - x / 5.0 * (1.0 - x / 6.0)))), (1.0 - keep) / safe)
    rest = select(x < 0.03, 0.5 * (1.0 - x / 3.0 * (1.0 - x / 4.0 * (1.0 - x / 5.0 * (1.0 - x / 6.0)))), (1.0 - mean) / safe)
    return keep, mean, rest


@cache
def _resistance_of(friction: Any) -> Callable[..., Any]:
    """Return ``resistance(par, z, v, h)``: (a, b, p, q) of its mean force a + b w and its bristle p z + q w after h at a mean velocity w.

    v is a guess of w.
    """
    if friction.law == "smooth":
        force = friction.force

        def smooth(par: Any, z: float, v: float, h: float) -> Any:
            w = select(fabs(v) < SLOWEST, SLOWEST, v)
            return 0.0, force(par, w) / w, 1.0, 0.0

        return smooth
    level = friction.level

    def bristle(par: Any, z: float, v: float, h: float) -> Any:
        rate = par.stiffness * fabs(v) / level(par, v)
        keep, mean, rest = _relaxation(rate * h)
        fixed = (par.stiffness - par.bristle_damping * rate) * mean * z
        return fixed, par.stiffness * h * rest + par.bristle_damping * mean + par.viscous, keep, h * mean

    return bristle


@cache
def _advance_of(gap: Any, motor: Any, load: Any, motor_view: Any, load_view: Any) -> Callable[..., Any]:
    """Return ``advance(par, side, push, y, h)``: motor position and velocity, those of the load, and both bristles after h on one side."""
    resist_motor, resist_load = _resistance_of(motor), _resistance_of(load)

    def mean_velocities(par: Any, side: float, push: Any, y: Any, v: Any, h: float) -> Any:
        half, slope = gap(par, y[2])
        way = h * v[1]
        # The mean slope of the gap over the step keeps the shaft conservative, but for the guess of the travel.
        slope = select(fabs(way) < SHORTEST, slope, (gap(par, y[2] + way)[0] - half) / select(fabs(way) < SHORTEST, 1.0, way))
        turned = 1.0 + side * slope
        spring = par.stiffness_value * (y[0] - y[2] - side * half)
        joint = par.stiffness_value * 0.5 * h + par.damper_value
        touching = fabs(side)
        spring, joint = touching * spring, touching * joint
        am, bm, pm, qm = resist_motor(motor_view(par), y[4], v[0], h)
        al, bl, pl, ql = resist_load(load_view(par), y[5], v[1], h)
        hm, hl = 0.5 * h * par.motor_mobility, 0.5 * h * par.load_mobility
        m11 = 1.0 + 0.5 * h * par.motor_decay + hm * (bm + joint)
        m22 = 1.0 + 0.5 * h * par.load_decay + hl * (bl + joint * turned * turned)
        m12, m21 = -hm * joint * turned, -hl * joint * turned
        r1 = y[1] + hm * (push[0] - am - spring)
        r2 = y[3] + hl * (push[1] - al + turned * spring)
        # The diagonal dominates: the determinant is positive.
        determinant = m11 * m22 - m12 * m21
        w = (m22 * r1 - m12 * r2) / determinant, (m11 * r2 - m21 * r1) / determinant
        return w, pm * y[4] + qm * w[0], pl * y[5] + ql * w[1]

    def advance(par: Any, side: float, push: Any, y: Any, h: float) -> Any:
        guess, _, _ = mean_velocities(par, side, push, y, (y[1], y[3]), h)
        w, zm, zl = mean_velocities(par, side, push, y, guess, h)
        return y[0] + h * w[0], 2.0 * w[0] - y[1], y[2] + h * w[1], 2.0 * w[1] - y[3], zm, zl

    return advance


@cache
def _stretch_of(gap: Any, physical: bool, motor: Any, load: Any, motor_view: Any, load_view: Any) -> Callable[..., Any]:
    """Return ``stretch(par, side, twist, push, y, h)``: the same at the next end of a contact or of the step, and the time that is left."""
    advance, (guard, falling) = _advance_of(gap, motor, load, motor_view, load_view), contact_guard_of(gap, physical)

    def stretch(par: Any, side: float, twist: float, push: Any, y: Any, h: float) -> Any:
        y1, twist1 = advance(par, side, push, y, h), unwound(par, twist, h)
        flank = select(y1[0] - y1[2] - twist1 > 0.0, 1.0, -1.0)
        last = guard(par, side, flank, y1, twist1)
        if not last < 0.0 or par.bonded > 0.5:
            return side, twist1, y1, 0.0
        a = (y1[1] - y[1]) / h, (y1[3] - y[3]) / h
        d0, d1 = falling(par, side, flank, y, a, twist), falling(par, side, flank, y1, a, twist1)
        u = first_zero(guard(par, side, flank, y, twist), last, h * d0, h * d1)
        low, high, was, before = 0.0, 1.0, 1.0, last
        for _ in range(TRIALS):
            y1 = advance(par, side, push, y, u * h)
            value = guard(par, side, flank, y1, unwound(par, twist, u * h))
            low, high = select(value > 0.0, u, low), select(value > 0.0, high, u)
            # The secant through the last two trials, kept inside the bracket.
            rise = value - before
            wanted = u - value * (u - was) / select(rise == 0.0, 1.0, rise)
            inside = select(wanted >= low, select(wanted <= high, 1.0, 0.0), 0.0)
            # Below rounding the sign of a trial is meaningless.
            settled = fabs(wanted - u) < SETTLED
            was, before = u, value
            u = select(settled, u, select(inside > 0.5, wanted, 0.5 * (low + high)))
        y1 = advance(par, side, push, y, u * h)
        # A damped shaft leaves its flank twisted; reaching a flank ends that twist.
        left_twist = select(par.unwinding > 0.0, y1[0] - y1[2] - side * gap(par, y1[2])[0], 0.0)
        twist1 = select(side == 0.0, 0.0, left_twist)
        return select(side == 0.0, flank, 0.0), twist1, y1, (1.0 - u) * h

    return stretch


@cache
def two_mass_bristle_step(gap: Any, physical: bool, motor: Any, load: Any, motor_view: Any, load_view: Any) -> Callable[..., Any]:
    """Return the step of a two-mass plant with bristles.

    Parameters
    ----------
    gap : callable
        ``gap(par, position)``: half of the free travel at the load's position, and its slope.
    physical : bool
        Which of the two models of contact.
    motor, load : friction classes
        The law of one or both is "bristle"; that of the other may be "smooth".
    motor_view, load_view : callable
        Pick the parameters of their frictions out of ``par``.
    """
    shaft, stretch = shaft_of(gap), _stretch_of(gap, physical, motor, load, motor_view, load_view)
    advance = _advance_of(gap, motor, load, motor_view, load_view)
    on_motor, on_load = bool(motor.states), bool(load.states)

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        push = (par.force_value * inp.command, inp.load)
        side, twist, left = select(par.bonded > 0.5, 1.0, x.side), x.twist, clock.dt
        zm = x.motor_friction_bristle if on_motor else 0.0
        zl = x.load_friction_bristle if on_load else 0.0
        y = (x.motor_position, x.motor_velocity, x.position, x.velocity, zm, zl)
        for _ in range(STRETCHES):
            side, twist, y, left = stretch(par, side, twist, push, y, left)
            if left <= 0.0:
                break
        if left > 0.0:
            y = advance(par, side, push, y, left)
        pm, vm, pl, vl, zm, zl = y
        force, _ = shaft(par, side, y)
        out = (pl, vl, (vl - x.velocity) / clock.dt, pm, vm, side, force)
        return (pm, vm, pl, vl, side, twist, *((zl,) if on_load else ()), *((zm,) if on_motor else ())), out

    return step
