"""Ghaffari & Ulsoy, the position loop without simulation: gains, poles, variation of the plant, and stability limits."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import chain, product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.tick_map import spectral_radius
from contourlab.arrays import Array, Complex
from contourlab.components.controller.position import PositionController
from contourlab.components.drive.saturation import Saturation
from contourlab.components.friction.laws import NoFriction
from contourlab.components.ideal import IdealSensor
from contourlab.components.plant.rigid_axis import RigidAxis
from contourlab.geometry import Line, Path
from contourlab.loop.machine import Axis, AxisController, Controller, Machine
from contourlab.loop.template import build
from contourlab.papers.ghaffari.axis_response import axis_response
from contourlab.papers.ghaffari.setup import PLACED_POLES, TABLE_2, TABLE_3, Gains, Reading, axis, axis_controller
from contourlab.papers.rows import Row, derived, ours, printed

_MM = 1e-3
PARTS = ("real pole", "pair, real part", "pair, imaginary part")


def linear_rows() -> Iterator[Row]:
    """Yield the rows on Tables II and III, Fig 8, and the stability limits."""
    return chain(_table_2(), _poles(), _fig_8(), _oscillation_limit())


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
            yield printed(f"Table II {symbol}", f"axis {number}", getattr(gains, name), here, unit, DIGITS[name], note)


def ideal_loop(gains: Gains) -> tuple[RigidAxis, PositionController]:
    """Return the axis a'/(s (s + b')) and our controller in the structure of eq (16)."""
    controller = axis_controller(gains, Reading()).controller.replace(structure="ipv")
    assert isinstance(controller, PositionController)
    return RigidAxis(gain=gains.model_gain * _MM, damping=gains.model_damping), controller


def _split(poles: NDArray[Any]) -> tuple[float, float, float]:
    """Return the real pole of three, and the real and imaginary part of the pair [1/s]."""
    pair = poles[np.argmax(poles.imag)]
    return float(poles[np.argmin(np.abs(poles.imag))].real), float(pair.real), float(pair.imag)


def closed_loop_poles(gains: Gains) -> tuple[float, float, float]:
    """Return the real pole, and the real and imaginary part of the pair [1/s], of our controller with the ideal axis."""
    plant, control = (part.linearize() for part in ideal_loop(gains))
    seen = [control.inputs.index("position"), control.inputs.index("velocity")]
    push = plant.b[:, [plant.inputs.index("command")]]
    matrix = np.block([[plant.a + push @ control.d[:, seen], push @ control.c], [control.b[:, seen], control.a]])
    return _split(np.linalg.eigvals(matrix))


def characteristic_roots(gains: Gains) -> tuple[float, float, float]:
    """Return the real pole, and the real and imaginary part of the pair [1/s], from the denominator of eq (16)."""
    a, b, v, p, i = gains.model_gain, gains.model_damping, gains.velocity_gain, gains.position_gain, gains.integral_gain
    return _split(np.roots([1.0, b + a * v, a * p, a * p * i]))


def _poles() -> Iterator[Row]:
    w, zeta = PLACED_POLES["natural_frequency"], PLACED_POLES["damping"]
    wanted = (-PLACED_POLES["pole"], -zeta * w, w * math.sqrt(1.0 - zeta**2))
    for number, gains in TABLE_2.items():
        here = closed_loop_poles(gains)
        slack = np.abs(np.array([closed_loop_poles(corner) for corner in _corners(placed(gains))]) - wanted).max(axis=0)
        note = "our controller on a'/(s (s + b')) with the printed gains, against alpha, w_n and zeta; tolerance from the last digits"
        for part, paper, pole, most in zip(PARTS, wanted, here, slack, strict=True):
            yield derived(f"Table II {part}", f"axis {number}", paper, pole, "1/s", float(most), note)
    for number, gains in TABLE_3.items():
        identified = replace(gains, model_gain=TABLE_2[number].model_gain, model_damping=TABLE_2[number].model_damping)
        note = "Table III gains on the identified a', b': our controller against the roots of eq 16"
        for part, paper, pole in zip(PARTS, characteristic_roots(identified), closed_loop_poles(identified), strict=True):
            yield derived(f"Table III {part}", f"axis {number}", paper, pole, "1/s", 1e-6, note)


def _corners(gains: Gains) -> list[Gains]:
    """Return all combinations of gains changed by -1, 0 or 1 unit of the last printed digit."""
    moves = product(*((-digit, 0.0, digit) for digit in DIGITS.values()))
    return [replace(gains, **{name: getattr(gains, name) + step for name, step in zip(DIGITS, move, strict=True)}) for move in moves]


def _fig_8() -> Iterator[Row]:
    """Yield rows on the closed loop of eq (16) with K_V 0.1, K_P 4, K_I 11.8 and 25 % variation of a' = 800, b' = 20."""
    w = np.geomspace(1.0, 25.0, 200)
    base = Gains(1.0, 0.0, 0.1, 4.0, 11.8, 800.0, 20.0)
    note = "largest up to 25 rad/s, eight times the circle's frequency: our controller against eq 16; the curves of Fig 8 nearly coincide"
    for a, b in product((600.0, 800.0, 1000.0), (15.0, 20.0, 25.0)):
        varied, case = replace(base, model_gain=a, model_damping=b), f"a' {a:g}, b' {b:g}"
        apart = float(np.abs(closed_loop(varied, w) / equation_16(varied, w) - 1.0).max())
        words = "our controller on a'/(s (s + b')), 1 to 25 rad/s"
        yield derived("Fig 8 P/R', eq 16: largest relative difference", case, 0.0, apart, "", 1e-9, words)
        if varied == base:
            continue
        paper, here = (_change(closed(varied, w) / closed(base, w)) for closed in (equation_16, closed_loop))
        for name, unit, said, got in zip(("magnitude", "phase"), ("dB", "deg"), paper, here, strict=True):
            yield derived(f"Fig 8 change of {name}", case, said, got, unit, 1e-6, note)


def equation_16(gains: Gains, w: Array) -> Complex:
    """Return P/R' of eq (16)."""
    a, b, v, p, i = gains.model_gain, gains.model_damping, gains.velocity_gain, gains.position_gain, gains.integral_gain
    s = 1j * w
    return np.asarray(a * p * i / (s**3 + (b + a * v) * s**2 + a * p * s + a * p * i))


def closed_loop(gains: Gains, w: Array) -> Complex:
    """Return P/R' of our controller with the ideal axis, in continuous time."""
    plant, controller = ideal_loop(gains)
    return axis_response(Axis("ideal", plant), AxisController(controller), 0.0, w).modified


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
