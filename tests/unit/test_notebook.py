"""What a notebook shows: tables for pandas, pictures with the values in them."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

import contourlab as cl
from contourlab.errors import FeedError, ParameterError, ResultError
from contourlab.geometry.line_and_arc import Line
from contourlab.notebook import MOST_POINTS


@pytest.fixture(scope="module")
def run():
    case = cl.load_scenario("builtin:ghaffari/demo-stage").base
    reference = cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 1, case.machine.servo_period)
    return case, reference, cl.judge(cl.simulate(case.machine, case.controller, reference), reference)


def test_a_table_has_a_column_for_each_axis(run):
    result = run[2]
    frame = result.to_pandas()
    assert np.array_equal(frame["reference 3"], result["reference"][:, 1])
    assert np.array_equal(frame["contour_error"], result["contour_error"]) and np.array_equal(frame.index, result.time)


def test_a_picture_shows_path_and_error(run):
    path, error = run[2].plot().axes
    assert [line.get_label() for line in path.lines] == ["reference", "axes"]
    assert np.array_equal(error.lines[0].get_ydata(), 1e6 * run[2]["contour_error"])
    assert "<svg" in run[2]._repr_html_() and len(repr(run[2])) < 200


def test_a_result_without_positions_has_a_table_only(run):
    from dataclasses import replace

    bare = replace(run[2], signals={"contour_error": run[2].signals["contour_error"]})
    assert "<svg" not in bare._repr_html_()
    with pytest.raises(ResultError):
        bare.plot()


def test_a_batch_becomes_a_table_and_a_curve(run):
    case, reference, _ = run
    gains = np.array([1.1, 0.9, 1.0])
    batch = cl.simulate_batch(case.machine, case.controller, reference, {"axes.*.plant.gain": gains})
    frame = batch.to_pandas()
    assert np.array_equal(frame["axes.3.plant.gain"], gains)
    assert np.array_equal(frame["contour_error_max"], batch.figures["contour_error_max"])
    line = batch.plot("contour_error_rms").axes[0].lines[0]
    assert line.get_xdata().tolist() == [0.9, 1.0, 1.1] and line.get_ydata()[-1] == 1e6 * batch.figures["contour_error_rms"][0]
    assert "<svg" in batch._repr_html_() and len(repr(batch)) < 500
    assert (batch.units["axes.3.plant.gain"], batch.units["contour_error_max"]) == ("m/s^2/full_scale", "m")
    with pytest.raises(ParameterError):
        batch.plot("error")


def test_a_sweep_of_a_thousand_variants_is_one_table(run):
    case, reference, _ = run
    random = np.random.default_rng(1)
    variants = {f"axes.{axis}.plant.gain": random.uniform(0.9, 1.1, 1000) for axis in case.machine.axis_names}
    batch = cl.simulate_batch(case.machine, case.controller, reference, variants, part=True, effort=True)
    frame = batch.to_pandas()
    assert frame.shape == (1000, len(variants) + len(batch.figures) + 1)
    assert set(batch.units) == {*variants, *batch.figures}
    assert all(np.array_equal(frame[name], values) for name, values in variants.items())
    # Values that differ independently are points: a line through them says nothing.
    assert batch.plot().axes[0].lines[0].get_linestyle() == "None"
    assert "1000" in batch._repr_html_()


def test_one_variant_is_a_point(run):
    case, reference, _ = run
    (line,) = cl.simulate_batch(case.machine, case.controller, reference, {"axes.*.plant.gain": [1.0]}).plot().axes[0].lines
    assert line.get_xdata().tolist() == [1.0] and line.get_marker() == "."


def test_a_failed_variant_leaves_a_gap(run):
    case, reference, _ = run
    batch = cl.simulate_batch(case.machine, case.controller, reference, {"axes.*.plant.gain": [1e9]})
    assert np.isnan(batch.to_pandas()["contour_error_max"]).all() and batch.to_pandas()["failed_at"][0] >= 0
    assert "<td" in batch._repr_html_()


def test_metrics_show_each_error(run):
    _, reference, judged = run
    metrics = cl.summarise(judged, reference)
    frame = metrics.to_pandas()
    assert frame.index.tolist() == ["part error", "contour error", "planning deviation", "tracking error 1", "tracking error 3"]
    assert frame.loc["part error", "max"] == metrics.part_error.max
    assert frame.loc["contour error", "worst_time"] == metrics.contour_error.worst.time
    assert frame.loc["tracking error 3", "rms"] == metrics.tracking_error[1].rms
    largest, rms = metrics.plot().axes[0].containers
    assert [bar.get_width() for bar in largest] == pytest.approx((1e6 * frame["max"]).tolist())
    assert [bar.get_width() for bar in rms] == pytest.approx((1e6 * frame["rms"]).tolist())
    assert "<svg" in metrics._repr_html_() and len(repr(metrics)) < 300


def test_a_reference_shows_path_and_feedrate(run):
    circle = run[1]
    path, feed = circle.plot().axes
    x, y = path.lines[0].get_data()
    assert np.hypot(x, y) == pytest.approx(5.0)
    assert feed.lines[0].get_ydata() == pytest.approx(6e4 * 2 * np.pi * 5e-3)
    assert "<svg" in circle._repr_html_() and len(repr(circle)) < 300
    frame = circle.to_pandas(100, 103)
    block = circle.block(100, 103)
    assert np.array_equal(frame["position 2"], block.position[:, 1]) and np.array_equal(frame["feedrate"], block.feedrate)
    assert np.array_equal(frame.index, np.arange(100, 103) * circle.servo_period)
    assert circle.to_pandas().shape == (circle.n_sample, 8)
    with pytest.raises(FeedError):
        circle.to_pandas(0, circle.n_sample + 1)


def test_a_long_reference_is_drawn_from_few_points():
    square = cl.Path([Line(*ends) for ends in pairwise([(0.0, 0.0), (0.1, 0.0), (0.1, 0.1), (0.0, 0.1), (0.0, 0.0)])], closed=True)
    limits = cl.AxisLimits([0.5, 0.5], [2.0, 2.0], [100.0, 100.0])
    reference = cl.plan(cl.route_from_path(square, 0.05), limits, 1e-3, laps=500)
    path, feed = reference.plot().axes
    assert reference.n_sample > 4_000_000 and not reference._kept
    assert len(path.lines[0].get_xdata()) <= MOST_POINTS and len(feed.lines[0].get_xdata()) <= MOST_POINTS
    corners = set(zip(*np.round(path.lines[0].get_data(), 9).tolist(), strict=True))
    assert {(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)} <= corners
    assert (feed.lines[0].get_ydata().min(), feed.lines[0].get_ydata().max()) == pytest.approx((0.0, 3000.0), abs=1e-6)


def test_a_recorded_reference_shows_its_samples():
    path = cl.contour("circle", radius=5e-3)
    reference = cl.Reference.from_samples(path.position(np.linspace(0.0, 0.01, 101)), 1e-3, path)
    drawn = reference.plot().axes
    assert np.array_equal(drawn[0].lines[0].get_xdata(), 1e3 * reference.block(0, 101).position[:, 0])
    assert np.array_equal(drawn[1].lines[0].get_ydata(), 6e4 * reference.block(0, 101).feedrate)


def test_what_a_scenario_holds_is_shown_in_a_line():
    scenario = cl.load_scenario("builtin:demo-part")
    case = scenario.cases()[-1]
    shown = (scenario, case, case.machine, case.controller, case.machine.axes[0], case.controller.axes["x"], case.motion.program)
    assert all(len(repr(value)) < 300 and "\n" not in repr(value) for value in shown), [len(repr(value)) for value in shown]
    assert f"axes: {', '.join(case.machine.axis_names)}" in repr(case.machine) and "newton" in repr(case.controller)
    assert case.name in repr(case) and "demo-part" in repr(scenario)


def test_the_tracking_error_of_a_run_is_drawn_with_the_sign_of_the_judge():
    case = cl.load_scenario("builtin:ghaffari/demo-stage").base
    circle = cl.uniform(cl.contour("circle", radius=5e-3), 2.0, 1, case.machine.servo_period)
    result = cl.simulate(case.machine, case.controller, circle)
    drawn = result.plot().axes[1].lines[0].get_data()
    error = 1e6 * cl.judge(result, circle)["tracking_error"][:, 0]
    assert np.allclose(drawn[1], error[np.rint(drawn[0] / circle.servo_period).astype(int)], rtol=0.0, atol=1e-9)
