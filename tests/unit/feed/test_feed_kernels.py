"""The recursions of the feed planner against closed forms, linear programming, and plain Python."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import linprog

from contourlab.feed import AxisLimits, blending, kernels
from contourlab.feed.bounds import Samples, piece_bounds
from contourlab.geometry import contour
from contourlab.native.kernel import Kernel

LIMIT = np.array([2.0, 3.0])
JERK = np.array([40.0, 40.0])


def samples(n: int, name: str = "ellipse") -> tuple[np.ndarray, ...]:
    path = contour(name)
    s = np.linspace(0.0, path.length * (1 - 1e-12), n)
    _, t, k, c = (np.ascontiguousarray(part) for part in path.derivatives(s, 3))
    return s, t, k, c


def run_reach(run, place, parts, ceiling, memory=None, period=0.0):
    n = place[0].size
    ceiling = ceiling.copy()
    ceiling[[0, -1]] = 0.0
    memory = memory or (*(np.full(n, np.nan) for _ in range(4)), np.zeros(n, np.int64))
    before = memory[3].copy()
    run(*place, *parts, np.full(n, 0.3), ceiling, LIMIT, JERK, period, *memory)
    *_, square, flags = memory
    np.testing.assert_array_equal(flags & kernels.MOVED != 0, square != before)
    return memory


def test_a_line_follows_the_law_of_constant_acceleration() -> None:
    s = np.sort(np.append(np.random.default_rng(1).uniform(0.0, 0.3, 80), [0.0, 0.15, 0.3]))
    tangent = np.tile([1.0, 0.0], (s.size, 1))
    none, one = np.zeros_like(tangent), np.ones_like(s)
    *_, square, _ = run_reach(kernels.reach, (s, tangent, none, none), (one, one), np.full(s.size, 0.7))
    np.testing.assert_allclose(square, np.minimum(np.minimum(4.0 * s, 4.0 * (0.3 - s)), 0.49), atol=1e-12)


def test_the_limits_hold_and_a_linear_program_finds_nothing_faster() -> None:
    # In v^2 the limits are linear. The program may trade the speed of one sample for another's, a pass cannot: a small gap is left.
    place, n = samples(60), 60
    s, t, k, _ = place
    # Where an axis is momentarily at rest, its centripetal acceleration limits the speed, which belongs to the ceiling.
    still = np.where(np.abs(t) < 1e-6, np.abs(k), 1e-9)
    ceiling = np.minimum(0.35, np.sqrt((LIMIT / still).min(axis=1)))
    *_, square, _ = run_reach(kernels.reach, place, (np.ones(n), np.ones(n)), ceiling)
    rows, bounds = [], []
    for i in range(n - 1):
        for at in (i, i + 1):
            for axis in range(2):
                row = np.zeros(n)
                slope = t[at, axis] / (2.0 * (s[i + 1] - s[i]))
                row[i + 1] += slope
                row[i] -= slope
                row[at] += k[at, axis]
                rows += [row, -row]
                bounds += [LIMIT[axis], LIMIT[axis]]
    box = [(0.0, 0.0 if i in (0, n - 1) else ceiling[i] ** 2) for i in range(n)]
    assert np.all(np.array(rows) @ square <= np.array(bounds) * (1 + 1e-12))
    found = linprog(-np.ones(n), A_ub=np.array(rows), b_ub=bounds, bounds=box)
    assert square.sum() <= found.x.sum() * (1 + 1e-9)
    assert square.sum() == pytest.approx(found.x.sum(), rel=2e-3)


@pytest.mark.parametrize("period", [0.0, 0.02])
def test_a_change_of_limits_equals_a_fresh_start(period: float) -> None:
    place, n = samples(400, "butterfly"), 400
    generator = np.random.default_rng(5)
    run = kernels.reach
    turning, speeding, ceiling = np.ones(n), np.ones(n), np.full(n, 0.2)
    memory = run_reach(run, place, (turning, speeding), ceiling, period=period)
    for _ in range(20):
        at = generator.integers(0, n - 9)
        turning[at : at + 5] *= 0.8
        speeding[at + 2 : at + 8] *= 0.7
        memory[4][at : at + 8] |= kernels.LOWERED
        ceiling[generator.integers(0, n)] *= 0.5
        run_reach(run, place, (turning, speeding), ceiling, memory, period)
        assert np.all(memory[4][at : at + 8] & kernels.LOWERED)
        memory[4][:] = 0
        *_, fresh, _ = run_reach(run, place, (turning, speeding), ceiling, period=period)
        np.testing.assert_array_equal(memory[3], fresh)


def test_machine_code_and_plain_python_agree() -> None:
    place, n = samples(120, "butterfly"), 120
    parts, ceiling = (np.ones(n), np.ones(n)), np.full(n, 0.2)
    plain = run_reach(kernels.reach.plain, place, parts, ceiling, period=0.02)[3]
    np.testing.assert_allclose(run_reach(kernels.reach, place, parts, ceiling, period=0.02)[3], plain, rtol=1e-9, atol=1e-15)


def test_spread_takes_the_least_value_in_reach() -> None:
    generator = np.random.default_rng(2)
    s, value = np.sort(generator.uniform(0.0, 1.0, 300)), generator.uniform(0.1, 1.0, 300)
    found = np.empty_like(s)
    kernels.spread(s, value, 0.05, found, np.empty(300, np.int64))

    def least(at: int) -> float:
        lowest = value[at]
        for way in (range(at - 1, -1, -1), range(at + 1, 300)):
            passed = value[at]
            for i in way:  # values behind a smaller one do not count
                if value[i] < passed and abs(s[i] - s[at]) <= 0.05 * value[i]:
                    lowest = min(lowest, value[i])
                passed = min(passed, value[i])
        return float(lowest)

    np.testing.assert_array_equal(found, [least(i) for i in range(300)])
    assert np.count_nonzero(found < value) > 200


def test_a_speed_peak_is_cut_to_its_minimum_duration() -> None:
    # A triangle of 1 m/s over 2 m: at the level w it is 2 (1 - w) wide, which takes 0.5 s if 2 (1 - w) = 0.5 w.
    s = np.linspace(0.0, 2.0, 201)
    ceiling = np.full_like(s, 5.0)
    kernels.flatten(s, 1.0 - np.abs(s - 1.0), 0.5, ceiling)
    assert ceiling.min() == pytest.approx(0.8, rel=1e-9)
    np.testing.assert_allclose(s[ceiling < 5.0][[0, -1]], [0.8, 1.2], atol=0.011)


def test_overlapping_faults_lower_the_limits_once() -> None:
    s = np.linspace(0.0, 1.0, 11)
    faults = np.zeros((2, 7))
    faults[:, :3] = [[4, 0.46, 0.1], [6, 0.66, 0.1]]  # sample, place, speed
    factors = np.array([[1.0, 0.8], [0.9, 0.9], [1.0, 1.0]])
    low, parts, flags = np.ones(11), np.ones((3, 11)), np.zeros(11, np.int64)
    kernels.lower(s, faults, factors, 1.5, 2.0, low, parts, flags)
    np.testing.assert_allclose(parts[0], [1, 1, 1, 1, 1, 0.64, 0.64, 0.64, 0.64, 0.64, 1])
    np.testing.assert_allclose(parts[1], [1, 1, 1, 0.81, 0.81, 0.81, 0.81, 0.81, 0.81, 0.81, 1])
    np.testing.assert_array_equal(parts[2], np.ones(11))
    np.testing.assert_array_equal(flags & kernels.LOWERED != 0, (parts[:2] < 1.0).any(axis=0))
    np.testing.assert_array_equal(low, np.ones(11))


def test_derivatives_between_samples_are_those_of_a_cubic() -> None:
    bend = np.poly1d([1.3, -2.0, 0.7, 0.2])
    ends, here = np.array([0.2, 0.9]), np.zeros((3, 1, 1))
    k, c = bend(ends)[:, None], bend.deriv()(ends)[:, None]
    for part in (0.1, 0.5, 0.8):
        kernels._between(np.zeros((2, 1)), k, c, 0, 0.7, part, here)
        assert here[1, 0, 0] == pytest.approx(bend(0.2 + 0.7 * part), rel=1e-12)
        assert here[2, 0, 0] == pytest.approx(bend.deriv()(0.2 + 0.7 * part), rel=1e-12)


def test_a_block_has_whole_steps_and_keeps_its_length() -> None:
    s = np.linspace(0.0, 0.3, 60)
    square = np.minimum(np.minimum(4.0 * s, 4.0 * (0.3 - s)), 0.04)
    first, last, free = np.array([0, 20, 41]), np.array([20, 41, 59]), np.array([0, 0, 1])
    time, lasting, count = np.empty(60), np.empty(3), np.empty(3, np.int64)
    kernels.clock(s, square, first, last, free, 0.01, time, lasting, count)
    np.testing.assert_allclose(lasting[:2], count[:2] * 0.01, rtol=1e-15)
    mean = np.zeros(int(count.sum()))
    kernels.steps(s, square, time, first, last, lasting, np.cumsum(count) - count, count, 0.01, mean)
    assert mean.sum() * 0.01 == pytest.approx(0.3, rel=1e-12)
    assert mean.max() <= 0.2 * (1 + 1e-12)
    # 0.3 m at 0.2 m/s with two ramps at 2 m/s^2 takes 1.6 s; each of the first blocks takes up to one step more.
    assert 1.6 <= lasting.sum() < 1.6 + 0.02 + 0.01


@pytest.mark.parametrize("jerk", [40.0, np.inf])
def test_the_bounds_of_pieces_keep_the_limits_at_every_sample_and_speed(jerk: float) -> None:
    _, t, k, c = samples(600, "butterfly")
    k[:100], c[:100] = 0.0, 0.0  # straight pieces too
    starts = np.arange(0, 600, 20)
    limits = AxisLimits(np.array([0.5, 0.4]), LIMIT, np.full(2, jerk))
    given = Samples(t, k, c, np.full(600, 0.3))
    stops = np.random.default_rng(1).random((starts.size, 2)) < 0.3
    found = piece_bounds(given, starts, np.full(starts.size, 0.01), stops, limits)
    V, A, rise, taper = (np.repeat(part, 20) for part in found)
    assert (V <= 0.3).all() and (np.abs(t) * V[:, None] <= limits.velocity * (1 + 1e-12)).all()
    for v in np.linspace(0.0, 1.0, 50)[:, None] * V:
        with np.errstate(invalid="ignore"):
            tangential = np.minimum(A, np.sqrt(2.0 * taper * np.maximum(V - v, 0.0)))
        tangential = np.where(np.isnan(tangential), A, tangential)  # an infinite taper at the top speed
        assert (np.abs(t) * tangential[:, None] + np.abs(k) * v[:, None] ** 2 <= LIMIT * (1 + 1e-9)).all()
    if np.isfinite(jerk):
        assert (np.abs(t) * rise[:, None] + 3 * np.abs(k) * (V * A)[:, None] + np.abs(c) * V[:, None] ** 3 <= jerk * (1 + 1e-9)).all()


@pytest.mark.parametrize("mark", [blending.mark_starts, blending.mark_chains])
def test_runs_of_lines_in_machine_code_and_in_plain_python_agree(mark: Kernel) -> None:
    generator = np.random.default_rng(4)
    turned = np.cumsum(generator.normal(0.0, 0.02, 400))
    points = np.cumsum(np.column_stack([np.cos(turned), np.sin(turned)]), axis=0)
    linked = generator.random(399) < 0.9
    fast = blending.run_starts(points, np.full(399, 0.02), linked, mark)
    np.testing.assert_array_equal(fast, blending.run_starts(points, np.full(399, 0.02), linked, mark.plain))
    assert 40 < fast.size < 300
