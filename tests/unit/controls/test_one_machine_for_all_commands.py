"""One control's file, one program: every command plans within the same limits, and each reads the file once."""

from __future__ import annotations

import json
from dataclasses import astuple, replace
from pathlib import Path

import numpy as np
import pytest
from made_controls import GRBL, LINUXCNC, made_control
from typed_commands import invoke

import contourlab as cl
from contourlab.app.json_values import json_values
from contourlab.controls.linuxcnc import machine as reader
from contourlab.errors import ParameterError, ProgramError, ScenarioError
from contourlab.features.check.program_check import about_machine, check
from contourlab.features.limits.command import limits
from contourlab.features.run.options import Run
from contourlab.features.run.outcome import run_case
from contourlab.features.run.source import scenario_of
from contourlab.features.sweep.study import load_study
from contourlab.feed.bounds import Grbl, LinuxCNC
from contourlab.program import Reading, parse_program
from contourlab.scenario import load_machine, load_scenario, save
from contourlab.scenario.load import reading_on, scenario_from_parts

PROGRAM = "G0 X4 Y4\nG1 X4.1 F1\nG1 Y1 F200\nM2\n"


def made(folder: Path, *pairs: tuple[str, str], program: str = PROGRAM, text: str = LINUXCNC, name: str = "m.ini") -> tuple[Path, Path]:
    for old, new in pairs:
        assert old in text
        text = text.replace(old, new)
    (folder / name).write_text(text)
    (folder / "part.ngc").write_text(program)
    return folder / name, folder / "part.ngc"


def codes(found: object) -> list[str]:
    return [one.code for one in found.findings]  # type: ignore[attr-defined]


def times(machine: Path, part: Path) -> list[float]:
    run = scenario_from_parts(part, machine).base.reference().profile
    assert run is not None
    return [run.duration, check(part, machine=str(machine)).cycle_time or 0.0, limits(part, machine=str(machine)).cycle_time]


def test_a_bound_of_the_velocity_along_the_path_holds_in_every_command(tmp_path: Path) -> None:
    """A diagonal rapid of 4 sqrt(2) inches at 1 inch/s along the path and, as it expects a blend, half of 20 inch/s^2 of each axis."""
    machine, part = made(tmp_path, ("[TRAJ]\n", "[TRAJ]\nMAX_LINEAR_VELOCITY = 1\n"), program="G0 X4 Y4\nM2\n")
    bounded = times(machine, part)
    assert bounded[1:] == pytest.approx([bounded[0]] * 2, abs=1e-3)
    assert bounded[0] == pytest.approx(4 * 2**0.5 / 1.0 + 1.0 / (10 * 2**0.5), abs=1e-3)
    saved = tmp_path / "saved.toml"
    save(load_machine(machine), saved)
    assert load_machine(saved).planner_limits().path_velocity == pytest.approx(0.0254)
    free, _ = made(tmp_path, program="G0 X4 Y4\nM2\n")
    assert max(times(free, part)) < 0.6 * bounded[0]


def test_a_scenario_may_set_another_bound(tmp_path: Path) -> None:
    made(tmp_path, ("[TRAJ]\n", "[TRAJ]\nMAX_LINEAR_VELOCITY = 1\n"), program="G0 X4 Y4\nM2\n")
    (tmp_path / "s.toml").write_text('machine = "m.ini"\nprogram = "part.ngc"\n[feed]\npath_velocity = "50.8 mm/s"\n')
    case = load_scenario(tmp_path / "s.toml").base
    profile = case.reference().profile
    assert profile is not None and float(profile.v0.max()) == pytest.approx(0.0508)


def test_a_file_is_read_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    machine, part = made(tmp_path)
    angle = np.linspace(0.0, 2.0 * np.pi, 2001)
    at = 4.0 + np.stack([np.cos(angle), np.sin(angle)], axis=1)
    rows = np.column_stack([0.001 * np.arange(angle.size), at, at])
    log = tmp_path / "log.csv"
    np.savetxt(log, rows, delimiter=",", header="time [s],reference.x,reference.y,position.x,position.y", comments="")
    (tmp_path / "circle.ngc").write_text("G0 X5 Y4\nG64 P0.01\nG3 X5 Y4 I-1 F60\nM2\n")
    read: list[Path] = []
    monkeypatch.setattr(reader, "read_ini", lambda file, own=reader.read_ini: (read.append(file), own(file))[1])
    for asked in (
        lambda: check(part, machine=str(machine)),
        lambda: limits(part, machine=str(machine)),
        lambda: limits(log, machine=str(machine), unit="inch"),
        lambda: cl.measure(log, machine=str(machine)),
        lambda: cl.measure(log, machine=str(machine), program=tmp_path / "circle.ngc"),
        lambda: cl.circle(log, machine=str(machine)),
    ):
        read.clear()
        asked()
        assert len(read) == 1
    of_object = cl.measure(log, machine=load_machine(machine))  # which no command can name
    assert (of_object.command, of_object.data.next_steps) == ("", [])
    assert cl.circle(log, machine=load_machine(machine)).next_step == ""


