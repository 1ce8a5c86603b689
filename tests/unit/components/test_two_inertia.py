"""The two-inertia feed drive: lost motion, special cases equal to other plants, lanes, and reported values."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from component_rig import make
from numpy.typing import NDArray
from two_mass_rig import DRIVE, NONE, Drive, random_command

import contourlab as cl
from contourlab.components.friction.laws import Coulomb
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.errors import ParameterError

Array = NDArray[np.float64]
TURN = 2.0 * math.pi / DRIVE["lead"]


def test_lost_motion_at_a_slow_reversal_is_gap_plus_windup_by_guide_friction() -> None:
    """Lost motion = gap + 2 F_c/k: the motor's way from the last forward to the first backward motion of the load."""
    coulomb, gap, viscous = 120.0, 25e-6, 2e5
    plant = TwoInertia(**DRIVE, motor_damping=viscous / TURN**2)
    # From 0.1 mm/s forwards slowly to as much backwards: the motor's own damping sets the pace.
    most = coulomb + 1e-4 * viscous
    force = np.interp(np.arange(30_000), [2000, 28_000], [most, -most])
    run = Drive(plant, Coulomb(coulomb=coulomb), period=1e-4).run(force / TURN)
    assert run["velocity"][2000] == pytest.approx(1e-4, rel=1e-3) and run["velocity"][-1] == pytest.approx(-1e-4, rel=1e-3)
    stops = int(np.flatnonzero(run["velocity"][2000:] == 0.0)[0]) + 2000
    leaves = int(np.flatnonzero(run["velocity"][stops:])[0]) + stops
    lost = run["motor_position"][stops] - run["motor_position"][leaves]
    assert lost == pytest.approx(gap + 2.0 * coulomb / (950.0 * TURN**2), rel=3e-3)


@pytest.mark.parametrize("factor", [1.0, 4.0])
def test_a_stiff_shaft_without_a_gap_is_a_ball_screw(factor: float) -> None:
    """The load lags by m a/k: the difference from the rigid axis falls with the stiffness."""
    stiffness = 2e4 * factor
    values = {**DRIVE, "backlash_gap": 0.0, "stiffness": stiffness}
    plant = TwoInertia(**values, mass=30.0, motor_damping=0.02, shaft_damping=2e-5 * stiffness)
    rigid = make("plant", "ball-screw", mass=30.0, inertia=9.6e-3, lead=0.016, torque_constant=1.0, efficiency=1.0, damping=0.02 * TURN**2)
    command = np.repeat([2.0, -1.0, 0.5], 100)
    runs = []
    for part, substeps in ((plant, plant.fewest_substeps(1e-3)[0]), (rigid, 1)):
        runs.append(Drive(part, substeps=substeps).run(command)["position"])
    inertia = 4.4e-3 + 30.0 / TURN**2
    most = inertia * 2.0 / (9.6e-3 + 30.0 / TURN**2) / stiffness / TURN
    assert 0.1 * most < np.abs(runs[0] - runs[1]).max() < 4.0 * most


def test_slow_motions_see_the_rigid_model() -> None:
    plant = TwoInertia(**DRIVE, mass=30.0, motor_damping=0.02, load_damping=0.03, torque_gain=0.9)
    gain, damping = plant.rigid_model()
    whole = 9.6e-3 + 30.0 / TURN**2
    assert gain == pytest.approx(0.9 / (whole * TURN))
    assert damping == pytest.approx(0.05 / whole)
    # A steady torque ends at the velocity a u/b.
    run = Drive(plant, period=5e-4).run(np.full(40_000, 0.5))
    assert run["velocity"][-1] == pytest.approx(0.5 * gain / damping, rel=1e-3)


def test_a_mass_counts_as_its_reflected_inertia() -> None:
    """m (l/2 pi)^2: as table, as load on it, or as an inertia."""
    command = random_command(np.random.default_rng(2), 2000, 3.0)
    inertia = 30.0 / TURN**2
    plants = [
        TwoInertia(**DRIVE, mass=30.0),
        TwoInertia(**DRIVE, mass=10.0).loaded(20.0),
        TwoInertia(**{**DRIVE, "load_inertia": 4.4e-3 + inertia}),
    ]
    runs = [Drive(plant, period=1e-4).run(command) for plant in plants]
    for run in runs[1:]:
        assert run["position"] == pytest.approx(runs[0]["position"], rel=1e-9, abs=1e-14)
    assert TwoInertia.moved_mass(plants[1].constants()) == 30.0
    assert plants[0].loaded(0.0) is plants[0]


