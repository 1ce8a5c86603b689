"""The disturbance observer: its effect on the plant, eqs (10)-(13), and on an axis that differs from its model."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, Array, make
from hypothesis import given
from hypothesis import strategies as st

from contourlab.components.contract import Component
from contourlab.components.friction.laws import NoFriction
from contourlab.components.mechanics.core import link
from contourlab.engine.runner import make_group
from contourlab.engine.schedule import Late, Node, Schedule
from contourlab.engine.step import Port, Step

POSITIVE = st.floats(0.1, 100.0)


def subtract(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    return (), (inp.command - inp.estimate,)


SUBTRACT = Step("subtract", subtract, inputs=(Port("command"), Port("estimate")), outputs=(Port("applied"),))


def velocity_of(plant: Component, observer: Component | None, command: Array, load: Array, jit: bool = False) -> Array:
    """Return the velocity (n_tick,) of an axis for a given command, from which the observer subtracts its estimate."""
    nodes = []
    if observer is not None:
        wires = {"velocity": Late("plant.velocity"), "applied": Late("drive.applied")}
        nodes.append(Node("observer", observer.make_step(), wires, observer.block(PERIOD)))
    estimate: Any = 0.0 if observer is None else "observer.disturbance_estimate"
    nodes.append(Node("drive", SUBTRACT, {"command": "in.command", "estimate": estimate}))
    wired: dict[str, Any] = {"command": "drive.applied", "load": "in.load"}
    nodes.append(Node("plant", link(plant, NoFriction()), wired, plant.block(PERIOD)))
    schedule = Schedule(tuple(nodes), (Port("command"), Port("load")), PERIOD, len(nodes))
    group = make_group(schedule, 1, slice(0, 1), jit)
    return group.run(np.column_stack([command, load]), [schedule.row("plant.velocity")])[:, 0, 0]


def loop(a: float, b: float, a_hat: float, b_hat: float, wd: float, wz: float) -> tuple[Array, Array, Array]:
    """Return A, B, C of axis and observer in continuous time: states v, xi, d_hat; inputs u_c, d; output v."""
    observer = make("observer", "disturbance-observer", bandwidth=wd, filter_bandwidth=wz, model_gain=a_hat, model_damping=b_hat)
    model = observer.linearize()
    # s v = -b v + a (u_c - d_hat + d); the estimate uses the observer's velocity and applied command.
    matrix = np.zeros((3, 3))
    matrix[0] = [-b, 0.0, -a]
    matrix[1:, 1:] = model.a
    matrix[1:, 0] = model.b[:, 0]
    matrix[1:, 2] -= model.b[:, 1]
    inputs = np.array([[a, a], [0.0, 0.0], [0.0, 0.0]])
    inputs[1:, 0] = model.b[:, 1]
    return matrix, inputs, np.array([[1.0, 0.0, 0.0]])


@given(a=POSITIVE, b=POSITIVE, a_hat=POSITIVE, b_hat=POSITIVE, wd=st.floats(1.0, 1e3), ratio=st.floats(0.1, 100.0))
def test_the_loop_is_that_of_equations_10_to_13(a: float, b: float, a_hat: float, b_hat: float, wd: float, ratio: float) -> None:
    """V = [P U_c + P (1 - Q) D]/(1 - Q + P Q N), with P = a/(s + b), Q = w_d/(s + w_d), N = (s w_z/(s + w_z) + b_hat)/a_hat.

    This is (10)-(13) solved by hand from the observer's definition, independent of its state form.
    """
    wz = ratio * wd
    matrix, inputs, output = loop(a, b, a_hat, b_hat, wd, wz)
    for w in np.geomspace(0.01, 1e4, 9):
        s = 1j * w
        p, q, n = a / (s + b), wd / (s + wd), (s * wz / (s + wz) + b_hat) / a_hat
        wanted = np.array([p, p * (1.0 - q)]) / (1.0 - q + p * q * n)
        found = (output @ np.linalg.solve(s * np.eye(3) - matrix, inputs.astype(complex)))[0]
        assert found == pytest.approx(wanted, rel=1e-8)


@given(a=POSITIVE, b=POSITIVE, a_hat=POSITIVE, b_hat=POSITIVE, wd=st.floats(1.0, 1e3), ratio=st.floats(0.1, 100.0))
def test_it_is_stable_for_all_positive_parameters(a: float, b: float, a_hat: float, b_hat: float, wd: float, ratio: float) -> None:
    """Routh's criterion proves it in continuous time; this test uses eigenvalues."""
    matrix, _, _ = loop(a, b, a_hat, b_hat, wd, ratio * wd)
    assert np.linalg.eigvals(matrix).real.max() < 0.0


@pytest.mark.parametrize("rule", ["backward-euler", "pole-matched"])
@pytest.mark.parametrize(("gain", "damping"), [(1.695, 10.1), (0.648, 6.5), (0.9, 25.0)])
@pytest.mark.parametrize("disturbance", [0.0, -0.088])
def test_an_axis_under_its_observer_has_the_steady_gain_of_the_model(rule: str, gain: float, damping: float, disturbance: float) -> None:
    """a_hat/b_hat from the command to the velocity, for any axis and any disturbance."""
    a_hat, b_hat = 0.9, 12.0
    observer = make("observer", "disturbance-observer", model_gain=a_hat, model_damping=b_hat, discretisation=rule)
    n = 4000
    v = velocity_of(make("plant", "rigid-axis", gain=gain, damping=damping), observer, np.full(n, 0.3), np.full(n, disturbance), jit=True)
    assert v[-1] == pytest.approx(0.3 * a_hat / b_hat, rel=1e-10)


def test_without_the_observer_neither_holds() -> None:
    n = 4000
    v = velocity_of(make("plant", "rigid-axis", gain=1.695, damping=10.1), None, np.full(n, 0.3), np.full(n, -0.088), jit=True)
    assert v[-1] == pytest.approx((0.3 - 0.088) * 1.695 / 10.1, rel=1e-10)


def test_a_disturbance_step_decays_at_the_bandwidth() -> None:
    """With an exact model and w_z far above, the response to a disturbance decays as exp(-w_d t)."""
    a, b, wd, n = 1.0, 5.0, 40.0, 400
    plant = make("plant", "rigid-axis", gain=a, damping=b)
    observer = make("observer", "disturbance-observer", bandwidth=wd, filter_bandwidth=1e5, model_gain=a, model_damping=b)
    load = np.full(n, 0.2)
    v = velocity_of(plant, observer, np.zeros(n), load)
    t = PERIOD * np.arange(1, n + 1)
    # P (1 - Q) = a s/((s + b)(s + w_d)): a step of 0.2 gives a (e^{-b t} - e^{-w_d t})/(w_d - b) times 0.2.
    assert v == pytest.approx(0.2 * a * (np.exp(-b * t) - np.exp(-wd * t)) / (wd - b), abs=0.04 * v.max())


def test_an_exact_model_shows_no_disturbance() -> None:
    """The estimate is the error of sampling alone and vanishes with the period."""
    plant = make("plant", "rigid-axis", gain=1.1, damping=8.0)
    observer = make("observer", "disturbance-observer", model_gain=1.1, model_damping=8.0)
    command = 0.5 * np.sin(5.0 * PERIOD * np.arange(2000))
    with_it = velocity_of(plant, observer, command, np.zeros(2000), jit=True)
    without = velocity_of(plant, None, command, np.zeros(2000), jit=True)
    assert np.abs(with_it - without).max() < 0.01 * np.abs(without).max()
