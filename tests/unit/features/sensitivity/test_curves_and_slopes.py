"""Curves, local sensitivities and saved runs, against closed forms and single runs."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from modelled import Modelled

from contourlab.components.controller.position import PositionController
from contourlab.components.friction.laws import NoFriction
from contourlab.components.ideal import IdealSensor
from contourlab.errors import ParameterError
from contourlab.features.sensitivity.curves import curves, local
from contourlab.features.sensitivity.options import Plan
from contourlab.features.sensitivity.study import distributions, ranking, sensitivity_study, verdict
from contourlab.feed import uniform
from contourlab.geometry import contour
from contourlab.loop import AxisController, Controller, Machine, simulate
from contourlab.metrics.figures import summarise
from contourlab.metrics.judge import judge as judged
from contourlab.papers.ghaffari.setup import TABLE_3, Reading, controller, machine
from contourlab.study import DesignVariable, Runner, Setting, Space
from contourlab.study.checkpoint import Checkpoint
from contourlab.study.runner import CHUNK, Columns

KEY = "contour_error_integral"
READING = Reading()
MACHINE, CONTROLLER = machine(1, READING), controller(1, TABLE_3, READING)
REFERENCE = uniform(contour("circle", radius=0.02), 0.5, 2, READING.servo_period)
GAINS = Space.chosen(MACHINE, CONTROLLER, ["3.model_gain", "3.position_gain"], 2.0)


def number(name: str, value: float, low: float, high: float, logarithmic: bool = True) -> DesignVariable:
    return DesignVariable(f"controller.axes.x.controller.{name}", value, low, high, logarithmic=logarithmic)


PLANE = Space((number("a", 2.0, 0.5, 8.0), number("b", 3.0, 1.0, 9.0)))


def around(value: float) -> Space:
    """Return `PLANE` with another start value of its first variable."""
    first, *others = PLANE.numbers
    return Space((replace(first, value=value), *others))


def model(columns: Columns) -> dict[str, np.ndarray]:
    """A product of powers that fails beyond a = 6: J = a^2 / b + a b."""
    a, b = columns.values()
    value = np.where(a > 6.0, np.nan, a**2 / b + a * b)
    return {KEY: value}


def test_slopes_and_interactions_are_the_derivatives() -> None:
    a, b = 2.0, 3.0
    figure = a**2 / b + a * b
    found = local(PLANE, Modelled(model).judge(KEY))
    slopes = [one.sensitivity for one in found.slopes]
    assert slopes == pytest.approx([(2 * a / b + b) * a / figure, (-(a**2) / b**2 + a) * b / figure], rel=1e-4)
    matrix = np.array([[2 / b * a * a, (-2 * a / b**2 + 1) * a * b], [0, 2 * a**2 / b**3 * b * b]]) / figure
    matrix[1, 0] = matrix[0, 1]
    np.testing.assert_allclose(found.interactions, matrix, rtol=5e-3)
    assert not any(one.doubt for one in found.slopes) and all(one.step <= 0.02 for one in found.slopes)


def test_a_corner_is_reported() -> None:
    found = local(Space(PLANE.numbers[:1]), lambda columns: 1.0 + 3.0 * np.abs(next(iter(columns.values())) - 2.0)).slopes[0]
    assert found.doubt is not None and found.doubt.code == "CL672" and found.sensitivity == pytest.approx(0.0, abs=1e-9)
    assert (found.below, found.above) == (pytest.approx(-6.0), pytest.approx(6.0))


def test_a_quantised_figure_is_reported() -> None:
    """The figure has steps as coarse as the changes: no two step sizes agree."""
    noisy = local(Space(PLANE.numbers[:1]), lambda columns: 1.0 + 0.3 * np.sin(2e4 * next(iter(columns.values())) ** 2)).slopes[0]
    assert noisy.doubt is not None and noisy.doubt.code == "CL673"


def test_a_number_on_its_bound_and_a_failing_one_are_reported() -> None:
    judge = Modelled(model).judge(KEY)
    found = local(replace(PLANE, numbers=(replace(PLANE.numbers[0], least=2.0, most=9.0), *PLANE.numbers[1:])), judge)
    assert np.isnan(found.slopes[0].sensitivity) and found.slopes[0].doubt is not None and found.slopes[0].doubt.code == "CL670"
    assert np.isfinite(found.slopes[1].sensitivity) and np.isnan(found.interactions[0, 1])
    near = local(around(5.9), judge)
    assert near.slopes[0].doubt is not None and near.slopes[0].doubt.code == "CL671"


def test_a_curve_has_its_minimum_and_its_flat_and_failed_segments() -> None:
    judge = Modelled(model).judge(KEY)
    first, second = curves(PLANE, judge, 41)
    assert second.minimum is not None
    # dJ/db = 0 at b = sqrt(a)
    assert second.minimum.value == pytest.approx(np.sqrt(2.0), abs=second.minimum.within) and not second.minimum.bound
    assert first.minimum is not None and first.minimum.bound == "lower"
    assert len(first.failed) == 1 and first.failed[0].last and first.failed[0].low == pytest.approx(6.1, abs=0.3)
    assert np.isnan(first.figures[first.values > 6.0]).all()
    level = curves(Space(PLANE.numbers[:1]), lambda columns: 1.0 + np.exp(-3.0 * next(iter(columns.values()))), 41)[0]
    assert level.flat is not None and level.flat.last and level.flat.low == pytest.approx(1.0, abs=0.05)
    with pytest.raises(ParameterError, match="5 or more"):
        Plan(values=4)


def test_a_curve_consists_of_single_runs() -> None:
    """Compiled lanes against one run at a time under the exact judge."""
    runs = Runner(Setting(MACHINE, CONTROLLER, REFERENCE))
    curve = curves(GAINS, runs.judge(KEY), 5)[0]
    for k in (0, 3):
        value = float(curve.values[k])
        part = CONTROLLER.axes["3"]
        changed = replace(part, controller=part.controller.replace(model_gain=value))
        made = replace(CONTROLLER, axes={**CONTROLLER.axes, "3": changed})
        run = judged(simulate(MACHINE, made, REFERENCE), REFERENCE)
        assert curve.figures[k] == pytest.approx(summarise(run, REFERENCE).contour_error.integral, rel=1e-6)


def test_contour_error_of_a_circle_is_linear_in_a_mismatch() -> None:
    """Two equal ideal axes under a soft loop: the radius error is proportional to the feedforward mismatch 1 - a/a'."""
    axes = tuple(
        replace(axis, plant=MACHINE.axes[0].plant, friction=NoFriction(), sensor=IdealSensor(), name=name)
        for axis, name in zip(MACHINE.axes, "xy", strict=True)
    )
    gain, damping = axes[0].plant.values()["gain"], axes[0].plant.values()["damping"]
    period, feed = 1e-4, 0.5
    stage = Machine("equal", axes, period)
    law = PositionController(position_gain=1.0, velocity_gain=0.0, integral_gain=0.0, model_gain=gain, model_damping=damping)
    made = Controller({name: AxisController(law) for name in "xy"})
    reference = uniform(contour("circle", radius=0.02), feed, 4, period)
    name = "controller.axes.x.controller.model_gain"
    judge = Runner(Setting(stage, made, reference, moving=True)).judge(KEY)
    values = gain * np.array([1.05, 1.1, 1.2])
    columns = {name: values, name.replace(".x.", ".y."): values}
    figures = judge(columns)
    shares = 1.0 - gain / values
    np.testing.assert_allclose(figures / figures[1], shares / shares[1], rtol=0.02)


