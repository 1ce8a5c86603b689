"""``contourlab precompensate`` as typed."""

import itertools
import json
import re
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from made_controls import FLUIDNC, GRBL, LINUXCNC

import contourlab as cl
from contourlab.cli.main import main
from contourlab.errors import OutputError
from contourlab.feed import AxisLimits, plan, route_from_program
from contourlab.program import Reading, parse_program

PART = "G21 G90 G64 P0.002\nN10 G1 X10 Y0 F1500 (in)\nN20 G3 X10 Y0 I-10 J0\nN30 G1 X0 Y0\nM2\n"
LIMITS = AxisLimits(np.full(2, 0.2), np.full(2, 1.0))


def log_of(program: str, file: Path, columns: str = "load") -> Path:
    """Write the log of axes that lag by a second-order loop of 8 Hz (p'' = w^2 (c - p) + 1.4 w (c' - p'))."""
    from scipy.signal import lsim

    route = route_from_program(parse_program(program, reading=Reading(require_end=False)), ("x", "y"), default_tolerance=2e-6)
    from contourlab.feed import blended

    reference = plan(blended(route, LIMITS), LIMITS, 1e-3)
    command = reference.block(0, reference.n_sample).position
    command = np.vstack([np.repeat(command[:1], 100, axis=0), command, np.repeat(command[-1:], 400, axis=0)])
    time = 1e-3 * np.arange(len(command))
    w = 2.0 * np.pi * 8.0
    position = np.column_stack([lsim(([1.4 * w, w * w], [1.0, 1.4 * w, w * w]), column, time)[1] for column in command.T])
    head = "time [s],x_cmd [mm],y_cmd [mm],x [mm],y [mm]" + (",x_load [mm],y_load [mm]" if columns == "load" else "")
    rows = np.column_stack([time, 1e3 * command, 1e3 * position, *([1e3 * position] if columns == "load" else [])])
    np.savetxt(file, rows, delimiter=",", header=head, comments="", fmt="%.7f")
    return file


def feeds(text: str) -> set[str]:
    return set(re.findall(r"F[\d.]+", text))


