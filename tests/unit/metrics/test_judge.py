"""The judge on positions with closed-form errors."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from made_runs import circle_laps, made_run, samples_on

from contourlab.errors import ResultError
from contourlab.geometry import Arc, Line, Path, contour
from contourlab.metrics.figures import summarise
from contourlab.metrics.judge import furthest, judge, reach

ROUND = 1e-15  # positions of some 0.1 m have a last digit of 1.4e-17 m


@pytest.mark.parametrize("clockwise", [0.0, 1.0])
def test_circle_run_off_centre(clockwise: float) -> None:
    """The tool's circle is shifted by c: the distance is |p - 0| - R; left of a counter-clockwise travel is inside."""
    reference = circle_laps(720, clockwise=clockwise)
    shift = np.array([1.3e-4, -0.7e-4])
    tool = reference.block(0, 720).position + shift
    judged = judge(made_run(reference, tool), reference)
    outward = np.linalg.norm(tool, axis=1) - 0.02
    inside = -outward if clockwise == 0.0 else outward
    assert np.abs(judged["contour_error"] - inside).max() < ROUND
    # Law of cosines: |p| of the shifted circle at the angle between spoke and shift.
    angle = (1.0 if clockwise == 0.0 else -1.0) * 2.0 * np.pi * np.arange(720) / 720 - math.atan2(*shift[::-1])
    e = math.hypot(*shift)
    law = np.sqrt(0.02**2 + e**2 + 2.0 * 0.02 * e * np.cos(angle)) - 0.02
    assert np.abs(outward - law).max() < 1e-14
    assert np.abs(judged["tracking_error"] + shift).max() < ROUND


def test_ellipse_run_as_a_circle() -> None:
    """On a tool circle of radius R around an ellipse's centre: R - b on the short axis, a - R on the long one,
    and in between the distance from the foot point equation."""
    a, b, radius = 0.030, 0.0298, 0.0299
    path = contour("ellipse", a=a, b=b)
    along = np.linspace(0.0, path.length, 400, endpoint=False)
    foot = path.position(along)
    # Points made from their feet: p = foot + d * (unit normal to the left), with any d well inside the evolute.
    d = 1e-4 * np.sin(3.0 * 2.0 * np.pi * along / path.length)
    tool = foot + d[:, None] * path.normal(along)
    judged = judge(made_run(samples_on(path, along), tool), samples_on(path, along))
    assert np.abs(judged["contour_error"] - d).max() < ROUND
    assert np.abs(judged["foot_arc_length"] - along).max() < 1e-11
    quarter = np.arange(4) * path.length / 4.0
    tool = radius * np.array([[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]])
    judged = judge(made_run(samples_on(path, quarter), tool), samples_on(path, quarter))
    # Counter-clockwise, left is inside: a point outside is negative.
    assert np.abs(judged["contour_error"] - [a - radius, b - radius, a - radius, b - radius]).max() < 1e-14


def test_circle_run_as_an_ellipse() -> None:
    """Servo mismatch turns a circle into an ellipse; its distance from the circle is exactly |p| - R."""
    reference = circle_laps(500)
    u = 2.0 * np.pi * np.arange(500) / 500
    a, b = 0.0201, 0.01985
    judged = judge(made_run(reference, np.column_stack([a * np.cos(u), b * np.sin(u)])), reference)
    law = 0.02 - np.sqrt((a * np.cos(u)) ** 2 + (b * np.sin(u)) ** 2)
    assert np.abs(judged["contour_error"] - law).max() < ROUND


def test_lag_along_a_line_is_no_contour_error() -> None:
    path = Path([Line((0.0, 0.0), (0.4, 0.3))])
    along = np.linspace(0.05, 0.4, 200)
    reference = samples_on(path, along)
    left = np.array([-0.6, 0.8])
    tool = path.position(along - 2e-3) + 5e-6 * left
    judged = judge(made_run(reference, tool), reference)
    assert np.abs(judged["contour_error"] - 5e-6).max() < ROUND
    assert np.abs(np.linalg.norm(judged["tracking_error"], axis=1) - math.hypot(2e-3, 5e-6)).max() < 1e-14
    assert np.abs(judged["foot_arc_length"] - (along - 2e-3)).max() < 1e-14


def test_beyond_the_ends_of_an_open_path_the_distance_is_to_the_end() -> None:
    path = Path([Line((0.0, 0.0), (0.1, 0.0))])
    reference = samples_on(path, np.array([0.0, 0.1]))
    judged = judge(made_run(reference, np.array([[-3e-4, 4e-4], [0.1 + 3e-4, -4e-4]])), reference)
    assert judged["contour_error"] == pytest.approx([5e-4, -5e-4], abs=1e-16)
    assert np.array_equal(judged["foot_arc_length"], [0.0, 0.1])


