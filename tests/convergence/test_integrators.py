"""Order of the plants' integration, against closed forms and an independent solver."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
from scipy.integrate import solve_ivp

from contourlab.components.friction.laws import Coulomb, LuGre, NoFriction
from contourlab.components.mechanics.core import link
from contourlab.components.plant.plant import MassDamper
from contourlab.engine.step import record
from contourlab.primitives import Clock

INPUTS = record(("command", "load"))


def march(plant, friction, state, command, duration, n):
    """Integrate in plain Python with n steps; return the final state and the trace of velocities."""
    step = link(plant, friction)
    dt = duration / n
    par = step.par_type(**plant.block(dt), **friction.block(dt))
    names = record(tuple(port.name for port in step.states))
    x = names(*state)
    velocities = [x.velocity]
    for k in range(n):
        push = command(k * dt) if callable(command) else command
        x_next, _ = step.function(par, x, INPUTS(push, 0.0), Clock(float(k), k * dt, dt))
        x = names(*x_next)
        velocities.append(x.velocity)
    return x, np.array(velocities)


def fitted_order(errors, factor=2.0):
    return np.mean([math.log(a / b) / math.log(factor) for a, b in pairwise(errors)])


def test_viscous_motion_is_of_fourth_order():
    plant = MassDamper(mass=2.0, damping=8.0, force_constant=1.0)
    exact = 0.5 * math.exp(-4.0 * 1.0) + (3.0 / 8.0) * (1.0 - math.exp(-4.0))
    errors = [abs(march(plant, NoFriction(), (0.0, 0.5), 3.0, 1.0, n)[0].velocity - exact) for n in (20, 40, 80)]
    assert 3.8 < fitted_order(errors) < 4.3


def test_sliding_to_rest_is_of_fourth_order_and_holds():
    mass, damping, coulomb, v0 = 2.0, 5.0, 3.0, 0.7
    plant, friction = MassDamper(mass=mass, damping=damping, force_constant=1.0), Coulomb(coulomb=coulomb)
    stop = mass / damping * math.log(1.0 + damping * v0 / coulomb)
    exact = mass / damping * (v0 + coulomb / damping) * (1.0 - math.exp(-damping * stop / mass)) - coulomb / damping * stop
    errors = []
    # The steps do not divide the stopping time, so each run has to locate the reversal.
    for n in (37, 73, 147, 293):
        end, velocities = march(plant, friction, (0.0, v0), 0.0, 0.53, n)
        assert end.velocity == 0.0
        assert np.all(velocities >= 0.0)
        errors.append(abs(end.position - exact))
    assert errors[-1] < 1e-8
    assert fitted_order(errors) > 3.0


def test_reversal_through_friction_matches_events():
    """Push against the motion until the axis turns: sliding, reversal, sliding the other way, all within coarse steps."""
    plant, friction = MassDamper(mass=1.0, damping=0.5, force_constant=1.0), Coulomb(coulomb=1.0, breakaway=1.0)
    push, v0, end_time = -2.5, 0.8, 0.6

    def way(sign):
        return lambda t, y: [y[1], push - sign * 1.0 - 0.5 * y[1]]

    def turn(t, y):
        return y[1]

    turn.terminal = True
    forward = solve_ivp(way(1.0), (0.0, end_time), [0.0, v0], events=turn, rtol=1e-12, atol=1e-14)
    back = solve_ivp(way(-1.0), (forward.t[-1], end_time), [forward.y[0, -1], 0.0], rtol=1e-12, atol=1e-14)
    errors = []
    for n in (13, 29, 61, 127):
        x, _ = march(plant, friction, (0.0, v0), push, end_time, n)
        errors.append(abs(x.position - back.y[0, -1]) + abs(x.velocity - back.y[1, -1]))
    assert errors[-1] < 1e-8
    assert fitted_order(errors) > 3.0


def test_lugre_agrees_with_a_stiff_solver_to_second_order():
    plant = MassDamper(mass=1.0, force_constant=1.0)
    friction = LuGre(coulomb=1.0, breakaway=1.5, stribeck_velocity=0.01, stiffness=1e5, bristle_damping=300.0, viscous=0.4)

    def slope(t, y):
        _, v, z = y
        g = 1.0 + 0.5 * math.exp(-((v / 0.01) ** 2))
        dz = v - 1e5 * abs(v) * z / g
        return [v, 2.0 - (1e5 * z + 300.0 * dz + 0.4 * v), dz]

    exact = solve_ivp(slope, (0.0, 0.2), [0.0, 0.0, 0.0], method="Radau", rtol=1e-11, atol=1e-14).y[:, -1]
    errors = []
    for n in (800, 1600, 3200, 6400):
        x, _ = march(plant, friction, (0.0, 0.0, 0.0), 2.0, 0.2, n)
        errors.append(abs(x.velocity - exact[1]))
    assert errors[-1] < 1e-5
    assert fitted_order(errors[1:]) > 1.6


def test_lugre_is_stable_at_a_servo_period_far_above_its_own_time():
    """Bristles of 1e8 N/m at 1 ms: an explicit method would need steps of a microsecond."""
    plant, friction = (
        MassDamper(mass=10.0, force_constant=1.0),
        LuGre(coulomb=5.0, breakaway=6.0, stiffness=1e8, bristle_damping=1e3),
    )
    _, velocities = march(plant, friction, (0.0, 0.0, 0.0), lambda t: 8.0 * math.sin(20.0 * t), 2.0, 2000)
    assert np.isfinite(velocities).all()
    assert np.abs(velocities).max() < 8.0 / 10.0 / 20.0 * 2.0
