"""Five machines, each simulated from its equations by numpy and scipy alone, against `simulate`.

Reference, controller and plant are written here anew, from the papers and the components' docstrings. The plants move under a held command
by a solver of high order that stops at each reversal, release and contact.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from two_mass_reference import Reference

import contourlab as cl
from contourlab.components.contract import Component
from contourlab.components.controller.cascade import Cascade
from contourlab.components.controller.pid import PID
from contourlab.components.controller.position import PositionController
from contourlab.components.coupling.laws import ModifiedReference
from contourlab.components.disturbance.loads import ForceRipple
from contourlab.components.drive.saturation import DelayedSaturation, Saturation
from contourlab.components.estimator.local import OsculatingCircle
from contourlab.components.friction.laws import Coulomb
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.components.plant.lagged_mass import LinearMotor
from contourlab.components.plant.plant import MassDamper, RigidAxis
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.components.sensor.encoder import Encoder
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.feed import uniform
from contourlab.loop import Axis, AxisController, Controller, Machine, simulate

Array = NDArray[np.float64]
T, RADIUS, FREQUENCY = 1e-3, 0.01, 2.0
CLOSE, ORDER = 1e-8, (3.8, 4.3)
"""Difference over the signal's range where the plant moves without error; order of the others."""
SUBSTEPS = (4, 8)


def circle(k: int) -> tuple[Array, Array, Array]:
    """Return position, velocity and acceleration of the reference at a tick."""
    w = 2.0 * math.pi * FREQUENCY
    turn = np.array([math.cos(w * k * T), math.sin(w * k * T)])
    return RADIUS * turn, RADIUS * w * np.array([-turn[1], turn[0]]), -RADIUS * w * w * turn


def ours(axis: dict[str, Any], controller: dict[str, Component], **coupling: Component) -> dict[str, Array]:
    """Return the signals of two equal axes on the circle."""
    path = cl.contour("circle", radius=RADIUS)
    machine = Machine("machine", tuple(Axis(name, **axis) for name in "xy"), T)
    axes = {name: AxisController(**controller) for name in "xy"}  # type: ignore[arg-type]
    result = simulate(machine, Controller(axes, **coupling), uniform(path, FREQUENCY, 1, T))  # type: ignore[arg-type]
    return {name: np.asarray(result[name]) for name in result.signals}


def off(signals: dict[str, Array], names: str, theirs: list[tuple[float, ...]], axis: int = 0) -> Array:
    """Return the largest difference of each signal over its range."""
    values = np.array(theirs)
    mine = np.column_stack([signals[name][: len(values), axis] for name in names.split()])
    return np.asarray(np.abs(mine - values).max(axis=0) / np.ptp(values, axis=0))


def check_order_four(errors: list[Array]) -> None:
    """Check the errors of the signals, the last at half the step of the one before."""
    assert (errors[-1] < CLOSE).all()
    orders = np.log2(errors[-2] / errors[-1])
    assert (ORDER[0] < orders).all() and (orders < ORDER[1]).all(), orders


def carry(
    y: Array,
    flow: Callable[[Array, float], list[float]],
    net: Callable[[Array], float],
    held: float = 0.0,
    sliding: Callable[[float], float] | None = None,
) -> Array:
    """Return the state (position, velocity, ...) a period later.

    `flow` gives the rates for an acceleration, `net` the acceleration without friction; friction holds up to `held` at rest.
    """
    left, loose = T, 0.0
    while left > 1e-15:
        push = net(y)
        way = float(np.sign(y[1])) or loose or (0.0 if abs(push) <= held else float(np.sign(push)))

        def rates(_: float, z: Array, way: float = way) -> list[float]:
            if sliding is None:
                return flow(z, net(z))
            return flow(z, net(z) - way * sliding(way * z[1]) if way else 0.0)

        def guard(_: float, z: Array, way: float = way) -> float:
            return way * z[1] if way else held - abs(net(z))

        guard.terminal, guard.direction = True, -1.0  # type: ignore[attr-defined]
        events = None if sliding is None else guard
        run = solve_ivp(rates, (0.0, left), y, method="DOP853", rtol=1e-13, atol=1e-16, events=events)
        left, y, loose = left - float(run.t[-1]), run.y[:, -1].copy(), 0.0
        if run.status == 1 and way:
            y[1] = 0.0
        elif run.status == 1:
            loose = float(np.sign(net(y)))
    return y


