"""``contourlab sweep report`` as typed: a small study, its answers against its rows, and its page."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from made_studies import asked, made_study

import contourlab as cl
from contourlab.cli.main import main
from contourlab.study.statistics import wilson

STUDY = """\
# Which of them follow the circle?
scenario = "scenario.toml"
variants = 300
chunk = 128
design = "{design}"
figures = ["part_error_max", "cycle_time", "command_energy"]
[vary]
scheme = {{ values = ["position loop", "all of it"] }}
"feed.frequency" = {{ values = ["0.5 Hz", "0.4 Hz"] }}
"axes.*.friction.coulomb" = {{ values = ["70 %", "100 %", "130 %"], together = true }}
"axes.1.plant.gain" = {{ uniform = ["90 %", "110 %"]{steps} }}
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_answers_are_those_of_the_rows(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made_study(folder, STUDY.format(design="random", steps=""))
    assert main(["sweep", "study.toml", "--out", "store"]) == 0
    found = asked(capsys, "report", "store")["answers"]
    rows = asked(capsys, "query", "store", "SELECT * FROM results ORDER BY variant")
    error = np.array([row["part_error_max"] for row in rows])
    assert (found["judged"], found["passed"]) == (300, int(np.count_nonzero(error <= 27.8e-6)))
    assert found["median"] == np.sort(error)[149] and found["p95_low"] < found["p95"] < found["p95_high"]

    columns = [effect["column"] for effect in found["effects"]]
    assert set(columns) == {"scheme", "feed.frequency", "axes.*.friction.coulomb", "axes.1.plant.gain"} and len(columns) == 4
    cuts = [effect["gain"] for effect in found["effects"] if effect["cut"] is not None]
    assert all(300 * gain > 15 for gain in cuts) and len(cuts) < 4
    subsets = {(one["column"], one["value"]): one for one in found["subsets"]}
    assert len(subsets) == 2 + 2 + 3
    chosen = error[[row["scheme"] == "all of it" for row in rows]]
    assert subsets["scheme", "all of it"]["judged"] == len(chosen)
    assert subsets["scheme", "all of it"]["passed"] == np.count_nonzero(chosen <= 27.8e-6)
    assert [one["variants"] for one in found["convergence"]] == [150, 300]

    assert list(found["objectives"]) == ["part_error_max", "cycle_time", "command_energy"]
    assert found["front"][0]["part_error_max"] == error.min()
    page = Path("store/report.html").read_text(encoding="utf-8")
    assert "Which of them follow the circle?" in page and not re.search(r"(src|href)=.?http", page)
    assert main(["sweep", "report", "store", "--out", "again.html"]) == 0
    assert Path("again.html").read_text(encoding="utf-8") == page
    Path("store/report.html").unlink()
    answer = cl.sweep.report("store")
    assert answer.page is None and answer.answers.judged == 300 and not Path("store/report.html").exists()  # a function writes nothing
    assert cl.sweep.show("store").report(folder / "named.html").page == folder / "named.html"
    answer.save()
    assert {Path(name).read_text(encoding="utf-8") for name in ("store/report.html", "named.html")} == {page}
    assert asked(capsys, "show", "store")["done"] == 300  # the page in the store disturbs nobody


def test_a_grid_is_no_sample(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made_study(folder, STUDY.format(design="grid", steps=", steps = 3").replace("variants = 300\n", ""))
    assert main(["sweep", "study.toml", "--out", "store"]) == 0
    found = asked(capsys, "report", "store", "--figure", "command_energy", "--out", "page.html")["answers"]
    assert found["convergence"] == [] and found["needed_for_yield"] is None and found["tolerance"] is None
    assert "cycle_time" in found["objectives"] and Path("page.html").exists() and not Path("store/report.html").exists()
    assert main(["sweep", "report", "store"]) == 0
    for words in (["store", "--figure", "nothing"], ["."], ["store", "--out", "page.html/x"]):
        assert main(["sweep", "report", *words]) == 2
    manifest = json.loads(Path("store/manifest.json").read_text())
    Path("empty").mkdir()
    Path("empty/manifest.json").write_text(json.dumps(manifest))
    assert main(["sweep", "report", "empty"]) == 2


def test_a_saltelli_study_tells_what_needs_a_parameter(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made_study(folder, STUDY.format(design="saltelli", steps="").replace("300", "390"))  # 65 groups of 4 draws
    assert main(["sweep", "study.toml", "--out", "store"]) == 0
    found = asked(capsys, "report", "store")["answers"]
    rows = asked(capsys, "query", "store", "SELECT * FROM results ORDER BY variant")
    figure = np.array([row["part_error_max"] for row in rows]).reshape(65, 6)
    variance = figure[:, :2].var()
    totals = {one["column"]: one["total"] for one in found["effects"]}
    for i, column in enumerate(("scheme", "feed.frequency", "axes.*.friction.coulomb", "axes.1.plant.gain"), 2):
        assert totals[column] == pytest.approx(np.mean((figure[:, 0] - figure[:, i]) ** 2) / 2.0 / variance)
    assert totals["scheme"] > 0.5 > totals["axes.1.plant.gain"] > 0.0
    passed = found["passed"] / found["judged"]
    assert found["low"] < wilson(found["passed"], found["judged"])[0] < passed  # variants that share draws tell less
