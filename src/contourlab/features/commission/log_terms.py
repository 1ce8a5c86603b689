"""The loop of a log in the terms of controls: what is in force, and what takes the following error away."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import inf, nan

from contourlab.analysis.identification.least_squares import Bounds

TIME = "equivalent_time"
UNKNOWN = Bounds(nan, -inf, inf)
TERMS: dict[str, tuple[tuple[str, str, str, float, float, str], ...]] = {
    "generic": (
        ("Kv", "1/s", "Kv", 1.0, nan, ""),
        ("velocity feedforward", "%", "velocity_feedforward", 100.0, 100.0, ""),
        ("acceleration feedforward", "ms", "", 1.0, 1e3, TIME),
        ("velocity loop: time constant", "ms", TIME, 1e3, nan, ""),
    ),
    "sinumerik": (
        ("MD32200 POSCTRL_GAIN", "1000/min", "Kv", 0.06, nan, ""),
        ("MD32610 VELO_FFW_WEIGHT", "", "velocity_feedforward", 1.0, 1.0, ""),
        ("MD32620 FFW_MODE", "", "", 1.0, 3.0, ""),
        ("MD32810 EQUIV_SPEEDCTRL_TIME", "s", TIME, 1.0, 1.0, TIME),
    ),
    "twincat": (
        ("Proportional Factor Kv", "1/s", "Kv", 1.0, nan, ""),
        ("Pre-Control Weighting", "", "velocity_feedforward", 1.0, 1.0, ""),
        ("Proportional Factor Ka", "s", "", 1.0, 1.0, TIME),
    ),
    "cia402": (
        ("position loop: gain", "1/s", "Kv", 1.0, nan, ""),
        ("0x60B1 velocity offset", "of set velocity", "velocity_feedforward", 1.0, 1.0, ""),
    ),
}
"""Name, unit, figure that it is and its factor; and what is proposed: a number, or a number times a figure."""


@dataclass(frozen=True)
class LogTerm:
    """A parameter of a control.

    Attributes
    ----------
    name, unit : str
    value : Bounds
        As the log shows it; nan where it does not.
    proposed : float
        nan: it stays, or the log does not give it.
    """

    name: str
    unit: str
    value: Bounds
    proposed: float


def terms_of_log(control: str, x: Mapping[str, Bounds]) -> tuple[LogTerm, ...]:
    """Return the parameters of a control for the figures of an axis; without a time constant nothing is proposed."""
    terms = []
    for name, unit, key, factor, wanted, of in TERMS[control]:
        shown, known = x.get(key, UNKNOWN), x.get(of or TIME, UNKNOWN).value
        value = Bounds(factor * shown.value, factor * shown.low, factor * shown.high)
        terms.append(LogTerm(name, unit, value, wanted * known if of else wanted + 0.0 * known))
    return tuple(terms)
