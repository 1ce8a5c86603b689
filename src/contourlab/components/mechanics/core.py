"""Plant and friction linked into one step: friction is part of the plant's integration.

Three laws, each with its own integration method; command and load are constant over the step.

- *smooth* friction is a force of velocity: classical Runge-Kutta, fourth order.
- *sticking* friction holds the axis at rest: Runge-Kutta while it slides one way; where the velocity passes zero within the step, the
  instant is located on the cubic through both ends, and from there the axis is held, or slides the other way. No chatter, and friction
  never gives energy.
- *bristle* friction is stiff: velocity and bristle are advanced together, implicitly, and extrapolated to second order.

A plant whose drive's force lags behind its command has a third state. What is linear, the lag and its back-action included, moves exactly
(`propagator`): an electrical time constant far below the servo period needs no sub-steps. Friction acts on it as a push that is a
polynomial in time over the step: by the exponential Runge-Kutta method of fourth order of Krogstad, which without decay and lag is the
classical one. A reversal is located on the motion itself; from there the axis is held while the force goes on, and breaks away at the
instant at which the force passes the breakaway friction.

A plant whose motor and load can differ in position has a friction on either side and links them itself: `two_mass_mechanics`. One that has
a step of its own keeps it; friction acts on its load: `rubbing`.

References
----------
Krogstad, "Generalized integrating factor methods for stiff PDEs", J. Comput. Phys. 203 (2005), eq (51).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from contourlab.components.contract import Component
from contourlab.components.friction.laws import NoFriction
from contourlab.components.mechanics.following import following
from contourlab.components.mechanics.laws import friction_of
from contourlab.components.mechanics.propagator import DOUBLINGS, land, propagator, speed
from contourlab.components.mechanics.rubbing import rubbed
from contourlab.engine.step import Port, Step, record
from contourlab.errors import ComponentError
from contourlab.native.generated import generated
from contourlab.primitives import clip, exp, fabs, log, maximum, select

MOTOR_FRICTION, LOAD_FRICTION = "motor_friction_", "load_friction_"
"""Prefixes of friction parameters on a plant with two sides: shaft and bristles both have a stiffness."""


def friction_prefix(plant: Any) -> str:
    """Return the prefix of the names of the load friction's parameters."""
    return LOAD_FRICTION if hasattr(plant, "joined") else ""


def moves_its_count(plant: Any) -> bool:
    """Tell whether a step count pulls the plant along: its step covers a servo period with all sub-steps."""
    return hasattr(plant, "pull")


def link(plant: Component, friction: Component, motor_friction: Component | None = None, substeps: int = 1) -> Step:
    """Return the step of a plant with its friction.

    Parameters
    ----------
    plant : SingleMass, LaggedMass, a plant with two sides, or one with a step of its own
    friction : Component of the family friction
    motor_friction : Component of the family friction, optional
        Of the motor, on a plant with two sides; its parameters have the prefix `MOTOR_FRICTION`.
    substeps : int
        Within the step of a plant that a step count pulls along; the engine repeats the steps of all others.

    Raises
    ------
    ComponentError
        If plant and friction have a parameter of the same name, or the plant does not support the friction's law.
    """
    if hasattr(plant, "joined"):
        return _two_sided(plant, friction, motor_friction or NoFriction())
    shared = sorted({*plant.numeric(), *plant.derived} & {*friction.numeric(), *friction.derived})
    if shared:
        raise ComponentError(f"plant {plant.kind} and friction {friction.kind} both have a parameter {shared[0]!r}: rename one")
    parameters = (*plant.numeric(), *plant.derived, *friction.numeric(), *friction.derived)
    states, name = (*plant.states, *friction.states), f"plant/{plant.kind}+{friction.kind}"
    if getattr(plant, "steps_itself", False):
        function, names = (
            plant.step_function(),
            [tuple(port.name for port in ports) for ports in (plant.states, plant.inputs, plant.outputs)],
        )
        if not isinstance(friction, NoFriction):
            rough: Any = type(friction)
            function = rubbed(function, rough, names[0], names[1], names[2].index("velocity"))
        return Step(name, function, parameters, plant.tables, plant.ring, states, plant.inputs, plant.outputs)
    makers: dict[str, Callable[..., Any]] = {"smooth": _smooth, "sticking": _sticking, "bristle": _bristle}
    if any(port.name == "force" for port in plant.states):
        makers = {"smooth": lagged_smooth, "sticking": lagged_sticking, "bristle": lagged_bristle}
    law = getattr(friction, "law", "")
    if law not in makers:
        raise ComponentError(f"friction {friction.kind}: law {law!r} is not one of {', '.join(makers)}")
    kinds: tuple[Any, Any] = (type(plant), type(friction))
    function = following(*kinds, makers[law], substeps) if moves_its_count(plant) else makers[law](*kinds)
    return Step(name, function, parameters, (), "", states, plant.inputs, plant.outputs)


