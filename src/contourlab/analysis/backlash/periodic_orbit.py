"""Exact motion of a loop with a gap, and its periodic orbits.

The loop has three modes: contact below, gap, contact above. The state is extended by the twist of a damped shaft in the gap and by a
constant 1: each mode is then w' = M w, solved by a matrix exponential. The end of a mode is found on a Chebyshev interpolant of its guard.
A chunk of time is halved until the interpolant is exact to rounding, so that no crossing and no pair of crossings is missed. The instant is
then refined on the exponential itself. `spans` strings the modes together: an exact simulation, with mode changes located to rounding.

Orbits come from a search for starts and shooting by Newton's method, with Floquet multipliers. The sequence of modes is not assumed: each
shot follows the loop. Its Jacobian is the product of the modes' exponentials and of a saltation matrix at each change of mode.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import islice

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.backlash.lure import BacklashLoop, LimitCycle, dead_zone, predict_limit_cycles, quasi_linear
from contourlab.analysis.linear.tick_map import poles_of
from contourlab.arrays import Array, Complex, Index
from contourlab.errors import ParameterError
from contourlab.native.kernel import kernel

DEGREE = 18
"""Degree of the Taylor polynomial, used up to a norm of 1: the remainder is 1/19! = 8e-18."""
MOST_HALVINGS = 1100


def exponentials(matrix: Array, times: ArrayLike) -> Array:
    """Return exp(matrix t) at times t, accurate for slow rates next to fast ones.

    In the usual scaling and squaring, rounding errors of a slow mode grow with the fastest rate. Here exp(M t) - 1 is squared, so that a
    slow mode keeps its digits. No library call is used that would spread 6 x 6 products over threads.

    Parameters
    ----------
    matrix : ndarray (n, n)
    times : array_like (...,)

    Returns
    -------
    ndarray (..., n, n)

    References
    ----------
    Moler & Van Loan, Nineteen dubious ways to compute the exponential of a matrix, 2003, method 3.

    >>> exponentials(np.array([[0.0, 1.0], [0.0, 0.0]]), 3.0).tolist()
    [[1.0, 3.0], [0.0, 1.0]]
    """
    at, whole = np.asarray(times, dtype=float), np.ascontiguousarray(matrix, dtype=float)
    found = np.empty((at.size, *whole.shape))
    exponentiate(whole, at.ravel(), float(np.abs(whole).sum(axis=1).max()), found, np.empty((2, *whole.shape)))
    return found.reshape(*at.shape, *whole.shape)


@kernel("f8[:,:] f8[:] f8 f8[:,:,:] f8[:,:,:]")
def exponentiate(matrix, times, norm, found, memory):  # type: ignore[no-untyped-def]
    """Write exp(matrix t) at each time into `found`; `memory` (2, n, n) is for products."""
    n, scaled, product = matrix.shape[0], memory[0], memory[1]
    for k in range(times.size):
        power, part, halvings = found[k], times[k], 0
        # Overflow gives inf or nan: the caller detects the divergence.
        while norm * abs(part) > 1.0 and halvings < MOST_HALVINGS:
            part, halvings = 0.5 * part, halvings + 1
        for i, j in np.ndindex(n, n):
            scaled[i, j] = matrix[i, j] * part
            power[i, j] = scaled[i, j] / DEGREE
        # Horner's rule for exp(X) - 1 = X (1 + X/2 (1 + X/3 (...))), then the squares of exp(X): exp(2 X) - 1 = 2 Y + Y Y.
        for divisor in range(DEGREE - 1, -halvings, -1):
            for i, j in np.ndindex(n, n):
                total = scaled[i, j] if divisor > 0 else 2.0 * power[i, j]
                for m in range(n):
                    total += (scaled[i, m] if divisor > 0 else power[i, m]) * power[m, j]
                product[i, j] = total / max(divisor, 1)
            for i, j in np.ndindex(n, n):
                power[i, j] = product[i, j]
        for i in range(n):
            power[i, i] += 1.0


BELOW, GAP, ABOVE = -1, 0, 1
"""Contact with the motor behind, no contact, contact with the motor ahead of the load."""
NODES = 17
_PLACES = -np.cos(np.pi * np.arange(NODES) / (NODES - 1))
_TO_CHEBYSHEV = np.linalg.inv(np.polynomial.chebyshev.chebvander(_PLACES, NODES - 1))
"""From values at the places on [-1, 1] to Chebyshev coefficients."""
ROUNDING = float(np.finfo(float).eps)
DEEPEST = 60


class Flow:
    """Modes, guards and exact propagation of a loop.

    Parameters
    ----------
    reference : float
        Constant.
    """

    def __init__(self, loop: BacklashLoop, reference: float = 0.0) -> None:
        self.loop, self.reference = loop, reference
        self.twisted = loop.shaft_damping > 0.0
        self.n = loop.n
        self.size = loop.n + int(self.twisted) + 1
        self.matrices = {mode: self._matrix(mode) for mode in (BELOW, GAP, ABOVE)}
        self.guards = {mode: self._guards(mode) for mode in (BELOW, GAP, ABOVE)}
        self._chunks: dict[tuple[int, int], tuple[Array, Array, Array]] = {}

    @cached_property
    def unit(self) -> float:
        """Length of a chunk at level 0 [s]: 4 over the fastest rate of all modes."""
        rates = [np.abs(np.linalg.eigvals(matrix)).max() for matrix in self.matrices.values()]
        return 4.0 / max(float(max(rates)), 1e-300)

    def lengthened(self, x: Array, twist: float | None = None) -> tuple[Array, int]:
        """Return extended state w and mode of a start x (n,); `twist` is that of the shaft in the gap, relaxed by default."""
        loop = self.loop
        lag = float(dead_zone(loop.c @ x, loop.half_gap))
        if self.twisted and twist is not None:
            lag = twist
        w = np.concatenate([x, [lag] if self.twisted else [], [1.0]])
        reach = float(loop.c @ x) - lag
        for side in (BELOW, ABOVE):
            # At the edge of a dead zone there is no torque yet: the direction of motion decides.
            pushed = side * float(self.torque_row(side) @ w) > 0.0 or (not self.twisted and side * float(self.difference_rate @ w) > 0.0)
            if side * reach >= loop.half_gap * (1.0 - 1e-12) and pushed:
                return w, side
        return w, GAP

    @cached_property
    def difference(self) -> Array:
        """Row of theta_d on w."""
        row = np.zeros(self.size)
        row[: self.n] = self.loop.c
        return row

    @cached_property
    def difference_rate(self) -> Array:
        """Row of theta_d' on w."""
        row = np.zeros(self.size)
        row[: self.n] = self.loop.rate
        row[-1] = float(self.loop.c @ self.loop.reference_input[:, 0]) * self.reference
        return row

    def torque_row(self, mode: int) -> Array:
        """Row of the torque on w; zero in the gap."""
        row = np.zeros(self.size)
        if mode != GAP:
            row += self.loop.stiffness * self.difference + self.loop.shaft_damping * self.difference_rate
            row[-1] -= mode * self.loop.stiffness * self.loop.half_gap
        return row

    def _matrix(self, mode: int) -> Array:
        """Return M of w' = M w."""
        loop, n = self.loop, self.n
        m = np.zeros((self.size, self.size))
        m[:n, :n] = loop.a if mode == GAP or loop.contact_a is None else loop.contact_a
        m[:n, -1] = (loop.reference_input if mode == GAP or loop.contact_e is None else loop.contact_e)[:, 0] * self.reference
        m[:n] -= np.outer(loop.b, self.torque_row(mode))
        if self.twisted:
            m[n] = self.difference_rate if mode != GAP else 0.0
            m[n, n] = -loop.stiffness / loop.shaft_damping if mode == GAP else m[n, n]
        return m

    def _guards(self, mode: int) -> tuple[tuple[Array, int], ...]:
        """Return rows that rise through 0 where the mode ends, each with the mode that follows."""
        if mode != GAP:
            return ((-mode * self.torque_row(mode), GAP),)
        # A flank is reached where side (theta_d - twist) - h passes 0.
        reach = self.difference.copy()
        if self.twisted:
            reach[self.n] -= 1.0
        edge = self.loop.half_gap * np.eye(1, self.size, self.size - 1)[0]
        return tuple((side * reach - edge, side) for side in (BELOW, ABOVE))

    def exponential(self, mode: int, times: ArrayLike) -> Array:
        """Return exp(M t) at times (...,): (..., n_w, n_w)."""
        # Powers of 2 that balance the rows and columns cost no digit and save halvings.
        scale = self._scale
        balanced = self.matrices[mode] * scale / scale[:, None]
        with np.errstate(over="ignore", invalid="ignore"):
            return np.asarray(exponentials(balanced, times) * scale[:, None] / scale)

    @cached_property
    def _scale(self) -> Array:
        from scipy.linalg import matrix_balance

        sizes = np.abs(np.array(list(self.matrices.values()))).sum(axis=0)
        _, (scale, _) = matrix_balance(sizes, permute=False, separate=True)
        return np.asarray(scale, dtype=np.float64)

    def reset(self, mode: int, following: int) -> Array:
        """Return the map of w at a change of mode: a shaft that leaves contact keeps its twist."""
        change = np.eye(self.size)
        if self.twisted and mode != GAP and following == GAP:
            change[self.n] = self.difference
            change[self.n, -1] -= mode * self.loop.half_gap
        return change

    def advance(self, w: Array, mode: int, limit: float, level: int) -> tuple[float, Array, int | None, int]:
        """Propagate w over one chunk, or to the end of its mode, or to the limit.

        Returns
        -------
        time, w : time propagated, and the state there
        following : next mode, before `reset`; None if this one continues
        level : length for the next chunk, `unit` times 2^-level
        """
        level = max(level, int(np.ceil(np.log2(self.unit / limit))) - 1)
        while True:
            propagator, series, sizes = self._chunk(mode, level)
            with np.errstate(over="ignore", invalid="ignore"):
                coefficients = series @ w
                size = np.abs(coefficients)
                noise = 1e-12 * size.max(axis=1) + 8.0 * ROUNDING * (sizes @ np.abs(w))
            if level >= DEEPEST or ((size[:, -3:].max(axis=1) <= noise) & np.isfinite(noise)).all():
                break
            level += 1
        span = self.unit * 2.0**-level
        at, following = self._first(w, mode, coefficients, noise, span) or (span, None)
        if at > limit:
            return limit, self.exponential(mode, limit) @ w, None, level
        if following is None:
            return span, propagator @ w, None, level - 1
        return at, self.exponential(mode, at) @ w, following, level

    def _first(self, w: Array, mode: int, coefficients: Array, noise: Array, span: float) -> tuple[float, int] | None:
        """Return the first instant at which a guard rises through 0, with the mode that follows."""
        best: tuple[float, int] | None = None
        for (row, following), series, least in zip(self.guards[mode], coefficients, noise, strict=True):
            if abs(series[0]) > np.abs(series[1:]).sum():
                continue
            for place in _rises(series, least):
                at = self._polish(w, mode, row, 0.5 * span * (place + 1.0), span)
                # A mode may start on its own guard: a rise there that does not last is rounding.
                lasts = at > 1e-9 * self.unit or np.polynomial.chebyshev.chebval(min(place + 2e-3, 1.0), series) > 0.0
                if lasts and (best is None or at < best[0]):
                    best = at, following
                    break
        return best

    def _polish(self, w: Array, mode: int, row: Array, at: float, span: float) -> float:
        """Refine an instant on the exponential itself."""
        for _ in range(8):
            there = self.exponential(mode, at) @ w
            slope = float(row @ self.matrices[mode] @ there)
            step = float(row @ there) / slope if slope > 0.0 else 0.0
            if abs(step) > 0.05 * span:
                break
            at -= step
            if abs(step) <= 4.0 * ROUNDING * at:
                break
        return at

    def _chunk(self, mode: int, level: int) -> tuple[Array, Array, Array]:
        """Return exp(M d), Chebyshev series (n_guard, NODES, n_w) of the guards, and their sizes (n_guard, n_w), for d = unit 2^-level."""
        key = mode, level
        if key not in self._chunks:
            span = self.unit * 2.0**-level
            steps = self.exponential(mode, np.append(0.5 * span * (_PLACES + 1.0), span))
            with np.errstate(over="ignore", invalid="ignore"):
                samples = np.einsum("gi,kij->gkj", np.array([row for row, _ in self.guards[mode]]), steps[:-1])
                sizes = np.abs(samples).max(axis=1) if np.isfinite(steps).all() else np.full((len(samples), self.size), np.nan)
                self._chunks[key] = steps[-1], _TO_CHEBYSHEV @ samples, sizes
        return self._chunks[key]


