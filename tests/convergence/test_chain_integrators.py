"""The chain of inertias: order against independent solutions, energy, and the chain of two beside the two-inertia drive."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from two_mass_rig import DRIVE, NONE, Drive, chain_energy, random_command

from contourlab.components.friction.laws import Coulomb
from contourlab.components.plant.inertia_chain import InertiaChain
from contourlab.components.plant.two_inertia import COARSEST, TwoInertia

Array = NDArray[np.float64]
LEAD = 0.016
TURN = 2.0 * math.pi / LEAD
N_TICK = 60
COMMAND = 3.0 * np.sin(0.05 * np.arange(N_TICK)) + 0.5 * np.random.default_rng(1).normal(size=N_TICK)
RUBBING = Coulomb(coulomb=60.0, breakaway=60.0, viscous=100.0)
STICKY = Coulomb(coulomb=50.0, breakaway=80.0, stribeck_velocity=5e-3)
BY_NUMBER = [2, 3, 5, pytest.param(8, marks=pytest.mark.slow)]


def chain(n: int, **values: Any) -> InertiaChain:
    """Return a chain of unlike inertias and stiffnesses, 10 g m^2 and 4 kN m/rad in all."""
    inertias = tuple(1e-2 * w / (n * (n + 1) / 2) for w in range(1, n + 1))
    stiffnesses = tuple(1e3 * (n - 1) * (1.0 + 0.3 * (-1) ** j) for j in range(n - 1))
    return InertiaChain(**{"inertias": inertias, "stiffnesses": stiffnesses, "lead": LEAD, **values})


def orders(errors: list[float]) -> float:
    return float(np.mean([math.log2(a / b) for a, b in pairwise(errors)]))


def substeps(plant: InertiaChain) -> list[int]:
    """Return halving steps from a third of a radian of the highest frequency on."""
    coarse = math.ceil(1.5 * 1e-3 * COARSEST / 0.5 * 2.0 * math.pi * plant.frequencies()[-1] / COARSEST)
    return [coarse, 2 * coarse, 4 * coarse]


@pytest.mark.parametrize("n", BY_NUMBER)
def test_a_chain_without_gaps_is_its_linear_system(n: int) -> None:
    """M p'' + C p' + K p = forces, put together here joint by joint, by the matrix exponential."""
    plant = chain(n, shaft_dampings=(0.1,), motor_damping=0.02, load_damping=0.03, mass=5.0, torque_gain=0.8)
    m = np.array(plant.inertias) * TURN**2 + np.r_[np.zeros(n - 1), 5.0]
    joint = np.diff(np.eye(n), axis=0)
    k, c = (joint.T @ np.diag(np.array(x) * TURN**2) @ joint for x in (plant.stiffnesses, [0.1] * (n - 1)))
    c[0, 0] += 0.02 * TURN**2
    c[-1, -1] += 0.03 * TURN**2
    a = np.zeros((2 * n + 2, 2 * n + 2))
    a[:n, n : 2 * n] = np.eye(n)
    a[n : 2 * n, :n], a[n : 2 * n, n : 2 * n] = -k / m[:, None], -c / m[:, None]
    a[n, -2], a[2 * n - 1, -1] = 0.8 * TURN / m[0], 1.0 / m[-1]
    step, x, exact = expm(1e-3 * a), np.zeros(2 * n + 2), []
    for u in COMMAND:
        x = step @ np.r_[x[: 2 * n], u, -20.0]
        exact.append(x[[0, n - 1, 2 * n - 1]])
    errors = []
    for count in substeps(plant):
        run = Drive(plant, substeps=count).run(COMMAND, -20.0)
        errors.append(float(np.abs(np.column_stack([run[f] for f in ("motor_position", "position", "velocity")]) - exact).max()))
    assert 3.8 < orders(errors) < 4.4
    assert errors[-1] < 1e-6 * np.abs(exact).max()
    # The same matrices by the plant's own account.
    model = plant.linearize()
    assert model.a == pytest.approx(a[: 2 * n, : 2 * n]) and model.b == pytest.approx(a[: 2 * n, 2 * n :])
    assert np.sort(2.0 * math.pi * plant.frequencies()) == pytest.approx(np.sqrt(np.sort(np.linalg.eigvals(k / m[:, None]).real)[1:]))


def solved(plant: InertiaChain, push: Array) -> Array:
    """Return the load's and the motor's places at the end of each tick: events of an independent solver at every flank, undamped joints."""
    n, half = len(plant.inertias), 0.5 * np.array(plant.gaps)
    m, k = np.array(plant.inertias) * TURN**2, np.array(plant.stiffnesses) * TURN**2

    def slope(t: float, y: Array, force: float, sides: tuple[int, ...]) -> Array:
        joints = k * (-np.diff(y[:n]) - np.array(sides) * half) * (np.array(sides) != 0)
        return np.r_[y[n:], (np.r_[force, joints] - np.r_[joints, 0.0]) / m]

    def flank(j: int, side: int, way: float) -> Any:
        def crossing(t: float, y: Array, *_: Any) -> float:
            return float(y[j] - y[j + 1] - side * half[j])

        crossing.terminal, crossing.direction = True, way  # type: ignore[attr-defined]
        return crossing

    y, sides, found = np.zeros(2 * n), [0 if h > 0.0 else 1 for h in half], []
    for force in push:
        left = 1e-3
        while left > 1e-15:
            events, names = [], []
            for j in np.flatnonzero(half):
                for side, way, then in ((1, 1.0, 1), (-1, -1.0, -1)) if sides[j] == 0 else ((sides[j], -float(sides[j]), 0),):
                    events.append(flank(j, side, way))
                    names.append((j, then))
            options: Any = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-16, "max_step": 1e-4}
            part = solve_ivp(slope, (0.0, left), y, args=(force, tuple(sides)), events=events, **options)
            left, y = left - float(part.t[-1]), part.y[:, -1]
            hits = [name for name, times in zip(names, part.t_events, strict=True) if len(times)]
            if not hits:
                break
            sides[hits[0][0]] = hits[0][1]
        found.append(y[[0, n - 1]])
    return np.array(found)


