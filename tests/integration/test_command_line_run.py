"""`contourlab run`: from a scenario or a part program to files whose figures agree with their signals."""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from typed_commands import CIRCLE, ON_XYZ, PART, Finished, Run, contents

import contourlab as package
from contourlab.app.results import LIST, SAFETY
from contourlab.cli.main import main
from contourlab.result import Result

RADIUS = 0.02


def strict(text: str) -> Any:
    """Read JSON strictly: nan and infinities are errors."""

    def refuse(word: str) -> None:
        raise AssertionError(f"{word} is no JSON")

    return json.loads(text, parse_constant=refuse)


def summary(finished: Finished) -> dict[str, Any]:
    found: dict[str, Any] = strict((finished.folder / "summary.json").read_text(encoding="utf-8"))
    return found


def test_json_is_alone_on_standard_output_and_is_the_summary(circle: Finished) -> None:
    assert strict(circle.said.out) == summary(circle)
    assert circle.said.err == ""


def test_a_run_leaves_report_summary_and_the_signals_of_each_scheme(circle: Finished) -> None:
    written = {LIST, "report.html", "summary.json", "signals/position-loop.nc", "signals/all-of-it.nc", "proposed/position-loop.toml"}
    assert set(contents(circle.folder)) == written
    assert f"# {SAFETY}" in (circle.folder / "proposed" / "position-loop.toml").read_text().splitlines()
    page = (circle.folder / "report.html").read_text(encoding="utf-8")
    assert page.lower().startswith("<!doctype html>")
    assert page.rstrip().endswith("</html>")
    assert len(page) < 15e6


def test_the_summary_keeps_its_published_keys(circle: Finished) -> None:
    found = summary(circle)
    assert found["schema"] == "contourlab-summary/1"
    assert found["version"] == package.__version__
    assert list(found["schemes"]) == ["position loop", "all of it"]
    for one in found["schemes"].values():
        assert one["verdict"].keys() == {"passed", "tolerance", "worst", "causes", "left_out", "changes"}


def test_a_failed_tolerance_is_exit_code_1(circle: Finished) -> None:
    found = summary(circle)
    verdicts = {name: scheme["verdict"] for name, scheme in found["schemes"].items()}
    assert (circle.said.code, found["passed"]) == (1, False)
    assert {name: verdict["passed"] for name, verdict in verdicts.items()} == {"position loop": False, "all of it": True}
    for name, verdict in verdicts.items():
        largest = found["schemes"][name]["metrics"]["part_error"]["max"]
        assert verdict["worst"]["value"] == pytest.approx(largest, rel=1e-12)
        assert verdict["passed"] == (largest <= verdict["tolerance"] == pytest.approx(16e-6))


@pytest.mark.parametrize("scheme", ["position loop", "all of it"])
def test_the_figures_follow_from_the_signals(circle: Finished, scheme: str) -> None:
    """The distance to a circle needs no judge: it is the radius less 20 mm, outside is to the right when it is run counterclockwise."""
    result = Result.load(circle.folder / "signals" / f"{scheme.replace(' ', '-')}.nc")
    found = summary(circle)["schemes"][scheme]
    assert (result.n_sample, found["n_sample"], result.servo_period) == (4000, 4000, 1e-3)
    assert (found["metrics"]["basis"], found["metrics"]["judged_time"]) == ("last lap", 2.0)
    start, stop = 2000, 4000  # laps at 0.5 Hz and 1 ms
    error = RADIUS - np.hypot(*result["tool_position"][start:stop].T)
    wanted = {
        "max": np.abs(error).max(),
        "rms": np.sqrt(np.mean(error**2)),
        "mean": np.abs(error).mean(),
        "signed_mean": error.mean(),
        "integral": np.abs(error).sum() * 1e-3,
        "integral_without_mean": np.abs(error - error.mean()).sum() * 1e-3,
    }
    figures = found["metrics"]["part_error"]
    assert {name: figures[name] for name in wanted} == pytest.approx(wanted, rel=1e-9, abs=1e-15)
    assert figures["worst"]["sample"] == start + int(np.argmax(np.abs(error)))
    lag = result["reference"][start:stop] - result["tool_position"][start:stop]
    assert found["axes"] == list(result.axes)
    for column, tracking in enumerate(found["metrics"]["tracking_error"]):
        assert tracking["max"] == pytest.approx(np.abs(lag[:, column]).max(), rel=1e-12)