CELLS = 32
CELL = math.pi / CELLS
_ORDERS = np.arange(NODES)
_EDGES = math.pi - CELL * np.arange(CELLS + 1)
"""Angles of places cos(angle) on [-1, 1]. Over the angle a Chebyshev series is a sum of cosines, whose derivatives have simple bounds."""
_AT_EDGES = np.cos(np.outer(_EDGES, _ORDERS))
_SLOPES = _ORDERS * np.sin(np.outer(_EDGES[:-1] - 0.5 * CELL, _ORDERS))
_FIRST_BEND = -(_ORDERS**2) * np.cos((math.pi - 0.5 * CELL) * _ORDERS)


def _rises(series: Array, noise: float) -> list[float]:
    """Return where a Chebyshev series rises through 0 on [-1, 1], in order; rises that end below `noise` do not count.

    If bounds on the series between a few places prove the first rise, only that one is returned, to about a hundredth.
    """
    size = np.abs(series)
    values, bend = _AT_EDGES @ series, float(_ORDERS**2 @ size)
    above, far = values > 0.0, np.abs(values) > max(0.125 * CELL**2 * bend, noise)
    one_way, rising = np.abs(_SLOPES @ series) > 0.5 * CELL * bend, ~above[:-1] & above[1:]
    unknown = ~((above[1:] == above[:-1]) & far[1:] & far[:-1]) & ~(one_way & ~rising)
    # At -1, where a mode starts on its own guard, the slope over the angle is 0.
    unknown[0] &= not _FIRST_BEND @ series < -0.5 * CELL * float(_ORDERS**3 @ size)
    if not unknown.any():
        return []
    first = int(np.argmax(unknown))
    if first and rising[first] and one_way[first] and far[first + 1]:
        return [math.cos(_EDGES[first] - CELL * values[first] / (values[first] - values[first + 1]))]
    return _all_rises(series, noise)


