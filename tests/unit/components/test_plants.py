"""Plants against their closed-form solutions."""

from __future__ import annotations

import math

import numpy as np
import pytest
from component_rig import PERIOD, make, run_alone
from hypothesis import given
from hypothesis import strategies as st

N = 600
TIME = PERIOD * np.arange(1, N + 1)


def test_a_step_on_a_rigid_axis_is_an_exponential() -> None:
    a, b, u = 1.695, 10.1, 0.4
    out = run_alone(make("plant", "rigid-axis", gain=a, damping=b), {"command": np.full(N, u)})
    v = u * a / b * -np.expm1(-b * TIME)
    p = u * a / b * (TIME + np.expm1(-b * TIME) / b)
    # The classical Runge-Kutta method misses (b dt)^5/120 of exp(-b dt) per step; later terms are smaller by b dt each.
    left_out = (1.0 + b * PERIOD) * (b * PERIOD) ** 4 / 120.0
    assert np.abs(out["velocity"] / v - 1.0).max() < left_out
    # Position: b^3 dt^5/120 a u per step, and as much again from the velocity.
    assert (np.abs(out["position"] - p) <= 2.0 * left_out * u * a / b * TIME).all()
    assert out["velocity"][-1] == pytest.approx(u * a / b, rel=math.exp(-b * 0.6) * 1.01)


def test_four_substeps_reduce_the_error_256_times() -> None:
    plant = make("plant", "rigid-axis", gain=1.0, damping=200.0)
    v = 1.0 / 200.0 * -np.expm1(-200.0 * TIME)
    gaps = [np.abs(run_alone(plant, {"command": np.ones(N)}, substeps=n)["velocity"] / v - 1.0).max() for n in (1, 4)]
    assert 200.0 < gaps[0] / gaps[1] < 320.0


def test_a_damped_mass_under_drive_and_load() -> None:
    m, c, k, i, load = 20.0, 100.0, 60.0, 1.5, -25.0
    out = run_alone(make("plant", "mass-damper", mass=m, damping=c, force_constant=k), {"command": np.full(N, i), "load": np.full(N, load)})
    assert out["velocity"] == pytest.approx((k * i + load) / c * -np.expm1(-c / m * TIME), rel=1e-10)
    # The acceleration is the mean over the tick, so its sum gives the velocity.
    assert np.cumsum(out["acceleration"]) * PERIOD == pytest.approx(out["velocity"], rel=1e-12)


def test_carried_mass_is_mass() -> None:
    fed = {"command": np.sin(5.0 * TIME)}
    whole = run_alone(make("plant", "mass-damper", mass=32.0, damping=7.0, force_constant=60.0), fed)
    parts = run_alone(make("plant", "mass-damper", mass=12.0, carried_mass=20.0, damping=7.0, force_constant=60.0), fed)
    assert np.array_equal(whole["position"], parts["position"])


@pytest.mark.parametrize("carried", [0.0, 15.0])
def test_the_work_of_a_screw_goes_into_table_and_rotor(carried: float) -> None:
    """Without losses K_t i theta = (m v^2 + J omega^2)/2: an energy balance independent of the reflected inertia."""
    m, inertia, lead, torque, i = 40.0, 3e-3, 0.01, 0.6, 2.0
    screw = make("plant", "ball-screw", mass=m, carried_mass=carried, inertia=inertia, lead=lead, torque_constant=torque, efficiency=1.0)
    out = run_alone(screw, {"command": np.full(N, i)})
    turn = 2.0 * math.pi / lead
    stored = 0.5 * (m + carried) * out["velocity"] ** 2 + 0.5 * inertia * (turn * out["velocity"]) ** 2
    assert stored == pytest.approx(torque * i * turn * out["position"], rel=1e-11)
    # With these numbers most of it is in the rotor.
    assert inertia * turn**2 > 20.0 * (m + carried)


def test_a_screw_at_speed_gives_the_force_of_its_torque() -> None:
    """In steady motion motor power times efficiency goes into the damping: K_t i omega eta = c v^2."""
    lead, torque, i, eta, c = 0.02, 0.5, 3.0, 0.9, 2000.0
    screw = make("plant", "ball-screw", mass=10.0, inertia=1e-4, lead=lead, torque_constant=torque, efficiency=eta, damping=c)
    v = run_alone(screw, {"command": np.full(2000, i)})["velocity"][-1]
    assert torque * i * (2.0 * math.pi / lead * v) * eta == pytest.approx(c * v * v, rel=1e-10)


@given(mass=st.floats(0.5, 500.0), force=st.floats(-900.0, 900.0), start=st.floats(-0.5, 0.5))
def test_a_free_mass_under_constant_force_flies_a_parabola(mass: float, force: float, start: float) -> None:
    out = run_alone(
        make("plant", "mass-damper", mass=mass, force_constant=1.0), {"command": np.full(50, force)}, initial={"velocity": start}
    )
    t = TIME[:50]
    scale = abs(start) + abs(force / mass) * t
    assert (np.abs(out["velocity"] - (start + force / mass * t)) <= 1e-13 * scale + 1e-300).all()
    assert (np.abs(out["position"] - (start * t + 0.5 * force / mass * t * t)) <= 1e-13 * scale * t + 1e-300).all()


def test_command_and_load_have_the_same_effect() -> None:
    """On a normalised axis both are shares of full scale; on one in newtons the force constant converts the command."""
    wave = np.sin(9.0 * TIME)
    rigid, mass = make("plant", "rigid-axis", gain=2.0, damping=3.0), make("plant", "mass-damper", mass=4.0, force_constant=8.0)
    for plant, factor in ((rigid, 1.0), (mass, 8.0)):
        pushed, driven = run_alone(plant, {"load": factor * wave}), run_alone(plant, {"command": wave})
        assert np.array_equal(pushed["velocity"], driven["velocity"])
