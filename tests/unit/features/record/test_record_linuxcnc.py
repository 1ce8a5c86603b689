"""The HAL file and the script of `record`: what they sample of each kind of wiring, and that `measure` reads what the script writes."""

from __future__ import annotations

import json
import os
import shutil
import stat
import subprocess
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from made_controls import made_control
from reference_data import reference_file

import contourlab as cl
from contourlab.controls.linuxcnc.files import read_graph, read_ini
from contourlab.errors import ContourlabError, ScenarioError
from contourlab.logs import load_log

SERVO = """loadrt pid names=pid.x,pid.y
net x-cmd joint.0.motor-pos-cmd => pid.x.command
net x-out pid.x.output => hm2_7i77.0.analogout0
net x-fb hm2_7i77.0.encoder.00.position => pid.x.feedback joint.0.motor-pos-fb
net y-cmd joint.1.motor-pos-cmd => pid.y.command
net y-out pid.y.output => hm2_7i76e.0.stepgen.01.velocity-cmd
net y-scale hm2_7i76e.0.encoder.01.position => pid.y.feedback
net y-fb hm2_7i76e.0.stepgen.01.position-fb => joint.1.motor-pos-fb
net x-here joint.0.pos-fb => pyvcp.x
"""


def machine(folder: Path, hal: str = SERVO, *more: str) -> Path:
    ini = folder / "m.ini"
    own = [
        "[EMCMOT]",
        "SERVO_PERIOD = 500000",
        "[TRAJ]",
        "LINEAR_UNITS = mm",
        "COORDINATES = X Y",
        *(f"[JOINT_{n}]\nTYPE = LINEAR" for n in (0, 1)),
    ]
    ini.write_text("\n".join([*own, *more, "[HAL]", "HALFILE = m.hal"]))
    (folder / "m.hal").write_text(hal)
    return ini


def nets(text: str) -> dict[str, list[str]]:
    """Return the words of the signal of each pin of the sampler."""
    lines = [line.split() for line in text.splitlines() if line.startswith("net ")]
    return {words[-1]: words[1:-2] for words in lines}


def test_the_newcomers_router(tmp_path: Path) -> None:
    """Where step generators count their own steps, a finding warns. The HAL file names pins that nothing else nets."""
    answer = cl.record(reference_file("repro/trial3/router.ini")).save(tmp_path / "out")
    assert [(axis.axis, axis.command, axis.position, axis.source) for axis in answer.axes] == [
        (letter, f"joint.{n}.pos-cmd", f"joint.{n}.pos-fb", "steps") for n, letter in enumerate("xyz")
    ]
    (count,) = [one for one in answer.findings if one.code == "CL415"]
    assert list(count.values["axes"]) == ["x", "y", "z"]
    assert "CL993" not in {one.code for one in answer.findings} and "CL866" in {one.code for one in answer.findings}
    hal, script = (file.read_text() for file in answer.files)
    assert nets(hal)["sampler.0.pin.3"][-1] == "joint.1.pos-fb" and nets(hal)["sampler.0.pin.6"][-1] == "motion.program-line"
    assert "cfg=ffffffsbb" in hal and "position.z [mm],line" in script and "-v period=0.001 " in script
    # The file is one that halcmd reads: each pin once.
    ini = read_ini(reference_file("repro/trial3/router.ini"))
    graph = read_graph(ini, [answer.files[0]])
    assert len(graph.signal_of) == 18 and all(len(pins) == 2 for pins in graph.pins.values())


def test_encoders_and_scales(tmp_path: Path) -> None:
    """An encoder in the loop, and a scale that only the pid of a step generator reads; a pin that has a signal keeps it."""
    answer = cl.record(machine(tmp_path))
    assert [(axis.command, axis.position, axis.source) for axis in answer.axes] == [
        ("joint.0.pos-cmd", "joint.0.pos-fb", "encoder"),
        ("pid.y.command", "pid.y.feedback", "encoder"),
    ]
    written = {Path(file).name: text for file, text in answer.contents.items()}
    pins = nets(written["contourlab-record.hal"])
    assert [pins[f"sampler.0.pin.{k}"] for k in (1, 2, 3)] == [["x-here"], ["y-cmd"], ["y-scale"]]
    assert "axis_position.y [mm]" in written["contourlab-record.sh"] and "-v period=0.0005 " in written["contourlab-record.sh"]
    assert {one.code for one in answer.findings} == {"CL993"}


