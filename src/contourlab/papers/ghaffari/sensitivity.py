"""Ghaffari & Ulsoy, Figs 6 and 7: contour error over each parameter of eq 19 around Table III, and its minima.

The figures have no numbers; Table III was "obtained from the empirical sensitivity analysis". Axis 1 is studied in configuration A3-A1,
axes 2 and 3 in A3-A2, where the paper calibrates them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import astuple, replace
from functools import cache
from itertools import chain

import numpy as np

from contourlab.features.sensitivity.curves import Curve, Slope, curves, local
from contourlab.papers.ghaffari.setup import FITTED, TABLE_3, Gains, Reading, circle, controller, machine
from contourlab.papers.rows import COMPUTED, DERIVED, Row, ours, printed
from contourlab.study import Runner, Setting, Space

BOUNDS = {
    "observer.model_gain": ("a_hat", "200 mm/s^2/full_scale..3000 mm/s^2/full_scale"),
    "observer.model_damping": ("b_hat", "7 1/s..75 1/s"),
    "controller.model_gain": ("a'", "300 mm/s^2/full_scale..2700 mm/s^2/full_scale"),
    "controller.model_damping": ("b'", "8 1/s..90 1/s"),
    "controller.velocity_gain": ("K_V", "0.01 full_scale*s/mm..3 full_scale*s/mm"),
    "controller.position_gain": ("K_P", "0.5 full_scale/mm..100 full_scale/mm"),
    "controller.integral_gain": ("K_I", "1 1/s..300 1/s"),
}
"""Parameters of eq 19: symbol and range; about a factor of three up and down for feedforward and observer."""
NAMES = tuple(name for name, _ in BOUNDS.values())
MODEL = NAMES[:4]
SLOPES = ("a_hat", "K_P", "K_I")
"""Parameters whose local sensitivity has a row; that of the other three of the ratio is alike, that of K_V nearly zero."""
WITH = {1: 1, 2: 2, 3: 2}
"""Partner of axis 3 in the configuration in which each axis is studied."""
AGREES = 0.05
"""Relative tolerance, as for the integrals of Fig 9."""
STATED = Reading()
_MICRO = 1e6
FIGURE = "contour_error_integral"


def sensitivity_rows() -> Iterator[Row]:
    """Yield the rows of Figs 6 and 7."""
    return chain(_minima(), _fitted_minima(), _same_curves(), _slopes(), _large_gains())


@cache
def _studied(number: int, reading: Reading = STATED, symbols: Sequence[str] = NAMES) -> tuple[Space, Runner]:
    """Return parameters of an axis around Table III, and the runs of its configuration."""
    first = WITH[number]
    made, stage = controller(first, TABLE_3, reading), machine(first, reading)
    texts = [f"controller.axes.{number}.{name}={bounds}" for name, (symbol, bounds) in BOUNDS.items() if symbol in symbols]
    return Space.chosen(stage, made, texts), Runner(Setting(stage, made, circle(reading)))


@cache
def axis_curves(number: int) -> dict[str, Curve]:
    """Return the curves of an axis by symbol: the integral of the contour error [m s] over 41 values of each parameter [SI]."""
    space, runs = _studied(number)
    return dict(zip(NAMES, curves(space, runs.judge(FIGURE)), strict=True))


@cache
def _axis_slopes(number: int) -> dict[str, Slope]:
    space, runs = _studied(number, symbols=SLOPES)
    return dict(zip(SLOPES, local(space, runs.judge(FIGURE)).slopes, strict=True))


def _gains(number: int) -> dict[str, float]:
    """Return the line of Table III by symbol."""
    a_hat, b_hat, k_v, k_p, k_i, a, b = astuple(TABLE_3[number])
    return {"a_hat": a_hat, "b_hat": b_hat, "a'": a, "b'": b, "K_V": k_v, "K_P": k_p, "K_I": k_i}


def _ratio(values: dict[str, float]) -> float:
    """Return the ratio of the steady gain of the axis with observer to the steady gain that the feedforward inverts."""
    return values["a_hat"] / values["b_hat"] / (values["a'"] / values["b'"])


def _moved(number: int, name: str) -> dict[str, float]:
    """Return the line of Table III with one parameter at its minimum."""
    curve = axis_curves(number)[name]
    assert curve.minimum is not None
    return _gains(number) | {name: curve.variable.display_value(curve.minimum.value)}


def _minima() -> Iterator[Row]:
    """Yield the minimum of the error over each parameter of observer and feedforward, the others as in Table III."""
    for number in TABLE_3:
        for name in MODEL:
            curve, paper = axis_curves(number)[name], _gains(number)[name]
            assert curve.minimum is not None
            here, lowest = _moved(number, name)[name], _MICRO * curve.minimum.figure
            at_paper = _MICRO * float(np.interp(curve.variable.value, curve.values, curve.figures))
            case = f"axis {number} in A3-A{WITH[number]}, the others as in Table III"
            note = (
                f"integral {lowest:.3g} um s at the minimum, {at_paper:.3g} at Table III. In the model the four act as one ratio of steady "
                f"gains, (a_hat/b_hat)/(a'/b'): {_ratio(_gains(number)):.3f} in Table III, {_ratio(_moved(number, name)):.3f} here. So "
                "only one of them counts"
            )
            unit, kind = curve.variable.display, COMPUTED if name == MODEL[0] else DERIVED
            yield printed(f"minimum over {name}", case, paper, here, unit, AGREES * paper, note, kind=kind)


def _fitted_minima() -> Iterator[Row]:
    """Yield the minimum over a_hat under the fitted filters, which were not fitted to it."""
    for number, gains in TABLE_3.items():
        space, runs = _studied(number, FITTED, MODEL[:1])
        (curve,) = curves(space, runs.judge(FIGURE))
        assert curve.minimum is not None
        here, paper = curve.variable.display_value(curve.minimum.value), gains.observer_gain
        case, words = f"axis {number} in A3-A{WITH[number]}", "filters fitted to the two printed integrals"
        unit, note = curve.variable.display, "a prediction of these filters"
        yield printed(f"minimum over {MODEL[0]}, fitted filters", case, paper, here, unit, AGREES * paper, note, reading=words, main=False)


def _same_curves() -> Iterator[Row]:
    """Yield the largest difference between the curves of axes 1 and 2, which are equal in the paper's simulations."""
    for name in MODEL[2:]:
        first, second = (axis_curves(number)[name].figures for number in (1, 2))
        apart = 100.0 * float(np.max(np.abs(first / second - 1.0)))
        note = 'the paper on its simulations: "the same sensitivity curves for the feedforward parameters of Axis-1"'
        yield ours("curves of axis 1 and axis 2 apart, at most", name, apart, "%", note)