def test_the_reference_is_the_circle_that_was_asked_for(circle: Finished) -> None:
    result = Result.load(circle.folder / "signals" / "all-of-it.nc")
    angle = np.pi * np.arange(result.n_sample) * 1e-3
    wanted = RADIUS * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    np.testing.assert_allclose(result["reference"], wanted, rtol=0.0, atol=1e-12)


def test_a_part_program_leaves_its_files(part: Finished) -> None:
    assert (part.said.code, part.said.err) == (0, "")
    assert set(contents(part.folder)) == {LIST, "report.html", "summary.json", "signals/base.nc"}
    assert f"report: {Path('results') / 'report.html'}" in part.said.out


BEGINS = {"svg": b"<?xml", "png": b"\x89PNG", "pdf": b"%PDF"}


@pytest.mark.slow
@pytest.mark.parametrize("formats", [["png", "pdf"]])
def test_pictures_are_written_in_the_formats_asked_for(contourlab: Run, tmp_path: Path, formats: list[str]) -> None:
    (tmp_path / "part.ngc").write_text(PART, encoding="utf-8")
    said = contourlab("run", "part.ngc", *ON_XYZ, "--out", "results", *(word for name in formats for word in ("--plots", name)))
    assert (said.code, said.err) == (0, "")
    pictures = [tmp_path / "results" / name for name in contents(tmp_path / "results") if name.startswith("plots/")]
    assert {path.suffix for path in pictures} == {f".{name}" for name in formats}
    for name in formats:
        stems = {path.stem for path in pictures if path.suffix == f".{name}"}
        assert stems >= {"path-0", "error-time", "error-arc", "axis-0", "axis-1", "axis-2", "bode-0", "bode-1", "bode-2"}
    for path in pictures:
        assert path.read_bytes().startswith(BEGINS[path.suffix[1:]])


def test_the_part_error_is_the_distance_to_the_line_and_the_arc(part: Finished) -> None:
    result = Result.load(part.folder / "signals" / "base.nc")
    tool = result["tool_position"]
    on_line = np.clip(tool[:, 0], 0.0, 5e-3)
    line = np.linalg.norm(tool - np.stack([on_line, 0 * on_line, 0 * on_line], axis=1), axis=1)
    flat = tool[:, :2] - [5e-3, 5e-3]
    ends = np.minimum(np.hypot(*(tool[:, :2] - [5e-3, 0.0]).T), np.hypot(*(tool[:, :2] - [5e-3, 10e-3]).T))
    arc = np.hypot(np.where(flat[:, 0] >= 0.0, np.abs(np.hypot(*flat.T) - 5e-3), ends), tool[:, 2])
    # Line and arc meet in a common tangent and leave it on different sides, so the nearer one is the one being cut.
    np.testing.assert_allclose(np.abs(result["part_error"]), np.minimum(line, arc), rtol=0.0, atol=1e-12)
    found = summary(part)
    assert (found["passed"], found["schemes"]["base"]["verdict"]) == (None, None)
    assert found["schemes"]["base"]["metrics"]["part_error"]["max"] == pytest.approx(np.minimum(line, arc).max(), rel=1e-6)


