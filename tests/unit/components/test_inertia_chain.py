"""The chain of inertias in a machine, what it says of itself, and what a screw makes of masses and inertias."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from component_rig import make
from two_mass_rig import Drive, random_command

import contourlab as cl
from contourlab.components.friction.laws import LuGre
from contourlab.components.mechanics.core import link
from contourlab.components.plant.inertia_chain import InertiaChain
from contourlab.components.plant.reflected import reflected_inertia, reflected_mass
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.errors import ComponentError, ParameterError

THREE: dict[str, Any] = {
    "inertias": (3e-3, 2.2e-3, 4.4e-3),
    "lead": 0.016,
    "stiffnesses": (3000.0, 950.0),
    "backlash_gaps": (10e-6, 0.0),
    "backlash_angles": (0.0, 5e-3),
}
LEAD = 0.016 / (2.0 * math.pi)


def test_what_a_chain_is_made_of_adds_up() -> None:
    plant = InertiaChain(**THREE, mass=10.0, motor_damping=0.01, load_damping=0.03)
    assert plant.gaps == pytest.approx((10e-6, 5e-3 * LEAD))
    assert plant.gap_at(0.2) == pytest.approx(10e-6 + 5e-3 * LEAD)
    gain, damping = plant.rigid_model()
    whole = 9.6e-3 + reflected_inertia(10.0, 0.016)
    assert gain == pytest.approx(LEAD / whole) and damping == pytest.approx(0.04 / whole)
    assert plant.mobilities() == pytest.approx((1.0 / (10.0 + 4.4e-3 / LEAD**2), LEAD**2 / 3e-3))
    assert InertiaChain.moved_mass(plant.loaded(7.0).constants()) == 17.0
    assert plant.linear().gaps == (0.0, 0.0)


def test_the_highest_frequency_of_a_chain_sets_its_substeps() -> None:
    """Equal masses and springs: w = 2 sqrt(k/m) sin(i pi/2n), a textbook row."""
    plant = InertiaChain(inertias=(1e-3,) * 6, stiffnesses=(500.0,), lead=0.01)
    wanted = 2.0 * math.sqrt(500.0 / 1e-3) * np.sin(np.arange(1, 6) * math.pi / 12.0)
    assert 2.0 * math.pi * plant.frequencies() == pytest.approx(wanted, rel=1e-12)
    count, why = plant.fewest_substeps(1e-3)
    assert count == math.ceil(wanted[-1] * 1e-3 / 0.5) == 3 and f"{wanted[-1] / 2.0 / math.pi:.4g} Hz" in why
    damped = plant.replace(shaft_dampings=(5.0,))
    # Dampers in a row have eigenvalues 4 d/m sin^2: over a unit of decay in a step more of them are wanted.
    assert damped.fewest_substeps(1e-3)[0] == math.ceil(4.0 * 5.0 / 1e-3 * math.sin(5.0 * math.pi / 12.0) ** 2 * 1e-3)


def test_each_joint_stands_in_its_gap_where_it_was_put() -> None:
    plant = InertiaChain(**THREE, start_in_gap=1.0)
    states, outputs = plant.at_rest(0.3)
    load_side, motor_side = 0.5 * 5e-3 * LEAD, 5e-6
    assert states["inner_positions"] == pytest.approx((0.3 + load_side,))
    assert states["motor_position"] == outputs["motor_position"] == pytest.approx(0.3 + load_side + motor_side)
    run = Drive(plant).run(np.zeros(20))
    assert np.ptp(run["motor_position"]) == 0.0 and not run["position"].any()


def test_gap_state_is_that_of_the_loose_joint_nearest_the_load() -> None:
    command = random_command(np.random.default_rng(1), 3000, 2.0)
    for gaps, joint in (((10e-6, 0.0), 0), ((10e-6, 20e-6), 1), ((0.0, 0.0), 1)):
        run = Drive(InertiaChain(**{**THREE, "backlash_gaps": gaps, "backlash_angles": (0.0,)}), period=1e-4).run(command)
        assert np.array_equal(run["gap_state"], run["sides_x"][:, joint])


def test_lost_motion_of_a_chain_is_that_of_all_its_joints() -> None:
    """A force at the load, against a held motor, first one way and then the other: 2 F (1/k_1 + 1/k_2) and both gaps."""
    plant = InertiaChain(**THREE, load_damping=5.0, shaft_dampings=(0.5,))
    force, held = np.repeat([100.0, -100.0], 3000), make("friction", "coulomb", coulomb=1e5)
    run = Drive(plant, motor_friction=held).run(np.zeros(6000), force, None)
    between = run["position"][2999] - run["position"][-1]
    assert not run["motor_velocity"].any()
    twist = 2.0 * 100.0 * LEAD**2 * (1.0 / 3000.0 + 1.0 / 950.0)
    assert between == pytest.approx(plant.gap_at(0.0) + twist, rel=1e-6)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"inertias": (1e-3,)}, "two"),
        ({"stiffnesses": (1.0, 2.0, 3.0)}, "stiffnesses = 3 values: must be 2"),
        ({"backlash_gaps": (1e-6, -1e-6)}, "backlash_gaps"),
        ({"inertias": (1e-3, 0.0, 1e-3)}, "inertias"),
    ],
)
def test_a_chain_that_cannot_be_is_refused(values: dict[str, Any], message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        InertiaChain(**{**THREE, **values})


def test_bristles_on_a_chain_are_refused_in_words() -> None:
    with pytest.raises(ComponentError, match=r"inertia-chain.*'bristle': load lugre.*two-inertia"):
        link(InertiaChain(**THREE), LuGre(coulomb=10.0, breakaway=12.0, stiffness=1e6))


@pytest.mark.parametrize("jit", [False, True])
def test_a_machine_of_chains_starts_moving_and_carries_what_stands_on_it(jit: bool) -> None:
    """A free drive that starts with the reference's speed keeps it, in all of its masses, and keeps still inside."""
    loose = InertiaChain(**{**THREE, "backlash_gaps": (0.0,), "backlash_angles": (0.0,)})
    limits = cl.Limits(following_error=1.0)
    axes = (cl.Axis("x", loose, limits=limits, substeps=4), cl.Axis("y", loose, limits=limits, substeps=4, mounted_on="x", stage_mass=50.0))
    machine = cl.Machine("m", axes, 1e-3)
    idle = cl.Controller({name: cl.AxisController(controller=make("controller", "position")) for name in "xy"})
    reference = cl.uniform(cl.contour("circle", radius=0.01), 1.0, 1, 1e-3)
    result = cl.simulate(machine, idle, reference, moving=True, jit=jit, signals=("axis_velocity", "motor_velocity", "shaft_force"))
    start = result["axis_velocity"][0]
    assert np.hypot(*start) == pytest.approx(2.0 * math.pi * 0.01)
    for name in ("axis_velocity", "motor_velocity"):
        assert np.abs(result[name] - start).max() < 1e-12
    assert machine.loaded_plant("x").carried_mass == 50.0


