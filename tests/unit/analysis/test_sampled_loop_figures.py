"""The sampled loop against runs of the engine, and the known figures of machines."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from one_axis import W_V, T, axis, controller, observer

import contourlab as cl
from contourlab.analysis.linear.sampled_loop import SampledLoop, sampled_loop
from contourlab.components.controller.position import PositionController
from contourlab.components.disturbance.loads import SineLoad
from contourlab.components.drive.saturation import DelayedSaturation
from contourlab.components.plant.plant import MassDamper
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.feed import Reference
from contourlab.geometry import Line, Path
from contourlab.loop.machine import Axis, Controller, Machine
from contourlab.papers.ghaffari.axis_response import axis_response


def shipped() -> tuple[Machine, Controller]:
    case = cl.load_scenario("builtin:demo-part.toml").case("with disturbance observer")
    return case.machine, case.controller


def test_shipped_machine_without_the_delay_of_its_drive() -> None:
    machine, made = shipped()
    bare = replace(machine.axis("x"), drive=machine.axis("x").drive.replace(delay=0.0))
    found = sampled_loop(bare, made.axes["x"], machine.servo_period, machine.carried_mass("x")).margins()
    assert found.gain == pytest.approx(3.35, abs=0.005)


def test_modulus_margins_printed_in_the_documents() -> None:
    """The demo gives 0.70 for the position loop; the page on contouring 0.60 for one at 160 rad/s, and 0.59 for the observer."""

    def least(machine: Machine, made: Controller) -> float:
        loops = [sampled_loop(a, made.axes[a.name], machine.servo_period, machine.carried_mass(a.name)) for a in machine.axes]
        return min(loop.margins().modulus for loop in loops)

    machine, with_observer = shipped()
    alone = cl.load_scenario("builtin:demo-part.toml").case("position loop").controller
    assert f"{least(machine, with_observer):.2f}" == "0.59"
    assert f"{least(machine, alone):.2f}" == "0.70"
    faster = {}
    for name, mine in alone.axes.items():
        law: Any = mine.controller
        placed = PositionController.place(
            natural_frequency=160.0, damping=0.8, pole=160.0, model_gain=law.model_gain, model_damping=law.model_damping
        )
        faster[name] = replace(mine, controller=law.replace(**placed))
    assert f"{least(machine, replace(alone, axes=faster)):.2f}" == "0.60"


def phasor(signal: np.ndarray, turn: np.ndarray) -> complex:
    return complex(signal @ turn) * 2.0 / len(turn)


@pytest.mark.parametrize("hertz", [4.0, 40.0, 160.0])
@pytest.mark.parametrize("structure", ["feedforward", "ipv"])
def test_closed_loop_as_simulated(structure: str, hertz: float) -> None:
    """A sine of 0.1 mm through the whole loop, analysed over its last periods: the same figure, without approximation."""
    w = 2.0 * math.pi * hertz
    made = controller(structure=structure, velocity=FilteredDifference(bandwidth=W_V), seen=observer())
    part = axis(DelayedSaturation(delay=1.4e-3))
    time = np.arange(3000) * T
    wave = 1e-4 * np.sin(w * time)
    reference = Reference.from_samples(wave[:, None], T, Path([Line((-1.0,), (1.0,))]), arc_length=1.0 + wave)
    run = cl.simulate(Machine("one", (part,), T), Controller({"x": made}), reference, jit=False)
    # At the ends of the reference its derivatives are one-sided.
    kept = slice(-600, -100)
    turn = np.exp(-1j * w * time[kept])
    names = ("reference", "reference_velocity", "reference_acceleration", "position")
    r, rv, ra, p = (phasor(run[name][kept, 0], turn) for name in names)
    # Compare with the derivatives as fed, independent of how from_samples makes them.
    found = sampled_loop(part, made, T)
    driven = found.response([w])
    assert p / r == pytest.approx(driven_by(found, w, rv / r, ra / r), rel=1e-6)
    if structure == "ipv":
        assert p / r == pytest.approx(driven.closed_loop[0], rel=1e-6)
        assert driven.modified[0] == pytest.approx(driven.closed_loop[0], rel=1e-12)


def driven_by(loop: SampledLoop, w: float, velocity: complex, acceleration: complex) -> complex:
    """Return position per reference with these ratios of velocity and acceleration, from the matrices of the closed loop."""
    a, b = loop.closed
    mixed = b[:, 0] + velocity * b[:, 1] + acceleration * b[:, 2]
    return complex(loop.state[0] @ np.linalg.solve(np.exp(1j * w * T) * np.eye(len(a)) - a, mixed))


def test_feedforward_uses_the_derivatives_of_the_sine() -> None:
    """r_v = j w r and r_a = -w^2 r: with them the response is the sum of its three paths."""
    loop = sampled_loop(axis(), controller(seen=observer()), T)
    for w in (3.0, 200.0, 3000.0):
        assert loop.response([w]).closed_loop[0] == pytest.approx(driven_by(loop, w, 1j * w, -w * w), rel=1e-9)


@pytest.mark.parametrize("hertz", [5.0, 80.0])
def test_compliance_as_simulated(hertz: float) -> None:
    made = controller(velocity=FilteredDifference(bandwidth=W_V), seen=observer())
    plant = MassDamper(mass=25.0, damping=80.0, force_constant=22.0)
    part = Axis("x", plant, disturbance=SineLoad(amplitude=3.0, frequency=hertz))
    w, still = 2.0 * math.pi * hertz, np.zeros((3000, 1))
    reference = Reference.from_samples(still, T, Path([Line((-1.0,), (1.0,))]), arc_length=np.ones(3000))
    run = cl.simulate(Machine("one", (part,), T), Controller({"x": made}), reference, jit=False)
    turn = np.exp(-1j * w * np.arange(3000) * T)[-600:]
    force = phasor(3.0 * np.sin(w * np.arange(3000) * T)[-600:], turn)
    found = sampled_loop(part, made, T).response([w]).compliance[0]
    assert phasor(run["position"][-600:, 0], turn) / force == pytest.approx(found, rel=1e-6)


def test_a_short_period_converges_to_continuous_time() -> None:
    """All figures of an axis converge to first order."""
    made, w = controller(velocity=FilteredDifference(bandwidth=W_V), seen=observer()), np.geomspace(5.0, 300.0, 7)
    exact = axis_response(axis(), made, w)
    for name in ("closed_loop", "modified", "loop_gain", "compliance", "compensated"):
        gaps = [np.abs(getattr(sampled_loop(axis(), made, t).response(w), name) / getattr(exact, name) - 1.0).max() for t in (2e-5, 1e-5)]
        assert gaps[1] < 2e-2, name
        assert gaps[0] / gaps[1] == pytest.approx(2.0, rel=0.1), name
