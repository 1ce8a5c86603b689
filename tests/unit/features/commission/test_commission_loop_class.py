"""What a pid closes its loop on: by the files in the forms that people use, and by a log where the files cannot say."""

from pathlib import Path

import numpy as np
import pytest
from each import each
from made_two_masses import TwoMasses, drawn

from contourlab.errors import ScenarioError
from contourlab.features.commission.records import decided
from contourlab.features.commission.setup import Setup, read_setup

STEPS, VELOCITY, SERVO, UNKNOWN = "step generator", "velocity drive", "servo", "unknown"
INI = """[KINS]
KINEMATICS = trivkins coordinates=X
JOINTS = 1
[EMCMOT]
SERVO_PERIOD = 1000000
[TRAJ]
LINEAR_UNITS = mm
COORDINATES = X
[HMOT]
CARD0 = hm2_7i76e.0
[HAL]
{hal}
[JOINT_0]
MIN_LIMIT = 0
MAX_LIMIT = 100
MAX_VELOCITY = 50
MAX_ACCELERATION = 500
P = 50
"""
PID = """loadrt pid names=pid.x
addf motion-controller servo-thread
addf pid.x.do-pid-calcs servo-thread
net x-enable joint.0.amp-enable-out => pid.x.enable
net x-cmd joint.0.motor-pos-cmd => pid.x.command
net x-fb => joint.0.motor-pos-fb
setp pid.x.Pgain [JOINT_0]P
"""
OWN = "net x-out pid.x.output => stepgen.0.velocity-cmd\nnet x-fb stepgen.0.position-fb => pid.x.feedback\n"


def setup_of(folder: Path, hal: str, *, names: str = "HALFILE = m.hal", **files: str) -> Setup:
    """Return the setup of a machine with one axis."""
    for name, text in {"m.ini": INI.format(hal=names), "m.hal": PID + hal, **files}.items():
        (folder / name.replace("_", ".")).write_text(text)
    return read_setup(folder / "m.ini", folder / "m.hal")


def loop_of(setup: Setup) -> str:
    (axis,) = setup.axes
    assert axis.loop.why
    return axis.loop.loop


CARD, MESA, BUS = "[HMOT](CARD0)", "hm2_5i25.0", "lcec.0.x"
FORMS = {  # what takes the output, where the feedback comes from, further lines, and the class
    "mesa stepgen": (f"{CARD}.stepgen.00.velocity-cmd", f"{CARD}.stepgen.00.position-fb", "", STEPS),
    "parport stepgen": ("stepgen.0.velocity-cmd", "stepgen.0.position-fb", "", STEPS),
    "riocore": ("fpga0.stepdir0.velocity", "fpga0.stepdir0.position", "", STEPS),
    "remora, open": ("remora.joint.0.vel-cmd", "remora.joint.0.pos-fb", "", STEPS),
    "remora, encoder": ("remora.joint.0.vel-cmd", "remora.joint.0.encoder-count", "", VELOCITY),
    "remora, encoder by module": ("remora.joint.0.vel-cmd", "measuredJ0.position", "loadrt PRUencoder names=measuredJ0", VELOCITY),
    "stepgen with a scale": (f"{MESA}.stepgen.00.velocity-cmd", f"{MESA}.encoder.00.position", "", VELOCITY),
    "stepgen, fed by an unknown": ("stepgen.0.velocity-cmd", "laser.0.position", "", UNKNOWN),
    "stepgen, fed by a choice": (
        "stepgen.0.velocity-cmd",
        "mux2.0.out",
        "loadrt mux2\nnet s stepgen.0.position-fb mux2.0.in0\nnet e encoder.0.position mux2.0.in1",
        UNKNOWN,
    ),
    "counts through scale": (
        "stepgen.0.velocity-cmd",
        "scale.0.out",
        "loadrt scale\nnet c stepgen.0.counts conv-s32-float.0.in\nnet f conv-s32-float.0.out scale.0.in",
        STEPS,
    ),
    "board that may count its steps": ("ppmc.0.stepgen.00.velocity", "ppmc.0.encoder.00.position", "", UNKNOWN),
    "mesa pwmgen": (f"{MESA}.pwmgen.00.value", f"{MESA}.encoder.00.position", "", UNKNOWN),
    "mesa analogue": (f"{MESA}.7i77.0.1.analogout0", f"{MESA}.encoder.00.position", "", UNKNOWN),
    "dac": ("ppmc.0.DAC.00.value", "ppmc.0.encoder.00.position", "", UNKNOWN),
    "mesa current": (f"{MESA}.8i20.0.1.current", f"{MESA}.resolver.00.position", "", SERVO),
    "cia402 velocity": ("cia402.0.velocity-cmd", "cia402.0.pos-fb", "loadrt cia402", VELOCITY),
    "cia402 by name": ("x-drive.velocity-cmd", "x-drive.pos-fb", "loadrt cia402 names=x-drive", VELOCITY),
    "lcec velocity": (f"{BUS}.target-velocity", f"{BUS}.actual-position", "", VELOCITY),
    "lcec torque": (f"{BUS}.target-torque", f"{BUS}.actual-position", "", SERVO),
    "lcec analogue": (f"{BUS}.aout-0-value", "lcec.0.enc.enc-0-pos", "", UNKNOWN),
    "slave named level": ("lcec.0.level.value", "lcec.0.level.pos", "", UNKNOWN),
    "unknown component": ("mine.0.in", "mine.0.out", "", UNKNOWN),
    "two sinks": ("stepgen.0.velocity-cmd", "stepgen.0.position-fb", f"net o {MESA}.pwmgen.00.value", UNKNOWN),
    "watched signals": (
        "stepgen.0.velocity-cmd",
        "stepgen.0.position-fb",
        "net o sampler.0.pin.0\nnet x-fb sampler.0.pin.1 wcomp.0.in pyvcp.x",
        STEPS,
    ),
    "linked anew": (
        "stepgen.0.velocity-cmd",
        "stepgen.0.position-fb",
        f"unlinkp pid.x.feedback\nunlinkp stepgen.0.position-fb\nnet scale-fb {MESA}.encoder.00.position pid.x.feedback",
        VELOCITY,
    ),
}
WRITTEN = (
    "net o pid.x.output => {sink}\nnet x-fb {source} => pid.x.feedback\n",
    "net o <= pid.x.output\nnet o => {sink}\nnet x-fb <= {source}\nnet x-fb => pid.x.feedback\n",
    "net x-fb pid.x.feedback {source}  # the feedback\nnet o \\\n  {sink} pid.x.output\n",
    "linkps pid.x.output => o\nlinksp o => {sink}\nlinkps {source} => x-fb\nlinksp x-fb => pid.x.feedback\n",
)


