"""Supervision by the place in the program."""

from __future__ import annotations

from functools import cache
from typing import Any, ClassVar

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import param, text_param
from contourlab.components.supervisor.switching import Supervisor, settled
from contourlab.engine.step import Port
from contourlab.errors import ParameterError
from contourlab.primitives import lookup, select


class PreRouted(Supervisor):
    """The active controller is laid down beforehand for each part of the motion: number n_i from the arc length s_i, or the line l_i, on.

    Arc lengths are those of the planned path from its start. By lines it is the last of them that does not come after the line of the
    program that is being carried out; before the first one it is the axis' ``controller``. A subroutine is at its own lines.

    References
    ----------
    Shahin, ElMaraghy & ElBeheiry, "On nonlinearity control of CNC feed drives", section "Supervisory control", after ElBeheiry, ElMaraghy &
    ElMaraghy, "The structured design of a reconfigurable control process", 14th CIRP Design Seminar (2004).
    """

    kind = "pre-routed"
    reference = "Shahin, ElMaraghy & ElBeheiry, supervisory control"
    reasons: ClassVar[tuple[str, ...]] = ("the program has come to a place that is laid down for it",)
    example = {"by": "arc-length", "places": (0.0, 0.3, 0.9), "lines": (0.0, 1.0, 2.0), "numbers": (1.0, 0.0, 2.0), "dwell_time": 3e-3}
    without_effect = (*Supervisor.without_effect, "lines")  # in the example, which goes by arc length
    inputs = (Port("arc_length"), Port("source_line"))
    tables = ("routes",)

    by: str = text_param(default="arc-length", choices=("arc-length", "line"), doc="what the route is laid down along")
    places: tuple[float, ...] = param(default=(0.0,), unit="m", vector=True, minimum=0.0, display="mm", doc="rising arc lengths, s_i")
    lines: tuple[float, ...] = param(default=(0.0,), vector=True, minimum=0.0, whole=True, doc="lines of the program, rising, l_i")
    numbers: tuple[float, ...] = param(vector=True, minimum=0.0, whole=True, doc="number of the controller from there on, n_i")

    def __init__(self, **values: Any) -> None:
        super().__init__(**values)
        name = "lines" if self.by == "line" else "places"
        if list(self._route) != sorted(set(self._route)):
            raise ParameterError(name, f"{list(self._route)}", "rising")
        if len(self.numbers) != len(self._route):
            raise ParameterError("numbers", f"{len(self.numbers)} of them", f"{len(self._route)}, one for each of the {name}")

    @property
    def _route(self) -> tuple[float, ...]:
        return self.lines if self.by == "line" else self.places

    def table_values(self) -> dict[str, Array]:
        return {"routes": np.array([*self._route, *self.numbers])}

    def step_function(self) -> Any:
        return _routed(len(self._route), self.by == "line")

    @property
    def n_controller(self) -> int:
        """How many controllers it chooses from."""
        return int(max(self.numbers)) + 1


@cache
def _routed(n: int, by_line: bool) -> Any:
    count = float(n)

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        place = inp.source_line if by_line else inp.arc_length
        wanted = 0.0
        for i in range(n):
            wanted = select(place >= lookup(par.routes, float(i)), lookup(par.routes, count + float(i)), wanted)
        return settled(x.active, x.since, wanted, 1.0, par.dwell_time, clock.dt)

    return step