def test_an_angle_of_the_coupling_counts_as_its_length_along_the_screw() -> None:
    angle = 25e-6 * TURN
    split = TwoInertia(**{**DRIVE, "backlash_gap": 10e-6}, backlash_angle=0.6 * angle)
    assert split.gap_at(0.3) == pytest.approx(25e-6, rel=1e-12)
    command = random_command(np.random.default_rng(3), 2000, 3.0)
    whole, parts = (Drive(plant, period=1e-4).run(command) for plant in (TwoInertia(**DRIVE), split))
    assert parts["position"] == pytest.approx(whole["position"], abs=1e-12)


def test_a_batch_of_32_gaps_equals_32_single_runs() -> None:
    gap = np.geomspace(1e-6, 1e-3, 32)
    command = random_command(np.random.default_rng(4), 3000, 3.0)
    friction, other = Coulomb(coulomb=60.0, breakaway=60.0, viscous=100.0), Coulomb(coulomb=50.0, breakaway=80.0, stribeck_velocity=5e-3)
    drive = Drive(TwoInertia(**DRIVE), friction, other, period=1e-4)
    together = drive.run(command, group=drive.group(32, backlash_gap=gap))
    for lane in (0, 7, 16, 31):
        alone = Drive(TwoInertia(**{**DRIVE, "backlash_gap": gap[lane]}), friction, other, period=1e-4).run(command)
        for name in ("position", "motor_position", "velocity"):
            assert np.abs(together[name][:, lane] - alone[name]).max() < 1e-9 * np.abs(alone[name]).max()
        assert np.mean(together["gap_state"][:, lane] == alone["gap_state"]) > 0.999


