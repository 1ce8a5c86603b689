"""What the viewer of a notebook is given."""

from __future__ import annotations

import gzip

import made_circles
import numpy as np
import pytest
from made_studies import made_study
from messages import pictures

import contourlab as cl
from contourlab.errors import ParameterError
from contourlab.features.run import show
from contourlab.rendering.html import VIEWER

pytest.importorskip("anywidget", reason="no anywidget in this environment")


@pytest.fixture(scope="module")
def case():
    return cl.load_scenario("builtin:ghaffari/demo-stage").base


@pytest.fixture(scope="module")
def circle(case):
    return cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 1, case.machine.servo_period)


@pytest.fixture(scope="module")
def result(case, circle):
    return cl.judge(cl.simulate(case.machine, case.controller, circle), circle)


def test_runs_are_shown_as_in_their_report(result):
    view = cl.show({"first": result, "again": result}, tolerance=50e-6)
    shown = pictures(view.message)
    scene = shown["path-space"]
    assert [run["name"] for run in scene["runs"]] == ["first", "again"] and scene["tolerance"] == 50.0
    assert max(scene["runs"][0]["size"]) == pytest.approx(1e6 * np.abs(result["part_error"]).max(), rel=1e-4)
    assert {"error-time", "axis-0"} <= shown.keys()
    assert gzip.decompress(view.viewer).decode() == VIEWER.read_text(encoding="utf-8")
    assert list(pictures(cl.show(result, "axis-0").message)) == ["axis-0"]


def test_an_answer_shows_its_own_pictures(case, tmp_path):
    test = cl.circle(made_circles.write_log(tmp_path / "log.csv", x=8e-6))
    (causes,) = pictures(cl.show(test).message).values()
    assert causes["kind"] == "CircleCauses" and "backlash x" in causes["causes"]
    runs = cl.run(case)
    assert pictures(cl.show(runs).message).keys() >= {"path-space", "live", "error-time", "bode-0"}


def test_a_stored_study_shows_the_pictures_of_its_page(tmp_path):
    pytest.importorskip("duckdb", reason="no DuckDB in this environment")
    study = cl.sweep(made_study(tmp_path), out=tmp_path / "store")
    shown = pictures(cl.show(study).message)
    assert shown.keys() == pictures(cl.show(study.report()).message).keys() == {"distribution"}


def test_a_motion_is_shown_as_a_machine_without_error_makes_it(circle):
    shown = pictures(cl.show(circle).message)
    (run,) = shown["path-space"]["runs"]
    np.testing.assert_allclose(np.hypot(*run["foot"][:, :2].T), 5.0, rtol=1e-5)
    assert np.abs(run["size"]).max() < 1e-3
    np.testing.assert_allclose(run["feedrate"], 6e4 * 2.0 * np.pi * 5e-3, rtol=1e-3)


def test_a_study_is_shown_by_its_distribution_and_over_each_parameter(case, circle):
    gains = np.array([1.1, 0.9, 1.0])
    batch = cl.simulate_batch(case.machine, case.controller, circle, {"axes.3.plant.gain": gains})
    shown = pictures(cl.show(batch).message)
    assert list(shown) == ["distribution", "axes.3.plant.gain"]
    errors = {curve["name"]: curve for curve in shown["distribution"]["panels"][0]["curves"]}
    largest = 1e6 * batch.figures["contour_error_max"]
    np.testing.assert_allclose(errors["contour error max"]["x"], np.sort(largest), rtol=1e-6)
    np.testing.assert_allclose(errors["contour error max"]["y"], [100 / 3, 200 / 3, 100], rtol=1e-6)
    points = {curve["name"]: curve for curve in shown["axes.3.plant.gain"]["panels"][0]["curves"]}["contour error max"]
    np.testing.assert_allclose((points["x"], points["y"]), (gains, largest), rtol=1e-6)


def test_what_the_viewer_does_not_draw_is_refused(result, circle, monkeypatch):
    for given, keys in ((3, ()), ("run", ()), (result, ("path-0",))):
        with pytest.raises(ParameterError):
            cl.show(given, *keys)
    monkeypatch.setattr(show, "MOST_SAMPLES", 10)
    with pytest.raises(ParameterError):
        cl.show(circle)
