"""Trials equal `simulate` with the judge; the model for learning is that of the loop."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from learning_stages import PERIOD, control, full_stage, make, proportional, rough, stage, there_and_rest

import contourlab as cl
from contourlab.errors import ComponentError, ParameterError
from contourlab.features.learn import input_response
from contourlab.loop import Learned
from contourlab.loop.trials import Trials, feedforward_command
from contourlab.metrics.judge import judge


@pytest.fixture(scope="module")
def circle() -> cl.Reference:
    return cl.uniform(cl.contour("circle", radius=0.02), 0.5, 1, PERIOD)


@pytest.mark.parametrize("target", ["command", "reference"])
@pytest.mark.parametrize("jit", [True, False])
def test_a_trial_is_a_simulation_to_the_last_bit(target: str, jit: bool) -> None:
    machine, controller = full_stage()
    circle = cl.uniform(cl.contour("circle", radius=0.01), 4.0, 1, PERIOD)
    table = 1e-3 * np.sin(np.arange(circle.n_sample)[:, None] * (0.01, 0.013))
    trials = Trials(machine, controller, circle, target=target, seed=3, jit=jit)
    for trial, given in ((0, None), (2, table), (1, table)):
        run = trials.run(given, trial)
        learned = Learned(**{target: np.zeros_like(table) if given is None else given})
        whole = cl.simulate(machine, controller, circle, seed=3, jit=jit, learned=learned, trial=trial)
        assert np.array_equal(run.position, whole["axis_position"])
        assert np.array_equal(run.measured, whole["position"])
        assert np.array_equal(run.command, whole["command"])
        assert np.array_equal(run.estimate, whole["disturbance_estimate"])
        assert run.command - run.excess == pytest.approx(np.clip(whole["command"], -0.6, 0.6), abs=1e-12)


def test_the_trial_number_selects_the_noise(circle: cl.Reference) -> None:
    trials = Trials(*full_stage(), circle, seed=3)
    one, other, again = (trials.run(None, i).measured for i in (1, 2, 1))
    assert np.array_equal(one, again)
    assert not np.array_equal(one, other)


def test_the_figures_are_those_of_the_exact_judge() -> None:
    machine, controller = full_stage()
    for path in (cl.contour("ellipse"), cl.contour("square"), cl.contour("butterfly")):
        reference = cl.uniform(path, 0.25, 1, PERIOD)
        run = Trials(machine, controller, reference, vector=True).run(None, 0)
        exact = judge(cl.simulate(machine, controller, reference), reference)
        size = np.abs(exact["contour_error"])
        assert run.contour_rms == pytest.approx(np.sqrt(np.mean(size**2)), rel=1e-12)
        assert run.contour_max == pytest.approx(size.max(), rel=1e-12)
        assert run.contour_mean == pytest.approx(size.mean(), rel=1e-12)
        assert np.abs(run.contour_error - exact["contour_error"]).max() < 1e-15


def test_the_vector_leads_from_the_measured_position_to_the_path() -> None:
    machine, controller = full_stage()
    reference = cl.uniform(cl.contour("ellipse"), 0.25, 1, PERIOD)
    trials = Trials(machine, controller, reference, vector=True)
    run = trials.run(None, 0)
    foot = reference.path.foot_point(run.measured, trials.arc_length, 5e-3)
    assert run.contour_vector == pytest.approx(foot.position - run.measured, abs=1e-15)


def test_a_machine_with_an_error_map_is_judged_at_the_tool(circle: cl.Reference) -> None:
    plain = stage()
    bent = replace(plain, squareness={("x", "y"): 1e-3})
    run = Trials(bent, control(), circle).run(None, 0)
    exact = judge(cl.simulate(bent, control(), circle), circle)
    assert run.contour_rms == pytest.approx(np.sqrt(np.mean(exact["contour_error"] ** 2)), rel=1e-9)
    assert run.tool[:, 0] == pytest.approx(run.position[:, 0] + 1e-3 * run.position[:, 1])
    assert run.contour_max > 1.005 * Trials(plain, control(), circle).run(None, 0).contour_max


def test_a_diverging_trial_says_where(circle: cl.Reference) -> None:
    trials = Trials(stage(), control(), circle)
    run = trials.run(np.full((circle.n_sample, 2), 1e4), 1)
    assert not run.status.ok
    assert "following error" in run.status.reason
    assert np.isnan(run.contour_rms)
    assert trials.run(None, 2).status.ok


def test_a_controller_that_cannot_learn_is_named(circle: cl.Reference) -> None:
    class Deaf(type(control().axes["x"].controller)):  # type: ignore[misc]
        """A controller without a port for the learned command."""

        inputs = tuple(port for port in type(control().axes["x"].controller).inputs if port.name != "feedforward")
        kind = ""

    deaf = cl.Controller({name: cl.AxisController(Deaf(**control().axes["x"].controller.values())) for name in "xy"})
    with pytest.raises(ParameterError, match="feedforward"):
        Trials(stage(), deaf, circle)


# --- prior knowledge -----------------------------------------------------------------------------------------------------------------


def test_the_feedforward_of_a_model_is_found_and_pure_feedback_has_none() -> None:
    """Eq (15) of Ghaffari & Ulsoy without errors: (r_a + b' r_v)/a'."""
    reference = there_and_rest()
    block = reference.block(0, reference.n_sample)
    gains = {"velocity_gain": 70.0, "position_gain": 2800.0, "integral_gain": 12.0, "model_gain": 0.8, "model_damping": 20.0}
    machine = cl.Machine("one", (cl.Axis("x", make("plant", "rigid-axis", gain=1.0)),), PERIOD)
    fed = cl.Controller({"x": cl.AxisController(make("controller", "position", **gains))})
    expected = (block.acceleration + 20.0 * block.velocity) / 0.8
    assert feedforward_command(machine, fed, reference) == pytest.approx(expected, abs=1e-9)
    assert not feedforward_command(stage(1), proportional(1), reference).any()


@pytest.mark.parametrize("observer", [False, True])
def test_learning_with_a_wrong_feedforward_still_converges_to_zero_error(observer: bool) -> None:
    """If the feedforward or the observer's estimate counted as feedback, the table would settle where they cancel, with an error."""
    gains = {"velocity_gain": 70.0, "position_gain": 2800.0, "integral_gain": 0.0, "model_gain": 0.5, "model_damping": 25.0}
    watch = make("observer", "disturbance-observer", bandwidth=60.0, model_gain=0.8, model_damping=25.0) if observer else None
    machine = cl.Machine("one", (cl.Axis("x", make("plant", "rigid-axis", gain=1.0, damping=6.0)),), PERIOD)
    loop = cl.Controller({"x": cl.AxisController(make("controller", "position", **gains), observer=watch)})
    law = make("learning", "zero-phase", gain=0.5, half_width=3, passes=2)
    from contourlab.features.learn import Stopping, learn

    run = learn(machine, loop, there_and_rest(), law, trials=40, stopping=Stopping(improvement=0.0))
    assert run.trials[-1].tracking < 1e-3 * run.trials[0].tracking


# --- the model -----------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("target", ["command", "reference"])
@pytest.mark.parametrize("kind", ["plain", "delayed", "observed"])
def test_the_response_to_a_table_is_that_of_a_run(target: str, kind: str) -> None:
    parts: dict[str, Any] = {"drive": make("drive", "delayed-saturation", delay=15.4e-3)} if kind == "delayed" else {}
    machine, controller = stage(1, **parts), control(1)
    if kind == "observed":
        machine = cl.Machine("one", (cl.Axis("x", make("plant", "rigid-axis", gain=1.0, damping=6.0)),), PERIOD)
        loop = cl.AxisController(
            make("controller", "position", velocity_gain=70.0, position_gain=2800.0, integral_gain=12.0),
            make("velocity", "filtered-difference", bandwidth=800.0),
            make("observer", "disturbance-observer", bandwidth=100.0, filter_bandwidth=2000.0, model_gain=0.8, model_damping=25.0),
        )
        controller = cl.Controller({"x": loop})
    reference = there_and_rest()
    n, rng = reference.n_sample, np.random.default_rng(2)
    size = 1e-2 if target == "command" else 1e-4
    table = size * rng.normal(size=(n, 1))
    moved = [
        cl.simulate(machine, controller, reference, learned=Learned(**{target: values}))["position"] for values in (np.zeros((n, 1)), table)
    ]
    response = input_response(machine, controller, target, n)
    expected = np.convolve(table[:, 0], response[:, 0])[:n]
    np.testing.assert_allclose((moved[1] - moved[0])[:, 0], expected, rtol=0.0, atol=1e-9 * np.abs(expected).max())


def test_an_unstable_loop_has_no_response() -> None:
    with pytest.raises(ComponentError, match="unstable"):
        input_response(stage(1), proportional(1, time_constant=1e-4), "command", 100)


def test_the_rough_motion_is_at_rest_at_both_ends() -> None:
    position = rough().block(0, rough().n_sample).position
    assert np.ptp(position[:500]) == 0.0
    assert np.ptp(position[-500:]) == 0.0