def test_branch_at_the_self_intersection() -> None:
    """Where the lemniscate crosses itself at right angles, progress decides the branch, not distance."""
    path = contour("lemniscate", a=0.04)
    half = 0.5 * path.length
    near = np.linspace(-4e-3, 4e-3, 81)
    for centre in (half, path.length):
        along = centre + near
        d = 2e-4
        # The lag carries the tool over the other branch while the reference is already past the crossing.
        tool = path.position(along - 1e-3) + d * path.normal(along - 1e-3)
        judged = judge(made_run(samples_on(path, along), tool), samples_on(path, along))
        assert np.abs(judged["foot_arc_length"] - (along - 1e-3)).max() < 1e-11
        assert np.abs(judged["contour_error"] - d).max() < ROUND


@pytest.mark.parametrize("turn", [1.0, -1.0])
def test_a_corner_cut_and_overshot(turn: float) -> None:
    """A right-angled corner: cutting it gives an inward error, equal to the shorter leg; overshooting gives an outward one."""
    corner = Path([Line((0.0, 0.0), (0.1, 0.0)), Line((0.1, 0.0), (0.1, 0.1 * turn))])
    cut = np.array([[0.1 - 3e-4, 2e-4 * turn], [0.1 - 1e-4, 2e-4 * turn]])
    over = np.array([[0.1 + 3e-4, -4e-4 * turn], [0.1 + 3e-4, 1e-3 * turn]])
    reference = samples_on(corner, np.array([0.1, 0.1, 0.1, 0.1 + 1e-3]))
    judged = judge(made_run(reference, np.concatenate([cut, over])), reference)
    assert judged["contour_error"] == pytest.approx(turn * np.array([2e-4, 1e-4, -5e-4, -3e-4]), abs=1e-15)


def test_two_passes_over_one_point_are_kept_apart() -> None:
    """There and back on one line: the side changes with the direction of travel."""
    path = Path([Line((0.0, 0.0), (0.1, 0.0)), Line((0.1, 0.0), (0.0, 0.0))])
    reference = samples_on(path, np.array([0.05, 0.15]))
    judged = judge(made_run(reference, np.array([[0.05, 1e-5], [0.05, 1e-5]])), reference)
    assert judged["contour_error"] == pytest.approx([1e-5, -1e-5], abs=1e-17)
    assert judged["foot_arc_length"] == pytest.approx([0.05, 0.15])


def test_laps_are_counted_in_the_foot_point() -> None:
    reference = circle_laps(200, laps=3)
    tool = reference.block(0, 600).position * (1.0 - 1e-3)
    judged = judge(made_run(reference, tool), reference)
    assert np.abs(judged["foot_arc_length"] - judged["arc_length"]).max() < 1e-12
    assert np.abs(judged["contour_error"] - 2e-5).max() < ROUND


def test_in_space_the_error_is_a_distance() -> None:
    helix = Path([Arc((0.0, 0.0, 0.0), 0.02, 0.0, 4.0 * math.pi, rise=(0.0, 0.0, 0.01))])
    along = np.linspace(0.1 * helix.length, 0.9 * helix.length, 100)
    inward = helix.normal(along)
    reference = samples_on(helix, along)
    for side in (1.0, -1.0):
        judged = judge(made_run(reference, helix.position(along) + side * 3e-5 * inward), reference)
        assert np.abs(judged["contour_error"] - 3e-5).max() < 1e-14
        assert np.array_equal(judged["contour_error"], judged["part_error"])


@pytest.mark.parametrize("turn", [1.0, -1.0])
def test_rounded_corner_has_a_planning_deviation(turn: float) -> None:
    """Fillet of radius r in a right angle: inwards r (1 - cos alpha) from the lines, at most r (1 - cos 45 deg)."""
    r = 2e-3
    programmed = Path([Line((0.0, 0.0), (0.1, 0.0)), Line((0.1, 0.0), (0.1, 0.1 * turn))])
    fillet = Arc((0.1 - r, r * turn), r, -turn * math.pi / 2, turn * math.pi / 2)
    planned = Path([Line((0.0, 0.0), (0.1 - r, 0.0)), fillet, Line((0.1, r * turn), (0.1, 0.1 * turn))])
    swept = np.linspace(0.0, math.pi / 2, 101)
    along = 0.1 - r + r * swept
    reference = samples_on(planned, along, programmed)
    off = 7e-5
    tool = planned.position(along) - turn * off * planned.normal(along)  # outwards
    judged = judge(made_run(reference, tool), reference)
    deviation = r * (1.0 - np.cos(np.minimum(swept, math.pi / 2 - swept)))
    assert np.abs(judged["planning_deviation"] - turn * deviation).max() < 1e-14
    assert np.abs(judged["contour_error"] + turn * off).max() < 1e-14
    # The tool runs at radius r + off about the fillet's centre: the same law with that radius.
    to_line = (r + off) * np.cos(np.minimum(swept, math.pi / 2 - swept)) - r
    assert np.abs(judged["part_error"] + turn * to_line).max() < 1e-14