# --- a cascade, and friction that sticks ----------------------------------------------------------------------------------------------

MASS, DAMPING, FORCE = 10.0, 60.0, 50.0
SLIDING, HELD, STRIBECK, VISCOUS = 16.0, 25.0, 5e-3, 30.0
GAINS = {"position_gain": 40.0, "velocity_gain": 60.0, "integral_time": 0.02, "velocity_feedforward": 0.8, "acceleration_feedforward": 0.3}
LIMIT = 0.8


def cascade(y: Callable[[], tuple[float, float]], limit: float, axis: int = 0) -> Iterator[tuple[float, float]]:
    """Yield tick by tick the command and what the drive accepts of it, for a position and velocity."""
    integral = command = applied = 0.0
    for k in range(10**6):
        (r, rv, ra), (p, v) = (float(one[axis]) for one in circle(k)), y()
        error = GAINS["position_gain"] * (r - p) + GAINS["velocity_feedforward"] * rv - v
        rise = T * GAINS["velocity_gain"] / GAINS["integral_time"] * error
        integral += 0.0 if rise * (command - applied) > 0.0 else rise
        command = GAINS["velocity_gain"] * error + integral + GAINS["acceleration_feedforward"] * ra
        applied = min(max(command, -limit), limit)
        yield command, applied


def test_a_cascade_on_an_axis_that_sticks() -> None:
    def sliding(w: float) -> float:
        return (SLIDING + (HELD - SLIDING) * math.exp(-((w / STRIBECK) ** 2)) + VISCOUS * w) / MASS

    y, rows = np.array([RADIUS, 0.0]), []
    law = cascade(lambda: (y[0], y[1]), LIMIT)
    for _ in range(300):
        command, applied = next(law)
        rows.append((y[0], y[1], command, applied))
        y = carry(y, lambda z, a: [z[1], a], lambda z, u=applied: (FORCE * u - DAMPING * z[1]) / MASS, HELD / MASS, sliding)
    values = np.array(rows)
    assert np.count_nonzero(values[:, 1] == 0.0) > 5  # it sticks
    assert np.count_nonzero(values[:, 2] != values[:, 3]) > 2  # the drive limits
    friction = Coulomb(coulomb=SLIDING, breakaway=HELD, stribeck_velocity=STRIBECK, viscous=VISCOUS)
    plant, drive = MassDamper(mass=MASS, damping=DAMPING, force_constant=FORCE), Saturation(limit=LIMIT)
    errors = []
    for substeps in SUBSTEPS:
        signals = ours({"plant": plant, "friction": friction, "drive": drive, "substeps": substeps}, {"controller": Cascade(**GAINS)})
        errors.append(off(signals, "axis_position axis_velocity command applied_command", rows))
    check_order_four(errors)


# --- an observer and a modified reference on a circle ---------------------------------------------------------------------------------


