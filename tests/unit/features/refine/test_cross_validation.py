"""Intervals for new runs: each log is left out in turn and predicted from the others."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from contourlab.components.controller.lead_lag import LeadLag
from contourlab.components.friction.laws import Coulomb
from contourlab.components.plant.plant import MassDamper
from contourlab.components.sensor.encoder import Encoder
from contourlab.features.measure.measured_path import path_of_samples
from contourlab.features.refine.log_run import LogRun, log_run
from contourlab.features.refine.study import RefineSettings, cross_validated, new_run_factor, refine
from contourlab.feed import Reference
from contourlab.loop import Axis, AxisController, Controller, Machine, simulate
from contourlab.loop.parameters import with_values
from contourlab.result import Result, Signal

PERIOD = 1e-3
SETTINGS = RefineSettings(starts=1, rounds=1)
WANTED = ("axes.*.plant.damping", "axes.*.friction.coulomb")
GAIN = "controller.axes.x.controller.gain"


def parts() -> tuple[Machine, Controller]:
    def axis(name: str) -> Axis:
        plant = MassDamper(mass=50.0, damping=400.0, force_constant=100.0)
        return Axis(name, plant, Coulomb(coulomb=60.0), sensor=Encoder(resolution=1e-7))

    gains = LeadLag.design(np.radians(60.0), 60.0, 2.0, 8.0)
    return Machine("table", (axis("x"), axis("y")), PERIOD), Controller({name: AxisController(LeadLag(**gains)) for name in "xy"})


def logged(label: str, coulomb: float, radius: float = 0.02, seconds: float = 1.5) -> LogRun:
    """Return the log of a circle on a table whose Coulomb friction [N] may differ from the 60 N of the model."""
    machine, controller = parts()
    along = np.linspace(0.0, 1.0, round(seconds / PERIOD))
    angle = 2.0 * np.pi * along**3 * (10.0 - 15.0 * along + 6.0 * along**2)
    circle = radius * np.column_stack([1.0 - np.cos(angle), np.sin(angle)])
    asked = np.vstack([np.zeros((60, 2)), circle, np.zeros((100, 2))])
    path, arc_length = path_of_samples(asked)
    reference = Reference.from_samples(asked, PERIOD, path, arc_length=arc_length)
    true = with_values(machine, controller, {f"axes.{axis}.friction.coulomb": coulomb for axis in "xy"})[0]
    position = simulate(true, controller, reference, signals=("position",))["position"]
    signals = {name: Signal(data, ("sample", "axis"), "m") for name, data in (("reference", asked), ("position", position))}
    return log_run(machine, controller, Result(label, ("x", "y"), PERIOD, signals), label)


@pytest.mark.parametrize(("n", "independent"), [(2, 0.726), (3, 0.773), (9, 0.902)])
@pytest.mark.slow
def test_new_runs_lie_within_the_factor_as_often_as_stated(n: int, independent: float) -> None:
    """Each run differs from the mean of the others, or, more favourably, each prediction has an error of its own."""
    values = 0.2 * np.random.default_rng(n).standard_normal((10000, n + 1))
    runs, new = values[:, :n], values[:, n]
    others = (runs.sum(axis=1, keepdims=True) - runs) / (n - 1)
    for left_out, error, share in ((runs - others, new - runs.mean(axis=1), n / (n + 1)), (runs, new, independent)):
        within = [abs(e) <= np.log(new_run_factor(np.exp(row), np.ones(n))) for row, e in zip(left_out, error, strict=True)]
        # 10000 draws: three standard deviations are at most 1.4 %.
        assert np.mean(within) == pytest.approx(share, abs=0.015)


def test_an_exact_prediction_needs_no_room() -> None:
    assert new_run_factor([2e-5, 3e-5], [2e-5, 3e-5]) == 1.0
    assert np.isfinite(new_run_factor([0.0, 3e-5], [2e-5, 3e-5]))


def test_deviations_include_the_scatter_between_runs() -> None:
    """Friction of 50 N in one run and 70 N in the other: left out in turn, 10 N; the residual alone shows less."""
    refined = refine([logged("low", 50.0), logged("high", 70.0, 0.015)], WANTED, settings=SETTINGS)
    crossed, found = cross_validated(refined, SETTINGS)
    inner, outer = ({one.sought.name: one.deviation for one in result.parameters} for result in (refined, crossed))
    for axis in "xy":
        name = f"axes.{axis}.friction.coulomb"
        assert inner[name] < 0.7 * outer[name] and outer[name] == pytest.approx(10.0, rel=0.05)
    assert all(outer[name] >= inner[name] for name in inner)
    assert [one.value for one in crossed.parameters] == [one.value for one in refined.parameters]
    assert found is not None
    low, high = found.held_out
    assert (low.run, high.run) == ("low", "high") and not low.second_half
    # The friction of the other run: too much error for the run with little friction, too little for the other.
    assert low.simulated_rms > 1.05 * low.measured_rms and high.simulated_rms < 0.95 * high.measured_rms
    errors = np.log([low.measured_rms / low.simulated_rms, high.measured_rms / high.simulated_rms])
    assert np.log(found.rms_factor) == pytest.approx(1.5 * np.sqrt(np.mean(errors**2)))
    (stated,) = (one.values for one in crossed.findings if one.code == "CL566")
    assert (stated["level"], stated["rms_high"], stated["max_low"]) == (2.0 / 3.0, found.rms_factor, 1.0 / found.max_factor)


def test_a_run_is_predicted_without_its_own_samples() -> None:
    other = logged("other", 60.0, 0.015)
    predictions = []
    for coulomb in (50.0, 90.0):
        _, found = cross_validated(refine([logged("run", coulomb), other], WANTED, settings=SETTINGS), SETTINGS)
        assert found is not None
        predictions.append(found.held_out[0].simulated_rms)
    assert predictions[0] == pytest.approx(predictions[1], rel=2e-3)


def test_gains_of_one_run_are_fitted_to_its_first_half() -> None:
    first, second = logged("first", 60.0), logged("second", 60.0, 0.015)
    gain = first.controller.axes["x"].controller.values()["gain"]
    second = replace(second, controller=with_values(second.machine, second.controller, {GAIN: 0.8 * gain})[1])
    wanted = [*WANTED, f"second:{GAIN}={0.5 * gain} A/m..{2.0 * gain} A/m"]
    crossed, found = cross_validated(refine([first, second], wanted, settings=SETTINGS), SETTINGS)
    assert found is not None
    assert [one.second_half for one in found.held_out] == [False, True]
    for one in found.held_out:
        assert one.simulated_rms == pytest.approx(one.measured_rms, rel=0.02)
    assert "CL566" in {one.code for one in crossed.findings}


def test_without_a_second_run_or_a_shared_parameter_there_is_no_interval() -> None:
    first, second = logged("first", 60.0), logged("second", 60.0, 0.015)
    for runs, wanted in (([first], WANTED), ([first, second], ["first:axes.x.plant.damping"])):
        refined = refine(runs, wanted, settings=SETTINGS)
        crossed, found = cross_validated(refined, SETTINGS)
        assert found is None and crossed.parameters == refined.parameters
        assert [one.code for one in crossed.findings if one.code in ("CL566", "CL567")] == ["CL567"]


def test_with_one_axis_the_tracking_error_counts() -> None:
    run = logged("run", 60.0)
    machine = replace(run.machine, axes=run.machine.axes[:1])
    alone = replace(run, machine=machine, controller=Controller({"x": run.controller.axes["x"]}), position=run.position[:, :1])
    alone.__dict__["asked"] = run.asked[:, :1]
    part = run.measured[slice(*run.moves), 0]
    assert alone.contour() == pytest.approx((np.sqrt(np.mean(part**2)), np.abs(part).max()))
