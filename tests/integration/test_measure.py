"""``contourlab measure`` as typed, on the measured runs of a two-axis table and on faulty logs."""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Callable
from datetime import datetime, timedelta
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from made_controls import made_control
from reference_data import reference_file
from typed_commands import AsJson, Refused

from contourlab.cli.main import main
from contourlab.errors import ResultError
from contourlab.features.measure.measured_path import fitted_shift, path_of_samples
from contourlab.features.measure.study import measure
from contourlab.geometry import Line
from contourlab.geometry import Path as Path_
from contourlab.logs import load_log, read_record
from contourlab.result import Result, Signal


def circle(n: int = 2000, radius: float = 0.02) -> np.ndarray:
    angle = np.linspace(0.0, 2.0 * np.pi, n)
    return radius * np.column_stack([np.cos(angle), np.sin(angle)])


def run_of(position: np.ndarray, reference: np.ndarray | None) -> Result:
    signals = {"position": Signal(position, ("sample", "axis"), "m")}
    if reference is not None:
        signals["reference"] = Signal(reference, ("sample", "axis"), "m")
    return Result("bench", ("x", "y"), 1e-3, signals)


@pytest.mark.parametrize(
    ("file", "rms", "largest", "tracking"), [("lli", 84.76, 262.4, (76.4, 77.7)), ("pp", 48.3, 95.4, (1277.4, 1082.7))]
)
@pytest.mark.slow
def test_the_measured_runs_of_the_table(
    tmp_path: Path, as_json: AsJson, file: str, rms: float, largest: float, tracking: tuple[float, float]
) -> None:
    log = reference_file(f"data/ubc-xy-table/line_circle_{file}.mat")
    found = as_json("measure", log, "--out", tmp_path / "out")
    metrics = found["schemes"][f"line_circle_{file}"]["metrics"]
    assert metrics["contour_error"]["rms"] * 1e6 == pytest.approx(rms, rel=0.01)
    assert metrics["contour_error"]["max"] * 1e6 == pytest.approx(largest, rel=0.01)
    assert [axis["rms"] * 1e6 for axis in metrics["tracking_error"]] == pytest.approx(tracking, rel=0.01)
    scheme = found["schemes"][f"line_circle_{file}"]
    assert scheme["servo_period"] == 1e-4
    own = {"file", "format", "columns", "clock", "notes", "findings", "shift", "verdict"}
    assert set(scheme) == {"axes", "servo_period", "n_sample", "metrics", "circles", "reversals", "reversal_figures"} | own
    assert (tmp_path / "out" / "report.html").stat().st_size > 10_000
    written = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert written.pop("made_by") and written == found


def as_table(run: np.ndarray, stamp: str, heads: str) -> str:
    """Write the run at 1 kHz; `stamp` formats its time, which starts two seconds before midnight."""
    start = datetime(2024, 5, 31, 23, 59, 58)
    stamps = [(start + timedelta(milliseconds=k)).strftime(stamp.replace("%f", f"{k % 1000:03d}")) for k in range(len(run))]
    rows = [";".join([stamp, *(f"{value:.9f}" for value in row)]) for stamp, row in zip(stamps, run.tolist(), strict=True)]
    return "\n".join([f"{heads};x pos [mm];y pos [mm];x ref [mm];y ref [mm]", *rows, ""])


def as_scope(run: np.ndarray) -> str:
    pins = "joint.0.motor-pos-fb;joint.1.motor-pos-fb;joint.0.motor-pos-cmd;joint.1.motor-pos-cmd;machine-is-on"
    rows = [";".join(f"{value:+.14f}" for value in row).replace(".", ",") + ";TRUE" for row in run.tolist()]
    return "\n".join(["# Sampling period is 1000000 ns", pins, "# Position: 0;0;0;0;0", *rows, ""])


def as_trace(run: np.ndarray) -> str:
    """Write only changed values in each sample, as the control does."""
    ids = ("f1", "f2", "f3", "f4")
    shown = "".join(
        f'<signal key="s{k}" name="/Nck/!SD/{name} [u1, {axis}]" description="{name} (64 bit)" unitsType="mm"/>'
        for k, (name, axis) in enumerate([("actual", 1), ("actual", 2), ("setpoint", 1), ("setpoint", 2)], 1)
    )
    data = "".join(f'<dataSignal key="s{k}" id="f{k}" interval="0.001000" datapointCount="{len(run)}"/>' for k in range(1, 5))
    rows, before = [], [np.nan] * 4
    for k, row in enumerate(run.tolist()):
        new = "".join(f' {name}="{value:.9f}"' for name, value, last in zip(ids, row, before, strict=True) if value != last)
        rows, before = [*rows, f'<rec time="{k * 1e-3:.6f}"{new}/>'] if new else rows, row
    displayed = f"<traceDisplaySetup><signals>{shown}</signals></traceDisplaySetup>"
    return f"<traceSession>{displayed}<traceData><dataFrame>{data}{''.join(rows)}</dataFrame></traceData></traceSession>"


BY_PIN = ["--column", "position.x=joint.0.motor-pos-fb [mm]", "--column", "position.y=joint.1.motor-pos-fb [mm]"]
BY_AXIS = [
    word
    for signal, name in (("position", "actual"), ("reference", "setpoint"))
    for k, axis in enumerate("xy", 1)
    for word in ("--column", f"{signal}.{axis}={name} (64 bit) AX{k}")
]


