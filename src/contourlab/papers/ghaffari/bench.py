"""Ghaffari & Ulsoy, section III: measurements with the position loop open, repeated on the simulated axes."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import Component
from contourlab.components.controller.position import PositionController
from contourlab.components.disturbance.loads import TableLoad
from contourlab.components.friction.laws import NoFriction
from contourlab.components.ideal import IdealSensor
from contourlab.engine.runner import make_group
from contourlab.geometry import Line, Path
from contourlab.loop.machine import Axis, AxisController, Controller, Limits, Machine
from contourlab.loop.simulate import jit_enabled
from contourlab.loop.template import build
from contourlab.papers.ghaffari.setup import AXES, TABLE_3, Gains, Reading, axis, axis_controller
from contourlab.papers.rows import INPUT, Row, derived, identity, printed

PERIOD = Reading().servo_period
_PER_MM = 1e3


def bench_rows() -> Iterator[Row]:
    """Yield the rows on the open-loop comparison, stiction, and the sampled observer."""
    return chain(_comparison(), _stiction(), _observer())


def run_bench(
    axes: Sequence[Axis], controllers: Mapping[str, AxisController], period: float, derivative: int, values: Array, signals: tuple[str, str]
) -> tuple[Array, Array]:
    """Run axes side by side, tick by tick; return two signals (n, n_axis).

    Parameters
    ----------
    axes, controllers
    period : float [s]
    derivative : int
        Derivative of the reference that receives `values` on all axes; the others are 0.
    values : ndarray (n,)
    signals : (str, str)
    """
    n = len(axes)
    path = Path([Line(np.zeros(n), np.ones(n))])
    loop = build(Machine("bench", tuple(axes), period), Controller(dict(controllers)), path, np.zeros(n))
    fed = np.zeros((len(values), 3 * n + 2))
    fed[:, derivative * n : (derivative + 1) * n] = values[:, None]
    rows = [loop.schedule.row(signal) for name in signals for signal in loop.signals[name]]
    log = make_group(loop.schedule, 1, slice(0, 1), jit_enabled()).run(fed, rows)[:, :, 0]
    return log[:, :n], log[:, n:]


def drive_open_loop(
    command: Array, *, friction: bool = False, observed: Mapping[int, Gains] | None = None, load: Component | None = None
) -> tuple[Array, Array]:
    """Run all three axes side by side with the position loop open.

    Parameters
    ----------
    command : ndarray (n,) [full scale]
        Command of each axis, before its observer.
    friction : bool
        Include the stiction of section III.
    observed : mapping of int to Gains, optional
        Table of the observers; by default no observers.
    load : Component, optional
        Disturbance on every axis.

    Returns
    -------
    position, velocity : ndarray (n, 3) [m], [m/s]
        Values before the command of the same row acts.
    """
    axes, controllers = [], {}
    for number in AXES:
        plain = replace(axis(number, Reading()), sensor=IdealSensor(), limits=Limits(following_error=math.inf), disturbance=load)
        axes.append(plain if friction else replace(plain, friction=NoFriction()))
        # With a model gain of 1 and no other gains, the command is the acceleration of the reference.
        observer = axis_controller(observed[number], Reading()).observer if observed else None
        controllers[str(number)] = AxisController(PositionController(model_gain=1.0), observer=observer)
    return run_bench(axes, controllers, PERIOD, 2, command, ("axis_position", "axis_velocity"))


def _comparison() -> Iterator[Row]:
    """Yield rows on the step responses of axes 1 and 2 without friction."""
    step = 0.1
    _, velocity = drive_open_loop(np.full(4000, step))
    steady = velocity[-1] / step
    time = [rise_time(column / column[-1]) for column in velocity.T]
    faster, larger = 100.0 * (time[1] / time[0] - 1.0), 100.0 * (steady[0] / steady[1] - 1.0)
    note = "time to 63 % after a command step"
    yield derived("response of axis 1 faster than axis 2", "open loop", 55.0, faster, "%", 0.5, note)
    note = "steady velocity after a command step; the paper rounds to tens"
    yield derived("DC gain of axis 1 larger than axis 2", "open loop", 70.0, larger, "%", 5.0, note)


def rise_time(response: Array) -> float:
    """Return the time [s] at which a step response first passes 1 - 1/e, interpolated linearly."""
    level = 1.0 - math.exp(-1.0)
    k = int(np.argmax(response >= level))
    return PERIOD * (k - float((response[k] - level) / (response[k] - response[k - 1])))


def _stiction() -> Iterator[Row]:
    rate = 0.019  # per second; chosen so that no stiction is a whole number of steps
    command = rate * PERIOD * np.arange(6000.0)
    position, _ = drive_open_loop(command, friction=True)
    moved = np.argmax(position != 0.0, axis=0)
    for column, (number, percent) in enumerate(((1, 5.5), (2, 8.8), (3, 7.7))):
        # The command one tick before the first motion.
        here = 100.0 * float(command[moved[column] - 1])
        note = "slow command ramp, as in Fig 5(a): the command at which the axis first moves"
        yield printed("stiction", f"axis {number}", percent, here, "% of full scale", 0.05, note, kind=INPUT)


def _observer() -> Iterator[Row]:
    """Yield rows on the sampled observer: steady gains of command and load, and attenuation of a slow load."""
    ticks, step, rate = 4000, 0.1, 0.05
    duration, still = ticks * PERIOD, np.zeros(ticks)
    wd = Reading().bandwidth
    lengthened = wd * PERIOD / -math.expm1(-wd * PERIOD)
    steady, rising = (TableLoad(time_step=duration, forces=values) for values in ((step, step), (0.0, rate * duration)))
    driven = drive_open_loop(np.full(ticks, step), observed=TABLE_3)[1][-1] / step * _PER_MM
    loaded = drive_open_loop(still, observed=TABLE_3, load=steady)[1][-1] / step * _PER_MM
    slow = drive_open_loop(still, observed=TABLE_3, load=rising)[1][-1] / rate * _PER_MM
    for column, (number, gains) in enumerate(TABLE_3.items()):
        case, ratio = f"axis {number}, Table III", gains.observer_gain / gains.observer_damping
        note = "a_hat/b_hat for any plant; velocity 4 s after a command step"
        yield identity("DC gain u_c to v", case, ratio, float(driven[column]), "mm/s/full_scale", 1e-6 * ratio, note)
        note = "velocity 4 s after a load step"
        yield identity("DC gain d to v", case, 0.0, abs(float(loaded[column])), "mm/s/full_scale", 1e-6 * ratio, note)
        note = f"a_hat/(b_hat w_d); with a period of 1 ms, T/(1 - exp(-w_d T)) replaces 1/w_d: {lengthened:.4f} times as much"
        level, name = ratio / wd, "attenuation of disturbance, sampled"
        yield derived(name, case, level, float(slow[column]), "mm/full_scale", 1e-3 * level, note)