def test_both_motors_of_a_gantry(tmp_path: Path) -> None:
    """The first is the axis; the other is a column that counts where it is named."""
    ini = machine(tmp_path, SERVO.replace("x-here", "y-here").replace("joint.0.pos-fb", "joint.1.pos-fb"))
    ini.write_text(ini.read_text().replace("COORDINATES = X Y", "COORDINATES = X X"))
    answer = cl.record(ini)
    assert [(axis.axis, axis.position, dict(axis.others)) for axis in answer.axes] == [
        ("x", "joint.0.pos-fb", {"gantry_x_1": "pid.y.feedback"})
    ]
    (found,) = [one for one in answer.findings if one.code == "CL994"]
    assert found.values["pin"] == "joint.0.pos-fb"
    assert "cfg=fffsbb" in answer.contents["contourlab-record.hal"]
    (tmp_path / "log.csv").write_text("time [s],reference.x [mm],axis_position.x [mm],gantry_x_1 [mm]\n0,0,0,1\n1,1,1,2\n2,2,2,3\n")
    assert load_log(tmp_path / "log.csv").result.signals["axis_position"].data[0] == 0.0
    assert load_log(tmp_path / "log.csv", columns=["axis_position.x=gantry_x_1"]).result.signals["axis_position"].data[0] == 1e-3


def test_a_sampler_that_is_there_and_axes_that_are_not(tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match=r"m\.hal:1"):
        cl.record(machine(tmp_path, "loadrt sampler depth=1000 cfg=f\n"))
    ini = machine(tmp_path)
    ini.write_text(ini.read_text().replace("COORDINATES = X Y", "COORDINATES = A C"))
    with pytest.raises(ScenarioError):
        cl.record(ini)
    with pytest.raises(ScenarioError, match=r"m\.ini:\d+: kinematics 5axiskins"):
        cl.record(machine(tmp_path, SERVO, "[KINS]", "KINEMATICS = 5axiskins coordinates=XYZBC"))
    with pytest.raises(ContourlabError):
        cl.record(made_control(tmp_path, "grbl"))


@pytest.mark.parametrize("name", ["x-cmd;reboot", "`id`", "$(id)", "x\u00ff", "[JOINT_0]NAME", "\\"])
def test_no_name_of_a_stranger_is_written(tmp_path: Path, name: str) -> None:
    """Names of signals stand in the HAL file, and nothing of the files in the script."""
    ini = machine(tmp_path, SERVO.replace("x-here", name), "NAME = $(touch here); '\n")
    with pytest.raises(ScenarioError):
        cl.record(ini)


def test_the_script_has_nothing_of_the_files(tmp_path: Path) -> None:
    folder = tmp_path / "a'b\n$(touch here)"
    folder.mkdir()
    scripts = [cl.record(file).contents["contourlab-record.sh"] for file in (machine(folder), machine(tmp_path))]
    assert scripts[0] == scripts[1]


# --- the script, with a sampler that writes what halsampler -t does -----------------------------------------------------------------


def sampled(rows: np.ndarray, *, lost: int = 0) -> Iterator[str]:
    """Yield the lines of ``halsampler -t``: numbers of six decimals, whole ones for s and b, a blank after each; overruns.

    The first lines are of an earlier run, which the sampler kept: its numbers are below 70000.
    """
    yield "overrun\n"
    yield from (f"{k} {'1.000000 ' * 4}7 1 {int(k > 69900)} \n" for k in range(69000, 70000))
    for k, row in enumerate(rows.tolist()):
        if lost and k == 1000:
            yield "overrun\n"
        if not (lost and 1000 <= k < 1000 + lost):
            yield f"{k + 70000} " + "".join(f"{value:.6f} " for value in row[:-3]) + "".join(f"{int(value)} " for value in row[-3:]) + "\n"


def program_run() -> np.ndarray:
    """Return rows at 2 kHz: 1 s at rest, 2 s of a program of two lines with a lag of 10 um in x and 3 um in y, 2 s at rest, a jog."""
    n = np.arange(12000)
    x, y = 0.01 * (np.clip(n - 2000, 0, 2000) + np.clip(n - 10000, 0, 2000)), 0.01 * np.clip(n - 4000, 0, 2000)
    runs = (n >= 2000) & (n < 6000)
    late = [np.where(runs, np.maximum(way - lag, 0.0), way) for way, lag in ((x, 0.010), (y, 0.003))]
    return np.column_stack([x, late[0], y, late[1], np.where(runs, 2 + (n >= 4000), 0), runs, ~runs])


