"""Twelve machines from typical data sheets: the proposed controllers have their margins and follow a circle and a part."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import contourlab as cl
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.features.machines.answers import read_answers
from contourlab.features.machines.new_machine import new_machine, write_machine
from contourlab.features.tune.study import TuneSettings, tune
from contourlab.scenario import Case, load_controller, load_machine, scenario_from_parts
from contourlab.study import Setting

SHEETS = sorted((Path(__file__).parents[3] / "data_sheets").glob("*.toml"))
ROUND = {"contour": {"name": "circle", "radius": "8 mm"}, "feed": {"law": "planned", "feedrate": "3 m/min"}}
PART = """G21 G90 G94 G64 P0.005
G1 X12 F3000
G3 X15 Y3 I0 J3
G1 Y8
G1 X0
G1 X0 Y0
M30
"""


@pytest.fixture(params=SHEETS, ids=lambda sheet: sheet.stem)
def folder(request, tmp_path):
    write_machine(new_machine(read_answers(request.param)), tmp_path / "machine")
    return tmp_path / "machine"


def largest_error(case: Case) -> float:
    """Return the largest part error of a case [m]."""
    reference = case.reference()
    result = cl.judge(cl.simulate(case.machine, case.controller, reference), reference)
    return float(cl.summarise(result, reference).part_error.max)


def test_there_are_four_sheets_of_each_class():
    assert [sheet.stem for sheet in SHEETS] == [f"{name}-{i}" for name in ("mill", "router", "stage") for i in (1, 2, 3, 4)]


def test_the_files_keep_6_db_and_30_degrees(folder):
    machine = load_machine(folder / "machine.toml")
    controller = load_controller(folder / "controller.toml", machine)
    for axis in machine.axes:
        margins = sampled_loop(axis, controller.axes[axis.name], machine.servo_period, machine.carried_mass(axis.name)).margins()
        assert margins.stable
        assert 20.0 * math.log10(margins.gain) >= 6.0
        assert math.degrees(margins.phase) >= 30.0


@pytest.fixture(params=["circle", "part"])
def case(request, folder, tmp_path):
    (tmp_path / "part.ngc").write_text(PART, encoding="utf-8")
    motion = {"program": None, **ROUND} if request.param == "circle" else {"program": tmp_path / "part.ngc"}
    return scenario_from_parts(machine=folder / "machine.toml", controller=folder / "controller.toml", **motion).base


def test_a_circle_and_a_part_run(case):
    # The least stiff of them, a rack at 2 ms, keeps 60 um.
    assert largest_error(case) < 100e-6


IN_TURN = [(sheet, ("circle", "part")[i % 2]) for i, sheet in enumerate(SHEETS)]


@pytest.mark.slow
@pytest.mark.parametrize(("folder", "case"), IN_TURN, indirect=True, ids=lambda value: getattr(value, "stem", value))
def test_tuning_finds_at_most_a_factor_of_one_and_a_half(case):
    tuned = tune(Setting(case.machine, case.controller, case.reference()), TuneSettings(budget=2000))
    before, after = (one.figures["part_error_max"] for one in (tuned.before, tuned.after))
    assert before <= 1.5 * after
