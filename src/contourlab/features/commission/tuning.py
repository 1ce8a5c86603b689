"""Gains of HAL's ``pid`` that follow given commands best: placed poles, then a search over all of them, as in ``tune``."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ParameterError, refuse
from contourlab.features.commission.loop import GAINS, ROBUST, AxisModel, Law, Runs, keep_margins, run_lanes
from contourlab.features.commission.records import restless
from contourlab.study.search import restarted

UNSEEN = 1.0
"""Delay in periods, beyond that of the model, with which the margins must hold: a log of slow motion does not show the current loop."""
BUDGET = 1400
"""Sets of gains that a search tries."""
TIE = 0.05
"""Weight of the rms error beside the largest."""
ROUGH = 0.1
"""Largest rms step of the output from noise, as a share of the largest output; beyond it the noise is heard in the motor."""
GROWTH = 0.5
"""Logarithm of the growth of a velocity that `AxisTask.most_ahead` allows."""
OFF = 0.2
"""Weight of the error at switching on with a larger gain of the axis."""
Moves: TypeAlias = Sequence[tuple[Array, Array]]
"""Commands and positions (n,) [m]."""
BOX = {"bandwidth": (0.003, 0.6), "damping": (0.3, 3.0), "integral": (1e-5, 0.3), "ff1": (0.6, 1.4), "ff2": (0.0, 3.0)}
"""Ranges: bandwidth times period, damping ratio, integral rate over bandwidth, and factors of the nominal feedforward."""


@dataclass(frozen=True, eq=False)
class AxisTask:
    """Commands of an axis to follow.

    Attributes
    ----------
    model : AxisModel
    law : Law
    pairs : sequence of (ndarray (n,) [m], ndarray (n,) [m])
        Commands with the noise of the encoder.
    off : sequence of ndarray (n,) [m]
        Noise of further runs that begin with `free` samples in which LinuxCNC is off, and then hold; a pid that is always enabled drifts.
    free : int
    always_enabled : bool
        While LinuxCNC is off the pid then feeds measured acceleration back; the loop must bear that with a larger gain too.
    gain_margin, phase_margin : float [dB, deg]
    """

    model: AxisModel
    law: Law
    pairs: Moves
    off: Sequence[Array] = ()
    free: int = 0
    always_enabled: bool = False
    gain_margin: float = 6.0
    phase_margin: float = 30.0

    @property
    def box(self) -> dict[str, tuple[float, float]]:
        """The ranges of the search."""
        most = 0.0 if self.model.share else 0.85 / max(ROBUST)  # fed back late, acceleration drives a resonance
        return BOX | ({"ff2": (0.0, most)} if self.always_enabled else {})

    def largest(self, gains: Array, factor: float = 1.0) -> float:
        """Return the largest error [m] of one set of gains; `factor` scales the gain of the axis."""
        scaled = self.model.scaled(factor)
        worst = max(float(run_lanes(*pair, gains[None], [scaled], self.law).largest[0]) for pair in self.pairs)
        return max(worst, float(self.switched_on(gains[None], scaled)[0]))

    def switched_on(self, gains: Array, model: AxisModel) -> Array:
        """Return the largest error (m,) [m] after LinuxCNC is switched on, the mean over the runs."""
        largest = [run_lanes(np.zeros(noise.size), noise, gains, [model], self.law, free=self.free).largest for noise in self.off]
        return np.asarray(np.mean(largest, axis=0)) if largest else np.zeros(len(gains))

    def runs(self, gains: Array) -> Moves:
        """Return commands and positions with one set of gains."""
        return [(command, run.position) for command, run in self.traced(gains)]

    def traced(self, gains: Array) -> Sequence[tuple[Array, Runs]]:
        """Return the commands and their runs with one set of gains."""
        return [(pair[0], run_lanes(*pair, gains[None], [self.model], self.law, trace=True)) for pair in self.pairs]

    def most_ahead(self, ff2: Array) -> Array:
        """Return the largest velocity feedforward (n,) beyond that for the previous target.

        While LinuxCNC is off, feedforward feeds velocity and acceleration back: v grows at the rate (g FF1 - d)/(1 - g FF2), with gain g
        and damping d of the axis. With g a quarter larger, it may grow by a factor of exp(`GROWTH`) until LinuxCNC is switched on.
        """
        if not self.off:
            return np.full(ff2.size, math.inf)
        larger = self.model.scaled(max(ROBUST))
        slower = np.maximum(1.0 - larger.gain * ff2, 0.0) * GROWTH / (self.free * self.law.period)
        return np.asarray((larger.damping + slower) / larger.gain)

    def gains(self, points: Array) -> Array:
        """Return the gains (n, 7) of points (n, 5) in the box from 0 to 1."""
        model, period = self.model, self.law.period
        low, high = np.array(list(self.box.values())).T
        bandwidth, damping, integral = (low[:3] * (high[:3] / low[:3]) ** points[:, :3]).T
        ff1, ff2 = (low[3:] + points[:, 3:] * (high[3:] - low[3:])).T
        w = bandwidth / period
        p = w * np.maximum(w, model.regulated) / model.gain  # slower than the drive's loop, the position loop is of first order
        gains = np.zeros((len(points), len(GAINS)))
        gains[:, 0] = p
        gains[:, 1] = p * w * integral
        gains[:, 2] = np.maximum(2.0 * damping * w - model.damping, 0.0) / model.gain
        held = p * period if self.law.previous_target else np.zeros(len(points))
        gains[:, 4] = np.minimum(ff1 * (model.per_speed + held), held + self.most_ahead(ff2 / model.gain))
        gains[:, 5] = ff2 / model.gain
        return gains


def shared_delay(axes: Sequence[Moves], period: float) -> float:
    """Return the delay [s] of the positions behind their commands that all axes share; one axis alone shares none.

    Parameters
    ----------
    axes : sequence of Moves
    period : float [s]
    """
    delays = []
    for runs in axes:
        speed = np.concatenate([np.gradient(command) / period for command, _ in runs])
        delays.append(float(speed @ np.concatenate([command - position for command, position in runs])) / max(float(speed @ speed), 1e-30))
    return max(min(delays), 0.0) if len(delays) > 1 else 0.0


def largest_error(runs: Moves, delay: float, period: float) -> float:
    """Return the largest distance [m] of positions from commands that come later by a delay [s]."""
    late = (np.interp(np.arange(command.size) - delay / period, np.arange(command.size), command) for command, _ in runs)
    return max(float(np.abs(command - position).max()) for command, (_, position) in zip(late, runs, strict=True))


@dataclass(frozen=True, eq=False)
class TunedAxis:
    """Tuned gains of an axis.

    Attributes
    ----------
    gains : ndarray (7,)
        In the order of `loop.GAINS`, per metre.
    largest : float [m]
        Largest error on the commands.
    spread : float [m]
        The same at worst with the gain of the axis a quarter off.
    """

    gains: Array
    largest: float
    spread: float


def tune_axis(task: AxisTask, *, unit: float = 1e-3, seed: int = 0) -> TunedAxis:
    """Return the gains with the smallest largest error that keep the margins.

    Parameters
    ----------
    task : AxisTask
    unit : float [m]
        Machine unit, in which the gains are rounded.
    seed : int

    Raises
    ------
    ParameterError
        If no gains keep the margins.
    """
    moves = [(command, noise, restless(command, task.law.period)) for command, noise in task.pairs]
    lively = [(command[kept], noise[kept]) for command, noise, kept in moves]
    larger, slower = task.model.scaled(max(ROBUST)), replace(task.model, delay=max(task.model.delay, 0.0) + UNSEEN * task.law.period)

    def objective(points: Array) -> Array:
        gains = task.gains(points)
        good = keep_margins(gains, slower, task.law.period, task.gain_margin, task.phase_margin)
        values = np.full(len(points), np.inf)
        if not good.any():
            return values
        rms, excess = np.zeros((2, int(good.sum())))
        worst = np.maximum(task.switched_on(gains[good], task.model), OFF * task.switched_on(gains[good], larger))
        for command, noise in lively:
            runs = run_lanes(command, noise, gains[good], [task.model], task.law)
            worst, rms = np.maximum(worst, runs.largest), np.maximum(rms, runs.rms)
            bound = ROUGH * np.maximum(runs.output, 1e-12)
            excess = np.maximum(excess, np.maximum(runs.rough / bound - 1.0, 0.0) + 10.0 * runs.limited)
        values[good] = (worst + TIE * rms) * (1.0 + excess)
        return values

    point = restarted(objective, _placed(objective)[None], BUDGET, seed).point
    gains = np.array([float(f"{unit * gain:.4g}") / unit for gain in task.gains(point[None])[0]])
    largest = {factor: task.largest(gains, factor) for factor in ROBUST}
    return TunedAxis(gains, largest[1.0], max(largest.values()))


def _placed(objective: Callable[[Array], Array]) -> Array:
    """Return the best of well damped poles from slow to fast, with nominal feedforward."""
    speeds = np.linspace(0.02, 0.98, 96)
    points = np.column_stack([speeds, *(np.full(speeds.size, share) for share in (0.55, 0.3, 0.5, 1.0 / 3.0))])
    points = np.vstack([points, points * [1.0, 1.2, 1.0, 1.0, 1.0]])
    values = objective(points)
    best = int(np.argmin(values))
    refuse(not math.isfinite(values[best]), ParameterError, "margins", "no gains found", "smaller margins: a delayed axis cannot keep them")
    return np.asarray(points[best])
