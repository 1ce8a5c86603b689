"""Gains of HAL's ``pid`` that follow given commands best: one at a time from placed poles, then all at once, as in ``tune``."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from contourlab.analysis.linear.margins import Margins
from contourlab.arrays import Array
from contourlab.design import search
from contourlab.errors import ParameterError
from contourlab.features.commission.loop import AxisModel, Law, run_lanes
from contourlab.features.commission.stability import ROBUST, keep_margins, loop_margins

UNSEEN = 1.0
"""Delay in periods, beyond that of the model, with which the margins must hold: a log of slow motion does not show the current loop."""
BUDGET, STARTS, PASSES, VALUES = 3000, 3, 2, 33
TIE = 0.05
"""Weight of the rms error beside the largest."""
ROUGH = 0.1
"""Largest rms step of the output from noise, as a share of the largest output; beyond it the noise is heard in the motor."""
BOX = {"bandwidth": (0.003, 0.6), "damping": (0.3, 3.0), "integral": (1e-5, 0.3), "ff1": (0.6, 1.4), "ff2": (0.0, 3.0)}
"""Ranges: bandwidth times period, damping ratio, integral rate over bandwidth, and factors of the nominal feedforward."""


@dataclass(frozen=True, eq=False)
class AxisTask:
    """Commands of an axis to follow.

    Attributes
    ----------
    model : AxisModel
    law : Law
    commands, noises : sequence of ndarray (n,) [m]
    gain_margin, phase_margin : float [dB, deg]
    """

    model: AxisModel
    law: Law
    commands: Sequence[Array]
    noises: Sequence[Array]
    gain_margin: float = 6.0
    phase_margin: float = 30.0

    def largest(self, gains: Array, factor: float = 1.0) -> float:
        """Return the largest error [m] of one set of gains; `factor` scales the gain of the axis."""
        scaled = replace(self.model, gain=factor * self.model.gain)
        return max(float(run_lanes(*pair, gains[None], [scaled], self.law).largest[0]) for pair in self.pairs())

    @property
    def slower(self) -> AxisModel:
        """The axis with more delay, for the margins."""
        return replace(self.model, delay=max(self.model.delay, 0.0) + UNSEEN * self.law.period)

    def pairs(self) -> Sequence[tuple[Array, Array]]:
        """Return commands with their noises."""
        return list(zip(self.commands, self.noises, strict=True))


@dataclass(frozen=True, eq=False)
class TunedAxis:
    """Tuned gains of an axis.

    Attributes
    ----------
    gains : ndarray (7,)
        In the order of `loop.GAINS`, per metre.
    method : str
        "sequential" or "global".
    margins : Margins
    largest : float [m]
        Largest error on the commands.
    spread : float [m]
        The same at worst with the gain of the axis a quarter off.
    ended : tuple of str
        Numbers of `BOX` at an end of their range.
    """

    gains: Array
    method: str
    margins: Margins
    largest: float
    spread: float
    ended: tuple[str, ...]


def gains_of(points: Array, model: AxisModel, law: Law) -> Array:
    """Return the gains (n, 7) of points (n, 5) in the box from 0 to 1."""
    low, high = np.array(list(BOX.values())).T
    geometric = low[:3] * (high[:3] / low[:3]) ** points[:, :3]
    bandwidth, damping, integral = geometric.T
    ff1, ff2 = (low[3:] + points[:, 3:] * (high[3:] - low[3:])).T
    w = bandwidth / law.period
    p = w**2 / model.gain
    gains = np.zeros((len(points), 7))
    gains[:, 0] = p
    gains[:, 1] = p * w * integral
    gains[:, 2] = np.maximum(2.0 * damping * w - model.damping, 0.0) / model.gain
    gains[:, 4] = ff1 * (model.damping / model.gain + (p * law.period if law.previous_target else 0.0))
    gains[:, 5] = ff2 / model.gain
    return gains


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

    def objective(points: Array) -> Array:
        gains = gains_of(points, task.model, task.law)
        good = keep_margins(gains, task.slower, task.law.period, task.gain_margin, task.phase_margin)
        values = np.full(len(points), np.inf)
        if not good.any():
            return values
        worst, rms, excess = (np.zeros(int(good.sum())) for _ in range(3))
        for command, noise in task.pairs():
            runs = run_lanes(command, noise, gains[good], [task.model], task.law)
            worst, rms = np.maximum(worst, runs.largest), np.maximum(rms, runs.rms)
            bound = ROUGH * np.maximum(runs.output, 1e-12)
            excess = np.maximum(excess, np.maximum(runs.rough / bound - 1.0, 0.0) + 10.0 * runs.limited)
        values[good] = (worst + TIE * rms) * (1.0 + excess)
        return values

    start, value = _placed(objective)
    start, value = _sequential(objective, start, value)
    found = search(objective, np.vstack([start, _drawn(STARTS - 1, seed)]), budget=BUDGET, seed=seed, population=32)
    method, point = ("global", found.point) if found.value < value else ("sequential", start)
    gains = np.array([float(f"{unit * gain:.4g}") / unit for gain in gains_of(point[None], task.model, task.law)[0]])
    ended = tuple(name for name, place in zip(BOX, point.tolist(), strict=True) if not 0.005 < place < 0.995 and name != "integral")
    spread = max(task.largest(gains, factor) for factor in ROBUST)
    return TunedAxis(gains, method, loop_margins(gains, task.slower, task.law.period), task.largest(gains), spread, ended)


def _drawn(count: int, seed: int) -> Array:
    return 0.25 + 0.5 * np.random.default_rng(seed).random((count, len(BOX)))


def _placed(objective: Callable[[Array], Array]) -> tuple[Array, float]:
    """Return the best of well damped poles from slow to fast, with nominal feedforward."""
    speeds = np.linspace(0.02, 0.98, 96)
    points = np.column_stack([speeds, *(np.full(speeds.size, share) for share in (0.55, 0.3, 0.5, 1.0 / 3.0))])
    points = np.vstack([points, points * [1.0, 1.2, 1.0, 1.0, 1.0]])
    values = objective(points)
    best = int(np.argmin(values))
    if not math.isfinite(values[best]):
        raise ParameterError("margins", "no gains found", "smaller margins: a delayed axis cannot keep them")
    return points[best], float(values[best])


def _sequential(objective: Callable[[Array], Array], point: Array, value: float) -> tuple[Array, float]:
    """Improve one number at a time, each along a coarse and a fine line."""
    point = point.copy()
    for _ in range(PASSES):
        for i in range(point.size):
            for span in (1.0, 0.06):
                line = np.repeat(point[None], VALUES, axis=0)
                line[:, i] = np.clip(point[i] + span * np.linspace(-1.0, 1.0, VALUES), 0.0, 1.0)
                values = objective(line)
                best = int(np.argmin(values))
                if values[best] < value:
                    point, value = line[best].copy(), float(values[best])
    return point, value
