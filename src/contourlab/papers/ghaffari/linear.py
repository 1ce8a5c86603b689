"""Ghaffari & Ulsoy, the position loop without simulation: gains, variation of the plant, and stability limits."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import chain, product

import numpy as np

from contourlab.analysis.linear.tick_map import spectral_radius
from contourlab.arrays import Array, Complex
from contourlab.components.controller.position import PositionController
from contourlab.components.drive.saturation import Saturation
from contourlab.components.friction.laws import NoFriction
from contourlab.components.ideal import IdealSensor
from contourlab.components.plant.plant import RigidAxis
from contourlab.geometry import Line, Path
from contourlab.loop.machine import Axis, AxisController, Controller, Machine
from contourlab.loop.template import build
from contourlab.papers.ghaffari.axis_response import axis_response
from contourlab.papers.ghaffari.setup import PLACED_POLES, TABLE_2, TABLE_3, Gains, Reading, axis, axis_controller
from contourlab.papers.rows import Row, derived, identity, ours

_MM = 1e-3
BASE, VARIED = (800.0, 20.0), tuple(product((600.0, 800.0, 1000.0), (15.0, 20.0, 25.0)))
"""Fig 8: a' [mm/s^2] and b' [1/s], and both varied by 25 %."""


def linear_rows() -> Iterator[Row]:
    """Yield the rows on the gains of Table II, Fig 8, and the stability limits."""
    return chain(_table_2(), _fig_8(), _oscillation_limit())


DIGITS = {"velocity_gain": 1e-3, "position_gain": 1e-2, "integral_gain": 1e-2}
"""One unit of the last printed digit, lengths in mm: the paper truncates K_V."""


def placed(printed_gains: Gains) -> Gains:
    """Return a line of Table II with the gains from our pole placement for its a' and b'."""
    a, b = printed_gains.model_gain, printed_gains.model_damping
    found = PositionController.place(**PLACED_POLES, model_gain=a * _MM, model_damping=b)
    velocity, position = found["velocity_gain"] * _MM, found["position_gain"] * _MM
    return replace(printed_gains, velocity_gain=velocity, position_gain=position, integral_gain=found["integral_gain"])


def _table_2() -> Iterator[Row]:
    words = {
        "velocity_gain": ("K_V", "full_scale*s/mm", "eqs 21-23; the paper truncates"),
        "position_gain": ("K_P", "full_scale/mm", "eqs 21-23"),
        "integral_gain": ("K_I", "1/s", "eqs 21-23"),
    }
    for number, gains in TABLE_2.items():
        for name, (symbol, unit, note) in words.items():
            here = getattr(placed(gains), name)
            yield derived(f"Table II {symbol}", f"axis {number}", getattr(gains, name), here, unit, DIGITS[name], note)


def ideal_loop(gains: Gains) -> tuple[RigidAxis, PositionController]:
    """Return the axis a'/(s (s + b')) and our controller in the structure of eq (16)."""
    controller = axis_controller(gains, Reading()).controller.replace(structure="ipv")
    assert isinstance(controller, PositionController)
    return RigidAxis(gain=gains.model_gain * _MM, damping=gains.model_damping), controller


def fig_8(w: Array, response: Callable[[Gains, Array], Complex]) -> dict[tuple[float, float], Complex]:
    """Return P/R' of Fig 8 by a' and b': K_V 0.1, K_P 4, K_I 11.8."""
    return {(a, b): response(Gains(1.0, 0.0, 0.1, 4.0, 11.8, a, b), w) for a, b in VARIED}


def _fig_8() -> Iterator[Row]:
    """Yield our controller against eq (16), and the largest changes by 25 % of a' or b', which the paper calls negligible."""
    w = np.geomspace(1.0, 25.0, 200)
    here, exact = fig_8(w, closed_loop), fig_8(w, equation_16)
    apart = max(float(np.abs(here[case] / exact[case] - 1.0).max()) for case in VARIED)
    note = "our controller on a'/(s (s + b'))"
    yield identity("Fig 8 P/R', eq 16: largest relative difference", "a' and b' varied", 0.0, apart, "", 1e-9, note)
    changes = {case: _change(here[case] / here[BASE]) for case in VARIED}
    note = "the largest of all variations, up to 25 rad/s, eight times the circle's frequency; the curves of Fig 8 nearly coincide"
    for i, (name, unit) in enumerate((("magnitude", "dB"), ("phase", "deg"))):
        (a, b), change = max(changes.items(), key=lambda item: item[1][i])
        yield ours(f"Fig 8 change of {name}", f"a' {a:g}, b' {b:g}", change[i], unit, note)


def equation_16(gains: Gains, w: Array) -> Complex:
    """Return P/R' of eq (16)."""
    a, b, v, p, i = gains.model_gain, gains.model_damping, gains.velocity_gain, gains.position_gain, gains.integral_gain
    s = 1j * w
    return np.asarray(a * p * i / (s**3 + (b + a * v) * s**2 + a * p * s + a * p * i))


def closed_loop(gains: Gains, w: Array) -> Complex:
    """Return P/R' of our controller with the ideal axis, in continuous time."""
    plant, controller = ideal_loop(gains)
    return axis_response(Axis("ideal", plant), AxisController(controller), w).modified


def _change(ratio: Complex) -> tuple[float, float]:
    """Return the largest changes of magnitude [dB] and phase [deg]."""
    return 20.0 * float(np.abs(np.log10(np.abs(ratio))).max()), float(np.degrees(np.abs(np.angle(ratio))).max())


def sampled_radius(gains: Gains, number: int) -> float:
    """Return the largest pole magnitude of the sampled loop of an axis, without friction, quantisation and limits."""
    bare = replace(axis(number, Reading()), friction=NoFriction(), sensor=IdealSensor(), drive=Saturation())
    made = axis_controller(gains, Reading())
    free = replace(made, controller=made.controller.replace(anti_windup="none"))
    path = Path([Line((0.0,), (1.0,))])
    loop = build(Machine("axis", (bare,), Reading().servo_period), Controller({bare.name: free}), path, np.zeros(1))
    return spectral_radius(loop.schedule)


def _oscillation_limit() -> Iterator[Row]:
    """Yield K_P and K_I at which the sampled loop with observer oscillates, and the Routh limit of eq (16)."""
    for number, start in TABLE_3.items():
        for name, symbol, unit in (("position_gain", "K_P", "full_scale/mm"), ("integral_gain", "K_I", "1/s")):

            def beyond(value: float, name: str = name, start: Gains = start, number: int = number) -> float:
                return sampled_radius(replace(start, **{name: value}), number) - 1.0

            note = "sampled loop with observer, from the compiled steps"
            if symbol == "K_I":
                routh = start.model_damping + start.model_gain * start.velocity_gain
                note += f"; eq 16 alone oscillates from K_I = b' + a' K_V = {routh:g} 1/s"
            limit = crossing(beyond, getattr(start, name), 1e4)
            yield ours(f"{symbol} at which the loop oscillates", f"axis {number}, Table III", limit, unit, note)


def crossing(function: Callable[[float], float], low: float, high: float) -> float:
    """Return where a function changes from negative to positive, to a relative 1e-6, by bisection in the logarithm."""
    while high > low * (1.0 + 1e-6):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if function(middle) < 0.0 else (low, middle)
    return low