GAPS = {2: (25e-6,), 3: (10e-6, 25e-6), 5: (0.0, 10e-6, 0.0, 25e-6)}


@pytest.mark.parametrize("n", GAPS)
def test_the_order_is_four_through_contacts_of_several_joints(n: int) -> None:
    plant = chain(n, backlash_gaps=GAPS[n])
    errors = np.empty((3, 3))
    for i, level in enumerate((0.7, 1.0, 1.4)):
        exact = solved(plant, level * COMMAND * TURN)
        for j, count in enumerate(substeps(plant)):
            run = Drive(plant, substeps=count).run(level * COMMAND)
            errors[i, j] = np.abs(np.column_stack([run["motor_position"], run["position"]]) - exact).max()
        changes = np.count_nonzero(np.diff(np.atleast_2d(run["sides_x"].T)), axis=1)
        assert (changes[np.array(GAPS[n]) > 0.0] >= 5).all() and not changes[np.array(GAPS[n]) == 0.0].any()
    assert 3.4 < orders(list(np.exp(np.log(errors).mean(axis=0)))) < 4.8
    assert errors[:, -1].max() < 1e-9


@pytest.mark.parametrize(
    ("frictions", "model"),
    [((NONE, NONE), "physical"), ((RUBBING, STICKY), "physical"), ((NONE, NONE), "dead-zone")],
    ids=["free", "rubbing", "pulling"],
)
def test_a_chain_of_two_is_the_two_inertia_drive(frictions: tuple[Any, Any], model: str) -> None:
    command = random_command(np.random.default_rng(0), 20_000, 3.0)
    values = {"shaft_damping": 0.3, "motor_damping": 0.02, "load_damping": 0.01, "mass": 10.0, "start_in_gap": 0.5, "contact_model": model}
    two = TwoInertia(**DRIVE, **values)
    one = {name: value for name, value in values.items() if name != "shaft_damping"}
    inertias, joints = (5.2e-3, 4.4e-3), {"stiffnesses": (950.0,), "shaft_dampings": (0.3,), "backlash_gaps": (25e-6,)}
    link = InertiaChain(inertias=inertias, lead=LEAD, **joints, **one)
    runs = [Drive(plant, *frictions, period=2e-4).run(command) for plant in (two, link)]
    for name in ("position", "motor_position", "velocity", "acceleration", "shaft_force", "gap_state"):
        assert np.abs(runs[0][name] - runs[1][name]).max() <= 1e-8 * np.abs(runs[0][name]).max()
    assert two.mobilities() == pytest.approx(link.mobilities()) and two.rigid_model() == pytest.approx(link.rigid_model())
    assert two.fewest_substeps(1e-3)[0] == link.fewest_substeps(1e-3)[0]


SOAKED = {
    "three": Drive(chain(3, backlash_gaps=(10e-6, 25e-6)), period=1e-4),
    "three, damped, rubbing": Drive(chain(3, backlash_gaps=(10e-6, 25e-6), shaft_dampings=(0.1,)), RUBBING, STICKY, period=1e-4),
    "five": Drive(chain(5, backlash_gaps=(0.0, 10e-6, 0.0, 25e-6)), period=5e-5),
    "eight, each joint with a gap, rubbing": Drive(chain(8, backlash_gaps=(5e-6,)), RUBBING, STICKY, period=3e-5),
}


@pytest.mark.parametrize("name", [pytest.param(name, marks=pytest.mark.slow if "eight" in name else ()) for name in SOAKED])
def test_a_chain_gains_no_energy_under_a_hundred_thousand_random_samples(name: str) -> None:
    drive = SOAKED[name]
    plant, command = drive.plant, random_command(np.random.default_rng(7), 100_000, 5.0)
    run = drive.run(command)
    assert all(np.isfinite(values).all() for values in run.values())
    held = chain_energy(plant, run)
    force = plant.constants().force_value * command
    gain = np.diff(held) - force[1:] * np.diff(run["motor_position"])
    size = held.max() + (np.abs(force) + np.abs(run["shaft_force"])).max() * np.abs(run["motor_position"]).max()
    assert gain.max() <= 1e-13 * size
    sides = np.atleast_2d(run["sides_x"].T)
    assert all(np.count_nonzero(np.diff(side)) > 1000 for side, gap in zip(sides, plant.gaps, strict=True) if gap > 0.0)
    if plant.shaft_dampings == (0.0,):
        shown = run["gap_state"] == 0.0
        assert not run["shaft_force"][shown].any() and (run["shaft_force"] * run["gap_state"] >= 0.0).all()
