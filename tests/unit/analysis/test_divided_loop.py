"""Stability of a divided loop: against closed forms, an independent model, the undivided loop gain, and simulation."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from component_rig import make
from scipy.linalg import expm
from scipy.optimize import brentq

import contourlab as cl
from contourlab.analysis.linear.divided_loop import LinkTiming, divided_loop, timing_of
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.components.ideal import IdealLink
from contourlab.components.link.network import Network
from contourlab.errors import ComponentError, ParameterError
from contourlab.feed import AxisLimits, plan, route_from_path
from contourlab.geometry import Line, Path
from contourlab.loop import Division

PERIOD = 1e-3
GAIN, DAMPING = 0.9, 12.0
NONE = LinkTiming()


def axis(name: str = "x") -> cl.Axis:
    return cl.Axis(name, make("plant", "rigid-axis", gain=GAIN, damping=DAMPING))


def servo(observer: bool = True, **gains: float) -> cl.AxisController:
    chosen = {"velocity_gain": 100.0, "position_gain": 4000.0, "integral_gain": 11.8, **gains}
    return cl.AxisController(
        make("controller", "position", **chosen),
        make("velocity", "filtered-difference", bandwidth=800.0),
        make("observer", "disturbance-observer", model_gain=0.6, model_damping=20.0) if observer else None,
    )


def delay_margin(gain: Callable[[Any], Any], top: float) -> float:
    """Return the least delay [s] that brings a stable loop's gain (at frequencies up to `top`) to -1; infinite if none does."""
    w = np.geomspace(1e-4 * top, top, 20_000)
    size = np.log(np.abs(gain(w)))
    places = np.flatnonzero(size[:-1] * size[1:] < 0.0)
    crossings = [brentq(lambda x: math.log(abs(gain(np.array([x]))[0])), w[i], w[i + 1]) for i in places]
    return min((float(np.angle(-gain(np.array([x]))[0])) % (2.0 * math.pi) / x for x in crossings), default=math.inf)


def divided(mine: cl.AxisController, division: str) -> cl.Controller:
    return cl.Controller({"x": replace(mine, link=Division(division, Network(), Network()))})


def single() -> cl.Machine:
    return cl.Machine("one", (axis(),), PERIOD)


@pytest.mark.parametrize("division", ["drive", "observer", "controller"])
def test_with_a_perfect_link_it_is_the_undivided_loop(division: str) -> None:
    loop = divided_loop(single(), divided(servo(), division))
    whole = np.abs(sampled_loop(axis(), servo(), PERIOD).poles).max()
    assert loop.growth(NONE, NONE) == pytest.approx(whole, rel=1e-9)