def _all_rises(series: Array, noise: float) -> list[float]:
    """Return the rises of `_rises` from all roots of the series."""
    from numpy.polynomial import chebyshev

    kept = np.trim_zeros(np.where(np.abs(series) > 1e-17 * np.abs(series).max(), series, 0.0), "b")
    if kept.size < 2:
        return []
    roots = chebyshev.chebroots(kept)
    places = np.sort(roots.real[(np.abs(roots.imag) < 1e-5) & (np.abs(roots.real) < 1.0 + 1e-9)]).clip(-1.0, 1.0)
    if not places.size:
        return []
    # Signs between neighbours separate a crossing from a touch.
    edges = np.concatenate([[-1.0], places, [1.0]])
    between = chebyshev.chebval(0.5 * (edges[:-1] + edges[1:]), kept)
    above = between > 0.0
    above[1:-1] &= between[1:-1] > noise
    return [float(places[i]) for i in range(places.size) if above[i + 1] and not above[i]]


RUNAWAY = 1e9
"""Largest state, over its start or the gap; beyond it a run has diverged."""


@dataclass(frozen=True, eq=False)
class Span:
    """A span of time in one mode: w' = M w from `start`, for `duration`."""

    time: float
    duration: float
    mode: int
    start: Array
    end: Array
    following: int | None
    """The next mode; None if the span ends without a mode change."""