@pytest.mark.parametrize(("sink", "source", "more", "loop"), FORMS.values(), ids=FORMS)
@pytest.mark.parametrize("written", WRITTEN)
def test_forms(tmp_path: Path, sink: str, source: str, more: str, loop: str, written: str) -> None:
    setup = setup_of(tmp_path, f"{written.format(sink=sink, source=source)}{more}\n")
    assert loop_of(setup) == loop
    assert ("CL864" in {one.code for one in setup.findings}) == (loop == STEPS)
    assert len(setup.closed) == (loop != STEPS)


@pytest.mark.parametrize(("output", "loop"), [(OWN, STEPS), (OWN.replace("x-fb stepgen.0.position-fb", "x-fb laser.0.position"), UNKNOWN)])
def test_limits_inside_a_pid_count_where_its_loop_is_predicted(tmp_path: Path, output: str, loop: str) -> None:
    setup = setup_of(tmp_path, f"{output}setp pid.x.maxerror 0.01\nnet v joint.0.vel-cmd pid.x.command-deriv\n")
    assert loop_of(setup) == loop
    assert {one.code for one in setup.findings} & {"CL859", "CL860"} == (set() if loop == STEPS else {"CL859", "CL860"})


CHAIN = ("scale.0 in", "limit3.0 in", "mult2.0 in1", "sum2.0 in0", "mux4.0 in2", "lowpass.0 in", "abs.0 in", "offset.0 in", "mux-gen.0 in")


@pytest.mark.parametrize("length", range(len(CHAIN) + 1))
@pytest.mark.parametrize("back", [False, True])
def test_values_are_followed_through_components(tmp_path: Path, length: int, back: bool) -> None:
    """A chain of any length before the sink, or before the feedback, changes no class; its selectors and gains lead nowhere."""
    source, sink = ("stepgen.0.position-fb", "pid.x.feedback") if back else ("pid.x.output", "stepgen.0.velocity-cmd")
    lines = []
    for k, (name, enters) in enumerate(link.split() for link in CHAIN[:length]):
        lines += [f"net chain{k} {source} {name}.{enters}", f"net other{k} {name}.gain hm2_5i20.0.encoder.07.position"]
        source = f"{name}.out"
    lines.append(f"net last {source} => {sink} hm2_5i20.0.gpio.000.value")
    direct = OWN.splitlines()[0 if back else 1]
    setup = setup_of(tmp_path, "\n".join([*lines, direct]) + "\n")
    assert loop_of(setup) == STEPS


def test_the_way_back_of_an_offset(tmp_path: Path) -> None:
    hal = "net a pid.x.output offset.0.in\nnet b offset.0.out stepgen.0.velocity-cmd\n"
    hal += "net c stepgen.0.position-fb offset.0.fb-in\nnet x-fb offset.0.fb-out pid.x.feedback\n"
    assert loop_of(setup_of(tmp_path, hal)) == STEPS