@pytest.mark.parametrize(
    ("name", "written", "words"),
    [
        ("stamped.csv", lambda run: as_table(run, "%Y%m%dT%H%M%S.%f", "stamp"), []),
        ("two.csv", lambda run: as_table(run, "%d.%m.%Y;%H:%M:%S,%f", "Datum;Uhrzeit"), []),
        ("clock.csv", lambda run: as_table(run, "%H:%M:%S.%f", "at"), []),
        ("coarse.csv", lambda run: as_table(run, "%d/%m/%y;%H:%M:%S", "Date;Time"), ["--period", "1ms"]),
        ("scope.csv", as_scope, BY_PIN),
        ("trace.xml", as_trace, BY_AXIS),
    ],
)
@pytest.mark.slow
def test_the_same_run_in_other_forms(
    tmp_path: Path,
    as_json: AsJson,
    name: str,
    written: Callable[[np.ndarray], str],
    words: list[str],
) -> None:
    """Every tenth sample of the table's pole-placement run: the contour error does not depend on the log's format."""
    record = read_record(reference_file("data/ubc-xy-table/line_circle_pp.mat"))
    (tmp_path / name).write_text(written(np.column_stack([channel.values[::10] for channel in record.channels])))
    found = as_json("measure", tmp_path / name, *words, "--out", tmp_path / "out")["schemes"][Path(name).stem]
    assert (found["servo_period"], found["n_sample"]) == (1e-3, 3900)
    error = found["metrics"]["contour_error"]
    assert (error["rms"], error["max"]) == pytest.approx((48.2416e-6, 95.3252e-6), rel=1e-5)


def test_a_known_error() -> None:
    """A circle that is 30 um too large and a tenth of a second late: the contour error is 30 um at any lag."""
    wanted = np.vstack([circle(), np.repeat(circle()[-1:], 100, axis=0)])
    late = np.vstack([np.repeat(wanted[:1], 100, axis=0), wanted[:-100]])
    found = measure(run_of(late * (1.0 + 30e-6 / 0.02), wanted))
    assert found.metrics.contour_error.rms == pytest.approx(30e-6, rel=2e-3)
    assert found.metrics.contour_error.max == pytest.approx(30e-6, rel=1e-2)
    assert found.metrics.tracking_error[0].rms > 1e-3


def test_a_largest_error_of_one_sample_is_questioned() -> None:
    wanted = circle()
    wavy = wanted * (1.0 + 1e-3 * np.sin(np.arange(len(wanted)) / 40.0)[:, None])
    assert "CL410" not in {one.code for one in measure(run_of(wavy, wanted)).findings}
    wavy[700] *= 1.045
    found = measure(run_of(wavy, wanted))
    assert found.metrics.contour_error.max > 0.8e-3
    assert found.findings[-1].code == "CL410" and found.findings[-1].values["others"] == pytest.approx(20e-6, rel=0.02)


def test_the_path_of_samples_leaves_out_what_lies_on_a_line() -> None:
    line = np.column_stack([np.linspace(0.0, 0.1, 5000), np.zeros(5000)])
    path, along = path_of_samples(np.vstack([line[:1]] * 300 + [line, [[0.1, 0.02]]]))
    assert len(path.curves) == 2
    assert along[299] == 0.0 and along[300 + 2500] == pytest.approx(line[2500, 0]) and along[-1] == pytest.approx(0.12)


def test_a_slow_arc_is_no_chord() -> None:
    """Each of many close samples on an arc is collinear with its neighbours; together they are not."""
    angle = np.linspace(0.0, np.pi, 200_001)
    path, along = path_of_samples(0.02 * np.column_stack([np.cos(angle), np.sin(angle)]))
    assert path.length == pytest.approx(0.02 * np.pi, rel=1e-6)
    assert len(path.curves) < 2500
    assert np.abs(np.linalg.norm(path.position(along), axis=1) - 0.02).max() < 11e-9
    there_and_back = np.concatenate([np.linspace(0.0, 0.01, 1000), np.linspace(0.01, 0.002, 1000)])
    assert path_of_samples(np.column_stack([there_and_back, 0.0 * there_and_back]))[0].length == pytest.approx(0.018)


PART = "G21 G90 G17 G64\nG1 X0 Y0 F1000\nX20\nG3 X20 Y20 I0 J10\nG1 X0\nM2\n"


def test_a_part_program_as_the_reference(tmp_path: Path, as_json: AsJson, capsys: pytest.CaptureFixture[str]) -> None:
    """A tool 15 um to the left of the program's path, at its own pace, resting on the way."""
    angle = np.linspace(-np.pi / 2.0, np.pi / 2.0, 900)[1:-1]
    arc = np.column_stack([0.02 + (0.01 - 15e-6) * np.cos(angle), 0.01 + (0.01 - 15e-6) * np.sin(angle)])
    there = np.column_stack([np.linspace(0.0, 0.02, 700), np.full(700, 15e-6)])
    back = np.column_stack([np.linspace(0.02, 0.0, 300), np.full(300, 0.02 - 15e-6)])
    tool = np.vstack([np.repeat(there[:1], 50, axis=0), there, arc, np.repeat(arc[-1:], 80, axis=0), back]) * 1e3
    log = tmp_path / "log.csv"
    log.write_text("x pos [mm];y pos [mm]\n" + "\n".join(f"{x:.9f};{y:.9f}" for x, y in tool))
    (tmp_path / "part.ngc").write_text(PART)
    words = ["measure", str(log), "--period", "1 ms", "--reference", str(tmp_path / "part.ngc"), "--out", str(tmp_path / "out")]
    metrics = as_json(*words)["schemes"]["log"]["metrics"]
    assert metrics["contour_error"]["rms"] == pytest.approx(15e-6, rel=1e-2)
    assert metrics["contour_error"]["max"] == pytest.approx(15e-6, rel=2e-2)
    assert metrics["tracking_error"][0]["rms"] is None
    assert main([*words, "--tolerance", "20 um"]) == 0
    assert re.search(r"PASS\b.* 15", capsys.readouterr().out)
    assert main([*words, "--tolerance", "10 um"]) == 1


