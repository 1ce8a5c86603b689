"""Ghaffari & Ulsoy, section II: disturbance observer with plant, eqs (10)-(14), from the linear models of the components."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.sampled_loop import AxisResponse
from contourlab.arrays import Array, Complex
from contourlab.components.controller.position import PositionController
from contourlab.components.friction.laws import NoFriction
from contourlab.components.ideal import IdealSensor
from contourlab.loop.machine import AxisController
from contourlab.papers.ghaffari.axis_response import axis_response
from contourlab.papers.ghaffari.setup import AXES, TABLE_2, TABLE_3, Gains, Reading, axis, axis_controller
from contourlab.papers.rows import Row, derived, ours, printed

_PER_MM = 1e3


def observer_rows() -> Iterator[Row]:
    """Yield the rows on eqs (10)-(13) for both tables, and on the reduction to eq (14)."""
    return chain(_identity(), _reduction())


def compensated_axis(number: int, gains: Gains, frequency: NDArray[Any]) -> AxisResponse:
    """Return the continuous-time responses of an axis with its observer only: no position loop, friction or quantisation."""
    bare = replace(axis(number, Reading()), friction=NoFriction(), sensor=IdealSensor())
    observer = axis_controller(gains, Reading()).observer
    return axis_response(bare, AxisController(PositionController(), observer=observer), 0.0, frequency)


def exact_compensated(number: int, gains: Gains, reading: Reading, s: NDArray[Any]) -> tuple[Complex, Complex]:
    """Return V/U_c and V/D of eqs (10)-(13), lengths in mm."""
    a, b, ah, bh = AXES[number].gain, AXES[number].damping, gains.observer_gain, gains.observer_damping
    wz, wd = reading.filter_bandwidth, reading.bandwidth
    below = s**3 + (wz + b) * s**2 + ((wz + bh) * wd * a / ah + wz * b) * s + wd * wz * bh * a / ah
    return np.asarray(a * (s + wz) * (s + wd) / below, dtype=complex), np.asarray(a * s * (s + wz) / below, dtype=complex)


def _identity() -> Iterator[Row]:
    w = np.logspace(-3, 4, 200)
    for table, name in ((TABLE_2, "Table II"), (TABLE_3, "Table III")):
        for number, gains in table.items():
            case = f"axis {number}, {name}"
            response = compensated_axis(number, gains, w)
            driven, disturbed = response.compensated * _PER_MM, 1j * w * response.compliance * _PER_MM
            exact, exact_disturbed = exact_compensated(number, gains, Reading(), 1j * w)
            note = "our observer and plant, 0.001 to 10^4 rad/s"
            for what, ours_, eq in (("V/U_c, eqs 10, 11, 13", driven, exact), ("V/D, eqs 10, 12, 13", disturbed, exact_disturbed)):
                apart = float(np.abs(ours_ / eq - 1.0).max())
                yield derived(f"{what}: largest relative difference", case, 0.0, apart, "", 1e-9, note)
            level = gains.observer_gain / (gains.observer_damping * Reading().bandwidth)
            slope = float(np.abs(disturbed[0]) / w[0])
            note = "a_hat/(b_hat w_d): velocity over the rate of a slow disturbance; our components in continuous time"
            yield derived("attenuation of disturbance", case, level, slope, "mm/full_scale", 1e-6 * level, note)


def _reduction() -> Iterator[Row]:
    """Yield rows on eq (14): a first-order velocity loop instead of the exact one."""
    w = np.linspace(0.5, 50.0, 400)
    for number, gains in TABLE_2.items():
        loop = compensated_axis(number, gains, w).compensated * _PER_MM
        ideal = gains.observer_gain / (1j * w + gains.observer_damping)
        error = 100.0 * float(np.abs(ideal / loop - 1.0).max())
        case = f"axis {number}, Table II"
        yield ours("reduction (14), largest error to 50 rad/s", case, error, "%", "with a' = a_hat, b' = b_hat")
        a_fit, b_fit = first_order_fit(w, loop)
        fit = 100.0 * (1.0 - float(np.linalg.norm(loop - a_fit / (1j * w + b_fit)) / np.linalg.norm(loop)))
        gain, damping = gains.model_gain, gains.model_damping
        reason = (
            f"eq 10 has a steady gain of a_hat/b_hat = {gains.observer_gain / gains.observer_damping:.0f} mm/s, but the printed a'/b' is "
            f"{gain / damping:.0f}: no axis that follows eq 10 with Table II's observer has the printed a' and b'"
        )
        note = "fit of a'/(s + b') to our observer and plant, without friction"
        yield printed("fitted a'", case, gain, a_fit, "mm/s^2/full_scale", 0.05 * gain, note, reason=reason)
        yield printed("fitted b'", case, damping, b_fit, "1/s", 0.05 * damping, note, reason=reason)
        note = "the paper: above 95 %, for its measured steps"
        yield printed("fit of eq 14", case, 95.0, fit, "%", 5.0, note, at_least=True)


def first_order_fit(w: Array, response: Complex) -> tuple[float, float]:
    """Return a' and b' from least squares on (s + b') V = a' U, which is linear in both."""
    rows = np.concatenate([np.column_stack([np.ones_like(w), -response.real]), np.column_stack([np.zeros_like(w), -response.imag])])
    right = np.concatenate([(1j * w * response).real, (1j * w * response).imag])
    gain, damping = np.linalg.lstsq(rows, right, rcond=None)[0]
    return float(gain), float(damping)
