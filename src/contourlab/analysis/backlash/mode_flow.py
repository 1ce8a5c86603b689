"""The three modes of a loop with a gap (contact below, gap, contact above), each propagated exactly up to its end.

The state is extended by the twist of a damped shaft in the gap and by a constant 1: each mode is then w' = M w, solved by a matrix
exponential. The end of a mode is found on a Chebyshev interpolant of its guard. A chunk of time is halved until the interpolant is exact to
rounding, so that no crossing and no pair of crossings is missed. The instant is then refined on the exponential itself.

`spans` strings the modes together: an exact simulation, with mode changes located to rounding.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.backlash.lure import BacklashLoop, dead_zone
from contourlab.arrays import Array, Index
from contourlab.errors import ParameterError

DEGREE = 18
"""Degree of the Taylor polynomial, used up to a norm of 1: the remainder is 1/19! = 8e-18."""


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
    t = np.asarray(times, dtype=float)
    scaled = matrix * t[..., None, None]
    norm = float(np.abs(scaled).sum(axis=-1).max(initial=0.0))
    halvings = max(0, int(np.ceil(np.log2(max(norm, 1e-300)))))
    scaled = scaled * 2.0**-halvings
    # Horner's rule for exp(X) - 1 = X (1 + X/2 (1 + X/3 (...))).
    eye = np.eye(len(matrix))
    inner = np.broadcast_to(eye, scaled.shape)
    for k in range(DEGREE, 1, -1):
        inner = eye + scaled @ inner / k
    less_one = scaled @ inner
    # Overflow gives inf or nan: the caller detects the divergence.
    with np.errstate(over="ignore", invalid="ignore"):
        for _ in range(halvings):
            less_one = 2.0 * less_one + less_one @ less_one
    return np.asarray(eye + less_one)


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
        self._chunks: dict[tuple[int, int], tuple[Array, Array]] = {}

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
        m[:n, -1] = loop.reference_input_in(mode == GAP)[:, 0] * self.reference
        m[:n] -= np.outer(loop.b, self.torque_row(mode))
        if self.twisted:
            m[n] = self.difference_rate if mode != GAP else 0.0
            m[n, n] = -loop.stiffness / loop.shaft_damping if mode == GAP else m[n, n]
        return m

    def _guards(self, mode: int) -> tuple[tuple[Array, int], ...]:
        """Return rows that rise through 0 where the mode ends, each with the mode that follows."""
        if mode != GAP:
            return ((-mode * self.torque_row(mode), GAP),)
        return tuple((self._reach(side), side) for side in (BELOW, ABOVE))

    def _reach(self, side: int) -> Array:
        """Return the row of side (theta_d - twist) - h."""
        row = side * self.difference
        if self.twisted:
            row[self.n] -= side
        row[-1] -= self.loop.half_gap
        return row

    def exponential(self, mode: int, time: float) -> Array:
        """Return exp(M t)."""
        return self.exponentials(mode, np.array(time))

    def exponentials(self, mode: int, times: Array) -> Array:
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
            propagator, samples = self._chunk(mode, level)
            with np.errstate(over="ignore", invalid="ignore"):
                coefficients = samples @ w @ _TO_CHEBYSHEV.T
                floor = 8.0 * ROUNDING * (np.abs(samples).max(axis=1) @ np.abs(w))
                noise = 1e-12 * np.abs(coefficients).max(axis=1) + floor
                smooth = np.abs(coefficients[:, -3:]).max(axis=1) <= noise
            if level >= DEEPEST or (smooth.all() and np.isfinite(coefficients).all() and np.isfinite(propagator).all()):
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
        for _ in range(4):
            there = self.exponential(mode, at) @ w
            slope = float(row @ self.matrices[mode] @ there)
            step = float(row @ there) / slope if slope > 0.0 else 0.0
            if abs(step) > 1e-3 * span:
                break
            at -= step
            if abs(step) <= 4.0 * ROUNDING * at:
                break
        return at

    def _chunk(self, mode: int, level: int) -> tuple[Array, Array]:
        """Return exp(M d), and rows (n_guard, NODES, n_w) of the guards at the nodes, for d = unit 2^-level."""
        key = mode, level
        if key not in self._chunks:
            span = self.unit * 2.0**-level
            steps = self.exponentials(mode, 0.5 * span * (_PLACES + 1.0))
            rows = np.array([row for row, _ in self.guards[mode]])
            self._chunks[key] = self.exponential(mode, span), np.einsum("gi,kij->gkj", rows, steps)
        return self._chunks[key]


def _rises(series: Array, noise: float) -> list[float]:
    """Return where a Chebyshev series rises through 0 on [-1, 1], in order; rises that end below `noise` do not count."""
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
        lengthened[at] = flow.exponentials(motion[i].mode, t[at] - motion[i].time) @ motion[i].start
    return lengthened, modes[index]