@pytest.mark.slow
def test_runs_of_a_part_program_are_compared_from_their_folders(tmp_path: Path, as_json: AsJson) -> None:
    """A run judged against a program has no drive reference, so neither a run nor a comparison has a tracking error."""
    (tmp_path / "part.ngc").write_text("G21 G90 G64\nG1 X0 Y0 F3000\nG1 X40\nG1 Y30\nG1 X0\nG1 Y0\nM2\n")
    from contourlab.features.measure.log_choice import program_of

    path = program_of(tmp_path / "part.ngc", ("x", "y"))[1].path
    along = np.linspace(0.0, path.length, 3000)
    for name, off in (("a", 10e-6), ("b", 15e-6)):
        tool = (path.position(along) + off * path.normal(along)) * 1e3
        lines = [f"{x:.7f},{y:.7f}" for x, y in tool]
        (tmp_path / f"{name}.csv").write_text("x pos [mm],y pos [mm]\n" + "\n".join(lines) + "\n")
        words = ["measure", str(tmp_path / f"{name}.csv"), "--period", "1 ms", "--reference", str(tmp_path / "part.ngc")]
        assert main([*words, "--out", str(tmp_path / name)]) == 0
    metrics = [run["metrics"] for run in as_json("compare", tmp_path / "a", tmp_path / "b", "--out", tmp_path / "both")["schemes"].values()]
    assert [found["contour_error"]["rms"] for found in metrics] == pytest.approx([10e-6, 15e-6], rel=0.01)
    assert all(axis["rms"] is None for found in metrics for axis in found["tracking_error"])


@pytest.mark.slow
def test_finished_runs_are_compared_by_the_figures_of_the_run(tmp_path: Path, as_json: AsJson) -> None:
    """Rapid moves stray farther, but neither the verdict nor a comparison judges them."""
    (tmp_path / "part.ngc").write_text("G21 G90 G61\nG0 X60 Y20\nG1 X40 F1000\nG1 Y30\nG0 X0 Y0\nM2\n")
    words = ["run", str(tmp_path / "part.ngc"), "--machine", "xyz", "--controller", "xyz-controller"]
    errors = []
    for name in ("a", "b"):
        errors.append(as_json(*words, "--out", tmp_path / name)["schemes"]["base"]["metrics"])
    assert errors[0]["others"][0]["max"] > 1.2 * errors[0]["contour_error"]["max"]
    both = as_json("compare", tmp_path / "a", tmp_path / "b", "--out", tmp_path / "both")["schemes"]
    for found, wanted in zip(both.values(), errors, strict=True):
        assert found["metrics"]["judged_time"] == wanted["judged_time"]
        assert found["metrics"]["contour_error"]["max"] == pytest.approx(wanted["contour_error"]["max"], rel=1e-3)
    words = ["--program", tmp_path / "part.ngc", "--tolerance", f"{1.01e6 * errors[0]['contour_error']['max']:.4f} um"]
    again = as_json("compare", tmp_path / "a", tmp_path / "b", *words, "--out", tmp_path / "both")["schemes"]
    assert [found["verdict"]["passed"] for found in again.values()] == [True, True]
    assert {found["verdict"]["worst"]["line"] for found in again.values()} <= {3, 4}


def test_a_part_program_in_other_coordinates(tmp_path: Path, as_json: AsJson, refused: Refused) -> None:
    """The part lies anywhere on the table: with the shift fitted, the error is the same as with the shift given."""
    program = tmp_path / "part.ngc"
    program.write_text("G21 G90 G64 P0.01\nG0 X0 Y0\nG1 X40 F3000\nG3 X40 Y30 J15\nG1 X10\nG1 X0 Y0\nM2\n")
    from contourlab.features.measure.log_choice import program_of

    path = program_of(program, ("x", "y"))[1].path
    along = np.linspace(0.0, path.length, 4000)
    off = path.normal(along) * (8e-6 * np.sin(400.0 * along))[:, None]
    tool = path.position(along) + off + np.array([0.1237, -0.0611])
    lines = ["t [s],x pos [mm],y pos [mm]"]
    lines += [f"{k * 1e-3:.4f},{x * 1e3:.7f},{y * 1e3:.7f}" for k, (x, y) in enumerate(tool)]
    log = tmp_path / "log.csv"
    log.write_text("\n".join(lines) + "\n")
    found = {}
    for shift in ("fit", "123.7 mm, -61.1 mm"):
        scheme = as_json("measure", log, "--reference", program, "--shift", shift, "--out", tmp_path / "o")["schemes"]["log"]
        found[shift] = scheme["metrics"]["contour_error"]["rms"]
        assert scheme["shift"]["x"] == pytest.approx(0.1237, abs=1e-5)
    fitted, given = found.values()
    assert given == pytest.approx(8e-6 / np.sqrt(2.0), rel=0.02)
    assert fitted == pytest.approx(given, rel=0.01)
    assert "log.csv: " in refused("measure", log, "--reference", program, "--out", tmp_path / "o")
    said = refused("measure", log, "--reference", program, "--shift", "3 mm", "--out", tmp_path / "o")
    assert "--shift" in said and "x, y" in said


def test_a_straight_path_does_not_determine_its_shift() -> None:
    along = np.linspace(0.0, 0.1, 500)
    with pytest.raises(ResultError, match="straight"):
        fitted_shift(Path_([Line((0.0, 0.0), (0.1, 0.0))]), np.column_stack([along, np.full(500, 0.01)]))


