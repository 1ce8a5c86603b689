"""INI and HAL files: what they say, and where a wiring is missing or unusual."""

from pathlib import Path

import pytest
from linuxcnc_rig import Rig

from contourlab.errors import ScenarioError
from contourlab.features.commission.command import changes
from contourlab.features.commission.excitation import excitation, sampler, sampler_columns
from contourlab.features.commission.setup import Setup, read_setup
from contourlab.program import parse_program


def setup_of(folder: Path, *hal: tuple[str, str], ini: tuple[tuple[str, str], ...] = ()) -> Setup:
    """Return the setup of the rig's files with texts replaced."""
    files = Rig().write(folder)
    for file, pairs in zip(files, (ini, hal), strict=True):
        text = file.read_text()
        for old, new in pairs:
            assert old in text
            text = text.replace(old, new)
        file.write_text(text)
    return read_setup(*files)


def places(setup: Setup, code: str) -> list[str]:
    return [one.place for one in setup.findings if one.code == code]


def test_gains_come_from_the_ini_file_and_keep_their_places(tmp_path: Path) -> None:
    setup = setup_of(tmp_path)
    x, y = setup.axes
    assert (x.name, x.joint, x.pid, y.pid) == ("x", 0, "pid.x", "pid.y")
    assert x.gains == {"Pgain": 0.8, "Igain": 0.5, "Dgain": 0.0, "FF0": 0.0, "FF1": 0.015, "FF2": 0.0, "FF3": 0.0}
    assert x.limits == {"velocity": 200.0, "acceleration": 1000.0, "low": -200.0, "high": 200.0}
    assert x.places["Pgain"].file == setup.ini.file
    assert setup.ini.file.read_text().splitlines()[x.places["Pgain"].line - 1] == "P = 0.8"
    assert x.signals == {"command": "x-cmd", "feedback": "x-fb", "output": "x-out"}
    assert (setup.unit, setup.period, x.always_enabled) == (1e-3, 1e-3, False)
    assert [(one.code, one.place) for one in setup.findings] == [("CL852", "axis z")]


def test_numbered_pids_and_gains_in_the_hal_file(tmp_path: Path) -> None:
    pairs = [("names=pid.x,pid.y", "num_chan=2"), ("setp pid.x.Pgain [JOINT_0]P", "setp pid.0.Pgain 7.5  # by hand"), ("pid.x", "pid.0")]
    setup = setup_of(tmp_path, *pairs, ("pid.y", "pid.1"))
    assert [axis.pid for axis in setup.axes] == ["pid.0", "pid.1"]
    assert setup.axes[0].gains["Pgain"] == 7.5
    assert setup.axes[0].places["Pgain"].file == setup.hal


def test_inch(tmp_path: Path) -> None:
    setup = setup_of(tmp_path, ini=(("LINEAR_UNITS = mm", "LINEAR_UNITS = inch"),))
    assert (setup.unit, setup.unit_name) == (0.0254, "inch")
    assert "G20" in excitation(setup).splitlines()[1]


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ("net x-fb axis.x.motor => pid.x.feedback joint.0.motor-pos-fb", "net x-fb axis.x.motor => joint.0.motor-pos-fb", "CL854"),
        ("=> pid.x.feedback joint.0.motor-pos-fb", "=> pid.x.feedback", "CL855"),
        ("net x-enable joint.0.amp-enable-out => pid.x.enable\n", "", "CL856"),
        ("net x-enable joint.0.amp-enable-out => pid.x.enable", "setp pid.x.enable 1", "CL861"),
        ("addf pid.x.do-pid-calcs servo-thread\n", "", "CL857"),
        ("loadrt pid", "addf pid.x.do-pid-calcs servo-thread\nloadrt pid", "CL858"),
        ("setp pid.x.FF0", "setp pid.x.maxerror 0.001\nsetp pid.x.FF0", "CL859"),
        ("=> pid.x.command", "=> pid.x.command\nnet xv joint.0.vel-cmd => pid.x.command-deriv", "CL860"),
    ],
)
def test_unusual_wiring_is_named(tmp_path: Path, old: str, new: str, code: str) -> None:
    setup = setup_of(tmp_path, (old, new))
    assert [one.code for one in setup.findings if one.code != "CL852"] == [code]


def test_a_finding_names_file_and_line(tmp_path: Path) -> None:
    setup = setup_of(tmp_path, ("setp pid.x.FF0", "setp pid.x.maxerror 0.001\nsetp pid.x.FF0"))
    line = setup.hal.read_text().splitlines().index("setp pid.x.maxerror 0.001") + 1
    assert places(setup, "CL859") == [f"rig.hal:{line}"]


def test_dead_band_and_bias_are_read_where_they_are_set(tmp_path: Path) -> None:
    setup = setup_of(tmp_path, ("setp pid.x.FF0", "setp pid.x.deadband 0.001\nsetp pid.x.bias 0.2\nsetp pid.x.FF0"))
    x, y = setup.axes
    assert (x.gains["deadband"], x.gains["bias"]) == (0.001, 0.2) and not {"deadband", "bias"} & y.gains.keys()
    assert [one.code for one in setup.findings] == ["CL852"]


def test_missing_unit_and_period(tmp_path: Path) -> None:
    setup = setup_of(tmp_path, ini=(("LINEAR_UNITS = mm\n", ""), ("SERVO_PERIOD = 1000000\n", "")))
    assert {"CL850", "CL851"} <= {one.code for one in setup.findings}


