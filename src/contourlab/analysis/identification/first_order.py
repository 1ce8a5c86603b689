"""Identification of the first-order axis v' = -b v + a (u - friction - offset), in open or closed loop.

While the axis moves in one direction the motion is linear, and exact from sample to sample. The instant of a stop within a sample has a
closed form; from there the axis moves on, turns, or sticks until the command exceeds its friction.

Open loop (steps, squares, random levels): one output-error fit gives gain, damping, Coulomb friction, offset, delay and initial velocity.
The model is simulated from the command alone and compared with the measured velocity. (Fitting the equation itself to measured v and v'
would bias b when the velocity is noisy.) Measured and simulated velocity are the same difference quotient of position, so that the
difference adds no lag and no bias.

Closed loop, behind a disturbance observer with proportional position and velocity feedback (eq 18):
P/R = a' K_P/(s^2 + (b' + a' K_V) s + a' K_P). The reference is free of measurement noise, so the feedback does not bias the fit.

References
----------
Ghaffari & Ulsoy, "Component swapping modularity for distributed precision contouring", section III and eqs (1), (2) and (18), with
Coulomb friction.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.identification.filtered_motion import even_record
from contourlab.analysis.identification.least_squares import Free, OutputFit, deviation_findings, fit_findings, fit_output
from contourlab.arrays import Array
from contourlab.errors import ParameterError, refuse
from contourlab.findings import Finding, finding
from contourlab.native.kernel import kernel


def delayed(command: Array, samples: float) -> Array:
    """Return a held command delayed by a number of samples; a fraction of a sample gives a weighted mean of two held values."""
    whole = math.floor(samples)
    part = samples - whole
    padded = np.concatenate([np.full(whole + 1, command[0]), command])
    n = command.size
    return np.asarray((1.0 - part) * padded[1 : n + 1] + part * padded[:n])


def _gains(damping: float, time: float) -> tuple[float, float, float]:
    """Return the decay factor of a velocity, and velocity and travel per acceleration, after a time."""
    x = damping * time
    if x < 1e-3:
        gained = time * (1.0 - x * (0.5 - x * (1.0 / 6.0 - x / 24.0)))
        way = time * time * (0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x / 120.0)))
        return math.exp(-x), gained, way
    gained = -math.expm1(-x) / damping
    return math.exp(-x), gained, (time - gained) / damping


def first_order_motion(
    command: Array, period: float, damping: float, forward: float = 0.0, backward: float = 0.0, start: float = 0.0
) -> tuple[Array, Array]:
    """Return velocity and position of the axis per unit of its gain a, before the command of each sample acts.

    Parameters
    ----------
    command : ndarray (n,)
        Held from each sample to the next.
    period : float [s], > 0
    damping : float [1/s], >= 0
        b.
    forward, backward : float
        Friction in each direction, in units of the command: from rest the axis moves forwards if u > forward, backwards if u < -backward.
    start : float
        Initial velocity over a.

    Returns
    -------
    velocity, position : ndarray (n,)
        Over a; the first position is 0.
    """
    held = np.ascontiguousarray(command, dtype=float)
    v, p = np.zeros(held.size), np.zeros(held.size)
    v[0] = start
    _move(held, period, damping, forward, backward, v, p)
    return v, p


@kernel("f8[:] f8 f8 f8 f8 f8[:] f8[:]")
def _move(command: Array, period: float, damping: float, forward: float, backward: float, v: Array, p: Array) -> None:
    """Compute the motion from the first velocity and position on."""
    left, gained, gone = _gains(damping, period)
    rubs = forward != 0.0 or backward != 0.0
    way = 1.0 if v[0] > 0.0 else -1.0 if v[0] < 0.0 else 0.0
    for k in range(command.size - 1):
        if way == 0.0:
            way = 1.0 if command[k] > forward else -1.0 if command[k] < -backward else 0.0
        if way == 0.0:
            p[k + 1] = p[k]
            continue
        push = command[k] - (forward if way > 0.0 else -backward)
        v[k + 1] = left * v[k] + gained * push
        if rubs and way * v[k + 1] < 0.0:
            v[k + 1], travel, way = _turned(v[k], command[k], way, period, damping, forward, backward)
        else:
            travel = gained * v[k] + gone * push
        p[k + 1] = p[k] + travel


def _turned(
    velocity: float, command: float, way: float, period: float, damping: float, forward: float, backward: float
) -> tuple[float, float, float]:
    """Return velocity, travel and direction after a sample in which the axis stops."""
    push = command - (forward if way > 0.0 else -backward)
    ratio = -velocity / push
    stop = math.log1p(damping * ratio) / damping if damping * period > 1e-9 else ratio
    _, gained, gone = _gains(damping, stop)
    reached = gained * velocity + gone * push
    onward = 1.0 if command > forward else -1.0 if command < -backward else 0.0
    if onward == 0.0:
        return 0.0, reached, 0.0
    push = command - (forward if onward > 0.0 else -backward)
    _, gained, gone = _gains(damping, period - stop)
    return gained * push, reached + gone * push, onward


EXPLAINED = 80.0
"""Fit [percent] below which the model is in doubt."""
LONGEST_DELAY = 0.05
"""Largest fitted delay [s]."""


@dataclass(frozen=True, eq=False)
class FirstOrderFit(OutputFit):
    """An axis of first order, identified from a record.

    Its parameters are a [m/s^2 per command], b [1/s] and, if fitted, friction, offset [command], delay [s] and start [m/s]; `measured` and
    `predicted` are velocities [m/s].

    Attributes
    ----------
    time : ndarray (n,) [s]
        Middle of the interval over which each velocity is differenced.
    command : ndarray (n,)
        Mean over each interval.
    smoothing : int
        Samples of an interval.
    """

    time: Array
    command: Array
    smoothing: int
    usable: bool = True
    findings: tuple[Finding, ...] = ()


def smoothing_of(position: Array) -> int:
    """Return the samples over which to difference a position, so that counts and noise are at most half a percent of the velocity."""
    steps = np.abs(np.diff(position))
    refuse(not steps.any(), ParameterError, "position", "one place throughout", "a record in which the axis moves")
    count = float(steps[steps > 0.0].min())
    # Third differences nearly vanish for a smooth motion; for white noise they have 20 times its variance.
    noise = max(count / math.sqrt(12.0), float(np.median(np.abs(np.diff(position, 3)))) / 0.6745 / math.sqrt(20.0))
    size = float(np.sqrt(np.mean(steps**2)))
    return int(np.clip(math.ceil(math.sqrt(2.0) * noise / (0.005 * size)), 1, max(position.size // 400, 1)))


@dataclass(frozen=True, eq=False)
class _Blocks:
    """A record, and the model's velocities over the same intervals."""

    command: Array
    period: float
    smoothing: int

    def model(self, x: Mapping[str, float]) -> Array:
        """Return the model's velocity; a is 1 by default."""
        u, a, friction = delayed(self.command, x.get("delay", 0.0) / self.period), x.get("a", 1.0), x.get("friction", 0.0)
        u = u - x.get("offset", 0.0)
        return a * self.differenced(first_order_motion(u, self.period, x["b"], friction, friction, x.get("start", 0.0) / a)[1])

    def differenced(self, position: Array) -> Array:
        return np.asarray(np.diff(position[:: self.smoothing]) / (self.smoothing * self.period))

    def averaged(self, values: Array) -> Array:
        n = (values.size - 1) // self.smoothing
        return np.asarray(values[: n * self.smoothing].reshape(n, self.smoothing).mean(axis=1))


