"""Ghaffari & Ulsoy, section II: disturbance observer with plant, eqs (10)-(13), from the linear models of the components."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.sampled_loop import AxisResponse
from contourlab.arrays import Complex
from contourlab.components.controller.position import PositionController
from contourlab.components.friction.laws import NoFriction
from contourlab.components.ideal import IdealSensor
from contourlab.loop.machine import AxisController
from contourlab.papers.ghaffari.axis_response import axis_response
from contourlab.papers.ghaffari.setup import AXES, TABLE_2, TABLE_3, Gains, Reading, axis, axis_controller
from contourlab.papers.rows import Row, identity

_PER_MM = 1e3


def compensated_axis(number: int, gains: Gains, frequency: NDArray[Any]) -> AxisResponse:
    """Return the continuous-time responses of an axis with its observer only: no position loop, friction or quantisation."""
    bare = replace(axis(number, Reading()), friction=NoFriction(), sensor=IdealSensor())
    observer = axis_controller(gains, Reading()).observer
    return axis_response(bare, AxisController(PositionController(), observer=observer), frequency)


def exact_compensated(number: int, gains: Gains, reading: Reading, s: NDArray[Any]) -> tuple[Complex, Complex]:
    """Return V/U_c and V/D of eqs (10)-(13), lengths in mm."""
    a, b, ah, bh = AXES[number].gain, AXES[number].damping, gains.observer_gain, gains.observer_damping
    wz, wd = reading.filter_bandwidth, reading.bandwidth
    below = s**3 + (wz + b) * s**2 + ((wz + bh) * wd * a / ah + wz * b) * s + wd * wz * bh * a / ah
    return np.asarray(a * (s + wz) * (s + wd) / below, dtype=complex), np.asarray(a * s * (s + wz) / below, dtype=complex)


def observer_rows() -> Iterator[Row]:
    """Yield the largest difference of our observer and plant from eqs (10)-(13), over all axes and both tables."""
    w, apart = np.logspace(-3, 4, 200), np.zeros(2)
    for table in (TABLE_2, TABLE_3):
        for number, gains in table.items():
            response = compensated_axis(number, gains, w)
            pair = response.compensated * _PER_MM, 1j * w * response.compliance * _PER_MM
            exact = exact_compensated(number, gains, Reading(), 1j * w)
            apart = np.maximum(apart, [np.abs(here / there - 1.0).max() for here, there in zip(pair, exact, strict=True)])
    note = "our observer and plant, 0.001 to 10^4 rad/s"
    for what, most in zip(("V/U_c, eqs 10, 11, 13", "V/D, eqs 10, 12, 13"), apart, strict=True):
        yield identity(f"{what}: largest relative difference", "all axes, Tables II and III", 0.0, float(most), "", 1e-9, note)
