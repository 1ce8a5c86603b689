"""Friction laws against closed forms: stopping, sticking, presliding and sliding."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from component_rig import make, run_alone
from hypothesis import given
from hypothesis import strategies as st

from contourlab.components.contract import Component


def mass_of(mass: float) -> Component:
    """Return a free mass whose command is its force."""
    return make("plant", "mass-damper", mass=mass, force_constant=1.0)  # type: ignore[no-any-return]


# --- sticking ------------------------------------------------------------------------------------------------------------------------


@given(
    mass=st.floats(0.5, 50.0),
    coulomb=st.floats(0.5, 50.0),
    speed=st.floats(1e-3, 1.0),
    period=st.floats(1e-4, 1e-2),
    way=st.sampled_from([-1.0, 1.0]),
)
def test_an_axis_stops_exactly_at_the_right_place_and_time(mass: float, coulomb: float, speed: float, period: float, way: float) -> None:
    """m v' = -F: it stops after m v0/F at m v0^2/(2 F), between two ticks."""
    stop, length = mass * speed / coulomb, 0.5 * mass * speed**2 / coulomb
    n = math.ceil(stop / period)
    if n > 300:
        period, n = stop / 17.3, 18
    fed = {"command": np.zeros(n + 5)}
    friction = make("friction", "coulomb", coulomb=coulomb)
    out = run_alone(mass_of(mass), fed, friction=friction, initial={"velocity": way * speed}, period=period)
    # The tick is certain only if the stop does not fall on it.
    moving = n - 1 if abs(stop / period - round(stop / period)) > 1e-9 else max(n - 2, 0)
    assert (way * out["velocity"][:moving] > 0.0).all()
    assert not out["velocity"][n:].any()
    assert len(set(out["position"][n:])) == 1
    assert way * out["position"][-1] == pytest.approx(length, rel=1e-12)


@pytest.mark.parametrize("breakaway", [0.0, 1.0, 1.5])
def test_nothing_creeps_below_breakaway_in_a_hundred_thousand_ticks(breakaway: float) -> None:
    level = max(1.0, breakaway)
    k = np.arange(100_000)
    push = level * np.sign(np.sin(0.001 * k**1.3))
    push[::3] *= 0.9999
    push[::7] *= 0.5
    friction = make("friction", "coulomb", coulomb=1.0, breakaway=breakaway)
    out = run_alone(mass_of(2.0), {"command": push}, friction=friction, initial={"position": 0.25}, jit=True)
    assert np.abs(push).max() == level
    assert not out["velocity"].any()
    assert set(out["position"]) == {0.25}


@pytest.mark.parametrize("way", [-1.0, 1.0])
def test_the_threshold_is_sharp(way: float) -> None:
    friction = make("friction", "coulomb", coulomb=1.0, breakaway=1.5)
    for force, moves in ((math.nextafter(1.5, 0.0), False), (1.5, False), (math.nextafter(1.5, 2.0), True)):
        out = run_alone(mass_of(2.0), {"command": np.full(3, way * force)}, friction=friction)
        assert (way * out["velocity"] > 0.0).all() if moves else not out["velocity"].any()


def test_friction_holds_against_drive_and_load_together() -> None:
    friction = make("friction", "coulomb", coulomb=1.0)
    balanced = run_alone(mass_of(2.0), {"command": np.full(50, 40.0), "load": np.full(50, -40.9)}, friction=friction)
    assert not balanced["velocity"].any()


def test_sliding_force_lies_on_the_stribeck_curve() -> None:
    """Force to hold a speed: F_s at rest, F_c + (F_s - F_c)/e + c v_s at v_s, F_c + c w far above."""
    friction = make("friction", "coulomb", coulomb=2.0, breakaway=3.0, stribeck_velocity=0.01, viscous=4.0)
    for speed, force in ((1e-6, 3.0), (0.01, 2.0 + math.exp(-1.0) + 0.04), (0.5, 4.0)):
        slow, fast = (
            run_alone(mass_of(1e3), {"command": np.full(1, f)}, friction=friction, initial={"velocity": speed})["acceleration"][0]
            for f in (0.99 * force, 1.01 * force)
        )
        assert slow < 0.0 < fast
        assert fast + slow == pytest.approx(0.0, abs=1e-3 * fast)


# --- friction that is least at rest ---------------------------------------------------------------------------------------------------

RISING: dict[str, Any] = {"coulomb": 3.0, "breakaway": 2.0, "rise_velocity": 0.01}


@pytest.mark.parametrize("way", [-1.0, 1.0])
def test_a_force_between_rest_and_sliding_friction_settles_at_the_speed_of_balance(way: float) -> None:
    """F_c - (F_c - F_s) exp(-(w/v_r)^2) = f at w = v_r sqrt(ln((F_c - F_s)/(F_c - f))); below F_s nothing moves."""
    friction = make("friction", "rising", **RISING)
    for force in (2.0, math.nextafter(2.0, 0.0)):
        assert not run_alone(mass_of(0.5), {"command": np.full(50, way * force)}, friction=friction)["velocity"].any()
    for force in (2.2, 2.7, 2.95):
        out = run_alone(mass_of(0.5), {"command": np.full(4000, way * force)}, friction=friction, jit=True)
        assert way * out["velocity"][-1] == pytest.approx(0.01 * math.sqrt(-math.log(3.0 - force)), rel=1e-9)