def test_reach_holds_the_foot_of_any_tracking_error() -> None:
    straight, ring = Path([Line((0.0, 0.0), (1.0, 0.0))]), contour("circle", radius=0.02)
    tracking = np.array([[3e-3, 4e-3], [0.0, 0.0]])
    assert reach(straight, furthest(tracking)) >= 2.0 * 5e-3
    assert reach(ring, 100.0 * furthest(tracking)) == pytest.approx(math.pi * 0.02)
    assert reach(straight, 0.0) > 0.0


def test_a_reference_far_ahead_does_not_lose_the_foot() -> None:
    """A lag of a tenth of a lap on a circle: the foot lags as much as the tool."""
    reference = circle_laps(400, laps=2)
    asked = reference.block(0, 800)
    lag = 0.1 * reference.path.length
    tool = reference.path.position(asked.arc_length - lag) * 1.001
    judged = judge(made_run(reference, tool), reference)
    assert np.abs(judged["foot_arc_length"] - (asked.arc_length - lag)).max() < 1e-12
    assert np.abs(judged["contour_error"] + 2e-5).max() < ROUND


@pytest.mark.parametrize(
    ("name", "row", "words"),
    [
        ("tool_position", (7, 1), "tool_position.* y .*finite.*sample 7"),
        ("reference", (3, 0), "reference.* x .*finite.*sample 3"),
        ("arc_length", (9,), "arc_length.*finite.*sample 9"),
    ],
)
@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_a_non_finite_sample_is_reported_by_name(name: str, row: tuple[int, ...], words: str, bad: float) -> None:
    reference = circle_laps(50)
    result = made_run(reference, reference.block(0, 50).position)
    data = np.array(result[name])
    data[row] = bad
    signal = type(result.signals[name])(data, result.signals[name].dims, "m")
    with pytest.raises(ResultError, match=words):
        judge(result.with_signals(**{name: signal}), reference)


def test_axes_other_than_those_of_the_path() -> None:
    ring, line = circle_laps(50), Path([Line((0.0, 0.0, 0.0), (1.0, 0.0, 0.0))])
    result = made_run(ring, ring.block(0, 50).position)
    with pytest.raises(ResultError, match=r"axes x, y .*3 coordinates"):
        judge(result, samples_on(line, np.linspace(0.0, 1.0, 50)))


def test_a_result_of_another_reference_is_refused() -> None:
    ring, half = circle_laps(50), samples_on(Path([Line((0.0, 0.0), (1.0, 0.0))]), np.linspace(0.0, 1.0, 50))
    result = replace(made_run(ring, ring.block(0, 50).position), attributes={"reference_digest": ring.digest})
    judge(result, ring)
    with pytest.raises(ResultError):
        judge(result, half)


def test_a_missing_signal_is_reported_by_name() -> None:
    ring = circle_laps(50)
    result = made_run(ring, ring.block(0, 50).position)
    bare = type(result)("bare", result.axes, result.servo_period, {"reference": result.signals["reference"]})
    with pytest.raises(ResultError, match=r"'tool_position'.* bare.* reference$"):
        judge(bare, ring)


@pytest.mark.parametrize("name", ["tool_position", "reference", "arc_length", "axis_position"])
def test_positions_in_another_unit_are_refused(name: str) -> None:
    reference = circle_laps(8)
    run = made_run(reference, reference.block(0, 8).position)
    run = run.with_signals(axis_position=run.signals["tool_position"])
    judge(run, reference)
    with pytest.raises(ResultError, match=f"{name}.*mm"):
        judge(run.with_signals(**{name: replace(run.signals[name], unit="mm")}), reference)


def test_the_figures_are_those_of_the_own_reference() -> None:
    own, other = circle_laps(100), circle_laps(99)
    run = replace(made_run(own, own.block(0, 100).position), attributes={"reference_digest": own.digest})
    summarise(judge(run, own), own)
    with pytest.raises(ResultError, match="another reference"):
        summarise(judge(run, own), other)
