"""`--set NAME=VALUE`: a value in place of the scenario's."""

from __future__ import annotations

import json
import shlex
from pathlib import Path

import pytest
from typed_commands import CIRCLE, ON_XYZ, PART, SCHEMES, Refused, Run, write

import contourlab as cl
from contourlab.app.session import Asked
from contourlab.errors import ParameterError
from contourlab.features.run.changes import of_machine
from contourlab.features.run.options import Compare
from contourlab.features.run.options import Run as Settings
from contourlab.features.run.source import scenario_asked
from contourlab.scenario import dump, load_scenario

VALUES = ("axes.*.plant.damping=9 1/s", "1.position_gain=3 full_scale/mm", "feed.frequency=0.4 Hz", "run.seed=7")
"""A number of the machine, one of the controller, and keys of the file."""
SAME = """
[axes."*".plant]
damping = "9 1/s"
[controller]
file = "builtin:ghaffari/calibrated"
[controller.axes.1.controller]
position_gain = "3 full_scale/mm"
"""


@pytest.fixture
def plain(tmp_path: Path) -> Path:
    return tmp_path / write(tmp_path, CIRCLE + SCHEMES, "plain.toml")


def test_every_scheme_is_as_if_the_file_had_the_values(tmp_path: Path, plain: Path) -> None:
    same = CIRCLE.replace("0.5 Hz", "0.4 Hz").replace("[run]\n", "[run]\nseed = 7\n")
    write(tmp_path, same.replace('controller = "builtin:ghaffari/calibrated"\n', "") + SAME + SCHEMES, "same.toml")
    made, read = scenario_asked([plain], Settings(set=VALUES)), load_scenario(tmp_path / "same.toml")
    assert dump(made) == dump(read) != dump(load_scenario(plain))


def test_the_last_value_counts(plain: Path) -> None:
    one, every = "axes.1.plant.damping=8 1/s", "axes.*.plant.damping=9 1/s"
    for texts, wanted in (((one, every), 9.0), ((every, one), 8.0), ((one, every, one), 8.0)):
        machine = scenario_asked([plain], Settings(set=texts)).machine
        assert machine.axis("1").plant.values()["damping"] == wanted


def test_a_scheme_without_the_parameter_stays(plain: Path) -> None:
    texts, both = ("controller.axes.*.observer.model_damping=11 1/s",), ("position loop", "all of it")
    plainly, changed = (scenario_asked([plain], Compare(set=given, schemes=both)).cases() for given in ((), texts))
    assert changed[0].controller == plainly[0].controller and changed[1].controller != plainly[1].controller
    with pytest.raises(ParameterError):
        scenario_asked([plain], Compare(set=texts, schemes=both[:1]))


def test_a_limit_changes_the_plan_and_the_command_is_kept(contourlab: Run, tmp_path: Path) -> None:
    write(tmp_path, PART)
    said = [
        contourlab("run", "part.ngc", *ON_XYZ, *more, "--check", "--json") for more in ((), ("--set", "axes.x.limits.velocity=0.5 m/min"))
    ]
    first, slower = (json.loads(one.out)["schemes"]["base"]["duration"] for one in said)
    assert slower > 1.3 * first
    mass = "axes.x.plant.mass=95 kg"
    done = contourlab("run", "part.ngc", *ON_XYZ, "--set", mass, "--no-interval", "--tolerance", "1 um")
    assert done.code == 1, done.err
    proposed = next(line for line in done.out.splitlines() if line.startswith("next:"))
    for command in (json.loads((tmp_path / "results" / "summary.json").read_text(encoding="utf-8"))["command"], proposed):
        assert mass in shlex.split(command)


def test_what_a_part_does_not_have_is_refused(plain: Path, refused: Refused) -> None:
    for text, words in {
        "axes.1.plant.dampng=9 1/s": "axes.1.plant.damping",
        "axes.1.plant.damping=-9 1/s": "out of range",
        "axes.1.plant.damping=9": "no unit",
        "axes.1.plant.damping=9 mm": "converted",
        "axes.1.plant.damping": "NAME=VALUE",
        "feed.frequncy=1 Hz": "'frequency'",
        "axes.9.limits.velocity=1 m/s": "'9'",
        "feed=1": "table",
        "run.tolerance=[[1": "quantity",
    }.items():
        assert words in refused("run", plain, "--check", "--set", text)


def test_of_objects_parameters_alone_are_set(plain: Path) -> None:
    scenario = load_scenario(plain)
    made = scenario_asked([scenario], Settings(set=VALUES[:1]))
    assert made.machine == cl.with_values(scenario.machine, scenario.controller, {"axes.*.plant.damping": 9.0})[0]
    with pytest.raises(ParameterError):
        scenario_asked([scenario], Settings(set=VALUES[2:3]))


def test_no_controller_is_set_that_another_takes_over_from(tmp_path: Path) -> None:
    changing = CIRCLE + 'changes = [{at = "1 s", controller = "builtin:ghaffari/initial"}]\n'
    file = tmp_path / write(tmp_path, changing, "changing.toml")
    scenario_asked([file], Settings(set=VALUES[:1]))
    with pytest.raises(ParameterError):
        scenario_asked([file], Settings(set=VALUES[1:2]))


def test_the_next_command_is_about_the_same() -> None:
    settings = Settings(machine="xyz", set=VALUES[:1], plugin=(Path("part.py"),))
    wanted = ["a.ngc", "--machine", "xyz", "--set", VALUES[0], "--plugin", "part.py"]
    assert Asked("run", settings, None, inputs=("a.ngc",)).given == wanted


def test_another_controller_keeps_the_values_of_the_machine_alone(plain: Path) -> None:
    case = load_scenario(plain).base
    assert of_machine(VALUES, case) == (VALUES[0], *VALUES[2:])
    assert of_machine(["1.*damping=9 1/s"], case) == ("axes.1.plant.damping=9 1/s",)
