"""Runs along rounded paths: places on the programmed path, and the compiled judge with micron blends between metre-long lines."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from made_runs import PERIOD, Array, made_run, samples_on
from test_streaming_judge import streamed

from contourlab.feed import Reference, Route, blended
from contourlab.geometry import Arc, Line, Path
from contourlab.metrics.circles import circles_of
from contourlab.metrics.figures import left_out
from contourlab.metrics.judge import judge


def rounded(curves: list[Any], tolerance: float, closed: bool = False) -> Route:
    return blended(Route(Path(curves, closed), 0.05, False, 0.0, 0, corner_tolerance=tolerance))


def staircase(n: int, size: float) -> list[Any]:
    steps = np.zeros((n, 2))
    steps[np.arange(n), np.arange(n) % 2] = size
    points = np.concatenate([np.zeros((1, 2)), np.cumsum(steps, axis=0)])
    return Line.many(points[:-1], points[1:])


def along_the_plan(route: Route, arc_length: Array) -> Reference:
    return Reference.from_samples(
        route.path.position(arc_length),
        PERIOD,
        route.path,
        arc_length=arc_length,
        programmed=route.programmed,
        correspondence=route.correspondence,
    )


def test_the_compiled_judge_with_micron_blends_between_metre_long_lines() -> None:
    path = rounded(staircase(5, 1.0), 1e-6).path
    assert path.table(1e-11).halvings > 0
    blends = path.breaks[1:-1].reshape(-1, 2)
    along = np.sort(np.concatenate([np.linspace(0.1, 4.9, 97), *(np.linspace(a - 1e-6, b + 1e-6, 60) for a, b in blends)]))
    rng = np.random.default_rng(4)
    tool = path.position(along) + 1e-8 * rng.normal(size=(len(along), 2))
    exact = judge(made_run(samples_on(path, along), tool), samples_on(path, along))["contour_error"]
    _, error, _ = streamed(path, along, tool)
    np.testing.assert_allclose(error, exact, rtol=0, atol=1.1e-11)
    assert np.abs(exact).max() > 1e-8


@pytest.mark.parametrize("tolerance", [1e-5, 1e-4])
def test_only_the_cut_corners_of_a_rounded_path_are_left_out(tolerance: float) -> None:
    route = rounded(staircase(200, 1e-3), tolerance)
    s = np.linspace(0.0, route.path.length, 20_001)
    reference = along_the_plan(route, s)
    judged = judge(made_run(reference, reference.block(0, len(s)).position), reference)
    longest, at_end = left_out(judged, reference, reference.judged)
    # The middle of a right-angled blend is P off. Its foot jumps from one leg to the other there: sqrt(2) P before and after the corner.
    assert 1.1 * tolerance < longest < np.sqrt(2.0) * tolerance + 1.5 * s[1]
    assert at_end < 1e-9
    # Scaling by total length instead would be off by the sum of all earlier corner cuts.
    assert np.abs(reference.programmed_arc_length(s) - s * (route.programmed.length / s[-1])).max() < 1e-3
    # A tool that stops early leaves out the rest of the programmed path; along a staircase its length is x + y.
    tool = reference.block(0, len(s)).position.copy()
    tool[19_800:] = tool[19_800]
    _, at_end = left_out(judge(made_run(reference, tool), reference), reference, reference.judged)
    assert at_end == pytest.approx(route.programmed.length - tool[-1].sum(), rel=0, abs=2.0 * tolerance)
    off = route.programmed.position(reference.programmed_arc_length(s)) - route.path.position(s)
    assert np.linalg.norm(off, axis=1).max() < 2.0 * tolerance


def test_a_programmed_circle_is_found_after_rounded_corners() -> None:
    lead_in = staircase(40, 1e-3)
    at = lead_in[-1].end
    circle = Arc(at + np.array([0.0, 0.01]), 0.01, -0.5 * np.pi, 2.0 * np.pi)
    route = rounded([*lead_in, circle], 1e-4)
    s = np.linspace(0.0, route.path.length, 8001)
    reference = along_the_plan(route, s)
    (found,) = circles_of(made_run(reference, reference.block(0, 8001).position), reference)
    # An exactly followed reference has no deviation after the blend into the circle.
    assert found.radius == pytest.approx(0.01)
    assert np.abs(found.deviation[200:-10]).max() < 1e-9
    # The whole circle is covered: without the map, earlier corner cuts would remove a third of a radian.
    assert np.ptp(np.unwrap(found.angle)) > 2.0 * np.pi - 0.05


def test_the_work_of_the_judge_grows_with_the_samples(monkeypatch: pytest.MonkeyPatch) -> None:
    from contourlab.geometry import foot_point

    leaves = [0]
    plain = foot_point.searched

    def counted(*arguments: Any) -> int:
        found = plain(*arguments)
        leaves[-1] += found
        return found

    monkeypatch.setattr(foot_point, "searched", counted)
    for n in (100, 200, 400):
        route = rounded(staircase(n, 1e-3), 1e-5)
        s = np.linspace(0.0, route.path.length, 20 * n)
        reference = along_the_plan(route, s)
        leaves.append(0)
        judge(made_run(reference, reference.block(0, len(s)).position), reference)
        assert leaves[-1] < 20 * n * 12
