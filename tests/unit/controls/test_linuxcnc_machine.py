"""LinuxCNC's own files as a machine: work offsets, tools, units, what closes the loops, and what is absent."""

import json
from pathlib import Path

import pytest
from made_controls import LINUXCNC
from reference_data import reference_file
from typed_commands import invoke

from contourlab.controls import control_file
from contourlab.errors import ParameterError, ScenarioError
from contourlab.program import Reading, parse_program
from contourlab.scenario import load_machine, load_scenario
from contourlab.scenario.load import reading_on, scenario_from_parts

PROGRAM = "G0 X1 Y1\nG1 X2 F30\nG1 Y2\nM2\n"


def machine_file(folder: Path, *pairs: tuple[str, str], text: str = LINUXCNC) -> Path:
    for old, new in pairs:
        assert old in text
        text = text.replace(old, new)
    file = folder / "m.ini"
    file.write_text(text)
    return file


def codes(file: Path) -> list[str]:
    control = control_file(file)
    assert control is not None
    return [found.code for found in control.findings]


def test_a_program_is_read_in_the_units_and_offsets_of_the_control(tmp_path: Path) -> None:
    """An inch machine starts in inches; its files are in inches too."""
    (tmp_path / "sim.var").write_text("5220\t2\n5241\t1.0\n5242\t0.5\n5210\t0\n")
    (tmp_path / "tool.tbl").write_text("T1 P1 Z2.0 D0.25 ; mill\n")
    more = "[RS274NGC]\nPARAMETER_FILE = sim.var\n"
    machine = load_machine(machine_file(tmp_path, ("[RS274NGC]\n", more), ("[EMCMOT]", "[EMCIO]\nTOOL_TABLE = tool.tbl\n[EMCMOT]")))
    reading = reading_on(machine, {"require_end": False})
    program = parse_program("T1 M6\nG43\nG0 X1 Y1 Z0\nG1 X2 F30\n", reading=reading)
    first, second = program.moves
    assert first.end == pytest.approx((2.0 * 0.0254, 1.5 * 0.0254, 2.0 * 0.0254), abs=1e-15)
    assert second.feedrate == pytest.approx(30.0 * 0.0254 / 60.0)
    assert second.mode.control == "blend" and second.mode.tolerance == pytest.approx(0.001 * 0.0254)  # from the start-up code


def test_parameter_file_of_points_angles_and_other_numbers() -> None:
    """Only linear coordinates have a unit."""
    numbers = {}
    for unit in ("mm", "inch"):
        reading = Reading(unit=unit, zero="1, 2, -3")
        program = parse_program("G20\nG0 X1 Y1 Z1\n#1=#5221\n#2=#5230\nG1 X#1 F10\nM2", reading=reading)
        numbers[unit] = program.moves[0].end
    assert numbers["mm"] == pytest.approx((0.0264, 0.0274, 0.0224), abs=1e-15)
    assert numbers["inch"] == pytest.approx((2 * 0.0254, 3 * 0.0254, -2 * 0.0254), abs=1e-15)


@pytest.mark.parametrize("zero", ["1, 2", "1, 2, x", "1, 2, inf", "1;2;3"])
def test_a_zero_that_is_no_point_is_refused(zero: str, tmp_path: Path) -> None:
    (tmp_path / "part.ngc").write_text(PROGRAM)
    said = invoke(tmp_path, "check", "part.ngc", "--machine", machine_file(tmp_path), "--zero", zero)
    assert said.code == 2 and len(said.err.strip().splitlines()) == 1


def test_without_work_offsets_only_the_size_is_held_against_the_travel(tmp_path: Path) -> None:
    file, part = machine_file(tmp_path), tmp_path / "part.ngc"
    part.write_text(PROGRAM.replace("X2", "X20"))  # longer than any zero allows
    assert invoke(tmp_path, "check", part, "--machine", file).code == 2
    part.write_text(PROGRAM)

    def checked(*words: str) -> tuple[int, list[str]]:
        said = invoke(tmp_path, "check", part, "--machine", file, "--json", *words)
        return said.code, [found["code"] for found in json.loads(said.out)["findings"]]

    code, found = checked()
    assert code == 0 and "CL985" in found
    code, found = checked("--zero", "3, 1, 0")
    assert code == 0 and "CL985" not in found
    code, found = checked("--zero", "8, 1, 0")  # x to 10 inches of 9
    assert code == 2 and "CL470" in found
    with pytest.raises(Exception, match="axis x"):
        scenario_from_parts(part, file, options={"zero": "8, 1, 0"}).base.reference()


def test_what_is_absent_is_named_and_the_rest_is_read(tmp_path: Path) -> None:
    more = [("[RS274NGC]\n", "[RS274NGC]\nPARAMETER_FILE = a.var\n"), ("[EMCMOT]", "[EMCIO]\nTOOL_TABLE = t.tbl\n[EMCMOT]")]
    file = machine_file(tmp_path, *more, ("[HAL]", "[HAL]\nHALFILE = absent.hal\nHALFILE = script.tcl"))
    assert sorted(codes(file)) == ["CL866", "CL866", "CL980", "CL980", "CL984"]
    assert load_machine(file).axes[0].limits.velocity == pytest.approx(0.0508)