def spans(flow: Flow, w: Array, mode: int, duration: float, most: int) -> Iterator[Span]:
    """Yield the spans of a motion that starts at `w` in `mode`.

    Raises
    ------
    ParameterError
        If the mode changes more than `most` times.
    """
    time, begun, origin, level = 0.0, 0.0, w, 0
    limit = RUNAWAY * max(float(np.abs(w).max()), flow.loop.half_gap)
    for _ in range(most):
        while True:
            step, w, following, level = flow.advance(w, mode, duration - time, level)
            time += step
            # The sum of the steps equals the duration up to rounding.
            done = duration - time <= 1e-15 * duration
            if following is not None or done or not np.abs(w).max() < limit:
                break
        yield Span(begun, time - begun, mode, origin, w, following)
        if done or following is None:
            return
        w, mode, begun = flow.reset(mode, following) @ w, following, time
        origin = w
    raise ParameterError("changes of mode", most, f"fewer within {duration:g} s: shorten the time or allow more")


def lengthened_at(flow: Flow, motion: Sequence[Span], time: ArrayLike) -> tuple[Array, Index]:
    """Return the lengthened states (n_time, size) of a motion at times (n_time,) [s] within it, and the modes."""
    starts, modes = np.array([span.time for span in motion]), np.array([span.mode for span in motion], dtype=np.int64)
    t = np.atleast_1d(np.asarray(time, dtype=float))
    index = np.searchsorted(starts, t, side="right") - 1
    lengthened = np.empty((t.size, flow.size))
    for i in np.unique(index):
        at = np.flatnonzero(index == i)
        lengthened[at] = flow.exponential(motion[i].mode, t[at] - motion[i].time) @ motion[i].start
    return lengthened, modes[index]


