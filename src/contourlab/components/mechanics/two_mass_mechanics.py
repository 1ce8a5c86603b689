"""One step of two masses joined by a shaft with backlash, with friction on either, and every contact located.

Between two events the motion is smooth: a classical Runge-Kutta step of fourth order. An event ends this stretch: a flank is reached or
left, a body stops or breaks loose. It is located on the cubic through both ends of the stretch, and the next stretch starts there. So
nothing chatters, the order is kept through contacts, and neither contact nor friction adds energy. A step with more events than
`STRETCHES` ends with the gap looked up at every stage, which is of second order.

The torque of the shaft is T = k theta + c theta' with its twist theta. In the model of Nordin, Galic & Gutman a flank is left where T falls
to zero, and the shaft then unwinds at the rate k/c. In the older dead-zone model it is left at the edge of the gap, and a damped shaft
pulls until then. Without damping both are equal.

Bristles are stiff, so their method is implicit: the midpoint rule integrates masses and shaft, and each bristle follows exactly the mean
velocity of its body at a constant slip rate. All forces are then linear in the two mean velocities: two equations. They are solved twice,
with the slip rate at the start and at the mean velocity, which gives second order. Ends of contacts are located by repeating the step for
each trial. The work of a force is exactly its mean times the mean velocity. The shaft returns the energy it takes, and a bristle z takes at
least the energy it stores, since s0 z' z <= s0 z v at any slip rate. So no step adds energy, as long as the bristle damping is dissipative
(s1 |v| <= 4 g).

References
----------
Nordin, Galic & Gutman, "New models for backlash and gear play", Int. J. Adaptive Control and Signal Processing 11 (1997) 49-63; Canudas de
Wit, Olsson, Astrom & Lischinsky, "A new model for control of systems with friction", IEEE TAC 40 (1995); Barahanov & Ortega, "Necessary and
sufficient conditions for passivity of the LuGre friction model", IEEE TAC 45 (2000) (the bound on s1).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from contourlab.components.mechanics.laws import (
    body_guard,
    contact_guard_of,
    first_dip,
    first_zero,
    friction_of,
    hermite,
    shaft_of,
    unwound,
)
from contourlab.primitives import exp, fabs, select

STRETCHES = 6
"""Most events located within a step; crossing the whole gap takes three."""

END, CONTACT, MOTOR, LOAD = 0.0, 1.0, 2.0, 3.0
"""Why a stretch ends: end of the step, flank reached or left, motor or load stops or breaks loose."""


def _way(v: float, push: float, held: float, released: float) -> float:
    """Return the direction in which a body slides, 0 if it is held; a body just released slides."""
    rest = select(fabs(push) <= held, released, select(push > 0.0, 1.0, -1.0))
    return select(v == 0.0, rest, select(v > 0.0, 1.0, -1.0))


@cache
def _slide_of(shaft: Any, motor: Any, load: Any, motor_view: Any, load_view: Any) -> Callable[..., Any]:
    """Return ``slide(par, side, ways, push, y, h)``: where a smooth stretch ends, and the accelerations at its start and its end."""
    resist_motor, resist_load = friction_of(motor)[0], friction_of(load)[0]

    def rates(par: Any, side: float, ways: Any, push: Any, y: Any) -> Any:
        back, forth = shaft(par, side, y)
        am = par.motor_mobility * (push[0] - back - resist_motor(motor_view(par), y[1], ways[0])) - par.motor_decay * y[1]
        al = par.load_mobility * (push[1] + forth - resist_load(load_view(par), y[3], ways[1])) - par.load_decay * y[3]
        return select(ways[0] == 0.0, 0.0, am), select(ways[1] == 0.0, 0.0, al)

    def slide(par: Any, side: float, ways: Any, push: Any, y: Any, h: float) -> Any:
        pm, vm, pl, vl = y
        half, sixth = 0.5 * h, h / 6.0
        a1, b1 = rates(par, side, ways, push, y)
        vm2, vl2 = vm + half * a1, vl + half * b1
        a2, b2 = rates(par, side, ways, push, (pm + half * vm, vm2, pl + half * vl, vl2))
        vm3, vl3 = vm + half * a2, vl + half * b2
        a3, b3 = rates(par, side, ways, push, (pm + half * vm2, vm3, pl + half * vl2, vl3))
        vm4, vl4 = vm + h * a3, vl + h * b3
        a4, b4 = rates(par, side, ways, push, (pm + h * vm3, vm4, pl + h * vl3, vl4))
        end = (
            pm + sixth * (vm + 2.0 * (vm2 + vm3) + vm4),
            vm + sixth * (a1 + 2.0 * (a2 + a3) + a4),
            pl + sixth * (vl + 2.0 * (vl2 + vl3) + vl4),
            vl + sixth * (b1 + 2.0 * (b2 + b3) + b4),
        )
        return end, (a1, b1), (a4, b4)

    return slide


@cache
def ways_of(motor: Any, load: Any, motor_view: Any, load_view: Any) -> Callable[..., Any]:
    """Return ``ways(par, net, y, released)``: the direction in which each body slides, from the forces on it without friction."""
    (_, held_motor, motor_sticks), (_, held_load, load_sticks) = friction_of(motor), friction_of(load)

    def ways(par: Any, net: Any, y: Any, released: Any) -> Any:
        way_motor, way_load = 1.0, 1.0
        if motor_sticks:
            way_motor = _way(y[1], net[0], held_motor(motor_view(par)), released[0])
        if load_sticks:
            way_load = _way(y[3], net[1], held_load(load_view(par)), released[1])
        return way_motor, way_load

    return ways


@cache
def body_event_of(friction: Any, view: Any, why: float) -> Callable[..., Any]:
    """Return ``event(par, way, v, a, net, rise, h, found)``: `found`, or the stop or release of a body where that comes first.

    v, a, net and rise (velocity, acceleration, push without friction, and its slope) are pairs: at the start and the end of the stretch.
    """
    _, held, sticks = friction_of(friction)

    def event(par: Any, way: float, v: Any, a: Any, net: Any, rise: Any, h: float, found: Any) -> Any:
        u, reason, loose = found
        if sticks:
            most = held(view(par))
            toward = select(net[1] > 0.0, 1.0, -1.0)
            last = body_guard(way, v[1], net[1], toward, most)
            if last < 0.0:
                first = body_guard(way, v[0], net[0], toward, most)
                d0, d1 = body_guard(way, a[0], rise[0], toward, 0.0), body_guard(way, a[1], rise[1], toward, 0.0)
                at = first_zero(first, last, h * d0, h * d1)
            else:
                # Two reversals within a step: friction would push the body between them.
                at = first_dip(way * v[0], way * v[1], h * (way * a[0]), h * (way * a[1]))
            if at < u:
                u, reason, loose = at, why, select(way == 0.0, toward, 0.0)
        return u, reason, loose

    return event


@cache
def _stretch_of(gap: Any, physical: bool, motor: Any, load: Any, motor_view: Any, load_view: Any) -> Callable[..., Any]:
    """Return ``stretch(par, side, twist, released, push, y, h)``: the state at the next event or the end, and the time left."""
    shaft, (guard, falling), ways_at = shaft_of(gap), contact_guard_of(gap, physical), ways_of(motor, load, motor_view, load_view)
    slide = _slide_of(shaft, motor, load, motor_view, load_view)
    motor_event, load_event = body_event_of(motor, motor_view, MOTOR), body_event_of(load, load_view, LOAD)

    def net_of(par: Any, side: float, push: Any, y: Any) -> Any:
        back, forth = shaft(par, side, y)
        return push[0] - back, push[1] + forth

    def rise_of(par: Any, side: float, y: Any, a: Any) -> float:
        return select(side == 0.0, 0.0, par.stiffness_value * (y[1] - y[3]) + par.damper_value * (a[0] - a[1]))

    def stretch(par: Any, side: float, twist: float, released: Any, push: Any, y: Any, h: float) -> Any:
        net = net_of(par, side, push, y)
        ways = ways_at(par, net, y, released)
        y1, a, a1 = slide(par, side, ways, push, y, h)
        net1 = net_of(par, side, push, y1)
        rise, rise1 = rise_of(par, side, y, a), rise_of(par, side, y1, a1)
        twist1 = unwound(par, twist, h)
        flank = select(y1[0] - y1[2] - twist1 > 0.0, 1.0, -1.0)
        u, why, loose = 1.0, END, 0.0
        last = guard(par, side, flank, y1, twist1)
        if last < 0.0 and par.bonded < 0.5:
            d0, d1 = falling(par, side, flank, y, a, twist), falling(par, side, flank, y1, a1, twist1)
            u, why = first_zero(guard(par, side, flank, y, twist), last, h * d0, h * d1), CONTACT
        found = (u, why, loose)
        found = motor_event(par, ways[0], (y[1], y1[1]), (a[0], a1[0]), (net[0], net1[0]), (-rise, -rise1), h, found)
        u, why, loose = load_event(par, ways[1], (y[3], y1[3]), (a[1], a1[1]), (net[1], net1[1]), (rise, rise1), h, found)
        if why == END:
            return side, twist1, (0.0, 0.0), y1, 0.0
        pm, pl = (hermite(u, y[i], y1[i], h * y[i + 1], h * y1[i + 1]) for i in (0, 2))
        vm, vl = (hermite(u, y[i], y1[i], h * a[i // 2], h * a1[i // 2]) for i in (1, 3))
        left_twist = select(par.unwinding > 0.0, pm - pl - side * gap(par, pl)[0], 0.0)
        kept = select(side == 0.0, unwound(par, twist, u * h), left_twist)
        side = select(why == CONTACT, select(side == 0.0, flank, 0.0), side)
        released = (select(why == MOTOR, loose, 0.0), select(why == LOAD, loose, 0.0))
        y = (pm, select(why == MOTOR, 0.0, vm), pl, select(why == LOAD, 0.0, vl))
        return side, select(side == 0.0, kept, 0.0), released, y, (1.0 - u) * h

    return stretch


@cache
def _ending_of(gap: Any, motor: Any, load: Any, motor_view: Any, load_view: Any) -> Callable[..., Any]:
    """Return ``ending(par, push, y, h)``: the rest of a step without events, bodies stopped at reversals; and the side at its end."""
    shaft, ways_at = shaft_of(gap, known=False), ways_of(motor, load, motor_view, load_view)
    slide = _slide_of(shaft, motor, load, motor_view, load_view)
    motor_sticks, load_sticks = friction_of(motor)[2], friction_of(load)[2]

    def ending(par: Any, push: Any, y: Any, h: float) -> Any:
        back, forth = shaft(par, 0.0, y)
        ways = ways_at(par, (push[0] - back, push[1] + forth), y, (0.0, 0.0))
        (pm, vm, pl, vl), _, _ = slide(par, 0.0, ways, push, y, h)
        if motor_sticks:
            vm = select(ways[0] * vm < 0.0, 0.0, vm)
        if load_sticks:
            vl = select(ways[1] * vl < 0.0, 0.0, vl)
        half = gap(par, pl)[0]
        return (pm, vm, pl, vl), select(pm - pl > half, 1.0, select(pm - pl < -half, -1.0, 0.0))

    return ending


@cache
def two_mass_step(gap: Any, physical: bool, motor: Any, load: Any, motor_view: Any, load_view: Any) -> Callable[..., Any]:
    """Return the step of a two-mass plant.

    Parameters
    ----------
    gap : callable
        ``gap(par, position)``: half of the free travel at the load's position, and its slope.
    physical : bool
        Which of the two models of contact.
    motor, load : friction classes
        Their laws are "smooth" or "sticking".
    motor_view, load_view : callable
        Pick the parameters of their frictions out of ``par``.
    """
    shaft = shaft_of(gap)
    stretch, ending = _stretch_of(gap, physical, motor, load, motor_view, load_view), _ending_of(gap, motor, load, motor_view, load_view)

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        push = (par.force_value * inp.command, inp.load)
        # Without a gap the shaft never leaves its flank.
        side, twist, released = select(par.bonded > 0.5, 1.0, x.side), x.twist, (0.0, 0.0)
        y, left = (x.motor_position, x.motor_velocity, x.position, x.velocity), clock.dt
        for _ in range(STRETCHES):
            side, twist, released, y, left = stretch(par, side, twist, released, push, y, left)
            if left <= 0.0:
                break
        if left > 0.0:
            y, side = ending(par, push, y, left)
            twist = 0.0
        force, _ = shaft(par, side, y)
        pm, vm, pl, vl = y
        return (pm, vm, pl, vl, side, twist), (pl, vl, (vl - x.velocity) / clock.dt, pm, vm, side, force)

    return step


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
def _bristled_stretch_of(gap: Any, physical: bool, motor: Any, load: Any, motor_view: Any, load_view: Any) -> Callable[..., Any]:
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
        twist1 = select(side == 0.0, 0.0, select(par.unwinding > 0.0, y1[0] - y1[2] - side * gap(par, y1[2])[0], 0.0))
        return select(side == 0.0, flank, 0.0), twist1, y1, (1.0 - u) * h

    return stretch


@cache
def two_mass_bristle_step(gap: Any, physical: bool, motor: Any, load: Any, motor_view: Any, load_view: Any) -> Callable[..., Any]:
    """Return the step of a two-mass plant with bristles; parameters as of `two_mass_step`.

    The law of one or both of `motor` and `load` is "bristle"; that of the other may be "smooth".
    """
    shaft, stretch = shaft_of(gap), _bristled_stretch_of(gap, physical, motor, load, motor_view, load_view)
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
