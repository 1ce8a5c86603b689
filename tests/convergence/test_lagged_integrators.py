"""Order and robustness of the integration of plants whose force lags, against closed forms and an independent solver."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from contourlab.components.contract import Component
from contourlab.components.friction.laws import Coulomb, LuGre, NoFriction, SmoothCoulomb
from contourlab.components.mechanics.core import link
from contourlab.components.mechanics.propagator import STIFFEST, propagator
from contourlab.components.plant.lagged_mass import LinearMotor
from contourlab.engine.step import record
from contourlab.primitives import Clock

Array = NDArray[np.float64]
INPUTS = record(("command", "load"))
MASS, VISCOUS = 2.0, 5.0
NONE = NoFriction()


def motor(rate: float = 60.0, back_emf: float = 8.0, viscous: float = VISCOUS) -> LinearMotor:
    """Return a motor of R = 2 ohm, K_f = 10 N/A whose current follows with a rate R/L."""
    return LinearMotor(resistance=2.0, inductance=2.0 / rate, back_emf=back_emf, force_constant=10.0, mass=MASS, viscous_friction=viscous)


def march(plant: Component, friction: Component, start: tuple[float, ...], command: float, duration: float, n: int) -> Array:
    """Return the states (n + 1, n_state) over n steps in plain Python."""
    step, dt = link(plant, friction), duration / n
    par = step.par_type(**plant.block(dt), **friction.block(dt))
    names = record(tuple(port.name for port in step.states))
    x, seen = names(*start), [start]
    for k in range(n):
        x = names(*step.function(par, x, INPUTS(command, 0.0), Clock(float(k), k * dt, dt))[0])
        seen.append(tuple(x))
    return np.array(seen)


def slope(plant: LinearMotor, command: float, friction: Any) -> Any:
    """Return the right side of eqs (1) and (2) in position, velocity and current, with a friction force of velocity."""

    def right_side(t: float, y: Array) -> list[float]:
        _, v, i = y
        current = (plant.amplifier_gain * command - plant.resistance * i - plant.back_emf * v) / plant.inductance
        return [v, (plant.force_constant * i - plant.viscous_friction * v - friction(v)) / plant.mass, current]

    return right_side


def solved(plant: LinearMotor, command: float, friction: Any, start: Array, duration: float) -> Array:
    method: Any = "Radau" if plant.resistance > 1e5 * plant.inductance else "DOP853"  # the quick one, where the lag is not stiff
    found = solve_ivp(slope(plant, command, friction), (0.0, duration), start, method=method, rtol=1e-11, atol=1e-14)
    return np.asarray(found.y[:, -1]) * (1.0, 1.0, plant.force_constant)


def orders(errors: list[float]) -> list[float]:
    return [math.log2(a / b) for a, b in pairwise(errors)]


@given(
    decay=st.floats(0.0, 100.0),
    mobility=st.floats(0.01, 10.0),
    rate=st.floats(0.1, 1e5),
    back=st.floats(0.0, 1e5),
    h=st.floats(1e-7, 0.01),
)
def test_the_propagator_is_the_matrix_exponential(decay: float, mobility: float, rate: float, back: float, h: float) -> None:
    """The columns of exp of the matrix bordered by a chain of ones are phi_0 to phi_4: Al-Mohy & Higham 2011, theorem 2.1."""
    whole = np.zeros((6, 6))
    # Scale the force so that both couplings are equal: expm is then well conditioned.
    unit = math.sqrt(max(back, 1e-6) / mobility)
    whole[:2, :2] = h * np.array([[-decay, mobility * unit], [-back / unit, -rate]])
    whole[0, 2] = whole[2, 3] = whole[3, 4] = whole[4, 5] = 1.0
    found, exact = propagator(decay, rate, decay * rate + mobility * back, h, 12), expm(whole)
    # scipy's expm is the less exact of the two: at a stiffness of 9 it is 9e-14 from the series summed with 60 digits, this one 6e-16.
    tolerance = 3e-14 * (1.0 + h * (decay + rate + math.sqrt(mobility * back)))
    assert np.array(found[:5]) == pytest.approx(np.r_[exact[0, 0], exact[0, 2:]], abs=tolerance)
    assert mobility * unit * found[5] == pytest.approx(exact[0, 1], abs=tolerance)
    assert found[10] == pytest.approx(exact[1, 1], abs=tolerance)


@pytest.mark.parametrize("rate", [60.0, 1e4, 1e6])
def test_without_friction_a_step_of_any_length_is_exact(rate: float) -> None:
    """1e4 1/s at 1 ms, and a hundred times stiffer: no sub-steps."""
    plant = motor(rate)
    exact = solved(plant, 3.0, lambda v: 0.0, np.array([0.1, -0.2, 1.5]), 0.05)
    for n in (1, 5, 50):
        if rate * 0.05 / n <= STIFFEST:
            end = march(plant, NONE, (0.1, -0.2, 15.0), 3.0, 0.05, n)[-1]
            assert end == pytest.approx(exact, rel=1e-9, abs=1e-10)


@pytest.mark.parametrize(("rate", "coarsest"), [(60.0, 40), (1e4, 10)])
def test_a_smooth_friction_is_of_fourth_order(rate: float, coarsest: int) -> None:
    plant = motor(rate)
    friction = SmoothCoulomb(coulomb=2.0, breakaway=3.0, stribeck_velocity=0.3, smoothing_velocity=0.15)
    par = friction.constants()
    # Start on the slow motion, where a stiff lag has no transient.
    start = (0.0, 0.4, (10.0 * 1.0 - 10.0 * 8.0 * 0.4) / 2.0)
    exact = solved(plant, 1.0, lambda v: SmoothCoulomb.force(par, v), np.array([0.0, 0.4, start[2] / 10.0]), 0.4)
    errors = []
    for n in (coarsest, 2 * coarsest, 4 * coarsest, 8 * coarsest):
        errors.append(float(np.abs(march(plant, friction, start, 1.0, 0.4, n)[-1] - exact)[:2].sum()))
    assert np.mean(orders(errors)) > 3.8
    assert errors[0] < 1e-6


def test_the_error_of_a_stiff_lag_stays_small_where_its_transient_is_not_resolved() -> None:
    """The command jumps. At R/L = 1e4 1/s, ten time constants fit into a servo period of 1 ms."""
    plant = motor(1e4)
    friction = SmoothCoulomb(coulomb=2.0, breakaway=3.0, stribeck_velocity=0.3, smoothing_velocity=0.15)
    par = friction.constants()
    exact = solved(plant, 5.0, lambda v: SmoothCoulomb.force(par, v), np.zeros(3), 0.02)
    end = march(plant, friction, (0.0, 0.0, 0.0), 5.0, 0.02, 20)[-1]
    assert np.abs(end - exact)[:2] == pytest.approx([0.0, 0.0], abs=1e-6)


def reversal(plant: LinearMotor, command: float, coulomb: float, start: Array, duration: float) -> Array:
    """Slide, turn and slide the other way, or rest until the force is enough: from the events of an independent solver."""

    def stopped(t: float, y: Array) -> float:
        return float(y[1])

    stopped.terminal = True  # type: ignore[attr-defined]
    way = math.copysign(1.0, start[1])
    options: Any = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-15}  # none of these motors is stiff
    first = solve_ivp(slope(plant, command, lambda v: way * coulomb), (0.0, duration), start, events=stopped, **options)
    at, y = first.t[-1], first.y[:, -1].copy()
    y[1] = 0.0
    # At rest the current goes to e/R on an exponential.
    level, rate = plant.amplifier_gain * command / plant.resistance, plant.resistance / plant.inductance
    edge = math.copysign(coulomb, level) / plant.force_constant
    if abs(y[2]) * plant.force_constant <= coulomb:
        wait = math.log((level - y[2]) / (level - edge)) / rate if abs(level) > abs(edge) else math.inf
        if at + wait >= duration:
            return np.array([y[0], 0.0, plant.force_constant * (level + (y[2] - level) * math.exp(-rate * (duration - at)))])
        at, y[2] = at + wait, edge
    way = math.copysign(1.0, y[2])
    last = solve_ivp(slope(plant, command, lambda v: way * coulomb), (at, duration), y, **options)
    return np.asarray(last.y[:, -1]) * (1.0, 1.0, plant.force_constant)


CASES = [
    (0.0, 3.0, (0.0, 0.5, 1.0)),  # slides to rest and stays
    (-2.5, 1.0, (0.0, 0.5, 1.0)),  # turns at once
    (3.0, 6.0, (0.0, -0.2, -8.0)),  # stops, is held while the force changes its sign, and breaks away
]
# The steps do not hit the instants, so each run has to locate them.
UNEVEN = (37, 73, 147, 293)


@pytest.mark.slow
@pytest.mark.parametrize(("command", "coulomb", "start"), CASES)
@pytest.mark.parametrize("rate", [60.0, 1000.0])
def test_stops_reversals_and_breaking_away_are_exact_where_sliding_is_linear(
    rate: float, command: float, coulomb: float, start: tuple[float, float, float]
) -> None:
    plant, friction = motor(rate), Coulomb(coulomb=coulomb)
    exact = reversal(plant, command, coulomb, np.array(start) / (1.0, 1.0, 10.0), 0.3)
    for n in UNEVEN:
        end = march(plant, friction, start, command, 0.3, n)[-1]
        assert end[:2] == pytest.approx(exact[:2], abs=1e-11)


@pytest.mark.parametrize(("command", "coulomb", "start"), CASES)
@pytest.mark.parametrize("rate", [60.0, 200.0])
def test_stops_reversals_and_breaking_away_are_of_high_order(
    rate: float, command: float, coulomb: float, start: tuple[float, float, float]
) -> None:
    """Viscous damping is part of the friction for the method, and part of the plant in the solution, where it is exact."""
    exact = reversal(motor(rate), command, coulomb, np.array(start) / (1.0, 1.0, 10.0), 0.3)
    plant, friction = motor(rate, viscous=0.0), Coulomb(coulomb=coulomb, viscous=VISCOUS)
    errors = [float(np.abs(march(plant, friction, start, command, 0.3, n)[-1] - exact)[:2].sum()) for n in UNEVEN]
    assert errors[-1] < 1e-7
    assert np.mean(orders(errors)) > 3.0


def test_the_force_changes_while_the_axis_is_held() -> None:
    plant, friction = motor(60.0), Coulomb(coulomb=1.0, breakaway=1.5)
    states = march(plant, friction, (0.25, 0.0, -1.2), 0.29, 0.5, 500)
    assert set(states[:, 0]) == {0.25}
    assert not states[:, 1].any()
    t = np.linspace(0.0, 0.5, 501)
    assert states[:, 2] == pytest.approx(1.45 + (-1.2 - 1.45) * np.exp(-60.0 * t), rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("n", [3, 7, 20])
def test_breaking_away_within_a_step_happens_at_its_instant(n: int) -> None:
    """f = 10 (1 - exp(-60 t)) passes 6 at t = ln(2.5)/60; from there the linear motion goes on with 6 - F_c as its push."""
    plant, friction = motor(60.0, back_emf=0.0, viscous=0.0), Coulomb(coulomb=6.0)
    instant, duration = math.log(2.5) / 60.0, 0.04
    s = duration - instant
    # m v' = f - 6 with f = 10 - 4 exp(-60 s): integrated by hand.
    speed = (4.0 * s - 4.0 / 60.0 * (1.0 - math.exp(-60.0 * s))) / MASS
    way = (2.0 * s * s - 4.0 / 60.0 * (s - (1.0 - math.exp(-60.0 * s)) / 60.0)) / MASS
    end = march(plant, friction, (0.0, 0.0, 0.0), 2.0, duration, n)[-1]
    assert end[:2] == pytest.approx([way, speed], rel=1e-10)


@pytest.mark.parametrize("rate", [60.0, 1e3, 1e4])
def test_bristles_are_of_second_order(rate: float) -> None:
    plant = motor(rate)
    friction = LuGre(coulomb=1.0, breakaway=1.5, stribeck_velocity=0.01, stiffness=1e5, bristle_damping=30.0, viscous=0.4)

    def right_side(t: float, y: Array) -> list[float]:
        p, v, i, z = y
        g = 1.0 + 0.5 * math.exp(-((v / 0.01) ** 2))
        dz = v - 1e5 * abs(v) * z / g
        force = 1e5 * z + 30.0 * dz + 0.4 * v
        return [*slope(plant, 1.0, lambda v: force)(t, np.array([p, v, i])), dz]

    exact = solve_ivp(right_side, (0.0, 0.1), np.zeros(4), method="DOP853", rtol=1e-12, atol=1e-15).y[:, -1]
    errors = [float(abs(march(plant, friction, (0.0,) * 4, 1.0, 0.1, n)[-1][1] - exact[1])) for n in (400, 800, 1600, 3200)]
    assert errors[0] < 1e-6
    assert 1.9 < np.mean(orders(errors)[1:]) < 2.2


@pytest.mark.parametrize("back_emf", [0.0, 1.0, 300.0])
def test_friction_is_stable_up_to_the_runge_kutta_bound_at_any_lag(back_emf: float) -> None:
    """Friction slope times step over mass may reach 2.78, the bound that a machine checks; with a slow lag it may go no further."""
    growth = {}
    for slope_of in (0.5, 2.78, 2.9):
        friction = SmoothCoulomb(coulomb=0.0, breakaway=0.0, viscous=slope_of * MASS / 1e-3)
        found = []
        for rate in (0.1, 60.0, 1e4, 9e5):
            step = link(motor(rate, back_emf, 0.0), friction)
            par = step.par_type(**motor(rate, back_emf, 0.0).block(1e-3), **friction.block(1e-3))
            names = record(tuple(port.name for port in step.states))
            columns = [step.function(par, names(*unit), INPUTS(0.0, 0.0), Clock(0.0, 0.0, 1e-3))[0] for unit in np.eye(3)]
            found.append(float(np.abs(np.linalg.eigvals(np.column_stack(columns)[1:, 1:])).max()))
        growth[slope_of] = max(found)
    assert growth[0.5] < 1.0 and growth[2.78] < 1.0 < growth[2.9]


# --- energy --------------------------------------------------------------------------------------------------------------------------

FORCES = st.floats(0.01, 50.0)
STICKING = st.builds(Coulomb, coulomb=FORCES, breakaway=FORCES, stribeck_velocity=st.floats(1e-5, 0.1), viscous=st.floats(0.0, 20.0))
MOTORS = st.builds(motor, rate=st.floats(5.0, 2e4), back_emf=st.floats(0.1, 100.0), viscous=st.floats(0.0, 50.0))


def energy(plant: LinearMotor, states: Array) -> Array:
    """Return m v^2/2 + L i^2/2 (K_f/K_b), the energy of the mass and of the winding as seen from it; it falls without a voltage."""
    _, _, _, _, back = plant.rates(plant)
    return np.asarray(0.5 * plant.mass * states[:, 1] ** 2 + 0.5 * states[:, 2] ** 2 / back)


@settings(max_examples=60)
@given(plant=MOTORS, friction=STICKING, speed=st.floats(-1.0, 1.0), force=st.floats(-100.0, 100.0), period=st.floats(1e-4, 5e-3))
def test_a_sticking_friction_never_feeds_energy_and_rest_is_exact(
    plant: LinearMotor, friction: Coulomb, speed: float, force: float, period: float
) -> None:
    """Across reversals, holds and breaking away, at any stiffness, with a drop from F_s to F_c that a step resolves."""
    largest = max(friction.coulomb, friction.breakaway) + abs(force) + 1.0
    friction = friction.replace(stribeck_velocity=max(friction.stribeck_velocity, 5.0 * largest / MASS * period))
    states = march(plant, friction, (0.0, speed, force), 0.0, 120 * period, 120)
    held = energy(plant, states)
    assert (np.diff(held) <= 1e-6 * held.max() + 1e-30).all()
    resting = (states[:-1, 1] == 0.0) & (np.abs(states[:-1, 2]) <= max(friction.coulomb, friction.breakaway))
    assert not states[1:, 1][resting].any()
    assert (states[1:, 0] == states[:-1, 0])[resting].all()


@settings(max_examples=40)
@given(plant=MOTORS, speed=st.floats(-1.0, 1.0), share=st.floats(0.01, 1.0))
def test_a_smooth_friction_never_feeds_energy_where_it_is_resolved(plant: LinearMotor, speed: float, share: float) -> None:
    friction = SmoothCoulomb(coulomb=2.0, breakaway=3.0, stribeck_velocity=0.02, smoothing_velocity=0.01)
    period = share * MASS / (3.0 / 0.01 + 3.0 / 0.02)
    held = energy(plant, march(plant, friction, (0.0, speed, 5.0), 0.0, 100 * period, 100))
    assert (np.diff(held) <= 1e-9 * held[0]).all()


@settings(max_examples=40)
@given(
    plant=MOTORS,
    stiffness=st.floats(1e3, 1e7),
    speed=st.floats(0.01, 1.0),
    period=st.floats(1e-5, 5e-3),
)
def test_bristles_never_feed_energy_at_any_step(plant: LinearMotor, stiffness: float, speed: float, period: float) -> None:
    """As for a plain mass: dE/dt <= 0 wherever s1 |v| <= 4 g, a bound that s1 is held to here."""
    friction = LuGre(coulomb=2.0, breakaway=3.0, stiffness=stiffness, stribeck_velocity=0.05, bristle_damping=min(300.0, 4.0 * 2.0 / speed))
    states = march(plant, friction, (0.0, speed, 0.0, 0.0), 0.0, 100 * period, 100)
    held = energy(plant, states) + 0.5 * stiffness * states[:, 3] ** 2
    assert (np.diff(held) <= 1e-3 * held[0]).all()
    assert held[-1] < held[0]