STEPS = 40
CLOSED = 1e-10
"""Largest distance between start and end of a closed orbit, over its size, state by state."""
MOST = 4000
SAMPLES = 2048


@dataclass(frozen=True, eq=False)
class PeriodicOrbit:
    """A periodic motion.

    Attributes
    ----------
    period : float [s]
    start : ndarray (n,)
        A state on it.
    amplitude : float
        Half of the range of the motor-load difference [rad or m].
    ratio : float
        Amplitude over half of the gap.
    multipliers : ndarray (m,) of complex
        Floquet multipliers by falling size, without the one at 1 along the orbit, and of states that change (see `poles_of`).
    """

    period: float
    start: Array
    amplitude: float
    ratio: float
    multipliers: Complex

    @property
    def frequency(self) -> float:
        """2 pi over the period [rad/s]."""
        return 2.0 * math.pi / self.period

    @property
    def stable(self) -> bool:
        """Whether neighbouring motions converge to the orbit."""
        return bool((np.abs(self.multipliers) < 1.0).all())


@dataclass(frozen=True, eq=False)
class Shot:
    """The end of a motion and its Jacobian with respect to the start."""

    start: Array
    end: Array
    jacobian: Array
    slope: Array
    """Velocity at the end."""
    motion: tuple[Span, ...]


class Shooter:
    """Shots of one loop from a state y: x, and the twist of a damped shaft."""

    def __init__(self, loop: BacklashLoop) -> None:
        self.flow = Flow(loop)
        self.n = loop.n + int(self.flow.twisted)

    def shot(self, y: Array, duration: float) -> Shot:
        """Return the end of a motion from y (n,) and its Jacobian (n, n)."""
        flow, x = self.flow, y[: self.flow.n]
        # The twist of a start is limited to what contact allows.
        d = float(flow.loop.c @ x)
        w, mode = flow.lengthened(x, float(np.clip(y[-1], d - flow.loop.half_gap, d + flow.loop.half_gap)) if flow.twisted else None)
        motion = tuple(spans(flow, w, mode, duration, MOST))
        if motion[-1].time + motion[-1].duration < duration * (1.0 - 1e-9):
            raise ParameterError("start", "a motion that runs away", "one that comes back")
        jacobian = np.eye(flow.size)
        for span in motion:
            jacobian = flow.exponential(span.mode, span.duration) @ jacobian
            if span.following is not None and span is not motion[-1]:
                jacobian = _saltation(flow, span.mode, span.following, span.end) @ jacobian
        last = motion[-1]
        slope = flow.matrices[last.mode] @ last.end
        end = last.end[: self.n].copy()
        if flow.twisted and last.mode != GAP:  # in contact the positions define the shaft's twist
            end[-1] = flow.loop.c @ end[: flow.n] - last.mode * flow.loop.half_gap
        return Shot(w[: self.n], end, jacobian[: self.n, : self.n], slope[: self.n], motion)


def _saltation(flow: Flow, mode: int, following: int, w: Array) -> Array:
    """Return the saltation matrix of a change of mode at w: small differences arrive at different times."""
    row = next(row for row, after in flow.guards[mode] if after == following)
    reset = flow.reset(mode, following)
    before = flow.matrices[mode] @ w
    jump = flow.matrices[following] @ reset @ w - reset @ before
    slope = float(row @ before)
    return np.asarray(reset + np.outer(jump, row) / slope) if slope > 0.0 else reset


def close_orbit(loop: BacklashLoop, start: ArrayLike, period: float, *, twist: float = 0.0) -> PeriodicOrbit | None:
    """Return the periodic orbit near a start, if Newton's steps lead to one.

    Parameters
    ----------
    start : array_like (n,)
        A state near the orbit.
    period : float [s]
        A guess.
    twist : float
        Twist of a damped shaft at the start.

    Returns
    -------
    PeriodicOrbit or None
        None if Newton's steps do not converge, or end at a point of rest.
    """
    shooter = Shooter(loop)
    y = np.asarray(start, dtype=float)
    y = np.append(y, twist) if shooter.flow.twisted else y
    try:
        closed = _newton(shooter, y, period)
    except (ParameterError, np.linalg.LinAlgError):
        return None
    return None if closed is None else _orbit(shooter, *_single_round(shooter, *closed))


