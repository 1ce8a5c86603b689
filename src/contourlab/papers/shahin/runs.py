"""Runs of the feed drives of Shahin, ElMaraghy & ElBeheiry, reduced to the figures that the paper gives while they run."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from functools import cache

import numpy as np
from numpy.typing import NDArray

from contourlab.feed import Reference
from contourlab.loop import Controller, Machine, simulate_blocks
from contourlab.papers.shahin import setup as setup

Array = NDArray[np.float64]
WINDOW = (1.0, 10.0)
"""Time that the paper looks at [s]."""
SIGNALS = ("axis_position", "axis_velocity", "reference", "reference_velocity", "active_controller")


@dataclass
class Figures:
    """What is seen of a run from 1 s on.

    Attributes
    ----------
    axis_error : ndarray (n_axis,) [m]
        Largest distance of the load from its reference, axis by axis.
    contour_error : float [m]
        Largest distance from the circle.
    feed_ripple : float [m/s]
        Largest deviation of the overall feedrate from that asked for.
    axis_feed_error : float [m/s]
        Largest deviation of an axis' feedrate.
    switches : int
        How often a controller was switched, all axes together.
    diverged : float [s]
        When the following error passed its limit; infinite where it did not.
    """

    axis_error: Array = field(default_factory=lambda: np.zeros(2))
    contour_error: float = 0.0
    feed_ripple: float = 0.0
    axis_feed_error: float = 0.0
    switches: int = 0
    diverged: float = math.inf

    @property
    def largest(self) -> float:
        """Largest axis error [m]; infinite where the run diverged."""
        return float(self.axis_error.max()) if math.isinf(self.diverged) else math.inf

    def take(self, block: dict[str, Array], first: int, feed: float) -> None:
        """Take in a block, from sample `first` of it on."""
        part = {name: data[first:] for name, data in block.items()}
        if not len(part["reference"]):
            return
        self.axis_error = np.maximum(self.axis_error, np.abs(part["axis_position"] - part["reference"]).max(axis=0))
        radius = np.hypot(*part["axis_position"].T)
        self.contour_error = max(self.contour_error, float(np.abs(radius - setup.RADIUS).max()))
        speed = np.hypot(*part["axis_velocity"].T)
        self.feed_ripple = max(self.feed_ripple, float(np.abs(speed - feed).max()))
        apart = np.abs(part["axis_velocity"] - part["reference_velocity"]).max()
        self.axis_feed_error = max(self.axis_feed_error, float(apart))
        if "active_controller" in part:
            self.switches += int(np.count_nonzero(np.diff(part["active_controller"], axis=0)))


def measured(machine: Machine, controller: Controller, reference: Reference, feed: float = setup.FEED, until: float = WINDOW[1]) -> Figures:
    """Run a machine along a reference, from a moving start, and return its figures from 1 s to `until` [s]."""
    found, done, period = Figures(), 0, machine.servo_period
    supervised = any(part.supervisor is not None for part in controller.axes.values())
    signals = SIGNALS if supervised else SIGNALS[:-1]
    for block, status in simulate_blocks(machine, controller, reference, signals=signals, moving=True):
        last = min(len(block["reference"]), max(0, round(until / period) - done))
        found.take({name: data[:last] for name, data in block.items()}, max(0, round(WINDOW[0] / period) - done), feed)
        done += len(block["reference"])
        if not status.ok:
            found.diverged = status.sample * period
    return found


def controller_of(name: str, setting: setup.Setting) -> Controller:
    """Return a scheme, or a baseline: "PI", "PI with feedforward", "PI on the load"."""
    baselines = {
        "PI": setup.baseline(),
        "PI with feedforward": setup.baseline(forward=True),
        "PI on the load": setup.baseline(feedback="load"),
    }
    return baselines[name] if name in baselines else setup.scheme(name, setting)


def prepare(tests: Sequence[tuple[str, setup.Setting, float, float]]) -> None:
    """Run circular tests on all processors, so that `circular` has them; the machine code is made by the first one."""
    if tests:
        circular(*tests[0])
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        list(pool.map(lambda test: circular(*test), dict.fromkeys(tests)))


def circular(name: str, setting: setup.Setting, feed: float = setup.FEED, until: float = WINDOW[1]) -> Figures:
    """Return the figures of the circular test under a controller as of `controller_of`, from 1 s to `until` [s]; each is run once."""
    return _circular(name, setting, feed, until)


@cache
def _circular(name: str, setting: setup.Setting, feed: float, until: float) -> Figures:
    period = setup.servo_period(feed)
    laps = max(1, math.ceil(until * feed / (2.0 * math.pi * setup.RADIUS)))
    return measured(setup.machine(setting, period), controller_of(name, setting), setup.circle(laps, period, feed), feed, until)