@pytest.mark.parametrize(
    ("key", "old", "new"),
    [
        ("MAX_VELOCITY", "200", "0"),
        ("MAX_VELOCITY", "200", "inf"),
        ("MAX_ACCELERATION", "1000", "-5"),
        ("MAX_LIMIT", "200", "1e99"),
        ("MAX_LIMIT", "200", "-300"),
        ("SERVO_PERIOD", "1000000", "0"),
    ],
)
def test_limits_that_cannot_be_are_refused(tmp_path: Path, key: str, old: str, new: str) -> None:
    with pytest.raises(ScenarioError, match=key):
        setup_of(tmp_path, ini=((f"{key} = {old}\n", f"{key} = {new}\n"),))


def test_no_pid_at_all_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match="motor-pos-cmd"):
        setup_of(tmp_path, ("pid.x.command", "other.x"), ("pid.y.command", "other.y"))


def test_a_file_that_the_ini_file_does_not_name_is_read_alone(tmp_path: Path) -> None:
    ini, hal = Rig().write(tmp_path)
    copy = tmp_path / "copy.hal"
    copy.write_text(hal.read_text().replace("setp pid.x.Pgain [JOINT_0]P", "setp pid.x.Pgain 3"))
    assert read_setup(ini, copy).axes[0].gains["Pgain"] == 3.0
    assert read_setup(ini, hal).axes[0].gains["Pgain"] == 0.8


def test_words_of_gcode_make_no_part_program_of_a_configuration(tmp_path: Path) -> None:
    pairs = (("[DISPLAY]", "[HALUI]\nMDI_COMMAND = G0 X0\nG1 X1 F100\n[DISPLAY]"),)
    setup = setup_of(tmp_path, ("setp pid.x.FF0", "net x-more \\\n  x-drive.command\nsetp pid.x.FF0"), ini=pairs)
    assert [axis.name for axis in setup.axes] == ["x", "y"]


@pytest.mark.parametrize("text", ["G21 G90\nG1 X1 F100\n", '[machine]\nname = "m"\n', "", "1,2\n3,4\n5,6\n"])
def test_a_file_of_another_kind_is_no_ini_file(tmp_path: Path, text: str) -> None:
    _, hal = Rig().write(tmp_path)
    other = tmp_path / "other.ini"
    other.write_text(text)
    with pytest.raises(ScenarioError, match="not a file of LinuxCNC"):
        read_setup(other, hal)
    with pytest.raises(ScenarioError, match="a folder, not a file of LinuxCNC"):
        read_setup(tmp_path, hal)


def test_angular_joints_are_left_out(tmp_path: Path) -> None:
    setup = setup_of(tmp_path, ini=(("[JOINT_1]\nTYPE = LINEAR", "[JOINT_1]\nTYPE = ANGULAR"),))
    assert [axis.name for axis in setup.axes] == ["x"] and places(setup, "CL863") == ["axis y"]


def test_excitation_stays_within_travel_and_limits(tmp_path: Path) -> None:
    pairs = (("MIN_LIMIT = -200", "MIN_LIMIT = 10"), ("MAX_LIMIT = 200", "MAX_LIMIT = 50"), ("MAX_VELOCITY = 200", "MAX_VELOCITY = 80"))
    setup = setup_of(tmp_path, ini=pairs)
    program = parse_program(excitation(setup), "excite.ngc")
    moves = [move for move in program.moves if hasattr(move, "end")]
    ends = [1e3 * move.end[k] for move in moves for k in (0, 1)]
    assert min(ends[2:]) >= 10.0
    assert max(ends) <= 50.0
    feeds = {round(1e3 * move.feedrate, 6) for move in moves}
    assert max(feeds) == 80.0
    assert len(feeds) >= 6
    assert {move.turns for move in moves if hasattr(move, "turns")} == {1, -1}


def test_sampler_records_each_axis(tmp_path: Path) -> None:
    setup = setup_of(tmp_path)
    lines = sampler(setup).splitlines()
    assert sampler_columns(setup) == ["x_cmd", "x", "x_out", "y_cmd", "y", "y_out"]
    assert "loadrt sampler depth=16000 cfg=ffffff" in lines
    assert "net y-fb => sampler.0.pin.4  # y" in lines


def test_changes_set_the_gains_and_nothing_else(tmp_path: Path) -> None:
    setup = setup_of(tmp_path, ("setp pid.x.Pgain [JOINT_0]P", "setp pid.x.Pgain 0.8  # 0.8 by hand"))
    before = setup.ini.file.read_bytes(), setup.hal.read_bytes()
    diff = changes(setup, {"x": {"Pgain": 20.0, "FF1": 0.04, "FF3": 1e-6}, "y": {"Igain": 0.5}})
    changed = {line for line in diff.splitlines() if line[0] in "+-" and line[:3] not in ("+++", "---")}
    assert changed == {
        "-setp pid.x.Pgain 0.8  # 0.8 by hand",
        "+setp pid.x.Pgain 20  # 0.8 by hand",
        "-FF1 = 0.015",
        "+FF1 = 0.04",
        "+setp pid.x.FF3 1e-06",
    }
    assert before == (setup.ini.file.read_bytes(), setup.hal.read_bytes())
