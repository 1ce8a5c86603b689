"""Sampled loops of many candidate controllers of one axis at once, for searches.

`sampled_loop` takes tens of milliseconds for one loop, too long for ten thousand candidates. Here the variants run in parallel lanes.
`sampled_loops` returns the loops; `lane_loops` only tests whether the closed loop is stable with its command multiplied by a factor, or
shifted in phase.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from contourlab.analysis.linear.margins import Margins
from contourlab.analysis.linear.sampled_loop import INPUTS, SampledLoop, bare_axis, loop_of, opened_schedule
from contourlab.analysis.linear.tick_map import TickMap, lane_matrices, live_states
from contourlab.arrays import Array, Complex, Flags
from contourlab.engine.schedule import Schedule
from contourlab.loop.batch import LANES
from contourlab.loop.machine import Axis, AxisController, Controller, Machine
from contourlab.loop.parameters import parameters_of
from contourlab.loop.simulate import jit_enabled

GRID = 200
"""Frequencies of `rough_margins`."""


class LaneLoops:
    """Open loops x(k + 1) = A x(k) + B u(k), y(k) = C x(k + 1), one for each variant, between the signals at the cuts.

    Attributes
    ----------
    a : ndarray (n_variant, n, n)
    b : ndarray (n_variant, n, 2)
        Command that enters the filters and the drive, estimate that enters the controller.
    c : ndarray (n_variant, 2, n)
    """

    def __init__(self, a: Array, b: Array, c: Array) -> None:
        self.a, self.b, self.c = a, b, c

    def radius(self, factor: complex) -> Array:
        """Return the largest magnitude of the closed loop's poles (n_variant,) with the command multiplied by a factor.

        A complex factor of magnitude 1 acts as a lag at positive frequencies and as a lead at negative ones, or the reverse: the loop is
        stable only if it tolerates both.
        """
        turned = np.array([factor, 1.0]).real if np.isreal(factor) else np.array([factor, 1.0])
        b = self.b * turned
        inner = np.eye(2) - self.c @ b
        closed = self.a + b @ np.linalg.solve(inner, self.c @ self.a)
        largest = np.full(len(closed), math.inf)
        finite = np.isfinite(closed).all(axis=(1, 2))
        if finite.any():
            largest[finite] = np.abs(np.linalg.eigvals(closed[finite])).max(axis=1, initial=0.0)
        return largest


def margin_factors(gain: float, phase: float) -> tuple[complex, ...]:
    """Return the factors under which a loop with these margins is stable.

    Parameters
    ----------
    gain : float, >= 1
        Gain margin as a factor.
    phase : float [rad], >= 0

    Notes
    -----
    Only the ends of each range are tested: compute exact margins for the result of a search. A gain of 1 or a phase of 0 adds no factor.
    """
    turned = complex(np.exp(-1j * phase))
    return (1.0, *((gain,) if gain > 1.0 else ()), *((turned,) if phase > 0.0 else ()))


def unstable_by(loops: LaneLoops, factors: Sequence[complex]) -> Array:
    """Return how far (n_variant,) the largest pole over some factors lies outside the unit circle; negative where all are stable."""
    return np.asarray(np.max([loops.radius(factor) for factor in factors], axis=0) - 1.0)


def lane_loops(
    axis: Axis, controller: AxisController, servo_period: float, carried_mass: float, overrides: Mapping[str, Array]
) -> LaneLoops:
    """Return the open loops of one axis for many sets of parameters.

    Parameters
    ----------
    axis, controller, servo_period, carried_mass
        As in `contourlab.analysis.linear.sampled_loop.sampled_loop`.
    overrides : mapping of str to ndarray (n_variant,)
        Values [SI] by dotted names; names outside the loop of this axis are ignored.

    Raises
    ------
    ComponentError
        If a step is not linear, or a delay is too long for the analysis.
    """
    _, _, schedule, a, b = _opened_lanes(axis, controller, servo_period, overrides, carried_mass)
    b = b[:, :, [schedule.row(signal) for signal in INPUTS[:2]]]
    c = np.zeros((2, a.shape[1]))
    base = a.shape[1] - schedule.n_row
    c[0, base + schedule.row(f"{axis.name}.controller.command")] = 1.0
    if controller.observer is not None:
        c[1, base + schedule.row(f"{axis.name}.observer.disturbance_estimate")] = 1.0
    moved = np.asarray((a != np.eye(a.shape[1])).any(axis=0))
    driven: Flags = np.asarray((b != 0.0).any(axis=(0, 2)))
    read: Flags = np.asarray(c.any(axis=0))
    kept = np.flatnonzero((moved.any(axis=1) | driven) & (moved.any(axis=0) | read))
    # A cut signal enters at the tick in which it leaves: keep a command even if no past state drives it.
    kept = kept[live_states((a[:, kept][:, :, kept] != 0.0).any(axis=0), driven[kept], read[kept])]
    return LaneLoops(a[:, kept][:, :, kept], b[:, kept], np.broadcast_to(c[:, kept], (len(a), 2, kept.size)))


def sampled_loops(
    axis: Axis, controller: AxisController, servo_period: float, columns: Mapping[str, Array], carried_mass: float = 0.0
) -> list[SampledLoop]:
    """Return the sampled loop of an axis for each of many sets of parameters.

    Parameters
    ----------
    axis, controller, servo_period, carried_mass
        As in `contourlab.analysis.linear.sampled_loop.sampled_loop`.
    columns : mapping of str to ndarray (n_variant,)
        Values [SI] by dotted names; names outside the loop of this axis are ignored.

    Raises
    ------
    ComponentError
        If a step is not linear, or a delay is too long for the analysis.
    """
    machine, bare, schedule, a, b = _opened_lanes(axis, controller, servo_period, columns, carried_mass)
    return [loop_of(machine, bare, TickMap(a[i], b[i], schedule)) for i in range(len(a))]


def _opened_lanes(
    axis: Axis, controller: AxisController, servo_period: float, columns: Mapping[str, Array], carried_mass: float
) -> tuple[Machine, Controller, Schedule, Array, Array]:
    """Return the bare axis, its controller and open schedule, and A (n_variant, n, n) and B (n_variant, n, n_external)."""
    n = len(next(iter(columns.values()), (0.0,)))
    machine, bare = bare_axis(axis, controller, servo_period, carried_mass)
    known = parameters_of(machine, bare)
    # The loop of one axis has no estimator of the coupling.
    used = {name: np.asarray(values, dtype=float) for name, values in columns.items() if name in known}
    schedule = opened_schedule(machine, bare, used)
    parts = [lane_matrices(schedule, LANES, first, jit_enabled()) for first in range(0, n if used else 1, LANES)]
    a, b = (np.concatenate([part[i] for part in parts]) for i in (0, 1))
    if not used:
        return machine, bare, schedule, np.repeat(a[:1], n, axis=0), np.repeat(b[:1], n, axis=0)
    return machine, bare, schedule, a[:n], b[:n]


def rough_margins(loop: SampledLoop) -> Margins:
    """Return margins by linear interpolation on a frequency grid, accurate to a few tenths of a decibel and of a degree.

    Good enough to guide a search; check its result with `SampledLoop.margins`.
    """
    if not loop.stable:
        return Margins(math.nan, math.nan, math.nan, math.nan, stable=False)
    w = np.geomspace(1e-4 * loop.nyquist, loop.nyquist, GRID)
    gain = loop.loop_gain(w)
    phase, crossover = _phase(w, gain)
    factor, phase_crossover = _factor(w, gain)
    return Margins(factor, phase, crossover, float(np.abs(1.0 + gain).min()), True, phase_crossover)


def _phase(w: Array, gain: Complex) -> tuple[float, float]:
    with np.errstate(divide="ignore"):
        size = np.log(np.abs(gain))
    at = np.flatnonzero(np.isfinite(size[:-1]) & np.isfinite(size[1:]) & (size[:-1] * size[1:] <= 0.0) & (size[:-1] != size[1:]))
    if not at.size:
        return math.inf, math.nan
    part = size[at] / (size[at] - size[at + 1])
    angle = np.angle(-gain[at]) + part * np.angle(gain[at + 1] / gain[at])
    angle = np.angle(np.exp(1j * angle))
    best = int(np.argmin(np.abs(angle)))
    return float(angle[best]), float(w[at[best]] * (w[at[best] + 1] / w[at[best]]) ** part[best])


def _factor(w: Array, gain: Complex) -> tuple[float, float]:
    at = np.flatnonzero(gain.imag[:-1] * gain.imag[1:] < 0.0)
    part = gain.imag[at] / (gain.imag[at] - gain.imag[at + 1])
    real, where = gain.real[at] + part * (gain.real[at + 1] - gain.real[at]), w[at] * (w[at + 1] / w[at]) ** part
    if abs(gain[-1].imag) <= 1e-9 * abs(gain[-1]):
        real, where = np.append(real, gain[-1].real), np.append(where, w[-1])
    inside = (real < 0.0) & (real > -1.0)
    if not inside.any():
        return math.inf, math.nan
    best = int(np.argmin(real[inside]))
    return float(-1.0 / real[inside][best]), float(where[inside][best])
