"""Coverage: the part of a path that the tool left out, and its effect on the verdict."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from made_runs import PERIOD, circle_laps, made_run, samples_on

import contourlab as cl
from contourlab.components.registry import component
from contourlab.feed import Reference
from contourlab.geometry import Line, Path
from contourlab.metrics.figures import left_out, summarise
from contourlab.metrics.judge import judge
from contourlab.result import Result

LAP = 2.0 * math.pi * 0.02


def open_path() -> Reference:
    path = Path([Line((0.0, 0.0), (0.06, 0.0)), Line((0.06, 0.0), (0.06, 0.04))])
    return samples_on(path, np.linspace(0.0, path.length, 201))


def run_along(reference: Reference, along: Any) -> Result:
    return judge(made_run(reference, reference.path.position(along)), reference)


def test_a_following_tool_leaves_out_at_most_one_step() -> None:
    for reference in (open_path(), circle_laps(800, laps=2)):
        along = reference.block(0, reference.n_sample).arc_length
        found = summarise(run_along(reference, along), reference)
        assert found.left_out == pytest.approx(float(np.diff(along).max()), rel=1e-6)


def test_a_stopped_tool_leaves_out_the_rest() -> None:
    reference = open_path()
    along = np.minimum(reference.block(0, 201).arc_length, 0.07)
    assert summarise(run_along(reference, along), reference).left_out == pytest.approx(0.03, abs=1e-9)
    late = np.maximum(reference.block(0, 201).arc_length, 0.02)
    assert summarise(run_along(reference, late), reference).left_out == pytest.approx(0.02, abs=1e-9)


def test_a_hole_in_the_middle_is_found() -> None:
    reference = open_path()
    along = reference.block(0, 201).arc_length
    jumping = np.where((along > 0.01) & (along < 0.05), np.where(along < 0.03, 0.01, 0.05), along)
    assert summarise(run_along(reference, jumping), reference).left_out == pytest.approx(0.04, abs=1e-9)


def test_a_lag_on_laps_leaves_nothing_out() -> None:
    """The judged lap begins where the previous one ended, 30 samples late."""
    reference = circle_laps(800, laps=3)
    along = reference.block(0, reference.n_sample).arc_length
    lagging = run_along(reference, np.maximum(along - 30.0 * LAP / 800.0, 0.0))
    assert summarise(lagging, reference).left_out == pytest.approx(LAP / 800.0, rel=1e-3)
    longest, at_end = left_out(run_along(reference, np.zeros_like(along)), reference, reference.judged)
    assert longest == pytest.approx(LAP, rel=1e-9) and at_end == 0.0


def test_a_missing_end_is_reported_separately() -> None:
    reference = open_path()
    along = reference.block(0, 201).arc_length
    jumping = np.where((along > 0.01) & (along < 0.05), np.where(along < 0.03, 0.01, 0.05), np.minimum(along, 0.0985))
    longest, at_end = left_out(run_along(reference, jumping), reference, reference.judged)
    assert (longest, at_end) == (pytest.approx(0.04, abs=1e-9), pytest.approx(1.5e-3, abs=1e-9))


@pytest.mark.parametrize(("coulomb", "passes"), [(0.02, True), (30.0, False)])
def test_a_machine_that_cannot_move_does_not_pass(coulomb: float, passes: bool) -> None:
    """A tool stuck at the start of the circle is on the path all the time."""
    plant = component("plant", "mass-damper")(mass=10.0, damping=0.0, force_constant=50.0)
    friction = component("friction", "coulomb")(coulomb=50.0 * coulomb, breakaway=50.0 * coulomb, stribeck_velocity=1e-3)
    drive = component("drive", "saturation")(limit=3.0)
    part = component("controller", "position")(velocity_gain=60.0, position_gain=6000.0, integral_gain=20.0, model_gain=5.0)
    limits = cl.Limits(following_error=1.0)
    machine = cl.Machine("made", tuple(cl.Axis(n, plant, friction, drive, limits=limits) for n in "xy"), PERIOD)
    controller = cl.Controller(dict.fromkeys("xy", cl.AxisController(part)))
    reference = cl.uniform(cl.contour("circle", radius=0.02), 0.5, 2, PERIOD)
    judged = judge(cl.simulate(machine, controller, reference), reference)
    found = cl.verdict(machine, controller, reference, judged, 300e-6)
    assert found.worst.value < 300e-6
    assert found.passed is passes
    assert found.left_out == (0.0 if passes else pytest.approx(LAP, rel=1e-6))
    assert passes or found.causes == ()