@pytest.mark.parametrize(
    ("program", "zero", "code"),
    [
        ("G0 X1 Y1\nG1 X20 F100\nM2\n", None, "CL478"),
        ("G0 X1 Y1\nG53 G0 X9.5\nM2\n", None, "CL989"),
        ("G0 X1 Y1\nG1 X2 F100\nM2\n", "8, 1, 0", "CL470"),
        ("G0 X1 Y1\nG1 X2 F100\nM2\n", "3, 1, 0", None),
        ("G0 X1 Y1\nG1 X2 F100\nM2\n", None, None),
    ],
)
def test_limits_holds_a_program_against_travel_as_check_and_run_do(
    tmp_path: Path, program: str, zero: str | None, code: str | None
) -> None:
    machine, part = made(tmp_path, program=program)
    words = () if zero is None else ("--zero", zero)
    answers = {}
    for command in ("check", "limits"):
        said = invoke(tmp_path, command, part, "--machine", machine, "--json", *words)
        answers[command] = {found["code"] for found in json.loads(said.out)["findings"]}
        assert said.code == (2 if code else 0), command
    assert answers["check"] == answers["limits"]
    assert answers["limits"] & {"CL470", "CL478", "CL989"} == ({code} if code else set())
    assert ("CL985" in answers["limits"]) == (zero is None)
    if code:
        with pytest.raises(ProgramError):
            scenario_from_parts(part, machine, options={} if zero is None else {"zero": zero}).base.reference()


def test_a_machine_that_nobody_named_has_no_travel_to_leave(tmp_path: Path) -> None:
    (tmp_path / "part.ngc").write_text("G0 X1000\nM2\n")
    found = limits(tmp_path / "part.ngc")
    assert "CL471" in codes(found) and found.passed and found.exit_code == 0


def test_a_saved_machine_asks_for_the_zero_as_its_file_does(tmp_path: Path) -> None:
    """The zero of a program is unknown on both; with one, or with a parameter file, the travel has ends on both."""
    for text, name in ((LINUXCNC, "m.ini"), (GRBL, "grbl.txt")):
        file, _ = made(tmp_path, text=text, name=name)
        saved = tmp_path / f"{name}.toml"
        save(load_machine(file), saved)
        of_file, of_saved = load_machine(file), load_machine(saved)
        own = {one.code for one in of_file.control.findings}  # type: ignore[union-attr]
        for reading in (Reading(), Reading(zero="3, 1, 0"), Reading(parameters=tmp_path / "sim.var")):
            about = [{one.code for one in about_machine(machine, reading)} for machine in (of_file, of_saved)]
            assert about[0] - own - {"CL991"} == about[1]
            assert ("CL985" in about[1]) == (reading == Reading())


def test_a_saved_scenario_asks_for_the_zero_too(tmp_path: Path) -> None:
    machine, part = made(tmp_path)
    for options, known in (({}, False), ({"zero": "1, 1, 0"}, True)):
        saved = tmp_path / "saved.toml"
        save(scenario_from_parts(part, machine, options=options), saved)
        case = load_scenario(saved).base
        assert all(axis.limits.floating != known for axis in case.machine.axes)
        again = {one.code for one in about_machine(case.machine, case.motion.reading)}  # type: ignore[union-attr]
        assert ("CL985" in again) != known
        assert case.motion.program.moves == scenario_from_parts(part, machine, options=options).base.motion.program.moves  # type: ignore[union-attr]