def test_what_the_control_compensates_is_not_the_machine(tmp_path: Path) -> None:
    file = machine_file(tmp_path, ("STEP_SCALE = 4000\n[AXIS_Y]", "STEP_SCALE = 4000\nBACKLASH = 0.001\nCOMP_FILE = x.comp\n[AXIS_Y]"))
    control = control_file(file)
    assert control is not None
    found = {one.code: one.values for one in control.findings}
    assert found["CL986"]["gap"] == pytest.approx(2.54e-5) and found["CL987"]["file"] == "x.comp"
    assert {axis.plant.kind for axis in load_machine(file).axes} == {"step-drive"}


def test_files_include_each_other_up_to_sixteen_deep(tmp_path: Path) -> None:
    for k in range(16):
        (tmp_path / f"{k}.inc").write_text(f"#INCLUDE {k + 1}.inc\n")
    (tmp_path / "16.inc").write_text(LINUXCNC)
    file = machine_file(tmp_path, text="#INCLUDE 1.inc\n")
    assert load_machine(file).name == "a router"
    file.write_text("#INCLUDE 0.inc\n")
    with pytest.raises(ScenarioError, match=r"15\.inc:1"):
        load_machine(file)


@pytest.mark.parametrize(
    ("planner", "jerk"), [("PLANNER_TYPE = 1\nMAX_LINEAR_JERK = 100\n", 2.54), ("MAX_LINEAR_JERK = 100\n", float("inf"))]
)
def test_a_jerk_limit_holds_with_its_planner_only(tmp_path: Path, planner: str, jerk: float) -> None:
    machine = load_machine(machine_file(tmp_path, ("[TRAJ]\n", f"[TRAJ]\n{planner}")))
    assert machine.axes[0].limits.jerk == pytest.approx(jerk)


def test_an_axis_whose_answer_is_open_is_planned_but_not_run(tmp_path: Path) -> None:
    """A pid on an analogue output: the file does not say what the drive makes of it. A plant of one's own closes the gap."""
    loop = ("loadrt pid names=pid.x", "net x-cmd joint.0.motor-pos-cmd => pid.x.command", "net x-out pid.x.output => pwmgen.0.value")
    pid = "\n".join(f"HALCMD = {line}" for line in loop)
    file = machine_file(tmp_path, ("HALCMD = net x-cmd joint.0.motor-pos-cmd => stepgen.0.position-cmd", pid))
    part = tmp_path / "part.ngc"
    part.write_text(PROGRAM)
    assert invoke(tmp_path, "check", part, "--machine", file).code == 0
    said = invoke(tmp_path, "run", part, "--machine", file, "--tolerance", "1 mm")
    assert said.code == 2 and "pwmgen.0.value" in said.err.strip().splitlines()[-1]
    scenario = tmp_path / "s.toml"
    scenario.write_text(
        'machine = {file = "m.ini"}\nprogram = "part.ngc"\n[axes.x]\nsubsteps = 4\n'
        'plant = {kind = "step-drive", natural_frequency = "80 Hz", damping_ratio = 1.0}\n'
    )
    machine = load_scenario(scenario).machine
    machine.check_modelled()
    with pytest.raises(ParameterError):
        load_machine(file).check_modelled()


def test_a_scenario_takes_controller_and_program_reading_from_the_control(tmp_path: Path) -> None:
    machine_file(tmp_path)
    (tmp_path / "part.ngc").write_text(PROGRAM)
    (tmp_path / "s.toml").write_text('machine = "m.ini"\nprogram = "part.ngc"\n')
    case = load_scenario(tmp_path / "s.toml").base
    assert {axis.controller.kind for axis in case.controller.axes.values()} == {"steps"}
    assert case.reference().path.position([0.0])[0, 0] == pytest.approx(0.0)
    assert float(case.reference().path.position([case.reference().path.length])[0, 0]) == pytest.approx(2 * 0.0254)


def test_the_router_of_a_newcomer(tmp_path: Path) -> None:
    """INI, HAL and part to a verdict in one command; every number has its origin."""
    folder = reference_file("repro", "trial3")
    said = invoke(tmp_path, "run", folder / "bracket.ngc", "--machine", folder / "router.ini", "--tolerance", "50 um", "--json")
    answer = json.loads(said.out)
    (scheme,) = answer["schemes"].values()
    assert said.code == 0 and scheme["verdict"]["passed"]
    assert scheme["metrics"]["part_error"]["max"] == pytest.approx(3e-5, rel=0.05)  # G64 P0.03 of the start-up code, and little else
    origin = answer["machine"]["origin"]
    assert answer["machine"]["source"] == "LinuxCNC" and set(origin.values()) == {"read", "computed", "guessed"}
    found = {one["code"] for one in scheme["findings"]}
    assert {"CL866", "CL980", "CL984", "CL985"} <= found
