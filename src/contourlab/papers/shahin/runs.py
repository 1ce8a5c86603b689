"""Runs of Shahin, ElMaraghy & ElBeheiry: figures of circular tests, traces for pictures, ramps."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.feed import AxisLimits, Reference, plan, route_from_path
from contourlab.geometry import Line, Path
from contourlab.loop import Controller, Machine, simulate, simulate_blocks
from contourlab.metrics.figures import summarise
from contourlab.metrics.judge import judge
from contourlab.papers.shahin import setup
from contourlab.papers.shahin.setup import Setting
from contourlab.scenario import load_scenario
from contourlab.threads import in_threads

WINDOW = (1.0, 10.0)
"""Time window that the paper evaluates [s]."""
SIGNALS = ("axis_position", "axis_velocity", "reference", "reference_velocity")
STRIDE = 100
"""Samples of 2 us between points of a picture: sixty points per period of the shaft."""
LENGTH, ACCELERATION = 0.2, 2.0
"""Length of the ramp [m] and acceleration of its run-up [m/s^2]."""
STEADY = (0.5, 1.4)
"""Time of the ramp's steady motion [s]."""


@dataclass
class Figures:
    """Figures of a run, from 1 s on.

    Attributes
    ----------
    axis_error : ndarray (n_axis,) [m]
        Largest distance of the load from its reference.
    contour_error : float [m]
        Largest distance from the circle.
    feed_ripple, axis_feed_error : float [m/s]
        Largest deviation of the feedrate along the path, and of an axis velocity.
    switches : int
        Controller switches of all axes.
    diverged : float [s]
        Time at which the following error exceeds its limit; infinite if it never does.
    """

    axis_error: Array = field(default_factory=lambda: np.zeros(2))
    contour_error: float = 0.0
    feed_ripple: float = 0.0
    axis_feed_error: float = 0.0
    switches: int = 0
    diverged: float = math.inf

    @property
    def largest(self) -> float:
        """Largest axis error [m]; infinite if the run diverged."""
        return float(self.axis_error.max()) if math.isinf(self.diverged) else math.inf

    def take(self, block: dict[str, Array], feed: float) -> None:
        """Add a block of samples."""
        if not len(block["reference"]):
            return
        self.axis_error = np.maximum(self.axis_error, np.abs(block["axis_position"] - block["reference"]).max(axis=0))
        radius = np.hypot(*block["axis_position"].T)
        self.contour_error = max(self.contour_error, float(np.abs(radius - setup.RADIUS).max()))
        speed = np.hypot(*block["axis_velocity"].T)
        self.feed_ripple = max(self.feed_ripple, float(np.abs(speed - feed).max()))
        difference = np.abs(block["axis_velocity"] - block["reference_velocity"]).max()
        self.axis_feed_error = max(self.axis_feed_error, float(difference))
        if "active_controller" in block:
            self.switches += int(np.count_nonzero(np.diff(block["active_controller"], axis=0)))


def measured(machine: Machine, controller: Controller, reference: Reference, feed: float = setup.FEED, until: float = WINDOW[1]) -> Figures:
    """Simulate from a moving start and return the figures from 1 s to `until` [s]."""
    figures, done, period = Figures(), 0, machine.servo_period
    supervised = any(part.supervisor is not None for part in controller.axes.values())
    signals = (*SIGNALS, "active_controller") if supervised else SIGNALS
    for block, status in simulate_blocks(machine, controller, reference, signals=signals, moving=True):
        count = len(block["reference"])
        window = slice(*(min(count, max(0, round(time / period) - done)) for time in (WINDOW[0], until)))
        figures.take({name: data[window] for name, data in block.items()}, feed)
        done += count
        if not status.ok:
            figures.diverged = status.sample * period
    return figures


def controller_of(name: str, setting: Setting) -> Controller:
    """Return a scheme, alone or as in `setup.COUPLED`, or a baseline: "PI", "PI with feedforward", "PI on the load"."""
    baselines: dict[str, dict[str, Any]] = {"PI": {}, "PI with feedforward": {"forward": True}, "PI on the load": {"feedback": "load"}}
    if name in baselines:
        return setup.baseline(**baselines[name])
    return setup.scheme(name, setting) if name in setup.SCHEMES else setup.coupled(name.split()[0], setting)


def prepare(tests: Sequence[tuple[Any, ...]]) -> None:
    """Run circular tests in parallel to fill the cache of `circular`; the first test compiles."""
    circular(*tests[0])
    in_threads(lambda test: circular(*test), dict.fromkeys(tests))


@cache
def circular(name: str, setting: Setting, feed: float = setup.FEED, until: float = WINDOW[1]) -> Figures:
    """Return the figures of a circular test from 1 s to `until` [s]; `name` as in `controller_of`."""
    period = setup.servo_period(feed)
    laps = max(1, math.ceil(until * feed / (2.0 * math.pi * setup.RADIUS)))
    return measured(setup.machine(setting, period), controller_of(name, setting), setup.circle(laps, period, feed), feed, until)


def part_error(scheme: str) -> tuple[float, float]:
    """Return the part error [m], rms and largest, of a scheme of the shipped part on a machine with backlash."""
    case = load_scenario("builtin:backlash/part").case(scheme)
    reference = case.reference()
    found = summarise(judge(simulate(case.machine, case.controller, reference), reference), reference).part_error
    return found.rms, found.max


def third_lap(name: str, setting: Setting) -> dict[str, Array]:
    """Return `SIGNALS` and the time [s] of the third lap of a circular test, for pictures; `name` as in `controller_of`."""
    period = setup.servo_period()
    reference = setup.circle(3, period)
    run = simulate(setup.machine(setting, period), controller_of(name, setting), reference, signals=SIGNALS, moving=True)
    start, stop = reference.laps[-1]
    return {"time": period * np.arange(start, stop, STRIDE, dtype=np.float64)} | {name: run[name][start:stop:STRIDE] for name in SIGNALS}


@cache
def _ramp() -> Reference:
    """Return a straight motion of x at the feedrate after a run-up at constant acceleration; y is at rest."""
    limits = AxisLimits([1.0, 1.0], [ACCELERATION, ACCELERATION], [math.inf, math.inf])
    return plan(route_from_path(Path([Line((0.0, 0.0), (LENGTH, 0.0))]), setup.FEED), limits, setup.SERVO_PERIOD)


def ramp(name: str, setting: Setting) -> tuple[float, float]:
    """Return the largest error [m] and feedrate deviation [m/s] of the x load in the ramp's steady part; `name` as in `controller_of`."""
    machine = setup.machine(setting, setup.SERVO_PERIOD)
    run = simulate(machine, controller_of(name, setting), _ramp(), signals=("axis_position", "axis_velocity", "reference"))
    steady = slice(*(round(time / setup.SERVO_PERIOD) for time in STEADY))
    error = np.abs(run["axis_position"] - run["reference"])[steady, 0].max()
    return float(error), float(np.abs(run["axis_velocity"][steady, 0] - setup.FEED).max())
