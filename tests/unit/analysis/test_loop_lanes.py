"""Margins of many loops at once, against the exact margins of each."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from contourlab.analysis.linear.sampled_loop import AxisLanes, LaneLoops, lane_loops, margin_factors, sampled_loop, unstable_by
from contourlab.analysis.linear.tick_map import proved_stable
from contourlab.components.drive.saturation import DelayedSaturation
from contourlab.loop.parameters import with_values
from contourlab.papers.ghaffari.setup import TABLE_3, Reading, controller, machine
from contourlab.study import Space
from contourlab.study.guards import Bounds, Guards

N = 40
GAIN = 20.0 * math.log10(1.5)


def candidates(delay: float = 0.0) -> tuple:
    reading = Reading()
    stage, made = machine(2, reading), controller(2, TABLE_3, reading)
    if delay:
        axes = tuple(replace(a, drive=DelayedSaturation(delay=delay)) if a.name == "2" else a for a in stage.axes)
        stage = replace(stage, axes=axes)
    space = Space.chosen(stage, made)
    points = np.random.default_rng(3).uniform(0.1, 0.8, (N, len(space.numbers)))
    return stage, made, space.columns(points)


@pytest.mark.parametrize("delay", [0.0, 2e-3])
def test_lanes_agree_with_the_margins_of_each_loop(delay: float) -> None:
    stage, made, columns = candidates(delay)
    mine = {name: values for name, values in columns.items() if ".axes.2." in name}
    loops = lane_loops(stage.axis("2"), made.axes["2"], stage.servo_period, 0.0, mine)
    bounds = Bounds(GAIN, 25.0)
    kept = unstable_by(loops, margin_factors(1.5, math.radians(25.0))) < 0.0
    radius = loops.radius(1.0)
    for i in range(N):
        _, one = with_values(stage, made, {name: float(values[i]) for name, values in mine.items()})
        exact = sampled_loop(stage.axis("2"), one.axes["2"], stage.servo_period)
        assert radius[i] == pytest.approx(np.abs(exact.poles).max(), abs=1e-6)
        assert kept[i] == (not bounds.broken(exact.margins()))
    assert 0 < kept.sum() < N


def test_a_proof_of_stability_agrees_with_the_poles() -> None:
    """Of loops on both sides of the limit, and of matrices whose powers grow far before they fall, or whose radius is close to 1."""
    stage, made, columns = candidates(2e-3)
    mine = {name: values for name, values in columns.items() if ".axes.2." in name}
    loops = lane_loops(stage.axis("2"), made.axes["2"], stage.servo_period, 0.0, mine)
    for gain, phase in ((1.0, 0.0), (1.2, 10.0), (1.5, 25.0)):
        factors = margin_factors(gain, math.radians(phase))
        radius = np.max([loops.radius(factor) for factor in factors], axis=0)
        excess = unstable_by(loops, factors)
        assert np.array_equal(excess < 0.0, radius < 1.0) and np.array_equal(excess[radius >= 1.0], radius[radius >= 1.0] - 1.0)
        assert 0 < (excess == -1.0).sum() < N
    huge = LaneLoops(np.stack([loops.a[0], 1e200 * loops.a[0], loops.a[0]]), loops.b[:3], loops.c[:3])
    assert unstable_by(huge, (1.0,))[1] > 1.0 and np.array_equal(
        unstable_by(huge, (1.0,))[[0, 2]] < 0.0, huge[np.array([0, 2])].radius(1.0) < 1.0
    )
    rng = np.random.default_rng(5)
    radius = 1.0 + np.array([*-np.geomspace(1e-12, 0.5, 100), *np.geomspace(1e-12, 0.5, 100)])
    turned = np.linalg.qr(rng.normal(size=(200, 6, 6)))[0]
    upper = np.triu(rng.normal(size=(200, 6, 6)) * 10.0 ** rng.uniform(-2.0, 5.0, (200, 1, 1)), 1) + radius[:, None, None] * np.diag(
        [1.0] + [0.4] * 5
    )
    for scale in (1.0, 1j):
        proved = proved_stable(scale * (turned @ upper @ np.swapaxes(turned, 1, 2)))
        assert not proved[100:].any() and proved[:100].sum() > 10


def test_a_prepared_loop_gives_the_bits_of_a_new_one() -> None:
    """Whatever it was asked before: other values, another number of them, other parameters, a longer delay."""
    stage, made, columns = candidates(2e-3)
    place = stage.axis("2"), made.axes["2"], stage.servo_period, 0.0
    prepared = AxisLanes(*place)
    gains = {name: values for name, values in columns.items() if ".axes.2.controller." in name}
    some = {name: values[:7] for name, values in gains.items()}
    turned = {name: values[::-1] for name, values in gains.items()}
    delays = {"axes.2.drive.delay": np.linspace(1e-3, 9e-3, N)}
    for asked in (gains, turned, some, columns, gains, delays, {name: 0.5 * values for name, values in delays.items()}, turned):
        one, other = prepared(asked), lane_loops(*place, asked)
        assert all(np.array_equal(getattr(one, name), getattr(other, name)) for name in "abc")
    assert not np.array_equal(prepared(gains).a, prepared(turned).a)


def test_a_guard_checks_all_axes_and_caches_the_result() -> None:
    stage, made, columns = candidates()
    guard, known = Guards(stage, made, Bounds(GAIN, 25.0)), {}
    excess = guard.excess(columns, known)
    assert not guard.unknown and len(known) == 2
    assert np.array_equal(guard.excess(columns, known), excess)
    assert np.array_equal(guard.excess({name: values[5:6] for name, values in columns.items()}), excess[5:6])
    for i in range(0, N, 8):
        _, one = with_values(stage, made, {name: float(values[i]) for name, values in columns.items()})
        met = [not guard.bounds.broken(sampled_loop(axis, one.axes[axis.name], stage.servo_period).margins()) for axis in stage.axes]
        assert all(met) == (excess[i] < 0.0)


def test_a_matrix_far_from_normal_is_not_proved_stable() -> None:
    """Its pole lies at 1.0452, by its trace and determinant; rounding of its powers hides it."""
    matrix = np.array([[102309.63137341579, 125900.85066966839], [-83138.07001791247, -102308.58617881237]])
    assert not proved_stable(matrix[None]).any()
    rng = np.random.default_rng(1)
    for skew in (1e2, 1e4, 1e6):
        poles = rng.uniform(0.9, 1.05, (200, 2))
        turn = np.array([[1.0, 1.0 / skew], [-skew, 1.0]])
        matrices = np.array([turn @ np.diag(pole) @ np.linalg.inv(turn) for pole in poles])
        assert not (proved_stable(matrices) & (poles.max(axis=1) > 1.001)).any()
