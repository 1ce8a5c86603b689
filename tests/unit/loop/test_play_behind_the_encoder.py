"""Play behind the encoder: against a loop over samples, in blocks, in lanes, and as a cause."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from component_rig import make

import contourlab as cl
from contourlab.components.origin import Origin
from contourlab.errors import ParameterError
from contourlab.features.run.lost_steps import lost_steps
from contourlab.features.run.trust import about_guesses
from contourlab.features.run.verdict import verdict
from contourlab.loop.machine import AxisError
from contourlab.loop.simulate import simulate_blocks
from contourlab.rendering.judgement import Cause
from contourlab.rendering.origins import numbers_of
from contourlab.study import Setting

GAP = 40e-6
PERIOD = 1e-3


def machine(gap: float) -> cl.Machine:
    """Return steppers without steps that follow closely: the play is nearly all of the error."""
    plant = make("plant", "step-drive", natural_frequency=80.0, velocity_feedforward=1.0)
    return cl.Machine("made", tuple(cl.Axis(name, plant, substeps=8, error=AxisError(backlash=gap)) for name in "xy"), PERIOD)


CONTROLLER = cl.Controller(dict.fromkeys("xy", cl.AxisController(make("controller", "steps"))))


def circle() -> cl.Reference:
    return cl.uniform(cl.contour("circle", radius=0.02), 0.25, 2, PERIOD)


def by_hand(position: np.ndarray, gap: float) -> np.ndarray:
    tool = position.copy()
    for column in tool.T:
        left = column[0]
        for k, at in enumerate(column):
            if at - left > 0.5 * gap:
                left = at - 0.5 * gap
            elif left - at > 0.5 * gap:
                left = at + 0.5 * gap
            column[k] = left
    return tool


def test_the_tool_rests_between_two_flanks() -> None:
    run = cl.simulate(machine(GAP), CONTROLLER, circle())
    np.testing.assert_array_equal(run["axis_position"], by_hand(np.asarray(run["position"]), GAP))
    np.testing.assert_array_equal(run["tool_position"], run["axis_position"])
    after = slice(circle().n_sample // 2, None)
    assert np.abs(run["axis_position"] - run["position"])[after].max() == pytest.approx(0.5 * GAP, rel=1e-9)


def test_the_play_goes_on_between_blocks() -> None:
    whole = cl.simulate(machine(GAP), CONTROLLER, circle())["tool_position"]
    blocks = [signals["tool_position"] for signals, _ in simulate_blocks(machine(GAP), CONTROLLER, circle(), block=97)]
    np.testing.assert_array_equal(np.concatenate(blocks), whole)


def test_variants_in_lanes_have_the_play() -> None:
    made: Any = machine(GAP)
    setting = Setting(made, CONTROLLER, circle())
    figures = setting.batch({"axes.x.plant.natural_frequency": np.array([80.0, 40.0])}, ["part_error_max"]).figures["part_error_max"]
    for frequency, figure in zip((80.0, 40.0), figures, strict=True):
        x = replace(made.axes[0], plant=made.axes[0].plant.replace(natural_frequency=frequency))
        judged = cl.judge(cl.simulate(replace(made, axes=(x, made.axes[1])), CONTROLLER, circle()), circle())
        assert figure == pytest.approx(cl.summarise(judged, circle()).part_error.max, abs=1e-7)


def test_the_play_is_the_cause() -> None:
    judged = cl.judge(cl.simulate(machine(GAP), CONTROLLER, circle()), circle())
    answer = verdict(machine(GAP), CONTROLLER, circle(), judged, 1e-3)
    assert answer.passed and answer.causes[0].name == "backlash"
    assert answer.causes[0].contribution == pytest.approx(answer.worst.value, rel=0.3)


def test_an_offset_on_reversal_is_proposed_at_the_price_of_a_run_with_it() -> None:
    limited = replace(machine(GAP), axes=tuple(replace(axis, limits=cl.Limits(acceleration=2.0)) for axis in machine(GAP).axes))
    values = {"backlash_gap": GAP, "backlash_velocity": (2.0 * GAP) ** 0.5, "backlash_acceleration": 2.0}
    offset = replace(CONTROLLER.axes["x"], compensation=make("compensation", "backlash-offset", **values))
    slow = cl.uniform(cl.contour("circle", radius=0.02), 0.02, 2, PERIOD)

    def worst(controller: cl.Controller) -> float:
        return float(cl.summarise(cl.judge(cl.simulate(limited, controller, slow), slow), slow).part_error.max)

    plain, compensated = worst(CONTROLLER), worst(cl.Controller(dict.fromkeys("xy", offset)))
    answer = verdict(limited, CONTROLLER, slow, cl.judge(cl.simulate(limited, CONTROLLER, slow), slow), 1e-6)
    (price,) = [change.part_error for change in answer.changes if "backlash" in change.name]
    assert price == pytest.approx(compensated, rel=1e-9) and price < 0.6 * plain


def test_a_stepper_loses_no_step_in_a_play() -> None:
    plant = make("plant", "stepper", mass=10.0, inertia=1e-4, lead=5e-3, holding_torque=2.2)
    axes = tuple(cl.Axis(name, plant, substeps=8, error=AxisError(backlash=6.0 * plant.full_step)) for name in "xy")
    wide, slow = cl.Machine("made", axes, PERIOD), cl.uniform(cl.contour("circle", radius=0.01), 0.02, 1, PERIOD)
    run = cl.simulate(wide, CONTROLLER, slow)
    assert np.abs(run["axis_position"] - run["position"]).max() == pytest.approx(3.0 * plant.full_step, rel=1e-9)
    assert lost_steps(wide, slow, run) == ()


def test_a_guessed_play_counts_as_a_guess_of_its_axis() -> None:
    made = machine(GAP)
    guessed = replace(made.axes[0], error=AxisError(backlash=GAP, origins={"backlash": Origin("assumed")}))
    causes = [Cause("backlash", 30e-6, 0.75), Cause("geometry", 10e-6, 0.25)]
    numbers = numbers_of(replace(made, axes=(guessed, made.axes[1])), CONTROLLER)
    assert about_guesses(causes, numbers, {"x": 0.1e-6, "y": 40e-6}) == []
    (note,) = about_guesses(causes, numbers, {"x": 40e-6, "y": 0.1e-6})
    assert (note.code, note.values["share"], note.values["numbers"]) == ("CL229", 0.75, ["axes.x.error.backlash"])
    limited = replace(made.axes[0], limits=replace(made.axes[0].limits, acceleration=2.0, origins={"acceleration": Origin("assumed")}))
    numbers = numbers_of(replace(made, axes=(limited, made.axes[1])), CONTROLLER)
    assert about_guesses(causes, numbers, {"x": 40e-6, "y": 0.0}) == []
    (note,) = about_guesses([Cause("lag", 30e-6, 0.75)], numbers, {"x": 40e-6, "y": 0.0})
    assert note.values["numbers"] == ["axes.x.limits.acceleration"]


def test_a_negative_play_is_refused() -> None:
    with pytest.raises(ParameterError):
        AxisError(backlash=-1e-6)