def test_an_observer_and_a_modified_reference_on_a_circle() -> None:
    a, b, kv, kp, ki, weight = 1.7, 10.0, 60.0, 3000.0, 10.0, 0.75
    wd, wz, model_a, model_b, wv = 150.0, 1500.0, 1.5, 12.0, 800.0
    early = {w: w * T / (1.0 + w * T) for w in (wd, wz, wv)}  # backward Euler
    y = np.array([[RADIUS, 0.0], [0.0, 0.0]])
    last, v, filtered, estimate, integral, u, rows = y[:, 0].copy(), np.zeros(2), np.zeros(2), np.zeros(2), np.zeros(2), np.zeros(2), []
    for k in range(300):
        r, rv, ra = circle(k)
        p = y[:, 0]
        v = v + early[wv] * ((p - last) / T - v)
        last = p.copy()
        modified = (1.0 - weight) * r + weight * RADIUS * p / np.linalg.norm(p)
        filtered = filtered + early[wz] * (v - filtered)
        estimate = estimate + early[wd] * ((wz * (v - filtered) + model_b * v) / model_a - u - estimate)
        integral = integral + T * (modified - p)
        u = kv * (rv - v) + kp * (modified - p) + kp * ki * integral + (ra + model_b * rv) / model_a - estimate
        rows.append((*p, *modified, *estimate, *u))
        y = np.array([carry(z, lambda s, acc: [s[1], acc], lambda s, f=f: a * f - b * s[1]) for z, f in zip(y, u.tolist(), strict=True)])
    observer = DisturbanceObserver(bandwidth=wd, filter_bandwidth=wz, model_gain=model_a, model_damping=model_b)
    law = PositionController(velocity_gain=kv, position_gain=kp, integral_gain=ki, model_gain=model_a, model_damping=model_b)
    parts = {"controller": law, "observer": observer, "velocity": FilteredDifference(bandwidth=wv)}
    coupling = {"estimator": OsculatingCircle(), "coupling": ModifiedReference(weight=weight)}
    signals = ours({"plant": RigidAxis(gain=a, damping=b)}, parts, **coupling)
    values = np.array(rows)
    for axis in (0, 1):
        mine = [tuple(row) for row in values[:, axis::2].tolist()]
        errors = off(signals, "axis_position modified_reference disturbance_estimate command", mine, axis)
        assert (errors < CLOSE).all()


# --- two masses with play -------------------------------------------------------------------------------------------------------------


def test_two_masses_with_play() -> None:
    turn = 2.0 * math.pi / 0.016
    motor, load, shaft, damper, gap = 5.2e-3, 4.4e-3, 950.0, 0.3, 25e-6
    masses, rubbing = (motor * turn**2, load * turn**2), (60.0, 40.0)
    there = Reference(*masses, shaft * turn**2, damper * turn**2, 0.5 * gap, 0.0, True, rubbing, rubbing)
    y, side, sides, rows = np.array([RADIUS, 0.0, RADIUS, 0.0, 0.0]), 0, list[int](), []
    gains, integral = GAINS | {"velocity_gain": 300.0, "acceleration_feedforward": 3.0}, 0.0
    for k in range(250):
        r, rv, ra = (float(one[0]) for one in circle(k))
        error = gains["position_gain"] * (r - y[0]) + gains["velocity_feedforward"] * rv - y[1]
        integral += T * gains["velocity_gain"] / gains["integral_time"] * error
        command = gains["velocity_gain"] * error + integral + gains["acceleration_feedforward"] * ra
        rows.append((*y[:4].tolist(), command))
        sides.append(side)
        y, side = there.hold(y, side, turn * command, T)
    assert np.count_nonzero(np.diff(sides)) > 3
    plant = TwoInertia(motor_inertia=motor, load_inertia=load, lead=0.016, stiffness=shaft, shaft_damping=damper, backlash_gap=gap)
    parts = {
        "friction": Coulomb(coulomb=rubbing[1], breakaway=rubbing[1]),
        "motor_friction": Coulomb(coulomb=rubbing[0], breakaway=rubbing[0]),
    }
    names, errors = "motor_position motor_velocity axis_position axis_velocity command", []
    for substeps in SUBSTEPS:
        law = {"controller": Cascade(**gains), "feedback": "motor", "velocity_feedback": "motor"}
        signals = ours({"plant": plant, "substeps": 2 * substeps, **parts}, law)
        assert np.array_equal(signals["gap_state"][: len(rows), 0], sides)
        errors.append(off(signals, names, rows))
    check_order_four(errors)


# --- delay, a quantised encoder and a PID -----------------------------------------------------------------------------------------------