def _newton(shooter: Shooter, y: Array, period: float) -> tuple[Shot, float] | None:
    """Return the closed shot near y, and its period."""
    first, shot = period, shooter.shot(y, period)
    size = _size(shot)
    for _ in range(STEPS):
        if np.abs((shot.end - shot.start) / size).max() <= CLOSED:
            return shot, period
        following = _damped(shooter, shot, period, *_step(shot, size), size)
        if following is None or not 0.2 * first < following[1] < 5.0 * first:
            return None
        shot, period = following
    return None


def _single_round(shooter: Shooter, shot: Shot, period: float) -> tuple[Shot, float]:
    """Return one round of an orbit, if it closed after several."""
    size = _size(shot)
    for rounds in range(9, 1, -1):
        once = shooter.shot(shot.start, period / rounds)
        if np.abs((once.end - once.start) / size).max() <= 1e3 * CLOSED:
            return once, period / rounds
    return shot, period


def _step(shot: Shot, size: Array) -> tuple[Array, float]:
    """Return Newton's step of the start and of the period; at right angles to the motion, since the phase is free."""
    n, scaled = len(size), shot.jacobian * size / size[:, None]
    missed, slope = (shot.end - shot.start) / size, shot.slope / size
    speed = max(float(np.linalg.norm(slope)), 1e-300)
    unit = slope / speed
    matrix = np.block([[scaled - np.eye(n), unit[:, None]], [unit[None, :], np.zeros((1, 1))]])
    solution = np.linalg.lstsq(matrix, np.append(-missed, 0.0), rcond=1e-13)[0]
    return solution[:n] * size, float(solution[n]) / speed


def _damped(shooter: Shooter, shot: Shot, period: float, step: Array, longer: float, size: Array) -> tuple[Shot, float] | None:
    """Return shot and period after the step, or after a part of it that reduces the distance between start and end; None if none does."""
    now = float(np.linalg.norm((shot.end - shot.start) / size))
    for part in (0.5 ** np.arange(14)).tolist():
        if 0.0 < period + part * longer < math.inf:
            tried = shooter.shot(shot.start + part * step, period + part * longer)
            gap = float(np.linalg.norm((tried.end - tried.start) / size))
            # At rounding level the distance may stay the same.
            if gap < now * (1.0 - 0.1 * part) or gap < CLOSED:
                return tried, period + part * longer
    return None


def _size(shot: Shot) -> Array:
    """Return the size of each state along a shot, for scaling."""
    largest = np.abs(np.array([span.start[: len(shot.start)] for span in shot.motion] + [shot.end])).max(axis=0)
    return np.asarray(np.maximum(largest, 1e-9 * largest.max()))


def _orbit(shooter: Shooter, shot: Shot, period: float) -> PeriodicOrbit | None:
    """Return a closed shot as an orbit, unless it is a point of rest."""
    loop = shooter.flow.loop
    states = lengthened_at(shooter.flow, shot.motion, np.linspace(0.0, period, SAMPLES + 1))[0]
    amplitude = _half_range(states[:, : loop.n] @ loop.c)
    if amplitude < loop.half_gap:
        return None
    multipliers = poles_of(shot.jacobian)
    multipliers = np.delete(multipliers, int(np.argmin(np.abs(multipliers - 1.0))))
    multipliers = multipliers[np.argsort(-np.abs(multipliers))]
    return PeriodicOrbit(period, shot.start[: loop.n], amplitude, amplitude / loop.half_gap, multipliers)


def _half_range(values: Array) -> float:
    """Return half of the range of a sampled period, its extremes taken from the parabola through three samples."""

    def top(v: Array) -> float:
        i = int(np.argmax(v[:-1]))
        before, here, after = float(v[i - 1 if i else -2]), float(v[i]), float(v[i + 1])
        bend = before - 2.0 * here + after
        return here if bend >= 0.0 else here - (after - before) ** 2 / (8.0 * bend)

    return 0.5 * (top(values) + top(-values))


