"""An unstable loop is called unstable wherever its margins would appear."""

from __future__ import annotations

import json
from dataclasses import asdict, replace
from typing import Any

import pytest

import contourlab as cl
from contourlab.analysis.linear.margins import Margins
from contourlab.app.json_values import json_text
from contourlab.features.run.outcome import Outcome, bode_of, run_case
from contourlab.features.run.report import report_data
from contourlab.rendering.comparison import compare


@pytest.fixture(scope="module")
def outcomes() -> list[Outcome]:
    case = cl.load_scenario("builtin:demo-part.toml").case("position loop")
    made: Any = case.controller.axes["y"]
    wild = replace(made, controller=made.controller.replace(velocity_gain=60.0 * made.controller.velocity_gain))
    found = run_case(case, explain=False)
    controller = replace(case.controller, axes={**case.controller.axes, "y": wild})
    return [found, replace(found, name="wild", bode=bode_of(case.machine, controller))]


def test_margins_of_an_unstable_axis(outcomes: list[Outcome]) -> None:
    tame, wild = (outcome.bode for outcome in outcomes)
    assert [tame[axis].margins.stable for axis in "xyz"] == [True, True, True]
    assert [wild[axis].margins.stable for axis in "xyz"] == [True, False, True]


def test_the_page_and_the_table_say_unstable(outcomes: list[Outcome]) -> None:
    data = report_data("t", outcomes, scenario="", command="")
    calm, shaky = (scheme.bode["y"].notes for scheme in data.schemes)
    assert {"bandwidth (-3 dB)", "phase margin", "gain margin", "modulus margin"} == set(calm)
    assert list(shaky) == ["loop"]
    assert shaky["loop"].startswith("unstable")
    (row,) = (row for row in compare(data).rows if row.label == "servo loops")
    assert [(cell.text, cell.mood) for cell in row.cells] == [("stable", ""), ("unstable: y", "poor")]
    assert "servo loops" not in [row.label for row in compare(report_data("t", outcomes[:1], scenario="", command="")).rows]


def test_the_summary_says_so_too(outcomes: list[Outcome]) -> None:
    found = json.loads(json_text(outcomes[1]))["margins"]
    assert found["y"] == {**dict.fromkeys(asdict(Margins(0.0, 0.0, 0.0, 0.0))), "stable": False}
    assert found["x"]["stable"] is True
    assert found["x"]["gain"] > 2.0
    assert found["x"]["phase_crossover"] > found["x"]["crossover"] > 0.0
