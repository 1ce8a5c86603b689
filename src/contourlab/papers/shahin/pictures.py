"""Shahin, ElMaraghy & ElBeheiry: what Figs 7 to 13 are drawn from."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from contourlab.loop import simulate
from contourlab.papers.shahin import setup as setup
from contourlab.papers.shahin.runs import controller_of
from contourlab.papers.shahin.setup import Setting

Array = NDArray[np.float64]
STRIDE = 100
"""Samples of 2 us from one point of a picture to the next: sixty in a period of the shaft."""
SIGNALS = ("axis_position", "axis_velocity", "reference", "reference_velocity")


@dataclass(frozen=True, eq=False)
class Trace:
    """The third lap of a circular test.

    Attributes
    ----------
    time : ndarray (n,) [s]
        From the start of the run.
    angle : ndarray (n,) [rad]
        Of the loads around the centre, in [0, 2 pi).
    radial : ndarray (n,) [m]
        Deviation from the radius.
    axis_error, axis_feed_error : ndarray (n, 2) [m], [m/s]
        Reference less load, axis by axis, and of their velocities.
    feedrate : ndarray (n,) [m/s]
        Overall.
    """

    time: Array
    angle: Array
    radial: Array
    axis_error: Array
    axis_feed_error: Array
    feedrate: Array


@cache
def trace(name: str, setting: Setting) -> Trace:
    """Return the third lap under a scheme or a baseline, as named in `contourlab.papers.shahin.runs.circular`."""
    period = setup.servo_period()
    reference = setup.circle(3, period)
    run = simulate(setup.machine(setting, period), controller_of(name, setting), reference, signals=SIGNALS, moving=True)
    start, stop = reference.laps[-1]
    part = {name: run[name][start:stop:STRIDE] for name in SIGNALS}
    x, y = part["axis_position"].T
    return Trace(
        time=period * np.arange(start, stop, STRIDE, dtype=np.float64),
        angle=np.mod(np.arctan2(y, x), 2.0 * np.pi),
        radial=np.hypot(x, y) - setup.RADIUS,
        axis_error=part["reference"] - part["axis_position"],
        axis_feed_error=part["reference_velocity"] - part["axis_velocity"],
        feedrate=np.hypot(*part["axis_velocity"].T),
    )