KICKS = (1.5, 5.0, 30.0, 200.0)
"""Initial motor-load differences of simulated motions, over half of the gap."""
SETTLING, SETTLED = 60, 1000
"""Mode changes before a motion is tested for periodicity, at least and at most."""


def find_orbits(
    loop: BacklashLoop, *, prediction: Sequence[LimitCycle] | None = None, kicks: tuple[float, ...] = KICKS
) -> tuple[PeriodicOrbit, ...]:
    """Return the limit cycles of a loop at rest, by falling amplitude.

    Shooting starts from each prediction of the describing function, and from simulated motions that have settled.

    Parameters
    ----------
    prediction : sequence of LimitCycle, optional
        Of the describing function, if known; a loop that switches its controller has none.
    kicks : tuple of float
        Initial motor-load differences, over half of the gap, of the simulated motions.

    Notes
    -----
    An empty result does not prove that there is no orbit.
    """
    if prediction is None and loop.contact_a is None:
        prediction = predict_limit_cycles(loop)
    shots = []
    for cycle in prediction or ():
        # A state on the sinusoid of the quasi-linear loop, where the difference passes its peak.
        values, vectors = np.linalg.eig(quasi_linear(loop, cycle.ratio, cycle.frequency))
        vector = vectors[:, int(np.argmin(np.abs(values - 1j * cycle.frequency)))]
        shots.append(close_orbit(loop, (vector * (cycle.amplitude / (loop.c @ vector))).real, 2.0 * math.pi / cycle.frequency))
    shots += [_settled_orbit(loop, kick) for kick in kicks]
    orbits: list[PeriodicOrbit] = []
    for orbit in shots:
        if orbit is not None and not any(_same(orbit, other) for other in orbits):
            orbits.append(orbit)
    return tuple(sorted(orbits, key=lambda orbit: -orbit.amplitude))


def _settled_orbit(loop: BacklashLoop, kick: float) -> PeriodicOrbit | None:
    """Simulate a motion from `SETTLING` to `SETTLED` mode changes and shoot from its last contact; None at rest or in a runaway."""
    flow = Flow(loop)
    w, mode = flow.lengthened(kick * loop.half_gap * loop.c / float(loop.c @ loop.c), None)
    # At first 100 periods of the slowest oscillation in contact.
    poles = np.linalg.eigvals(loop.contact_matrix)
    ringing = poles.imag[poles.imag > 1e-6 * np.abs(poles).max()]
    slowest = float(ringing.min()) if ringing.size else float(np.abs(poles).min())
    duration = 100.0 * 2.0 * math.pi / max(slowest, 1e-300)
    for _ in range(10):
        motion = tuple(islice(spans(flow, w, mode, duration, SETTLED), SETTLED))
        last = motion[-1]
        if last.following is None and last.time + last.duration < duration * (1.0 - 1e-12):
            return None
        if len(motion) >= SETTLING:
            break
        duration *= 2.0
    contacts = [span for span in motion if span.mode == 1]
    return None if len(motion) < SETTLING or len(contacts) < 4 else _from_returns(loop, flow, contacts)


def _from_returns(loop: BacklashLoop, flow: Flow, contacts: Sequence[Span]) -> PeriodicOrbit | None:
    """Shoot from the last contact; the period is the time since the most recent similar contact."""
    states = np.array([span.start[: loop.n] for span in contacts])
    size = np.maximum(np.abs(states).max(axis=0), 1e-300)
    last = len(contacts) - 1
    best = min(range(max(0, last - 6), last), key=lambda i: (np.abs((states[i] - states[last]) / size).max() > 0.3, last - i))
    # Start half-way through a contact, away from the ends of the mode.
    span = contacts[last]
    middle = flow.exponential(span.mode, 0.5 * span.duration) @ span.start
    return close_orbit(loop, middle[: loop.n], span.time - contacts[best].time, twist=float(middle[loop.n]) if flow.twisted else 0.0)


def _same(orbit: PeriodicOrbit, other: PeriodicOrbit) -> bool:
    """Return whether two orbits are equal, or one is several rounds of the other."""
    rounds = orbit.period / other.period
    whole = max(round(rounds), 1) if rounds >= 1.0 else 1.0 / max(round(1.0 / rounds), 1)
    return abs(rounds / whole - 1.0) < 1e-6 and abs(orbit.amplitude / other.amplitude - 1.0) < 1e-5
