"""Quadrature signals of an encoder: their errors from an ellipse, the resulting position errors, and counts finer than a period.

`fit_ellipse` uses all samples of a record. `track_ellipse` runs the step of the sensor component, tick by tick. Zero crossings of sinusoids
of higher order divide a period of the corrected signals.

References
----------
P. L. M. Heydemann, "Determination and correction of quadrature fringe measurement errors in interferometers", Applied Optics 20 (1981);
E. Ulu, N. Gecer Ulu, M. Cakmakci, "Development and validation of an adaptive method to generate high-resolution quadrature encoder
signals", Journal of Dynamic Systems, Measurement, and Control 136 (2014).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import BLOCK, Array, Flags, Index
from contourlab.components.sensor.encoder import (
    DERIVED,
    LEAST_COVARIANCE,
    STATES,
    TABLES,
    TUNING,
    arctangents,
    ellipse,
    followed,
)
from contourlab.engine.runner import make_group
from contourlab.engine.step import Node, Port, Schedule, Step, ports
from contourlab.errors import ParameterError, refuse
from contourlab.loop.simulate import jit_enabled

ENTRIES = 64
"""Table entries per order: the interpolated sinusoids have an error of 1/(8 ENTRIES^2) = 3e-5."""
HIGHEST = 100_000


def interpolation_order(pitch: float, resolution: float) -> int:
    """Return the order n of the sinusoids whose zero crossings are a resolution apart: pitch = 4 n resolution.

    Parameters
    ----------
    pitch : float [m], > 0
        Travel of one period of the signals: 4 um for a scale with a resolution of 1 um after the usual fourfold count.
    resolution : float [m], > 0

    Raises
    ------
    ParameterError
        If the pitch is not four times a whole number of resolutions; the message names the nearest valid resolutions.

    >>> interpolation_order(4e-6, 25e-9), interpolation_order(4e-6, 10e-9)
    (40, 100)
    """
    for name, value in (("pitch", pitch), ("resolution", resolution)):
        refuse(not 0.0 < value < float("inf"), ParameterError, name, f"{value:g}", "> 0 and finite", "m")
    exact = pitch / (4.0 * resolution)
    order = round(exact) if exact < 2.0 * HIGHEST else 0
    if not 1 <= order <= HIGHEST or abs(exact - order) > 1e-6 * order:
        near = sorted({pitch / (4.0 * n) for n in (np.floor(exact), np.ceil(exact)) if 1 <= n <= HIGHEST})
        nearest = " or ".join(f"{value:.9g}" for value in near) or f"from {pitch / (4.0 * HIGHEST):.6g} to {0.25 * pitch:.6g}"
        raise ParameterError(
            "resolution", f"{resolution:g} m", f"a pitch of {pitch:g} m over four times a whole number, such as {nearest}", "m"
        )
    return order


@dataclass(frozen=True, eq=False)
class Counts:
    """A position in counts.

    Parameters
    ----------
    counts : ndarray of int (n,)
        The first lies within half a pitch of zero.
    missed : ndarray of bool (n,)
        Samples at which whole pitches may be lost.
    """

    counts: Index
    missed: Flags


class SinusoidTable:
    """Sinusoids of a higher order from two signals, by quadrant and ratio: no arctangent, no sine.

    The smaller magnitude of the two signals over the larger is the tangent of an angle between 0 and 45 degrees. A table over this ratio
    holds cos(n phi) and sin(n phi) of that octant, and the number of preceding zero crossings. The octant follows from the signs of the
    signals and from which one is larger. The amplitude cancels in the ratio.

    Parameters
    ----------
    order : int, 1 to 100 000
        n. A pitch has 4 n counts.
    entries : int, optional
        Intervals of the table; 64 n by default.

    Notes
    -----
    sin(n phi) = sin(phi) U_{n-1}(cos phi) with the Chebyshev polynomials of the second kind: the signal of higher order depends only on
    the two measured signals, so a table can hold it.
    """

    def __init__(self, order: int, entries: int | None = None) -> None:
        refuse(not 1 <= order <= HIGHEST, ParameterError, "order", order, f"1 to {HIGHEST}")
        self.order = int(order)
        self.entries = max(ENTRIES * self.order, 1024) if entries is None else int(entries)
        refuse(self.entries < 4 * self.order, ParameterError, "entries", self.entries, f"at least four for each order, {4 * self.order}")
        angle = np.arctan(np.arange(self.entries + 2) / self.entries)
        self._cosine, self._sine = np.cos(self.order * angle), np.sin(self.order * angle)
        self._turns = angle / (2.0 * np.pi)
        self._crossings = np.rint(self.order * angle * (2.0 / np.pi)).astype(np.int64)

    def sinusoids(self, u1: ArrayLike, u2: ArrayLike) -> tuple[Array, Array]:
        """Return cos(n phi) and sin(n phi) (n,) of corrected signals (n,) with phi = arctan(u2/u1)."""
        i, part, (beyond, behind, below) = self._place(u1, u2)
        cosine, sine = ((1.0 - part) * t[i] + part * t[i + 1] for t in (self._cosine, self._sine))
        # Beyond 45 degrees, phi = 90 degrees - angle; for u1 < 0, 180 degrees - phi; for u2 < 0, -phi.
        turned_cosine, turned_sine = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[self.order % 4]
        c = np.where(beyond, turned_cosine * cosine + turned_sine * sine, cosine)
        s = np.where(beyond, turned_sine * cosine - turned_cosine * sine, sine)
        half = -1.0 if self.order % 2 else 1.0
        c, s = np.where(behind, half * c, c), np.where(behind, -half * s, s)
        return c, np.where(below, -s, s)

    def in_period(self, u1: ArrayLike, u2: ArrayLike) -> Index:
        """Return the count (n,) within the period, -2 n to 2 n: round(4 n phi/(2 pi)) for phi from -pi to pi.

        The table gives the count to within one. The sum and difference of the sinusoids of higher order cross zero half-way between two
        counts; their signs select the count.
        """
        i, _, octant = self._place(u1, u2)
        coarse = _unfolded(self._crossings[i], self.order, octant)
        return np.asarray(coarse + (quadrant(*self.sinusoids(u1, u2)) - coarse + 1) % 4 - 1, dtype=np.int64)

    def turns(self, u1: ArrayLike, u2: ArrayLike) -> Array:
        """Return the angle (n,) in turns, -1/2 to 1/2, to 1e-5 of a count."""
        i, part, octant = self._place(u1, u2)
        angle: Array = _unfolded((1.0 - part) * self._turns[i] + part * self._turns[i + 1], 0.25, octant)
        return angle

    def count(self, u1: ArrayLike, u2: ArrayLike) -> Counts:
        """Count corrected signals (n,): within the period by the table, across periods by the shorter way round."""
        periods, missed = period_count(self.turns(u1, u2))
        return Counts(self.in_period(u1, u2) + 4 * self.order * periods, missed)

    def _place(self, u1: ArrayLike, u2: ArrayLike) -> tuple[Index, Array, tuple[Flags, Flags, Flags]]:
        """Return interval, place in it, and octant: whether phi is beyond 45 degrees, and which signals are negative."""
        first, second = (np.asarray(u, dtype=np.float64) for u in (u1, u2))
        along, across = np.abs(first), np.abs(second)
        ratio = self.entries * np.minimum(along, across) / np.maximum(np.maximum(along, across), np.finfo(float).tiny)
        i = ratio.astype(np.int64)
        return i, ratio - i, (across > along, first < 0.0, second < 0.0)


def _unfolded(angle: Any, quarter: float, octant: tuple[Flags, Flags, Flags]) -> Any:
    """Return an angle of the first octant in its own octant; `quarter` is that of a quarter of a turn."""
    beyond, behind, below = octant
    angle = np.where(beyond, quarter - angle, angle)
    angle = np.where(behind, 2 * quarter - angle, angle)
    return np.where(below, -angle, angle)


def quadrant(cosine: Array, sine: Array) -> Index:
    """Return the quadrant of the sinusoids, 0 to 3, each centred on an axis."""
    up, right = sine + cosine > 0.0, cosine - sine > 0.0
    return np.where(up, np.where(right, 0, 1), np.where(right, 3, 2)).astype(np.int64)


def period_count(turns: ArrayLike) -> tuple[Index, Flags]:
    """Count whole periods, taking the shorter way round from one sample to the next.

    Parameters
    ----------
    turns : array_like (n,)
        Angle of the signals, -1/2 to 1/2.

    Returns
    -------
    periods : ndarray of int (n,)
        From 0 at the first sample.
    missed : ndarray of bool (n,)
        Samples at which whole periods may have been lost.

    Notes
    -----
    Correct while the axis moves less than half a pitch per sample. A faster axis seems to move the other way. Only the sample at which it
    becomes too fast is detected, by a jump of the apparent speed by more than half a pitch per sample. An axis that is too fast from the
    start is not detected.
    """
    angle = np.asarray(turns, dtype=np.float64)
    step = np.diff(angle, prepend=angle[:1])
    back = np.rint(step)
    return np.cumsum(-back).astype(np.int64), np.abs(np.diff(step - back, prepend=0.0)) > 0.5


FEWEST = 16
"""Smallest number of samples of a fit, and number of sectors that must each contain one."""
ROUNDEST = 0.2
"""Largest scatter (rms, over the radius) of points about a fitted ellipse."""
SINGULAR = 1e12
ORDERS = 8


@dataclass(frozen=True)
class QuadratureConstants:
    """Errors of two signals: u1d = u1 + p, u2d = (u2 cos al - u1 sin al)/r + q, for u1 = R cos phi, u2 = R sin phi.

    Parameters
    ----------
    offset_1, offset_2 : float
        p and q, in the unit of the signals.
    ratio : float, > 0
        Amplitude of the first signal over that of the second, r.
    phase_error : float [rad], within +-pi/2
        al.
    amplitude : float, > 0
        Of the first signal, R.

    Raises
    ------
    ParameterError
        If a value is out of its range.
    """

    offset_1: float = 0.0
    offset_2: float = 0.0
    ratio: float = 1.0
    phase_error: float = 0.0
    amplitude: float = 1.0

    def __post_init__(self) -> None:
        for name in ("ratio", "amplitude"):
            if not 0.0 < getattr(self, name) < math.inf:
                raise ParameterError(name, getattr(self, name), "> 0 and finite")
        if not abs(self.phase_error) < 0.5 * math.pi:
            raise ParameterError("phase_error", self.phase_error, "within a quarter of a turn", "rad")
        for name in ("offset_1", "offset_2"):
            if not math.isfinite(getattr(self, name)):
                raise ParameterError(name, getattr(self, name), "finite")

    @classmethod
    def from_coefficients(cls, a: float, b: float, c: float, d: float, e: float) -> QuadratureConstants:
        """Return the constants of the ellipse A u1d^2 + B u2d^2 + C u1d u2d + D u1d + E u2d = 1 (Heydemann).

        Raises
        ------
        ParameterError
            If the coefficients do not describe an ellipse.
        """
        if not (4.0 * a * b > c * c and math.isfinite(a * b)):
            raise ParameterError("A, B, C", f"{a:g}, {b:g}, {c:g}", "those of an ellipse, 4 A B > C^2")
        ratio = math.sqrt(b / a)
        # Not C/sqrt(4 A B): all coefficients are negative if the origin lies outside the ellipse.
        sine = c / (2.0 * a * ratio)
        scale = 1.0 / (c * c - 4.0 * a * b)
        p, q = (2.0 * b * d - e * c) * scale, (2.0 * a * e - d * c) * scale
        square = (1.0 / a + p * p + (ratio * q) ** 2 + 2.0 * ratio * sine * p * q) / (1.0 - sine * sine)
        refuse(not square > 0.0, ParameterError, "A .. E", f"{a:g}, {b:g}, {c:g}, {d:g}, {e:g}", "those of an ellipse with points on it")
        return cls(p, q, ratio, math.asin(sine), math.sqrt(square))

    def coefficients(self) -> tuple[float, float, float, float, float]:
        """Return A .. E of the ellipse of the signals; they are infinite if it passes through the origin."""
        with np.errstate(divide="ignore"):
            coefficients = ellipse(self.offset_1, self.offset_2, self.ratio, math.sin(self.phase_error), np.float64(self.amplitude))
        a, b, c, d, e = (float(value) for value in coefficients)
        return a, b, c, d, e

    def distorted(self, phase: ArrayLike) -> tuple[Array, Array]:
        """Return the two signals at phases (n,) [rad]."""
        angle = np.asarray(phase, dtype=np.float64)
        u1 = self.amplitude * np.cos(angle)
        # u2 cos al - u1 sin al is R sin(phi - al).
        return u1 + self.offset_1, self.amplitude * np.sin(angle - self.phase_error) / self.ratio + self.offset_2

    def corrected(self, u1: ArrayLike, u2: ArrayLike) -> tuple[Array, Array]:
        """Return the corrected signals (n,), on a circle of the same amplitude."""
        first = np.asarray(u1, dtype=np.float64) - self.offset_1
        second = self.ratio * (np.asarray(u2, dtype=np.float64) - self.offset_2)
        return first, (first * math.sin(self.phase_error) + second) / math.cos(self.phase_error)

    def error_without(self, phase: ArrayLike) -> Array:
        """Return the angle error [rad] of the uncorrected signals at phases (n,) [rad].

        To first order, for offsets p and q: (q cos phi - p sin phi)/R; for ratio and phase error: -(r - 1)/2 sin 2 phi - al cos^2 phi.
        """
        angle = np.asarray(phase, dtype=np.float64)
        u1, u2 = self.distorted(angle)
        off = np.arctan2(u2, u1) - angle
        return np.asarray(off - 2.0 * np.pi * np.rint(off / (2.0 * np.pi)), dtype=np.float64)


@dataclass(frozen=True)
class EllipseFit:
    """A fit to all samples.

    Parameters
    ----------
    scatter : float
        Distance of the corrected points from their circle, rms over the radius: noise, converter steps and harmonics.
    """

    constants: QuadratureConstants
    scatter: float


def fit_ellipse(u1: ArrayLike, u2: ArrayLike) -> EllipseFit:
    """Fit the ellipse of Heydemann to two signals, by least squares over all samples.

    Parameters
    ----------
    u1, u2 : array_like (n,)
        At least 16 samples, from the whole ellipse.

    Raises
    ------
    ParameterError
        If there are too few samples, a value is not finite, the signals do not change, or the points do not cover a whole ellipse.

    Notes
    -----
    The fit minimises algebraic distances: noise of relative size sigma biases the constants by the order of sigma^2.
    """
    first, second = _two_records(u1, u2, FEWEST)
    # Centred and scaled, so that offset and unit do not affect the conditioning.
    middle, half = [], []
    for name, values in (("u1", first), ("u2", second)):
        if not np.isfinite(values).all():
            raise ParameterError(name, f"not finite at sample {int(np.argmin(np.isfinite(values)))}", "finite everywhere")
        low, high = float(values.min()), float(values.max())
        middle.append(0.5 * (low + high))
        half.append(0.5 * (high - low))
        if half[-1] <= 1e-9 * max(abs(low), abs(high)):
            raise ParameterError(name, f"{values[0]:g} throughout", "a signal that moves: the axis stands still")
    inner = QuadratureConstants.from_coefficients(*_solved((first - middle[0]) / half[0], (second - middle[1]) / half[1]))
    offsets = middle[0] + half[0] * inner.offset_1, middle[1] + half[1] * inner.offset_2
    constants = QuadratureConstants(*offsets, inner.ratio * half[0] / half[1], inner.phase_error, inner.amplitude * half[0])
    return _judged(constants, first, second)


def _two_records(u1: ArrayLike, u2: ArrayLike, fewest: int) -> tuple[Array, Array]:
    first, second = (np.asarray(u, dtype=np.float64) for u in (u1, u2))
    if first.ndim != 1 or first.shape != second.shape or first.size < fewest:
        raise ParameterError("signals", f"{first.shape} and {second.shape}", f"two records of one length, at least {fewest} samples")
    return first, second


def _solved(x: Array, y: Array) -> tuple[float, ...]:
    """Return A .. E by least squares; summed block by block to save memory."""
    gram, right = np.zeros((5, 5)), np.zeros(5)
    for start in range(0, x.size, BLOCK):
        a, b = x[start : start + BLOCK], y[start : start + BLOCK]
        rows = np.stack([a * a, b * b, a * b, a, b])
        gram += rows @ rows.T
        right += rows.sum(axis=1)
    if not np.linalg.cond(gram) < SINGULAR:
        raise ParameterError("signals", "points on a line or a short arc", "from all round an ellipse: the axis has to move a pitch")
    return tuple(float(value) for value in np.linalg.solve(gram, right))


def _judged(constants: QuadratureConstants, first: Array, second: Array) -> EllipseFit:
    """Return the fit if the points form a whole ellipse."""
    c1, c2 = constants.corrected(first, second)
    scatter = float(np.sqrt(np.mean((np.hypot(c1, c2) / constants.amplitude - 1.0) ** 2)))
    if scatter > ROUNDEST:
        shown = f"{100.0 * scatter:.0f} % of the radius"
        raise ParameterError("scatter round the fitted ellipse", shown, f"below {100.0 * ROUNDEST:.0f} %: the signals are no ellipse")
    sector = np.floor((np.arctan2(c2, c1) / (2.0 * np.pi) + 0.5) * FEWEST).astype(np.int64)
    covered = np.unique(np.clip(sector, 0, FEWEST - 1)).size / FEWEST
    if covered < 1.0:
        shown = f"{100.0 * covered:.0f} % of the circle"
        raise ParameterError("signals", shown, "from all round it: the axis has to move a pitch or more, at changing phases")
    return EllipseFit(constants, scatter)


@dataclass(frozen=True)
class Subdivisional:
    """Errors of position that repeat with every pitch.

    Parameters
    ----------
    peak : float [m]
        Of the sum of the harmonics.
    orders : tuple of float [m]
        Amplitude of each harmonic, from once per pitch on.
    rest : float [m]
        Rms of the remaining error: noise, counts, slow errors of the scale beyond a straight line.
    """

    peak: float
    orders: tuple[float, ...]
    rest: float


def subdivisional_error(position_error: ArrayLike, phase: ArrayLike) -> Subdivisional:
    """Return the error of position that repeats with every pitch.

    Parameters
    ----------
    position_error : array_like (n,) [m]
        Measured minus true position. A constant and a straight line over the travel (mounting, temperature) are removed.
    phase : array_like (n,) [rad]
        True phase, unwrapped: 2 pi x/pitch.

    Raises
    ------
    ParameterError
        If the travel is less than two pitches, or there are fewer than four samples for each unknown.
    """
    error, angle = (np.asarray(values, dtype=np.float64) for values in (position_error, phase))
    n_unknown, orders = 2 * ORDERS + 2, range(1, ORDERS + 1)
    if error.shape != angle.shape or error.size < 4 * n_unknown:
        raise ParameterError("samples", error.size, f"one phase for each error, at least {4 * n_unknown}")
    travel = float(np.ptp(angle)) / (2.0 * np.pi)
    refuse(travel < 2.0, ParameterError, "travel", f"{travel:.3g} pitches", "at least 2, to separate what repeats")
    middle = 0.5 * (float(angle.min()) + float(angle.max()))
    gram, right = np.zeros((n_unknown, n_unknown)), np.zeros(n_unknown)

    def rows(part: slice) -> Array:
        a = angle[part]
        return np.stack([np.ones_like(a), (a - middle) / travel, *[wave(k * a) for k in orders for wave in (np.cos, np.sin)]])

    parts = [slice(start, start + BLOCK) for start in range(0, error.size, BLOCK)]
    for part in parts:
        w = rows(part)
        gram += w @ w.T
        right += w @ error[part]
    weights = np.linalg.lstsq(gram, right, rcond=None)[0]
    square = sum(float(np.sum((error[part] - weights @ rows(part)) ** 2)) for part in parts)
    turn = np.linspace(0.0, 2.0 * np.pi, 2049)
    sums = sum(weights[2 * k] * np.cos(k * turn) + weights[2 * k + 1] * np.sin(k * turn) for k in orders)
    amplitudes = tuple(float(np.hypot(weights[2 * k], weights[2 * k + 1])) for k in orders)
    return Subdivisional(float(np.abs(sums).max()), amplitudes, math.sqrt(square / error.size))


@dataclass(frozen=True, eq=False)
class Tracked:
    """Signals corrected on line.

    Parameters
    ----------
    u1, u2 : ndarray (n,)
        Corrected, over the nominal amplitude.
    sample : ndarray of int (m,)
        Samples at which the fit is stored.
    coefficients : ndarray (m, 5)
        A .. E at these samples, of the signals over the nominal amplitude.
    amplitude : float
        Nominal amplitude.
    updated : ndarray of bool (n,)
        Samples that updated the fit.
    """

    u1: Array
    u2: Array
    sample: Index
    coefficients: Array
    amplitude: float
    updated: Flags

    def constants(self, index: int = -1) -> QuadratureConstants:
        """Return the constants at one of the stored samples, the last by default, in the unit of the signals."""
        relative = QuadratureConstants.from_coefficients(*(float(value) for value in self.coefficients[index]))
        scaled = {name: getattr(relative, name) * self.amplitude for name in ("offset_1", "offset_2", "amplitude")}
        return replace(relative, **scaled)


def _track(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    states, (u1, u2) = followed(par, x, inp.u1 / par.amplitude, inp.u2 / par.amplitude, x.turns)
    return states, (u1, u2, states[4], states[3])


def track_ellipse(
    u1: ArrayLike,
    u2: ArrayLike,
    start: QuadratureConstants,
    *,
    forgetting: float = 0.998,
    initial_covariance: float = 10.0,
    update_travel: float = 1.0 / 32.0,
    n_kept: int = 1024,
) -> Tracked:
    """Correct signals sample by sample, as a controller does: recursive least squares with forgetting and covariance resetting.

    Parameters
    ----------
    u1, u2 : array_like (n,)
        Measured and finite; each sample is corrected with the fit before it.
    start : QuadratureConstants
        Initial constants; their amplitude is the nominal amplitude.
    forgetting : float, 0.9 to 1
        lambda, per update; 0.995 to 0.9995 is usual. The memory is 1/(1 - lambda) updates.
    initial_covariance : float, >= 40 (1 - lambda)
        Of each coefficient, over the squared noise. Greater values give the initial constants less weight.
    update_travel : float, > 0
        Travel between two updates, in pitches. An axis at rest, or oscillating within a pitch, causes no updates.
    n_kept : int, >= 2
        Largest number of samples at which the coefficients are stored.

    Raises
    ------
    ParameterError
        If a parameter is out of range.
    """
    first, second = _two_records(u1, u2, 1)
    for name, value, low, high in (
        ("forgetting", forgetting, 0.9, 1.0),
        ("initial_covariance", initial_covariance, LEAST_COVARIANCE * (1.0 - forgetting), 1e6),
        ("update_travel", update_travel, 1e-4, 10.0),
        ("n_kept", n_kept, 2, 1 << 30),
    ):
        refuse(not low <= value <= high, ParameterError, name, value, f"from {low:g} to {high:g}")
    size, n = start.amplitude, first.size
    theta = replace(start, offset_1=start.offset_1 / size, offset_2=start.offset_2 / size, amplitude=1.0).coefficients()
    parameters = dict(zip((*DERIVED, *TUNING, "amplitude"), (*theta, forgetting, initial_covariance, update_travel, size), strict=True))
    inputs, outputs = ports("u1", "u2"), (*ports("u1", "u2"), Port("theta", 5), Port("used"))
    step = Step("quadrature", _track, ("amplitude", *TUNING, *DERIVED), TABLES, "", STATES, inputs, outputs)
    node = Node("fit", step, {"u1": "in.u1", "u2": "in.u2"}, parameters, {"arctangent": arctangents()})
    schedule = Schedule((node,), inputs, 1.0, 1)
    group, row = make_group(schedule, 1, slice(0, 1), jit=jit_enabled()), schedule.row("fit.u1")
    chosen = np.unique(np.linspace(0, n - 1, min(n, n_kept)).astype(np.int64))
    out, kept = np.empty((3, n)), []
    for at in range(0, n, BLOCK):
        part = slice(at, min(at + BLOCK, n))
        log = group.run(np.column_stack([first[part], second[part]]), list(range(row, row + 8)))[:, :, 0]
        out[:, part] = log[:, [0, 1, 7]].T
        kept.append(log[chosen[(chosen >= at) & (chosen < part.stop)] - at, 2:7])
    # The position of the last update changes with each update; the first sample is an update.
    return Tracked(out[0], out[1], chosen, np.concatenate(kept), size, np.diff(out[2], prepend=np.nan) != 0.0)
