"""Exact periodic orbits of a loop with a gap: a search for starts, shooting by Newton's method, and Floquet multipliers.

The sequence of modes is not assumed: each shot follows the loop. Its Jacobian is the product of the modes' exponentials and of a saltation
matrix at each change of mode.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.backlash.limit_cycle_prediction import LimitCycle, predict_limit_cycles, quasi_linear
from contourlab.analysis.backlash.lure import BacklashLoop
from contourlab.analysis.backlash.mode_flow import GAP, Flow, Span, lengthened_at, spans
from contourlab.analysis.linear.tick_map import poles_of
from contourlab.arrays import Array, Complex
from contourlab.errors import ParameterError

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
        w, mode = flow.lengthened(x, self._twist(y))
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

    def _twist(self, y: Array) -> float | None:
        """Return the twist of a start, limited to what contact allows."""
        if not self.flow.twisted:
            return None
        loop, own = self.flow.loop, float(y[-1])
        d = float(loop.c @ y[: loop.n])
        return float(np.clip(own, d - loop.half_gap, d + loop.half_gap))


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
    first = period
    shot = shooter.shot(y, period)
    size = _size(shot)
    for _ in range(STEPS):
        missed = shot.end - shot.start
        if np.abs(missed / size).max() <= CLOSED:
            return shot, period
        step, longer = _step(shot, size)
        shot, period, better = _damped(shooter, shot, period, step, longer, size)
        if not better or not 0.2 * first < period < 5.0 * first:
            return None
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
    n = len(size)
    scaled = shot.jacobian * size / size[:, None]
    missed, slope = (shot.end - shot.start) / size, shot.slope / size
    unit = slope / max(float(np.linalg.norm(slope)), 1e-300)
    matrix = np.block([[scaled - np.eye(n), unit[:, None]], [unit[None, :], np.zeros((1, 1))]])
    solution = np.linalg.lstsq(matrix, np.append(-missed, 0.0), rcond=1e-13)[0]
    return solution[:n] * size, float(solution[n]) / max(float(np.linalg.norm(slope)), 1e-300)


def _damped(shooter: Shooter, shot: Shot, period: float, step: Array, longer: float, size: Array) -> tuple[Shot, float, bool]:
    """Take the step, or a part of it that reduces the distance between start and end; return whether that succeeded."""
    now = float(np.linalg.norm((shot.end - shot.start) / size))
    part = 1.0
    while part > 1e-4:
        if 0.0 < period + part * longer < math.inf:
            tried = shooter.shot(shot.start + part * step, period + part * longer)
            gap = float(np.linalg.norm((tried.end - tried.start) / size))
            # At rounding level the distance may stay the same.
            if gap < now * (1.0 - 0.1 * part) or gap < CLOSED:
                return tried, period + part * longer, True
        part *= 0.5
    return shot, period, False


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
        start = (vector * (cycle.amplitude / (loop.c @ vector))).real
        shots.append(close_orbit(loop, start, 2.0 * math.pi / cycle.frequency))
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
    earlier = range(max(0, last - 6), last)
    best = min(earlier, key=lambda i: (np.abs((states[i] - states[last]) / size).max() > 0.3, last - i))
    # Start half-way through a contact, away from the ends of the mode.
    span = contacts[last]
    middle = flow.exponential(span.mode, 0.5 * span.duration) @ span.start
    return close_orbit(loop, middle[: loop.n], span.time - contacts[best].time, twist=float(middle[loop.n]) if flow.twisted else 0.0)


def _same(orbit: PeriodicOrbit, other: PeriodicOrbit) -> bool:
    """Return whether two orbits are equal, or one is several rounds of the other."""
    rounds = orbit.period / other.period
    whole = max(round(rounds), 1) if rounds >= 1.0 else 1.0 / max(round(1.0 / rounds), 1)
    return abs(rounds / whole - 1.0) < 1e-6 and abs(orbit.amplitude / other.amplitude - 1.0) < 1e-5
