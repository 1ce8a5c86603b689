"""``contourlab sweep optimise`` as typed: searches that improve, several figures, and going on after a kill."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from made_studies import asked, exported, made_study

from contourlab.cli.main import main
from contourlab.features.sweep import command as optimise
from contourlab.features.sweep.store import Store

STUDY = """\
scenario = "scenario.toml"
scheme = "all of it"
seed = 3
figures = ["part_error_max", "command_energy"]
[vary]
"axes.1.friction.coulomb" = { uniform = ["10 %", "200 %"] }
"axes.*.plant.gain" = { normal = ["100 %", "10 %"] }
"""
CHOICES = """\
scheme = { values = ["position loop", "all of it"], weights = [1, 3] }
"axes.3.friction.coulomb" = { values = ["50 %", "100 %"] }
"""
SMALL = ["--trials", "112", "--batch", "32"]
BOTH = ["--minimise", "part_error_max", "--minimise", "command_energy"]
Capture = pytest.CaptureFixture[str]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("optuna")
    monkeypatch.chdir(tmp_path)
    made_study(tmp_path, STUDY)


@pytest.mark.slow
@pytest.mark.parametrize("sampler", ["tpe", "nsga2", "cma-es"])
def test_a_search_finds_better_variants(capsys: Capture, sampler: str) -> None:
    found = asked(capsys, "optimise", "study.toml", "--out", "store", "--sampler", sampler, *SMALL)
    errors = np.array([row["part_error_max"] for row in asked(capsys, "query", "store", "SELECT * FROM results ORDER BY variant")])
    assert (found["done"], len(errors), found["front_size"]) == (112, 112, 1)
    assert found["best"][0]["variant"] == np.argmin(errors) and found["best"][0]["part_error_max"] == errors.min()
    assert np.median(errors[96:]) < np.quantile(errors[:32], 0.3)  # the last batch is where the first was good
    report = asked(capsys, "report", "store")["answers"]
    assert (report["design"], report["smallest"]) == ("search", errors.min())
    assert [report[name] for name in ("tolerance", "share", "needed_for_yield", "effects", "subsets")] == [None, None, None, [], []]
    assert 'href="#decides"' not in Path("store/report.html").read_text(encoding="utf-8")
    assert asked(capsys, "show", "store")["yield"] is None
    assert main(["sweep", "worst", "store", "--rerun", str(np.argmin(errors)), "--out", "best"]) in (0, 1)


@pytest.mark.slow
def test_several_figures_give_a_front(capsys: Capture) -> None:
    Path("study.toml").write_text(STUDY.replace('scheme = "all of it"\n', "") + CHOICES)
    found = asked(capsys, "optimise", "study.toml", "--out", "store", *BOTH, *SMALL)
    rows = asked(capsys, "query", "store", "SELECT * FROM results ORDER BY part_error_max, command_energy")
    lowest, front = np.inf, []
    for row in rows:
        if row["command_energy"] < lowest:
            lowest = row["command_energy"]
            front.append((row["part_error_max"], lowest))
    assert found["sampler"] == "nsga2" and found["front_size"] == len(front) > 3
    assert (found["best"][0]["part_error_max"], found["best"][0]["command_energy"]) == front[0]
    assert {row["scheme"] for row in rows} == {"position loop", "all of it"} and len({row["axes.3.friction.coulomb"] for row in rows}) == 2


@pytest.mark.slow
@pytest.mark.parametrize("words", [["--sampler", "tpe"], BOTH, ["--sampler", "cma-es"]])
def test_a_search_goes_on_after_a_kill(capsys: Capture, monkeypatch: pytest.MonkeyPatch, words: list[str]) -> None:
    assert main(["sweep", "optimise", "study.toml", "--out", "whole", *words, *SMALL]) == 0
    command = ["sweep", "optimise", "study.toml", "--out", "store", *words, *SMALL, "--resume"]

    def killed(*given: object, **more: object) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:  # the batch is stored, but Optuna does not hear of it
        patch.setattr(Store, "log", killed)
        assert main(command) == 130
    assert len(list(Path("store").glob("part-*"))) == 1
    with monkeypatch.context() as patch:  # asked, but not simulated
        patch.setattr(optimise, "run_chunks", killed)
        assert main(command) == 130
    with Path("store/optuna.log").open("a") as stream:  # half a line
        stream.write('{"op_code": 5, "work')
    assert main(command) == 0
    assert exported(Path("store")) == exported(Path("whole"))
    sorted(Path("store").glob("part-*"))[1].unlink()
    assert asked(capsys, *command[1:])["done"] == 112 and exported(Path("store")) == exported(Path("whole"))
    assert main([*command[:-1]]) == 2


@pytest.mark.parametrize(
    "words",
    [
        ["--minimise", "nothing"],
        ["--sampler", "best"],
        [*BOTH, "--sampler", "cma-es"],
        ["--minimise", "part_error_max"] * 2,
        ["--batch", "1"],
    ],
)
def test_wrong_options_are_refused(words: list[str]) -> None:
    assert main(["sweep", "optimise", "study.toml", "--out", "store", *words]) == 2
    assert not Path("store").exists()


@pytest.mark.parametrize("design", ["list", "random"])
def test_studies_that_no_search_fits_are_refused(design: str) -> None:
    lines = '[vary]\n"axes.1.friction.coulomb" = { values = ["50 %", "100 %"] }\n'
    text = STUDY.partition("[vary]")[0] + ("" if design == "random" else 'design = "list"\n')
    Path("study.toml").write_text((text if design == "random" else text.replace("variants = 100\n", "")) + lines)
    assert main(["sweep", "optimise", "study.toml", "--out", "store", "--sampler", "cma-es"]) == 2
    assert not Path("store").exists()