def _two_sided(plant: Any, friction: Component, motor_friction: Component) -> Step:
    rows, views, states = [*plant.numeric(), *plant.derived], [], list(plant.states)
    for prefix, side in ((LOAD_FRICTION, friction), (MOTOR_FRICTION, motor_friction)):
        names = (*side.numeric(), *side.derived)
        views.append(_view(prefix, names))
        rows += [f"{prefix}{name}" for name in names]
        states += [Port(f"{prefix}{port.name}", port.size) for port in side.states]
    function = plant.joined(type(motor_friction), type(friction), views[1], views[0])
    name = f"plant/{plant.kind}+{friction.kind}+{motor_friction.kind}"
    return Step(name, function, tuple(rows), plant.tables, "", tuple(states), plant.inputs, plant.outputs)


@cache
def _view(prefix: str, names: tuple[str, ...]) -> Callable[..., Any]:
    """Return a function that selects the parameters of one friction, under their own names."""
    if not names:
        return lambda par: par
    scope: dict[str, Any] = {"__name__": __name__, "View": record(names)}
    source = f"def view(par):\n    return View({', '.join(f'par.{prefix}{name}' for name in names)})\n"
    view: Callable[..., Any] = generated(source, scope, "view")
    return view


@cache
def _slide_of(plant: Any, friction: Any) -> Callable[..., Any]:
    """Return ``slide(par, p, v, push, way, h)``: position and velocity after h, and the acceleration at both ends and on average."""
    mobility, decay, resistance = plant.mobility, plant.decay, friction_of(friction)[0]

    def acceleration(par: Any, v: float, push: float, way: float) -> float:
        return mobility(par) * (push - resistance(par, v, way)) - decay(par) * v  # type: ignore[no-any-return]

    def slide(par: Any, p: float, v: float, push: float, way: float, h: float) -> Any:
        half, sixth = 0.5 * h, h / 6.0
        k1 = acceleration(par, v, push, way)
        v2 = v + half * k1
        k2 = acceleration(par, v2, push, way)
        v3 = v + half * k2
        k3 = acceleration(par, v3, push, way)
        v4 = v + h * k3
        k4 = acceleration(par, v4, push, way)
        p_next = p + sixth * (v + 2.0 * (v2 + v3) + v4)
        slope = k1 + 2.0 * (k2 + k3) + k4
        return p_next, v + sixth * slope, k1, k4, slope / 6.0

    return slide


@cache
def _smooth(plant: Any, friction: Any) -> Callable[..., Any]:
    drive_force, slide = plant.drive_force, _slide_of(plant, friction)

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        push = drive_force(par, inp.command) + inp.load
        p_next, v_next, _, _, mean = slide(par, x.position, x.velocity, push, 1.0, clock.dt)
        return (p_next, v_next), (p_next, v_next, mean)

    return step


