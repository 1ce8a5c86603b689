"""Plant and friction linked into one step: friction is part of the plant's integration.

Three laws, each with its own integration method; command and load are constant over the step.

- *smooth* friction is a force of velocity: classical Runge-Kutta, fourth order.
- *sticking* friction holds the axis at rest: Runge-Kutta while it slides one way; where the velocity passes zero within the step, the
  instant is located on the cubic through both ends, and from there the axis is held, or slides the other way. No chatter, and friction
  never gives energy.
- *bristle* friction is stiff: velocity and bristle are advanced together, implicitly, and extrapolated to second order.

A plant whose drive's force lags behind its command has a third state; its laws are in `lagged_mechanics`. One whose
motor and load can differ in position has a friction on either side and links them itself: `two_mass_mechanics` and
`two_mass_bristle`.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from contourlab.components.contract import Component
from contourlab.components.friction.laws import NoFriction
from contourlab.components.mechanics.lagged_mechanics import lagged_bristle, lagged_smooth, lagged_sticking
from contourlab.components.mechanics.laws import friction_of
from contourlab.engine.step import Port, Step, record
from contourlab.errors import ComponentError
from contourlab.native.generated import generated
from contourlab.primitives import fabs, select

MOTOR_FRICTION, LOAD_FRICTION = "motor_friction_", "load_friction_"
"""Prefixes of friction parameters on a plant with two sides: shaft and bristles both have a stiffness."""


def friction_prefix(plant: Any) -> str:
    """Return the prefix of the names of the load friction's parameters."""
    return LOAD_FRICTION if getattr(plant, "two_sided", False) else ""


def link(plant: Component, friction: Component, motor_friction: Component | None = None) -> Step:
    """Return the step of a plant with its friction.

    Parameters
    ----------
    plant : SingleMass, LaggedMass, or a plant with two sides
    friction : Component of the family friction
    motor_friction : Component of the family friction, optional
        Of the motor, on a plant with two sides; its parameters have the prefix `MOTOR_FRICTION`.

    Raises
    ------
    ComponentError
        If plant and friction have a parameter of the same name, or the plant does not support the friction's law.
    """
    if getattr(plant, "two_sided", False):
        return _two_sided(plant, friction, motor_friction or NoFriction())
    shared = sorted({*plant.numeric(), *plant.derived} & {*friction.numeric(), *friction.derived})
    if shared:
        raise ComponentError(f"plant {plant.kind} and friction {friction.kind} both have a parameter {shared[0]!r}: rename one")
    makers: dict[str, Callable[..., Any]] = {"smooth": _smooth, "sticking": _sticking, "bristle": _bristle}
    if any(port.name == "force" for port in plant.states):
        makers = {"smooth": lagged_smooth, "sticking": lagged_sticking, "bristle": lagged_bristle}
    law = getattr(friction, "law", "")
    if law not in makers:
        raise ComponentError(f"friction {friction.kind}: law {law!r} is not one of {', '.join(makers)}")
    parameters = (*plant.numeric(), *plant.derived, *friction.numeric(), *friction.derived)
    states = (*plant.states, *friction.states)
    kinds: tuple[Any, Any] = (type(plant), type(friction))
    function = makers[law](*kinds)
    return Step(f"plant/{plant.kind}+{friction.kind}", function, parameters, (), "", states, plant.inputs, plant.outputs)


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
            safe = select(value * slope == 0.0, 1.0, slope)
            u = select(value * slope == 0.0, u, u - value / safe)
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