def printed(capsys: pytest.CaptureFixture[str], *words: str) -> dict:
    assert main([*words, "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def test_a_log_without_times_gets_its_period(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.ngc").write_text(PART)
    timed = log_of(PART, Path("timed.csv"))
    bare = [line.split(",", 1)[1] for line in timed.read_text().splitlines()]
    Path("bare.csv").write_text("\n".join(bare))
    words = ("precompensate", "part.ngc", "--out", "corrected.ngc", "--log")
    results = [printed(capsys, *words, "timed.csv"), printed(capsys, *words, "bare.csv", "--period", "1 ms")]
    (first,), (other,) = (result["passes"] for result in results)
    assert other["duration"] == pytest.approx(first["duration"]) and other["rms"] == pytest.approx(first["rms"], rel=1e-6)


@pytest.mark.slow
def test_pass_after_pass_from_logs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.ngc").write_text(PART)
    program = PART
    for k in range(4):
        log = log_of(program, Path(f"run-{k}.csv"))
        words = ("precompensate", "part.ngc", "--log", str(log), "--passes", "passes", "--out", f"part-{k + 1}.ngc")
        result = printed(capsys, *words)
        program = Path(f"part-{k + 1}.ngc").read_text()
    rms = [one["rms"] for one in result["passes"]]
    assert result["position"] == "load"
    assert rms[3] < rms[0] / 5.0, rms
    assert all(later < before for before, later in itertools.pairwise(rms)), rms
    assert all(abs(one["duration"] / result["passes"][0]["duration"] - 1.0) < 0.02 for one in result["passes"])
    assert [line for line in program.splitlines() if line.startswith("N")] == ["N10 F1500 (in)", "N20", "N30"]
    # The same log again, another program in the folder, and a corrected program are refused; nothing is written.
    for words in ("part.ngc --log run-3.csv", "part-1.ngc --log run-1.csv", "part.ngc --log run-2.csv --tolerance 1um"):
        assert main(["precompensate", *words.split(), "--passes", "passes", "--out", "no.ngc"]) == 2
        assert not Path("no.ngc").exists()


def test_a_log_from_arrays_and_one_with_a_period_correct_like_the_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.ngc").write_text(PART)
    names, *rows = log_of(PART, Path("run.csv")).read_text().splitlines()
    columns = dict(zip(names.split(","), np.array([row.split(",") for row in rows], dtype=float).T, strict=True))
    time = columns.pop("time [s]")
    np.savetxt("bare.csv", np.column_stack(list(columns.values())), delimiter=",", header=",".join(columns), comments="", fmt="%.17g")
    answers = [
        cl.precompensate("part.ngc", log="run.csv"),
        cl.precompensate("part.ngc", log=cl.load_log({"time [s]": time} | columns, name="run.csv")),
        cl.precompensate("part.ngc", log="bare.csv", period=f"{time[1] - time[0]} s"),
    ]
    first, *others = (answer.to_pandas() for answer in answers)
    for other in others:
        pd.testing.assert_frame_equal(other, first, rtol=1e-6)


def test_a_log_of_the_program_before_or_of_a_part_of_it_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.ngc").write_text(PART)
    log = log_of(PART, Path("run.csv"))
    lines = log.read_text().splitlines(keepends=True)
    Path("short.csv").write_text("".join(lines[: len(lines) // 2]))
    Path("again.csv").write_text("".join(lines[:-5]))
    words = ["precompensate", "part.ngc", "--passes", "passes", "--log"]
    assert main([*words, "short.csv", "--out", "no.ngc"]) == 2
    assert main([*words, "run.csv", "--out", "part-1.ngc"]) == 0
    assert main([*words, "again.csv", "--out", "no.ngc"]) == 2
    assert not Path("no.ngc").exists()


@pytest.mark.parametrize(("column", "factor"), [(3, -1.0), (4, 25.4), (3, 0.0)])
def test_positions_that_do_not_follow_their_commands_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, column: int, factor: float
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.ngc").write_text(PART)
    log = log_of(PART, Path("run.csv"), "motor")
    rows = np.loadtxt(log, delimiter=",", skiprows=1)
    rows[:, column] *= factor
    np.savetxt(log, rows, delimiter=",", header=log.read_text().splitlines()[0], comments="", fmt="%.7f")
    assert main(["precompensate", "part.ngc", "--log", "run.csv", "--out", "no.ngc"]) == 2
    assert main(["precompensate", "part.ngc", "--log", "run.csv", "--axes", "x", "--out", "no.ngc"]) == 2
    assert not Path("no.ngc").exists()


@pytest.mark.parametrize(("missing", "code"), [(0, ""), (3, "CL427"), (20, "refused")])
def test_missing_samples_are_reported_as_by_measure(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], missing: int, code: str
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.ngc").write_text(PART)
    lines = log_of(PART, Path("run.csv")).read_text().splitlines(keepends=True)
    for k in range(900, 900 + missing):
        lines[k] = lines[k].rsplit(",", 1)[0] + ",nan\n"
    Path("run.csv").write_text("".join(lines))
    words = ("precompensate", "part.ngc", "--log", "run.csv", "--out", "out.ngc")
    if code == "refused":
        assert main([*words]) == 2
    else:
        codes = [one["code"] for one in printed(capsys, *words)["findings"]]
        assert codes.count("CL427") == bool(code), codes


def test_a_slow_pass_names_the_sharpest_corner_without_a_tolerance(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.ngc").write_text("G21 G90 G64\nG1 X5 Y0 F1500\nG1 X10 Y1\nG1 X10 Y6\nM2\n")
    words = ("precompensate", "part.ngc", "--passes", "passes", "--out", "next.ngc", "--log")
    printed(capsys, *words, str(log_of(Path("part.ngc").read_text(), Path("run-0.csv"))))
    text = Path("next.ngc").read_text()
    assert len(feeds(text)) > 5, "ramps keep their feed"
    result = printed(capsys, *words, str(log_of(text.replace("F1500", "F1200"), Path("run-1.csv"))))
    assert feeds(Path("next.ngc").read_text()) == {"F1500"}
    corner = next(one for one in result["findings"] if one["code"] == "CL918")
    assert corner["values"]["line"] == 3
    assert corner["values"]["angle"] == pytest.approx(np.arctan2(5.0, 1.0))


def test_a_program_among_the_passes_stays(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("pass-1.ngc").write_text(PART)
    log_of(PART, Path("run.csv"))
    assert main(["precompensate", "pass-1.ngc", "--log", "run.csv", "--passes", ".", "--out", "out.ngc"]) == 2
    assert Path("pass-1.ngc").read_text() == PART


def test_motor_only_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.ngc").write_text(PART)
    log_of(PART, Path("run.csv"), "motor")
    result = printed(capsys, "precompensate", "part.ngc", "--log", "run.csv", "--log", "run.csv", "--out", "out.ngc")
    assert result["position"] == "motor"
    assert "CL907" in [one["code"] for one in result["findings"]]
    assert result["not_repeating"] == 0.0


@pytest.mark.parametrize(
    "words",
    [
        [], ["--log", "none.csv"], ["--machine", "xyz"], ["--log", "run.csv", "--controller", "c.toml"],
        ["--log", "run.csv", "--cap", "3"], ["--log", "run.csv", "--out", "part.ngc"], ["--log", "run.csv", "--planner", "grbl"],
    ],
)  # fmt: skip
def test_bad_input(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], words: list[str]) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.ngc").write_text(PART)
    log_of(PART, Path("run.csv"))
    assert main(["precompensate", "part.ngc", "--out", "out.ngc", *words]) == 2
    assert not Path("out.ngc").exists()
    assert Path("part.ngc").read_text() == PART


@pytest.mark.slow
def test_from_a_model(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.ngc").write_text("G21 G90 G64 P0.002\nG1 X20 Y0 F1500\nG3 X20 Y0 I-20 J0\nG1 X0 Y0\nM2\n")
    machine = ("--machine", "ubc/table", "--controller", "ubc/lead-lag-controller")
    result = printed(capsys, "precompensate", "part.ngc", *machine, "--out", "out.ngc", "--repeat", "6")
    assert result["gain"] > 5.0
    assert result["passes"][result["best"]]["in_time"]


def test_no_program_is_written_if_no_pass_gains(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.ngc").write_text("G21 G90\nG1 X10 Y0 F600\nG1 X10 Y10\nG1 X0 Y0\nM2\n")  # neither G61 nor G64: the tool may cut corners
    words = "precompensate part.ngc --machine xyz --controller xyz-controller --repeat 1 --out out.ngc --json"
    assert main(words.split()) == 1
    result = json.loads(capsys.readouterr().out)
    assert (result["status"], result["written"], result["out"], result["best"]) == ("no gain", 0, "", 0)
    assert not Path("out.ngc").exists()
    assert {one["line"] for one in result["passes"]} <= {2, 3, 4}


def findings_of(result: dict, code: str) -> list[dict]:
    return [one["values"] for one in result["findings"] if one["code"] == code]


def test_dwells_let_cuts_begin_on_the_path(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """The axes still swing by 12 um when the circle begins."""
    monkeypatch.chdir(tmp_path)
    part = "G21 G90 G64 P0.002\nG0 X10 Y3\nG0 X10 Y0\nG3 X10 Y0 I-10 J0 F1500\nG0 X0 Y0\nM2\n"
    Path("part.ngc").write_text(part)
    largest = {}
    for lead_in in (False, True):
        program = part
        for k in range(3):
            log = log_of(program, Path(f"run-{k}.csv"))
            words = ("precompensate", "part.ngc", "--log", str(log), "--passes", f"passes-{lead_in}", "--out", "out.ngc")
            result = printed(capsys, *words, *["--lead-in"] * lead_in)
            program = Path("out.ngc").read_text()
            longer = findings_of(result, "CL919")
            assert bool(longer) == lead_in
            if lead_in:
                assert longer[0]["after"] == pytest.approx(result["passes"][0]["duration"] + longer[0]["dwell"], rel=0.01)
            if k == 0 and lead_in:
                (values,) = findings_of(result, "CL926")
                assert values["line"] == 4 and values["total"] == pytest.approx(values["dwell"])
                lines = program.splitlines()
                assert lines[lines.index(f"G4 P{values['dwell']:g}") - 1] == "G0 X10 Y0"
        assert [one["line"] for one in result["passes"]] == [4, 4, 4]
        assert bool(findings_of(result, "CL917")) == (not lead_in)
        assert [one["dwell"] for one in result["passes"]] == pytest.approx([0.0, *[values["dwell"]] * 2] if lead_in else [0.0] * 3)
        assert all(one["in_time"] for one in result["passes"])
        path = np.hypot(*result["passes"][2]["place"])
        assert path == pytest.approx(0.01, rel=1e-6)
        position = np.loadtxt(log_of(program, Path("last.csv")), delimiter=",", skiprows=1)[:, 1:5]
        there = int(np.argmin(np.hypot(position[:, 0] - 10.0, position[:, 1])))
        begin = there + int(np.argmax(position[there:, 1] > 0.02))
        largest[lead_in] = np.abs(np.hypot(*position[begin : begin + 30, 2:].T) - 10.0).max()
    assert largest[True] < 0.3 * largest[False]


def test_if_what_was_learned_cannot_be_kept_nothing_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(file: Path, *_: object, **__: object) -> None:
        raise OutputError(f"{file}: cannot be written: No space left on device")

    monkeypatch.chdir(tmp_path)
    Path("part.ngc").write_text(PART)
    log_of(PART, Path("run.csv"))
    monkeypatch.setattr("contourlab.study.checkpoint.write_bytes_atomic", full)
    assert main(["precompensate", "part.ngc", "--log", "run.csv", "--passes", "passes", "--out", "out.ngc"]) == 2
    assert {path.name for path in tmp_path.rglob("*") if path.is_file()} == {"part.ngc", "run.csv"}


def test_a_longer_program_says_what_a_tolerance_would_save(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    corners = "".join(f"G1 X{10.0 * np.cos(a):.3f} Y{10.0 * np.sin(a):.3f} F1500\n" for a in np.linspace(0.0, 2.0 * np.pi, 31)[1:])
    part = f"G21 G90 G61\nG0 X10 Y0\n{corners}M2\n"
    Path("part.ngc").write_text(part)
    log_of(part, Path("run.csv"))
    result = printed(capsys, "precompensate", "part.ngc", "--log", "run.csv", "--lead-in", "--out", "out.ngc")
    ((longer,), (instead,)) = (findings_of(result, code) for code in ("CL919", "CL929"))
    assert longer["after"] > 1.02 * longer["before"] and instead["instead"] < 0.98 * longer["after"]


@pytest.mark.slow
def test_friction_lets_go_during_a_dwell(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.ngc").write_text("G21 G90 G64 P0.005\nG0 X-5 Y0\nG2 X0 Y5 I5 J0 F400\nG2 X5 Y0 I0 J-5\nG0 X0 Y0\nM2\n")
    words = (
        "precompensate",
        "part.ngc",
        "--machine",
        "ubc/table",
        "--controller",
        "ubc/lead-lag-controller",
        "--out",
        "out.ngc",
        "--repeat",
        "3",
    )
    stuck, free = printed(capsys, *words), printed(capsys, *words, "--lead-in")
    first, last = stuck["passes"][0], stuck["passes"][-1]
    assert last["largest"] > 0.99 * first["largest"] and last["line"] == first["line"] == 3
    assert last["share"] > first["share"] + 0.1
    (offer,) = findings_of(stuck, "CL917")
    best = free["passes"][free["best"]]
    assert best["largest"] < 0.5 * first["largest"] and best["rms"] < offer["rms"]
    assert best["largest"] == pytest.approx(offer["largest"], rel=0.5)
    assert best["dwell"] == pytest.approx(offer["total"])


def test_without_path_control_short_lines_take_no_longer(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.ngc").write_text("G21 G90\nG1 X40 Y0 F1200\nG3 X0 Y40 I-40 J0\nG1 X0 Y0\nM2\n")
    words = ("precompensate", "part.ngc", "--machine", "xyz", "--controller", "xyz-controller", "--repeat", "2", "--out", "out.ngc")
    result = printed(capsys, *words)
    best = result["passes"][result["best"]]
    assert best["rms"] < 0.8 * result["passes"][0]["rms"] and best["largest"] < 0.8 * result["passes"][0]["largest"]
    assert findings_of(result, "CL928") == [{"line": 2, "tolerance": pytest.approx(1e-6)}]
    assert Path("out.ngc").read_text().count("G64 P0.001") == 1


def test_short_lines_are_not_smoothed_within_the_tolerance_of_corners(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A stepper machine from its own file, which sets G64 P0.001 inch: without a Q the rms was larger after each pass."""
    monkeypatch.chdir(tmp_path)
    Path("m.ini").write_text(LINUXCNC.replace("STEP_SCALE = 4000", "STEP_SCALE = 40000"))
    Path("part.ngc").write_text("G21 G90\nG0 X5 Y0\nG3 X-5 Y0 I-5 J0 F900\nG3 X5 Y0 I5 J0\nG1 X15 Y0\nG1 Y10\nG1 X5\nM2\n")
    result = printed(capsys, "precompensate", "part.ngc", "--machine", "m.ini", "--repeat", "2", "--out", "out.ngc")
    first, best = result["passes"][0], result["passes"][result["best"]]
    assert best["rms"] < first["rms"] and best["largest"] < 0.5 * first["largest"]
    assert result["passes"][1]["rms"] < first["rms"] and result["passes"][1]["largest"] < 0.6 * first["largest"]
    assert "G64 P0.0254 Q0.001" in Path("out.ngc").read_text()
    assert main(["check", "out.ngc", "--machine", "m.ini"]) == 0


def test_the_next_line_can_be_typed_in_any_dialect(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    Path("part.nc").write_text("%\nO0001\nG21 G90\nG0 G28 Z0.\nG1 X40. Y0. F1200.\nG3 X0. Y40. I-40. J0.\nM30\n%\n")
    words = ("--machine", "xyz", "--controller", "xyz-controller", "--repeat", "2", "--dialect", "fanuc")
    assert main(["precompensate", "part.nc", *words, "--out", "corrected-for-the-control.nc"]) == 0
    *lines, last = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 80
    assert main(["check", "corrected-for-the-control.nc"]) == 2
    assert main(last.removeprefix("next: contourlab ").split()) == 0


def test_on_a_machine_by_its_data_grbl_passes_short_lines(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text("G21 G90\nG1 X40 Y0 F1200\nG3 X0 Y40 I-40 J0\nG1 X0 Y0\nM2\n")
    words = ("part.nc", "--machine", "xyz", "--controller", "xyz-controller", "--dialect", "grbl", "--repeat", "1", "--out", "out.nc")
    result = printed(capsys, "precompensate", *words, "--planner", "grbl")
    first, second = result["passes"]
    assert second["rms"] < 0.8 * first["rms"] and second["duration"] < 1.02 * first["duration"]
    assert main(["precompensate", *words]) == 1


@pytest.mark.parametrize(("control", "machine"), [(GRBL, "m.txt"), (FLUIDNC, "m.yaml")])
def test_a_program_is_read_and_written_as_the_control_of_the_machine_reads_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], control: str, machine: str
) -> None:
    """K beside I and J in an arc of the XY plane: LinuxCNC refuses it."""
    monkeypatch.chdir(tmp_path)
    Path(machine).write_text(control)
    Path("part.nc").write_text("G21 G90\nG0 X10 Y0\nG3 X10 Y0 I-5 J0 K0 F900\nG0 X0 Y0\nM30\n")
    log_of("G21 G90 G64 P0.002\nG0 X10 Y0\nG3 X10 Y0 I-5 J0 F900\nG0 X0 Y0\nM30\n", Path("run.csv"))
    assert main(["check", "part.nc", "--machine", machine]) == 0 != main(["check", "part.nc"])
    capsys.readouterr()
    result = printed(capsys, "precompensate", "part.nc", "--log", "run.csv", "--machine", machine, "--out", "out.nc", "--lead-in")
    # It stops at no short line: the program is longer by its dwells alone, if by any.
    assert all(one["after"] - one["before"] < one["dwell"] + 0.05 * one["before"] for one in findings_of(result, "CL919"))
    assert not findings_of(result, "CL929")
    text = Path("out.nc").read_text()
    assert main(["check", "out.nc", "--machine", machine]) == 0
    assert "G64" not in text and "G4 P0" in text