@pytest.mark.parametrize(
    ("content", "words", "said"),
    [
        ("x pos [mm]\n1\n2\n3\n", ["--period", "1 ms"], "no reference in log.csv"),
        ("x pos [mm],x ref [mm]\n1,1\n2,1\n3,1\n", ["--period", "1 ms"], "log.csv: the reference does not move"),
        ("x pos [mm],x ref [mm]\n1,1\n2,2\n3,3\n", [], "has no sample times"),
        ("x pos [mm],x ref [mm]\n1,1\n2,2\n3,3\n", ["--period", "1"], "--period"),
        ("x pos [mm],x ref [mm]\n1,1\n2,2\n3,3\n", ["--period", "1 ms", "--axes", "q"], "no axis q"),
        ("x pos [mm],x ref [mm]\n1,1\n2,2\n3,3\n", ["--period", "1 ms", "--tolerance", "3 s"], "--tolerance"),
        ("x pos [mm],x ref [mm]\n1,1\n2,2\n3,3\n", ["--period", "1 ms", "--plots", "gif"], "--plots"),
        ("x pos [mm],x ref [mm]\n1,1\n2,2\n3,3\n", ["--period", "1 ms", "--reference", "none.ngc"], "none.ngc"),
        ("t,x pos [mm],x ref [mm]\n0,1,1\n1,2,2\n0.5,3,3\n", [], "time goes back"),
        ("t,x pos [mm],x ref [mm]\n", [], "rows"),
        ("t,x pos [mm],enc x [mm],x ref [mm]\n0,1,1,1\n1,2,2,2\n2,3,3,3\n", [], "position.x may be 'x pos' or 'enc x'"),
        ("t,x pos [mm],x ref [mm]\n0,1,1\n1,2,2\n2,3,3\n", ["--column", "reference.x=x ref", "--reference", "x pos"], "given twice, as"),
    ],
)
def test_faults_are_refused_and_nothing_is_written(tmp_path: Path, refused: Refused, content: str, words: list[str], said: str) -> None:
    log = tmp_path / "log.csv"
    log.write_text(content)
    assert said in refused("measure", log, "--out", tmp_path / "out", *words)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("first", [1, 3])
def test_a_window_is_proposed_if_it_can_be_read(tmp_path: Path, refused: Refused, first: int) -> None:
    times = [*range(10, 10 + first), *range(4)]
    (tmp_path / "log.csv").write_text("t,x pos [mm],x ref [mm]\n" + "".join(f"{t},{t},{t}\n" for t in times))
    assert ("--window" in refused("measure", tmp_path / "log.csv")) == (first > 2)


@pytest.mark.slow
def test_a_simulated_run_can_be_measured(tmp_path: Path, as_json: AsJson) -> None:
    """`measure` finds the contour error that `run` printed in the signals that `run` wrote."""
    kept = ["--signals", "reference", "--signals", "tool_position", "--judge", "all"]
    printed = as_json("run", "builtin:demo-part", "--out", tmp_path / "run", *kept, code=(0, 1))["schemes"]["with disturbance observer"]
    log = load_log(tmp_path / "run" / "signals" / "with-disturbance-observer.nc")
    assert log.result.servo_period == printed["servo_period"]
    found = measure(log.result)
    assert found.metrics.contour_error.max == pytest.approx(printed["metrics"]["contour_error"]["max"], rel=1e-3)
    assert found.metrics.contour_error.rms == pytest.approx(printed["metrics"]["contour_error"]["rms"], rel=1e-2)


@pytest.mark.slow
def test_each_next_command_runs_as_printed(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["compare", "builtin:ghaffari/demo-stage", "--schemes", "position loop", "--out", "run"]) in (0, 1)
    capsys.readouterr()

    def proposed(*words: str) -> list[str]:
        assert main([*words, "--out", "measured"]) in (0, 1)
        lines = [line for line in capsys.readouterr().out.splitlines() if line.startswith("next: ")]
        return shlex.split(lines[-1].removeprefix("next: contourlab ")) if lines else []

    log = "run/signals/position-loop.nc"
    judged = proposed("measure", log)
    assert judged[0] == "measure"
    assert not proposed(*judged)  # it passes
    words = proposed("measure", log, "--tolerance", "1 nm")
    assert words[0] == "identify"
    assert main(words) in (0, 1)  # 1: the model explains too little