@pytest.mark.slow
def test_a_failed_verdict_names_line_time_and_cause(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "part.ngc").write_text(PART, encoding="utf-8")
    said = contourlab("run", "part.ngc", *ON_XYZ, "--tolerance", "2 um", "--out", "results")
    assert (said.code, said.err) == (1, "")
    found = strict((tmp_path / "results" / "summary.json").read_text(encoding="utf-8"))["schemes"]["base"]
    worst = found["verdict"]["worst"]
    verdict = next(line for line in said.out.splitlines() if "FAIL" in line)
    assert all(part in verdict for part in ("2 um", f"line {worst['line']}", f"{worst['time']:.3f} s"))
    # The largest error of a half circle is where y turns, on the line of the arc.
    assert PART.splitlines()[worst["line"] - 1].startswith("G3")
    assert worst["position"][0] > 9e-3
    assert found["verdict"]["causes"][0]["name"] == "reversal"
    assert ": reversal" in said.out


def test_check_reads_everything_and_writes_nothing(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "circle.toml").write_text(CIRCLE, encoding="utf-8")
    said = contourlab("run", "circle.toml", "--out", "results", "--check").answer
    assert "125.664 mm" in said  # 2 pi 20 mm
    assert "4000 samples" in said
    assert [path.name for path in tmp_path.iterdir()] == ["circle.toml"]


@pytest.mark.slow
def test_plain_python_gives_the_same_figures(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "part.ngc").write_text("G21 G90\nG1 X1 F3000\nG3 X1 Y2 J1\nM2\n", encoding="utf-8")
    for out, jit in (("compiled", "1"), ("plain", "0")):
        assert contourlab("run", "part.ngc", *ON_XYZ, "--out", out, env={"CONTOURLAB_JIT": jit}).code == 0
    compiled, plain = (Result.load(tmp_path / out / "signals" / "base.nc") for out in ("compiled", "plain"))
    assert set(compiled.signals) == set(plain.signals)
    for name in compiled.signals:
        scale = np.abs(compiled[name]).max()
        np.testing.assert_allclose(plain[name], compiled[name], rtol=0.0, atol=1e-9 * scale + 1e-15, err_msg=name)
    one, other = (strict((tmp_path / out / "summary.json").read_text(encoding="utf-8"))["schemes"]["base"] for out in ("compiled", "plain"))
    for name, value in one["metrics"]["part_error"].items():
        if isinstance(value, float):
            assert other["metrics"]["part_error"][name] == pytest.approx(value, rel=1e-9, abs=1e-9 * one["metrics"]["part_error"]["max"])


DRAG = '''
from contourlab.components.contract import Component, param
from contourlab.primitives import fabs


class Drag(Component):
    """Resistance of air: F = c v |v|."""

    family = "friction"
    kind = "drag-of-a-test"
    law = "smooth"
    example = {"coefficient": 40.0}
    reference = "turbulent flow through a fixed opening"

    coefficient: float = param(unit="{force}*s^2/m^2", minimum=0.0, doc="force at unit speed, c")

    @staticmethod
    def force(par, v):
        return par.coefficient * v * fabs(v)
'''


