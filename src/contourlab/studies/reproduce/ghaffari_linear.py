"""Ghaffari & Ulsoy, everything that needs no simulation: gains, poles, the observer's identity, margins."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.axis_response import axis_response
from contourlab.analysis.tick_map import spectral_radius
from contourlab.components.controller.position import PositionController
from contourlab.components.drive.saturation import Saturation
from contourlab.components.friction.none import NoFriction
from contourlab.components.mechanics import link
from contourlab.components.sensor.ideal import IdealSensor
from contourlab.engine.step import record
from contourlab.geometry import contour
from contourlab.loop.machine import AxisController, Controller, Machine
from contourlab.loop.template import build
from contourlab.primitives import Clock
from contourlab.studies.reproduce.ghaffari_setup import (
    AXES,
    PLACED_POLES,
    TABLE_2,
    TABLE_3,
    Gains,
    Reading,
    axis,
    axis_controller,
)
from contourlab.studies.reproduce.rows import Row, row

__all__ = ["linear_rows"]

Complex = NDArray[np.complex128]


def linear_rows() -> list[Row]:
    """Return the rows of Tables II and III, the observer (eqs 10-14), the comparison of axes, and Fig 8."""
    return [*_table_2(), *_poles(), *_observer(), *_reduction(), *_comparison(), *_fig_8(), *_oscillation_limit()]


def _table_2() -> list[Row]:
    found = []
    # One unit of the last printed digit: the paper cuts K_V off instead of rounding it.
    digits = {
        "velocity_gain": ("K_V", 1e-3, 1e-3),
        "position_gain": ("K_P", 1e-3, 1e-2),
        "integral_gain": ("K_I", 1.0, 1e-2),
    }
    units = {"velocity_gain": "full_scale*s/mm", "position_gain": "full_scale/mm", "integral_gain": "1/s"}
    for number, printed in TABLE_2.items():
        gains = PositionController.place(**PLACED_POLES, model_gain=printed.model_gain * 1e-3, model_damping=printed.model_damping)
        for name, (symbol, factor, digit) in digits.items():
            note = "eqs 21-23; the paper truncates" if symbol == "K_V" else "eqs 21-23"
            found.append(
                row(
                    f"Table II {symbol}",
                    f"axis {number}",
                    getattr(printed, name),
                    gains[name] * factor,
                    units[name],
                    digit,
                    note,
                )
            )
    return found


def characteristic_roots(gains: Gains) -> Complex:
    """Return the roots of the denominator of eq (16)."""
    a, b, v, p, i = gains.model_gain, gains.model_damping, gains.velocity_gain, gains.position_gain, gains.integral_gain
    return np.asarray(np.roots([1.0, b + a * v, a * p, a * p * i]), dtype=complex)


def _poles() -> list[Row]:
    wanted = np.array([-PLACED_POLES["pole"], PLACED_POLES["damping"] * PLACED_POLES["natural_frequency"]])
    imaginary = PLACED_POLES["natural_frequency"] * math.sqrt(1.0 - PLACED_POLES["damping"] ** 2)
    found = []
    for number, printed in TABLE_2.items():
        roots = characteristic_roots(printed)
        real, pair = roots[np.argmin(np.abs(roots.imag))].real, roots[np.argmax(roots.imag)]
        note = "roots of eq 16 with the printed gains; the target poles give the paper's column"
        found.append(row("Table II real pole", f"axis {number}", float(wanted[0]), float(real), "1/s", 1.5, note))
        found.append(row("Table II pair, real part", f"axis {number}", float(-wanted[1]), float(pair.real), "1/s", 1.0, note))
        found.append(row("Table II pair, imaginary part", f"axis {number}", imaginary, float(pair.imag), "1/s", 1.0, note))
    for number, printed in TABLE_3.items():
        identified = replace(printed, model_gain=TABLE_2[number].model_gain, model_damping=TABLE_2[number].model_damping)
        roots = characteristic_roots(identified)
        real, pair = roots[np.argmin(np.abs(roots.imag))].real, roots[np.argmax(roots.imag)]
        note = "Table III gains on the identified a', b'; the paper prints no poles"
        found.append(row("Table III real pole", f"axis {number}", None, float(real), "1/s", note=note))
        found.append(row("Table III pair, real part", f"axis {number}", None, float(pair.real), "1/s", note=note))
        found.append(row("Table III pair, imaginary part", f"axis {number}", None, float(pair.imag), "1/s", note=note))
    return found


def exact_compensated(number: int, gains: Gains, reading: Reading, s: NDArray[Any]) -> tuple[Complex, Complex]:
    """Return V/U_c and V/D of eqs (10)-(13), lengths in mm."""
    a, b, ah, bh = AXES[number].gain, AXES[number].damping, gains.observer_gain, gains.observer_damping
    wz, wd = reading.filter_bandwidth, reading.bandwidth
    below = s**3 + (wz + b) * s**2 + ((wz + bh) * wd * a / ah + wz * b) * s + wd * wz * bh * a / ah
    return np.asarray(a * (s + wz) * (s + wd) / below, dtype=complex), np.asarray(a * s * (s + wz) / below, dtype=complex)


def _observer() -> list[Row]:
    found = []
    w = np.logspace(-3, 4, 200)
    reading = Reading()
    for table, name in ((TABLE_2, "Table II"), (TABLE_3, "Table III")):
        for number in AXES:
            continuous = AxisController(
                axis_controller(table[number], reading).controller,
                observer=axis_controller(table[number], reading).observer,
            )
            bare = replace(axis(number, reading), friction=NoFriction(), sensor=IdealSensor())
            response = axis_response(bare, continuous, 0.0, w)
            exact, disturbed = exact_compensated(number, table[number], reading, 1j * w)
            case = f"axis {number}, {name}"
            error = float(np.abs(response.compensated / (exact * 1e-3) - 1.0).max())
            found.append(
                row(
                    "DOB identity (10)-(13), largest relative difference",
                    case,
                    0.0,
                    error,
                    "",
                    1e-9,
                    "our observer joined with the plant",
                )
            )
            ratio = table[number].observer_gain / table[number].observer_damping
            gain = float(np.abs(response.compensated[0])) * 1e3
            found.append(
                row(
                    "DC gain u_c to v",
                    case,
                    ratio,
                    gain,
                    "mm/s/full_scale",
                    1e-3 * ratio,
                    "a_hat/b_hat, whatever the plant",
                )
            )
            slope = float(np.abs(disturbed[0] / w[0]))
            level = ratio / reading.bandwidth
            note = "a_hat/(b_hat w_d): velocity per rate of a slow disturbance"
            found.append(row("attenuation of disturbance", case, level, slope, "mm/full_scale", 1e-3 * level, note))
    return found


def _reduction() -> list[Row]:
    """Eq (14): a first-order velocity loop in place of the exact one."""
    found = []
    w = np.linspace(0.5, 50.0, 400)
    identified = {1: (873.0, 19.7), 2: (754.0, 24.7), 3: (801.0, 19.9)}
    for number in AXES:
        exact, _ = exact_compensated(number, TABLE_2[number], Reading(), 1j * w)
        ideal = TABLE_2[number].observer_gain / (1j * w + TABLE_2[number].observer_damping)
        error = 100.0 * float(np.abs(ideal / exact - 1.0).max())
        case = f"axis {number}, Table II"
        found.append(row("reduction (14), largest error to 50 rad/s", case, None, error, "%", note="with a' = a_hat, b' = b_hat"))
        # Least squares on (s + b') V = a' U, linear in a' and b'.
        rows = np.concatenate([np.column_stack([np.ones_like(w), -exact.real]), np.column_stack([np.zeros_like(w), -exact.imag])])
        right = np.concatenate([(1j * w * exact).real, (1j * w * exact).imag])
        a_fit, b_fit = np.linalg.lstsq(rows, right, rcond=None)[0]
        fit = 100.0 * (1.0 - float(np.linalg.norm(exact - a_fit / (1j * w + b_fit)) / np.linalg.norm(exact)))
        note = "fit of a'/(s + b') to eq 10, no friction; the paper fitted measured steps"
        found.append(row("fitted a'", case, identified[number][0], float(a_fit), "mm/s^2/full_scale", None, note))
        found.append(row("fitted b'", case, identified[number][1], float(b_fit), "1/s", None, note))
        found.append(row("fit of eq 14 to eq 10", case, 95.0, fit, "%", 5.0, "the paper: above 95 %"))
    return found


def _comparison() -> list[Row]:
    one, two = AXES[1], AXES[2]
    faster = 100.0 * (one.damping / two.damping - 1.0)
    larger = 100.0 * ((one.gain / one.damping) / (two.gain / two.damping) - 1.0)
    found = [
        row("response of axis 1 faster than axis 2", "open loop", 55.0, faster, "%", 1.0, "ratio of b"),
        row(
            "DC gain of axis 1 larger than axis 2",
            "open loop",
            70.0,
            larger,
            "%",
            2.0,
            "ratio of a/b; the paper rounds to tens",
        ),
    ]
    for number, printed in ((1, 5.5), (2, 8.8), (3, 7.7)):
        note = "slow ramp of the command on the simulated axis, as in Fig 5(a): the command at which it first moves"
        found.append(row("stiction", f"axis {number}", printed, 100.0 * breakaway(number), "% of full scale", 0.05, note))
    return found


def breakaway(number: int, rate: float = 0.02) -> float:
    """Return the command at which an axis leaves its place under a ramp of `rate` full scales per second."""
    model = axis(number, Reading())
    step = link(model.plant, model.friction)
    period = 1e-3
    par = step.par_type(**model.plant.block(period), **model.friction.block(period))
    state_type, input_type = record(tuple(p.name for p in step.states)), record(tuple(p.name for p in step.inputs))
    state, k = state_type(*(0.0 for _ in step.states)), 0
    while state.position == 0.0:
        k += 1
        moved, _ = step.function(par, state, input_type(rate * k * period, 0.0), Clock(float(k), k * period, period))
        state = state_type(*moved)
    return rate * k * period


def _fig_8() -> list[Row]:
    """Closed loop of eq (16) with K_V 0.1, K_P 4, K_I 11.8 and 25 % on a' = 800, b' = 20."""
    w = np.logspace(0, 3, 400)

    def closed(a: float, b: float) -> Complex:
        s = 1j * w
        return np.asarray(a * 4.0 * 11.8 / (s**3 + (b + a * 0.1) * s**2 + a * 4.0 * s + a * 4.0 * 11.8))

    nominal = closed(800.0, 20.0)
    found = []
    band = w <= 25.0
    for a in (600.0, 800.0, 1000.0):
        for b in (15.0, 20.0, 25.0):
            if (a, b) != (800.0, 20.0):
                change = closed(a, b) / nominal
                case = f"a' {a:g}, b' {b:g}"
                decibel = 20.0 * float(np.abs(np.log10(np.abs(change[band]))).max())
                turn = float(np.degrees(np.abs(np.angle(change[band]))).max())
                note = "Fig 8 shows curves that lie together; to 25 rad/s, eight times the circle's frequency"
                found.append(row("Fig 8 change of magnitude", case, None, decibel, "dB", note=note))
                found.append(row("Fig 8 change of phase", case, None, turn, "deg", note=note))
    return found


def stable(gains: Gains, number: int, reading: Reading) -> bool:
    """Tell whether the sampled loop of one axis is stable, friction and quantisation left out."""
    bare = replace(axis(number, reading), friction=NoFriction(), sensor=IdealSensor(), drive=Saturation())
    made = axis_controller(gains, reading)
    free = replace(made, controller=made.controller.replace(anti_windup="none"))
    twin = replace(bare, name="twin")
    loop = build(
        Machine("axis", (bare, twin), reading.servo_period),
        Controller({bare.name: free, "twin": free}),
        contour("circle"),
        np.zeros(2),
    )
    return spectral_radius(loop.schedule) < 1.0 + 1e-9


def _oscillation_limit() -> list[Row]:
    """Where large K_P or K_I make the loop oscillate: the sampled loop with observer, against Routh on eq (16)."""
    found = []
    reading = Reading()
    for number in AXES:
        start = TABLE_3[number]
        for name, symbol, unit in (("position_gain", "K_P", "full_scale/mm"), ("integral_gain", "K_I", "1/s")):
            low, high = getattr(start, name), 1e4
            for _ in range(40):
                middle = math.sqrt(low * high)
                low, high = (middle, high) if stable(replace(start, **{name: middle}), number, reading) else (low, middle)
            routh = start.model_damping + start.model_gain * start.velocity_gain
            note = "sampled loop with observer, from the steps themselves"
            if symbol == "K_I":
                note += f"; eq 16 alone oscillates from K_I = b' + a' K_V = {routh:g} 1/s on"
            found.append(row(f"{symbol} at which the loop oscillates", f"axis {number}, Table III", None, low, unit, note=note))
    return found
