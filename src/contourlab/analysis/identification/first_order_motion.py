"""Motion of the first-order axis v' = -b v + a (u - friction) under a held command, exact between samples, sticking included.

While the axis moves in one direction the motion is linear: one filter call computes it. The instant of a stop within a sample has a closed
form; from there the axis moves on, turns, or sticks until the command exceeds its friction.

References
----------
Ghaffari & Ulsoy, "Component swapping modularity for distributed precision contouring", eqs (1) and (2), with Coulomb friction.
"""

from __future__ import annotations

import math

import numpy as np

from contourlab.arrays import Array

FIRST_PIECE = 64
"""Samples of the first block; doubled after each block without a stop."""


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
    n = command.size
    v, p = np.zeros(n), np.zeros(n)
    v[0] = start
    if forward == 0.0 and backward == 0.0:
        _glide(command, v, p, 0, n - 1, 0.0, _gains(damping, period))
        return v, p
    way = float(np.sign(start))
    gains = _gains(damping, period)
    k, piece = 0, FIRST_PIECE
    while k < n - 1:
        if way == 0.0:
            released = _released(command, k, forward, backward)
            p[k : released + 1] = p[k]
            if released == n:
                break
            k, way, piece = released, 1.0 if command[released] > forward else -1.0, FIRST_PIECE
            continue
        last = min(k + piece, n - 1)
        _glide(command, v, p, k, last, forward if way > 0.0 else -backward, gains)
        stops = np.flatnonzero(way * v[k + 1 : last + 1] < 0.0)
        if not stops.size:
            k, piece = last, 2 * piece
            continue
        k += int(stops[0])
        v[k + 1], gone, way = _turned(v[k], command[k], way, period, damping, (forward, backward))
        p[k + 1] = p[k] + gone
        v[k + 2 :] = 0.0
        k, piece = k + 1, FIRST_PIECE
    return v, p


def _released(command: Array, k: int, forward: float, backward: float) -> int:
    """Return the first sample from k on whose command moves an axis at rest; the number of samples if there is none."""
    n, piece = command.size, FIRST_PIECE
    while k < n:
        part = command[k : k + piece]
        moving = np.flatnonzero((part > forward) | (part < -backward))
        if moving.size:
            return k + int(moving[0])
        k, piece = k + piece, 2 * piece
    return n


def _turned(
    velocity: float, command: float, way: float, period: float, damping: float, friction: tuple[float, float]
) -> tuple[float, float, float]:
    """Return velocity, travel and direction after a sample in which the axis stops."""
    forward, backward = friction
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


def _glide(command: Array, v: Array, p: Array, k: int, last: int, held: float, gains: tuple[float, float, float]) -> None:
    """Compute the motion in one direction from sample k to `last`, into v and p."""
    from scipy.signal import lfilter

    left, gained, way = gains
    push = command[k:last] - held
    v[k + 1 : last + 1] = lfilter([gained], [1.0, -left], push, zi=np.array([left * v[k]]))[0]
    p[k + 1 : last + 1] = p[k] + np.cumsum(gained * v[k:last] + way * push)
