"""The one table of figures: lanes and single runs agree, and a new entry reaches every study and the report."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import contourlab as cl
from contourlab.errors import ParameterError
from contourlab.features.link.sweep import LinkSetting
from contourlab.features.sensitivity.options import Plan
from contourlab.features.swap.variants import Variants, variants_of
from contourlab.features.tune.objective import Goal, Objective, evaluate
from contourlab.metrics.run_figures import FIGURES, GOALS, RunFigure, figures_of_run, goal_named
from contourlab.study import Runner, Setting, Space
from contourlab.study.guards import Bounds

CREST = RunFigure(
    "tracking_error_crest",
    "tracking error, crest factor",
    "",
    lambda s: np.sqrt(s["largest_tracking"] * s["count"] / s["sum_tracking"]),
    word="crest",
)


@pytest.fixture(scope="module")
def setting() -> Setting:
    case = cl.load_scenario("builtin:ghaffari/demo-stage").base
    circle = cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 2, case.machine.servo_period)
    return Setting(case.machine, case.controller, circle)


@pytest.fixture
def crest(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(FIGURES, CREST.name, CREST)
    monkeypatch.setitem(GOALS, CREST.name, CREST)


def test_lanes_and_a_single_run_have_the_same_figures(setting: Setting) -> None:
    lanes = Runner(setting, tuple(FIGURES))(setting.as_it_is())
    alone = evaluate(setting, Bounds()).figures
    assert alone.keys() == FIGURES.keys() == lanes.keys() - {"failed_at"}
    for name, value in alone.items():
        assert value == pytest.approx(lanes[name][0], rel=1e-5, abs=1e-12), name


def test_an_unknown_goal_is_refused() -> None:
    assert goal_named("integral", "--figure") is goal_named("contour_error_integral", "--figure")
    for text in ("", "mood", "contour_error_signed_mean", "limited_share"):
        with pytest.raises(ParameterError) as caught:
            goal_named(text, "--figure")
        assert (caught.value.name, caught.value.value) == ("--figure", repr(text))


@pytest.mark.usefixtures("crest")
def test_one_new_entry_is_an_objective_of_every_study(setting: Setting) -> None:
    judged = cl.judge(setting.single(), setting.reference)
    behind = np.linalg.norm(judged["tracking_error"][setting.reference.judged.samples], axis=1)
    expected = behind.max() / np.sqrt(np.mean(behind**2))
    assert figures_of_run(judged, setting.reference.judged)[CREST.name] == pytest.approx(expected)
    batch = setting.batch(setting.as_it_is())
    assert batch.figures[CREST.name][0] == pytest.approx(expected, rel=1e-5) and batch.units[CREST.name] == ""
    name, own = next((name, values) for name, values in setting.as_it_is().items())
    objective = Objective(Runner(setting), Goal.parse("crest"), {name: float(own[0])})
    assert objective.at({name: float(own[0])}).value[0] == pytest.approx(expected, rel=1e-5)
    assert Plan(figure="crest").judged is CREST
    space = Space.chosen(setting.machine, setting.controller)
    first, second = setting.machine.axes
    members = variants_of(setting.machine, {first.name: [("other", second)]})
    variants = Variants(members, setting, space, objective="tracking_error_crest", floor=CREST.floor)
    assert variants.values(np.tile(space.start, (len(variants), 1, 1)), whole=True)[0][0, 0] == pytest.approx(expected, rel=1e-5)
    with pytest.raises(ParameterError, match="network"):  # beyond the check of the figure
        LinkSetting(setting, "crest", 1.0)


@pytest.mark.usefixtures("crest")
def test_one_new_entry_is_a_row_of_the_report(setting: Setting, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert any(CREST.label in line for line in cl.run("builtin:ghaffari/demo-stage").text.splitlines())