def test_where_friction_falls_with_speed_the_rising_law_is_the_stribeck_law() -> None:
    push = 4.0 * np.sin(0.02 * np.arange(2000) ** 1.1)
    shape = {"coulomb": 2.0, "breakaway": 3.0, "viscous": 4.0}
    falling = make("friction", "coulomb", **shape, stribeck_velocity=0.01), make("friction", "rising", **shape, rise_velocity=0.01)
    ours, theirs = (run_alone(mass_of(2.0), {"command": push}, friction=friction)["position"] for friction in falling)
    assert np.ptp(ours) > 1e-3
    assert ours == pytest.approx(theirs, abs=1e-12)


# --- bristles ------------------------------------------------------------------------------------------------------------------------

CLASSIC: dict[str, Any] = {
    "coulomb": 1.0,
    "breakaway": 1.5,
    "stribeck_velocity": 1e-3,
    "stiffness": 1e5,
    "bristle_damping": math.sqrt(1e5),
    "viscous": 0.4,
}
"""Canudas de Wit et al. 1995, Table I, for a mass of 1 kg."""


@pytest.mark.parametrize("part", [0.1, 0.5, 0.9])
def test_bristles_bend_as_in_presliding(part: float) -> None:
    """Rising force f up to f_1: with g = F_c = F_s, dz/dx = 1 - s0 z/g and s0 z = f give x = -(g/s0) ln(1 - f_1/g) at any rate."""
    friction = make("friction", "lugre", **{**CLASSIC, "breakaway": 1.0, "bristle_damping": 2e3, "viscous": 0.0})
    exact, gaps = -math.log1p(-part) / 1e5, []
    for n in (6400, 12800, 25600):
        push = part * np.minimum(np.arange(1.6 * n) / n, 1.0)
        out = run_alone(mass_of(1.0), {"command": push}, friction=friction, jit=True, period=1.0 / n)
        gaps.append(abs(out["position"][-1] / exact - 1.0))
    assert gaps[-1] < 1e-4
    # Tends to the second order of the method, once it resolves the bristles' time constant m/s1 = 0.5 ms.
    assert math.log2(gaps[-2] / gaps[-1]) > 1.7


def test_small_forces_see_the_stiffness_of_the_bristles() -> None:
    friction = make("friction", "lugre", **CLASSIC)
    moved = [run_alone(mass_of(1.0), {"command": np.full(4000, f)}, friction=friction)["position"][-1] for f in (1e-4, -1e-4)]
    assert moved == pytest.approx([1e-9, -1e-9], rel=1e-3)


@pytest.mark.parametrize("speed", [2e-3, 5e-3, 0.02, 0.1])
@pytest.mark.parametrize("way", [-1.0, 1.0])
def test_steady_sliding_lies_on_the_stribeck_curve(speed: float, way: float) -> None:
    """F = F_c + (F_s - F_c) exp(-(v/v_s)^2) + s2 v is an equilibrium of the sampled motion too."""
    viscous = 400.0  # high enough for a stable speed below v_s too
    force = 1.0 + 0.5 * math.exp(-((speed / 1e-3) ** 2)) + viscous * speed
    friction = make("friction", "lugre", **{**CLASSIC, "viscous": viscous})
    start = {"velocity": 0.5 * way * speed}
    out = run_alone(mass_of(1.0), {"command": np.full(3000, way * force)}, friction=friction, initial=start, jit=True)
    assert out["velocity"][-1] == pytest.approx(way * speed, rel=1e-9)


def test_a_slow_ramp_breaks_away_near_the_maximum_static_friction() -> None:
    """The slower the ramp, the nearer the breakaway is to F_s = 1.5 N (Canudas de Wit et al. 1995, Fig 4)."""
    friction = make("friction", "lugre", **CLASSIC)
    forces = []
    for rate in (10.0, 1.0, 0.1):
        push = rate * 1e-3 * np.arange(int(1600 / rate))
        out = run_alone(mass_of(1.0), {"command": push}, friction=friction, jit=True)
        forces.append(push[np.argmax(out["velocity"] > 1e-3)])
    assert forces == sorted(forces) and forces[-1] < 1.5
    assert forces[-1] == pytest.approx(1.5, rel=0.01)


# --- smooth --------------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("part", [0.1, 0.5, 0.9, -0.9])
def test_smooth_friction_creeps_at_the_speed_of_its_tanh(part: float) -> None:
    """Far below v_s, F = F_s tanh(v/v_e): a held force makes the axis creep at v_e artanh(F/F_s)."""
    smooth = make("friction", "smooth-coulomb", coulomb=1.0, breakaway=1.5, stribeck_velocity=1e3, smoothing_velocity=1e-2)
    out = run_alone(mass_of(0.5), {"command": np.full(2000, 1.5 * part)}, friction=smooth, jit=True)
    assert out["velocity"][-1] == pytest.approx(1e-2 * math.atanh(part), rel=1e-9)


@given(speed=st.floats(1e-7, 10.0))
def test_smooth_friction_far_above_its_speeds_is_coulomb_and_viscous(speed: float) -> None:
    smooth = make("friction", "smooth-coulomb", coulomb=1.0, breakaway=1.5, stribeck_velocity=1e-9, smoothing_velocity=1e-9, viscous=3.0)
    force = type(smooth).force(smooth_values(smooth), speed)
    assert force == pytest.approx(1.0 + 3.0 * speed, rel=1e-12)
    assert type(smooth).force(smooth_values(smooth), -speed) == -force


def smooth_values(part: Component) -> Any:
    """Return the parameters as a step receives them."""
    from types import SimpleNamespace

    return SimpleNamespace(**part.block(1e-3))
