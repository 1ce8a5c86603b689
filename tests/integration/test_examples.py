"""Every example runs in an empty folder and computes what its text claims."""

from __future__ import annotations

import runpy
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import contourlab as cl

EXAMPLES = Path(__file__).parents[2] / "examples"
NOTEBOOKS = EXAMPLES / "notebooks"
Values = dict[str, Any]


def strays(values: Values) -> None:
    verdict = values["verdict"]
    assert not verdict.passed
    assert verdict.worst.line == 48
    assert verdict.worst.value == pytest.approx(39.6e-6, rel=0.02)
    assert sum(cause.contribution for cause in verdict.causes) == pytest.approx(verdict.worst.value)


def controllers(values: Values) -> None:
    deviation = values["deviation"]
    coupled = deviation["with observer and cross-coupling"]
    assert coupled < 0.6 * deviation["with disturbance observer"] < 0.4 * deviation["position loop"]
    assert cl.contour_margins(values["machine"], values["coupled"]).modulus == pytest.approx(0.5, abs=0.01)


def learning(values: Values) -> None:
    first, learned = values["contour_error"].values()
    assert learned.max < 0.1 * first.max
    # The table, applied to a plain run, repeats the best trial.
    assert learned.max == pytest.approx(values["run"].trials[values["run"].best].contour_max, abs=1e-9)


def spikes(values: Values) -> None:
    # The gap, and the wind-up by friction: 2 * 103 N to 2 * 130 N over 100 N/um.
    found = values["found"]
    for gap, sigma in zip(found.backlash, found.deviation, strict=True):
        assert 22e-6 - 3.0 * sigma < gap < 22.6e-6 + 3.0 * sigma
    left = cl.backlash_of_runs(values["after"]).backlash
    assert max(left) < 0.2 * min(found.backlash)
    assert values["after"][0].circular_deviation < 0.75 * values["before"][0].circular_deviation


def series(values: Values) -> None:
    within = values["within"]
    assert within["observer"] == pytest.approx(0.66, abs=0.03)
    assert within["observer and cross-coupling"] > 0.99


def own(values: Values) -> None:
    deviation = values["deviation"]
    assert deviation["Coulomb", "own"] < 0.2 * deviation["Coulomb", "shipped"]
    assert deviation["LuGre, 5 N/um", "own"] > deviation["LuGre, 5 N/um", "shipped"]


def predictive(values: Values) -> None:
    largest, taken = values["largest"], values["taken"]
    assert largest["predictive"] < 0.3 * largest["position loop"]
    assert taken["predictive"] < 1.02 * taken["position loop"]


def agent(values: Values) -> None:
    largest, taken = values["largest"], values["taken"]
    assert taken["found"] < 0.96 * taken["as planned"] and largest["found"] < 1.1 * largest["as planned"]


SCRIPTS: dict[str, Callable[[Values], None]] = {
    "contour_error": strays,
    "controllers_compared": controllers,
    "learning": learning,
    "quadrant_spikes": spikes,
    "production_line": series,
    "own_component": own,
    "predictive_control": predictive,
    "feed_agent": agent,
}
CLAIMS = {
    "first-run": "changed_figures.part_error.max < 0.7 * figures.part_error.max, worst.line == 5",
    "every-question": "abs(refined.result.parameters[0].value / real.axes[0].plant.mass - 1.0) < 0.03, answer.done == 64, tuned.passed",
    "gain-sweep": "best < 0.5 * error[0, -1], best.bandwidth == 500.0, 2 * best.gain <= limit[-1]",
}
"""Expressions that are true at the end of a notebook."""
BRIEF = {
    "every-question": "from contourlab.app import quick\nfrom contourlab.papers.gecer_ulu import study\n"
    "quick.PLANNED, study.PARTS = 10.0, study.PARTS[1:2]"
}
"""What a notebook runs first here: quick answers get a quarter of their time, and one part of a paper is reproduced (all: tests/golden)."""


def test_every_example_is_here() -> None:
    assert {file.stem for file in EXAMPLES.glob("*.py")} == SCRIPTS.keys()
    assert {file.stem for file in NOTEBOOKS.glob("*.ipynb")} == CLAIMS.keys()


@pytest.mark.filterwarnings("ignore:FigureCanvasAgg is non-interactive:UserWarning")
@pytest.mark.parametrize("name", SCRIPTS)
@pytest.mark.slow
def test_script(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import matplotlib.pyplot as plt

    monkeypatch.chdir(tmp_path)
    values = runpy.run_path(str(EXAMPLES / f"{name}.py"))
    figure = plt.gcf()
    try:
        SCRIPTS[name](values)
        assert plt.get_fignums() == [figure.number], "one picture"
        assert all(axes.get_xlabel() or axes.name == "polar" for axes in figure.axes if axes.get_label() != "<colorbar>")
    finally:
        plt.close("all")
    assert not any(tmp_path.iterdir()), "a script leaves nothing behind"


@pytest.mark.slow
@pytest.mark.parametrize("name", CLAIMS)
def test_notebook(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import nbclient
    import nbformat

    monkeypatch.setenv("IPYTHONDIR", str(tmp_path / ".ipython"))
    book = nbformat.read(NOTEBOOKS / f"{name}.ipynb", 4)
    assert not any(cell.outputs or cell.execution_count for cell in book.cells if cell.cell_type == "code"), "saved without outputs"
    book.cells.insert(0, nbformat.v4.new_code_cell(BRIEF.get(name, "")))
    book.cells.append(nbformat.v4.new_code_cell(f"all(map(bool, ({CLAIMS[name]})))"))
    nbclient.NotebookClient(book, timeout=300, resources={"metadata": {"path": str(tmp_path)}}).execute()
    assert book.cells[-1].outputs[0].data["text/plain"] == "True"