@pytest.mark.parametrize("division", ["drive", "observer"])
@pytest.mark.parametrize("scale", [0.3, 0.5, 1.0])
def test_whole_ticks_of_delay_are_stable_up_to_the_delay_margin(division: str, scale: float) -> None:
    """The delay margin of the undivided loop, opened at the link, agrees with the poles of the loop with the delay."""
    mine = servo(velocity_gain=100.0 * scale, position_gain=4000.0 * scale)
    controller = divided(mine, division)
    alone = sampled_loop(axis(), mine, PERIOD)

    def local(w: Any) -> Any:
        opened = alone._opened(w)
        return -opened[:, 0, 0] / (1.0 + opened[:, 1, 0])

    margin = delay_margin(local if division == "observer" else alone.loop_gain, alone.nyquist) / PERIOD
    loop = divided_loop(single(), controller)
    assert 1.0 < margin < 60.0
    last = math.floor(margin)
    for ticks in (0, last // 2, last, last + 1, last + 3):
        for down in {0, ticks // 3, ticks}:
            stable = loop.growth(LinkTiming(1, down), LinkTiming(1, ticks - down)) < 1.0
            assert stable == (ticks < margin), (ticks, down)


def test_with_the_controller_in_the_axis_link_delays_do_not_affect_its_loop() -> None:
    controller = divided(servo(), "controller")
    loop = divided_loop(single(), controller)
    assert loop.growth(LinkTiming(7, 30), LinkTiming(3, 20)) == pytest.approx(loop.growth(NONE, NONE), rel=1e-9)


@pytest.mark.parametrize("spacing", [1, 2, 5, 12, 40])
def test_held_messages_act_as_slower_sampling(spacing: int) -> None:
    """Proportional control over messages both ways is the loop sampled at the message period, from a matrix exponential."""
    law = cl.AxisController(make("controller", "position", position_gain=900.0))
    loop = divided_loop(single(), divided(law, "drive"))
    time = spacing * PERIOD
    whole = expm(np.array([[0.0, 1.0, 0.0], [0.0, -DAMPING, GAIN], [0.0, 0.0, 0.0]]) * time)
    closed = whole[:2, :2] - np.outer(whole[:2, 2], [900.0, 0.0])
    expected = np.abs(np.linalg.eigvals(closed)).max() ** (1.0 / spacing)
    timing = LinkTiming(spacing, 0)
    assert loop.growth(timing, timing) == pytest.approx(expected, rel=1e-9)
    # Between two messages the results of the base are unused: slow up and every tick down gives the same.
    assert loop.growth(NONE, timing) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("division", ["drive", "observer"])
@pytest.mark.parametrize("quantity", ["delay", "message_period"])
@pytest.mark.slow
def test_simulation_loses_stability_where_the_model_does(division: str, quantity: str) -> None:
    machine = single()
    controller = divided(servo(), division)
    loop = divided_loop(machine, controller)
    ticks = np.arange(1, 33)
    timings = [LinkTiming(1, int(n)) if quantity == "delay" else LinkTiming(int(n), 0) for n in ticks]
    growth = np.array([loop.growth(t, t) for t in timings])
    route = route_from_path(Path([Line((0.0,), (0.3,))]), 0.1)
    # The axis then rests equally long; by then the transient of the stop has decayed or grown.
    reference = plan(replace(route, dwell=np.array([3.0])), AxisLimits([1.0], [2.0], [50.0]), PERIOD)
    variants = {f"controller.axes.x.link.{way}.{quantity}": ticks * PERIOD for way in ("down", "up")}
    batch = cl.simulate_batch(machine, controller, reference, variants, judge=False, keep=("axis_position",))
    error = np.abs(batch.signals["axis_position"][:, 0] - np.asarray(reference.block(0, reference.n_sample).position))
    n = len(error)
    early, late = error[: n // 2].max(axis=0), error[-100:].max(axis=0)
    broken = (batch.failed_at >= 0) | (late > early)
    clear = np.abs(np.log(growth)) > 1e-3
    assert clear.sum() >= 28 and 0 < broken.sum() < len(ticks)
    assert np.array_equal(broken[clear], growth[clear] > 1.0)


def test_the_modified_reference_goes_over_the_network() -> None:
    """The path's share of the position returns as a reference: stability ends where the delayed lambda T reaches 1."""
    mine = servo()
    axes = {"x": replace(mine, link=Division("controller", Network(), Network()))}
    alone = sampled_loop(axis(), mine, PERIOD)
    for weight in (0.5, 0.95):
        controller = cl.Controller(axes, make("estimator", "tangent"), make("coupling", "modified-reference", weight=weight))
        loop = divided_loop(single(), controller)
        margin = delay_margin(lambda w, part=weight: -part * alone.response(w).modified, alone.nyquist)
        # A gain below 1 everywhere is stable for any delay.
        assert (margin == math.inf) == (weight == 0.5)
        ticks = math.floor(min(margin / PERIOD, 200.0))
        assert loop.growth(NONE, LinkTiming(1, ticks)) < 1.0
        assert (loop.growth(NONE, LinkTiming(1, ticks + 1)) < 1.0) == (margin == math.inf)


def test_with_coupled_axes_the_direction_matters() -> None:
    axes = {name: replace(servo(), link=Division("observer", Network(), Network())) for name in "xy"}
    machine = cl.Machine("two", (axis("x"), axis("y")), PERIOD)
    controller = cl.Controller(axes, make("estimator", "newton"), make("coupling", "modified-reference", weight=0.75))
    alike = [divided_loop(machine, controller, t).growth(LinkTiming(3, 1), NONE) for t in ((1.0, 0.0), (0.0, -2.0), (1.0, 1.0))]
    assert alike[0] == pytest.approx(alike[1], rel=1e-9)
    assert alike[2] == pytest.approx(alike[0], rel=1e-9)  # two equal axes
    slanted = divided_loop(machine, controller, (math.cos(math.pi / 2), 1.0))
    assert slanted.growth(LinkTiming(3, 1), NONE) == pytest.approx(alike[0], rel=1e-9)


def test_a_part_without_timing_or_link_is_refused() -> None:
    assert timing_of(Network(message_period=2.5e-3, delay=1e-3, jitter=1.2e-3), PERIOD) == LinkTiming(3, 3)
    assert timing_of(IdealLink(), PERIOD) == timing_of(None, PERIOD) == NONE
    with pytest.raises(ComponentError, match="hold"):
        timing_of(Network(between="extrapolate"), PERIOD)
    with pytest.raises(ParameterError, match="link"):
        divided_loop(single(), cl.Controller({"x": servo()}))
    with pytest.raises(ParameterError, match="tangent"):
        divided_loop(single(), divided(servo(), "drive"), (0.0,))
    with pytest.raises(ComponentError, match="repeat only"):
        divided_loop(single(), divided(servo(), "drive")).growth(LinkTiming(997, 0), LinkTiming(991, 0))
