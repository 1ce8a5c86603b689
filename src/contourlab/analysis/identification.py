"""Identification of a servo axis from records: gain, damping ratio, natural frequency and delay, each with its standard deviation.

The axis is X(s)/U(s) = G wn^2 exp(-s tau)/(s (s^2 + 2 zeta wn s + wn^2)), under a command that is held between samples. Its response to
such a command is known in closed form for any damping ratio and any delay, so that a pulse of one sample is taken as what it is, not as
an impulse, and a delay is found to a fraction of a sample. Deviations hold for noise that is white and normal in the record given: give the
encoder's position, where noise is so, rather than its differences, where it is not.

References
----------
Gecer Ulu, Ulu & Cakmakci, "Design and analysis of a modular learning based cross-coupled control algorithm for multi-axis precision
positioning systems", section 2, eqs (4) and (5); Ljung, "System Identification", 2nd ed., eq (9.17) for the covariance.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.analysis.even_record import even_record
from contourlab.analysis.second_order import held_response
from contourlab.errors import ParameterError

__all__ = ["Estimate", "SecondOrderFit", "identify_delay", "identify_gain", "identify_second_order"]

Array = NDArray[np.float64]

SHORTEST = 12
"""Fewest samples that a record may have."""
EVEN = 1e-6
"""Share of the period by which times may be uneven."""
DAMPING = (0.02, 50.0)
"""Damping ratios between which one is looked for."""


@dataclass(frozen=True)
class Estimate:
    """A number found from a record.

    Attributes
    ----------
    value : float
    deviation : float
        Its standard deviation.
    fit : float [percent]
        100 (1 - |y - model| / |y - mean of y|): 100 where the model says all.
    """

    value: float
    deviation: float
    fit: float


@dataclass(frozen=True)
class SecondOrderFit:
    """An axis found from a record; each ``*_deviation`` is a standard deviation, in the same unit.

    Attributes
    ----------
    dc_gain, dc_gain_deviation : float [m/s per command]
    damping_ratio, damping_ratio_deviation : float
    natural_frequency, natural_frequency_deviation : float [rad/s]
    delay, delay_deviation : float [s]
        The deviation is 0 where the delay was given.
    fit : float [percent]
        100 (1 - |y - model| / |y - mean of y|).
    noise : float
        Standard deviation of what the model leaves over, in the unit of the record.
    correlation : ndarray (n, n)
        Of gain, damping ratio, natural frequency and, where it was looked for, delay.
    response : ndarray (n_sample,)
        The model's response to the recorded command.
    """

    dc_gain: float
    dc_gain_deviation: float
    damping_ratio: float
    damping_ratio_deviation: float
    natural_frequency: float
    natural_frequency_deviation: float
    delay: float
    delay_deviation: float
    fit: float
    noise: float
    correlation: Array
    response: Array


@dataclass(frozen=True)
class _Record:
    """A checked record: its period, and what the models are held against."""

    period: float
    response: Array
    command: Array
    of: str

    def unit(self, damping_ratio: float, natural_frequency: float, delay: float) -> Array:
        """Return what an axis with the gain 1 would have given."""
        return held_response(self.command, self.period, damping_ratio, natural_frequency, delay, of=self.of)

    def linear(self, model: Array) -> tuple[Array, Array]:
        """Return the best gain and, for a position, offset of a model, and what they leave over."""
        columns = np.column_stack([model, np.ones_like(model)] if self.of == "position" else [model])
        found = np.asarray(np.linalg.lstsq(columns, self.response, rcond=None)[0], dtype=float)
        return found, np.asarray(columns @ found - self.response)

    def fit(self, left: Array) -> float:
        return 100.0 * (1.0 - float(np.linalg.norm(left) / np.linalg.norm(self.response - self.response.mean())))


def identify_second_order(
    time: ArrayLike,
    velocity: ArrayLike,
    command: ArrayLike,
    *,
    of: str = "velocity",
    delay: float | None = 0.0,
    longest_delay: float | None = None,
) -> SecondOrderFit:
    """Find gain, damping ratio and natural frequency from a record of an axis that starts at rest: a pulse, a step, any open-loop command.

    Parameters
    ----------
    time : array_like (n,) [s]
        Evenly spaced, at least `SHORTEST` samples.
    velocity : array_like (n,) [m/s, or m]
        What was measured: the velocity, or with ``of="position"`` the position, whose offset is found too.
    command : array_like (n,)
        Held from each sample to the next; zero before the first.
    of : str
        ``"velocity"`` or ``"position"``.
    delay : float or None [s], >= 0
        Known transport delay; None to find it with the rest.
    longest_delay : float [s], optional
        Up to where it is looked for; a quarter of the record otherwise.

    Raises
    ------
    ParameterError
        If the record is too short, uneven, not finite, without command or response, or tells the parameters no apart.
    """
    from scipy.optimize import least_squares

    record = _checked(time, velocity, command, of)
    start, bounds = _start(record, delay, longest_delay)

    def left(x: Array) -> Array:
        return record.linear(record.unit(math.exp(x[0]), math.exp(x[1]), x[2] if delay is None else delay))[1]

    found = least_squares(left, start, bounds=bounds, x_scale=_scales(record, start), xtol=1e-14, ftol=1e-14, gtol=1e-14)
    best = found.x
    _check_response(record, *_explained(record, best, delay))
    at_bound = [i for i in range(2) if min(best[i] - bounds[0][i], bounds[1][i] - best[i]) < 1e-6]
    if at_bound:
        name = ("damping_ratio", "natural_frequency")[at_bound[0]]
        raise ParameterError(name, f"{math.exp(best[at_bound[0]]):.3g}", "told by the record: it holds no motion faster than its samples")
    return _described(record, best, delay)


def _described(record: _Record, best: Array, delay: float | None) -> SecondOrderFit:
    zeta, wn = math.exp(best[0]), math.exp(best[1])
    late = float(best[2]) if delay is None else delay
    numbers, left = _explained(record, best, delay)
    gain = float(numbers[0])

    def model(x: Array) -> Array:
        offset = x[4] if record.of == "position" else 0.0
        return np.asarray(x[0] * record.unit(x[1], x[2], x[3]) + offset)

    at = np.array([gain, zeta, wn, late, *numbers[1:]])
    free = [0, 1, 2, *([3] if delay is None else []), *([4] if record.of == "position" else [])]
    scale = np.array([gain, zeta, wn, record.period, record.period * gain or 1.0])
    covariance, noise = _covariance(model, at, free, scale, left)
    deviation = np.sqrt(np.diag(covariance))
    kept = 3 + (delay is None)
    return SecondOrderFit(
        gain,
        float(deviation[0]),
        zeta,
        float(deviation[1]),
        wn,
        float(deviation[2]),
        late,
        float(deviation[3]) if delay is None else 0.0,
        record.fit(left),
        noise,
        (covariance / np.outer(deviation, deviation))[:kept, :kept] if deviation.all() else np.eye(kept),
        model(at),
    )


def identify_gain(time: ArrayLike, velocity: ArrayLike, command: ArrayLike) -> Estimate:
    """Find the velocity per command [m/s per command] from an open-loop step: the mean of what has settled.

    Parameters
    ----------
    time : array_like (n,) [s]
        Evenly spaced, at least `SHORTEST` samples.
    velocity : array_like (n,) [m/s]
    command : array_like (n,)
        A step: constant over the last half of the record or more, and different at its start.

    Raises
    ------
    ParameterError
        If the record is too short, uneven or not finite, holds no step, does not rise with it, or has not settled.
    """
    record = _checked(time, velocity, command, "velocity")
    u, v = record.command, record.response
    step = int(np.flatnonzero(u != u[-1])[-1]) + 1 if np.any(u != u[-1]) else 0
    size = float(u[-1])
    if size == 0.0 or len(u) - step < len(u) // 2:
        raise ParameterError("command", "a record", "a step: constant and not zero over the last half of the record")
    last = v[-(len(u) - step) // 2 :]
    first, second = np.array_split(last, 2)
    mean, spread = float(last.mean()), float(last.std(ddof=1))
    if abs(mean) <= 4.0 * spread / math.sqrt(last.size) or not np.ptp(v) > 0.0:
        raise ParameterError("velocity", f"{mean:.3g}", "above its own noise after the step: the record shows no response", "m/s")
    if mean * size < 0.0:
        raise ParameterError("velocity", f"{mean:.3g}", "rising with the command: its sign is that of the other direction", "m/s")
    drift = abs(float(second.mean() - first.mean()))
    if drift > max(5.0 * spread * math.sqrt(2.0 / first.size), 1e-3 * abs(mean)):
        raise ParameterError("velocity", "a record", f"settled at its end: its last quarters differ by {100.0 * drift / abs(mean):.2g} %")
    left = last - mean
    before = v[:step]
    rise = math.sqrt(float(left @ left) / float(np.sum((np.r_[before, last] - np.r_[before, last].mean()) ** 2)))
    return Estimate(mean / size, spread / math.sqrt(last.size) / abs(size), 100.0 * (1.0 - rise))


def identify_delay(
    time: ArrayLike,
    response: ArrayLike,
    command: ArrayLike,
    *,
    damping_ratio: float,
    natural_frequency: float,
    of: str = "velocity",
    longest_delay: float | None = None,
) -> Estimate:
    """Find the transport delay [s] of an axis of known dynamics, to a fraction of a sample.

    Only what the axis was given and what it did count, so that the record may be of an open or a closed loop; in a closed one `command` is
    the controller's output. The gain is found along with it.

    Parameters
    ----------
    time : array_like (n,) [s]
        Evenly spaced, at least `SHORTEST` samples.
    response : array_like (n,) [m/s, or m]
        Velocity, or with ``of="position"`` position.
    command : array_like (n,)
        Held from each sample to the next; zero before the first.
    damping_ratio : float, > 0
    natural_frequency : float [rad/s], > 0
    of : str
        ``"velocity"`` or ``"position"``.
    longest_delay : float [s], optional
        Up to where it is looked for; a quarter of the record otherwise.

    Raises
    ------
    ParameterError
        If the record is too short, uneven, not finite, without command or response, or has a delay beyond `longest_delay`.
    """
    from scipy.optimize import least_squares

    record = _checked(time, response, command, of)
    for name, value in (("damping_ratio", damping_ratio), ("natural_frequency", natural_frequency)):
        if not (math.isfinite(value) and value > 0.0):
            raise ParameterError(name, f"{value:g}", "> 0")
    longest = _longest(record, longest_delay)

    def left(x: Any) -> Array:
        return record.linear(record.unit(damping_ratio, natural_frequency, float(np.ravel(x)[0])))[1]

    tried = np.linspace(0.0, longest, 2 * max(int(longest / record.period), 8))
    first = tried[int(np.argmin([np.linalg.norm(left(x)) for x in tried]))]
    around = record.period
    bounds = ([0.0], [longest + 1e-9 * around])
    found = least_squares(left, [first], bounds=bounds, x_scale=[around], xtol=1e-14, ftol=1e-14, gtol=1e-14)
    late = float(found.x[0])
    if late > longest - 1e-3 * around:
        raise ParameterError(
            "delay", f"{late:.4g}", f"below {longest:.4g}, up to where it is looked for: give longest_delay, or a longer record", "s"
        )
    numbers, over = record.linear(record.unit(damping_ratio, natural_frequency, late))
    _check_response(record, numbers, over)

    def model(x: Array) -> Array:
        return np.asarray(x[0] * record.unit(damping_ratio, natural_frequency, x[1]) + (x[2] if of == "position" else 0.0))

    free = [0, 1, *([2] if of == "position" else [])]
    gain = float(numbers[0])
    covariance, _ = _covariance(model, np.array([gain, late, *numbers[1:]]), free, np.array([gain, around, around * gain]), over)
    return Estimate(late, math.sqrt(float(covariance[1, 1])), record.fit(over))


def _checked(time: ArrayLike, response: ArrayLike, command: ArrayLike, of: str) -> _Record:
    if of not in ("velocity", "position"):
        raise ParameterError("of", repr(of), "one of 'velocity', 'position'")
    period, (_, y, u) = even_record(time, {of: response, "command": command}, SHORTEST, EVEN)
    if not u.any():
        raise ParameterError("command", "zero throughout", "a record in which the axis is moved")
    if not np.ptp(y) > 0.0:
        raise ParameterError(of, f"{y[0]:g} throughout", "a record in which the axis answers")
    return _Record(period, y, u, of)


def _explained(record: _Record, best: Array, delay: float | None) -> tuple[Array, Array]:
    """Return gain and offset, and what is left over, of the model that was found."""
    return record.linear(record.unit(math.exp(best[0]), math.exp(best[1]), float(best[2]) if delay is None else delay))


def _check_response(record: _Record, numbers: Array, left: Array) -> None:
    """The part that the model explains has to stand out of what it leaves over, and go with the command."""
    n, over = record.response.size, float(left @ left)
    spread = (
        float(np.sum((record.response - record.response.mean()) ** 2)) if record.of == "position" else float(np.sum(record.response**2))
    )
    # With this many samples a model of noise would leave about as much; four parameters explain a share of 4/n by chance.
    if over > spread * (1.0 - 40.0 / (n + 40.0)):
        raise ParameterError(record.of, "a record", "a response to the command: what goes with it is lost in the noise")
    if numbers[0] <= 0.0:
        raise ParameterError(record.of, "a record", "rising with the command: its sign is that of the other direction")


def _longest(record: _Record, longest: float | None) -> float:
    whole = record.period * (record.response.size - 1)
    found = 0.25 * whole if longest is None else longest
    if not 0.0 < found < whole:
        raise ParameterError("longest_delay", f"{found:g}", f"> 0 and below the record's {whole:g}", "s")
    return found


def _start(record: _Record, delay: float | None, longest_delay: float | None) -> tuple[Array, tuple[list[float], list[float]]]:
    """Return the best of a grid over damping, frequency and delay, and the bounds within which to go on from it."""
    whole = record.period * record.response.size
    lowest, highest = 0.5 / whole, 3.0 / record.period
    if delay is not None and not (math.isfinite(delay) and 0.0 <= delay < whole):
        raise ParameterError("delay", f"{delay:g}", f">= 0 and shorter than the record of {whole:g}", "s")
    longest = _longest(record, longest_delay) if delay is None else 0.0
    lates = [delay] if delay is not None else list(np.linspace(0.0, longest, 13))
    best, least = np.zeros(3), math.inf
    for zeta in (0.2, 0.7, 1.5, 5.0):
        for wn in np.geomspace(2.0 * lowest, 0.5 * highest, 16):
            for late in lates:
                norm = float(np.linalg.norm(record.linear(record.unit(zeta, float(wn), float(late)))[1]))
                if norm < least:
                    best, least = np.array([math.log(zeta), math.log(wn), float(late)]), norm
    low, high = [math.log(DAMPING[0]), math.log(lowest), 0.0], [math.log(DAMPING[1]), math.log(highest), longest]
    n = 3 if delay is None else 2
    return np.clip(best[:n], low[:n], high[:n]), (low[:n], high[:n])


def _scales(record: _Record, start: Array) -> list[float]:
    return [1.0, 1.0, record.period][: start.size]


def _covariance(model: Callable[[Array], Array], at: Array, free: list[int], scale: Array, left: Array) -> tuple[Array, float]:
    """Return the covariance of the parameters `free`, by central differences of the model, and the standard deviation of the noise."""
    columns = []
    for i in free:
        nudge = np.zeros(at.size)
        nudge[i] = 1e-5 * abs(scale[i])
        # A delay of nearly zero cannot be made shorter: from there, forwards only.
        back = nudge if i != 3 or at[i] > nudge[i] else np.zeros(at.size)
        columns.append((model(at + nudge) - model(at - back)) / (nudge[i] + back[i]))
    slopes = np.column_stack(columns)
    size = np.linalg.norm(slopes, axis=0)
    if not size.all():
        raise ParameterError("record", "its samples", "such that every parameter shows in it")
    variance = float(left @ left) / max(left.size - len(free), 1)
    # Columns of one length: units of the parameters are no matter of conditioning.
    inverse = np.linalg.pinv((slopes / size).T @ (slopes / size), rcond=1e-13)
    return np.asarray(variance * inverse / np.outer(size, size)), math.sqrt(variance)
