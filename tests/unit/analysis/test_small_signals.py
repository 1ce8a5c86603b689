"""The linear models of components against their steps."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.signal import cont2discrete

from contourlab.components.contract import Component
from contourlab.components.controller.position import PositionController
from contourlab.components.friction.laws import NoFriction
from contourlab.components.mechanics.core import link
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.components.plant.plant import BallScrew, MassDamper, RigidAxis, SingleMass
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.engine.step import Step, record
from contourlab.papers.ghaffari.axis_response import transfer
from contourlab.primitives import Clock

Matrices = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]


def matrices_of(step: Step, values: dict[str, Any], dt: float) -> Matrices:
    """Return A, B, C, D of one tick of a linear step, from unit changes of each state and input."""
    par = record(tuple(values))(**values)
    states, inputs = (record(tuple(p.name for p in ports)) for ports in (step.states, step.inputs))
    n, m = len(step.states), len(step.inputs)

    def tick(x: np.ndarray, u: np.ndarray) -> np.ndarray:
        after, out = step.function(par, states(*x.tolist()), inputs(*u.tolist()), Clock(0.0, 0.0, dt))
        return np.array([*after, *out])

    columns = [tick(e, np.zeros(m)) for e in np.eye(n)] + [tick(np.zeros(n), e) for e in np.eye(m)]
    whole = np.column_stack(columns) if columns else np.zeros((0, 0))
    return whole[:n, :n], whole[:n, n:], whole[n:, :n], whole[n:, n:]


def sampled(matrices: Matrices, w: float, dt: float) -> np.ndarray:
    a, b, c, d = matrices
    return np.asarray(c @ np.linalg.solve(np.exp(1j * w * dt) * np.eye(len(a)) - a, b) + d)


PLANTS: list[SingleMass] = [
    RigidAxis(gain=0.9, damping=20.0),
    MassDamper(mass=20.0, carried_mass=3.0, damping=100.0, force_constant=60.0),
    BallScrew(mass=20.0, inertia=2e-4, lead=0.01, torque_constant=0.5, damping=300.0),
]


@pytest.mark.parametrize("plant", PLANTS, ids=lambda plant: plant.kind)
def test_a_plant_equals_its_held_model(plant: SingleMass) -> None:
    """One tick is the model under held inputs, by the matrix exponential, up to the first term that Runge-Kutta neglects."""
    dt = 1e-3
    model = plant.linearize()
    a, b, *_ = cont2discrete((model.a, model.b, model.c, model.d), dt)
    found = matrices_of(link(plant, NoFriction()), {**plant.block(dt), **NoFriction().block(dt)}, dt)
    rate = -model.a[1, 1]
    # The Runge-Kutta error in position and velocity, for a unit velocity and for a unit of each input.
    free, pushed = rate**4 * dt**5 / 120.0, np.abs(model.b[1]) * rate**3 * dt**5 / 120.0
    assert np.abs(found[0] - a)[:, 0].max() == 0.0
    assert (np.abs(found[0] - a)[:, 1] < [1.01 * free + 1e-18, 1.01 * free * rate + 2e-16]).all()
    assert (np.abs(found[1] - b)[0] < 1.01 * pushed + 1e-15 * np.abs(b[0])).all()
    assert (np.abs(found[1] - b)[1] < 1.01 * pushed * rate + 1e-15 * np.abs(b[1])).all()
    # Outputs are the states after the tick.
    assert np.array_equal(found[2][:2], found[0])
    assert np.array_equal(found[3][:2], found[1])


SAMPLED: list[Component] = [
    FilteredDifference(bandwidth=300.0),
    FilteredDifference(bandwidth=300.0, discretisation="pole-matched"),
    DisturbanceObserver(bandwidth=80.0, filter_bandwidth=500.0, model_gain=0.8, model_damping=15.0),
    DisturbanceObserver(bandwidth=80.0, filter_bandwidth=500.0, model_gain=0.8, model_damping=15.0, discretisation="pole-matched"),
    PositionController(
        velocity_gain=60.0, position_gain=2200.0, integral_gain=12.0, model_gain=0.8, model_damping=15.0, anti_windup="none"
    ),
]


@pytest.mark.parametrize("part", SAMPLED, ids=lambda part: part.kind + "-" + str(getattr(part, "discretisation", "")))
def test_a_sampled_part_converges_to_its_model(part: Component) -> None:
    """From every input to every output, at 3 frequencies: the difference falls with the period, or faster."""
    model = part.linearize()
    assert model is not None
    step = part.make_step()
    columns = [[p.name for p in step.inputs].index(name) for name in model.inputs]
    for w in (5.0, 60.0, 400.0):
        exact = transfer(model, 1j * w)[0]
        gaps = []
        for dt in (2e-5, 1e-5):
            found = sampled(matrices_of(step, part.block(dt), dt), w, dt)[:, columns]
            gaps.append(np.abs(found - exact).max() / np.abs(exact).max())
        assert gaps[1] < 1e-2
        # 1e-9 is rounding: differences over 10 us, and a pole close to 1.
        assert gaps[1] < 1e-9 or gaps[0] / gaps[1] > 1.9
