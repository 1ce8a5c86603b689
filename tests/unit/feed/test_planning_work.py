"""What planning depends on, and how much it computes: stretches between stops are planned alone, and the work grows with the lines."""

from __future__ import annotations

from dataclasses import replace
from threading import Lock
from typing import Any

import numpy as np
import pytest

from contourlab.feed import AxisLimits, Route, blended, kernels, smooth
from contourlab.feed.planner import plan_profile
from contourlab.geometry import Path
from contourlab.geometry.line_and_arc import Line

LIMITS = AxisLimits(0.2, 1.5, 40.0)


def relief(n: int, offset: float = 0.0) -> Route:
    """Return n lines of 0.25 mm over waves, 100 in a row, with a stop after each row; every line ends in a rounded corner."""
    k = np.arange(n + 1)
    x, row = 0.25e-3 * np.abs((k + 100) % 200 - 100), 0.25e-3 * (k // 100)
    z = 0.6e-3 * np.sin(350.0 * x) * np.cos(270.0 * row) + 0.25e-3 * np.sin(900.0 * x + 400.0 * row)
    points = np.round(np.column_stack([x, row, z]), 7) + offset
    stops = np.arange(1, n + 1) % 100 == 0
    path = Path(Line.many(points[:-1], points[1:]))
    return Route(path, np.full(n, 0.05), np.zeros(n, bool), np.zeros(n), np.zeros(n), corner_tolerance=5e-6, exact_stop=stops)


def rows(route: Route, first: int, after: int) -> Route:
    """Return some lines of a route."""
    part = slice(first, after)
    given = {name: getattr(route, name)[part] for name in ("feedrate", "rapid", "dwell", "source_line", "corner_tolerance", "exact_stop")}
    return replace(route, path=Path(route.path.curves[part]), programmed=None, merge_tolerance=0.0, **given)


def duration(route: Route) -> float:
    return plan_profile(blended(route, LIMITS), LIMITS).duration


@pytest.mark.parametrize(("n", "within"), [(200, 1e-12), (600, 1e-3)])  # a longer program tries fewer averaging times
def test_parts_between_stops_take_the_time_of_the_whole(n: int, within: float) -> None:
    whole = relief(n)
    parts = [duration(rows(whole, first, first + 100)) for first in range(0, n, 100)]
    assert duration(whole) == pytest.approx(sum(parts), rel=within)


def test_a_moved_program_takes_the_same_time() -> None:
    assert duration(relief(200, 0.125)) == pytest.approx(duration(relief(200)), rel=1e-6)


@pytest.fixture
def work(monkeypatch: pytest.MonkeyPatch) -> dict[str, int]:
    """How many samples are checked, and at how many places the path is evaluated for a check."""
    counts = {"demand": 0, "needed": 0}
    demand, needed, alone = kernels.demand, kernels.needed, Lock()  # several planners run at a time

    def counted(*given: Any) -> None:
        with alone:
            counts["demand"] += int(given[13].sum())  # `watched`
        demand(*given)

    def evaluated(*given: Any) -> None:
        with alone:
            counts["needed"] += given[1].size
        needed(*given)

    monkeypatch.setattr(kernels, "demand", counted)
    monkeypatch.setattr(kernels, "needed", evaluated)
    return counts


def test_the_work_grows_with_the_lines(work: dict[str, int]) -> None:
    found = []
    for n in (400, 1600):
        work.update(demand=0, needed=0)
        duration(relief(n))
        found.append(dict(work))
    for name in work:
        assert found[0][name] > 0
        assert found[1][name] < 4.4 * found[0][name]


def test_only_what_has_changed_is_checked_again_with_the_same_result(work: dict[str, int], monkeypatch: pytest.MonkeyPatch) -> None:
    route = blended(relief(800), LIMITS)
    monkeypatch.setattr(smooth, "PER_SPAN", 4)  # so coarse that one check on the path is not enough
    short, least = plan_profile(route, LIMITS), dict(work)
    monkeypatch.setattr(smooth._Planner, "changed", lambda planner, faults: np.ones_like(planner.flags))
    work.update(demand=0, needed=0)
    whole = plan_profile(route, LIMITS)
    for name in ("t0", "s0", "v0", "a0", "j"):
        np.testing.assert_array_equal(getattr(short, name), getattr(whole, name))
    assert all(least[name] < 0.6 * work[name] for name in work)


def test_the_path_is_checked_in_each_interval_however_short() -> None:
    """A span may pass a hundred short curves: places even in time would miss the jerk of one."""
    for seed in range(50):
        rng = np.random.default_rng(seed)
        arc_length = np.cumsum(np.append(0.0, 10.0 ** rng.uniform(-8.0, -4.0, 60)) * (rng.uniform(size=61) > 0.1))
        bent, parts = rng.integers(0, 2, arc_length.size), np.array([6, 4])
        T, v = 0.2, np.concatenate([[0.0], rng.uniform(0.0, 1.0, 4), [0.0]])
        v *= arc_length[-1] / (v.sum() * T)
        start = np.append(0.0, np.cumsum(0.5 * (v[1:] + v[:-1]) * T))
        spans = np.column_stack([np.full(5, T), start[:-1], v[:-1], np.diff(v) / T, np.zeros(5)])
        at, reached, found = np.array([0, 0, 37]), np.zeros(1), []
        of, (time, place) = np.empty(37, dtype=np.int64), np.empty((2, 37))
        while at[2] == 37:
            kernels.walk(arc_length, kernels.STALE | (1 - bent) * kernels.STRAIGHT, spans, parts, at, reached, of, time, place)
            found.append(np.column_stack([of, time, place])[: at[2]])
        span, time_in, places = np.concatenate(found).T
        assert np.all(np.diff(span * T + time_in) <= T / 6 * 1.001)
        step = np.append(np.diff(arc_length), np.inf) / np.where(bent, 4, 1)
        for i in np.flatnonzero((step[:-1] > 0.0) & (bent[:-1] > 0)):
            inside = places[(places > arc_length[i] - 0.3 * step[i]) & (places < arc_length[i + 1] + 0.3 * step[i])]
            edges = np.append(np.append(arc_length[i], inside), arc_length[i + 1])
            assert np.diff(np.sort(edges)).max() <= 1.5 * step[i]