def test_a_run_saved_in_a_gap_with_a_twisted_shaft_resumes_exactly() -> None:
    command = random_command(np.random.default_rng(6), 4000, 3.0)
    drive = Drive(TwoInertia(**DRIVE, shaft_damping=0.5), period=1e-4)
    whole = drive.run(command)
    twisted = np.flatnonzero((whole["gap_state"] == 0.0) & (whole["twist_x"] != 0.0))
    stop = int(twisted[len(twisted) // 2]) + 1
    group = drive.group()
    drive.run(command[:stop], group=group)
    saved = group.snapshot()
    drive.run(-command[stop:], group=group)
    group.restore(saved)
    after = drive.run(command[stop:], group=group)
    for name, values in after.items():
        assert np.array_equal(values, whole[name][stop:])


def machine(gap: float, start: float) -> cl.Machine:
    plant = TwoInertia(**{**DRIVE, "backlash_gap": gap}, start_in_gap=start)
    limits = cl.Limits(velocity=0.2, acceleration=2.0, following_error=0.1)
    return cl.Machine("m", tuple(cl.Axis(name, plant, limits=limits) for name in "xy"), 1e-4)


def controller() -> cl.Controller:
    part = make("controller", "position", position_gain=3000.0, velocity_gain=40.0)
    return cl.Controller({name: cl.AxisController(controller=part) for name in "xy"})


@pytest.mark.parametrize("start", [-1.0, 0.0, 0.7])
def test_each_variant_of_a_batch_over_gaps_starts_as_alone(start: float) -> None:
    gaps = [5e-6, 20e-6, 80e-6]
    reference = cl.uniform(cl.contour("circle", radius=0.01), 1.0, 1, 1e-4)
    varied, kept = {"axes.x.plant.backlash_gap": gaps}, ("motor_position", "axis_position")
    found = cl.simulate_batch(machine(1e-5, start), controller(), reference, varied, keep=kept, judge=False)
    for i, gap in enumerate(gaps):
        alone = cl.simulate(
            cl.Machine("m", (machine(gap, start).axes[0], machine(1e-5, start).axes[1]), 1e-4),
            controller(),
            reference,
            signals=kept,
        )
        assert alone["motor_position"][0, 0] - alone["axis_position"][0, 0] == pytest.approx(0.5 * start * gap, abs=1e-15)
        for name in ("motor_position", "axis_position"):
            np.testing.assert_allclose(found.signals[name][:, :, i], alone[name], rtol=0.0, atol=1e-10)


def test_the_gap_along_the_travel_follows_its_table_and_holds_beyond() -> None:
    plant = TwoInertia(**DRIVE, gap_profile=(1.0, 0.5, 2.0), profile_start=-0.1, profile_step=0.2)
    assert [plant.gap_at(p) / 25e-6 for p in (-1.0, -0.1, 0.0, 0.1, 0.2, 0.3, 5.0)] == pytest.approx([1.0, 1.0, 0.75, 0.5, 1.25, 2.0, 2.0])
    gap = plant.gap_function()
    par = type("Par", (), {**plant.constants()._asdict(), "profile": (1.0, 0.5, 2.0)})
    for position in (-0.5, -0.05, 0.15, 0.4):
        half, slope = gap(par, position)
        assert half == pytest.approx(0.5 * plant.gap_at(position))
        assert slope == pytest.approx((plant.gap_at(position + 1e-6) - plant.gap_at(position - 1e-6)) / 4e-6, abs=1e-9)


def test_at_rest_the_motor_is_within_the_local_gap() -> None:
    plant = TwoInertia(**DRIVE, start_in_gap=-0.5, gap_profile=(1.0, 3.0), profile_start=0.0, profile_step=0.1)
    states, outputs = plant.at_rest(0.05)
    assert states == outputs == {"position": 0.05, "motor_position": 0.05 - 0.25 * 2.0 * 25e-6}


def test_a_drive_at_rest_stays_at_rest_anywhere_in_its_gap() -> None:
    for start in (-1.0, -0.3, 0.0, 1.0):
        run = Drive(TwoInertia(**DRIVE, start_in_gap=start, shaft_damping=0.2)).run(np.zeros(50))
        assert np.ptp(run["motor_position"]) == 0.0 and not run["position"].any() and not run["shaft_force"].any()


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"load_inertia": 0.0}, "load_inertia = 0 .*mass"),
        ({"stiffness": 0.0}, "stiffness"),
        ({"backlash_gap": -1e-6}, "backlash_gap"),
        ({"start_in_gap": 1.5}, "start_in_gap"),
        ({"contact_model": "elastic"}, "physical, dead-zone"),
        ({"gap_profile": ()}, "gap_profile"),
    ],
)
def test_an_impossible_drive_is_refused(values: dict[str, Any], message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        TwoInertia(**{**DRIVE, **values})


def test_masses_friction_mobilities_and_shaft_refer_to_the_table() -> None:
    """At first a force at the load moves the load alone; the motor's mobility is that of its own inertia."""
    plant = TwoInertia(**DRIVE, mass=30.0)
    assert plant.mobilities() == pytest.approx((1.0 / (4.4e-3 * TURN**2 + 30.0), 1.0 / (5.2e-3 * TURN**2)))
    run = Drive(plant, period=1e-6).run([0.0], load=10.0)
    assert float(run["acceleration"]) == pytest.approx(10.0 * plant.mobilities()[0])
    assert float(run["motor_velocity"]) == 0.0
    assert plant.linear().gap_at(0.0) == 0.0


def test_a_load_bouncing_in_its_gap_does_not_feel_the_friction_of_the_motor() -> None:
    """The motor is held; the load bounces between the flanks and each contact returns its energy."""
    plant = TwoInertia(**DRIVE, start_in_gap=0.0)
    run = Drive(plant, NONE, Coulomb(coulomb=5e3), period=1e-4).run(np.zeros(3000), velocity=0.01)
    assert not run["motor_velocity"].any()
    free = run["gap_state"] == 0.0
    assert np.abs(run["velocity"][free]) == pytest.approx(np.full(free.sum(), 0.01), rel=2e-4)
    assert np.count_nonzero(np.diff(run["gap_state"])) > 40
