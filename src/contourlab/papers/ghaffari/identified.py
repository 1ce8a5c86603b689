"""Ghaffari & Ulsoy, section III: the closed-loop identification of a' and b' by eq (18), done on the simulated axes.

The loop of Fig 5(b) runs tick by tick, K_P = 4 and K_V = 0.1, with the observer on, friction sticking and counts of the
encoder; the reference steps among random levels, small enough for the drive not to saturate. What the paper excited its axes with is
not printed.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.identification.first_order import identify_closed_loop
from contourlab.components.controller.position import PositionController
from contourlab.engine.runner import make_group
from contourlab.geometry import Line, Path
from contourlab.loop.axis_parts import Limits
from contourlab.loop.machine import Controller, Machine
from contourlab.loop.simulate import jit_enabled
from contourlab.loop.template import build
from contourlab.papers.ghaffari.setup import AXES, TABLE_2, TABLE_3, Gains, Reading, axis, axis_controller
from contourlab.papers.rows import Row, ours, printed

Array = NDArray[np.float64]
_MM = 1e-3
POSITION_GAIN, VELOCITY_GAIN = 4.0, 0.1
"""K_P [full scale/mm] and K_V [full scale s/mm] of the identification, as printed below eq (18)."""
DURATION, HOLD, RANGE, SEED = 20.0, 0.25, 0.1, 0
"""Of the reference: whole time [s], time at a level [s], largest level [mm]; seed of the levels."""
ACCURACY = 95.0
"""Fit [percent] that the paper reaches or passes."""


@dataclass(frozen=True)
class Identification:
    """What the identification finds on an axis: a' [mm/s^2 per full scale] and b' [1/s], deviations, fit [percent], largest command."""

    gain: float
    damping: float
    gain_deviation: float
    damping_deviation: float
    fit: float
    command: float


def reference(period: float) -> Array:
    """Return the steps [m] among random levels that the axes are asked for, from rest."""
    levels = np.random.default_rng(SEED).uniform(-RANGE, RANGE, round(DURATION / HOLD))
    steps = np.repeat(levels * _MM, round(HOLD / period))
    steps[: round(0.01 / period)] = 0.0
    return steps


def closed_loops(table: dict[int, Gains], reading: Reading, sticking: bool) -> tuple[Array, Array, Array]:
    """Run the loop of Fig 5(b) on all three axes side by side; return the reference (n,), positions (n, 3) [m] and commands (n, 3)."""
    asked = reference(reading.servo_period)
    axes, controllers = [], {}
    gains = PositionController(position_gain=POSITION_GAIN / _MM, velocity_gain=VELOCITY_GAIN / _MM)
    for number in AXES:
        axes.append(replace(axis(number, reading, sticking), limits=Limits(following_error=math.inf)))
        controllers[str(number)] = replace(axis_controller(table[number], reading), controller=gains)
    n = len(axes)
    path = Path([Line(np.zeros(n), np.ones(n))])
    loop = build(Machine("bench", tuple(axes), reading.servo_period), Controller(controllers), path, np.zeros(n))
    fed = np.zeros((asked.size, 3 * n + 2))
    fed[:, :n] = asked[:, None]  # without its derivatives: eq (18) has no feedforward
    wanted = [loop.schedule.row(signal) for name in ("position", "command") for signal in loop.signals[name]]
    log = make_group(loop.schedule, 1, slice(0, 1), jit_enabled()).run(fed, wanted)[:, :, 0]
    return asked, log[:, :n], log[:, n:]


def identified(table: dict[int, Gains], reading: Reading, sticking: bool = True) -> dict[int, Identification]:
    """Identify a' and b' of the three axes behind the observers of a table."""
    asked, position, command = closed_loops(table, reading, sticking)
    time = reading.servo_period * np.arange(asked.size)
    found = {}
    for column, number in enumerate(AXES):
        fit = identify_closed_loop(time, asked, position[:, column], POSITION_GAIN / _MM, VELOCITY_GAIN / _MM).found
        found[number] = Identification(
            fit["a"] / _MM, fit["b"], fit.deviation("a") / _MM, fit.deviation("b"), fit.fit, float(np.abs(command[:, column]).max())
        )
    return found


def identified_rows() -> list[Row]:
    """Return a', b' and the fit beside the paper's, and what moves them."""
    found = []
    fine = replace(Reading(), servo_period=1e-4)
    here, quick = identified(TABLE_2, Reading()), identified(TABLE_2, fine)
    for number, gains in TABLE_2.items():
        case, one = f"axis {number}, Table II, eq 18", here[number]
        steady, printed_steady = gains.observer_gain / gains.observer_damping, gains.model_gain / gains.model_damping
        reason = (
            f"the observer makes the axis a_hat/(s + b_hat) = {gains.observer_gain:g}/(s + {gains.observer_damping:g}) at low frequencies, "
            f"steady {steady:.0f} mm/s against the printed a'/b' = {printed_steady:.0f}; eq 18 takes what the lags of velocity filter, "
            f"hold and observer do at the loop's bandwidth into a', {one.gain:.0f} at 1 ms and {quick[number].gain:.0f} at 0.1 ms"
        )
        gain, damping = gains.model_gain, gains.model_damping
        found.append(printed("identified a'", case, gain, one.gain, "mm/s^2/full_scale", 0.05 * gain, reason=reason))
        found.append(printed("identified b'", case, damping, one.damping, "1/s", 0.05 * damping, reason=reason))
        note = f"the paper: above 95 %; random steps within {RANGE:g} mm, largest command {one.command:.2f} of full scale"
        found.append(printed("identification fit", case, ACCURACY, one.fit, "%", 100.0 - ACCURACY, note, at_least=True))
    variants = {
        "Table II, servo period 0.1 ms": quick,
        "Table II, 0.1 ms, no friction": identified(TABLE_2, fine, sticking=False),
        "Table II, low-passes by backward Euler": identified(TABLE_2, replace(Reading(), discretisation="backward-euler")),
        "Table III": identified(TABLE_3, Reading()),
        "Table III, servo period 0.1 ms": identified(TABLE_3, fine),
    }
    for words, by_axis in variants.items():
        for number, one in by_axis.items():
            case = f"axis {number}, {words}"
            for name, value, deviation, unit in (
                ("identified a' over what the paper leaves open", one.gain, one.gain_deviation, "mm/s^2/full_scale"),
                ("identified b' over what the paper leaves open", one.damping, one.damping_deviation, "1/s"),
            ):
                found.append(ours(name, case, value, unit, f"standard deviation {deviation:.2g}, fit {one.fit:.4g} %"))
    return found
