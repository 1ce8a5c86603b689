"""Calibration with a known answer, within bounds, and reproducible."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from tuned_axes import DAMPING, GAIN, circle, position_control, rigid_stage

from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.components.controller.cascade import Cascade
from contourlab.components.sensor.encoder import Encoder
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.errors import ParameterError
from contourlab.features.tune.objective import Goal, Objective, Problem
from contourlab.features.tune.search import LineRule, line_search, sequential
from contourlab.features.tune.study import Tuned, TuneSettings, tune
from contourlab.feed import uniform
from contourlab.geometry import contour
from contourlab.loop import AxisController, Controller
from contourlab.loop.parameters import with_values
from contourlab.papers.ghaffari.setup import TABLE_2, TABLE_3, Reading, controller, machine
from contourlab.study import Runner, Setting, Space
from contourlab.study.guards import Bounds

FREE = Bounds(gain_margin=0.0, phase_margin=0.0)
BEST = LineRule(plateau="best")
INTEGRAL = Goal.parse("integral")


def searched(names: list[str], bounds: Bounds = FREE, goal: str = "integral", **gains: float) -> Tuned:
    gain, phase = bounds.gain_margin, bounds.phase_margin
    settings = TuneSettings(
        objective=goal, gain_margin=gain, phase_margin=phase, plateau="best", method="sequential", parameter=tuple(names)
    )
    return tune(Setting(rigid_stage(), position_control(**gains), circle()), settings)


@pytest.mark.parametrize("wrong", [0.6, 1.7])
def test_the_feedforward_gain_converges_to_that_of_the_rigid_axis(wrong: float) -> None:
    """Without friction the plant's own gain is the inverse; the tracking error separates the axes. The hold is half a tick late."""
    found = searched(["model_gain"], goal="tracking", model_gain=wrong * GAIN)
    assert found.before.figures["tracking_error_rms"] > 20.0 * found.after.figures["tracking_error_rms"]
    assert list(found.values.values()) == pytest.approx([GAIN] * 2, rel=0.01)


def test_the_damping_of_a_rigid_axis_is_found() -> None:
    found = searched(["model_damping"], goal="tracking", model_damping=0.5 * DAMPING)
    assert found.before.figures["tracking_error_rms"] > 20.0 * found.after.figures["tracking_error_rms"]
    assert list(found.values.values()) == pytest.approx([DAMPING] * 2, rel=0.01)


@pytest.mark.slow
def test_each_step_moves_one_number_and_never_increases_the_error() -> None:
    stage, made = rigid_stage(), position_control(model_gain=0.7, model_damping=4.0)
    space, runner = Space.chosen(stage, made), Runner(Setting(stage, made, circle()))
    values = {number.name: number.value for number in space.numbers}
    path = sequential(Problem.of(runner, INTEGRAL, Bounds(), space), values, LineRule(), passes=2)
    assert [step.variable.name for step in path.steps[: len(space.names)]] == list(space.names)
    reached = [path.steps[0].objective_before, *(step.objective_after for step in path.steps)]
    assert all(later <= earlier for earlier, later in pairwise(reached))
    now = dict(values)
    for step in path.steps:
        assert step.before == now[step.variable.name]
        now[step.variable.name] = step.after
        alone = runner({name: np.array([value]) for name, value in now.items()})
        assert alone["contour_error_integral"][0] == step.objective_after
    assert now == path.values


def test_a_guard_stops_where_the_error_would_fall_further() -> None:
    """The position gain works against a wrong feedforward: the error falls with it up to the margin, and beyond."""
    names, wrong = ["x.position_gain=1 full_scale/mm..500 full_scale/mm"], {"model_gain": 0.5 * GAIN}
    free = searched(names, **wrong)
    kept = searched(names, Bounds(gain_margin=0.0, phase_margin=50.0), **wrong)
    name = next(iter(free.values))
    assert kept.values[name] < free.values[name]
    assert kept.after.figures["contour_error_integral"] > free.after.figures["contour_error_integral"]
    assert kept.path.steps[-1].bound == "margins"
    assert not kept.after.violations
    phase = math.degrees(kept.after.margins["x"].phase)
    assert 50.0 <= phase < 51.0
    assert math.degrees(free.after.margins["x"].phase) < 50.0


