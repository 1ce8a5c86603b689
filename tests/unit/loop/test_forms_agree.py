"""Plain Python, machine code and lanes are three forms of one loop and agree for any blocks, groups and threads."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from stages import control, make, stage, with_axis

import contourlab as cl
from contourlab.loop import simulate_blocks

SIGNALS = ("axis_position", "axis_velocity", "position", "command", "applied_command", "contour_error_estimate", "modified_reference")
SMOOTH = {
    "smooth": make("friction", "smooth-coulomb", coulomb=0.05, breakaway=0.07, stribeck_velocity=2e-3, smoothing_velocity=1e-4),
    "lugre": make("friction", "lugre", coulomb=0.05, breakaway=0.07, stribeck_velocity=2e-3, stiffness=1e4, bristle_damping=10.0),
    "sticking": make("friction", "coulomb", coulomb=0.055, breakaway=0.066, stribeck_velocity=2e-3),
    "none": make("friction", "none"),
}


def scale(data: np.ndarray) -> float:
    return float(np.max(np.abs(data))) or 1.0


@pytest.mark.parametrize("friction", SMOOTH)
def test_compiled_equals_plain_python(friction: str, circle: cl.Reference) -> None:
    machine = stage(friction=SMOOTH[friction], sensor=make("sensor", "ideal"))
    short = cl.uniform(circle.path, 1.0, 1, machine.servo_period)
    fast, plain = (cl.simulate(machine, control(), short, jit=jit) for jit in (True, False))
    for name in SIGNALS:
        assert np.max(np.abs(fast[name] - plain[name])) <= 1e-9 * scale(plain[name]), name


def test_lanes_equal_single_runs(machine: cl.Machine, circle: cl.Reference) -> None:
    """With an ideal encoder: quantisation turns a difference of 1e-13 into a whole count."""
    machine = stage(sensor=make("sensor", "ideal"))
    weights = np.linspace(0.0, 0.75, 5)
    batch = cl.simulate_batch(machine, control(), circle, {"controller.coupling.weight": weights}, keep=SIGNALS)
    for i, weight in enumerate(weights):
        single = cl.simulate(machine, replace(control(), coupling=make("coupling", "modified-reference", weight=weight)), circle)
        for name in SIGNALS:
            kept = batch.signals[name][:, :, i].reshape(single[name].shape)
            assert np.max(np.abs(kept - single[name])) <= 1e-9 * scale(single[name]), (name, weight)


def test_a_lane_does_not_depend_on_its_neighbours(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    """Any order, grouping and number of threads gives the same bits, including encoder noise."""
    gains = np.linspace(1.0, 1.3, 70)
    name = "axes.x.plant.gain"
    first = cl.simulate_batch(machine, controller, circle, {name: gains}, threads=1, keep=("axis_position",))
    shuffle = np.random.default_rng(3).permutation(gains.size)
    second = cl.simulate_batch(machine, controller, circle, {name: gains[shuffle]}, threads=2, keep=("axis_position",))
    alone = cl.simulate_batch(machine, controller, circle, {name: gains[17:18]}, keep=("axis_position",))
    assert np.array_equal(first.signals["axis_position"][:, :, shuffle], second.signals["axis_position"])
    assert np.array_equal(first.signals["axis_position"][:, :, 17:18], alone.signals["axis_position"])
    # One or two that are left over from whole groups run alone; all signals stand in one log.
    fewer = {n: cl.simulate_batch(machine, controller, circle, {name: gains[:n]}, keep=("axis_position",)) for n in (1, 2, 3, 17, 18)}
    for n, found in fewer.items():
        assert np.array_equal(first.signals["axis_position"][:, :, :n], found.signals["axis_position"]), n
        assert found.signals["axis_position"].base is not None and found.signals["axis_position"].shape[2] == n
    for figure, values in first.figures.items():
        assert np.array_equal(values[shuffle], second.figures[figure]), figure
        assert all(np.array_equal(values[:n], found.figures[figure]) for n, found in fewer.items()), figure


@pytest.mark.parametrize("block", [1, 7, 64, 1000])
def test_blocks_of_any_size_give_the_same_bits(block: int, machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    machine = with_axis(machine, "x", substeps=3)
    whole = cl.simulate(machine, controller, circle, signals=("tool_position", "command"))
    parts = [found for found, _ in simulate_blocks(machine, controller, circle, signals=("tool_position", "command"), block=block)]
    for name in whole.signals:
        assert np.array_equal(np.concatenate([part[name] for part in parts]), whole[name])


def test_the_past_does_not_depend_on_the_future(machine: cl.Machine, controller: cl.Controller) -> None:
    path = cl.contour("circle", radius=5e-3)
    one, two = (cl.simulate(machine, controller, cl.uniform(path, 1.0, laps, machine.servo_period)) for laps in (1, 2))
    assert np.array_equal(two["axis_position"][: one.n_sample - 1], one["axis_position"][:-1])


def test_the_seed_determines_the_noise(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    runs = [cl.simulate(machine, controller, circle, seed=seed)["position"] for seed in (1, 1, 2)]
    assert np.array_equal(runs[0], runs[1])
    assert not np.array_equal(runs[0], runs[2])


def test_the_streaming_judge_agrees_with_the_exact_one(circle: cl.Reference) -> None:
    machine = stage(sensor=make("sensor", "ideal"))
    batch = cl.simulate_batch(machine, control(), circle, {"controller.coupling.weight": [0.0, 0.5]})
    exact = cl.summarise(cl.judge(cl.simulate(machine, control(), circle), circle), circle)
    assert batch.unsure[1] == 0.0
    for figure, value in (
        ("rms", exact.contour_error.rms),
        ("mean", exact.contour_error.mean),
        ("max", exact.contour_error.max),
        ("signed_mean", exact.contour_error.signed_mean),
        ("integral", exact.contour_error.integral),
    ):
        assert batch.figures[f"contour_error_{figure}"][1] == pytest.approx(value, rel=1e-7), figure


@pytest.mark.parametrize("name", ["ellipse", "lemniscate", "butterfly"])
def test_the_streaming_judge_takes_the_right_branch(name: str) -> None:
    path = cl.contour(name)
    machine, controller = stage(sensor=make("sensor", "ideal")), control(coupled=False)
    reference = cl.uniform(path, 0.1, 1, machine.servo_period)
    batch = cl.simulate_batch(machine, controller, reference, {"axes.x.plant.gain": [1.1]})
    result = cl.judge(cl.simulate(machine, controller, reference), reference)
    assert batch.figures["contour_error_max"][0] == pytest.approx(np.max(np.abs(result["contour_error"])), rel=1e-5)


def test_reused_memory_changes_nothing(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    variants = {"axes.y.plant.damping": np.linspace(5.0, 8.0, 3)}
    first = cl.simulate_batch(machine, controller, circle, variants, keep=("command",))
    wanted = first.signals["command"].copy()
    again = cl.simulate_batch(machine, controller, circle, variants, keep=("command",), reuse=first)
    other = cl.simulate_batch(machine, controller, circle, variants, keep=("command", "position"), reuse=first)
    assert again.log is first.log and other.log is not first.log
    assert np.array_equal(again.signals["command"], wanted)
    assert np.array_equal(other.signals["command"], wanted)


def test_figures_of_a_loop_that_hardly_follows_are_exact() -> None:
    path = cl.contour("butterfly")
    machine = stage(sensor=make("sensor", "ideal"))
    reference = cl.uniform(path, 2.0, 1, machine.servo_period)
    gains = {"controller.axes.x.controller.position_gain": np.array([10.0, 30.0, 3000.0])}
    batch = cl.simulate_batch(machine, control(coupled=False), reference, gains)
    for i, gain in enumerate(gains["controller.axes.x.controller.position_gain"]):
        one = control(coupled=False)
        axis = replace(one.axes["x"], controller=one.axes["x"].controller.replace(position_gain=float(gain)))
        made = replace(one, axes={**one.axes, "x": axis})
        exact = cl.summarise(cl.judge(cl.simulate(machine, made, reference), reference), reference).contour_error
        for figure in ("rms", "mean", "max", "integral", "signed_mean"):
            assert batch.figures[f"contour_error_{figure}"][i] == pytest.approx(getattr(exact, figure), rel=1e-6), (figure, gain)
    assert not batch.unsure.any()


def test_a_variant_starts_where_a_run_starts(circle: cl.Reference) -> None:
    """The velocity filter on the motor's side, too: the place of the motor in the gap is a parameter."""
    plant = make(
        "plant", "two-inertia", motor_inertia=5e-3, load_inertia=4e-3, lead=0.016, stiffness=950.0, shaft_damping=0.1, start_in_gap=0.5
    )
    machine = stage(plant=plant, sensor=make("sensor", "ideal"), friction=make("friction", "none"), substeps=2)
    name, value = "axes.x.plant.backlash_gap", 2e-5
    batch = cl.simulate_batch(machine, control(), circle, {name: [value]}, keep=("velocity",))
    single = cl.simulate(machine, control(), circle, {name: value}, on_failure="return")
    assert np.array_equal(batch.signals["velocity"][0, :, 0], single["velocity"][0])