def test_a_ring_of_components_ends(tmp_path: Path) -> None:
    hal = "net a pid.x.output sum2.0.in0\nnet b sum2.0.out limit1.0.in\nnet c limit1.0.out sum2.0.in1\n"
    hal += "net x-fb encoder.0.position pid.x.feedback\n"
    assert loop_of(setup_of(tmp_path, hal)) == UNKNOWN


@pytest.mark.parametrize(
    ("names", "files"),
    [
        ("HALFILE = m.hal\nHALFILE = io.hal", {"io_hal": OWN}),
        ("TWOPASS = on\nHALFILE = io.hal\nHALFILE = m.hal", {"io_hal": OWN}),
        ("HALFILE = m.hal\nPOSTGUI_HALFILE = io.hal", {"io_hal": OWN}),
        ("HALFILE = m.hal\nHALFILE = more.hal", {"more_hal": "source io.hal\n", "io_hal": OWN}),
        ("HALFILE = m.hal\n" + "\n".join(f"HALCMD = {line}" for line in OWN.splitlines()), {}),
        ("HALFILE = m.hal\nHALFILE = io.hal\nHALFILE = empty.hal", {"io_hal": OWN, "empty_hal": ""}),
    ],
)
def test_all_files_count(tmp_path: Path, names: str, files: dict[str, str]) -> None:
    setup = setup_of(tmp_path, "", names=names, **files)
    assert loop_of(setup) == STEPS
    assert "CL866" not in {one.code for one in setup.findings}


@pytest.mark.parametrize("name", ["io.tcl", "io.tcl -option", "absent.hal"])
def test_a_file_that_is_not_read_is_named(tmp_path: Path, name: str) -> None:
    names = f"HALFILE = m.hal\nHALFILE = {name}"
    setup = setup_of(tmp_path, "net o pid.x.output\nnet x-fb pid.x.feedback\n", names=names, io_tcl="# Tcl\n")
    assert loop_of(setup) == UNKNOWN
    line = (tmp_path / "m.ini").read_text().splitlines().index(f"HALFILE = {name}") + 1
    assert [one.place for one in setup.findings if one.code == "CL866"] == [f"m.ini:{line}"]
    assert name in setup.axes[0].loop.why


def test_a_tcl_script_in_place_of_the_hal_file_is_refused(tmp_path: Path) -> None:
    setup_of(tmp_path, OWN, m_tcl="# Tcl\n")
    with pytest.raises(ScenarioError, match="Tcl"):
        read_setup(tmp_path / "m.ini", tmp_path / "m.tcl")


def test_two_passes_count_the_channels_of_all_files(tmp_path: Path) -> None:
    hal = "loadrt pid num_chan=1\n" + (PID + OWN).replace("names=pid.x", "num_chan=1").replace("pid.x", "pid.1")
    (tmp_path / "m.ini").write_text(INI.format(hal="TWOPASS = on\nHALFILE = m.hal"))
    (tmp_path / "m.hal").write_text(hal)
    (axis,) = read_setup(tmp_path / "m.ini", tmp_path / "m.hal").axes
    assert (axis.pid, axis.loop.loop) == ("pid.1", STEPS)


@pytest.mark.parametrize("count", ["0", "-1", "many", "[TRAJ]NOTHING", "\N{SUPERSCRIPT TWO}", "999999999999"])
def test_a_number_of_channels_that_cannot_be_is_refused(tmp_path: Path, count: str) -> None:
    with pytest.raises(ScenarioError, match="num_chan"):
        setup_of(tmp_path, f"loadrt pid num_chan={count}\n")


def test_odd_statements_are_passed_over(tmp_path: Path) -> None:
    odd = "source\nsource [HAL]NOTHING\nnet\nnet a\nlinkps a\nsetp a\naddf\nloadrt\nunlinkp\nunlinkp never.0.linked\nunlinkp\n"
    odd += "net x-fb x.y\nnet x-fb x.y\nunlinkp x.y\nloadrt encoder num_chan=999999999999\n"
    assert loop_of(setup_of(tmp_path, odd + OWN)) == STEPS


def test_a_gain_that_no_file_sets_is_that_of_pid(tmp_path: Path) -> None:
    """A pid starts with Pgain 1 and zeros, as ``halcmd show pin`` says."""
    (tmp_path / "m.ini").write_text(INI.format(hal="HALFILE = m.hal"))
    (tmp_path / "m.hal").write_text((PID + OWN).replace("setp pid.x.Pgain [JOINT_0]P\n", ""))
    (axis,) = read_setup(tmp_path / "m.ini", tmp_path / "m.hal").axes
    assert (axis.gains["Pgain"], axis.gains["FF1"], axis.idle) == (1.0, 0.0, False)