def identify_first_order(time: ArrayLike, command: ArrayLike, position: ArrayLike, *, friction: bool = True) -> FirstOrderFit:
    """Identify gain and damping, and friction, offset and delay, of an axis from its command and position.

    Parameters
    ----------
    time : array_like (n,) [s]
        Evenly spaced, at least 50 samples.
    command : array_like (n,)
        Held from each sample to the next.
    position : array_like (n,) [m]
        Measured.
    friction : bool
        Fit Coulomb friction, and an offset: the command that balances a constant force such as gravity.

    Raises
    ------
    ParameterError
        If the record is too short, uneven, not finite or at rest, if the axis moves against its command, or if parameters cannot be
        separated.
    """
    blocks, measured, free = _prepared(time, command, position, friction)
    fit = fit_output(blocks.model, measured, free)
    left_out: list[Finding] = []
    for name in ("start", "delay", "friction"):
        if name in free and (name in fit.at_bound or abs(fit[name]) < 2.0 * fit.deviation(name)):
            left_out.append(finding("CL528", name))
            free = {key: replace(part, start=fit[key]) for key, part in free.items() if key != name}
            fit = fit_output(blocks.model, measured, free)
    middle = np.asarray(time, dtype=float)[0] + blocks.period * blocks.smoothing * (np.arange(measured.size) + 0.5)
    return _judged(fit, middle, blocks.averaged(blocks.command), blocks.smoothing, "velocity", left_out)