@pytest.mark.slow
def test_two_measured_runs_side_by_side(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    logs = [str(reference_file(f"data/ubc-xy-table/line_circle_{name}.mat")) for name in ("lli", "pp")]
    assert main(["compare", *logs, "--out", str(tmp_path / "both")]) == 0
    found = json.loads((tmp_path / "both" / "summary.json").read_text())["schemes"]
    assert [run["metrics"]["contour_error"]["rms"] for run in found.values()] == pytest.approx([84.76e-6, 48.3e-6], rel=0.01)
    said = capsys.readouterr().out
    assert "-43 %" in said and "CL413" not in said
    said = " ".join(said.split())
    assert "0.8614 s to 2.737 s (line_circle_lli)" in said
    assert "0.8198 s to 2.695 s (line_circle_pp)" in said
    assert main(["measure", logs[0], "--out", str(tmp_path / "one")]) == 0
    assert main(["compare", str(tmp_path / "one"), logs[1], "--out", str(tmp_path / "again")]) == 0
    assert "-43 %" in capsys.readouterr().out


def test_runs_that_cannot_be_compared(tmp_path: Path, refused: Refused) -> None:
    first, second = tmp_path / "a.csv", tmp_path / "b.csv"
    first.write_text("time [s],x pos [mm],x ref [mm]\n0,0,0\n1,1,1\n2,2,2\n")
    second.write_text("time [s],y pos [mm],y ref [mm]\n0,0,0\n1,1,1\n2,2,2\n")
    out = ["--out", str(tmp_path / "out")]
    for words, said in (
        ([str(first), str(second)], "has axes y, but a has x"),
        ([str(first), str(first)], "is given twice"),
        ([str(first), str(tmp_path)], "is a folder with 0 runs"),
        ([str(first), str(second), "--trials", "3"], "--trials"),
        (["builtin:demo-part", "--tolerance", "25 um"], "--tolerance"),
    ):
        assert said in refused("compare", *words, *out)
    assert not (tmp_path / "out").exists()


def test_a_log_that_begins_in_motion() -> None:
    """A tool 12 um outside and 30 ms late: its first samples lie 1.9 mm before the start of the recorded path."""
    n, late = 4000, 30
    angle = np.linspace(0.0, 4.0 * np.pi, n + late)
    whole = 0.02 * np.column_stack([np.cos(angle), np.sin(angle)])
    wanted, tool = whole[late:], whole[:-late] * (1.0 + 12e-6 / 0.02)
    found = measure(run_of(tool, wanted))
    assert found.metrics.contour_error.max == pytest.approx(12e-6, abs=0.1e-6)
    assert found.findings[-1].code == "CL408" and found.findings[-1].values["samples"] in (late, late + 1)
    at_rest = measure(run_of(np.vstack([tool[:1]] * 2 + [tool]), np.vstack([wanted[:1]] * 2 + [wanted])))
    assert at_rest.metrics.contour_error.max > 1e-3  # the reference starts from rest, away from the tool
    ended = measure(run_of(whole[late:], whole[:-late]))
    assert ended.metrics.contour_error.max < 0.1e-6 and ended.findings[-1].code == "CL408"


def test_a_largest_error_inside_a_gap_is_reported(tmp_path: Path, as_json: AsJson) -> None:
    """A chord bridges missing samples on a circle; a finding says that its error is not measured."""
    wanted = np.vstack([circle(), np.repeat(circle()[-1:], 20, axis=0)]) * 1e3
    lines = [f"{k * 1e-3:.4f},{x:.6f},{y:.6f},{x:.6f},{y:.6f}" for k, (x, y) in enumerate(wanted)]
    lines[700:760] = [",".join([*line.split(",")[:3], "", "nan"]) for line in lines[700:760]]
    log = tmp_path / "log.csv"
    log.write_text("t [s],x ref [mm],y ref [mm],x pos [mm],y pos [mm]\n" + "\n".join(lines) + "\n")
    scheme = as_json("measure", log, "--out", tmp_path / "out")["schemes"]["log"]
    assert scheme["metrics"]["contour_error"]["max"] > 50e-6
    (inside,) = (one["values"] for one in scheme["findings"] if one["code"] == "CL411")
    assert inside["channels"] == ["x pos", "y pos"]


@pytest.mark.parametrize(("late", "when"), [(-5, 1.5), (25, 1.53)])
def test_a_largest_error_against_the_chord_of_a_gap(tmp_path: Path, as_json: AsJson, late: int, when: float) -> None:
    """Missing rows leave a chord in the reference. A tool that is ahead is on it at the edge of the gap, a late one after the gap."""
    angle = 2.0 * np.pi * (np.arange(2000)[:, None] - [0.0, late]) / 2000.0
    wanted, place = (20.0 * np.column_stack([np.cos(turned), np.sin(turned)]) for turned in angle.T)
    rows = np.column_stack([1e-3 * np.arange(2000), wanted, 1.0001 * place])
    rows = np.delete(rows, slice(1501, 1521), axis=0)
    log = tmp_path / "log.csv"
    heads = "t [s],x ref [mm],y ref [mm],x pos [mm],y pos [mm]"
    np.savetxt(log, rows, delimiter=",", comments="", header=heads)
    findings = as_json("measure", log, "--out", tmp_path / "out")["schemes"]["log"]["findings"]
    (near_gap,) = (one["values"] for one in findings if one["code"] == "CL412")
    windows = ['--window "0..1500"', '--window "1501..1979"']
    assert near_gap == {"time": pytest.approx(when, abs=0.01), "channels": ["x ref", "y ref"], "windows": windows}
    rows[1000:1010, 3] += 0.05  # a larger error elsewhere has nothing to do with the gap
    np.savetxt(log, rows, delimiter=",", comments="", header=heads)
    assert "CL412" not in {one["code"] for one in as_json("measure", log, "--out", tmp_path / "out")["schemes"]["log"]["findings"]}


@pytest.mark.parametrize(
    ("factor", "heads", "code"),
    [
        ([1.0, 100.0, 100.0], "t [s],{} [mm]", "CL403"),
        ([20.0, 1e3, 1e3], "t [s],{} [mm]", "CL403"),
        ([2.0, 1e-3, 1e-3], "t [s],{} [mm]", "CL402"),
        ([1e3, 1.0, 1.0], "t,{} [mm]", "CL401"),
        ([1e3, 1.0, 1.0], "t [ms],{} [mm]", ""),
    ],
)
def test_wrong_units_of_all_columns_are_questioned(tmp_path: Path, as_json: AsJson, factor: list[float], heads: str, code: str) -> None:
    wanted = 1e3 * circle()
    time, way = 1e-3 * factor[0] * np.arange(len(wanted)), factor[1] * wanted
    log = tmp_path / "log.csv"
    names = " [mm],".join(["x ref", "y ref", "x pos", "y pos"])
    np.savetxt(log, np.column_stack([time, way, 1.0001 * way]), delimiter=",", comments="", header=heads.format(names))
    codes = {one["code"] for one in as_json("measure", log, "--out", tmp_path / "out")["schemes"]["log"]["findings"]}
    assert codes & {"CL401", "CL402", "CL403"} == ({code} if code else set())


def test_an_axis_that_is_named_twice() -> None:
    with pytest.raises(ResultError, match="named twice"):
        measure(run_of(circle(), circle()), axes=("x", "x"))


@pytest.mark.parametrize(
    ("spoil", "axes"),
    [
        (lambda place: place, ""),
        (lambda place: 1e-3 * place, "refused"),
        (lambda place: np.add(place, [0.01, 0.0]), "refused"),
        (lambda place: place[:1] + (place - place[:1]) / 25.4, "refused"),
        (lambda place: place[:, ::-1], "x, y"),
        (lambda place: place * [1.0, -1.0], "y"),
    ],
)
def test_a_position_that_does_not_match_its_reference(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], spoil: Callable[[np.ndarray], np.ndarray], axes: str
) -> None:
    wanted = circle(800)
    place = spoil(np.vstack([np.repeat(wanted[:1], 10, axis=0), wanted[:-10]]))
    rows = np.column_stack([1e-3 * np.arange(800), 1e3 * wanted, 1e3 * place])
    log = tmp_path / "log.csv"
    np.savetxt(log, rows, delimiter=",", comments="", header="t [s],x ref [mm],y ref [mm],x pos [mm],y pos [mm]")
    code = main(["measure", str(log), "--out", str(tmp_path / "out")])
    if axes == "refused":
        said = capsys.readouterr().err
        assert code == 2 and "log.csv: " in said and said.count("\n") == 1 and not (tmp_path / "out").exists()
        return
    findings = json.loads((tmp_path / "out" / "summary.json").read_text())["schemes"]["log"]["findings"]
    unlike = [", ".join(one["values"]["axes"]) for one in findings if one["code"] == "CL405"]
    assert code == 0 and "CL430" in {one["code"] for one in findings} and unlike == ([axes] if axes else [])