def test_the_drive_limits_a_gain() -> None:
    """Encoder counts times the position gain reach the drive: its limit stops the gain before any margin does."""
    stage = rigid_stage()
    coarse = replace(stage, axes=tuple(replace(axis, sensor=Encoder(resolution=4e-6)) for axis in stage.axes))
    made = position_control(model_gain=0.8 * GAIN)
    free_of_margins = {"gain_margin": 0.0, "phase_margin": 0.0, "objective": "integral", "plateau": "best", "method": "sequential"}
    settings = TuneSettings(**free_of_margins, parameter=("x.position_gain=1 full_scale/mm..30 full_scale/mm",))  # type: ignore[arg-type]
    free = tune(Setting(coarse, made, circle()), settings)
    quiet, loud = (one.figures["command_largest"] for one in (free.before, free.after))
    allowed = 0.5 * (quiet + loud)
    assert quiet < allowed
    kept = tune(Setting(coarse, made, circle()), replace(settings, command=allowed))
    assert kept.after.figures["command_largest"] <= allowed * (1.0 + 1e-9)
    assert kept.path.steps[-1].bound.endswith("drive")
    assert not kept.after.violations


@pytest.mark.slow
def test_missing_margins_of_the_start_are_restored_first() -> None:
    settings = TuneSettings(objective="integral", phase_margin=40.0, method="sequential")
    found = tune(Setting(rigid_stage(), position_control(position_gain=60000.0), circle()), settings)
    assert any("phase margin" in words and "axis x" in words for words in found.before.violations)
    assert found.path.steps[0].stage == "repair"
    assert not found.after.violations
    assert all(math.degrees(margins.phase) >= 40.0 for margins in found.after.margins.values())


@pytest.mark.slow
def test_a_number_at_the_end_of_its_range_is_reported_in_every_stage() -> None:
    settings = TuneSettings(objective="integral", phase_margin=40.0, method="sequential")
    found = tune(Setting(rigid_stage(), position_control(position_gain=60000.0), circle()), settings)
    ends = {number.short: number.end(found.values[number.name]) for number in found.space.numbers}
    assert ends["y.velocity_gain"] == ends["x.velocity_gain"] != "" and sum(map(bool, ends.values())) == 2
    for stage in ("repair", "pass 1"):
        moved = [step for step in found.path.steps if step.stage == stage and step.variable.short.endswith("velocity_gain")]
        assert len(moved) == 2 and all("upper end" in step.bound for step in moved)
    (ended,) = [one for one in found.findings if one.code == "CL602"]
    assert ended.values["parameters"] == ("y.velocity_gain", "x.velocity_gain")
    # The other repaired number stopped at the margins, within its range.
    assert {step.bound for step in found.path.steps if step.stage == "repair" and "position_gain" in step.variable.name} == {"margins"}


@pytest.mark.slow
def test_a_diverging_start_is_repaired() -> None:
    found = tune(Setting(rigid_stage(), position_control(position_gain=3e5), circle()), TuneSettings(width=10.0, budget=400))
    assert found.before.run is None and "diverges" in found.before.violations[0]
    assert {step.variable.short.partition(".")[0] for step in found.path.steps if step.stage == "repair"} == {"x", "y"}
    assert found.after.run is not None and not found.after.violations
    lost = tune(
        Setting(rigid_stage(), position_control(position_gain=5e6), circle()), TuneSettings(parameter=("x.model_gain",), budget=100)
    )
    assert "diverges" in lost.after.violations[0]


@pytest.mark.slow
def test_a_start_beyond_repair_is_replaced_by_placed_poles() -> None:
    """Poles a hundred times too fast, out of reach of the ranges: the search starts again from placed poles."""
    gains = Cascade.tune(20_000.0, 1.0, 1.2, 9.0)
    part = AxisController(controller=Cascade(**gains), velocity=FilteredDifference(bandwidth=1500.0))
    found = tune(Setting(rigid_stage(), Controller(dict.fromkeys("xy", part)), circle()), TuneSettings(budget=200))
    assert found.before.violations and not found.after.violations