def test_a_delay_a_quantised_encoder_and_a_pid() -> None:
    p_gain, i_gain, d_gain, n, weight, count, limit, whole, part = 900.0, 8000.0, 25.0, 900.0, 0.8, 1e-6, 0.3, 2, 0.3
    y, rows, past = np.array([RADIUS, 0.0]), [], [0.0] * 8
    integral, slope, before, command = 0.0, 0.0, -RADIUS, 0.0
    for k in range(400):
        r = float(circle(k)[0][0])
        seen = count * round(y[0] / count)
        rise = T * i_gain * (r - seen)
        integral += 0.0 if rise * (command - past[-1]) > 0.0 else rise
        slope += n * T / (1.0 + n * T) * ((-seen - before) / T - slope)
        before = -seen
        command = p_gain * (weight * (r - RADIUS) - (seen - RADIUS)) + integral + d_gain * slope
        past.append(min(max(command, -limit), limit))
        applied = (1.0 - part) * past[-1 - whole] + part * past[-2 - whole]
        rows.append((y[0], y[1], seen, command, applied))
        y = carry(y, lambda z, a: [z[1], a], lambda z, u=applied: (FORCE * u - DAMPING * z[1]) / MASS)
    values = np.array(rows)
    assert np.count_nonzero(np.abs(values[:, 3]) > limit) > 50
    plant = MassDamper(mass=MASS, damping=DAMPING, force_constant=FORCE)
    drive = DelayedSaturation(limit=limit, delay=(whole + part) * T)
    law = PID(
        proportional_gain=p_gain,
        integral_gain=i_gain,
        derivative_gain=d_gain,
        derivative_bandwidth=n,
        derivative_on="measurement",
        reference_weight=weight,
    )
    signals = ours({"plant": plant, "drive": drive, "sensor": Encoder(resolution=count)}, {"controller": law})
    errors = off(signals, "axis_position axis_velocity position command applied_command", rows)
    assert (errors < CLOSE).all()


# --- a linear motor with ripple, whose current lags -------------------------------------------------------------------------------------


def test_a_linear_motor_with_ripple_and_a_lagged_drive() -> None:
    ohm, henry, emf, force, mass, rubs, amp = 2.5, 4e-3, 18.0, 21.0, 2.2, 12.0, 3.0
    pitch, sizes, phases, sliding, limit = 0.003, (1.2, 0.5), (0.3, -1.0), 6.0, 4.0
    y, rows = np.array([RADIUS, 0.0, 0.0]), []
    law = cascade(lambda: (y[0], y[1]), limit)
    for _ in range(300):
        command, applied = next(law)
        rows.append((y[0], y[1], command, applied))
        wave = 2.0 * math.pi * y[0] / pitch
        ripple = sum(size * math.sin((k + 1) * wave + phase) for k, (size, phase) in enumerate(zip(sizes, phases, strict=True)))

        def flow(z: Array, a: float, u: float = applied) -> list[float]:
            return [z[1], a, (amp * u - ohm * z[2] - emf * z[1]) / henry]

        def net(z: Array, ripple: float = ripple) -> float:
            return float(force * z[2] - rubs * z[1] + ripple) / mass

        y = carry(y, flow, net, sliding / mass, lambda w: sliding / mass)
    assert np.count_nonzero(np.array(rows)[:, 1] == 0.0) > 3
    plant = LinearMotor(
        resistance=ohm, inductance=henry, back_emf=emf, force_constant=force, mass=mass, viscous_friction=rubs, amplifier_gain=amp
    )
    ripples = ForceRipple(pitch=pitch, amplitudes=sizes, phases=phases)
    axis = {"plant": plant, "friction": Coulomb(coulomb=sliding), "drive": Saturation(limit=limit), "disturbance": ripples}
    for substeps in (1, 8):
        signals = ours({**axis, "substeps": substeps}, {"controller": Cascade(**GAINS)})
        errors = off(signals, "axis_position axis_velocity command applied_command", rows)
        assert (errors < CLOSE).all()