def named(folder: Path, heads: str, *columns: np.ndarray) -> str:
    """Write a log of millimetres every millisecond."""
    log = folder / "log.csv"
    rows = np.column_stack([1e-3 * np.arange(len(columns[0])), *(1e3 * column for column in columns)])
    np.savetxt(log, rows, delimiter=",", comments="", header=f"t [s],{heads}")
    return str(log)


def test_wrong_columns_are_refused_or_reported(tmp_path: Path, refused: Refused, capsys: pytest.CaptureFixture[str]) -> None:
    """Positions of x and y exchanged on a path longer than it is wide; the reference in place of the position; a reference left out."""
    wanted = circle(800) * [3.0, 1.0]
    place = np.vstack([np.repeat(wanted[:1], 10, axis=0), wanted[:-10]])
    log = named(tmp_path, "a [mm],b [mm],ar [mm],br [mm]", *place.T, *wanted.T)
    out = ["--out", str(tmp_path / "out")]
    columns = {"position.x": "a", "position.y": "b", "reference.x": "ar", "reference.y": "br"}

    def typed(**other: str) -> list[str]:
        said = {**columns, **{name.replace("_", "."): column for name, column in other.items()}}
        return ["measure", log, *(word for name, column in said.items() if column for word in ("--column", f"{name}={column}")), *out]

    said = refused(*typed(position_x="b", position_y="a"))
    assert said.count("120 mm") == 2
    said = refused(*typed(reference_y=""))
    assert re.search(r"reference\b.*\by\b", said)
    assert not (tmp_path / "out").exists()
    assert main(typed()) == 0
    assert "CL404" not in capsys.readouterr().out
    assert main(typed(position_x="ar")) == 0
    assert "CL404 warning" in capsys.readouterr().out


def test_a_program_in_other_units_or_without_its_laps_is_refused(
    tmp_path: Path, refused: Refused, capsys: pytest.CaptureFixture[str]
) -> None:
    side = np.linspace(0.0, 0.04, 500)
    there = np.concatenate([np.column_stack([side, 0.0 * side]), np.column_stack([0.0 * side + 0.04, side])])
    log = named(tmp_path, "x pos [mm],y pos [mm]", *there.T)
    program = "G90 G64\nG1 X0 Y0 F1000\nX40\nY40\nM2\n"
    for units, code in (("G21", 0), ("G20", 2)):
        (tmp_path / "part.ngc").write_text(f"{units} {program}")
        assert main(["measure", log, "--reference", str(tmp_path / "part.ngc"), "--out", str(tmp_path / units)]) == code
    said = capsys.readouterr().err
    assert "40 mm" in said and said.count("\n") == 1
    log = named(tmp_path, "x pos [mm],y pos [mm]", *np.vstack([there, there[::-1], there]).T)
    (tmp_path / "part.ngc").write_text(f"G21 {program}")
    assert " 3 times " in refused("measure", log, "--reference", tmp_path / "part.ngc", "--out", tmp_path / "laps")


@pytest.mark.parametrize(
    ("window", "largest", "rms", "cutting", "rapid"),
    [
        ("0..1493", 6.07, 0.826, (324, 0.824, 3.76, 511), (855, 0.827, 6.07, 453)),
        ("1494..", 1.74, 0.459, (199, 0.639, 1.74, 511), (1463, 0.429, 1.59, 627)),
    ],
)
def test_the_recording_of_a_production_machine(
    tmp_path: Path, as_json: AsJson, window: str, largest: float, rms: float, cutting: tuple[float, ...], rapid: tuple[float, ...]
) -> None:
    """Both figures were found by an independent program; four fifths of the moving samples are rapids."""
    file = reference_file("data/sinumerik/capture-840d.json")
    found = as_json("measure", file, "--axes", "X1,Y1", "--window", window, "--out", tmp_path / "out")["schemes"]["capture-840d"]
    error = found["metrics"]["contour_error"]
    assert (error["max"] * 1e6, error["rms"] * 1e6) == (pytest.approx(largest, abs=0.005), pytest.approx(rms, abs=0.0005))
    apart = {one["place"]: one["values"] for one in found["findings"] if one["code"] == "CL414"}
    for place, (samples, rms_of, largest_of, line) in (("cutting moves", cutting), ("rapid moves", rapid)):
        values = apart[place]
        assert (values["samples"], values["line"]) == (samples, line)
        assert (values["rms"] * 1e6, values["largest"] * 1e6) == (pytest.approx(rms_of, abs=0.0005), pytest.approx(largest_of, abs=0.005))


