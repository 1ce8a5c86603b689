"""Sampled loops of many variants of one axis at once: the ticks that show the linear map are run in lanes, a variant in each.

A search for gains asks for margins thousands of times. Probing in plain Python takes most of the time of such a question; in lanes it is
shared by 32 of them. What comes out is the loop of `contourlab.analysis.linear.sampled_loop` to rounding.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.lane_maps import opened_lanes
from contourlab.analysis.linear.margins import Margins
from contourlab.analysis.linear.sampled_loop import SampledLoop, loop_of
from contourlab.analysis.linear.tick_map import TickMap
from contourlab.loop.machine import Axis, AxisController

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
