"""Bristles on a two-mass drive: order against an independent solver, energy, and agreement with the single mass."""

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
from two_mass_rig import DRIVE, NONE, Drive, energy, random_command

from contourlab.components.friction.laws import Coulomb, LuGre, SmoothCoulomb
from contourlab.components.mechanics.core import link
from contourlab.components.plant.plant import BallScrew
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.errors import ComponentError

Array = NDArray[np.float64]
GUIDE = LuGre(coulomb=60.0, breakaway=90.0, stribeck_velocity=5e-3, stiffness=2e7, bristle_damping=5e3, viscous=100.0)
BEARING = LuGre(coulomb=50.0, breakaway=50.0, stiffness=1e7, bristle_damping=2e3)
SOFT = SmoothCoulomb(coulomb=60.0, breakaway=70.0, smoothing_velocity=2e-3, stribeck_velocity=1e-2)
OPEN, CLOSED = {}, {"backlash_gap": 0.0, "shaft_damping": 0.2}
N_TICK = 30
COMMAND = 1.5 * np.sin(0.15 * np.arange(N_TICK)) + 0.3 * np.random.default_rng(0).normal(size=N_TICK)

CASES: dict[str, tuple[dict[str, float], Any, Any]] = {
    "no gap": (CLOSED, GUIDE, BEARING),
    "both sides": (OPEN, GUIDE, BEARING),
    "load": (OPEN, GUIDE, NONE),
    "motor": (OPEN, NONE, BEARING),
    "bristles on the motor, smooth on the load": (OPEN, SOFT, BEARING),
}


def rub(friction: Any, v: float, z: float) -> tuple[float, float]:
    """Return the force of a friction and the rate of its bristle, from the equations of its model."""
    if isinstance(friction, SmoothCoulomb):
        return SmoothCoulomb.force(friction.constants(), v), 0.0
    if friction is NONE:
        return 0.0, 0.0
    level = friction.coulomb + (friction.breakaway - friction.coulomb) * math.exp(-((v / friction.stribeck_velocity) ** 2))
    rate = v - friction.stiffness * abs(v) * z / level
    return friction.stiffness * z + friction.bristle_damping * rate + friction.viscous * v, rate


def solved(plant: TwoInertia, load: Any, motor: Any) -> Array:
    """Return both positions at the end of each tick, from an independent solver."""
    d = plant.constants()

    def slope(t: float, y: Array, push: float) -> list[float]:
        theta = y[0] - y[2]
        force = d.stiffness_value * (theta - np.clip(theta, -d.half_gap, d.half_gap))
        force += d.damper_value * (y[1] - y[3])  # a shaft without a gap alone is damped here
        (fm, zm), (fl, zl) = rub(motor, y[1], y[4]), rub(load, y[3], y[5])
        return [y[1], d.motor_mobility * (push - force - fm), y[3], d.load_mobility * (force - fl), zm, zl]

    y, found = np.zeros(6), []
    for u in COMMAND:
        options: Any = {"method": "DOP853", "rtol": 1e-10, "atol": 1e-15, "max_step": 1.25e-4}
        y = solve_ivp(slope, (0.0, 1e-3), y, args=(d.force_value * u,), **options).y[:, -1]
        found.append(y[[0, 2]])
    return np.array(found)


@pytest.mark.parametrize("case", CASES)
def test_bristles_are_of_second_order_through_contacts_too(case: str) -> None:
    values, load, motor = CASES[case]
    plant = TwoInertia(**{**DRIVE, **values})
    exact, errors = solved(plant, load, motor), []
    for n in (4, 8, 16, 32):
        run = Drive(plant, load, motor, substeps=n).run(COMMAND)
        errors.append(float(np.abs(np.column_stack([run["motor_position"], run["position"]]) - exact).max()))
    contacts = np.count_nonzero(np.diff(run["gap_state"]))
    assert contacts == 0 if values else contacts >= 3
    assert errors[-1] < 1e-9
    assert 1.9 < np.mean([math.log2(a / b) for a, b in pairwise(errors)]) < 2.1


def stored(drive: Drive, run: dict[str, Array]) -> Array:
    """Return the energy of masses, shaft and bristles."""
    held = energy(drive.plant, run)
    for side, friction in (("load", drive.friction), ("motor", drive.motor_friction)):
        if isinstance(friction, LuGre):
            held = held + 0.5 * friction.stiffness * run[f"{side}_friction_bristle_x"] ** 2
    return held


def check(drive: Drive, command: Array) -> int:
    """Assert that a run is finite and gains nothing; return how often the contact changes."""
    run = drive.run(command)
    held, d = stored(drive, run), drive.plant.constants()
    gain = np.diff(held) - d.force_value * command[1:] * np.diff(run["motor_position"])
    assert all(np.isfinite(values).all() for values in run.values())
    assert gain.max() <= 1e-13 * (held.max() + np.abs(d.force_value * command * run["motor_position"]).max())
    theta, free = run["motor_position"] - run["position"] - run["twist_x"], run["gap_state"] == 0.0
    assert (np.abs(theta[free]) <= d.half_gap * (1.0 + 1e-6) + 1e-12).all() or len(drive.plant.gap_profile) > 1
    return int(np.count_nonzero(np.diff(run["gap_state"])))


