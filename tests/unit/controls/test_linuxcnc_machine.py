"""LinuxCNC's own files as a machine: work offsets, tools, units, what closes the loops, and what is absent."""

import json
import math
import re
from pathlib import Path

import numpy as np
import pytest
from made_controls import LINUXCNC
from reference_data import reference_file
from typed_commands import invoke

import contourlab as cl
from contourlab.controls import control_file
from contourlab.errors import LogError, ParameterError, ProgramError, ScenarioError
from contourlab.feed import Reference
from contourlab.feed.reference import ReferenceBlock
from contourlab.loop.simulate import sampler
from contourlab.program import Reading, parse_program
from contourlab.scenario import dump, load_machine, load_scenario
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


def blocks_of(reference: Reference) -> list[ReferenceBlock]:
    return [reference.block(start, stop, sampler(True)) for start, stop in reference.blocks(4096)]


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


@pytest.mark.parametrize("zero", ["1, 2", "1, 2, x", "1, 2, inf", "1;2;3", "nan,0,0"])
def test_a_zero_that_is_no_point_is_refused(zero: str, tmp_path: Path) -> None:
    (tmp_path / "part.ngc").write_text(PROGRAM)
    (tmp_path / "s.toml").write_text(f'machine = {{file = "m.ini"}}\n[program]\nfile = "part.ngc"\nzero = "{zero}"\n')
    machine = ("--machine", machine_file(tmp_path), "--zero", zero)
    heads = {("check", "part.ngc", *machine): "--zero", ("run", "part.ngc", *machine): "--zero", ("run", "s.toml"): "s.toml: program.zero:"}
    for words, head in heads.items():
        said = invoke(tmp_path, *words)
        assert said.code == 2 and len(said.err.strip().splitlines()) == 1 and said.err.startswith(f"contourlab: {head}")


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
    said = invoke(tmp_path, "run", part, "--machine", file, "--json", "--zero", "8, 1, 0")
    (problem,) = json.loads(said.out)["problems"]
    assert (said.code, problem["code"], problem["line"]) == (2, "CL470", 2) and said.err.rstrip().endswith("[CL470]")


def test_machine_coordinates_are_held_against_the_travel_without_a_zero(tmp_path: Path) -> None:
    """G53 knows where it leads; the travel of x is -1 to 9 inches."""
    part, file = tmp_path / "part.ngc", machine_file(tmp_path)
    for end, code in (("9", 0), ("9.1", 2), ("-1.1", 2)):
        part.write_text(PROGRAM.replace("M2", f"G53 G0 X{end}\nM2"))
        said = invoke(tmp_path, "check", part, "--machine", file, "--json")
        assert (said.code, "CL989" in said.out) == (code, bool(code)), end
        if code:
            with pytest.raises(ProgramError) as caught:
                scenario_from_parts(part, file).base.reference()
            assert (caught.value.code, caught.value.line) == ("CL989", 4)


def test_what_is_absent_is_named_and_the_rest_is_read(tmp_path: Path) -> None:
    more = [("[RS274NGC]\n", "[RS274NGC]\nPARAMETER_FILE = a.var\n"), ("[EMCMOT]", "[EMCIO]\nTOOL_TABLE = t.tbl\n[EMCMOT]")]
    file = machine_file(tmp_path, *more, ("[HAL]", "[HAL]\nHALFILE = absent.hal\nHALFILE = script.tcl"))
    assert sorted(codes(file)) == ["CL866", "CL866", "CL980", "CL980", "CL984"]
    assert load_machine(file).axes[0].limits.velocity == pytest.approx(0.0508)


def test_a_tool_table_has_tool_0_and_the_first_of_two(tmp_path: Path) -> None:
    (tmp_path / "tool.tbl").write_text("T0 P0\nT1 P1 Z2\nT1 P1 Z5\n")
    program = parse_program("T1 M6\nG43\nG0 X1 Z0\nM2", reading=Reading(tools=tmp_path / "tool.tbl"))
    assert program.moves[0].end[2] == pytest.approx(0.002)


@pytest.mark.parametrize("home", ["[JOINT_0]\nHOME = 5", "[JOINT_0]"])
def test_the_axes_begin_where_they_are_homed(tmp_path: Path, home: str) -> None:
    """So that a start at machine zero, outside the travel, is no fault of the program."""
    file = machine_file(tmp_path, ("MIN_LIMIT = -1\nMAX_LIMIT = 9", "MIN_LIMIT = 5\nMAX_LIMIT = 9"), ("[JOINT_0]", home))
    part = tmp_path / "part.ngc"
    part.write_text(PROGRAM)
    said = invoke(tmp_path, "check", part, "--machine", file, "--zero", "5, 1, 0", "--json")
    assert said.code == 0
    assert json.loads(said.out)["box"]["x"] == pytest.approx([5 * 0.0254, 7 * 0.0254])


