"""The loop of a log in the terms of controls: what is in force, and what takes the following error away."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import inf, nan

from contourlab.features.commission.log_loop import Bounds

UNKNOWN = Bounds(nan, -inf, inf)


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


Row = tuple[str, str, str, float, Callable[[Mapping[str, Bounds]], float]]
"""Name, unit, figure that it is, factor, and what is proposed."""


def _stays(x: Mapping[str, Bounds]) -> float:
    return nan


def _where_known(value: float) -> Callable[[Mapping[str, Bounds]], float]:
    return lambda x: value if "equivalent_time" in x else nan


def _time(factor: float) -> Callable[[Mapping[str, Bounds]], float]:
    return lambda x: factor * x.get("equivalent_time", UNKNOWN).value


TERMS: dict[str, tuple[Row, ...]] = {
    "generic": (
        ("Kv", "1/s", "Kv", 1.0, _stays),
        ("velocity feedforward", "%", "velocity_feedforward", 100.0, _where_known(100.0)),
        ("acceleration feedforward", "ms", "", 1.0, _time(1e3)),
        ("velocity loop: time constant", "ms", "equivalent_time", 1e3, _stays),
    ),
    "sinumerik": (
        ("MD32200 POSCTRL_GAIN", "1000/min", "Kv", 0.06, _stays),
        ("MD32610 VELO_FFW_WEIGHT", "", "velocity_feedforward", 1.0, _where_known(1.0)),
        ("MD32620 FFW_MODE", "", "", 1.0, _where_known(3.0)),
        ("MD32810 EQUIV_SPEEDCTRL_TIME", "s", "equivalent_time", 1.0, _time(1.0)),
        ("MD32650 AX_INERTIA", "kg", "mass", 1.0, _stays),
    ),
    "twincat": (
        ("Proportional Factor Kv", "1/s", "Kv", 1.0, _stays),
        ("Pre-Control Weighting", "", "velocity_feedforward", 1.0, _where_known(1.0)),
        ("Proportional Factor Ka", "s", "", 1.0, _time(1.0)),
    ),
    "cia402": (
        ("position loop: gain", "1/s", "Kv", 1.0, _stays),
        ("0x60B1 velocity offset", "set velocity", "velocity_feedforward", 1.0, _where_known(1.0)),
        ("0x60B2 torque offset", "kg set acceleration", "mass", 1.0, _stays),
    ),
}


def terms_of_log(control: str, figures: Mapping[str, Bounds]) -> tuple[LogTerm, ...]:
    """Return the parameters of a control for the figures of an axis."""

    def scaled(name: str, factor: float) -> Bounds:
        of = figures.get(name, UNKNOWN)
        return Bounds(factor * of.value, factor * of.low, factor * of.high)

    return tuple(LogTerm(name, unit, scaled(key, factor), wanted(figures)) for name, unit, key, factor, wanted in TERMS[control])
