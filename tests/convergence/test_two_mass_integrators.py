"""Order of the two-mass drive through contacts, stops and releases, against independent solutions."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from exact_run import simulate_exact
from numpy.typing import NDArray
from scipy.linalg import expm
from two_mass_reference import Reference
from two_mass_rig import DRIVE, NONE, Drive, energy

from contourlab.components.friction.laws import Coulomb
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.components.plant.two_sided import COARSEST
from contourlab.papers.shahin.two_inertia_loop import Feedback, TwoInertias, two_inertia_loop

Array = NDArray[np.float64]
SUBSTEPS = (4, 8, 16, 32)
"""0.16 to 0.02 rad of the shaft's oscillation in a step."""
PICOMETRES = 1e-11
N_TICK = 100
NOISE = np.random.default_rng(1).normal(size=(4, N_TICK))
COMMANDS = np.array([[1.0], [1.5], [2.0], [3.0]]) * np.sin(0.03 * np.arange(N_TICK)) + 0.5 * NOISE
COMMAND = COMMANDS[-1]
WEDGE = {"gap_profile": (1.0, 3.0, 3.0), "profile_start": -0.05, "profile_step": 0.2}
FRICTION = (50.0, 60.0)

CASES = {
    "without losses": ({}, (0.0, 0.0), 32),
    "damped": ({"shaft_damping": 0.3}, (0.0, 0.0), 10),
    "damped dead zone": ({"shaft_damping": 0.3, "contact_model": "dead-zone"}, (0.0, 0.0), 10),
    "friction": ({}, FRICTION, 32),
    "friction, damped": ({"shaft_damping": 0.3}, FRICTION, 10),
    "friction, damped dead zone": ({"shaft_damping": 0.3, "contact_model": "dead-zone"}, FRICTION, 10),
    "gap that varies": (WEDGE, (0.0, 0.0), 32),
    "gap that varies, damped, friction": ({"shaft_damping": 0.1, **WEDGE}, FRICTION, 10),
}


def frictions(coulomb: tuple[float, float]) -> tuple[Any, Any]:
    motor, load = (Coulomb(coulomb=force, breakaway=force) if force else NONE for force in coulomb)
    return load, motor


def solved(plant: TwoInertia, coulomb: tuple[float, float], command: Array) -> Array:
    """Return motor position, load position and side at the end of each tick, of the independent solver."""
    d = plant.constants()
    half = 0.5 * plant.gap_at(0.0)
    slope = (0.5 * plant.gap_at(0.01) - half) / 0.01
    masses = 1.0 / d.motor_mobility, 1.0 / d.load_mobility
    physical = plant.contact_model == "physical"
    reference = Reference(*masses, d.stiffness_value, d.damper_value, half, slope, physical, coulomb, coulomb)
    y, side, found = np.zeros(5), 0, []
    for value in command:
        y, side = reference.hold(y, side, d.force_value * value, 1e-3)
        found.append((y[0], y[2], side))
    return np.array(found)


def orders(errors: list[float]) -> Array:
    return np.array([math.log2(a / b) for a, b in pairwise(errors)])


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_the_order_is_four_through_contacts_stops_and_releases(case: str) -> None:
    """Contacts fall anywhere within a step, so the error of one motion scatters: the order is that of the mean of several."""
    values, coulomb, changes = CASES[case]
    plant = TwoInertia(**DRIVE, **values)
    errors, seen = np.empty((len(COMMANDS), len(SUBSTEPS))), 0
    for i, command in enumerate(COMMANDS):
        exact = solved(plant, coulomb, command)
        seen += np.count_nonzero(np.diff(exact[:, 2]))
        for j, n in enumerate(SUBSTEPS):
            run = Drive(plant, *frictions(coulomb), substeps=n).run(command)
            assert np.array_equal(run["gap_state"], exact[:, 2])
            errors[i, j] = np.abs(np.column_stack([run["motor_position"], run["position"]]) - exact[:, :2]).max()
    assert seen >= changes
    assert (errors[:, -1] < PICOMETRES).all()
    assert 3.7 < orders(list(np.exp(np.log(errors).mean(axis=0)))).mean() < 4.4


@pytest.mark.parametrize("damping", [0.0, 0.3])
@pytest.mark.parametrize("push", [-800.0, 150.0])
def test_the_order_is_four_against_matrix_exponentials_between_exact_instants(damping: float, push: float) -> None:
    """From a motion through the gap, under a constant force."""
    plant = TwoInertia(**DRIVE, shaft_damping=damping, motor_damping=0.02, load_damping=0.05)
    d = plant.constants()
    motor, load = 1.0 / d.motor_mobility, 1.0 / d.load_mobility
    drive = TwoInertias(motor, load, d.stiffness_value, d.half_gap, motor * d.motor_decay, load * d.load_decay, d.damper_value)
    loop = two_inertia_loop(drive, Feedback((0.0,) * 4, (1.0, 0.0, 0.0)))
    exact = simulate_exact(loop, (0.0, 0.06, 0.0, -0.02), 0.04, push)
    assert len(exact.times) >= 3
    errors = []
    for n in SUBSTEPS:
        start = {"motor_velocity": 0.06, "velocity": -0.02}
        run = Drive(plant, substeps=n).run(np.full(40, push / d.force_value), **start)
        states = np.column_stack([run["motor_position"], run["position"]])
        errors.append(float(np.abs(states - exact.state(1e-3 * np.arange(1, 41))[:, [0, 2]]).max()))
    assert errors[-1] < PICOMETRES
    assert 3.6 < orders(errors).mean() < 4.6