@pytest.mark.parametrize(
    ("planner", "code", "jerk"),
    [
        ("", "CL996", None),
        ("PLANNER_TYPE = 0\nMAX_LINEAR_JERK = 100\n", "CL996", None),
        ("PLANNER_TYPE = 1\nMAX_LINEAR_JERK = 0\n", "CL996", None),
        ("PLANNER_TYPE = 1\nMAX_LINEAR_JERK = 0.5\n", "CL996", None),
        ("ARC_BLEND_ENABLE = 0\n", "CL991", None),
        ("ARC_BLEND_OPTIMIZATION_DEPTH = 1\n", "CL991", None),
        ("PLANNER_TYPE = 1\n", "CL991", None),
        ("PLANNER_TYPE = 1\nMAX_LINEAR_JERK = 1e9\n", "CL991", None),
        ("PLANNER_TYPE = 1\nMAX_LINEAR_JERK = 100\n", "CL990", 2.54),
    ],
)
def test_the_plan_says_which_jerk_it_assumed(tmp_path: Path, planner: str, code: str, jerk: float | None) -> None:
    machine, part = made(tmp_path, ("[TRAJ]\n", f"[TRAJ]\n{planner}"))
    assert [axis.limits.jerk for axis in load_machine(machine).axes] == pytest.approx([jerk or np.inf] * 2)
    checked = json.loads(invoke(tmp_path, "check", part, "--machine", machine, "--json").out)
    ran = run_case(scenario_from_parts(part, machine).base, explain=False)
    for findings in (checked["findings"], json_values(ran.findings)):
        said = {one["code"]: one["values"] for one in findings if one["code"] in ("CL990", "CL991", "CL996")}
        assert list(said) == [code]
        assert said[code].get("axes") == (None if code == "CL996" else ["x", "y"])
        assert said[code].get("jerk") == (None if jerk is None else pytest.approx(jerk))


def test_the_file_says_how_linuxcnc_plans(tmp_path: Path) -> None:
    """Its blends, its look-ahead and the override that corners are planned for; the ratio is bounded as there."""
    keys = "ARC_BLEND_OPTIMIZATION_DEPTH = 80\nARC_BLEND_KINK_RATIO = 0.9\nARC_BLEND_GAP_CYCLES = 2\n"
    machine, _ = made(tmp_path, ("[TRAJ]\n", f"[DISPLAY]\nMAX_FEED_OVERRIDE = 1.5\n[TRAJ]\n{keys}"))
    assert load_machine(machine).own_planner == LinuxCNC(1e-3, 0.7071, 82, 2.0, 1.5)
    saved = tmp_path / "saved.toml"
    save(load_machine(machine), saved)
    assert load_machine(saved).own_planner == LinuxCNC(1e-3, 0.7071, 82, 2.0, 1.5)
    assert load_machine(saved).planned_as("grbl").own_planner.planner_blocks == Grbl().planner_blocks
    plain, _ = made(tmp_path)
    assert load_machine(plain).own_planner == LinuxCNC()


@pytest.mark.parametrize("code", ["G17 G99.9", "G0 X1", "G64 P-1 Q", "G17 M22", "g21 g64 m 22"])
def test_a_fault_of_the_start_up_code_names_the_ini_file_and_its_line(tmp_path: Path, code: str) -> None:
    machine, part = made(tmp_path, ("G64 P0.001", f"{code}\nREMAP = M22 ngc=m22"))
    line = 1 + (tmp_path / "m.ini").read_text().splitlines().index(f"RS274NGC_STARTUP_CODE = {code}")
    for command in ("check", "run", "limits"):
        said = invoke(tmp_path, command, part, "--machine", machine)
        assert said.code == 2 and f"m.ini:{line}:" in said.out + said.err and "part.ngc:" not in said.out + said.err, command


@pytest.mark.parametrize(
    ("code", "modes"), [("", {None}), ("G17", {None}), ("G17 G64 P0.001", {0.001 * 0.0254}), ("g17 g61", set()), ("G 61.1", set())]
)
def test_a_linuxcnc_starts_in_g64(tmp_path: Path, code: str, modes: set[float | None]) -> None:
    machine, _ = made(tmp_path, ("RS274NGC_STARTUP_CODE = G64 P0.001", f"RS274NGC_STARTUP_CODE = {code}"))
    moves = parse_program("G1 X1 F1\nX2\nM2", reading=reading_on(load_machine(machine), {})).moves
    assert {move.mode.tolerance for move in moves if move.mode.control == "blend"} == modes  # type: ignore[union-attr]
    assert all(move.mode.control for move in moves)  # type: ignore[union-attr]


def test_subprograms_are_found_where_the_control_finds_them(tmp_path: Path) -> None:
    """As LinuxCNC's interpreter 2.9 does: PROGRAM_PREFIX, then SUBROUTINE_PATH; then beside the program, for copies of one."""
    more = "[DISPLAY]\nPROGRAM_PREFIX = nc\n[RS274NGC]\nSUBROUTINE_PATH = ~nobody.here/x:subs:more\n"
    machine, _ = made(tmp_path, ("[RS274NGC]\n", more))
    (tmp_path / "prog").mkdir()
    part = tmp_path / "prog" / "part.ngc"
    part.write_text("G21\no<foo> call\nM2\n")
    for folder, x in (("prog", 4), ("more", 3), ("subs", 2), ("nc", 1)):  # each comes before those that are there already
        (tmp_path / folder).mkdir(exist_ok=True)
        (tmp_path / folder / "foo.ngc").write_text(f"o<foo> sub\nG1 X{x} F100\no<foo> endsub\nM2\n")
        found = check(part, machine=str(machine))
        assert not found.problems and found.box["x"][1] == pytest.approx(1e-3 * x)