def test_a_machine_may_hold_a_component_from_a_loose_file(contourlab: Run, tmp_path: Path) -> None:
    """At constant speed the drive pays for damping and drag alone: b v + c v^2 = (2 pi / l) K_t i."""
    (tmp_path / "drag.py").write_text(DRAG, encoding="utf-8")
    (tmp_path / "part.ngc").write_text("G21 G90\nG1 X40 F6000\nM2\n", encoding="utf-8")
    (tmp_path / "drag.toml").write_text(
        'controller = "builtin:xyz-controller"\nprogram = "part.ngc"\nmachine = {file = "builtin:xyz"}\n'
        '[axes.x]\nplant.damping = "1000 N*s/m"\nfriction = {kind = "drag-of-a-test", coefficient = "4000 N*s^2/m^2"}\n',
        encoding="utf-8",
    )
    chosen = ("--signals", "feedrate", "--signals", "applied_command")
    said = contourlab("run", "drag.toml", "--plugin", "drag.py", "--out", "results", *chosen)
    assert (said.code, said.err) == (0, "")
    result = Result.load(tmp_path / "results" / "signals" / "base.nc")
    assert set(result.signals) == {"feedrate", "applied_command"}
    cruise = np.flatnonzero(result["feedrate"] > 0.1 - 1e-12)
    current = result["applied_command"][cruise[len(cruise) // 2 :], 0].mean()
    assert current == pytest.approx((1000 * 0.1 + 4000 * 0.1**2) / (2 * np.pi / 0.01 * 0.49), rel=1e-3)
    without = contourlab("run", "drag.toml", "--out", "none")
    assert without.code == 2
    assert all(part in without.err for part in ("axes.x.friction.kind: ", "'drag-of-a-test'"))
    assert not (tmp_path / "none").exists()


LATE = """machine = "builtin:xyz"
controller = "builtin:xyz-controller"
program = "line.ngc"
[run]
tolerance = "2 um"
[schemes.late]
axes.x.drive.limit = "0.6 A"
"""


def test_a_tool_that_skips_part_of_the_path_is_told_beside_the_verdict(contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "late.toml").write_text(LATE, encoding="utf-8")
    (tmp_path / "line.ngc").write_text("G21 G90 G64\nG0 X0 Y0\nG1 X20 F3000\nM2\n", encoding="utf-8")
    said = contourlab("run", "late.toml", "--out", "results")
    verdict = strict((tmp_path / "results" / "summary.json").read_text(encoding="utf-8"))["schemes"]["late"]["verdict"]
    assert (said.code, verdict["passed"]) == (1, False)
    assert verdict["worst"]["value"] <= verdict["tolerance"] < verdict["left_out"]
    line = next(line for line in said.out.splitlines() if "FAIL" in line)
    assert f"{1e3 * verdict['left_out']:.3g} mm" in line


@pytest.mark.parametrize(("feed", "told"), [(100, False), (90000, True)])
def test_a_feed_that_is_never_reached_is_told(contourlab: Run, tmp_path: Path, feed: int, told: bool) -> None:
    (tmp_path / "line.ngc").write_text(f"G21 G90 G64\nG1 X20 F{feed}\nM2\n", encoding="utf-8")
    said = contourlab("run", "line.ngc", *ON_XYZ, "--out", "results")
    assert ("CL105" in said.out) is told


def test_a_run_that_does_not_fit_on_the_disk_is_refused_beforehand(
    contourlab: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "circle.toml").write_text(CIRCLE, encoding="utf-8")
    monkeypatch.setattr("shutil.disk_usage", lambda _: SimpleNamespace(free=1_000_000))
    said = contourlab("run", "circle.toml", "--out", "results")
    assert (said.code, said.err.count("\n")) == (2, 1)
    assert not (tmp_path / "results").exists()


@pytest.mark.slow
def test_ctrl_c_keeps_the_schemes_that_ended(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    from contourlab.features.run import command

    whole, ran = command.run_case, list[str]()

    def stopped(case: Any, *more: Any, **options: Any) -> Any:
        ran.append(case.name)
        if len(ran) == 3:
            raise KeyboardInterrupt
        return whole(case, *more, **options)

    monkeypatch.setattr(command, "run_case", stopped)
    monkeypatch.chdir(tmp_path)
    assert main(["run", "builtin:ghaffari/demo-stage"]) == 130
    said = capsys.readouterr().err.splitlines()
    assert said == ["contourlab: interrupted", f"Kept 2 of 4 schemes: {Path('results/report.html')}"]
    assert list(json.loads((tmp_path / "results" / "summary.json").read_text())["schemes"]) == ran[:2]
    ran[:] = ["", ""]
    assert main(["run", "builtin:ghaffari/demo-stage", "--out", "none"]) == 130
    assert capsys.readouterr().err == "contourlab: interrupted: no result is kept\n" and not (tmp_path / "none").exists()
