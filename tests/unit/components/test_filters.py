"""Filters of the command: against scipy, alone and in the loop."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, make, run_alone
from refusals import refuses
from scipy.signal import bilinear, freqs, freqz
from stages import control, stage

import contourlab as cl
from contourlab.analysis.linear.sampled_loop import lane_loops, sampled_loop
from contourlab.errors import ParameterError, ScenarioError
from contourlab.loop.trials import Trials
from contourlab.scenario import dump, parse_scenario

F, D = 140.0, 0.4
W = 2.0 * math.pi * F
CASES = {
    "notch": ({"damping_ratio": D, "numerator_damping_ratio": 0.05}, [1.0, 0.1 * W, W * W], [1.0, 2.0 * D * W, W * W]),
    "low-pass": ({"damping_ratio": D}, [W * W], [1.0, 2.0 * D * W, W * W]),
    "first-order-low-pass": ({}, [W], [1.0, W]),
}


def notch(**values: Any) -> Any:
    return make("filter", "notch", **{"frequency": F, "damping_ratio": D, "numerator_damping_ratio": 0.05, **values})


def filtered(controller: cl.Controller, *filters: Any) -> cl.Controller:
    named = tuple((f"f{i}", part) for i, part in enumerate(filters))
    return replace(controller, axes={name: replace(mine, filters=named) for name, mine in controller.axes.items()})


@pytest.fixture(scope="module")
def circle() -> cl.Reference:
    return cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 1, PERIOD)


@pytest.mark.parametrize("kind", CASES)
def test_a_filter_is_the_bilinear_one_of_scipy_with_its_frequency_prewarped(kind: str) -> None:
    values, above, below = CASES[kind]
    part = make("filter", kind, frequency=F, **values)
    impulse = np.zeros(4000)
    impulse[0] = 1.0
    response = run_alone(part, {"command": impulse})["command"]
    b, a = bilinear(above, below, W / (2.0 * math.tan(0.5 * W * PERIOD)))
    w = np.array([10.0, 0.5 * W, W, 1.5 * W, 3.0])
    expected = freqz(b, a, w * PERIOD)[1]
    found = np.array([np.sum(response * np.exp(-1j * x * PERIOD * np.arange(impulse.size))) for x in w])
    assert found == pytest.approx(expected, rel=1e-9, abs=1e-12)
    # At its own frequency the sampled filter is the continuous one.
    assert found[2] == pytest.approx(freqs(above, below, [W])[1][0], rel=1e-9)


@pytest.mark.parametrize("kind", CASES)
def test_at_rest_a_filter_passes_its_command_and_all_its_states_equal_it(kind: str) -> None:
    part = make("filter", kind, frequency=F, **CASES[kind][0])
    standing = dict.fromkeys(("input_1", "input_2", "output_1", "output_2"), 0.7)
    assert run_alone(part, {"command": np.full(50, 0.7)}, initial=standing)["command"] == pytest.approx(np.full(50, 0.7), rel=1e-13)
    assert run_alone(part, {"command": np.full(4000, 0.7)})["command"][-1] == pytest.approx(0.7, rel=1e-12)


def test_a_filter_multiplies_the_loop_gain() -> None:
    machine, plain = stage(), control().axes["x"]
    w = np.geomspace(1.0, 0.999 * math.pi / PERIOD, 50)
    axis = machine.axes[0]
    bare = sampled_loop(axis, replace(plain, observer=None), PERIOD)
    parts = (("a", notch()), ("b", make("filter", "low-pass", frequency=400.0)))
    made = sampled_loop(axis, replace(plain, observer=None, filters=parts), PERIOD)
    own = [part.block(PERIOD) for _, part in parts]
    response = np.prod([freqz([x["b0"], x["b1"], x["b2"]], [1.0, x["a1"], x["a2"]], w * PERIOD)[1] for x in own], axis=0)
    assert made.loop_gain(w) == pytest.approx(bare.loop_gain(w) * response, rel=1e-7)


def test_lanes_of_loops_differ_by_the_frequency_of_the_filter() -> None:
    axis, mine = stage().axes[0], filtered(control(), notch()).axes["x"]
    frequencies = np.array([90.0, 140.0, 333.0])
    lanes = lane_loops(axis, mine, PERIOD, 0.0, {"controller.axes.x.filters.f0.frequency": frequencies})
    for radius, phase, frequency in zip(lanes.radius(1.0), lanes.margins().phase, frequencies, strict=True):
        alone = sampled_loop(axis, replace(mine, filters=(("f0", notch(frequency=float(frequency))),)), PERIOD)
        assert radius == pytest.approx(np.abs(alone.poles).max(), rel=1e-9)
        assert phase == pytest.approx(alone.margins().phase, abs=1e-3)


def test_a_filter_does_not_look_like_a_limit(circle: cl.Reference) -> None:
    """Without a limit the integral never waits, although the drive gets another command than the controller gave."""
    found = []
    for way in ("hold", "none"):
        plain = filtered(control(), notch(), make("filter", "low-pass", frequency=200.0))
        axes = {name: replace(mine, controller=mine.controller.replace(anti_windup=way)) for name, mine in plain.axes.items()}
        found.append(cl.simulate(stage(), replace(plain, axes=axes), circle))
    assert np.abs(found[0]["command"] - found[0]["unfiltered_command"]).max() > 0.05
    assert np.allclose(found[0]["axis_position"], found[1]["axis_position"], rtol=0, atol=1e-12)


def test_the_integral_waits_at_the_limit_behind_a_filter() -> None:
    fast = cl.uniform(cl.contour("circle", radius=5e-3), 3.0, 3, PERIOD)
    machine = stage(drive=make("drive", "saturation", limit=0.9), friction=make("friction", "none"))
    largest = {}
    for way in ("hold", "none"):
        plain = filtered(control(False, integral_gain=40.0), notch())
        axes = {name: replace(mine, controller=mine.controller.replace(anti_windup=way)) for name, mine in plain.axes.items()}
        largest[way] = np.abs(cl.simulate(machine, replace(plain, axes=axes), fast)["unfiltered_command"]).max()
    assert largest["hold"] < 0.8 * largest["none"]


def test_batches_and_single_runs_agree(circle: cl.Reference) -> None:
    machine, made = stage(sensor=make("sensor", "ideal")), filtered(control(), notch())
    name, values = "controller.axes.x.filters.f0.frequency", np.array([60.0, 200.0])
    assert name in cl.parameter_names(machine, made)
    batch = cl.simulate_batch(machine, made, circle, {name: values})
    for i, value in enumerate(values):
        alone = cl.judge(cl.simulate(machine, made, circle, {name: float(value)}), circle)
        assert batch.figures["contour_error_rms"][i] == pytest.approx(np.sqrt(np.mean(alone["contour_error"] ** 2)), rel=1e-6)


def test_a_trial_of_learning_keeps_the_commands_before_the_filters(circle: cl.Reference) -> None:
    machine, made = stage(), filtered(control(), notch())
    trial, run = Trials(machine, made, circle).run(None, 0), cl.simulate(machine, made, circle)
    assert np.array_equal(trial.position, run["axis_position"]) and np.array_equal(trial.command, run["unfiltered_command"])
    assert not trial.excess.any()


def test_a_controller_with_new_filters_takes_over_without_a_bump(circle: cl.Reference) -> None:
    machine = stage(sensor=make("sensor", "ideal"))
    plain, other = control(), filtered(control(), notch(), make("filter", "low-pass", frequency=60.0))
    for one, two in ((plain, other), (other, plain)):
        found = cl.simulate(machine, one, circle, changes=[cl.Change(0.37, two)])
        step = np.abs(np.diff(found["applied_command"], axis=0)).max(axis=1)
        assert step[365:385].max() < 1.5 * step[200:365].max()


SCENARIO = """
name = "circle with filters"
machine = "builtin:ghaffari/a3a1"
controller = {file = "builtin:ghaffari/calibrated", axes = {"*" = {filters = FILTERS}}}
[contour]
name = "circle"
radius = "20 mm"
[feed]
law = "uniform"
frequency = "0.5 Hz"
[schemes.plain]
controller.axes."*".filters.slow = "none"
"""
TWO = '{slow = {kind = "low-pass", frequency = "300 Hz"}, deep = {kind = "notch", frequency = "60 Hz"}}'


def test_filters_are_read_in_their_order_and_written() -> None:
    scenario = parse_scenario(SCENARIO.replace("FILTERS", TWO))
    expected = (("slow", make("filter", "low-pass", frequency=300.0)), ("deep", make("filter", "notch", frequency=60.0)))
    assert {mine.filters for mine in scenario.controller.axes.values()} == {expected}
    assert {mine.filters for mine in scenario.case("plain").controller.axes.values()} == {expected[1:]}
    again = parse_scenario(dump(scenario))
    assert again.controller == scenario.controller and again.case("plain").controller == scenario.case("plain").controller


@pytest.mark.parametrize(
    ("filters", "key", "word"),
    [
        ('{deep = {kind = "notch", frequency = "600 Hz"}}', "deep", "500"),
        ('{deep = {kind = "comb", frequency = "60 Hz"}}', "deep.kind", "notch"),
        ('{"6" = {kind = "notch", frequency = "60 Hz"}}', "6", "letters"),
        ('{deep = {kind = "notch"}}', "deep", "frequency"),
    ],
)
def test_faults_are_named(filters: str, key: str, word: str) -> None:
    with refuses(ScenarioError, word) as caught:
        parse_scenario(SCENARIO.replace("FILTERS", filters))
    assert caught.value.key.endswith(f"filters.{key}")  # type: ignore[attr-defined]


def test_a_frequency_above_nyquist_is_refused_in_a_batch(circle: cl.Reference) -> None:
    with refuses(ParameterError, "500", name="notch.frequency"):
        varied = {"controller.axes.x.filters.f0.frequency": np.array([60.0, 510.0])}
        cl.simulate_batch(stage(), filtered(control(), notch()), circle, varied)
