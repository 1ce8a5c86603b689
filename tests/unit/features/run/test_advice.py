"""The most helpful single change: the candidates, and agreement of the promised figure with a run."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from component_rig import make

import contourlab as cl
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.features.run.outcome import run_case
from contourlab.features.run.remedies import remedies
from contourlab.features.run.verdict import Trial, advice
from contourlab.rendering.judgement import FEED
from contourlab.scenario import scenario_from_parts

PERIOD = 1e-3
A, B = 5.0, 4.0
"""Acceleration per command and decay of the plant."""


def machine(**slots: Any) -> cl.Machine:
    plant = make("plant", "mass-damper", mass=10.0, damping=40.0, force_constant=50.0)
    return cl.Machine("made", tuple(replace(cl.Axis(name, plant), **slots) for name in "xy"), PERIOD)


def controller(position_gain: float = 300.0, **values: Any) -> cl.Controller:
    part = make("controller", "position", velocity_gain=20.0, position_gain=position_gain, integral_gain=10.0, **values)
    return cl.Controller(dict.fromkeys("xy", cl.AxisController(part)))


def circle() -> cl.Reference:
    return cl.uniform(cl.contour("circle", radius=0.02), 0.5, 2, PERIOD)


def largest(one: cl.Machine, by: cl.Controller) -> float:
    judged = cl.judge(cl.simulate(one, by, circle()), circle())
    return float(np.abs(judged["part_error"][slice(*circle().laps[-1])]).max())


def test_poles_are_scaled() -> None:
    """Of s^3 + (b + a K_V) s^2 + a K_P s + a K_P K_I, however the gains were placed."""
    found = dict(remedies(machine(), controller()))
    faster = found["raising the poles of the position loops by a quarter"].axes["x"].controller.values()
    before = controller().axes["x"].controller.values()

    def poles(c: dict[str, float]) -> np.ndarray:
        k = A * c["position_gain"]
        return np.sort_complex(np.roots([1.0, B + A * c["velocity_gain"], k, k * c["integral_gain"]]))

    np.testing.assert_allclose(poles(faster), 1.25 * poles(before), rtol=1e-9)


def test_models_include_the_carried_mass() -> None:
    """A module of 30 kg on an axis of 10 kg: a quarter of the acceleration."""
    x, y = machine().axes
    stacked = cl.Machine("stack", (x, replace(y, mounted_on="x", stage_mass=30.0)), PERIOD)
    found = dict(remedies(stacked, controller()))
    forward = found["matching the feedforward model to the loop"].axes
    observed = found["adding a disturbance observer"].axes
    for part in (forward["x"].controller, observed["x"].observer):
        assert (part.model_gain, part.model_damping) == (pytest.approx(A / 4.0), pytest.approx(B / 4.0))  # type: ignore[union-attr]
    assert observed["y"].observer.model_gain == pytest.approx(A)  # type: ignore[union-attr]


def test_existing_parts_are_not_tried() -> None:
    part = controller(model_gain=A, model_damping=B).axes["x"]
    watched = replace(part, observer=make("observer", "disturbance-observer", model_gain=A, model_damping=B, bandwidth=100.0))
    full = cl.Controller(dict.fromkeys("xy", watched), make("estimator", "newton"), make("coupling", "modified-reference", weight=0.5))
    words = [words for words, _ in remedies(machine(), full)]
    assert not any("feeding forward" in w or "adding" in w or "coupling" in w for w in words)
    bandwidths = [c.axes["x"].observer.bandwidth for w, c in remedies(machine(), full) if "bandwidth" in w]  # type: ignore[union-attr]
    assert bandwidths == [150.0]


def improved(one: cl.Machine, by: cl.Controller, tolerance: float) -> tuple[Trial, Trial]:
    start = Trial((), by, circle(), largest(one, by))
    return start, advice(one, start, tolerance)[0]


def test_the_proposed_change_is_the_best_and_its_figure_is_that_of_a_run() -> None:
    one, by = machine(), controller()
    start, best = improved(one, by, 0.9 * largest(one, by))
    tried = {words: largest(one, changed) for words, changed in remedies(one, by)}
    assert best.changes == (min(tried, key=tried.__getitem__),)
    assert best.worst == pytest.approx(min(tried.values())) and best.worst < start.worst
    assert largest(one, best.controller) == pytest.approx(best.worst)


@pytest.mark.slow
def test_changes_build_on_each_other_until_the_tolerance_is_reached() -> None:
    rubbing = machine(friction=make("friction", "coulomb", coulomb=30.0, breakaway=30.0, stribeck_velocity=1e-3))
    _, best = improved(rubbing, controller(), 0.0)
    assert 1 < len(best.changes) <= 3
    single = min(largest(rubbing, changed) for _, changed in remedies(rubbing, controller()))
    assert best.worst < 0.99 * single
    assert largest(rubbing, best.controller) == pytest.approx(best.worst)


def test_the_friction_of_the_axis_is_fed_forward() -> None:
    rubbing = machine(friction=make("friction", "coulomb", coulomb=30.0, breakaway=30.0, stribeck_velocity=1e-3))
    law = dict(remedies(rubbing, controller()))["compensating the friction by feedforward"]
    part = law.axes["x"].feedforward
    assert part is not None and (part.values()["coulomb"], part.values()["force_constant"]) == (30.0, 50.0)
    assert largest(rubbing, law) < 0.7 * largest(rubbing, controller())


def test_a_proposed_cascade_keeps_its_margins() -> None:
    law = next(changed for words, changed in remedies(machine(), controller()) if "cascade" in words)
    loop = sampled_loop(machine().axes[0], law.axes["x"], PERIOD, 0.0).margins()
    assert 20.0 * np.log10(loop.gain) >= 6.0 and np.degrees(loop.phase) >= 30.0


def test_without_a_helpful_change_nothing_is_proposed() -> None:
    start = Trial((), controller(), circle(), 0.0)
    assert advice(machine(), start, 1e-6) == (start, [])


CORNER = "G21 G17 G90 F1500\nG64 P0.2\nG1 X10\nG1 X18 Y6\nM2\n"


def test_a_planning_error_leads_to_a_closer_plan(tmp_path: Path) -> None:
    """A turn of 37 degrees blended within 200 um: no controller helps, but a blend within a quarter of the tolerance does."""
    part = tmp_path / "corner.ngc"
    part.write_text(CORNER, encoding="ascii")
    case = scenario_from_parts(part, "xyz", "xyz-controller", run={"tolerance": "40 um"}).base
    found = run_case(case).verdict
    assert found is not None and found.causes[0].name == "planning"
    values = next(one.values for one in found.findings if one.code == "CL203")
    by_name = case.closer(1e-5)
    changed = replace(case, feed=replace(case.feed, path_control="blend", corner_tolerance=1e-5))
    assert values["change"] in by_name
    if "blending" in values["change"]:
        assert "G64 P0.01" in values["change"] and 'path_control = "blend", corner_tolerance = "10 um"' in values["change"]
        assert values["after"] == pytest.approx(run_case(changed).metrics.part_error.max, rel=5e-3)
    assert values["after"] < 40e-6 < 150e-6 < values["before"]
    assert values["time_after"] == by_name[values["change"]]().duration


@pytest.mark.slow
def test_each_price_is_the_figure_of_a_run_with_that_change(tmp_path: Path) -> None:
    """The price of the feed is that of a scenario with this override; that of a controller is that of the run under it."""
    part = tmp_path / "part.ngc"
    part.write_text("G21 G17 G90 G61 F1000\nG1 X10\nG3 X10 Y10 I0 J5\nG1 X0\nG1 Y0\nM2\n", encoding="ascii")
    case = scenario_from_parts(part, "builtin:xyz", "builtin:xyz-controller", run={"tolerance": "0.5 um"}).base
    verdict = run_case(case).verdict
    assert verdict is not None and [c.part_error for c in verdict.changes] == sorted(c.part_error for c in verdict.changes)
    prices = {change.name: change for change in verdict.changes}
    assert FEED in prices and len(prices) > 1 and all(change.part_error < 0.99 * verdict.worst.value for change in prices.values())
    slower = replace(case, feed=replace(case.feed, override=0.8))
    assert run_case(slower, explain=False).metrics.part_error.max == pytest.approx(prices.pop(FEED).part_error, rel=1e-9)
    for name, changed in remedies(case.machine, case.controller):
        if name in prices:
            largest_error = run_case(replace(case, controller=changed), explain=False).metrics.part_error.max
            price = prices.pop(name)
            assert (price.part_error, price.added_time) == (pytest.approx(largest_error, rel=1e-9), 0.0)
    assert not [name for name in prices if "G6" not in name]
