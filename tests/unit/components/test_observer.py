"""Disturbance observer and load observer: their effect on the plant, and on an axis that differs from its model."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, Array, make, run_alone
from hypothesis import given
from hypothesis import strategies as st

from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.components.contract import Component
from contourlab.components.friction.laws import NoFriction
from contourlab.components.mechanics.core import link
from contourlab.engine.runner import make_group
from contourlab.engine.step import Late, Node, Port, Schedule, Step
from contourlab.loop import Axis, AxisController

POSITIVE = st.floats(0.1, 100.0)


def subtract(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    return (), (inp.command - inp.estimate,)


SUBTRACT = Step("subtract", subtract, inputs=(Port("command"), Port("estimate")), outputs=(Port("applied"),))


def velocity_of(plant: Component, observer: Component | None, command: Array, load: Array, jit: bool = False) -> Array:
    """Return the velocity (n_tick,) of an axis for a given command, from which the observer subtracts its estimate."""
    nodes = []
    if observer is not None:
        offered = {"position": Late("plant.position"), "velocity": Late("plant.velocity"), "applied": Late("drive.applied")}
        wires = {port.name: offered[port.name] for port in observer.inputs}
        nodes.append(Node("observer", observer.make_step(), wires, observer.block(PERIOD)))
    estimate: Any = 0.0 if observer is None else "observer.disturbance_estimate"
    nodes.append(Node("drive", SUBTRACT, {"command": "in.command", "estimate": estimate}))
    wired: dict[str, Any] = {"command": "drive.applied", "load": "in.load"}
    nodes.append(Node("plant", link(plant, NoFriction()), wired, plant.block(PERIOD)))
    schedule = Schedule(tuple(nodes), (Port("command"), Port("load")), PERIOD, len(nodes))
    group = make_group(schedule, 1, slice(0, 1), jit)
    return group.run(np.column_stack([command, load]), [schedule.row("plant.velocity")])[:, 0, 0]


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


# --- the load observer ---------------------------------------------------------------------------------------------------------------


def load_seen(bandwidth: float, decay: float, load: float, n: int, jit: bool = False) -> Array:
    """Return the estimate (n + 1,) of a load that steps at the first tick, under a random command; the motion is solved by hand."""
    travel, speed = response(decay)
    command = np.random.default_rng(5).normal(size=n)
    position, velocity = np.zeros(n + 1), 0.0
    for k, push in enumerate(command + load):
        position[k + 1] = position[k] + speed * velocity / 1.3 + travel * push
        velocity = np.exp(-decay * PERIOD) * velocity + speed * push
    observer = make("observer", "load-observer", bandwidth=bandwidth, model_gain=1.3, model_damping=decay)
    return run_alone(observer, {"position": position, "applied": np.append(0.0, command)}, jit=jit)["disturbance_estimate"]


def response(decay: float) -> tuple[float, float]:
    """Return travel and speed of an axis of gain 1.3 after one tick of a unit load."""
    if decay == 0.0:
        return 0.65 * PERIOD**2, 1.3 * PERIOD
    speed = -1.3 * np.expm1(-decay * PERIOD) / decay
    return (1.3 * PERIOD - speed) / decay, speed


@pytest.mark.parametrize("jit", [False, True])
@pytest.mark.parametrize(("bandwidth", "decay"), [(80.0, 0.0), (400.0, 0.5), (400.0, 30.0), (2000.0, 200.0)])
def test_the_load_is_seen_through_two_poles_whatever_the_command(bandwidth: float, decay: float, jit: bool) -> None:
    """A step d: d_hat = d [1 - p^k - k p^(k - 1) (1 - l_2 c - p)], p = exp(-w_0 T), c the travel in a tick of a unit load."""
    n, load = 60, -0.4
    p, k = np.exp(-bandwidth * PERIOD), np.arange(n + 1)
    travel, speed = response(decay)
    correction = (1.0 - p) ** 2 / (PERIOD * speed)
    expected = load * (1.0 - p**k - k * p ** (k - 1.0) * (1.0 - correction * travel - p))
    assert load_seen(bandwidth, decay, load, n, jit) == pytest.approx(expected, abs=1e-8)


def test_with_both_poles_at_zero_the_load_is_exact_after_two_ticks() -> None:
    """Luenberger: the order is that of the axis with its load, 3, less the one measurement."""
    seen = load_seen(1e9, 20.0, 0.25, 10)
    assert abs(seen[1] - 0.25) > 0.1
    assert seen[2:] == pytest.approx(np.full(9, 0.25), abs=1e-8)


@given(a=POSITIVE, b=POSITIVE, bandwidth=st.floats(1.0, 1e4))
def test_the_linear_load_observer_passes_position_and_command_through_the_same_poles(a: float, b: float, bandwidth: float) -> None:
    model = make("observer", "load-observer", bandwidth=bandwidth, model_gain=a, model_damping=b).linearize()
    for ratio in (0.03, 0.4, 1.0, 5.0):
        s = 1j * ratio * bandwidth
        found = model.c @ np.linalg.solve(s * np.eye(2) - model.a, model.b.astype(complex)) + model.d
        both = bandwidth**2 / (s + bandwidth) ** 2
        assert found[0, 0] == pytest.approx(both * s * (s + b) / a, rel=1e-6)
        assert found[0, 1] == pytest.approx(-both, rel=1e-6)


@pytest.mark.parametrize(("gain", "damping"), [(1.695, 10.1), (0.648, 6.5), (0.9, 25.0)])
@pytest.mark.parametrize("disturbance", [0.0, -0.088])
def test_an_axis_under_its_load_observer_has_the_steady_gain_of_the_model(gain: float, damping: float, disturbance: float) -> None:
    observer = make("observer", "load-observer", bandwidth=200.0, model_gain=0.9, model_damping=12.0)
    n = 4000
    v = velocity_of(make("plant", "rigid-axis", gain=gain, damping=damping), observer, np.full(n, 0.3), np.full(n, disturbance), jit=True)
    assert v[-1] == pytest.approx(0.3 * 0.9 / 12.0, rel=1e-9)


def margin(gain: float, **observer: float) -> float:
    """Return the modulus margin of a position loop with a delay; without numbers, without an observer."""
    axis = Axis("x", make("plant", "rigid-axis", gain=gain, damping=12.0), drive=make("drive", "delayed-saturation", limit=1.0, delay=3e-3))
    kind = "disturbance-observer" if "filter_bandwidth" in observer else "load-observer"
    made = make("observer", kind, model_gain=0.9, model_damping=12.0, **observer) if observer else None
    law = make("controller", "position", velocity_gain=70.0, position_gain=3500.0)
    return sampled_loop(axis, AxisController(law, observer=made), PERIOD).margins().modulus


def test_an_exact_model_leaves_the_position_loop_its_margin() -> None:
    bare = margin(0.9)
    assert margin(0.9, bandwidth=300.0) == pytest.approx(bare, rel=1e-6)
    assert margin(0.9, bandwidth=900.0) == pytest.approx(bare, rel=1e-6)
    assert margin(0.9, bandwidth=150.0, filter_bandwidth=1500.0) < 0.95 * bare
    # A quarter more gain than modelled; both have the same slow part, 1 - s/w_d = 1 - 2 s/w_0.
    assert margin(1.125, bandwidth=300.0) > margin(1.125, bandwidth=150.0, filter_bandwidth=1500.0) > 0.5
    assert margin(0.675, bandwidth=300.0) > 0.5