def test_saved_runs_are_reused_only_for_the_same_study(tmp_path: Path) -> None:
    calls: list[int] = []

    def counted(columns: Columns) -> dict[str, np.ndarray]:
        calls.append(len(next(iter(columns.values()))))
        return model(columns)

    columns = {name: np.linspace(1.0, 5.0, CHUNK + 7) for name in PLANE.names}
    first = Modelled(counted, Checkpoint(tmp_path, "one"))
    figures = first(columns)[KEY]
    assert (first.runs, first.reused, calls) == (CHUNK + 7, 0, [CHUNK, 7])
    again = Modelled(counted, Checkpoint(tmp_path, "one"))
    np.testing.assert_array_equal(again(columns)[KEY], figures)
    assert (again.runs, again.reused) == (0, CHUNK + 7)
    other = Modelled(counted, Checkpoint(tmp_path, "another"))
    other(columns)
    assert other.runs == CHUNK + 7 and other.store is not None and other.store.others == 1


def test_an_interrupted_study_continues_with_the_same_result(tmp_path: Path) -> None:
    plan = Plan(parts=("curves", "sobol"), base=512, values=11)
    drawn = distributions(PLANE, "log-uniform")
    whole = sensitivity_study(PLANE, Modelled(model), plan, drawn, 1e3)
    done = 0

    def stopped(columns: Columns) -> dict[str, np.ndarray]:
        nonlocal done
        done += len(next(iter(columns.values())))
        if done > 1200:
            raise KeyboardInterrupt
        return model(columns)

    with pytest.raises(KeyboardInterrupt):
        sensitivity_study(PLANE, Modelled(stopped, Checkpoint(tmp_path, "m")), plan, drawn, 1e3)
    runs = Modelled(model, Checkpoint(tmp_path, "m"))
    resumed = sensitivity_study(PLANE, runs, plan, drawn, 1e3)
    assert runs.reused > 1000
    assert whole.sobol is not None and resumed.sobol is not None
    np.testing.assert_array_equal(resumed.sobol.total, whole.sobol.total)
    np.testing.assert_array_equal(resumed.sobol.total_interval, whole.sobol.total_interval)