def recorded(folder: Path, lines: Iterator[str], *words: str) -> subprocess.CompletedProcess[str]:
    """Run the script where halsampler prints some lines."""
    if shutil.which("awk") is None or os.name != "posix":
        pytest.skip("the script needs sh and awk")
    answer = cl.record(machine(folder)).save(folder / "recording")
    (folder / "samples").write_text("".join(lines))
    (folder / "bin").mkdir()
    for name, typed, command in (("halsampler", "-t", f"cat '{folder}/samples'"), ("halcmd", "getp sampler.0.sample-num", "echo 70000")):
        tool = folder / "bin" / name
        tool.write_text(f'#!/bin/sh\n[ "$*" = "{typed}" ] && {command}\n')
        tool.chmod(tool.stat().st_mode | stat.S_IXUSR)
    environment = {**os.environ, "PATH": f"{folder / 'bin'}{os.pathsep}{os.environ['PATH']}"}
    call = ["sh", str(answer.files[1]), *words]
    return subprocess.run(call, cwd=folder, env=environment, capture_output=True, text=True, timeout=60, check=False)


def test_the_script_records_the_program_alone(tmp_path: Path) -> None:
    ran = recorded(tmp_path, sampled(program_run()), "run.csv")
    assert ran.returncode == 0, ran.stderr
    log = load_log(tmp_path / "run.csv")
    assert log.result.servo_period == pytest.approx(0.5e-3)
    assert log.result.n_sample == 999 + 4000 + 1000  # half a second is 1000 samples
    assert {finding.code for finding in log.findings} == set()
    reference, position = log.result["reference"], log.result["axis_position"]
    assert reference.max(axis=0) == pytest.approx([0.02, 0.02]) and (reference - position)[3500].tolist() == pytest.approx([1e-5, 3e-6])
    assert log.lines is not None and log.lines.tolist() == [0] * 999 + [2] * 2000 + [3] * 2000 + [0] * 1000


def test_lost_samples_are_a_gap(tmp_path: Path) -> None:
    rows = np.roll(program_run(), -1000, axis=0)
    assert recorded(tmp_path, sampled(rows, lost=30), "run.csv").returncode == 0
    log = load_log(tmp_path / "run.csv")
    assert [gap.missing for gap in next(iter(log.clocks.values())).gaps] == [30]


@pytest.mark.parametrize("share", [0.0, 0.5, 0.7])
def test_samples_that_end_before_the_program_are_no_success(tmp_path: Path, share: float) -> None:
    lines = list(sampled(program_run()[:6500]))
    ran = recorded(tmp_path, iter(lines[: round(share * len(lines))]), "run.csv")
    assert ran.returncode == 1 and "run.csv" not in ran.stdout


def test_a_log_that_is_there_is_kept(tmp_path: Path) -> None:
    (tmp_path / "run.csv").write_text("mine")
    assert recorded(tmp_path, sampled(program_run()), "run.csv").returncode == 2
    assert (tmp_path / "run.csv").read_text() == "mine"


def test_measure_reads_the_log_with_no_option(tmp_path: Path) -> None:
    """The lag of x moves the tool off the second line; the zero of the part is found from the commands."""
    recorded(tmp_path, sampled(program_run()), "run.csv")
    (run,) = cl.measure(tmp_path / "run.csv").runs
    assert run.metrics.contour_error.max == pytest.approx(10e-6, rel=1e-4)
    (tmp_path / "part.ngc").write_text("G21 G90 F1200\nG1 X20\nY20\nM2\n")
    answer = cl.measure(tmp_path / "run.csv", machine=tmp_path / "m.ini", program=tmp_path / "part.ngc", tolerance="12 um")
    (run,) = answer.runs
    assert answer.passed and run.verdict is not None and run.verdict.worst.line == 3
    assert run.metrics.part_error.max == pytest.approx(10e-6, rel=1e-4) and run.metrics.planning_deviation.max < 1e-9
    assert "CL415" not in {one.code for one in run.findings}  # a scale is no count
    assert json.loads(json.dumps(answer.json))["machine"]["source"] == "LinuxCNC"