@pytest.mark.parametrize(("p", "ff1", "idle"), [("0", "0", True), ("0", "1", False), ("0.1", "0", False)])
def test_a_pid_without_gains(tmp_path: Path, p: str, ff1: str, idle: bool) -> None:
    hal = f"net o pid.x.output mine.0.in\nnet x-fb mine.0.out pid.x.feedback\nsetp pid.x.Pgain {p}\nsetp pid.x.FF1 {ff1}\n"
    setup = setup_of(tmp_path, hal)
    assert [one.place for one in setup.findings if one.code == "CL865"] == ["axis x"] * idle
    assert setup.axes[0].idle == idle


def test_settings_of_a_step_generator(tmp_path: Path) -> None:
    (values,) = (one.values for one in setup_of(tmp_path, OWN).findings if one.code == "CL864")
    assert (values["p"], values["ff1"], values["most"]) == (50.0, 0.0, pytest.approx(1000.0))
    assert values["age"] == pytest.approx(50e-6)  # a servo period at 50 mm/s
    assert values["maxvel"] > 0.05 and values["maxaccel"] > 0.5


# --- a log decides --------------------------------------------------------------------------------------------------------------------

PERIOD = 1e-3
TIME = PERIOD * np.arange(12_000)
GAINS = {"Pgain": 0.8, "Igain": 0.5, "Dgain": 0.0, "FF1": 0.015, "FF2": 0.0}


def command() -> np.ndarray:
    """Return strokes [m] at several speeds and accelerations, with rests."""
    speed = np.zeros(TIME.size)
    for k, (fastest, change) in enumerate(((0.004, 0.02), (0.05, 0.05), (0.2, 0.2), (0.1, 0.01), (0.2, 0.04), (0.05, 0.02))):
        for way, first in ((1.0, 2.0 * k), (-1.0, 2.0 * k + 0.9)):
            speed += way * fastest * np.clip(np.minimum(TIME - first, first + 0.8 - TIME) / change, 0.0, 1.0)
    return PERIOD * np.cumsum(speed)


def velocity_drive(lag: float, speed: float, count: float, late: int) -> tuple[np.ndarray, np.ndarray]:
    """Return output and position [m] under P and FF1 of a drive whose velocity follows the output: T v' = speed u - v."""
    wanted, out, seen = command(), np.zeros(TIME.size), np.zeros(TIME.size)
    x = v = 0.0
    kept = np.exp(-PERIOD / lag)
    for k in range(TIME.size):
        seen[k] = count * round(x / count)
        before = wanted[max(k - 1, 0)]
        out[k] = (0.2 / (lag + 0.005) * (before - seen[k]) + (wanted[k] - before) / PERIOD) / speed
        end = speed * out[max(k - late, 0)]
        x += end * PERIOD + (v - end) * lag * (1.0 - kept)
        v = end + (v - end) * kept
    return out, seen


@pytest.mark.parametrize("lag", [1e-4, 1e-3, 4e-3, 9e-3])
@pytest.mark.parametrize(("speed", "count", "late"), [(1e-3, 1e-7, 0), (1e-3, 5e-6, 2), (0.05, 1e-6, 0)])
def test_a_velocity_drive_is_seen_in_a_log(lag: float, speed: float, count: float, late: int) -> None:
    result = decided([velocity_drive(lag, speed, count, late)], PERIOD, 1e-3)
    assert result is not None and result.loop == VELOCITY


@pytest.mark.parametrize("unit", [1e-3, 0.0254])
def test_a_slow_velocity_drive_is_seen_where_the_output_is_its_speed(unit: float) -> None:
    result = decided([velocity_drive(0.03, unit, 1e-6, 0)], PERIOD, unit)
    assert result is not None and result.loop == VELOCITY


@each("seed", range(12))
def test_a_torque_servo_is_seen_in_a_log(seed: int) -> None:
    """Two masses with friction at both, a shaft, play and a quantised encoder, drawn at random; damping up to 80 1/s."""
    plant, noise = drawn(seed)
    measured, output = plant.measured(command(), GAINS, PERIOD, np.random.default_rng(seed).uniform(-noise, noise, TIME.size))
    result = decided([(output, measured)], PERIOD, 1e-3)
    assert result is not None and result.loop == SERVO


def test_logs_that_show_nothing_decide_nothing() -> None:
    measured, output = TwoMasses().measured(command(), GAINS, PERIOD, np.zeros(TIME.size))
    noise = np.random.default_rng(1).standard_normal(TIME.size)
    assert decided([], PERIOD, 1e-3) is None
    assert decided([(output[:30], measured[:30])], PERIOD, 1e-3) is None
    assert decided([(noise, measured)], PERIOD, 1e-3) is None
    assert decided([(-output, measured)], PERIOD, 1e-3) is None  # the output counts the other way
    assert decided([(0.0 * output, 0.0 * measured)], PERIOD, 1e-3) is None
