"""Linear interpolation in Shahin, ElMaraghy & ElBeheiry: a ramp whose slope is the feedrate."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cache

import numpy as np

from contourlab.feed import AxisLimits, Reference, plan, route_from_path
from contourlab.geometry import Line, Path
from contourlab.loop import simulate
from contourlab.papers.rows import Row, derived, ours
from contourlab.papers.shahin import setup as setup
from contourlab.papers.shahin.setup import Setting

LENGTH, ACCELERATION = 0.2, 2.0
"""Of the ramp [m], and of its run-up [m/s^2]."""
STEADY = (0.5, 1.4)
"""Time of the steady motion that is looked at [s]."""


@cache
def _ramp(period: float) -> Reference:
    """Return a straight motion of x at the feedrate, run up to at a steady acceleration; y stands."""
    limits = AxisLimits([1.0, 1.0], [ACCELERATION, ACCELERATION], [math.inf, math.inf])
    return plan(route_from_path(Path([Line((0.0, 0.0), (LENGTH, 0.0))]), setup.FEED), limits, period)


def _largest(name: str, setting: Setting) -> tuple[float, float]:
    """Return the largest error [m] and deviation of the feedrate [m/s] of the load of x in the steady part of the ramp."""
    period = setup.SERVO_PERIOD
    controller = setup.baseline() if name == "PI" else setup.scheme(name, setting)
    signals = ("axis_position", "axis_velocity", "reference")
    run = simulate(setup.machine(setting, period), controller, _ramp(period), signals=signals)
    steady = slice(*(round(time / period) for time in STEADY))
    error = np.abs(run["axis_position"] - run["reference"])[steady, 0].max()
    return float(error), float(np.abs(run["axis_velocity"][steady, 0] - setup.FEED).max())


def ramp_rows() -> Iterator[Row]:
    """Yield the rows of ramps: the largest error and the ripple of the steady motion."""
    lag, _ = _largest("PI", Setting(gap=0.0))
    yield derived("PI error on a ramp", "without backlash: f/K_v", 946.3, lag * 1e6, "um", 0.5, "the lag of a cascade; K_v is pinned by it")
    for name in ("PI", *setup.SCHEMES):
        error, ripple = _largest(name, Setting(start_in_gap=0.0))
        case = "total gap 25 um, motors in mid-gap at the start"
        yield ours(f"{name} error on a ramp", case, error * 1e6, "um", "0.5 to 1.4 s after a run-up at 2 m/s^2")
        yield ours(f"{name} feed ripple on a ramp", case, ripple * 60.0, "m/min", "a lossless load goes on to and fro in its gap")