def test_a_batch_varies_where_a_chain_starts_and_what_it_carries() -> None:
    machine = cl.Machine("m", tuple(cl.Axis(name, InertiaChain(**THREE), substeps=4) for name in "xy"), 1e-3)
    part = make("controller", "position", position_gain=3000.0, velocity_gain=40.0)
    controller = cl.Controller({name: cl.AxisController(controller=part) for name in "xy"})
    reference = cl.uniform(cl.contour("circle", radius=0.01), 1.0, 1, 1e-3)
    varied: dict[str, Any] = {"axes.x.plant.start_in_gap": [-1.0, 0.0, 1.0], "axes.x.plant.mass": [0.0, 5.0, 50.0]}
    kept = ("motor_position", "axis_position")
    found = cl.simulate_batch(machine, controller, reference, varied, keep=kept, judge=False)
    for i in range(3):
        plant = InertiaChain(**THREE, start_in_gap=varied["axes.x.plant.start_in_gap"][i], mass=varied["axes.x.plant.mass"][i])
        alone = cl.simulate(cl.Machine("m", (cl.Axis("x", plant, substeps=4), machine.axes[1]), 1e-3), controller, reference, signals=kept)
        for name in kept:
            assert np.abs(found.signals[name][:, :, i] - alone[name]).max() < 1e-9


def test_a_machine_takes_bristles_on_both_sides_of_a_two_inertia_drive() -> None:
    plant = TwoInertia(motor_inertia=5.2e-3, load_inertia=4.4e-3, lead=0.016, stiffness=950.0, backlash_gap=20e-6)
    bristles = LuGre(coulomb=20.0, breakaway=30.0, stiffness=1e7, bristle_damping=1e3)
    axes = tuple(cl.Axis(name, plant, friction=bristles, motor_friction=bristles.replace(coulomb=10.0), substeps=2) for name in "xy")
    part = make("controller", "position", position_gain=3000.0, velocity_gain=40.0)
    controller = cl.Controller({name: cl.AxisController(controller=part) for name in "xy"})
    reference = cl.uniform(cl.contour("circle", radius=0.01), 1.0, 1, 1e-3)
    names = ("axes.x.friction.coulomb", "axes.x.motor_friction.coulomb")
    batch = cl.simulate_batch(
        cl.Machine("m", axes, 1e-3),
        controller,
        reference,
        {names[0]: [20.0, 60.0], names[1]: [10.0, 30.0]},
        keep=("axis_position",),
        judge=False,
    )
    alone = cl.simulate(cl.Machine("m", axes, 1e-3), controller, reference, signals=("axis_position",))
    first, second = (batch.signals["axis_position"][:, :, i] for i in (0, 1))
    assert np.abs(first - alone["axis_position"]).max() < 1e-9
    assert np.abs(second[:, 0] - first[:, 0]).max() > 1e-6 and np.array_equal(second[:, 1], first[:, 1])


def test_a_screw_makes_an_inertia_of_a_mass_and_a_mass_of_an_inertia() -> None:
    """100 kg on a screw of 10 mm: as much as a steel disc of 10 cm and 3.3 mm, 2.53 kg cm^2."""
    assert reflected_inertia(100.0, 0.01) == pytest.approx(2.533e-4, rel=1e-4)
    assert reflected_mass(reflected_inertia(7.0, 0.02), 0.02) == pytest.approx(7.0)
    # A mass that moves at v has the energy of the inertia that turns at 2 pi v/l.
    v, mass, lead = 0.3, 12.0, 0.016
    assert 0.5 * mass * v**2 == pytest.approx(0.5 * reflected_inertia(mass, lead) * (2.0 * math.pi * v / lead) ** 2)
    for call in (lambda: reflected_inertia(-1.0, 0.01), lambda: reflected_inertia(1.0, 0.0), lambda: reflected_mass(math.inf, 0.01)):
        with pytest.raises(ParameterError):
            call()