def test_violated_margins_are_reported() -> None:
    settings = TuneSettings(parameter=("x.model_gain",), phase_margin=60.0, budget=100)
    found = tune(Setting(rigid_stage(), position_control(position_gain=60000.0), circle()), settings)
    assert any("phase margin" in words and "axis x" in words for words in found.after.violations)


def test_margins_of_the_result_are_those_of_the_loop() -> None:
    found = searched(["x.velocity_gain"], Bounds())
    stage, made = with_values(rigid_stage(), position_control(), found.values)
    assert found.controller == made
    loop = sampled_loop(stage.axes[0], made.axes["x"], stage.servo_period)
    assert found.after.margins["x"] == loop.margins()


@pytest.mark.parametrize("method", ["sequential", "both"])
@pytest.mark.slow
def test_the_result_is_the_same_on_any_number_of_threads(method: str) -> None:
    names = ("model_gain", "model_damping")
    made = position_control(model_gain=0.8, model_damping=5.0)
    one, two = (
        tune(
            Setting(rigid_stage(), made, circle()),
            TuneSettings(parameter=names, method=method, budget=800, workers=count),
        )
        for count in (1, 2)
    )
    assert one.values == two.values
    assert one.after.figures == two.after.figures
    assert [step.objective_after for step in one.path.steps] == [step.objective_after for step in two.path.steps]


@pytest.mark.slow
def test_the_global_search_is_no_worse_and_keeps_the_bounds() -> None:
    made = position_control(model_gain=0.8, model_damping=5.0)
    found = tune(Setting(rigid_stage(), made, circle()), TuneSettings(method="both", budget=1500))
    assert found.global_result is not None
    # One of its starts is that answer, normalised and back.
    assert found.global_result.objective <= found.path.steps[-1].objective_after * (1.0 + 1e-9)
    assert not found.after.violations
    assert len(found.global_result.search.per_start) == 5


def test_a_single_run_and_the_lanes_agree_on_the_result() -> None:
    found = searched(["model_gain"], model_gain=0.7)
    runner = Runner(Setting(rigid_stage(), found.controller, circle()), ("command_energy",))
    lanes = runner({name: np.array([value]) for name, value in found.values.items()})
    for name in ("contour_error_integral", "contour_error_max", "command_energy", "command_largest", "limited_share"):
        assert found.after.figures[name] == pytest.approx(lanes[name][0], rel=1e-6, abs=1e-12), name


def test_an_unlimited_drive_never_saturates() -> None:
    """Its commands are large numbers, in the plant's own unit."""
    gains = {"velocity_gain": 4e4, "position_gain": 1.5e6, "model_gain": 1e-3 * GAIN}
    settings = TuneSettings(parameter=("x.integral_gain",), gain_margin=0.0, phase_margin=0.0, budget=100)
    found = tune(Setting(rigid_stage(1e-3 * GAIN, 1e-3 * GAIN), position_control(**gains), circle()), settings)
    assert found.before.figures["command_largest"] > 100.0
    assert found.before.figures["limited_share"] == found.after.figures["limited_share"] == 0.0
    assert not found.after.violations


def test_machine_parameters_cannot_be_calibrated() -> None:
    with pytest.raises(ParameterError, match=r"x\.plant\.gain.*controller"):
        searched(["x.plant.gain"])


@pytest.mark.slow
def test_with_unreachable_margins_a_placed_start_still_works() -> None:
    """Some fractions of the fastest poles cannot be placed; they are skipped."""
    reading = Reading()
    settings = TuneSettings(start="placed", parameter=("3.integral_gain",), gain_margin=50.0, plateau="best", budget=100)
    laps = uniform(contour("circle", radius=0.02), 0.5, 2, 1e-3)
    found = tune(Setting(machine(1, reading), controller(1, TABLE_3, reading), laps), settings)
    assert any("gain margin" in words for words in found.after.violations)