REMAPS = """REMAP=M6 modalgroup=6 ngc=change
REMAP = m400 modalgroup=10 argspec=Pq ngc=own
REMAP=G88.6 modalgroup=1 py=x
REMAP=T prolog=p ngc=t
"""


@pytest.mark.parametrize(
    ("line", "refused", "noted"),
    [
        ("M6", None, [1]),
        ("T1 M06", None, [4, 1]),
        ("m6 (M400)", None, [1]),
        ("t#1", None, [4]),
        ("M400 P1", 2, []),
        ("G88.6 X1", 3, []),
        ("N5 g 88.6", 3, []),
        ("#<_m6> = [1 LT 2]", None, []),
        ("G1 X[SQRT[4] + COS[0]] F10", None, []),
        ("M60", None, []),
    ],
)
def test_a_remapped_code_names_its_line_of_the_ini_file(tmp_path: Path, line: str, refused: int | None, noted: list[int]) -> None:
    """A code that has its own meaning is noted once, whichever way it is written; any other is refused."""
    machine, part = made(tmp_path, ("[RS274NGC]\n", "[RS274NGC]\n" + REMAPS), program=f"G0 X1\n{line}\n{line}\nM2\n")
    first = (tmp_path / "m.ini").read_text().splitlines().index(REMAPS.splitlines()[0])
    found = check(part, machine=str(machine))
    assert [problem.line for problem in found.problems] == ([2, 3] if refused else [])
    assert all(f"m.ini:{first + refused};" in problem.message and problem.code == "CL808" for problem in found.problems if refused)
    notes = [notice for notice in found.notices if "m.ini:" in notice.message]
    assert [f"m.ini:{first + k};" in notice.message and notice.line == 2 for k, notice in zip(noted, notes, strict=True)] == [True] * len(
        noted
    )


def test_a_number_that_stands_for_no_limit_is_none_in_every_command(tmp_path: Path) -> None:
    ini = reader.read_ini(made(tmp_path, ("MAX_VELOCITY = 2", "MAX_VELOCITY = 1e99\nMIN_LIMIT = -1e99\nHOME = nan\nBACKLASH = 0"))[0])
    assert ini.number("JOINT_0", "MAX_VELOCITY", positive=True) is None and ini.number("JOINT_0", "MIN_LIMIT") is None
    assert ini.number("JOINT_0", "BACKLASH") == 0.0 and ini.number("JOINT_0", "ABSENT") is None
    for key, positive in (("HOME", False), ("BACKLASH", True), ("MIN_LIMIT", True)):
        with pytest.raises(ScenarioError):
            ini.number("JOINT_0", key, positive=positive)
    with pytest.raises(ScenarioError):
        load_machine(made(tmp_path, ("SERVO_PERIOD = 1000000", "SERVO_PERIOD = 1e10"))[0])


@pytest.mark.parametrize(
    ("change", "planner"),
    [
        (("$13=0", "$13=0"), Grbl(1e-5, 2e-6, 16, (4e-6, 4e-6))),
        (("$11=0.010\n$12=0.002", "$11=0.05\n$12=0.01"), Grbl(5e-5, 1e-5, 16, (4e-6, 4e-6))),
        (("$13=0", "$160=0"), Grbl(1e-5, 2e-6, 100, (4e-6, 4e-6))),
        (("$13=0", "$160=0\n$398=35"), Grbl(1e-5, 2e-6, 35, (4e-6, 4e-6))),
        (("$13=0", "$800=10"), None),
    ],
)
def test_a_dump_says_how_its_control_plans(tmp_path: Path, change: tuple[str, str], planner: Grbl | None) -> None:
    """grblHAL with a limit of jerk is planned with it; its buffer is that of $398, by default 100."""
    machine, part = made(tmp_path, change, text=GRBL, name="grbl.txt", program="G0 X4 Y4\nG1 X9 F900\nG2 X9 Y9 I1 J2.5\nM2\n")
    loaded = load_machine(machine)
    assert loaded.planner_limits().planner == planner
    saved = tmp_path / "saved.toml"
    save(loaded, saved)
    assert load_machine(saved).planner_limits().planner == planner
    run, *others = times(machine, part)
    assert others == pytest.approx([run] * 2, rel=1e-12)
    assert ("CL995" in codes(check(part, machine=str(machine)))) == (planner is not None)


