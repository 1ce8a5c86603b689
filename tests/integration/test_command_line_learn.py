"""`contourlab learn` and `contourlab compare`, as typed."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from typed_commands import Run

from contourlab.cli.main import main
from contourlab.loop.trials import Trials

LEARNING = """\
name = "again and again"
machine = "builtin:ghaffari/a3a1"
controller = "builtin:ghaffari/placed"
[contour]
name = "circle"
radius = "5 mm"
[feed]
law = "uniform"
frequency = "{frequency}"
laps = 1
[learning]
law = {{kind = "zero-phase", gain = {gain}, half_width = {half_width}}}
trials = 4
[schemes.coupled]
learning.law = "none"
[schemes.coupled.controller]
estimator = "tangent"
coupling = {{kind = "cross-coupled", gain = "2 full_scale/mm"}}
"""


def write(folder: Path, frequency: str = "0.5 Hz", gain: float = 0.3, half_width: int = 5) -> str:
    text = LEARNING.format(frequency=frequency, gain=gain, half_width=half_width)
    (folder / "s.toml").write_text(text, encoding="utf-8")
    return "s.toml"


@pytest.mark.slow
def test_schemes_by_their_parts(contourlab: Run, tmp_path: Path) -> None:
    names = ["fb", "ccc", "ilc", "ccc+ilc", "mr", "me+ilc", "coupled"]
    said = contourlab("compare", write(tmp_path), "--schemes", ",".join(names), "--json")
    assert said.code == 0, said.err
    schemes = json.loads(said.out)["schemes"]
    assert list(schemes) == names
    rms = {name: scheme["metrics"]["contour_error"]["rms"] for name, scheme in schemes.items()}
    assert rms["ccc"] < rms["fb"] and rms["ccc+ilc"] < rms["ccc"] and rms["ilc"] < rms["fb"]
    assert rms["coupled"] == rms["ccc"]
    assert {name for name, scheme in schemes.items() if scheme["learning"]} == {"ilc", "ccc+ilc", "me+ilc"}
    assert all(1e-9 < scheme["tick"] < 1e-3 for scheme in schemes.values())
    assert sorted(file.name for file in (tmp_path / "results" / "learned").iterdir()) == ["ccc-ilc.nc", "ilc.nc", "me-ilc.nc"]
    # Trial 0 of a scheme that learns is the scheme that does not.
    assert schemes["ccc+ilc"]["learning"]["trials"][0]["contour_rms"] == pytest.approx(rms["ccc"], rel=1e-6)


@pytest.mark.slow
def test_learning_goes_on_where_it_ended(contourlab: Run, tmp_path: Path) -> None:
    file = write(tmp_path)
    first = json.loads(contourlab("learn", file, "--schemes", "ilc", "--json").out)["schemes"]
    assert list(first) == ["before learning", "ilc"]
    trials = first["ilc"]["learning"]["trials"]
    assert len(trials) == 5
    assert first["before learning"]["metrics"]["contour_error"]["rms"] == pytest.approx(trials[0]["contour_rms"], rel=1e-6)
    assert first["ilc"]["metrics"]["contour_error"]["rms"] == pytest.approx(
        trials[first["ilc"]["learning"]["best_trial"]]["contour_rms"], rel=1e-6
    )
    again = contourlab("learn", file, "--schemes", "ilc", "--table", "results/learned/ilc.nc", "--trials", "2", "--out", "on", "--json")
    more = json.loads(again.out)["schemes"]["ilc"]["learning"]["trials"]
    assert more[0]["contour_rms"] == pytest.approx(trials[-1]["contour_rms"], rel=1e-3)
    assert len(more) == 3
    table = (tmp_path / "results" / "learned" / "ilc.nc").read_bytes()
    own = contourlab("learn", file, "--schemes", "ilc", "--table", "results/learned/ilc.nc")
    assert own.code == 2 and "results/learned/ilc.nc" in own.err.replace("\\", "/") and own.err.count("\n") == 1
    assert (tmp_path / "results" / "learned" / "ilc.nc").read_bytes() == table
    # Another feed is another motion.
    write(tmp_path, frequency="0.625 Hz")
    refused = contourlab("learn", file, "--schemes", "ilc", "--table", "results/learned/ilc.nc", "--out", "no")
    assert refused.code == 2
    assert "results/learned/ilc.nc: " in refused.err.replace("\\", "/") and refused.err.count("\n") == 1
    assert not (tmp_path / "no").exists()


@pytest.mark.slow
def test_the_text_shows_trials_and_the_forecast(contourlab: Run, tmp_path: Path) -> None:
    said = contourlab("learn", write(tmp_path, gain=0.9, half_width=0), "--schemes", "ilc", "--trials", "60")
    assert said.code == 0
    assert "before learning" in said.out
    assert "contour rms" in said.out
    assert "ilc: CL315" in said.out


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["compare", "s.toml", "--schemes", "fb,fb"], "scheme 'fb' is given twice"),
        (["compare", "s.toml", "--schemes", "fb,warp"], "no scheme 'warp': use one of 'coupled', fb, ccc, mr, me, ilc"),
        (["compare", "s.toml", "--schemes", "ccc+mr"], "at most one coupling"),
        (["learn", "s.toml", "--schemes", "coupled"], "no scheme learns"),
        (["learn", "s.toml", "--schemes", "ilc", "--trials", "0"], "--trials = 0: must be 1 or more"),
        (["learn", "s.toml", "--schemes", "ilc", "--table", "nowhere.nc"], "nowhere.nc: cannot be read as a learned table"),
        (["learn", "part.ngc"], "part.ngc: no such file"),
        (["learn", "nowhere.toml"], "nowhere.toml: cannot be read"),
    ],
)  # fmt: skip
@pytest.mark.slow
def test_invalid_commands_are_refused(contourlab: Run, tmp_path: Path, words: list[str], message: str) -> None:
    write(tmp_path)
    assert message in contourlab(*words).refusal
    assert not (tmp_path / "results").exists()


@pytest.mark.slow
def test_a_table_that_cannot_be_read_is_refused_before_anything_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("contourlab.features.run.command.run_case", pytest.fail)
    monkeypatch.chdir(tmp_path)
    assert main(["learn", write(tmp_path), "--schemes", "ilc", "--table", "nowhere.nc"]) == 2
    assert "nowhere.nc" in capsys.readouterr().err


@pytest.mark.slow
def test_a_part_missing_from_the_scenario_is_named(contourlab: Run, tmp_path: Path) -> None:
    file = tmp_path / "s.toml"
    text = (tmp_path / write(tmp_path)).read_text()
    file.write_text(text[: text.index("[learning]")])
    for scheme, wanted in (("ccc", 'coupling = {kind = "cross-coupled"'), ("ilc", 'law = {kind = "zero-phase"')):
        said = contourlab("compare", "s.toml", "--schemes", scheme)
        assert said.code == 2
        assert wanted in said.err
    assert contourlab("compare", "s.toml", "--schemes", "fb,mr,me").code == 0


@pytest.mark.slow
def test_tables_of_other_schemes_are_kept(contourlab: Run, tmp_path: Path) -> None:
    file = write(tmp_path)
    contourlab("learn", file, "--schemes", "ilc", "--trials", "1")
    before = (tmp_path / "results" / "learned" / "ilc.nc").read_bytes()
    contourlab("learn", file, "--schemes", "ccc+ilc", "--trials", "1")
    assert contourlab("compare", file, "--schemes", "fb,ccc").code == 0
    assert sorted(path.name for path in (tmp_path / "results" / "learned").iterdir()) == ["ccc-ilc.nc", "ilc.nc"]
    assert (tmp_path / "results" / "learned" / "ilc.nc").read_bytes() == before
    assert sorted(path.name for path in (tmp_path / "results" / "signals").iterdir()) == ["ccc.nc", "fb.nc"]


@pytest.mark.slow
def test_an_interrupt_keeps_the_learned_tables(contourlab: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    run = Trials.run

    def interrupted(self: Trials, table: Any, trial: int, *more: Any) -> Any:
        if trial == 3:
            raise KeyboardInterrupt
        return run(self, table, trial, *more)

    monkeypatch.setattr(Trials, "run", interrupted)
    said = contourlab("learn", write(tmp_path, gain=0.1, half_width=274), "--schemes", "ilc", "--trials", "100")
    assert said.code == 130 and "Traceback" not in said.err
    assert (tmp_path / "results" / "learned" / "ilc.nc").exists()