def test_threads_change_nothing() -> None:
    found = []
    for threads in (1, 3):
        runs = Runner(Setting(MACHINE, CONTROLLER, REFERENCE), threads=threads)
        found.append(sensitivity_study(GAINS, runs, Plan(parts=("local", "sobol"), base=16), distributions(GAINS), 0.1))
    one, three = found
    assert one.local is not None and three.local is not None and one.sobol is not None and three.sobol is not None
    np.testing.assert_array_equal(one.local.interactions, three.local.interactions)
    np.testing.assert_array_equal(one.sobol.total, three.sobol.total)


def test_conclusions_name_their_measure() -> None:
    """Each of the four parts alone gives the same numbers."""
    flat = Space((*PLANE.numbers, number("c", 1.0, 0.5, 2.0)))

    def three(columns: Columns) -> dict[str, np.ndarray]:
        a, b, c = columns.values()
        return {KEY: a + b + 1e-4 * c}

    grounds = {"curves": "change over its curve", "local": "local sensitivity", "morris": "mu*", "sobol": "total index"}
    for part, ground in grounds.items():
        study = sensitivity_study(flat, Modelled(three), Plan(parts=(part,), base=64), distributions(flat), 1e3)
        order = ranking(study)
        assert order.measure == ground and set(order.matter) == {"x.a", "x.b"} and set(order.negligible) == {"x.c"}
        found = {one.code: one.values for one in verdict(study)}
        assert found["CL656"]["measure"] == ground and set(found["CL656"]["parameters"]) == {"x.a", "x.b"}
        assert found["CL660" if part == "local" else "CL659"]["parameters"] == ("x.c",)


def test_failures_are_reported() -> None:
    study = sensitivity_study(PLANE, Modelled(model), Plan(parts=("curves", "sobol"), base=64), distributions(PLANE, "log-uniform"), 1e3)
    assert study.sobol_sample is not None and study.sobol_sample.failed > 0
    (failed,) = [one for one in verdict(study) if one.code == "CL674"]
    assert (failed.place, failed.values["failed"]) == ("Sobol", study.sobol_sample.failed)
    assert failed.values["runs"] == len(study.sobol_sample.values)


def test_a_failing_nominal_run_has_no_sensitivities() -> None:
    with pytest.raises(ParameterError, match="successful"):
        sensitivity_study(around(7.0), Modelled(model), Plan(parts=("local",)), distributions(PLANE), 1.0)
