"""What a contour error teaches: the inverse of the loop, and the correction of the next pass.

The error of a run is the vector from the position to its foot point on the programmed path. Per axis, the loop from command c to position
p is taken as

    (1 + z D)(c - p) = a D p + b D^2 p + friction,        so        c/p = 1 + (a D + b D^2)/(1 + z D)

and fitted by least squares to the log itself. The error, filtered forwards and backwards in time by that inverse and by a low-pass at
`CUTOFF` times the bandwidth, is what the command lacked. It is stored at the places along the programmed path where the control was then.

Each place keeps the correction under which its error was smallest. Where a step made it worse, half of it is tried next; where the error
is small, nothing is.

References
----------
D. A. Bristow, M. Tharayil, A. G. Alleyne, "A survey of iterative learning control", IEEE Control Systems Magazine 26 (3), 2006: inverse
of the plant and Q filter.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from contourlab.arrays import Array, Flags

CUTOFF = 0.8
"""Cutoff of the robustness filter over the bandwidth of the slowest axis; from about 1 on, the control's feed on the bends that are then
written changes from pass to pass, and passes get worse."""
FIT_BAND = 2.4
"""Band of the fit of the loop, over its bandwidth."""
ORDER = 4
"""Slope of the low-pass: |Q| = 1/(1 + (f/f_c)^ORDER)."""
NEAR = 0.5
"""Time over which an error counts for its place, times the cutoff."""
RESTS = 1.0 / 10.0
"""Error over the first error, both rms, up to which a place is left as it is."""
LEFT = 0.5
"""Share of what the control rounds itself that the first pass does not correct: short lines are rounded less than those of the program."""
FORGOTTEN = 1e-6
"""Mean square of the error where nothing is known [m^2]: any run is better."""
STEEPEST = 0.5
"""Displacement near the end of a corrected part over the distance from it."""
STICKING = 1e-4
"""Speed [m/s] over which friction changes its sign in the fit."""


@dataclass(frozen=True)
class Loop:
    """The closed loop of an axis from command to position.

    Attributes
    ----------
    zero : float [s], >= 0
    velocity_lag : float [s]
    acceleration_lag : float [s^2]
    bandwidth : float [Hz]
        Where the response falls by 3 dB; inf for an axis that does not move.
    """

    zero: float = 0.0
    velocity_lag: float = 0.0
    acceleration_lag: float = 0.0
    bandwidth: float = math.inf

    def inverse(self, frequency: Array) -> Array:
        """Return command over position at frequencies (n,) [Hz]."""
        s = 2j * math.pi * frequency
        return np.asarray(1.0 + (self.velocity_lag * s + self.acceleration_lag * s * s) / (1.0 + self.zero * s))


def filtered(values: Array, period: float, response: Callable[[Array], Array], longest: float) -> Array:
    """Filter values by a response over frequency [Hz], in both directions of time; zero before and after.

    Parameters
    ----------
    values : ndarray (n,) or (n, k)
    period : float [s]
    response : callable
        Of frequencies (m,), returning (m,) or (m, k).
    longest : float [s]
        Time after which the filter has decayed.
    """
    from scipy.fft import irfft, next_fast_len, rfft, rfftfreq

    n = len(values)
    size = next_fast_len(n + 2 * math.ceil(longest / period), real=True)
    gain = response(rfftfreq(size, period))
    gain = gain if gain.ndim == values.ndim else gain[:, None]
    return np.asarray(irfft(rfft(values, size, axis=0) * gain, size, axis=0)[:n])


def low_pass(cutoff: float) -> Callable[[Array], Array]:
    """Return the response of the robustness filter with a cutoff [Hz]."""
    return lambda frequency: 1.0 / (1.0 + (frequency / cutoff) ** ORDER)


def smoothed(values: Array, period: float, cutoff: float) -> Array:
    """Return values (n,) or (n, k) below a cutoff [Hz]."""
    return filtered(values, period, low_pass(cutoff), 3.0 / cutoff)


def fit_loop(command: Array, position: Array, period: float) -> Loop:
    """Fit the loop of one axis.

    Parameters
    ----------
    command, position : ndarray (n,) [m]
        Position where the loop measures it.
    period : float [s]
    """
    if np.ptp(command) == 0.0:
        return Loop()
    band, loop = 0.05 / period, Loop()
    for _ in range(4):
        fit = _fit(command, position, period, band)
        if math.isclose(fit.bandwidth, loop.bandwidth, rel_tol=0.02):
            return fit
        loop, band = fit, min(FIT_BAND * fit.bandwidth, 0.1 / period)
    return loop


def _fit(command: Array, position: Array, period: float, band: float) -> Loop:
    friction = np.tanh(np.gradient(position, period) / STICKING)
    asked, given, sign = (smoothed(part, period, band) for part in (command - command[0], position - command[0], friction))
    speed, late = np.gradient(given, period), asked - given
    columns = np.column_stack([-np.gradient(late, period), speed, np.gradient(speed, period), sign])
    edge = min(math.ceil(1.0 / (band * period)), len(late) // 4)
    used = slice(edge, len(late) - edge)
    scale = np.sqrt((columns[used] ** 2).mean(axis=0)) + 1e-300
    solved, *_ = np.linalg.lstsq(columns[used] / scale, late[used], rcond=1e-9)
    zero, velocity, acceleration, _ = (solved / scale).tolist()
    loop = Loop(max(zero, 0.0), velocity, acceleration)
    frequency = np.geomspace(0.02, 0.45 / period, 2000)
    below = np.flatnonzero(np.abs(loop.inverse(frequency)) > math.sqrt(2.0))
    return replace(loop, bandwidth=float(frequency[below[0]] if below.size else frequency[-1]))


@dataclass(frozen=True, eq=False)
class Run:
    """One run of a pass.

    Attributes
    ----------
    period : float [s]
    place : ndarray (n,) [m]
        Where the control was on the programmed path; never falls.
    error : ndarray (n, n_axis) [m]
        From the position to its foot point on the programmed path; zero off the corrected curves.
    moves : ndarray (n,) of bool
        Whether the command moved along a corrected curve.
    speed : ndarray (n,) [m/s]
        Of the command.
    duration : float [s]
        From the first to the last motion of the command.
    velocity, acceleration : ndarray (n_axis,) [m/s, m/s^2]
        Largest values of the command.
    rounded : ndarray (n, n_axis) [m]
        From the command to its foot point on the path that it was to follow: what the control rounds.
    """

    period: float
    place: Array
    error: Array
    moves: Flags
    speed: Array
    duration: float
    velocity: Array
    acceleration: Array
    rounded: Array

    @property
    def rms(self) -> float:
        """Contour error, rms over the corrected motion [m]."""
        return math.sqrt((self.error[self.moves] ** 2).sum(axis=1).mean())

    @property
    def largest(self) -> float:
        """Largest contour error of the corrected motion [m]."""
        return math.sqrt((self.error[self.moves] ** 2).sum(axis=1).max())

    def at(self, nodes: Array, values: Array) -> Array:
        """Return values (n, k) of the samples at places (n_node,) [m]: the mean of the samples at a place, between them linear."""
        place, back = np.unique(np.round(self.place[self.moves] * 1e7), return_inverse=True)
        count = np.bincount(back)
        means = [np.bincount(back, column) / count for column in values[self.moves].T]
        return np.column_stack([np.interp(nodes, place * 1e-7, column) for column in means])


def spread(runs: list[Run]) -> float | None:
    """Return the rms [m] of what differs between runs of the same pass; None for one run."""
    if len(runs) < 2:
        return None
    grid = runs[0].place[runs[0].moves]
    errors = np.array([run.at(grid, run.error) for run in runs])
    return float(np.sqrt((errors.var(axis=0, ddof=1)).sum(axis=1).mean()))


@dataclass(frozen=True, eq=False)
class Learned:
    """What all passes have taught, at the nodes of the contour.

    Attributes
    ----------
    kept : ndarray (n_node, n_axis) [m]
        Best correction of each place.
    step : ndarray (n_node, n_axis) [m]
        What the error under it asks for.
    error : ndarray (n_node,) [m^2]
        Mean square of that error around the place.
    gain : ndarray (n_node,)
        Share of the step to try next.
    tried : ndarray (n_node, n_axis) [m]
        Correction of the last written pass.
    speed : ndarray (n_node,) [m/s]
        Of the command in the program itself.
    rests : float [m]
        Error at which a place is left as it is.
    """

    kept: Array
    step: Array
    error: Array
    gain: Array
    tried: Array
    speed: Array
    rests: float


def learn(before: Learned | None, runs: list[Run], loops: list[Loop], nodes: Array, cutoff: float) -> Learned:
    """Return what is known after a pass; `Learned.tried` is then still the correction of this pass.

    Parameters
    ----------
    before : Learned or None
        None for the program itself.
    runs : list of Run
        Of the same pass.
    loops : list of Loop
        One for each axis.
    nodes : ndarray (n_node,) [m]
    cutoff : float [Hz]
    """
    run, longest = runs[0], 3.0 / cutoff + max(10.0 / loop.bandwidth for loop in loops)

    def response(frequency: Array) -> Array:
        inverse = np.stack([loop.inverse(frequency) for loop in loops], axis=1)
        return inverse * low_pass(cutoff)(frequency)[:, None]

    step = np.mean([one.at(nodes, filtered(one.error, one.period, response, longest)) for one in runs], axis=0)
    square = np.mean([one.at(nodes, _nearby((one.error**2).sum(axis=1), one.period, cutoff)) for one in runs], axis=0)[:, 0]
    if before is None:
        step = step - LEFT * np.mean([one.at(nodes, smoothed(one.rounded, one.period, cutoff)) for one in runs], axis=0)
        nothing, speed = np.zeros_like(step), run.at(nodes, run.speed[:, None])[:, 0]
        return Learned(nothing, step, square, np.ones(len(nodes)), nothing, speed, RESTS * run.rms)
    better = np.interp(run.place, nodes, (square < before.error).astype(np.float64))
    share = run.at(nodes, _nearby(better, run.period, cutoff)).clip(0.0, 1.0)
    return replace(
        before,
        kept=before.kept + share * (before.tried - before.kept),
        step=before.step + share * (step - before.step),
        error=before.error + share[:, 0] * (square - before.error),
        gain=before.gain * (0.5 + 0.5 * share[:, 0]),
    )


def _nearby(values: Array, period: float, cutoff: float) -> Array:
    """Return weighted means (n, 1) of values (n,) over the time in which an error counts for its place."""
    sigma = NEAR / cutoff
    weights = filtered(values, period, lambda frequency: np.exp(-0.5 * (2.0 * math.pi * frequency * sigma) ** 2), 4.0 * sigma)
    return np.maximum(weights, 0.0)[:, None]


def proposed(learned: Learned, cap: float, room: Array | float = np.inf) -> tuple[Array, Array]:
    """Return the correction of the next pass (n_node, n_axis) [m], and at which nodes (n_node,) the cap held it.

    Parameters
    ----------
    learned : Learned
    cap : float [m]
        Largest displacement.
    room : ndarray (n_node,) [m], optional
        Distance to the nearer end of a corrected part. There the displacement is zero, and grows so slowly that the path never turns back.
    """
    rest = np.clip((np.sqrt(np.maximum(learned.error, 0.0)) - learned.rests) / max(2.0 * learned.rests, 1e-300), 0.0, 1.0)
    tried = learned.kept + (learned.gain * rest)[:, None] * learned.step
    size = np.linalg.norm(tried, axis=1)
    capped = size > cap
    most = np.minimum(cap, STEEPEST * room)
    return tried * np.minimum(1.0, most / np.maximum(size, 1e-300))[:, None], capped


def forgotten(learned: Learned, nodes: Array, begin: float, end: float, after: float) -> Learned:
    """Return what is learned without a part of the path [m] in which the next run will differ; from `after` on the correction is whole."""
    weight = np.where(nodes < begin, 1.0, np.clip((nodes - end) / max(after - end, 1e-12), 0.0, 1.0))
    error = np.where(weight < 1.0, FORGOTTEN, learned.error)
    return replace(learned, kept=learned.kept * weight[:, None], step=learned.step * weight[:, None], error=error)