def first_order_start(time: ArrayLike, command: ArrayLike, position: ArrayLike) -> tuple[int, dict[str, float]]:
    """Return the smoothing of `identify_first_order`, and the values from which it starts [SI].

    Parameters and errors are those of `identify_first_order`, without its fit.
    """
    blocks, _, free = _prepared(time, command, position, True)
    return blocks.smoothing, {name: one.start for name, one in free.items()}


def _prepared(time: ArrayLike, command: ArrayLike, position: ArrayLike, friction: bool) -> tuple[_Blocks, Array, dict[str, Free]]:
    """Return the record, its velocities, and the start of the fit."""
    period, (_, u, p) = even_record(time, {"command": command, "position": position})
    if not np.ptp(u) > 0.0:
        raise ParameterError("command", f"{u[0]:g} throughout", "a record whose command changes: one level cannot separate a and b")
    blocks = _Blocks(u, period, smoothing_of(p))
    measured = blocks.differenced(p)
    refuse(not np.ptp(measured) > 0.0, ParameterError, "position", "a record", "one in which the axis moves")
    return blocks, measured, _start(blocks, measured, friction)


def _start(blocks: _Blocks, measured: Array, with_friction: bool) -> dict[str, Free]:
    """Return the start of the fit: the best of a grid over damping and friction, each with its best gain."""
    u, whole = blocks.command, blocks.period * blocks.command.size
    size = float(np.sqrt(np.mean(u**2)))
    fastest = 1.0 / (2.0 * blocks.period * blocks.smoothing)
    best, least = (0.0, 1.0, 0.0), math.inf
    for b in np.geomspace(0.3 / whole, fastest, 14):
        for share in (0.0, 0.2, 0.5, 0.8) if with_friction else (0.0,):
            unit = blocks.model({"b": float(b), "friction": share * size})
            power = float(np.sum(unit**2))  # a product of vectors would spread over threads, which takes longer
            a = float(np.sum(unit * measured)) / power if power > 0.0 else 0.0
            cost = float(np.sum((measured - a * unit) ** 2))
            if a != 0.0 and cost < least:
                best, least = (a, float(b), share * size), cost
    a, b, friction = best
    if a <= 0.0:
        raise ParameterError(
            "velocity", "a record", "rising with the command: one of the two is counted the other way round, or they are not of one axis"
        )
    free = {"a": Free(a, 1e-6 * a, 1e6 * a, a), "b": Free(b, 0.0, 20.0 * fastest, max(b, 0.01 * fastest))}
    if with_friction:
        free |= {"friction": Free(friction, 0.0, float(np.abs(u).max()), size), "offset": Free(0.0, -2.0 * size, 2.0 * size, 0.1 * size)}
    free["delay"] = Free(0.5 * blocks.period, 0.0, min(LONGEST_DELAY, 0.1 * whole), blocks.period)
    if abs(measured[0]) > 0.01 * float(np.abs(measured).max()):
        free["start"] = Free(float(measured[0]), scale=float(np.abs(measured).max()))
    return free