@pytest.mark.parametrize("damping", [0.0, 0.4])
def test_without_a_gap_it_is_the_linear_system_of_two_masses(damping: float) -> None:
    plant = TwoInertia(**{**DRIVE, "backlash_gap": 0.0}, shaft_damping=damping, motor_damping=0.02, load_damping=0.05)
    turn = 2.0 * math.pi / DRIVE["lead"]
    motor, load, k, c = (x * turn**2 for x in (5.2e-3, 4.4e-3, 950.0, damping))
    cm, cl = 0.02 * turn**2, 0.05 * turn**2
    a = np.zeros((6, 6))
    a[0, 1] = a[2, 3] = 1.0
    a[1, :4] = np.array([-k, -c - cm, k, c]) / motor
    a[3, :4] = np.array([k, c, -k, -c - cl]) / load
    a[1, 4], a[3, 5] = turn / motor, 1.0 / load
    step, x, exact = expm(1e-3 * a), np.zeros(6), []
    for u in COMMAND:
        x = step @ np.r_[x[:4], u, -20.0]
        exact.append(x[:4])
    errors = []
    for n in SUBSTEPS:
        run = Drive(plant, substeps=n).run(COMMAND, -20.0)
        states = np.column_stack([run[name] for name in ("motor_position", "motor_velocity", "position", "velocity")])
        errors.append(float(np.abs(states - exact).max()))
    assert errors[-1] < 1e-8 * float(np.abs(exact).max())
    assert 3.8 < orders(errors).mean() < 4.2


def test_crossing_a_whole_gap_within_a_step_is_of_fourth_order() -> None:
    """The motor flies over 5 um at 0.3 m/s: 17 us, in steps of up to 250 us."""
    plant = TwoInertia(**{**DRIVE, "backlash_gap": 5e-6})
    command = np.where(np.arange(30) % 6 < 3, 20.0, -20.0)
    exact = solved(plant, (0.0, 0.0), command)
    runs = [Drive(plant, substeps=n).run(command) for n in SUBSTEPS]
    jumps = np.abs(np.diff(runs[0]["gap_state"]))
    assert jumps.max() == 2.0
    errors = [float(np.abs(run["position"] - exact[:, 1]).max()) for run in runs]
    assert errors[-1] < PICOMETRES
    assert 3.4 < orders(errors).mean() < 4.7


def test_the_dead_zone_is_the_limit_of_the_physical_model_as_damping_vanishes() -> None:
    """The two differ in proportion to the damping, and both from the undamped drive."""
    undamped = Drive(TwoInertia(**DRIVE), substeps=24).run(COMMAND)["position"]
    between, above = [], []
    for damping in (4e-4, 2e-4, 1e-4):
        runs = [
            Drive(TwoInertia(**DRIVE, shaft_damping=damping, contact_model=model), substeps=24).run(COMMAND)["position"]
            for model in ("physical", "dead-zone")
        ]
        between.append(float(np.abs(runs[0] - runs[1]).max()))
        above.append(float(np.abs(runs[0] - undamped).max()))
    assert 0.9 < orders(above).mean() < 1.1
    assert orders(between).mean() > 0.9
    assert between[-1] < above[-1]


def test_at_the_coarsest_step_a_ringing_shaft_loses_only_the_runge_kutta_damping() -> None:
    """|R(iy)|^2 = 1 - y^6/72 + y^8/576 of the energy is left after a step of y radians."""
    plant = TwoInertia(**{**DRIVE, "backlash_gap": 0.0})
    ring = math.sqrt(950.0 * (1.0 / 5.2e-3 + 1.0 / 4.4e-3))
    period = COARSEST / ring
    assert plant.fewest_substeps(period)[0] == 1
    substeps, cause = plant.fewest_substeps(1.001 * period)
    assert substeps == 2 and "100.5 Hz" in cause
    run = Drive(plant, period=period).run(np.zeros(500), motor_position=1e-5, side=1.0)
    left = 1.0 - COARSEST**6 / 72.0 + COARSEST**8 / 576.0
    assert energy(plant, run)[1:] / energy(plant, run)[:-1] == pytest.approx(np.full(499, left), rel=1e-9)