def test_weights_refer_to_figures_relative_to_the_start() -> None:
    stage, made = rigid_stage(), position_control(model_gain=0.8)
    name = "controller.axes.x.controller.model_gain"
    goal = Goal.parse("integral=1,energy=0.5")
    judged = Objective(Runner(Setting(stage, made, circle())), goal, {name: 0.8})({name: np.array([0.8, 1.2])})
    assert judged.value[0] == pytest.approx(1.5)
    parts = judged.figures
    energy, error = (parts[key][1] / parts[key][0] for key in ("command_energy", "contour_error_integral"))
    assert judged.value[1] == pytest.approx(error + 0.5 * energy)


@pytest.mark.parametrize("plateau", ["robust", "largest"])
def test_on_a_plateau_the_rule_decides(plateau: str) -> None:
    """With the right feedforward the gains hardly matter, so the rule chooses."""
    stage, made = rigid_stage(), position_control(model_gain=0.9 * GAIN)
    space = Space.chosen(stage, made, ["x.integral_gain"])
    values, problem = {space.names[0]: 5.0}, Problem.of(Runner(Setting(stage, made, circle())), INTEGRAL, Bounds(), space)
    best = line_search(problem, space.numbers[0], values, BEST)
    found = line_search(problem, space.numbers[0], values, LineRule(plateau=plateau, within=0.2))
    assert found.objective_after <= 1.2 * best.objective_after * (1.0 + 1e-12)
    good = found.values[found.objectives <= min(1.2 * found.objectives.min(), found.objective_before)]
    if plateau == "largest":
        assert found.after == good.max()
    else:
        assert found.after == good.min()  # less integral gain, more margin


@pytest.mark.slow
def test_placed_poles_keep_the_margins_and_serve_as_a_start() -> None:
    made = position_control(position_gain=100.0)
    found = tune(Setting(rigid_stage(), made, circle()), TuneSettings(start="placed", budget=400))
    assert not found.after.violations
    assert found.space.numbers[0].value != made.axes["y"].controller.values()["velocity_gain"]
    assert found.before.figures["contour_error_integral"] > 5.0 * found.after.figures["contour_error_integral"]


@pytest.mark.parametrize(
    ("settings", "said"),
    [
        ({"method": "magic"}, "sequential, global, both"),
        ({"start": "here"}, "scenario, placed"),
        ({"passes": 0}, "passes"),
        ({"starts": 0}, "starts"),
        ({"budget": 1}, "budget"),
        ({"width": 1.0}, "width"),
    ],
)
def test_settings_out_of_range_are_refused(settings: dict[str, object], said: str) -> None:
    with pytest.raises(ParameterError, match=said):
        TuneSettings(**settings)  # type: ignore[arg-type]


@pytest.mark.parametrize("text", ["", "speed", "integral=0", "integral=x", "integral,integral", "integral=nan"])
def test_invalid_objectives_are_refused(text: str) -> None:
    with pytest.raises(ParameterError, match="objective"):
        Goal.parse(text)


@pytest.mark.parametrize("bounds", [{"gain_margin": -1.0}, {"phase_margin": 91.0}, {"limited": 1.1}, {"command": 0.0}])
def test_bounds_out_of_range_are_refused(bounds: dict[str, float]) -> None:
    with pytest.raises(ParameterError, match=next(iter(bounds))):
        Bounds(**bounds)


def test_a_controller_without_tunable_parameters_is_refused() -> None:
    nothing = position_control(velocity_gain=0.0, position_gain=0.0, integral_gain=0.0, model_gain=math.inf, model_damping=0.0)
    with pytest.raises(ParameterError, match="bounds"):
        tune(Setting(rigid_stage(), nothing, circle()))


@pytest.mark.slow
def test_tenfold_on_the_paper_s_circle() -> None:
    reading = Reading()
    stage, made = machine(1, reading), controller(1, TABLE_2, reading)
    found = tune(Setting(stage, made, uniform(contour("circle", radius=0.02), 0.5, 2, reading.servo_period)), TuneSettings(budget=1000))
    assert found.before.figures["contour_error_integral"] == pytest.approx(272.9e-6, rel=1e-3)
    assert found.before.figures["contour_error_integral"] > 10.0 * found.after.figures["contour_error_integral"]
    assert not found.after.violations
