"""Inputs of the loop besides the reference, and additive slots: learned tables, feedforward, predictor, correction."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from refusals import refuses
from stages import PERIOD, control, make, stage

import contourlab as cl
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.errors import ParameterError
from contourlab.loop import Learned, simulate_blocks

QUIET: dict[str, Any] = {
    "friction": make("friction", "none"),
    "drive": make("drive", "saturation"),
    "sensor": make("sensor", "ideal"),
}


class Ahead(Component):
    """Requests the position some ticks early."""

    family, kind = "feedforward", "test-ahead"
    inputs = (Port("reference"), Port("reference_ahead"))
    outputs = (Port("reference_shift"),)
    ticks: float = param(default=3.0, minimum=0.0, whole=True, doc="how early")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (inp.reference_ahead - inp.reference,)

    def ahead(self, dt: float) -> int:
        return int(self.ticks)


class Push(Component):
    """A constant command."""

    family, kind = "feedforward", "test-push"
    inputs = (Port("reference"),)
    outputs = (Port("command"),)
    push: float = param(default=0.0, minimum=-10.0, doc="command")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (par.push,)


class Same(Component):
    """A predictor that returns the measured position."""

    family, kind = "predictor", "test-same"
    inputs = (Port("position"), Port("applied"))
    outputs = (Port("position"),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (inp.position,)


class Nudge(Component):
    """A coupling that corrects the commands by constants and reads only some of its inputs."""

    family, kind = "coupling", "test-nudge"
    inputs = (Port("tangent", -1),)
    outputs = (Port("correction", -1),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        still = 0.0 * inp.tangent[0]
        return (), ((0.01 + still, 0.01 + still),)


class Deaf(Component):
    """A controller without external inputs."""

    family, kind = "controller", "test-deaf"
    inputs = (Port("reference"), Port("position"))
    outputs = (Port("command"),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (100.0 * (inp.reference - inp.position),)


def every_axis(whole: cl.Controller, **parts: Any) -> cl.Controller:
    return replace(whole, axes={name: replace(part, **parts) for name, part in whole.axes.items()})


def table(reference: cl.Reference, *values: float) -> np.ndarray:
    return np.tile(np.array(values), (reference.n_sample, 1))


def test_a_learned_command_cancels_an_opposite_load(circle: cl.Reference) -> None:
    machine, controller = stage(**QUIET), control(coupled=False)
    loaded = replace(machine, axes=tuple(replace(a, disturbance=make("disturbance", "constant", force=-0.3)) for a in machine.axes))
    free = cl.simulate(machine, controller, circle)
    held = cl.simulate(loaded, controller, circle, learned=Learned(command=table(circle, 0.3, 0.3)))
    # The observer counts the learned command as part of the drive's command, so it still estimates the load. Compare without it.
    plain = {name: replace(part, observer=None) for name, part in controller.axes.items()}
    without = cl.Controller(plain)
    np.testing.assert_allclose(
        cl.simulate(loaded, without, circle, learned=Learned(command=table(circle, 0.3, 0.3)))["axis_position"],
        cl.simulate(machine, without, circle)["axis_position"],
        atol=1e-13,
    )
    assert np.abs(held["axis_position"] - free["axis_position"]).max() > 1e-9


@pytest.mark.parametrize("hertz", [3.0, 17.0])
def test_a_learned_reference_acts_only_through_the_loop(hertz: float) -> None:
    machine, controller = stage(**QUIET), control(coupled=False)
    still = cl.Reference.from_samples(np.zeros((4000, 2)), PERIOD, cl.contour("circle", radius=1e-3), arc_length=np.zeros(4000))
    t, w = np.arange(4000) * PERIOD, 2.0 * np.pi * hertz
    shift = np.column_stack([1e-6 * np.sin(w * t), 0.0 * t])
    moved = cl.simulate(machine, controller, still, learned=Learned(reference=shift))["axis_position"]
    tail = slice(3000, 4000)
    basis = np.column_stack([np.sin(w * t[tail]), np.cos(w * t[tail])])
    (a, b), *_ = np.linalg.lstsq(basis, moved[tail, 0], rcond=None)
    wanted = sampled_loop(machine.axis("x"), controller.axes["x"], PERIOD).response([w]).modified[0]
    # The state at a sample is that before the command of its tick, so the response refers to the same sample.
    assert abs((a + 1j * b) / 1e-6 - wanted) < 2e-3 * abs(wanted)
    assert np.abs(moved[:, 1]).max() == 0.0


@pytest.mark.parametrize("block", [7, 100, 4096])
def test_looking_ahead_equals_an_earlier_reference(circle: cl.Reference, block: int) -> None:
    machine, controller = stage(**QUIET), control(coupled=False)
    early = every_axis(controller, feedforward=Ahead(ticks=5.0))
    parts = [found for found, _ in simulate_blocks(machine, early, circle, block=block)]
    seen = np.concatenate([part["axis_position"] for part in parts])
    position = circle.block(0, circle.n_sample).position
    index = np.minimum(np.arange(circle.n_sample) + 5, circle.n_sample - 1)
    shift = Learned(reference=position[index] - position)
    wanted = cl.simulate(machine, controller, circle, learned=shift)["axis_position"]
    np.testing.assert_allclose(seen, wanted, atol=1e-15)


def test_additive_terms_add_up(circle: cl.Reference) -> None:
    """A coupling correction, a feedforward and a learned command, each constant, equal one constant."""
    machine, controller = stage(**QUIET), control()
    three = every_axis(replace(controller, coupling=Nudge()), feedforward=Push(push=0.02))
    found = cl.simulate(machine, three, circle, learned=Learned(command=table(circle, 0.03, 0.03)))
    one = cl.simulate(machine, replace(controller, coupling=None), circle, learned=Learned(command=table(circle, 0.06, 0.06)))
    np.testing.assert_allclose(found["axis_position"], one["axis_position"], atol=1e-14)
    np.testing.assert_allclose(found["coupling_command"], 0.01)
    assert "modified_reference" not in found.signals


def test_a_predictor_is_between_sensor_and_controller(circle: cl.Reference) -> None:
    # Without a delay: with a predictor the observer receives the commands before it.
    machine, controller = stage(drive=QUIET["drive"]), control()
    plain = cl.simulate(machine, controller, circle)
    through = cl.simulate(machine, every_axis(controller, predictor=Same()), circle)
    np.testing.assert_array_equal(plain["axis_position"], through["axis_position"])


def test_lanes_learn_like_single_runs(circle: cl.Reference) -> None:
    machine, controller = stage(**QUIET), control()
    rng = np.random.default_rng(3)
    learned = Learned(1e-2 * rng.normal(size=(circle.n_sample, 2)), 1e-7 * rng.normal(size=(circle.n_sample, 2)))
    gains = {"controller.axes.x.controller.position_gain": [2800.0, 3000.0]}
    batch = cl.simulate_batch(machine, controller, circle, gains, learned=learned, keep=("axis_position",))
    single = cl.simulate(machine, controller, circle, learned=learned)
    np.testing.assert_allclose(batch.signals["axis_position"][:, :, 0], single["axis_position"], atol=1e-12)


def test_noise_differs_between_trials_and_repeats_within_one(circle: cl.Reference) -> None:
    machine, controller = stage(), control()
    first, again, second = (cl.simulate(machine, controller, circle, trial=trial)["position"] for trial in (1, 1, 2))
    np.testing.assert_array_equal(first, again)
    assert (first != second).any()
    assert (cl.simulate(machine, controller, circle)["position"] != first).any()


@pytest.mark.parametrize("shape", [(10, 2), (5, 3)])
def test_tables_for_another_motion_are_refused(circle: cl.Reference, shape: tuple[int, int]) -> None:
    with refuses(ParameterError, re.escape(f"{shape}"), name="learned.command"):
        cl.simulate(stage(), control(), circle, learned=Learned(command=np.zeros(shape)))


def test_a_reference_of_another_servo_period_is_refused(circle: cl.Reference) -> None:
    faster = replace(stage(), servo_period=0.25 * PERIOD)
    name = next(iter(cl.parameter_names(faster, control())))
    with refuses(ParameterError, name="reference"):
        cl.simulate(faster, control(), circle)
    with refuses(ParameterError, name="reference"):
        cl.simulate_batch(faster, control(), circle, {name: [1.0]})


@pytest.mark.parametrize("seed", [-1, 1.5, float("nan"), None, "7"])
def test_a_seed_is_a_whole_number(circle: cl.Reference, seed: Any) -> None:
    with refuses(ParameterError, name="seed"):
        cl.simulate(stage(), control(), circle, seed=seed)


@pytest.mark.parametrize("values", [[1.0 + 1.0j], [[1.0, 2.0]], ["a"], [None]])
def test_variants_are_real_numbers_in_one_row(circle: cl.Reference, values: Any) -> None:
    name = next(iter(cl.parameter_names(stage(), control())))
    with refuses(ParameterError, name="variants"):
        cl.simulate_batch(stage(), control(), circle, {name: values})


def test_a_controller_without_an_additive_input_is_named(circle: cl.Reference) -> None:
    machine = stage(**QUIET)
    axes = {**control(coupled=False).axes, "y": cl.AxisController(Deaf())}
    cl.simulate(machine, cl.Controller(axes), circle, on_failure="return")
    with refuses(ParameterError, "feedforward", name="controller.axes.y.controller", value='"test-deaf"'):
        cl.simulate(machine, cl.Controller(axes), circle, learned=Learned(command=table(circle, 0.0, 0.0)))
