"""The samples that are judged: cutting moves, lines, laps."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import contourlab as cl
from contourlab.errors import FeedError, ParameterError, ProgramError
from contourlab.feed import Reference
from contourlab.feed.reference import Judged, Profile, ranges_of_curves
from contourlab.scenario import Scenario, scenario_from_parts

PART = "G21 G17 G90\nG0 X10 Y10 Z5\nG1 Z0 F600\nG4 P0.3\nX20 F1200\nG3 X30 Y20 I0 J10\nG0 Z5\nX10 Y10\nG4 P0.2\nG1 Z-1\nY20\nG0 Z10\nM2\n"


@pytest.fixture
def scenario(tmp_path: Path) -> Scenario:
    part = tmp_path / "part.ngc"
    part.write_text(PART, encoding="ascii")
    return scenario_from_parts(part, "xyz", "xyz-controller", run={"tolerance": "50 um"})


def lines(reference: Reference, judged: Judged) -> set[int]:
    """Return the lines of the judged samples in motion."""
    block = reference.block(0, reference.n_sample)
    moving = block.feedrate > 1e-9
    return set(reference.source_line(block.arc_length[[k for k in judged.samples if moving[k]]]).tolist())


def test_cutting_moves_are_judged_by_default(scenario: Scenario) -> None:
    reference = scenario.base.reference()
    assert reference.judged.basis == "cutting moves" and len(reference.judged.ranges) == 2
    assert lines(reference, reference.judged) == {3, 5, 6, 10, 11}
    everything = set(lines(reference, Judged(((0, reference.n_sample),), "")))
    assert everything - {3, 5, 6, 10, 11} == {2, 7, 8, 12}


def test_a_dwell_belongs_to_the_move_before_it(scenario: Scenario) -> None:
    """The 0.3 s after line 3 are judged, the 0.2 s after the rapid of line 8 are not."""
    reference = scenario.base.reference()
    still = np.flatnonzero(reference.block(0, reference.n_sample).feedrate == 0.0)
    (first, second) = reference.judged.ranges
    period = reference.servo_period
    assert np.count_nonzero((still > first[0]) & (still < first[1] - 1)) * period == pytest.approx(0.3, abs=0.005)
    assert np.count_nonzero((still > second[0]) & (still < second[1] - 1)) == pytest.approx(0.0, abs=5)


@pytest.mark.parametrize(("choice", "wanted"), [("lines 5-6", {5, 6}), ("lines 11", {11}), ("lines 1-8", {3, 5, 6})])
def test_lines_are_chosen(scenario: Scenario, choice: str, wanted: set[int]) -> None:
    reference = scenario.judging(choice).base.reference()
    assert lines(reference, reference.judged) == wanted


def test_lines_of_one_fitted_curve_are_chosen(tmp_path: Path) -> None:
    angle = np.linspace(0.0, np.pi, 61)
    points = "".join(f"X{20.0 - 10.0 * np.cos(a):.4f} Y{10.0 * np.sin(a):.4f}\n" for a in angle)
    (tmp_path / "dense.ngc").write_text(f"G21 G64 P0.05\nG0 X10 Y0\nG1 F1200\n{points}M2\n", encoding="ascii")
    scenario = scenario_from_parts(tmp_path / "dense.ngc", "xyz", "xyz-controller").judging("lines 20-39")
    reference = scenario.base.reference()
    assert lines(reference, reference.judged) == set(range(20, 40))
    ((start, stop),) = reference.judged.ranges
    assert reference.source_line(reference.block(start - 1, stop + 1).arc_length)[[0, 1, -2, -1]].tolist() == [19, 20, 39, 40]


def test_the_rest_is_reported_by_kind(scenario: Scenario) -> None:
    reference = scenario.base.reference()
    judged = cl.judge(cl.simulate(scenario.machine, scenario.controller, reference), reference)
    metrics = cl.summarise(judged, reference)
    size = np.abs(judged["part_error"])
    outside = np.setdiff1d(np.arange(reference.n_sample), reference.judged.samples)
    assert [other.moves for other in metrics.others] == ["approach", "rapids", "retract"]
    assert max(other.max for other in metrics.others) == size[outside].max()
    assert metrics.part_error.max == size[reference.judged.samples].max()
    assert metrics.judged_time + sum(other.time for other in metrics.others) == pytest.approx(reference.n_sample * reference.servo_period)
    whole = scenario.judging("all").base.reference()
    assert cl.summarise(judged, whole).part_error.max == size.max() and cl.summarise(judged, whole).others == ()


def test_a_batch_judges_the_same_samples(scenario: Scenario) -> None:
    for choice in ("cutting", "all", "lines 5-6"):
        case = scenario.judging(choice).base
        reference = case.reference()
        name = "axes.x.plant.damping"
        part = case.machine.axis("x").plant.values()["damping"]
        batch = cl.simulate_batch(case.machine, case.controller, reference, {name: [part]}, effort=True)
        judged = cl.judge(cl.simulate(case.machine, case.controller, reference), reference)
        error = np.abs(judged["contour_error"][reference.judged.samples])
        assert batch.figures["contour_error_max"][0] == pytest.approx(error.max(), rel=1e-4)
        assert batch.figures["contour_error_integral"][0] == pytest.approx(error.sum() * reference.servo_period, rel=1e-4)


def test_a_result_of_part_of_a_run_is_judged_where_it_lies(scenario: Scenario) -> None:
    reference = scenario.base.reference()
    first, second = reference.judged.ranges
    middle = (first[0] + first[1]) // 2
    assert reference.judged.within(middle, second[0] - middle).ranges == ((0, first[1] - middle),)
    assert reference.judged.within(0, first[0]).basis == "whole motion"


@pytest.mark.parametrize("choice", ["lines 7-8", "lines 12", "lines 900-901"])
def test_lines_without_a_cut_are_refused(scenario: Scenario, choice: str) -> None:
    with pytest.raises((FeedError, ProgramError)):
        scenario.judging(choice).base.reference()


@pytest.mark.parametrize("choice", ["", "cut", "lines", "lines 0", "lines 25-20", "lines 5-", "lines 4 - 5", "lines -3", "All"])
def test_other_words_are_refused(scenario: Scenario, choice: str) -> None:
    with pytest.raises(ParameterError):
        scenario.judging(choice)


def test_a_contour_is_judged_over_its_last_lap_or_whole() -> None:
    reference = cl.uniform(cl.contour("circle"), 1.0, 3, 1e-3)
    assert reference.judged == Judged(((2000, 3000),), "last lap")
    assert replace(reference, laps=()).judged == Judged(((0, 3000),), "whole motion")


@pytest.mark.parametrize("late", [-1e-12, 0.0, 1e-12])
def test_a_move_that_begins_at_a_sample_up_to_rounding_begins_there(late: float) -> None:
    rest = 0.05 + late  # two moves of 0.1 m at 2 m/s, to 50 ms and 100 ms
    profile = Profile(np.array([0.0, rest]), np.array([0.0, 0.1]), np.full(2, 2.0), np.zeros(2), np.zeros(2), rest + 0.05, 0.2)
    ranges = ranges_of_curves(profile, np.array([0.0, 0.1, 0.2]), np.array([False, True]), 1e-3, 101)
    assert ranges == ((50, 101),)