def _judged(fit: OutputFit, time: Array, command: Array, smoothing: int, output: str, findings: Sequence[Finding] = ()) -> FirstOrderFit:
    """Return a fit with findings on a, b and the output, and whether the model is usable."""
    doubts, usable = [*findings], fit.fit > 0.5 * EXPLAINED
    for name in ("a", "b"):
        if name in fit.at_bound or fit.deviation(name) > 0.5 * fit[name]:
            doubts.append(finding("CL527", name, value=fit[name]))
            usable = False
        else:
            doubts += deviation_findings(name, fit[name], fit.deviation(name))
    doubts += fit_findings(fit.fit, EXPLAINED, output)
    return FirstOrderFit(**vars(fit), time=time, command=command, smoothing=smoothing, usable=usable, findings=tuple(doubts))


DAMPING_GRID, BAND_GRID = (0.3, 0.7, 1.0, 1.5, 3.0), 16


def closed_loop_position(reference: Array, period: float, gain: float, damping: float, position_gain: float, velocity_gain: float) -> Array:
    """Return the position of eq (18) at the samples; the reference is held between samples, and the axis starts at rest at its first value.

    Parameters
    ----------
    reference : ndarray (n,) [m]
    period : float [s]
    gain, damping : float [m/s^2 per command, 1/s]
        a' and b'.
    position_gain, velocity_gain : float [command/m, command s/m]
        K_P and K_V.
    """
    from scipy.linalg import expm
    from scipy.signal import lfilter

    stiffness, loss = gain * position_gain, damping + gain * velocity_gain
    whole = np.zeros((3, 3))
    whole[:2] = [[0.0, 1.0, 0.0], [-stiffness, -loss, stiffness]]
    a, b = (part := expm(whole * period))[:2, :2], part[:2, 2]
    trace, determinant = float(np.trace(a)), math.exp(-loss * period)
    # Position of x+ = A x + B r as one difference equation.
    top = [0.0, float(b[0]), float(a[0, 1] * b[1] - a[1, 1] * b[0])]
    return np.asarray(reference[0] + lfilter(top, [1.0, -trace, determinant], reference - reference[0]))


def identify_closed_loop(
    time: ArrayLike, reference: ArrayLike, position: ArrayLike, position_gain: float, velocity_gain: float
) -> FirstOrderFit:
    """Identify a' and b' of an axis from reference and position of its closed loop.

    Parameters
    ----------
    time : array_like (n,) [s]
        Evenly spaced, at least 50 samples.
    reference, position : array_like (n,) [m]
        The axis starts at rest at the reference.
    position_gain : float [command/m], > 0
        K_P during the run.
    velocity_gain : float [command s/m], >= 0
        K_V.

    Returns
    -------
    FirstOrderFit
        With a [m/s^2 per command] and b [1/s]; here `measured` and `predicted` are positions, and `command` is the reference.

    Raises
    ------
    ParameterError
        If a gain is out of range, the record is too short, uneven, not finite or at rest, or does not determine a' and b'.
    """
    for name, value, lowest in (("position_gain", position_gain, 1e-12), ("velocity_gain", velocity_gain, 0.0)):
        if not (math.isfinite(value) and value >= lowest):
            raise ParameterError(name, f"{value:g}", "finite and " + ("> 0" if lowest else ">= 0"))
    period, (_, r, p) = even_record(time, {"reference": reference, "position": position})
    if not (np.ptp(r) > 0.0 and np.ptp(p) > 0.0):
        raise ParameterError("reference", f"{r[0]:g} throughout", "a record in which reference and axis move")

    def model(x: Mapping[str, float]) -> Array:
        return closed_loop_position(r, period, x["a"], x["b"], position_gain, velocity_gain)

    bands = np.geomspace(2.0 / (period * r.size), 0.5 / period, BAND_GRID).tolist()
    places = [(band**2 / position_gain, 2.0 * ratio * band) for band in bands for ratio in DAMPING_GRID]
    tried = [{"a": a, "b": max(loss - a * velocity_gain, 0.0)} for a, loss in places]
    a, b = min(tried, key=lambda x: float(np.sum((model(x) - p) ** 2))).values()
    scale = max(b, 0.1 * a * velocity_gain, 1e-3 / period)
    fit = fit_output(model, p, {"a": Free(a, 1e-3 * a, 1e3 * a, a), "b": Free(b, 0.0, 10.0 / period, scale)})
    return _judged(fit, np.asarray(time, dtype=float), r, 1, "position")
