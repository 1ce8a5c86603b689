"""LinuxCNC as the machine under test: the real control without hardware, with simulated axes behind its own ``pid``.

Debian's packages linuxcnc-uspace and linuxcnc-uspace-dev run here without display or real-time kernel. Each run has namespaces of its own
(processes, shared memory, network, /tmp): runs do not meet each other, and nothing of a failed run is left. This takes root.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import tempfile
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path

TOOLS = ("linuxcnc", "halcompile", "halsampler", "gcc", "make", "unshare")
PERIOD = 0.001
COLUMNS = ("x_cmd [mm]", "y_cmd [mm]", "x [mm]", "y [mm]", "x_load [mm]", "y_load [mm]", "x_out", "y_out")
PINS = ("{a}-cmd", "{a}-fb", "{a}-load", "{a}-out")

AXIS = """component contourlab_axis "axis with friction, and behind the encoder play and a load, with inertia or without";
pin in float u "acceleration / gain"; pin out float motor; pin out float load;
param rw float gain = 2000; param rw float damping = 30; param rw float friction = 20; param rw float play = 0.02; param rw float noise = 0;
param rw float frequency = 0 "Hz, of load and motor on their shaft; 0: the load has no mass";
param rw float part = 0.5 "of the mass, at the load"; param rw float behind = 0 "friction at the load";
param rw float regulated = 0 "1/s, part of the damping: velocity loop of a drive"; param rw float reset = 0 "1/s, its integral";
param rw u32 substeps = 20 "per period; each is semi-implicit Euler";
variable double v; variable double x; variable double l; variable double w; variable double held; variable unsigned seed;
function _ fp;
license "GPL";
;;
static double rubbed(double speed, double rate, double level, double dt) {
    if (speed == 0) rate = rate > level ? rate - level : rate < -level ? rate + level : 0;
    else rate -= speed > 0 ? level : -level;
    double next = speed + dt*rate;
    return speed*next < 0 ? 0 : next;  /* held where it turns */
}
FUNCTION(_) {
    double h = fperiod / (substeps ? substeps : 1), turn = 6.283185307179586*frequency, k = part*(1 - part)*turn*turn;
    for (unsigned i = 0; i < (substeps ? substeps : 1); i++) {
        held += h*reset*(gain*u - regulated*v);
        if (frequency > 0) {
            double bent = x - l, force = 0;
            if (bent > play/2 || bent < -play/2) force = k*(bent - (bent > 0 ? play/2 : -play/2)) + 0.06*k/turn*(v - w);
            v = rubbed(v, (gain*u + held - damping*v - force)/(1 - part), friction/(1 - part), h);
            w = rubbed(w, force/part, behind/part, h);
            l += h*w;
        } else v = rubbed(v, gain*u + held - damping*v, friction, h);
        x += h*v;
    }
    if (frequency > 0) {} else if (x - l > play/2) l = x - play/2; else if (x - l < -play/2) l = x + play/2;
    seed = seed*1664525u + 1013904223u;
    motor = x + noise*((seed >> 8)/8388608.0 - 1.0); load = l;
}
"""

MODULE = f"contourlab_axis_{hashlib.sha256(AXIS.encode()).hexdigest()[:8]}"

USER = """#!/usr/bin/python3
import linuxcnc, subprocess, sys, time
command, state, errors = linuxcnc.command(), linuxcnc.stat(), linuxcnc.error_channel()
for wanted in (linuxcnc.STATE_ESTOP_RESET, linuxcnc.STATE_ON):
    command.state(wanted); command.wait_complete()
command.mode(linuxcnc.MODE_MANUAL); command.wait_complete()
for joint in range(3):
    command.home(joint)
end = time.time() + 10
while sum(state.homed[:3]) < 3 and time.time() < end:
    time.sleep(0.02); state.poll()
sampler = subprocess.Popen(["halsampler", "-t"], stdout=open("samples.txt", "w"))
command.mode(linuxcnc.MODE_AUTO); command.wait_complete()
command.program_open("/mnt/program.ngc"); command.auto(linuxcnc.AUTO_RUN, 0)
begun, started, done = time.time(), False, False
while time.time() < begun + LIMIT and not done:
    time.sleep(0.05); state.poll()
    idle = state.interp_state == linuxcnc.INTERP_IDLE
    started = started or not idle or time.time() > begun + 3
    done = started and idle and state.inpos and state.exec_state == linuxcnc.EXEC_DONE
