"""A force from a table over time or position."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.components.contract import Component, Port, param, text_param
from contourlab.errors import ParameterError
from contourlab.primitives import clip, floor, lookup

__all__ = ["TableLoad"]


@cache
def _make(over_time: bool, repeat: bool) -> Any:
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        where = clock.t if over_time else inp.position
        u = (where - par.origin) * par.inverse_step
        u = u - par.intervals * floor(u / par.intervals) if repeat else clip(u, 0.0, par.intervals)
        i = clip(floor(u), 0.0, par.intervals - 1.0)
        low = lookup(par.values_table, i)
        return (), (low + (u - i) * (lookup(par.values_table, i + 1.0) - low),)

    return step


class TableLoad(Component):
    """A force given at evenly spaced times or positions, linear between them: measured cutting forces, force ripple, cogging.

    With `beyond = "hold"` the first and last values hold outside the table; with ``"repeat"`` the table repeats, its last point being the
    first of the next turn.
    """

    family = "disturbance"
    kind = "table"
    example = {
        "over": "position",
        "beyond": "hold",
        "origin": -0.3,
        "step_size": 0.2,
        "values_given": (0.0, 1.0, -0.5, 2.0),
    }
    unbounded = ("origin", "values_given")
    inputs = (Port("position"),)
    outputs = (Port("force"),)
    tables = ("values_table",)
    derived = ("inverse_step", "intervals")

    over: str = text_param(default="time", choices=("time", "position"), doc="what the table is over")
    beyond: str = text_param(default="hold", choices=("hold", "repeat"), doc="what holds outside the table")
    origin: float = param(default=0.0, unit="", doc="time [s] or position [m] of the first value")
    step_size: float = param(unit="", minimum=0.0, exclusive=True, doc="time [s] or distance [m] between two values")
    values_given: tuple[float, ...] = param(unit="{force}", vector=True, doc="the forces; at least two")

    def __init__(self, **values: Any) -> None:
        super().__init__(**values)
        if len(self.values_given) < 2:
            raise ParameterError("values_given", f"{list(self.values_given)}", "a list of at least two numbers", "force")

    def step_function(self) -> Any:
        return _make(self.over == "time", self.beyond == "repeat")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return 1.0 / par.step_size, float(len(self.values_given) - 1)

    def table_values(self) -> dict[str, NDArray[np.float64]]:
        return {"values_table": np.array(self.values_given)}
