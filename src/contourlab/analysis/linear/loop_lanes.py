"""Whether the loops of many controllers hold with margins, in lanes: what a search asks of every candidate.

`sampled_loop` takes the exact margins of one loop; that is tens of milliseconds, too long for ten thousand candidates. Here one tick is run
from each unit of the state in 32 lanes at once, and a margin is a question to the closed loop: does it still hold when the command is
multiplied by a factor, or turned by an angle?
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.lane_maps import opened_lanes
from contourlab.analysis.linear.margins import Margins
from contourlab.analysis.linear.sampled_loop import INPUTS, SampledLoop, loop_of
from contourlab.analysis.linear.tick_map import TickMap
from contourlab.loop.machine import Axis, AxisController

Array = NDArray[np.float64]

class LaneLoops:
    """Opened loops x(k + 1) = A x(k) + B u(k), y(k) = C x(k + 1), one for each variant, as in `SampledLoop` but for what is cut only.

    Attributes
    ----------
    a : ndarray (n_variant, n, n)
    b : ndarray (n_variant, n, 2)
        Command that enters the drive, estimate that enters the controller.
    c : ndarray (n_variant, 2, n)
    """

    def __init__(self, a: Array, b: Array, c: Array) -> None:
        self.a, self.b, self.c = a, b, c

    def radius(self, factor: complex) -> Array:
        """Return the largest magnitude of the closed loop's poles (n_variant,) with the command multiplied by a factor.

        A complex factor of magnitude 1 turns the loop gain one way at positive frequencies and the other way at negative ones: it holds if
        the loop bears both a lag and a lead of that angle.
        """
        turned = np.array([factor, 1.0]).real if np.isreal(factor) else np.array([factor, 1.0])
        b = self.b * turned
        inner = np.eye(2) - self.c @ b
        closed = self.a + b @ np.linalg.solve(inner, self.c @ self.a)
        found = np.full(len(closed), math.inf)
        good = np.isfinite(closed).all(axis=(1, 2))
        if good.any():
            found[good] = np.abs(np.linalg.eigvals(closed[good])).max(axis=1, initial=0.0)
        return found


def margin_factors(gain: float, phase: float) -> tuple[complex, ...]:
    """Return the factors under which a loop with these margins still holds.

    Parameters
    ----------
    gain : float, >= 1
        Gain margin as a factor.
    phase : float [rad], >= 0

    Notes
    -----
    A margin asks that the loop holds all the way from 1 to there; only the ends are looked at, so the exact margins of what a search found
    are to be taken afterwards. Factors that are 1 are left out.
    """
    turned = complex(np.exp(-1j * phase))
    return (1.0, *((gain,) if gain > 1.0 else ()), *((turned,) if phase > 0.0 else ()))


def lane_loops(
    axis: Axis, controller: AxisController, servo_period: float, carried_mass: float, overrides: Mapping[str, Array]
) -> LaneLoops:
    """Return the opened loops of one axis under controllers that differ in numbers.

    Parameters
    ----------
    axis, controller, servo_period, carried_mass
        As of `contourlab.analysis.linear.sampled_loop.sampled_loop`.
    overrides : mapping of str to ndarray (n_variant,)
        Values [SI] by dotted names; those that have no part in the loop of this axis are passed over.

    Raises
    ------
    ComponentError
        If a step is not linear, or a delay is longer than its analysis takes.
    """
    _, _, schedule, a, b = opened_lanes(axis, controller, servo_period, overrides, carried_mass)
    b = b[:, :, [schedule.row(signal) for signal in INPUTS[:2]]]
    c = np.zeros((2, a.shape[1]))
    base = a.shape[1] - schedule.n_row
    c[0, base + schedule.row(f"{axis.name}.controller.command")] = 1.0
    if controller.observer is not None:
        c[1, base + schedule.row(f"{axis.name}.observer.disturbance_estimate")] = 1.0
    kept = _moving(a, b, c)
    # What is cut enters at the tick in which it leaves, so a command that nothing of the past moves still has to be kept.
    return LaneLoops(a[:, kept][:, :, kept], b[:, kept], np.broadcast_to(c[:, kept], (len(a), 2, kept.size)))


def _moving(a: Array, b: Array, c: Array) -> NDArray[np.int64]:
    """Return which entries are part of the loop: those that are read, and that something moves, in any variant."""
    moved = np.asarray((a != np.eye(a.shape[1])).any(axis=0))
    entered: NDArray[np.bool_] = np.asarray((b != 0.0).any(axis=(0, 2)))
    read: NDArray[np.bool_] = np.asarray(c.any(axis=0))
    kept = np.flatnonzero((moved.any(axis=1) | entered) & (moved.any(axis=0) | read))
    while True:
        part = np.asarray((a[:, kept][:, :, kept] != 0.0).any(axis=0))
        lives = (part.any(axis=1) | entered[kept]) & (part.any(axis=0) | read[kept])
        if lives.all():
            return kept
        kept = kept[lives]


def unstable_by(loops: LaneLoops, factors: Sequence[complex]) -> Array:
    """Return by how much (n_variant,) the largest pole lies outside the unit circle over some factors; negative where all hold."""
    return np.asarray(np.max([loops.radius(factor) for factor in factors], axis=0) - 1.0)


GRID = 200
"""Frequencies of `rough_margins`."""


def sampled_loops(
    axis: Axis, controller: AxisController, servo_period: float, columns: Mapping[str, Array], carried_mass: float = 0.0
) -> list[SampledLoop]:
    """Return the sampled loop of an axis for each of many sets of numbers.

    Parameters
    ----------
    axis, controller, servo_period, carried_mass
        As of `contourlab.analysis.linear.sampled_loop`.
    columns : mapping of str to ndarray (n,)
        Values [SI] by dotted names. Those that have no part in the loop of this axis are passed over.

    Raises
    ------
    ComponentError
        If a component is not linear, or a delay is longer than its analysis takes.
    """
    machine, made, schedule, a, b = opened_lanes(axis, controller, servo_period, columns, carried_mass)
    return [loop_of(machine, made, TickMap(mine, entered, schedule)) for mine, entered in zip(a, b, strict=True)]


def rough_margins(loop: SampledLoop) -> Margins:
    """Return margins read off a grid of frequencies, straight between its points: within a few tenths of a decibel and of a degree.

    Enough to lead a search; what it finds is to be held against `contourlab.analysis.SampledLoop.margins`.
    """
    nan = float("nan")
    if not loop.stable:
        return Margins(nan, nan, nan, nan, stable=False)
    w = np.geomspace(1e-4 * loop.nyquist, loop.nyquist, GRID)
    gain = loop.loop_gain(w)
    phase, crossover = _phase(w, gain)
    factor, where = _factor(w, gain)
    return Margins(factor, phase, crossover, float(np.abs(1.0 + gain).min()), True, where)


def _phase(w: Array, gain: NDArray[np.complex128]) -> tuple[float, float]:
    with np.errstate(divide="ignore"):
        size = np.log(np.abs(gain))
    at = np.flatnonzero(np.isfinite(size[:-1]) & np.isfinite(size[1:]) & (size[:-1] * size[1:] <= 0.0) & (size[:-1] != size[1:]))
    if not at.size:
        return float("inf"), float("nan")
    part = size[at] / (size[at] - size[at + 1])
    angle = np.angle(-gain[at]) + part * np.angle(gain[at + 1] / gain[at])
    angle = np.angle(np.exp(1j * angle))
    best = int(np.argmin(np.abs(angle)))
    return float(angle[best]), float(w[at[best]] * (w[at[best] + 1] / w[at[best]]) ** part[best])


def _factor(w: Array, gain: NDArray[np.complex128]) -> tuple[float, float]:
    at = np.flatnonzero(gain.imag[:-1] * gain.imag[1:] < 0.0)
    part = gain.imag[at] / (gain.imag[at] - gain.imag[at + 1])
    real, where = gain.real[at] + part * (gain.real[at + 1] - gain.real[at]), w[at] * (w[at + 1] / w[at]) ** part
    if abs(gain[-1].imag) <= 1e-9 * abs(gain[-1]):
        real, where = np.append(real, gain[-1].real), np.append(where, w[-1])
    inside = (real < 0.0) & (real > -1.0)
    if not inside.any():
        return float("inf"), float("nan")
    best = int(np.argmin(real[inside]))
    return float(-1.0 / real[inside][best]), float(where[inside][best])
