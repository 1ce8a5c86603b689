"""The tuned loop in the terms of other controls: a velocity loop inside a position loop, with feedforward.

The axis v' = g u - d v under ``pid`` obeys v' = (V - v) / T with the set velocity

    V = Kv (e + 1/Tn integral of e) + w r' + Ka r''

where K = D + d/g is the gain of the velocity loop (the damping of the axis acts as velocity feedback), T = 1/(g K), Kv = P/K, Tn = P/I,
w = (D + FF1 - P Ts)/K and Ka = FF2/K. With ``error-previous-target`` the error lags by the servo period Ts, else Ts is 0.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from contourlab.arrays import Array
from contourlab.features.commission.identification import IdentifiedAxis
from contourlab.figures import figure
from contourlab.rendering.table import Column, Table

EXACT, CHOICE, START, DRIVE, NONE = "exact", "choice", "start value", "to reach in the drive", "no equivalent"


@dataclass(frozen=True)
class Cascade:
    """An axis and its gains as a cascade, in SI.

    Attributes
    ----------
    kv : float [1/s]
    reset : float [s]
        Integral time of the position loop; inf without an integral.
    weight : float
        Velocity feedforward.
    ahead : float [s]
        Set velocity per acceleration.
    gain, velocity_gain : float [output per m/s]
        Of the velocity loop, and the part of it in the ``pid``.
    lag : float [s]
        Time constant of the velocity loop, and the delay beyond the hold.
    output_ahead : float [output per m/s^2]
        FF2.
    friction : float [output]
    play : float [m]
    """

    kv: float
    reset: float
    weight: float
    ahead: float
    gain: float
    velocity_gain: float
    lag: float
    output_ahead: float
    friction: float
    play: float


def cascade_of(gains: Array, axis: IdentifiedAxis) -> Cascade:
    """Return the cascade that does what gains (7,) [per metre] do on an axis."""
    p, i, d, _, ff1, ff2, _ = gains.tolist()
    model, law = axis.model, axis.law
    gain = max(d + model.per_speed, 1e-12)
    late = p * law.period if law.previous_target else 0.0
    lag = 1.0 / (model.gain * d + model.damping) + max(model.delay, 0.0)
    reset = p / i if i else math.inf
    return Cascade(p / gain, reset, (d + ff1 - late) / gain, ff2 / gain, gain, d, lag, ff2, model.friction / model.gain, axis.play)


Row = tuple[str, str, str, Callable[[Cascade], float]]
"""Name, unit, how it maps, and value of a parameter."""

CONTROLS: dict[str, tuple[Row, ...]] = {
    "sinumerik": (
        ("MD32200 POSCTRL_GAIN", "1000/min", EXACT, lambda c: 0.06 * c.kv),
        ("MD32620 FFW_MODE", "", CHOICE, lambda c: 3.0),
        ("MD32610 VELO_FFW_WEIGHT", "", EXACT, lambda c: min(c.weight, 1.0)),
        ("MD32810 EQUIV_SPEEDCTRL_TIME", "s", DRIVE, lambda c: c.lag),
        ("MD32450 BACKLASH", "mm", EXACT, lambda c: 1e3 * c.play),
        ("MD32490 FRICT_COMP_MODE", "", CHOICE, lambda c: 1.0),
        ("MD32500 FRICT_COMP_ENABLE", "", CHOICE, lambda c: 1.0),
        ("MD32520 FRICT_COMP_CONST_MAX", "mm/min", START, lambda c: 6e4 * 2.0 * c.friction / c.gain),
        ("Igain, FF2", "", NONE, lambda c: math.nan),
    ),
    "twincat": (
        ("Position control: Proportional Factor Kv", "1/s", EXACT, lambda c: c.kv),
        ("Position control: Integral Action Time Tn", "s", EXACT, lambda c: c.reset),
        ("Feedforward Velocity: Pre-Control Weighting", "", EXACT, lambda c: min(c.weight, 1.0)),
        ("Feedforward Acceleration: Proportional Factor Ka", "s", EXACT, lambda c: c.ahead),
        ("MC_BacklashCompensation.Backlash", "mm", EXACT, lambda c: 1e3 * c.play),
        ("velocity loop of the drive: time constant", "s", DRIVE, lambda c: c.lag),
        ("friction", "", NONE, lambda c: math.nan),
    ),
    "generic": (
        ("Kv", "1/s", EXACT, lambda c: c.kv),
        ("velocity feedforward", "%", EXACT, lambda c: 100.0 * c.weight),
        ("velocity loop: gain Kp", "output/(mm/s)", EXACT, lambda c: 1e-3 * c.velocity_gain),
        ("velocity loop: integral time Ti", "s", START, lambda c: c.reset),
        ("velocity loop: time constant", "ms", DRIVE, lambda c: 1e3 * c.lag),
        ("acceleration feedforward", "output/(mm/s^2)", EXACT, lambda c: 1e-3 * c.output_ahead),
        ("friction feedforward", "output", EXACT, lambda c: c.friction),
        ("backlash", "mm", EXACT, lambda c: 1e3 * c.play),
    ),
}


@dataclass(frozen=True)
class Term:
    """A parameter of a control.

    Attributes
    ----------
    name, unit : str
    maps : str
        "exact", "choice", "start value", "to reach in the drive", or "no equivalent".
    values : dict of str to float
        By axis; nan where nothing is known.
    """

    name: str
    unit: str
    maps: str
    values: dict[str, float]


def terms_of(control: str, cascades: Mapping[str, Cascade]) -> tuple[Term, ...]:
    """Return the parameters of a control for each axis."""
    return tuple(Term(name, unit, maps, {a: value(c) for a, c in cascades.items()}) for name, unit, maps, value in CONTROLS[control])


def term_table(terms: tuple[Term, ...]) -> Table:
    """Return the parameters as a table, with a column for each axis."""
    columns = [Column("parameter", left=True), *map(Column, terms[0].values), Column("unit", left=True), Column("maps", left=True)]
    shown = ([figure(value) if math.isfinite(value) else "-" for value in term.values.values()] for term in terms)
    return Table(columns, rows=((term.name, *values, term.unit, term.maps) for term, values in zip(terms, shown, strict=True)))