@cache
def _sticking(plant: Any, friction: Any) -> Callable[..., Any]:
    drive_force, held, slide = plant.drive_force, friction.held, _slide_of(plant, friction)

    def zero_of_cubic(v0: float, v1: float, d0: float, d1: float) -> float:
        # Where the cubic with ends v0, v1 of opposite sign and end slopes d0, d1 (per unit interval) is zero; three Newton steps
        # from the chord, held inside the interval.
        u = v0 / (v0 - v1)
        c2, c3 = 3.0 * (v1 - v0) - 2.0 * d0 - d1, 2.0 * (v0 - v1) + d0 + d1
        for _ in range(3):
            value = v0 + u * (d0 + u * (c2 + u * c3))
            slope = d0 + u * (2.0 * c2 + 3.0 * u * c3)
            u = select(value * slope == 0.0, u, u - value / select(value * slope == 0.0, 1.0, slope))
            u = select(u < 0.0, 0.0, select(u > 1.0, 1.0, u))
        return u

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        dt, p, v = clock.dt, x.position, x.velocity
        push = drive_force(par, inp.command) + inp.load
        rest = select(fabs(push) <= held(par), 0.0, select(push > 0.0, 1.0, -1.0))
        way = select(v == 0.0, rest, select(v > 0.0, 1.0, -1.0))
        p1, v1, k1, k4, _ = slide(par, p, v, push, way, dt)
        if way == 0.0:
            p1, v1 = p, 0.0
        elif way * v1 < 0.0:
            # The instant of the reversal, as a part of the step; then from rest, held or the other way.
            u = zero_of_cubic(v, v1, dt * k1, dt * k4)
            u2, u3 = u * u, u * u * u
            p_turn = p + (p1 - p) * (3.0 * u2 - 2.0 * u3) + dt * (v * (u - 2.0 * u2 + u3) + v1 * (u3 - u2))
            p2, v2, _, _, _ = slide(par, p_turn, 0.0, push, rest, (1.0 - u) * dt)
            p1, v1 = select(rest == 0.0, p_turn, p2), select(rest == 0.0, 0.0, v2)
        return (p1, v1), (p1, v1, (v1 - v) / dt)

    return step


@cache
def _bristle(plant: Any, friction: Any) -> Callable[..., Any]:
    mobility, decay, drive_force, level = plant.mobility, plant.decay, plant.drive_force, friction.level

    def advance(par: Any, p: float, v: float, z: float, push: float, h: float) -> Any:
        # Backward Euler in (v, z) with the slip rate taken at the start: linear in the new velocity, so solved in closed form.
        keep = 1.0 / (1.0 + h * par.stiffness * fabs(v) / level(par, v))
        fixed = par.stiffness * keep * z + par.bristle_damping * (keep - 1.0) * z / h
        per_velocity = keep * (par.stiffness * h + par.bristle_damping) + par.viscous
        v1 = (v + h * mobility(par) * (push - fixed)) / (1.0 + h * (decay(par) + mobility(par) * per_velocity))
        return p + h * v1, v1, keep * (z + h * v1)

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        dt, p, v, z = clock.dt, x.position, x.velocity, x.bristle
        push = drive_force(par, inp.command) + inp.load
        p1, v1, z1 = advance(par, p, v, z, push, dt)
        pa, va, za = advance(par, p, v, z, push, 0.5 * dt)
        pb, vb, zb = advance(par, pa, va, za, push, 0.5 * dt)
        # Extrapolation over the step size cancels the first-order error.
        p_next, v_next, z_next = 2.0 * pb - p1, 2.0 * vb - v1, 2.0 * zb - z1
        return (p_next, v_next, z_next), (p_next, v_next, (v_next - v) / dt)

    return step


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
            u = select(fabs(vu) <= 1e-14 * fabs(v - v_end), u, select(inside, nearer, 0.5 * (low + high)))
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