def test_rapid_moves_alone_get_no_verdict(tmp_path: Path, as_json: AsJson, refused: Refused) -> None:
    """Neither where the log says which moves are rapid, nor where the program does."""
    (tmp_path / "part.ngc").write_text("G21 G90\nG0 X20\nG1 X20 Y20 F1000\nM2\n", encoding="utf-8")
    x = np.minimum(np.arange(1000) * 4e-5, 0.02)
    log = named(tmp_path, "x pos [mm],y pos [mm]", x, 1e-6 * np.sin(1e3 * x))
    for words in (
        ["measure", reference_file("data/sinumerik/capture-840d.json"), "--axes", "X1,Y1", "--window", "700..1000"],
        ["measure", log, "--program", tmp_path / "part.ngc", "--window", "0..400"],
    ):
        found = as_json(*words, "--out", tmp_path / "out")
        (run,) = found["schemes"].values()
        assert (run["verdict"], run["metrics"]["basis"]) == (None, "rapid moves")
        assert "CL418" in [one["code"] for one in run["findings"]]
        refused(*words, "--tolerance", "1 m", "--out", tmp_path / "judged")


def test_a_part_program_and_columns_of_the_reference(tmp_path: Path, as_json: AsJson, refused: Refused) -> None:
    (tmp_path / "part.ngc").write_text("G21 G90\nF1200\nG1 X20\nY20\nM2\n", encoding="utf-8")
    x, y = np.minimum(np.arange(1000) * 0.04, 20.0), np.maximum(np.arange(1000) * 0.04 - 20.0, 0.0)
    log = tmp_path / "log.csv"
    rows = np.column_stack([1e-3 * np.arange(1000), x, y, x + 0.003, y + 0.004])
    np.savetxt(log, rows, delimiter=",", comments="", header="t [s],cx,cy,x pos,y pos")
    words = ("measure", log, "--unit", "mm", "--out", tmp_path / "out")
    figures = [
        as_json(*words, *more)["schemes"]["log"]["metrics"]["contour_error"]["max"]
        for more in (
            ["--program", tmp_path / "part.ngc"],
            ["--reference", tmp_path / "part.ngc"],
            ["--program", tmp_path / "part.ngc", "--reference", "cx,cy"],
        )
    ]
    assert figures == pytest.approx([4e-6, 4e-6, 4e-6], rel=1e-6)  # 4 um beside the first line, 3 um beside the second
    refused(*words, "--program", tmp_path / "part.ngc", "--reference", tmp_path / "part.ngc")


@pytest.mark.slow
def test_a_saved_run_is_measured_as_it_was_judged(tmp_path: Path, as_json: AsJson) -> None:
    """On the machine of a control's own file, with rounded corners and rapids: verdict, figures and lines are those of the run."""
    ini, part = reference_file("repro/trial3/router.ini"), reference_file("repro/trial3/bracket.ngc")
    asked = ("--machine", ini, "--tolerance", "20 um", "--out")
    run = as_json("run", part, "--no-interval", *asked, tmp_path / "run", code=1)
    log = as_json("measure", tmp_path / "run" / "signals" / "base.nc", "--program", part, *asked, tmp_path / "log", code=1)
    assert log["machine"] == run["machine"] and log["passed"] is run["passed"] is False
    wanted, found = run["schemes"]["base"], log["schemes"]["base"]
    for error in ("part_error", "planning_deviation"):
        for figure in ("max", "rms", "mean", "p95", "integral"):
            assert found["metrics"][error][figure] == pytest.approx(wanted["metrics"][error][figure], rel=1e-9, abs=1e-15)
    # The path through the samples cuts off a curve by a dt^2 / 8.
    assert found["metrics"]["contour_error"]["max"] == pytest.approx(wanted["metrics"]["contour_error"]["max"], abs=0.8 * 1e-6 / 8.0)
    for name in ("judged_time", "basis", "cycle_time", "tracking_error"):
        assert found["metrics"][name] == wanted["metrics"][name]
    others = [[(other["moves"], other["time"], other["max"]) for other in each["metrics"]["others"]] for each in (found, wanted)]
    assert others[0] == others[1]
    verdicts = [each["verdict"] for each in (found, wanted)]
    assert len({verdict["worst"]["sample"] for verdict in verdicts}) == 1
    lines = sorted({verdict["worst"]["line"] for verdict in verdicts})
    assert lines[-1] - lines[0] <= 1  # in the corner between them
    planned = [{cause["name"]: cause["contribution"] for cause in verdict["causes"]}["planning"] for verdict in verdicts]
    assert planned[0] == pytest.approx(planned[1], rel=1e-9)
    assert "CL415" not in {one["code"] for one in found["findings"]}  # its positions are those of the axes


def recorded(folder: Path, zero: tuple[float, float], *, commanded: bool, home: tuple[float, float] | None = None, code: str = "") -> Path:
    """Write what a control at 1 kHz records, in machine coordinates: it comes from elsewhere to a zero [mm], then runs a program.

    Before its last cut it may go home, in machine coordinates [mm].
    """
    way_home = "" if home is None else f"{code or f'G53 G0 X{home[0]} Y{home[1]}'}\n"
    (folder / "part.ngc").write_text(f"G21 G90 G64 P0.01\nF1200\nG0 X10 Y0\nG1 X30\nY20\n{way_home}G0 X50 Y20\nG1 Y0\nG0 X0 Y0\nM2\n")
    places = [[-80.0, 35.0], [10.0, 0.0], [30.0, 0.0], [30.0, 20.0], [50.0, 20.0], [50.0, 0.0], [0.0, 0.0]]
    corners = np.array([*places[:4], *([np.subtract(home, zero)] if home else []), *places[4:]])
    lines, rows = range(3, 3 + len(corners) - 1), []
    for line, (start, end) in zip(lines, pairwise(corners), strict=True):
        n = round(np.linalg.norm(end - start) / 0.02)
        rows += [(line, *(start + (end - start) * k / n)) for k in range(n)] + [(line, *end)] * 50
    way = np.array(rows)
    place = way[:, 1:] + zero
    tool = place + [[0.0, 0.004]] * (way[:, :1] == 4) + [[0.0, 0.009]] * (way[:, :1] == 6)
    table = [1e-3 * np.arange(len(way)), *tool.T, *(place.T if commanded else ()), way[:, 0]]
    heads = "time [s],position.x,position.y" + (",reference.x,reference.y" if commanded else "") + ",line"
    np.savetxt(folder / "log.csv", np.column_stack(table), delimiter=",", comments="", header=heads, fmt="%.9f")
    return folder / "log.csv"


