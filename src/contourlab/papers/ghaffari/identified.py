"""Ghaffari & Ulsoy, section III: closed-loop identification of a' and b' by eq (18) on the simulated axes.

The loop of Fig 5(b) with K_P = 4, K_V = 0.1, observer, sticking friction and encoder counts. The paper does not print its excitation. Here
the reference steps between random levels that do not saturate the drive.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from contourlab.analysis.identification.first_order import identify_closed_loop
from contourlab.arrays import Array
from contourlab.components.controller.position import PositionController
from contourlab.loop.axis_parts import Limits
from contourlab.papers.ghaffari.bench import run_bench
from contourlab.papers.ghaffari.setup import AXES, TABLE_2, TABLE_3, Gains, Reading, axis, axis_controller
from contourlab.papers.rows import Row, ours, printed

_MM = 1e-3
POSITION_GAIN, VELOCITY_GAIN = 4.0, 0.1
"""K_P [full scale/mm] and K_V [full scale s/mm] of the identification, as printed below eq (18)."""
DURATION, HOLD, RANGE, SEED = 20.0, 0.25, 0.1, 0
"""Reference: duration [s], time at a level [s], largest level [mm]; seed of the levels."""
ACCURACY = 95.0
"""Smallest fit [percent] in the paper."""


@dataclass(frozen=True)
class Identification:
    """Identified axis: a' [mm/s^2 per full scale], b' [1/s], standard deviations, fit [percent], largest command [full scale]."""

    gain: float
    damping: float
    gain_deviation: float
    damping_deviation: float
    fit: float
    command: float


def reference(period: float) -> Array:
    """Return reference steps [m] between random levels, from rest."""
    levels = np.random.default_rng(SEED).uniform(-RANGE, RANGE, round(DURATION / HOLD))
    steps = np.repeat(levels * _MM, round(HOLD / period))
    steps[: round(0.01 / period)] = 0.0
    return steps


def identified(table: dict[int, Gains], reading: Reading, sticking: bool = True) -> dict[int, Identification]:
    """Run the loop of Fig 5(b) on all three axes with the observers of a table, and identify a' and b'."""
    steps, period = reference(reading.servo_period), reading.servo_period
    axes, controllers = [], {}
    gains = PositionController(position_gain=POSITION_GAIN / _MM, velocity_gain=VELOCITY_GAIN / _MM)
    for number in AXES:
        axes.append(replace(axis(number, reading, sticking), limits=Limits(following_error=math.inf)))
        controllers[str(number)] = replace(axis_controller(table[number], reading), controller=gains)
    # No derivatives of the reference: eq (18) has no feedforward.
    position, command = run_bench(axes, controllers, period, 0, steps, ("position", "command"))
    time, identifications = period * np.arange(steps.size), {}
    for column, number in enumerate(AXES):
        fit = identify_closed_loop(time, steps, position[:, column], POSITION_GAIN / _MM, VELOCITY_GAIN / _MM).found
        deviations, largest = (fit.deviation("a") / _MM, fit.deviation("b")), float(np.abs(command[:, column]).max())
        identifications[number] = Identification(fit["a"] / _MM, fit["b"], *deviations, fit.fit, largest)
    return identifications


def identified_rows() -> Iterator[Row]:
    """Yield a', b' and the fit, and how they depend on what the paper leaves open."""
    fine = replace(Reading(), servo_period=1e-4)
    here, quick = identified(TABLE_2, Reading()), identified(TABLE_2, fine)
    for number, gains in TABLE_2.items():
        case, fit = f"axis {number}, Table II, eq 18", here[number]
        steady, printed_steady = gains.observer_gain / gains.observer_damping, gains.model_gain / gains.model_damping
        reason = (
            f"the observer makes the axis a_hat/(s + b_hat) = {gains.observer_gain:g}/(s + {gains.observer_damping:g}) at low frequencies, "
            f"steady gain {steady:.0f} mm/s against the printed a'/b' = {printed_steady:.0f}. Eq 18 puts the lags of velocity "
            f"filter, hold and observer at the loop's bandwidth into a': {fit.gain:.0f} at 1 ms and {quick[number].gain:.0f} at 0.1 ms"
        )
        gain, damping = gains.model_gain, gains.model_damping
        yield printed("identified a'", case, gain, fit.gain, "mm/s^2/full_scale", 0.05 * gain, reason=reason)
        yield printed("identified b'", case, damping, fit.damping, "1/s", 0.05 * damping, reason=reason)
        note = f"the paper: above 95 %; random steps within {RANGE:g} mm, largest command {fit.command:.2f} of full scale"
        yield printed("identification fit", case, ACCURACY, fit.fit, "%", 100.0 - ACCURACY, note, at_least=True)
    variants = {
        "Table II, servo period 0.1 ms": quick,
        "Table II, 0.1 ms, no friction": identified(TABLE_2, fine, sticking=False),
        "Table II, low-passes by backward Euler": identified(TABLE_2, replace(Reading(), discretisation="backward-euler")),
        "Table III": identified(TABLE_3, Reading()),
        "Table III, servo period 0.1 ms": identified(TABLE_3, fine),
    }
    for words, by_axis in variants.items():
        for number, fit in by_axis.items():
            for name, value, deviation, unit in (
                ("a'", fit.gain, fit.gain_deviation, "mm/s^2/full_scale"),
                ("b'", fit.damping, fit.damping_deviation, "1/s"),
            ):
                note = f"standard deviation {deviation:.2g}, fit {fit.fit:.4g} %"
                yield ours(f"identified {name} over what the paper leaves open", f"axis {number}, {words}", value, unit, note)
