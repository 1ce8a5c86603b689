"""A router described with the data of its motors and nothing else: the first figures are those of an engineer's controller."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from reference_data import reference_file

import contourlab as cl
from contourlab.features.machines.answers import read_answers
from contourlab.features.machines.new_machine import new_machine, write_machine
from contourlab.features.run.trust import part_interval
from contourlab.scenario import Case, scenario_from_parts
from contourlab.study import Setting


@pytest.fixture
def case(tmp_path: Path) -> Case:
    folder = reference_file("repro/router/answers.toml").parent
    write_machine(new_machine(read_answers(folder / "answers.toml")), tmp_path)
    return scenario_from_parts(folder / "part.ngc", tmp_path / "machine.toml", tmp_path / "controller.toml").cases()[0]


def test_the_error_on_cutting_moves_is_that_of_a_hand_made_cascade(case: Case) -> None:
    reference, route = case.reference(), case.route()
    result = cl.judge(cl.simulate(case.machine, case.controller, reference), reference)
    assert route is not None
    rapid = route.rapid[reference.path.curve_index(reference.block(0, reference.n_sample).arc_length)]
    error = np.abs(np.asarray(result["part_error"]))
    assert error[~rapid].max() == pytest.approx(23.8e-6, rel=0.2)


@pytest.mark.slow
def test_the_guesses_give_an_interval(case: Case) -> None:
    interval = part_interval(Setting.of(case))
    assert [one.code for one in interval.findings] == ["CL225", "CL228"]
    assert interval.failed == 0
    assert interval.max is not None and interval.max.low < interval.max.high