@pytest.mark.parametrize("commanded", [True, False])
def test_a_recording_in_machine_coordinates(tmp_path: Path, as_json: AsJson, commanded: bool) -> None:
    """The part lies anywhere, and the approach begins anywhere: neither counts, nor does a rapid between the cuts."""
    ini = made_control(tmp_path, "linuxcnc", ("LINEAR_UNITS = inch", "LINEAR_UNITS = mm"))
    log = recorded(tmp_path, (123.4, -56.7), commanded=commanded)
    asked = ("measure", log, "--program", tmp_path / "part.ngc", "--machine", ini, "--tolerance", "8 um")
    found = as_json(*asked, "--out", tmp_path / "out")
    (run,) = found["schemes"].values()
    # Without commanded positions the fit takes up a part of the offsets of two lines.
    near = 1e-10 if commanded else 9e-6
    assert run["shift"] == {"x": pytest.approx(0.1234, abs=near), "y": pytest.approx(-0.0567, abs=near)}
    given = as_json(*asked, "--shift", "123.4 mm, -56.7 mm", "--out", tmp_path / "out")
    (run,) = given["schemes"].values()
    assert given["passed"] and run["verdict"]["worst"]["line"] == 4
    assert run["verdict"]["worst"]["value"] == pytest.approx(4e-6, rel=1e-6)
    assert {other["moves"]: other["max"] for other in run["metrics"]["others"]}["rapids"] == pytest.approx(9e-6, rel=1e-6)
    codes = {one["code"] for one in run["findings"]}
    assert codes & {"CL407", "CL415"} == ({"CL415"} if commanded else {"CL407", "CL415"})
    causes = {cause["name"]: cause["contribution"] for cause in run["verdict"]["causes"]}
    assert causes == (
        dict.fromkeys(causes, pytest.approx(0.0, abs=1e-8)) | {"breakaway": pytest.approx(4e-6, rel=0.01)} if commanded else {}
    )


@pytest.mark.parametrize("code", ["", pytest.param("G28", marks=pytest.mark.slow)])
@pytest.mark.parametrize("commanded", [True, False])
@pytest.mark.parametrize("shift", ["fit", "123.4 mm, -56.7 mm"])
def test_a_move_in_machine_coordinates_does_not_move_with_the_part(
    tmp_path: Path, as_json: AsJson, shift: str, commanded: bool, code: str
) -> None:
    log = recorded(tmp_path, (123.4, -56.7), commanded=commanded, home=(0.0, 0.0), code=code)
    found = as_json("measure", log, "--program", tmp_path / "part.ngc", "--unit", "mm", "--shift", shift, "--out", tmp_path / "out")
    (run,) = found["schemes"].values()
    near = 1e-10 if commanded or shift != "fit" else 9e-6
    assert run["shift"] == {"x": pytest.approx(0.1234, abs=near), "y": pytest.approx(-0.0567, abs=near)}
    assert run["metrics"]["part_error"]["max"] == pytest.approx(4e-6, abs=1e-10 + near)
    assert ("CL406" in {one["code"] for one in run["findings"]}) == (shift == "fit" and not commanded)


def test_a_measured_run_that_is_saved_is_judged_again_where_it_was(tmp_path: Path, as_json: AsJson) -> None:
    """Its cutting moves count, though no program says again which they are."""
    log = recorded(tmp_path, (0.0, 0.0), commanded=True)
    found = as_json("measure", log, "--program", tmp_path / "part.ngc", "--unit", "mm", "--out", tmp_path / "out")
    again = as_json("measure", tmp_path / "out" / "signals" / "log.nc", "--out", tmp_path / "again")
    (first,), (second,) = (one["schemes"].values() for one in (found, again))
    assert second["metrics"]["contour_error"]["rms"] == pytest.approx(first["metrics"]["contour_error"]["rms"], rel=1e-9)
    assert second["metrics"]["judged_time"] == first["metrics"]["judged_time"]


def test_a_move_in_machine_coordinates_asks_for_the_zero(tmp_path: Path, refused: Refused) -> None:
    """Without the lines of the program, the log does not say up to where it is the part that counts."""
    log = recorded(tmp_path, (123.4, -56.7), commanded=True, home=(0.0, 0.0))
    log.write_text("\n".join(row.rpartition(",")[0] for row in log.read_text().splitlines()))
    asked = ("measure", log, "--program", tmp_path / "part.ngc", "--unit", "mm", "--shift")
    assert "--shift" in refused(*asked, "fit", "--out", tmp_path / "out")
    assert "--shift" not in refused(*asked, "1 mm, 2 mm", "--out", tmp_path / "out")


@pytest.mark.parametrize(("n", "codes"), [(2000, set()), (100, {"CL417"})])
def test_a_log_that_is_too_slow_for_its_contour_error_says_so(n: int, codes: set[str]) -> None:
    """A tool that lags along the circle is on it: an error of 2 R sin^2(pi/(2 n)) is that of the line through the samples."""
    reference = circle(n)
    angle = np.linspace(0.0, 2.0 * np.pi, n) - np.pi / n
    found = measure(run_of(0.02 * np.column_stack([np.cos(angle), np.sin(angle)]) * (1.0 + 2e-6), reference))
    assert {one.code for one in found.findings} & {"CL417"} == codes
    assert (found.metrics.contour_error.max > 1e-6) == bool(codes)