error = errors.poll()
time.sleep(0.2)
sampler.terminate()
open("user.txt", "w").write("done" if done and not error else f"failed: {error or 'the program did not end'}")
"""

INI = """[EMC]
VERSION = 1.1
MACHINE = contourlab rig
[DISPLAY]
DISPLAY = ./user.py
[TASK]
TASK = milltask
CYCLE_TIME = 0.001
[RS274NGC]
PARAMETER_FILE = rig.var
[EMCMOT]
EMCMOT = motmod
COMM_TIMEOUT = 4.0
SERVO_PERIOD = 1000000
[EMCIO]
EMCIO = io
CYCLE_TIME = 0.1
TOOL_TABLE = rig.tbl
[HAL]
HALFILE = rig.hal
[KINS]
KINEMATICS = trivkins coordinates=XYZ
JOINTS = 3
[TRAJ]
NO_FORCE_HOMING = 1
COORDINATES = X Y Z
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
MAX_LINEAR_VELOCITY = {velocity:g}
MAX_LINEAR_ACCELERATION = {acceleration:g}
"""
JOINT = """[AXIS_{letter}]
MIN_LIMIT = -200
MAX_LIMIT = 200
MAX_VELOCITY = {velocity:g}
MAX_ACCELERATION = {acceleration:g}
[JOINT_{number}]
TYPE = LINEAR
HOME_SEQUENCE = 0
MIN_LIMIT = -200
MAX_LIMIT = 200
MAX_VELOCITY = {velocity:g}
MAX_ACCELERATION = {acceleration:g}
FERROR = 50
MIN_FERROR = 50
"""
PID = {"P": 0.8, "I": 0.5, "D": 0.0, "FF0": 0.0, "FF1": 0.015, "FF2": 0.0}
PARAMETERS = {"P": "Pgain", "I": "Igain", "D": "Dgain", "FF0": "FF0", "FF1": "FF1", "FF2": "FF2", "FF3": "FF3"}
PARAMETERS |= {"DEADBAND": "deadband", "BIAS": "bias"}
HAL = """# Axes {letters} of the rig.
loadrt [KINS]KINEMATICS
loadrt [EMCMOT]EMCMOT servo_period_nsec=[EMCMOT]SERVO_PERIOD num_joints=[KINS]JOINTS
loadrt pid names=pid.x,pid.y
loadrt contourlab_axis names=axis.x,axis.y
addf axis.x servo-thread
addf axis.y servo-thread
addf motion-command-handler servo-thread
addf motion-controller servo-thread
addf pid.x.do-pid-calcs servo-thread
addf pid.y.do-pid-calcs servo-thread
"""
HAL_AXIS = """
net {a}-enable joint.{n}.amp-enable-out => pid.{a}.enable
net {a}-cmd joint.{n}.motor-pos-cmd => pid.{a}.command
net {a}-fb axis.{a}.motor => pid.{a}.feedback joint.{n}.motor-pos-fb
net {a}-out pid.{a}.output => axis.{a}.u
net {a}-load <= axis.{a}.load
"""
HAL_END = """
net z joint.2.motor-pos-cmd => joint.2.motor-pos-fb
net estop iocontrol.0.user-enable-out => iocontrol.0.emc-enable-in
net tool-prepare iocontrol.0.tool-prepare => iocontrol.0.tool-prepared
net tool-change iocontrol.0.tool-change => iocontrol.0.tool-changed
"""


class RigError(RuntimeError):
    """LinuxCNC did not run the program to its end."""


@dataclass(frozen=True)
class Plant:
    """A simulated axis: x'' = gain u - damping x' - friction sign(x').

    Attributes
    ----------
    gain : float [mm/s^2 per unit of output]
    damping : float [1/s]
    friction : float [mm/s^2]
    play : float [mm]
        Between motor and load, the whole gap.
    noise : float [mm]
        Of the encoder: uniform between plus and minus this.
    frequency : float [Hz]
        Of a load with inertia and the motor on their shaft; 0 for a load without mass.
    part : float
        Of the mass, at the load.
    behind : float [mm/s^2]
        Friction at the load, over the whole mass; `friction` is at the motor.
    regulated, reset : float [1/s]
        Part of the damping that is the velocity loop of a drive, and the integral gain of that loop over its proportional gain.
    substeps : int
        Integration steps per servo period.
    """

    gain: float = 2000.0
    damping: float = 30.0
    friction: float = 20.0
    play: float = 0.02
    noise: float = 0.0
    frequency: float = 0.0
    part: float = 0.5
    behind: float = 0.0
    regulated: float = 0.0
    reset: float = 0.0
    substeps: int = 20


@dataclass(frozen=True)
class Rig:
    """A machine with two axes x and y.

    Attributes
    ----------
    plants : mapping of str to Plant
    pid : mapping of str to mapping of str to float
        Changes of `PID` by axis, under HAL's names such as ``Pgain``.
    velocity, acceleration : float [mm/s, mm/s^2]
        Limits of each axis.
    hal : str, optional
        HAL file to use in place of the rig's own, for another controller; it has the same signals (`PINS`).
    """

    plants: Mapping[str, Plant] = field(default_factory=dict)
    pid: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    velocity: float = 200.0
    acceleration: float = 1000.0
    hal: str | None = None

    def ini_text(self) -> str:
        """Return the INI file as a user has it, with the gains in the sections of the joints."""
        limits = {"velocity": self.velocity, "acceleration": self.acceleration}
        text = INI.format(**limits)
        for number, letter in enumerate("XYZ"):
            text += JOINT.format(letter=letter, number=number, **limits)
            if letter != "Z":
                given = {short: self.pid.get(letter.lower(), {}).get(name, PID.get(short)) for short, name in PARAMETERS.items()}
                text += "".join(f"{short} = {value:.10g}\n" for short, value in given.items() if value is not None)
        return text

    def hal_text(self) -> str:
        """Return the HAL file as a user has it."""
        if self.hal is not None:
            return self.hal
        text = HAL.format(letters="x and y")
        for n, a in enumerate("xy"):
            known = [short for short, name in PARAMETERS.items() if short in PID or name in self.pid.get(a, {})]
            text += HAL_AXIS.format(a=a, n=n) + "".join(f"setp pid.{a}.{PARAMETERS[short]} [JOINT_{n}]{short}\n" for short in known)
        return text + HAL_END

    def write(self, folder: Path) -> tuple[Path, Path]:
        """Write rig.ini and rig.hal; return both."""
        folder.mkdir(parents=True, exist_ok=True)
        ini, hal = folder / "rig.ini", folder / "rig.hal"
        ini.write_text(self.ini_text())
        hal.write_text(self.hal_text())
        return ini, hal

    def _plant_text(self) -> str:
        """Return the HAL lines that no user has: the plants, and the sampler of the test."""
        lines = ["loadrt sampler depth=16000 cfg=ffffffff", "addf sampler.0 servo-thread"]
        for n, a in enumerate("xy"):
            plant = asdict(self.plants.get(a, Plant()))
            lines += [f"setp axis.{a}.{name} {value:.10g}" for name, value in plant.items()]
            lines += [f"net {pin.format(a=a)} sampler.0.pin.{2 * k + n}" for k, pin in enumerate(PINS)]
        return "\n".join(lines) + "\n"

    def run(self, program: str, log: Path, *, limit: float = 300.0) -> Path:
        """Run a program, write the log as CSV and return its path.

        Raises
        ------
        RigError
            If LinuxCNC failed, the program did not end, or samples are missing in three attempts.
        """
        _build()
        problem = ""
        for _ in range(3):
            try:
                rows = self._once(program, limit)
            except RigError as error:
                problem = str(error)
                continue
            numbers = [int(row[0]) for row in rows]
            if not rows or numbers[-1] - numbers[0] != len(rows) - 1:
                problem = "samples are missing"
                continue
            text = ",".join(("time [s]", *COLUMNS)) + "\n"
            text += "".join(",".join((f"{(n - numbers[0]) * PERIOD:.3f}", *row[1:])) + "\n" for n, row in zip(numbers, rows, strict=True))
            log.write_text(text)
            return log
        raise RigError(problem)

    def record(self, program: str, recording: Path, log: Path, *, limit: float = 300.0) -> Path:
        """Run a program as a user who records it with the files of ``contourlab record`` in a folder; return the log that they write.

        Raises
        ------
        RigError
            If LinuxCNC or the script failed, or the program did not end.
        """
        _build()
        return self._once(program, limit, recording, log)  # type: ignore[return-value]

    def _once(self, program: str, limit: float, recording: Path | None = None, log: Path | None = None) -> list[list[str]] | Path:
        with tempfile.TemporaryDirectory(prefix="rig") as name:
            folder = Path(name)
            folder.chmod(0o777)  # rtapi_app gives up its rights
            ini, hal = self.write(folder)
            hal.write_text(hal.read_text().replace("loadrt contourlab_axis ", f"loadrt {MODULE} "))
            ini.write_text(self.ini_text().replace("HALFILE = rig.hal\n", "HALFILE = rig.hal\nHALFILE = plant.hal\n"))
            (folder / "plant.hal").write_text(self._plant_text())
            (folder / "rig.tbl").write_text("T1 P1 D0.1\n")
            (folder / "program.ngc").write_text(program)
            user_text = USER.replace("LIMIT", f"{limit:g}")
            if recording is not None:
                for file in recording.iterdir():
                    shutil.copy(file, folder)
                named = "HALUI = halui\nHALFILE = contourlab-record.hal\n"
                ini.write_text(ini.read_text().replace("HALFILE = plant.hal\n", f"HALFILE = plant.hal\n{named}"))
                plants = [line for line in self._plant_text().splitlines(keepends=True) if "sampler" not in line]
                (folder / "plant.hal").write_text("".join(plants))
                script = """["sh", "contourlab-record.sh", "samples.txt"]"""
                user_text = user_text.replace("""["halsampler", "-t"], stdout=open("samples.txt", "w")""", script)
                user_text = user_text.replace("time.sleep(0.2)\nsampler.terminate()", "code = sampler.wait(10)\nerror = error or code")
                assert "sampler.wait" in user_text and script in user_text
            (folder / "user.py").write_text(user_text)
            (folder / "user.py").chmod(0o755)
            # The folder appears as /mnt behind an empty /tmp. When the first process ends, so do all in its namespace.
            mounts = f"mount --bind {folder} /mnt && mount -t tmpfs none /tmp"
            inside = f"ip link set lo up 2>/dev/null; {mounts} && cd /mnt && linuxcnc -r rig.ini"
            spaces = ("--ipc", "--pid", "--net", "--mount", "--fork", "--mount-proc", "--kill-child")
            # In $HOME LinuxCNC maps its tools into memory: a second one that starts there breaks the first.
            own = {"HOME": "/mnt", "RTAPI_UID": "1000", "RTAPI_FIFO_PATH": "/mnt/fifo", "PATH": "/usr/sbin:/usr/bin:/sbin:/bin"}
            environment = {**os.environ, **own}
            environment.pop("PYTHONPATH", None)
            call = ["unshare", *spaces, "sh", "-c", inside]
            try:
                ran = subprocess.run(call, env=environment, capture_output=True, text=True, timeout=limit + 60.0)
            except subprocess.TimeoutExpired as error:
                raise RigError(f"LinuxCNC did not end within {limit + 60.0:g} s") from error
            user, samples = folder / "user.txt", folder / "samples.txt"
            state = user.read_text() if user.exists() else f"no answer: {(ran.stdout + ran.stderr)[-400:]}"
            if state != "done":
                raise RigError(state)
            if log is not None:
                return Path(shutil.copy(samples, log))
            lines = samples.read_text().splitlines()
        rows = [line.split() for line in lines]
        return [row for row in rows if len(row) == len(COLUMNS) + 1]


def missing() -> str:
    """Return why the rig cannot run here; empty if it can."""
    tools = [tool for tool in TOOLS if not shutil.which(tool)]
    if tools:
        return f"not installed: {', '.join(tools)} (apt-get install linuxcnc-uspace linuxcnc-uspace-dev gcc make)"
    spaces = ["unshare", "--ipc", "--pid", "--mount", "--net", "--fork", "true"]
    if os.geteuid() != 0 or subprocess.run(spaces, capture_output=True).returncode:
        return "the rig needs root and namespaces"
    return ""


def _build() -> None:
    """Compile the axes with halcompile, once for each version of their source: other checkouts have modules of their own."""
    if Path("/usr/lib/linuxcnc/modules", f"{MODULE}.so").exists():
        return
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, f"{MODULE}.comp").write_text(AXIS.replace("contourlab_axis", MODULE, 1))
        ran = subprocess.run(["halcompile", "--install", f"{MODULE}.comp"], cwd=folder, capture_output=True, text=True)
    if ran.returncode:
        raise RigError(f"halcompile: {(ran.stderr or ran.stdout)[-300:]}")
