"""Sampled loops of many variants of one axis at once: the ticks that show the linear map are run in lanes, a variant in each.

A search for gains asks for margins thousands of times. Probing in plain Python takes most of the time of such a question; in lanes it is
shared by 32 of them. What comes out is the loop of `contourlab.analysis.sampled_loop` to rounding.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.margins import Margins
from contourlab.analysis.sampled_loop import SampledLoop, bare_axis, loop_of, opened_schedule
from contourlab.analysis.tick_map import TickMap
from contourlab.engine.runner import make_group
from contourlab.engine.schedule import Schedule
from contourlab.engine.step import rows
from contourlab.errors import ComponentError
from contourlab.loop.batch import LANES
from contourlab.loop.machine import Axis, AxisController, parameter_names
from contourlab.loop.simulate import jit_enabled

__all__ = ["rough_margins", "sampled_loops"]

Array = NDArray[np.float64]
GRID = 200
"""Frequencies of `rough_margins`."""


def sampled_loops(
    axis: Axis, controller: AxisController, servo_period: float, columns: Mapping[str, Array], carried_mass: float = 0.0
) -> list[SampledLoop]:
    """Return the sampled loop of an axis for each of many sets of numbers.

    Parameters
    ----------
    axis, controller, servo_period, carried_mass
        As of `contourlab.analysis.sampled_loop`.
    columns : mapping of str to ndarray (n,)
        Values [SI] by dotted names. Those that have no part in the loop of this axis are passed over.

    Raises
    ------
    ComponentError
        If a component is not linear, or a delay is longer than its analysis takes.
    """
    n = len(next(iter(columns.values())))
    machine, made = bare_axis(axis, controller, servo_period, carried_mass)
    known = parameter_names(machine, made)
    # The estimator of a coupling sees all axes; the loop of one axis has none.
    mine = {name: np.asarray(values, dtype=float) for name, values in columns.items() if name in known}
    schedule = opened_schedule(machine, made, mine)
    found: list[SampledLoop] = []
    for first in range(0, n, LANES):
        a, b = _maps(schedule, first)
        found += [loop_of(machine, made, TickMap(a[..., i], b[..., i], schedule)) for i in range(min(LANES, n - first))]
    return found


def _maps(schedule: Schedule, first: int) -> tuple[Array, Array]:
    """Return A (n, n, lane) and B (n, n_external, lane) of a group of variants."""
    group = make_group(schedule, LANES, slice(first, first + LANES), jit_enabled())
    parts = [*group.state, *group.rings, group.signals]
    n_input, size = rows(schedule.externals), sum(len(part) for part in parts)

    def after(state: Array, inputs: Array) -> Array:
        start = 0
        for part in parts:
            part[:] = state[start : start + len(part), None]
            start += len(part)
        group.tick = 0
        group.run(inputs[None, :], [])
        for ring in group.rings:
            ring[:] = np.roll(ring, -1, axis=0)
        return np.concatenate(parts)

    at_rest = after(np.zeros(size), np.zeros(n_input))

    def probe(state: Array, inputs: Array) -> Array:
        return after(state, inputs) - at_rest

    none, nothing = np.zeros(n_input), np.zeros(size)
    a = np.stack([probe(unit, none) for unit in np.eye(size)], axis=1)
    b = np.stack([probe(nothing, unit) for unit in np.eye(n_input)], axis=1)
    _check_linear(probe, a, b)
    return a, b


def _check_linear(probe: object, a: Array, b: Array) -> None:
    rng = np.random.default_rng(1)
    x, u = rng.normal(size=a.shape[1]), rng.normal(size=b.shape[1])
    told = np.einsum("ijl,j->il", a, x) + np.einsum("ijl,j->il", b, u)
    scale = np.einsum("ijl,j->il", np.abs(a), np.abs(x)) + np.einsum("ijl,j->il", np.abs(b), np.abs(u))
    if not (np.abs(probe(x, u) - told) <= 1e-9 * scale).all():  # type: ignore[operator]
        raise ComponentError("a part of the loop is not linear, so it has no frequency response")


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
