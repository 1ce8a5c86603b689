"""The travel of an axis as a length: a part that is longer is refused with its line, a place is not; an unknown travel is named."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from refusals import refuses

from contourlab.errors import ContourlabError, ProgramError
from contourlab.features.check.program_check import check
from contourlab.features.machines.answers import preset_answers
from contourlab.features.machines.new_machine import new_machine, write_machine
from contourlab.features.run.outcome import run_case
from contourlab.geometry.path import boxes
from contourlab.loop import Limits
from contourlab.rendering.origins import numbers_of_machine
from contourlab.scenario import Scenario, dump, load_machine, parse_scenario, scenario_from_parts

HEAD = "G21 G90 G17 G61 F6000\n"
AXES = {"x": 0.6, "y": 0.8, "z": 0.12}


@pytest.fixture(scope="module")
def router(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("machine") / "router"
    write_machine(new_machine(preset_answers("router", {})), folder)
    return folder


def program(folder: Path, moves: str) -> Path:
    (folder / "part.ngc").write_text(HEAD + moves + "M2\n", encoding="ascii")
    return folder / "part.ngc"


def scenario(router: Path, part: Path, **options: object) -> Scenario:
    return scenario_from_parts(part, router / "machine.toml", router / "controller.toml", options=options)


TOO_LONG = [
    ("G1 X2000\n", 2, "x", 2.0),
    ("G0 X100\nG1 X650\nG1 X40\nG1 X0\n", 4, "x", 0.65),  # line 3 cuts over 550 mm, line 4 over 610 mm
    ("G0 X50\nG1 X350\nG3 X350 I-301\n", 4, "x", 0.602),  # a full circle from -252 to 350 mm
    ("G0 Z50\nG1 X300\nG1 Z-70.001\n", 4, "z", 0.120001),
]


@pytest.mark.parametrize(("moves", "line", "axis", "length"), TOO_LONG)
@pytest.mark.parametrize("size", [1, 2500])
def test_a_part_longer_than_the_travel_is_refused(
    moves: str, line: int, axis: str, length: float, size: int, router: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also at the ends of an arc's bulge, and in whatever parts a check plans."""
    monkeypatch.setattr("contourlab.features.check.program_check.PART", size)
    part = program(tmp_path, moves)
    (found,) = check(part, machine=router).findings
    assert (found.code, found.place) == ("CL478", f"axis {axis}")
    assert (found.values["line"], found.values["travel"]) == (line, AXES[axis])
    assert found.values["length"] == pytest.approx(length, rel=1e-9)
    with refuses(ProgramError, axis, line=line):
        scenario(router, part).base.reference()


PLACED = [
    "G0 X5000 Y-900 Z70\nG1 X5600\nY-100\n",  # the work offset is unknown, so the place is
    "G0 X10\nG1 X400\nG53 G0 X-500\n",  # a tool change in machine coordinates
    "G0 X10\nG1 X610\n",  # exactly 600 mm
]


@pytest.mark.parametrize("moves", PLACED)
def test_a_place_is_not_refused(moves: str, router: Path, tmp_path: Path) -> None:
    part = program(tmp_path, moves)
    assert check(part, machine=router).findings == ()
    assert scenario(router, part).base.reference().n_sample
    assert scenario(router, part, fit=True).motion.notes == ()


def test_a_part_that_is_too_long_is_fitted_on_request(router: Path, tmp_path: Path) -> None:
    part = program(tmp_path, "G0 X1000 Y5\nG1 X2200 Y305\nG0 X0 Y0\n")
    reference = scenario(router, part, fit=True).base.reference()
    low, high = (ends[~reference.rapid] for ends in boxes(reference.path))
    assert (high.max(axis=0) - low.min(axis=0))[:2] == pytest.approx([0.98 * 0.6, 0.98 * 0.15], rel=1e-9)


def test_a_travel_by_its_ends_names_the_first_line(tmp_path: Path) -> None:
    part = program(tmp_path, "G1 X100\nG2 X100 Y0 I20 J40\nG1 X160\nG1 X-170\n")
    (found,) = check(part, machine="xyz").findings
    assert (found.code, found.place, found.values["line"]) == ("CL470", "axis x", 3)
    values = [found.values[name] for name in ("low", "high", "start", "stop")]
    assert values == pytest.approx([-0.17, 0.12 + math.hypot(0.02, 0.04), -0.15, 0.15])
    with refuses(ProgramError, "x", line=3):
        scenario_from_parts(part, "xyz", "xyz-controller").base.reference()


def test_a_program_outside_is_refused_before_it_is_planned(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Unless what a blend cuts off may keep it inside."""
    inside = scenario_from_parts(program(tmp_path, "G64 P1 G0 X120\nG1 X150.2 Y40\nX120 Y80\n"), "xyz", "xyz-controller").base.reference()
    assert inside.block(0, inside.n_sample).position[:, 0].max() < 0.15
    monkeypatch.setattr("contourlab.scenario.values.blended", None)
    outside = [
        ("G64 P1 G0 X120\nG1 X152.2 Y40\nX120 Y80\n", 3),
        ("G64 P1 G0 X120\nG1 X150.2 Y40\nX120 Y190\n", 4),
        ("G1 X10\nG2 X10 Y0 I150\nG0 Z-160\n", 3),
    ]
    for moves, line in outside:
        with refuses(ProgramError, code="CL470", line=line):
            scenario_from_parts(program(tmp_path, moves), "xyz", "xyz-controller").base.reference()


def test_an_unknown_travel_is_named(router: Path, tmp_path: Path) -> None:
    (tmp_path / "machine").mkdir()
    for file in router.iterdir():
        text = "".join(
            line for line in file.read_text(encoding="utf-8").splitlines(True) if not line.startswith("travel") or "axis-x" in file.name
        )
        (tmp_path / "machine" / file.name).write_text(text, encoding="utf-8")
    part = program(tmp_path, "G1 X1\n")
    named = [("CL479", ["y", "z"])]
    found = check(part, machine=tmp_path / "machine").findings
    assert [(one.code, one.values["axes"]) for one in found] == named
    outcome = run_case(scenario(tmp_path / "machine", part).base, explain=False)
    assert [(one.code, one.values["axes"]) for one in outcome.findings if one.code == "CL479"] == named


def test_both_forms_survive_a_round_trip(router: Path, tmp_path: Path) -> None:
    machine = load_machine(router / "machine.toml")
    assert {axis.name: axis.limits.extent for axis in machine.axes} == AXES
    assert {number.name: number.value for number in numbers_of_machine(machine) if "travel" in number.name} == {
        f"axes.{name}.limits.travel": value for name, value in AXES.items()
    }
    again = parse_scenario(dump(scenario(router, program(tmp_path, "G1 X1\n"))), tmp_path / "again.toml").machine
    assert [axis.limits for axis in again.axes] == [axis.limits for axis in machine.axes]


@pytest.mark.parametrize("travel", [0.0, -1.0, math.nan, (1.0, 0.0)])
def test_a_travel_is_a_length_or_two_ends(travel: object) -> None:
    with refuses(ContourlabError, name="limits.travel"):
        Limits(travel=travel)  # type: ignore[arg-type]


def test_boxes_are_those_of_the_curves() -> None:
    import contourlab as cl

    path = cl.contour("circle", radius=0.01)
    low, high = boxes(path)
    np.testing.assert_allclose([low[0], high[0]], [[-0.01] * 2, [0.01] * 2], rtol=1e-12)