def _slopes() -> Iterator[Row]:
    """Yield normalised local sensitivities at Table III."""
    for number in TABLE_3:
        for name, slope in _axis_slopes(number).items():
            step = f"percent of the integral per percent of the parameter; step {100.0 * slope.step:.2g} %"
            note = slope.doubt.text if slope.doubt else step
            yield ours("local sensitivity at Table III", f"axis {number}, {name}", slope.sensitivity, "%/%", note)


def _large_gains() -> Iterator[Row]:
    """Yield the effect of doubling K_P and K_I: at Table III, and with a feedforward that fits the axis."""
    fitting = {n: replace(TABLE_3[n], model_gain=_moved(n, "a'")["a'"]) for n in TABLE_3}
    for number in (2, 3):
        for words, table in (("Table III", TABLE_3), ("a' at its minimum on both axes", fitting)):
            before, *after = _integrals(number, table)
            for name, value in zip(("K_P", "K_I"), after, strict=True):
                case = f"axis {number}, {words}, {name} doubled"
                note = (
                    f"of {before:.3g} um s; the paper: K_P and K_I, if chosen large enough, have a negligible effect. "
                    "They reduce the error that the feedforward leaves, and have little effect if it fits"
                )
                yield ours("change of the integral", case, value - before, "um s", note)


def _integrals(number: int, table: dict[int, Gains]) -> list[float]:
    """Return the integral [um s] unchanged, with K_P doubled, and with K_I doubled."""
    reading, first = Reading(), WITH[number]
    made, stage = controller(first, table, reading), machine(first, reading)
    part = made.axes[str(number)].controller
    head = f"controller.axes.{number}.controller"
    factors = {"position_gain": [1.0, 2.0, 1.0], "integral_gain": [1.0, 1.0, 2.0]}
    columns = {f"{head}.{name}": float(getattr(part, name)) * np.array(factor) for name, factor in factors.items()}
    return [float(value) for value in _MICRO * Runner(Setting(stage, made, circle(reading)))(columns)[FIGURE]]
