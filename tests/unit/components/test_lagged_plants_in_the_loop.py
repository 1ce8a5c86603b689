"""Plants with lagging force in whole machines: batches against single runs, sampled loop against continuous loop."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import contourlab as cl
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.components.contract import Component
from contourlab.components.controller.position import PositionController
from contourlab.components.friction.laws import Coulomb, LuGre, NoFriction
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.components.plant.lagged_mass import LinearMotor, SecondOrderIntegrator
from contourlab.feed import uniform
from contourlab.loop import Axis, AxisController, Controller, Machine
from contourlab.papers.ghaffari.axis_response import axis_response

MOTOR = LinearMotor(resistance=2.0, inductance=4e-4, back_emf=20.0, force_constant=30.0, mass=2.0, viscous_friction=5.0)
KNOWN = SecondOrderIntegrator(dc_gain=0.05, damping_ratio=1.1, natural_frequency=150.0, mass=2.0)
BRISTLES = LuGre(coulomb=4.0, breakaway=6.0, stiffness=1e5, bristle_damping=300.0, viscous=1.0)


def controllers(plant: Any, **more: Any) -> AxisController:
    a, b = plant.rigid_model()
    gains = PositionController.place(60.0, 0.8, 100.0, a, b)
    return AxisController(PositionController(**gains), **more)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("plant", "friction", "varied"),
    [
        (MOTOR, NoFriction(), "resistance"),
        (MOTOR, Coulomb(coulomb=4.0, breakaway=6.0, stribeck_velocity=0.01), "inductance"),
        (MOTOR, BRISTLES, "back_emf"),
        (MOTOR, Coulomb(coulomb=4.0), "mass"),
        (KNOWN, Coulomb(coulomb=0.3), "mass"),
        (KNOWN, NoFriction(), "damping_ratio"),
    ],
)
def test_lanes_of_a_batch_equal_single_runs(plant: Any, friction: Component, varied: str) -> None:
    """y carries x, so its mass has several parts."""
    axes = (Axis("x", plant, friction=friction, mounted_on="y", stage_mass=1.5), Axis("y", plant, friction=friction, substeps=2))
    machine = Machine("m", axes, 1e-3)
    controller = Controller({name: controllers(plant) for name in "xy"})
    reference = uniform(cl.contour("circle", radius=0.02), 1.0, 1, 1e-3)
    values = getattr(plant, varied) * np.array([0.8, 1.0, 1.3])
    name = f"axes.y.plant.{varied}"
    batch = cl.simulate_batch(machine, controller, reference, {name: values}, keep=("position",))
    for i, value in enumerate(values):
        changed = Machine("m", (axes[0], cl.Axis("y", plant.replace(**{varied: value}), friction=friction, substeps=2)), 1e-3)
        one = cl.simulate(changed, controller, reference)
        assert np.abs(batch.signals["position"][:, :, i] - one["position"]).max() < 1e-11
        assert np.abs(one["position"] - one["reference"]).max() < 5e-3


@pytest.mark.parametrize("plant", [MOTOR, KNOWN])
@pytest.mark.parametrize("observed", [False, True])
def test_the_sampled_loop_converges_to_the_continuous_one(plant: Any, observed: bool) -> None:
    """Half the servo period halves the difference. Load and drive act at different places, which `compliance` must model."""
    a, b = plant.rigid_model()
    seen = DisturbanceObserver(bandwidth=40.0, filter_bandwidth=800.0, model_gain=a, model_damping=b) if observed else None
    axis, part, w = Axis("x", plant), controllers(plant, observer=seen), np.geomspace(1.0, 300.0, 25)
    exact = axis_response(axis, part, w)
    for name in ("closed_loop", "loop_gain", "compliance"):
        near = [getattr(sampled_loop(axis, part, period).response(w), name) for period in (2e-5, 1e-5)]
        off = [np.abs(found / getattr(exact, name) - 1.0).max() for found in near]
        assert off[1] < 0.02
        assert off[0] / off[1] == pytest.approx(2.0, abs=0.2)
