"""``contourlab precompensate`` as typed."""

import itertools
import json
import re
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import contourlab as cl
from contourlab.cli.main import main
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
    assert "CL905" in [one["code"] for one in result["findings"]]
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
        ["--log", "run.csv", "--cap", "3"], ["--log", "run.csv", "--out", "part.ngc"],
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
