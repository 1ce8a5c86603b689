"""Margins and stability of HAL's ``pid`` around an identified axis, without friction."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.margins import Margins, frequency_grid, margins
from contourlab.arrays import Array, Flags
from contourlab.features.commission.loop import AxisModel

GRID = 500
"""Frequencies of the quick check of many sets of gains."""
ROBUST = (0.75, 1.0, 1.25)
"""Factors of the axis gain at which the loop must be stable."""
Complex = NDArray[np.complex128]


def _axis_response(model: AxisModel, period: float, z: Complex) -> Complex:
    """Return the measured position over the output at points z."""
    decay, gained, travel, gain, _, _, whole, rest = model.row(period)
    velocity = gained / (z - decay)
    response: Complex = gain * ((gained * velocity + travel) / (z - 1.0) - rest * velocity) * z**-whole
    return response


def _law_response(gains: Array, period: float, z: Complex) -> Complex:
    """Return output over error of ``pid`` (n, k) at points z (k,)."""
    p, i, d = (gains[:, k, None] for k in range(3))
    response: Complex = p + i * period * z / (z - 1.0) + d * (z - 1.0) / (period * z)
    return response


def loop_margins(gains: Array, model: AxisModel, period: float) -> Margins:
    """Return the margins of one set of gains, in the order of `loop.GAINS` [per metre]."""
    poles = _poles(gains, model, period)
    grid = frequency_grid(period, poles, int(model.row(period)[6]) + 1)

    def loop(w: Array) -> Complex:
        z = np.exp(1j * w * period)
        response: Complex = _law_response(gains[None], period, z)[0] * _axis_response(model, period, z)
        return response

    return margins(loop, grid[grid > 0.0], stable=bool(np.abs(poles).max() < 1.0))


def _poles(gains: Array, model: AxisModel, period: float) -> Complex:
    """Return the poles of the closed loop, from the polynomials of law and axis in z."""
    decay, gained, travel, gain, _, _, whole, rest = model.row(period)
    p, i, d = gains[:3]
    # ((gained^2 + travel (z - decay)) - rest gained (z - 1)) / ((z - decay) (z - 1) z^whole)
    top = gain * np.array([travel - rest * gained, gained**2 - travel * decay + rest * gained])
    below = np.concatenate([np.polymul([1.0, -decay], [1.0, -1.0]), np.zeros(int(whole))])
    law = np.array([p + i * period + d / period, -p - 2.0 * d / period, d / period])
    return np.asarray(np.roots(np.polyadd(np.polymul(below, [1.0, -1.0, 0.0]), np.polymul(top, law))))


def robustly_stable(gains: Array, model: AxisModel, period: float) -> bool:
    """Return whether the loop is stable with the gain of the axis a quarter smaller, as identified, and a quarter larger."""
    scaled = (replace(model, gain=share * model.gain) for share in ROBUST)
    return all(float(np.abs(_poles(gains, one, period)).max()) < 1.0 - 1e-9 for one in scaled)


def keep_margins(gains: Array, model: AxisModel, period: float, gain_margin: float, phase_margin: float) -> Flags:
    """Return which sets of gains (n, 7) are stable and keep the margins [dB, deg], on a grid of frequencies."""
    w = np.geomspace(1e-4, 1.0, GRID) * math.pi / period
    z = np.exp(1j * w * period)
    loop = _law_response(gains, period, z) * _axis_response(model, period, z)[None]
    size, angle = np.log(np.abs(loop)), np.angle(-loop)
    crosses = (size[:, 1:] > 0.0) != (size[:, :-1] > 0.0)
    phase = np.minimum(np.abs(angle[:, 1:]), np.abs(angle[:, :-1]))
    enough = ~(crosses & (phase < math.radians(phase_margin))).any(axis=1)
    # The angle to -1 passes zero; a jump by a turn is no crossing.
    meets = ((angle[:, 1:] > 0.0) != (angle[:, :-1] > 0.0)) & (np.abs(np.diff(angle, axis=1)) < math.pi)
    near = np.minimum(np.abs(size[:, 1:]), np.abs(size[:, :-1])) < gain_margin * math.log(10.0) / 20.0
    enough &= ~(meets & near).any(axis=1)
    # At half the sample rate the loop is real: it meets the axis without crossing it.
    enough &= ~((loop[:, -1].real < 0.0) & (np.abs(size[:, -1]) < gain_margin * math.log(10.0) / 20.0))
    enough[enough] = [robustly_stable(row, model, period) for row in gains[enough]]
    return np.asarray(enough)