WAVY = {"gap_profile": (1.0, 3.0, 0.0), "profile_start": -0.02, "profile_step": 0.017}
SOAKED = {
    "fine": Drive(TwoInertia(**DRIVE), GUIDE, BEARING, period=1e-4),
    "coarse": Drive(TwoInertia(**DRIVE), GUIDE, BEARING, period=7e-4),
    "damped": Drive(TwoInertia(**DRIVE, shaft_damping=0.3), GUIDE, BEARING, period=3e-4),
    "stiff bristles without damping": Drive(TwoInertia(**DRIVE), GUIDE.replace(stiffness=1e10, bristle_damping=0.0), BEARING, period=5e-4),
    "gap that varies": Drive(TwoInertia(**DRIVE, **WAVY), GUIDE, BEARING, period=5e-4),
    "load alone": Drive(TwoInertia(**DRIVE), GUIDE, NONE, period=5e-4),
}


@pytest.mark.parametrize("name", SOAKED)
def test_a_hundred_thousand_random_samples_gain_nothing(name: str) -> None:
    """The energy balance holds for each step of any size, not only in the limit of small steps."""
    assert check(SOAKED[name], random_command(np.random.default_rng(1), 100_000, 5.0)) > 500


@settings(max_examples=200)
@given(
    masses=st.tuples(st.floats(-5.0, -1.0), st.floats(-5.0, -1.0)),
    springs=st.tuples(st.floats(1.0, 4.0), st.floats(4.0, 10.0), st.floats(4.0, 10.0)),
    gap=st.floats(-7.0, -3.0),
    force=st.floats(-1.0, 3.0),
    share=st.floats(0.02, 3.0),
    seed=st.integers(0, 2**32 - 1),
)
def test_no_drive_with_bristles_gains_energy(
    masses: tuple[float, float], springs: tuple[float, float, float], gap: float, force: float, share: float, seed: int
) -> None:
    """Also at steps up to six times the coarsest one that the shaft allows."""
    (motor, load), (stiffness, *bristles) = (10.0**m for m in masses), (10.0**k for k in springs)
    plant = TwoInertia(motor_inertia=motor, load_inertia=load, lead=0.01, stiffness=stiffness, backlash_gap=10.0**gap)
    frictions = (LuGre(coulomb=10.0**force, breakaway=1.5 * 10.0**force, stiffness=k) for k in bristles)
    period = share / math.sqrt(stiffness * (1.0 / motor + 1.0 / load))
    check(Drive(plant, *frictions, period=period), random_command(np.random.default_rng(seed), 400, stiffness * 10.0**gap))


def test_behind_a_stiff_shaft_bristles_act_as_on_a_single_mass() -> None:
    turn = 2.0 * math.pi / 0.016
    plant = TwoInertia(**{**DRIVE, "backlash_gap": 0.0, "stiffness": 1e5}, shaft_damping=5.0)
    rigid = BallScrew(mass=1e-6, inertia=9.6e-3, lead=0.016, torque_constant=1.0, efficiency=1.0)
    whole = GUIDE.replace(coulomb=120.0, breakaway=160.0)
    two = Drive(plant, whole, substeps=plant.fewest_substeps(1e-3)[0]).run(2.0 * COMMAND)["position"]
    one = Drive(rigid, whole, substeps=8).run(2.0 * COMMAND)["position"]
    # The load lags by the transmitted torque over the stiffness: at most 3 N m over 1e5 N m/rad.
    assert np.abs(two - one).max() < 2.0 * 3.5 / 1e5 / turn
    assert np.ptp(one) > 2e-5


@pytest.mark.parametrize(("load", "motor"), [(GUIDE, Coulomb(coulomb=5.0)), (Coulomb(coulomb=5.0), BEARING)])
def test_bristles_on_one_side_and_sticking_on_the_other_are_refused(load: Any, motor: Any) -> None:
    with pytest.raises(ComponentError, match=r"bristle.*'sticking'"):
        link(TwoInertia(**DRIVE), load, motor)


def test_lanes_with_bristles_are_single_runs() -> None:
    gaps, command = np.geomspace(1e-6, 1e-4, 32), random_command(np.random.default_rng(4), 2000, 3.0)
    drive = Drive(TwoInertia(**DRIVE), GUIDE, BEARING, period=1e-4)
    together = drive.run(command, group=drive.group(32, backlash_gap=gaps))["position"]
    for lane in (0, 13, 31):
        alone = Drive(TwoInertia(**{**DRIVE, "backlash_gap": gaps[lane]}), GUIDE, BEARING, period=1e-4).run(command)["position"]
        assert np.abs(together[:, lane] - alone).max() < 1e-9 * np.abs(alone).max()