def test_a_zero_leaves_no_shift_of_g92(tmp_path: Path) -> None:
    (tmp_path / "sim.var").write_text("5210\t1\n5211\t1.5\n")
    reading = Reading(parameters=tmp_path / "sim.var", zero="100, 0, 0")
    assert parse_program("G0 X30\nM2", reading=reading).moves[0].end[0] == pytest.approx(0.13)


@pytest.mark.parametrize("hal", ["loadrt corexykins", "loadrt trivkins coordinates=XZ"])
def test_kinematics_that_only_hal_names(tmp_path: Path, hal: str) -> None:
    file = machine_file(tmp_path, ("[KINS]\nKINEMATICS = trivkins coordinates=XY\n", ""), ("[HAL]\n", f"[HAL]\nHALCMD = {hal}\n"))
    if "core" in hal:
        with pytest.raises(ScenarioError):
            load_machine(file)
    else:
        assert load_machine(file).axis_names == ("x", "z")


def test_axes_of_an_old_lathe_have_the_numbers_of_their_letters(tmp_path: Path) -> None:
    old = LINUXCNC.replace("trivkins coordinates=XY", "trivkins").replace("[TRAJ]", "[TRAJ]\nCOORDINATES = X Z")
    old = old.replace("[JOINT_0]", "[AXIS_0]").replace("[JOINT_1]", "[AXIS_2]").replace("[AXIS_Y]\nMIN_LIMIT = 0\nMAX_LIMIT = 5\n", "")
    machine = load_machine(machine_file(tmp_path, text=old))
    assert machine.axis_names == ("x", "z") and machine.axis("z").limits.velocity == pytest.approx(0.0762)


def test_both_sides_of_a_gantry_count(tmp_path: Path) -> None:
    more = "STEP_SCALE = 4000\n[JOINT_2]\nMAX_VELOCITY = 1\nMAX_ACCELERATION = 20\n[AXIS_Y]"
    file = machine_file(tmp_path, ("coordinates=XY", "coordinates=XYX"), ("STEP_SCALE = 4000\n[AXIS_Y]", more))
    assert load_machine(file).axes[0].limits.velocity == pytest.approx(0.0254) and "CL982" in codes(file)


def test_the_velocity_along_the_path_is_bounded(tmp_path: Path) -> None:
    file = machine_file(tmp_path, ("[TRAJ]\n", "[TRAJ]\nMAX_LINEAR_VELOCITY = 1\n"))
    part = tmp_path / "part.ngc"
    part.write_text("G0 X4 Y4\nG1 X4.1 F1\nM2\n")
    case = scenario_from_parts(part, file).base
    speed = max(float((block.velocity**2).sum(axis=1).max() ** 0.5) for block in blocks_of(case.reference()))
    assert speed == pytest.approx(0.0254, rel=1e-6)


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
    ("hal", "place"),
    [
        (b"source 1.hal\n", r"1\.hal:1: source 1\.hal"),
        (b"\nsource 2.hal\n", r"2\.hal:1: source 1\.hal"),
        (bytes(range(256)), r"1\.hal: is no text"),
    ],
)
def test_a_hal_file_that_linuxcnc_would_not_end(tmp_path: Path, hal: bytes, place: str) -> None:
    (tmp_path / "1.hal").write_bytes(hal)
    (tmp_path / "2.hal").write_text("source 1.hal\n")
    with pytest.raises(ScenarioError, match=place):
        load_machine(machine_file(tmp_path, ("[HAL]\n", "[HAL]\nHALFILE = 1.hal\n")))


def test_an_absent_include_is_named_with_its_line(tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match=r"m\.ini:2: #INCLUDE absent\.inc"):
        load_machine(machine_file(tmp_path, ("MACHINE =", "#INCLUDE absent.inc\nMACHINE =")))


@pytest.mark.parametrize("scale", ["STEP_SCALE = 0", "STEP_SCALE = 4000\nENCODER_SCALE = -0.0", "INPUT_SCALE = .0e3"])
def test_a_scale_that_divides_is_not_0(tmp_path: Path, scale: str) -> None:
    with pytest.raises(ScenarioError, match=r"m\.ini:\d+: \[JOINT_0\]"):
        load_machine(machine_file(tmp_path, ("[JOINT_0]\n", f"[JOINT_0]\n{scale}\n")))