@pytest.mark.parametrize("planner", ["grbl", "linuxcnc"])
def test_a_plan_without_limits_of_jerk_keeps_the_other_limits(tmp_path: Path, planner: str) -> None:
    """On a machine that has limits of jerk: those of velocity and acceleration hold, and no jerk is asked for."""
    (tmp_path / "part.ngc").write_text("G61\nG1 X4 F900\nG1 X9 Y1\nG2 X19 Y11 I10\nM2\n")
    asked = limits(tmp_path / "part.ngc", machine="xyz", planner=planner)
    assert asked.passed and [peak.use for peak in asked.peaks if peak.kind == "jerk"] == [None] * 3
    assert limits(tmp_path / "part.ngc", machine="xyz", planner=planner, jerk="1 m/s^3").passed is False
    assert check(tmp_path / "part.ngc", planner=planner).cycle_time == asked.cycle_time


def test_a_configuration_of_fluidnc_says_how_it_plans(tmp_path: Path) -> None:
    machine = made_control(tmp_path, "fluidnc", ("name: a router\n", "name: a router\njunction_deviation_mm: 0.03\nplanner_blocks: 40\n"))
    assert astuple(load_machine(machine).own_planner)[:3] == pytest.approx((3e-5, 2e-6, 40), rel=1e-12)


def test_the_planner_is_that_of_the_option_then_of_the_scenario_then_of_the_file(tmp_path: Path) -> None:
    """A corner without a stop is quicker than with one; `check`, `limits` and `run` agree."""
    machine, part = made(tmp_path, text=GRBL, name="grbl.txt", program="G1 X4 F900\nG1 X9 Y1\nM2\n")
    own, _, _ = times(machine, part)
    stopping = [one(part, machine=str(machine), planner="jerk").cycle_time for one in (check, limits)]
    assert stopping[0] == stopping[1] and stopping[0] > 1.01 * own
    text = 'machine = "grbl.txt"\nprogram = "part.ngc"\n[feed]\nplanner = "jerk"\n'
    (tmp_path / "s.toml").write_text(text)
    settings = Run()
    assert scenario_of(tmp_path / "s.toml", settings).base.reference().duration == stopping[0]
    for file, more in ((tmp_path / "s.toml", {}), (part, {"machine": str(machine)})):
        assert scenario_of(file, replace(settings, planner="grbl", **more)).base.reference().duration == own
    case = load_scenario(tmp_path / "s.toml").base
    save(scenario_of(tmp_path / "s.toml", settings), tmp_path / "again.toml")
    assert load_scenario(tmp_path / "again.toml").base.machine.planner == case.machine.planner == "jerk"
    (tmp_path / "s.toml").write_text(text.replace("jerk", "grbl") + 'path_control = "blend"\n')
    with pytest.raises(ScenarioError, match="path_control"):
        load_scenario(tmp_path / "s.toml")
    said = invoke(tmp_path, "limits", part.name, "--machine", "xyz", "--planner", "grbl", "--dialect", "grblhal")
    assert "--planner grbl --dialect grblhal" in said.out.replace("\n  ", " ")
    (tmp_path / "log.csv").write_text("time [s],command.x [mm]\n" + "".join(f"{k / 1000},{k}\n" for k in range(9)))
    with pytest.raises(ParameterError, match="--planner"):
        limits(tmp_path / "log.csv", planner="grbl")


def test_a_machine_takes_the_place_of_that_of_a_scenario(tmp_path: Path) -> None:
    """It brings the controller of its control, whose loops are closed there."""
    machine, part = made(tmp_path)
    scenario, study = tmp_path / "s.toml", tmp_path / "study.toml"
    scenario.write_text(f'machine = "builtin:xyz"\ncontroller = "builtin:xyz-controller"\nprogram = "{part.name}"\n')
    study.write_text('scenario = "s.toml"\nvariants = 2\n[vary]\n"feed.override" = { values = [0.5, 1.0] }\n')
    own = [axis.plant for axis in load_machine(machine).axes]
    cases = [load_scenario(scenario, machine=machine).base, *load_study(study, machine=str(machine)).cases.values()]
    assert [[axis.plant for axis in case.machine.axes] for case in cases] == [own] * len(cases)
    said = invoke(tmp_path, "compare", "s.toml", "--machine", machine.name, "--no-interval", "--json")
    assert said.code == 0 and json.loads(said.out)["machine"]["source"] == "LinuxCNC"
    with pytest.raises(ParameterError):
        cl.compare(load_scenario(scenario), machine=str(machine))
