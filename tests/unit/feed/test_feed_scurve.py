"""Ramps and moves against their closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

from contourlab.feed.bounds import move_spans, peak_speed, ramp_distance, ramps, reachable_speed


def spans_end(duration: np.ndarray, s0: np.ndarray, v0: np.ndarray, a0: np.ndarray, j: np.ndarray) -> np.ndarray:
    """Return the progress at the end of each span [m]."""
    return s0 + duration * (v0 + duration * (a0 / 2.0 + duration * j / 6.0))


def vec(*values: float) -> np.ndarray:
    return np.array(values, dtype=float)


@pytest.mark.parametrize(
    ("low", "high", "acceleration", "rise", "taper"),
    [
        (0.0, 0.2, 1.0, 50.0, 50.0),  # acceleration reached
        (0.05, 0.06, 1.0, 50.0, 50.0),  # jerk only
        (0.0, 0.2, 1.0, 50.0, 5.0),  # gentle at high speed
        (0.1, 0.3, 2.0, math.inf, math.inf),  # no jerk limit
        (0.0, 0.3, math.inf, 30.0, 30.0),  # no acceleration limit
    ],
)
def test_a_ramp_reaches_its_speed_and_its_distance_is_the_integral(low, high, acceleration, rise, taper):
    ramp = ramps(vec(low), vec(high), vec(acceleration), vec(rise), vec(taper))
    peak, up, hold, down = (float(part[0]) for part in ramp[:4])
    total = up + hold + down
    time = np.linspace(0.0, total, 200_001)
    rising = np.where(up > 0, np.minimum(time / max(up, 1e-300), 1.0), 1.0)
    falling = np.where(down > 0, np.minimum((total - time) / max(down, 1e-300), 1.0), 1.0)
    a = peak * np.minimum(rising, falling)
    v = low + np.concatenate([[0.0], np.cumsum(0.5 * (a[1:] + a[:-1]) * np.diff(time))])
    distance = float(np.sum(0.5 * (v[1:] + v[:-1]) * np.diff(time)))
    assert peak <= acceleration
    assert v[-1] == pytest.approx(high, rel=1e-9)
    assert float(ramp.distance[0]) == pytest.approx(distance, rel=1e-8)
    assert ramp_distance(low, high, acceleration, rise, taper) == pytest.approx(float(ramp.distance[0]), rel=1e-14)


def rest_to_rest(length: float, feed: float, acceleration: float, jerk: float) -> float:
    zero = vec(0.0)
    args = vec(acceleration), vec(jerk), vec(jerk)
    peak = peak_speed(vec(length), zero, zero, vec(feed), *args)
    spans = move_spans(vec(length), zero, peak, zero, *args)
    assert float(spans_end(*spans)[0, -1]) == pytest.approx(length, rel=1e-14)
    return float(spans[0].sum())


def test_rest_to_rest_jerk_only():
    # s = 2 J (T/4)^3
    assert rest_to_rest(1e-3, 10.0, 10.0, 50.0) == pytest.approx(4.0 * (1e-3 / (2.0 * 50.0)) ** (1 / 3), rel=1e-12)


def test_rest_to_rest_acceleration_reached():
    # With tj = A/J and the constant part ta: s = A (tj + ta)(2 tj + ta)
    length, A, J = 0.1, 1.0, 50.0
    tj = A / J
    ta = (-3.0 * tj + math.sqrt(tj**2 + 4.0 * length / A)) / 2.0
    assert rest_to_rest(length, 10.0, A, J) == pytest.approx(4.0 * tj + 2.0 * ta, rel=1e-12)


def test_rest_to_rest_feed_reached():
    length, F, A, J = 0.5, 0.2, 1.0, 50.0
    assert rest_to_rest(length, F, A, J) == pytest.approx(length / F + F / A + A / J, rel=1e-12)


def test_rest_to_rest_feed_reached_without_full_acceleration():
    length, F, A, J = 0.5, 0.01, 1.0, 50.0
    assert rest_to_rest(length, F, A, J) == pytest.approx(length / F + 2.0 * math.sqrt(F / J), rel=1e-12)


def test_rest_to_rest_without_a_jerk_limit():
    assert rest_to_rest(0.1, 10.0, 1.0, math.inf) == pytest.approx(2.0 * math.sqrt(0.1), rel=1e-12)


def test_the_reachable_speed_uses_the_whole_distance():
    shape = (1.5, 40.0, 20.0)
    for low in (0.0, 0.01, 0.1):
        for room in (1e-6, 1e-4, 1e-2):
            high = reachable_speed(low, 5.0, room, *shape)
            used = ramp_distance(low, high, *shape)
            assert used <= room
            assert ramp_distance(low, high * (1 + 1e-9), *shape) > room or high == low


def test_the_reachable_speed_stops_at_the_ceiling():
    assert reachable_speed(0.1, 0.2, 10.0, 1.0, 50.0, 50.0) == 0.2
    assert reachable_speed(0.3, 0.2, 10.0, 1.0, 50.0, 50.0) == 0.3


def test_spans_are_continuous_in_speed_and_acceleration():
    generator = np.random.default_rng(7)
    n = 200
    acceleration, rise = generator.uniform(0.5, 3.0, n), generator.uniform(5.0, 100.0, n)
    taper = rise * generator.uniform(0.1, 1.0, n)
    start, end = generator.uniform(0.0, 0.05, (2, n))
    needed = ramps(np.minimum(start, end), np.maximum(start, end), acceleration, rise, taper).distance
    length = needed + generator.uniform(0.0, 0.05, n)
    peak = peak_speed(length, start, end, np.full(n, 0.2), acceleration, rise, taper)
    duration, s0, v0, a0, j = spans = move_spans(length, start, peak, end, acceleration, rise, taper)
    lasting = duration[:, :-1] > 0
    v_end = v0 + duration * (a0 + 0.5 * duration * j)
    a_end = a0 + duration * j
    assert np.all(duration >= 0)
    np.testing.assert_allclose(spans_end(*spans)[:, :-1], s0[:, 1:], atol=1e-15)
    np.testing.assert_allclose(v_end[:, :-1][lasting], v0[:, 1:][lasting], atol=1e-13)
    np.testing.assert_allclose(a_end[:, [0, 4]], a0[:, [1, 5]], atol=1e-12)
    np.testing.assert_allclose(a_end[:, [2, 6]], 0.0, atol=1e-12)
    np.testing.assert_allclose(v_end[:, -1], end, atol=1e-13)