@pytest.mark.parametrize("key", ["[DISPLAY]MAX_FEED_OVERRIDE", "[TRAJ]ARC_BLEND_GAP_CYCLES", "[TRAJ]MAX_LINEAR_VELOCITY"])
def test_a_number_out_of_range_is_named_as_the_control_names_it(tmp_path: Path, key: str) -> None:
    line = key.replace("]", "]\n") + " = -1\n"
    with pytest.raises(ScenarioError, match=rf"^\S*m\.ini:2\W+{re.escape(key)}\W"):
        load_machine(machine_file(tmp_path, text=line + LINUXCNC))


@pytest.mark.parametrize("dialect", ["grbl", "fanuc", "mach3"])
def test_the_start_up_code_is_read_in_the_dialect_of_its_control(tmp_path: Path, dialect: str) -> None:
    machine = load_machine(machine_file(tmp_path, ("P0.001", "P0.001 G90.1 G97")))
    first, *_ = parse_program("G0 X1 Y1\nM2\n", reading=reading_on(machine, {"dialect": dialect})).moves
    assert first.mode.tolerance == pytest.approx(0.001 * 0.0254)  # type: ignore[union-attr]
    with pytest.raises(ProgramError, match="G97"):
        parse_program("G0 X1 Y1\nM2\n", reading=reading_on(machine, {"dialect": "grbl", "startup": "G97"}))


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
    for refused in (load_machine(file).check_modelled, lambda: dump(load_machine(file))):
        with pytest.raises(ParameterError):
            refused()


def test_a_scenario_takes_controller_and_program_reading_from_the_control(tmp_path: Path) -> None:
    machine_file(tmp_path)
    (tmp_path / "part.ngc").write_text(PROGRAM)
    (tmp_path / "s.toml").write_text('machine = "m.ini"\nprogram = "part.ngc"\n')
    case = load_scenario(tmp_path / "s.toml").base
    assert {axis.controller.kind for axis in case.controller.axes.values()} == {"steps"}
    assert case.reference().path.position([0.0])[0, 0] == pytest.approx(0.0)
    assert float(case.reference().path.position([case.reference().path.length])[0, 0]) == pytest.approx(2 * 0.0254)


def test_a_log_has_the_unit_of_its_machine(tmp_path: Path) -> None:
    """A circle of 1 inch, run 1 mil too large; the file states no unit."""
    angle = np.linspace(0.0, 2.0 * math.pi, 2001)
    circle = np.stack([np.cos(angle), np.sin(angle)])
    rows = np.concatenate([0.001 * np.arange(angle.size)[None], circle, 1.001 * circle]).T
    header = "time [s],reference.x,reference.y,position.x,position.y"
    np.savetxt(tmp_path / "log.csv", rows, delimiter=",", header=header, comments="")
    with pytest.raises(LogError):
        cl.measure(tmp_path / "log.csv")
    found = cl.measure(tmp_path / "log.csv", machine=str(machine_file(tmp_path))).runs[0].metrics.contour_error
    assert found.max == pytest.approx(2.54e-5, rel=1e-3)
    assert found.max == cl.measure(tmp_path / "log.csv", unit="inch").runs[0].metrics.contour_error.max


@pytest.mark.slow
def test_the_router_of_a_newcomer(tmp_path: Path) -> None:
    """INI, HAL and part to a verdict in one command; every number has its origin."""
    folder = reference_file("repro", "trial3")
    said = invoke(tmp_path, "run", folder / "bracket.ngc", "--machine", folder / "router.ini", "--tolerance", "50 um", "--json")
    answer = json.loads(said.out)
    (scheme,) = answer["schemes"].values()
    assert said.code == 0 and scheme["verdict"]["passed"]
    # G64 P0.03 of the start-up code, and little else: the arc in a right angle is 30 um from the corner, and this from its lines.
    assert scheme["metrics"]["part_error"]["max"] == pytest.approx(3e-5 / 2**0.5, rel=0.05)
    origin = answer["machine"]["origin"]
    assert answer["machine"]["source"] == "LinuxCNC" and set(origin.values()) == {"read", "computed", "guessed"}
    found = {one["code"] for one in scheme["findings"]}
    assert {"CL866", "CL980", "CL984", "CL985", "CL996"} <= found
