"""Pictures show the measured values."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
import synthetic

from contourlab.errors import ResultError
from contourlab.feed import uniform
from contourlab.feed.reference import CUTTING, Judged
from contourlab.geometry import Line, Path, contour
from contourlab.rendering.comparison import compare
from contourlab.rendering.page_tables import circle_tables
from contourlab.rendering.path_picture import path_charts, path_scene
from contourlab.rendering.run_pictures import axis_charts, bode_charts, error_charts, polar_charts
from contourlab.result import Signal, Status

POINTS = 2000


def test_magnified_error_is_the_radial_deviation(circle):
    chart = path_charts(circle, POINTS)[0]
    for scheme, run in zip(circle.schemes, chart.runs, strict=True):
        out = np.linalg.norm(run.foot, axis=1)
        np.testing.assert_allclose(out, synthetic.RADIUS * 1e3, rtol=1e-9)
        drawn = np.linalg.norm(run.drawn(500.0), axis=1) - out
        size = np.abs(drawn) * 1e3 / 500.0
        counted = scheme.result["part_error"][scheme.metrics.judged.samples]
        assert size.max() == pytest.approx(np.abs(counted).max() * 1e6, rel=1e-9)
        inside = np.einsum("ij,ij->i", run.foot, run.error) < 0.0
        np.testing.assert_array_equal(inside, drawn < 0.0)


def test_laps_that_do_not_count_are_not_drawn(square):
    run = path_charts(square, POINTS)[0].runs[0]
    assert len(run.foot) == square.schemes[0].metrics.judged.samples.size < square.schemes[0].result.n_sample


@pytest.mark.parametrize("points", [POINTS, 60])
def test_judged_stretches_are_not_joined(circle, points):
    scheme, ranges = circle.schemes[0], ((100, 250), (300, 301), (700, 900))
    apart = replace(scheme, metrics=replace(scheme.metrics, judged=Judged(ranges, "cutting moves")))
    charts = path_charts(replace(circle, schemes=(apart,)), points)
    for run in (charts[0].runs[0], charts[-1].runs[0]):
        gaps = np.flatnonzero(np.isnan(run.foot[:, 0]) & np.isnan(run.error[:, 0]))
        whole = np.split(run.foot[:, :2], gaps)
        feet = [circle.asked.position(scheme.result["foot_arc_length"][slice(*one)])[:, 0] * 1e3 for one in ranges]
        stretches = [np.isin(part[np.isfinite(part[:, 0]), 0], foot) for foot, part in zip(feet, whole, strict=True)]
        assert all(drawn.size and drawn.all() for drawn in stretches)


def test_largest_drawn_error_covers_about_a_tenth(circle):
    chart = path_charts(circle, POINTS)[0]
    largest = np.abs(circle.schemes[0].result["part_error"]).max()
    assert 0.04 * 0.04 < chart.magnification * largest <= 0.1 * 0.04


def test_tolerance_is_drawn_on_both_sides_of_the_path(circle):
    chart = path_charts(circle, POINTS)[0]
    radii = sorted(float(np.linalg.norm(edge.drawn(1.0), axis=1).mean()) for edge in chart.tolerance)
    np.testing.assert_allclose(radii, [20.0 - 5e-3, 20.0 + 5e-3], rtol=1e-9)


def test_worst_ring_is_on_the_worst_sample(circle):
    chart = path_charts(circle, POINTS)[0]
    for scheme, ring in zip(circle.schemes, chart.worst, strict=True):
        np.testing.assert_allclose(ring.drawn(1.0)[0], np.array(scheme.verdict.worst.position) * 1e3, rtol=1e-12)


def test_a_diverged_run_does_not_set_the_magnification(circle):
    before = path_charts(circle, POINTS)[0].magnification
    far = replace(circle.schemes[0], result=replace(circle.schemes[0].result, status=Status(False, 7, "x", "ran away")))
    assert path_charts(replace(circle, schemes=(far, circle.schemes[1])), POINTS)[0].magnification > before


def test_corners_are_drawn_sharp(square):
    line = path_charts(square, 50)[0].lines[0]
    for corner in square.planned.position(square.planned.corners) * 1e3:
        assert np.min(np.hypot(line.x - corner[0], line.y - corner[1])) < 1e-6


@pytest.mark.parametrize(
    ("end", "views"), [((0.02, 0.01, 0.0), ["XY"]), ((0.02, 0.01, 0.03), ["XY", "XZ", "YZ"]), ((0.0, 0.0, 0.02), ["XZ"])]
)
def test_views_follow_the_extent_of_the_path(single, end, views):
    path = Path([Line((0.0, 0.0, 0.0), end), Line(end, (0.0, 0.0, 0.0))], closed=True)
    data = synthetic.around(single, path, uniform(path, 0.5, 1, 1e-3))
    assert [chart.view for chart in path_charts(data, POINTS)] == views


def test_the_scene_holds_the_errors_of_the_judged_lap(circle):
    scene = path_scene(circle, POINTS)
    np.testing.assert_allclose(np.linalg.norm(scene.path, axis=1), synthetic.RADIUS * 1e3, rtol=1e-5)
    assert scene.judged.all() and (scene.tolerance, scene.axes) == (5.0, ("x", "y"))
    for scheme, run in zip(circle.schemes, scene.runs, strict=True):
        counted = np.abs(scheme.result["part_error"][scheme.metrics.judged.samples]) * 1e6
        np.testing.assert_allclose(np.linalg.norm(run.error, axis=1), run.size, rtol=2e-3, atol=2e-3)
        assert run.size.max() == pytest.approx(counted.max(), rel=1e-4)
        assert run.time[0] == scheme.metrics.judged.ranges[0][0] * 1e-3 and np.all(np.diff(run.time) > 0.0)
        np.testing.assert_allclose(run.feedrate, synthetic.RADIUS * 2 * np.pi * synthetic.FREQUENCY * 6e4, rtol=1e-6)
        assert set(run.lines) == {3, 4} and set(run.stretch) == {1}


def test_a_scene_far_from_zero_is_as_fine(single):
    (left, right), (low, high) = sides = (0.7, 0.7037), (0.01, 0.0123)
    corners = [(left, low), (right, low), (right, high), (left, high), (left, low)]
    path = Path([Line(*ends) for ends in pairwise(corners)], closed=True)
    scene = path_scene(synthetic.around(single, path, uniform(path, 0.05, 1, 1e-3)), POINTS)
    off = [np.abs(scene.path[:, axis] - 1e3 * side) for axis in (0, 1) for side in sides[axis]]
    assert np.min(off, axis=0).max() < 3.7 / 2**17


def test_worst_places_of_the_scene_are_apart_and_have_causes(circle):
    scheme = circle.schemes[0]
    counted = scheme.metrics.judged.samples
    sample = int(counted[np.argmax(np.abs(scheme.result["part_error"][counted]))])
    worst = replace(scheme.verdict.worst, sample=sample, time=sample * 1e-3, position=tuple(scheme.result["tool_position"][sample]))
    known = replace(scheme, verdict=replace(scheme.verdict, worst=worst))
    run = path_scene(replace(circle, schemes=(known,)), POINTS).runs[0]
    first, *others = run.worst
    np.testing.assert_allclose((np.array(first.foot) + 1e-3 * np.array(first.error))[:2], np.array(worst.position) * 1e3, rtol=1e-9)
    assert (first.time, first.line, first.cause) == (worst.time, 4, "friction at the reversal")
    assert [one.cause for one in others if one.size > 0.9 * first.size] == ["reversal of x"]  # on the other side of the circle
    assert [one.size for one in run.worst] == sorted((one.size for one in run.worst), reverse=True)
    assert min(np.diff(sorted(one.time for one in run.worst))) >= 0.05


@pytest.mark.parametrize("points", [POINTS, 60])
def test_the_scene_joins_no_judged_stretches(circle, points):
    ranges = ((100, 250), (300, 301), (700, 900))
    apart = tuple(replace(one, metrics=replace(one.metrics, judged=Judged(ranges, CUTTING))) for one in circle.schemes)
    scene = path_scene(replace(circle, schemes=apart), points)
    assert scene.unjudged == "rapids" and 0 < np.count_nonzero(scene.judged) < scene.judged.size
    for run in scene.runs:
        assert len(run.time) <= points + 2 * len(ranges)
        for number, (start, stop) in enumerate(ranges, 1):
            samples = np.rint(run.time[run.stretch == number] * 1e3)
            assert samples.size and (samples.min(), samples.max()) == (start, stop - 1)


def test_the_scene_of_a_path_in_space_has_three_axes(single):
    end = (0.02, 0.01, 0.03)
    path = Path([Line((0.0, 0.0, 0.0), end), Line(end, (0.0, 0.0, 0.0))], closed=True)
    scene = path_scene(synthetic.around(single, path, uniform(path, 0.5, 1, 1e-3)), POINTS)
    assert scene.axes == ("x", "y", "z") and scene.tolerance is None
    np.testing.assert_allclose(np.ptp(scene.path, axis=0), np.array(end) * 1e3, rtol=1e-4)
    assert scene.runs[0].worst[0].cause == "" and scene.runs[0].size.max() == pytest.approx(scene.runs[0].worst[0].size, rel=1e-3)


def test_of_four_axes_the_scene_says_which_it_shows(single):
    end = (0.02, 0.0, 0.03, 0.01)
    path = Path([Line((0.0,) * 4, end), Line(end, (0.0,) * 4)], closed=True)
    data = synthetic.around(single, path, uniform(path, 0.5, 1, 1e-3))
    scene = path_scene(data, POINTS)
    assert scene.axes == tuple(data.axes[i] for i in (0, 2, 3)) and ", ".join(data.axes[:3]) in scene.caption


def test_a_run_without_a_finite_error_leaves_the_scene_empty(single):
    result = single.schemes[0].result
    lost = replace(result, signals=dict(result.signals) | {"part_error": Signal(np.full(result.n_sample, np.nan), ("sample",), "m")})
    run = path_scene(synthetic.with_result(single, lost), POINTS).runs[0]
    assert run.time.size == 0 and run.foot.shape == (0, 3) and run.worst == ()


def test_error_over_time_holds_the_worst_value_at_its_time(circle):
    chart = error_charts(circle, 200)[0]
    for scheme, curve in zip(circle.schemes, chart.panels[0].curves, strict=True):
        error = scheme.result["contour_error"] * 1e6
        worst = int(np.argmax(np.abs(error)))
        at = int(np.argmax(np.abs(curve.y)))
        assert curve.x[at] == worst * 1e-3 and curve.y[at] == error[worst]


def test_time_starts_where_a_window_of_a_run_starts(single):
    cut = synthetic.with_result(single, single.schemes[0].result.window(500, 900))
    assert error_charts(cut, 100)[0].panels[0].curves[0].x[0] == pytest.approx(0.5)


def test_reversals_and_corners_are_marked(circle, square):
    ticks = error_charts(circle, POINTS)[0].panels[0].ticks
    assert [round(tick.x, 2) for tick in ticks if tick.mark == "reversal"] == [2.0, 2.5, 3.0, 3.5]
    over_time, over_arc = error_charts(square, POINTS)
    times = [tick.x for tick in over_time.panels[0].ticks if tick.mark == "corner"]
    np.testing.assert_allclose(np.diff(times), 0.5, atol=2e-3)
    places = [tick.x for tick in over_arc.panels[0].ticks if tick.mark == "corner"]
    np.testing.assert_allclose(np.diff(places), 20.0)


def test_a_wide_tolerance_does_not_flatten_the_error(circle):
    panel = error_charts(replace(circle, tolerance=1e-3), POINTS)[0].panels[0]
    assert panel.y_range is not None and panel.y_range[1] < 20.0
    assert panel.band == (-1000.0, 1000.0)


def test_polar_plot_shows_the_deviation_in_micrometres(circle):
    chart = polar_charts(circle, 8000)[0]
    for scheme, curve in zip(circle.schemes, chart.curves, strict=True):
        np.testing.assert_allclose(curve.y, scheme.circles[0].deviation * 1e6)
        assert np.all(np.diff(curve.x) > 0.0)
        assert chart.reach[0] < curve.y.min() and curve.y.max() <= chart.reach[1]


def test_rings_are_labelled_with_their_own_value(circle):
    for value, text in polar_charts(circle, POINTS)[0].rings():
        if text:
            assert float(text.removesuffix(" um")) == pytest.approx(value)


def test_circle_table_prints_the_figures(circle):
    table = circle_tables(circle)[0]
    first = dict(table.rows)["circular deviation G, minimum zone"][0]
    assert float(first) == pytest.approx(circle.schemes[0].circles[0].circular_deviation * 1e6, rel=6e-3)


def test_axis_signals_are_in_print_units(circle):
    panels = {panel.y_label: panel for panel in axis_charts(circle, 8000)[0].panels}
    result = circle.schemes[0].result
    reference = next(c for c in panels["velocity [mm/min]"].curves if c.name == "reference")
    np.testing.assert_allclose(reference.y, result["reference_velocity"][:, 0] * 60e3)
    tracking = panels["tracking error [um]"].curves[0]
    np.testing.assert_allclose(tracking.y, result["tracking_error"][:, 0] * 1e6)
    jerk = panels["jerk [m/s^3]"].curves[0].y
    assert np.abs(jerk).max() == pytest.approx(synthetic.RADIUS * (2 * np.pi * synthetic.FREQUENCY) ** 3, rel=1e-3)
    assert {level.value for level in next(panels[label] for label in panels if label.startswith("command [%")).levels} == {100.0, -100.0}


def test_a_distant_limit_is_written_and_not_drawn(circle):
    jerk = next(panel for panel in axis_charts(circle, POINTS)[0].panels if panel.y_label.startswith("jerk"))
    assert jerk.far and jerk.y_range is not None and jerk.y_range[1] < 20.0


def test_a_peak_far_beyond_its_limit_is_written(circle):
    scheme = circle.schemes[0]
    tight = synthetic.machine(("x", "y"), replace(scheme.machine.axes[0].limits, jerk=0.05))
    chart = axis_charts(replace(circle, schemes=(replace(scheme, machine=tight),)), POINTS)[0]
    assert "Jerk" in chart.caption and "outside" in chart.caption


def test_bode_plot_is_the_response(circle):
    magnitude, phase = bode_charts(circle, POINTS)[0].panels
    answer = circle.schemes[0].bode["x"]
    np.testing.assert_allclose(10 ** (magnitude.curves[0].y / 20), np.abs(answer.response))
    np.testing.assert_allclose(np.exp(1j * np.radians(phase.curves[0].y)), answer.response / np.abs(answer.response))


def test_a_vanishing_response_does_not_hide_the_rest(circle):
    scheme = circle.schemes[0]
    answer = scheme.bode["x"]
    response = answer.response.copy()
    response[-1], response[-2] = 0.0, 1e-16
    deep = replace(circle, schemes=(replace(scheme, bode={"x": replace(answer, response=response)}),))
    assert bode_charts(circle, POINTS)[0].panels[0].y_range is None
    low, high = bode_charts(deep, POINTS)[0].panels[0].y_range
    assert 0.0 < high < 20.0 and low == pytest.approx(-120.0, abs=20.0)


def test_a_blended_path_is_compared_with_the_programmed_one(single):
    reference = replace(uniform(contour("circle", radius=0.02), 0.5, 1, 1e-3), programmed=contour("circle", radius=0.02001))
    data = synthetic.around(single, reference.path, reference, offset=0.0)
    assert data.is_blended
    chart = path_charts(data, POINTS)[0]
    assert [line.name for line in chart.lines] == ["programmed path", "planned path"]
    np.testing.assert_allclose(np.linalg.norm(chart.runs[0].error, axis=1), 10.0, rtol=1e-6)
    panel = error_charts(data, POINTS)[0].panels[0]
    assert panel.y_label == "part error [um]"
    np.testing.assert_allclose(np.abs(panel.curves[0].y), 10.0, rtol=1e-6)
    rows = {row.label: row.cells[0].text for row in compare(data).rows}
    assert rows["part error, largest"] == rows["planning deviation, largest"] == "10"


def test_a_run_without_extras_has_fewer_pictures(square):
    assert polar_charts(square, POINTS) == () and bode_charts(square, POINTS) == ()
    labels = [panel.y_label for panel in axis_charts(square, POINTS)[0].panels]
    assert labels == ["tracking error [um]", "velocity [mm/min]", "acceleration [m/s^2]", "jerk [m/s^3]"]


def test_an_unjudged_run_is_refused(single):
    result = single.schemes[0].result
    bare = replace(result, signals={k: v for k, v in result.signals.items() if k != "contour_error"})
    with pytest.raises(ResultError, match="contour_error"):
        error_charts(synthetic.with_result(single, bare), POINTS)
