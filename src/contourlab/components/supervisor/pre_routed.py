"""Supervision by the position in the program."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import param, text_param
from contourlab.components.supervisor.switching import Supervisor, settled
from contourlab.engine.step import Port
from contourlab.errors import ParameterError
from contourlab.primitives import lookup, select


class PreRouted(Supervisor):
    """Assign a controller to each part of the motion in advance: number n_i from arc length s_i, or from program line l_i, onwards.

    Arc length is that of the planned path from its start. With ``by = "line"`` the last l_i at or before the current program line counts; a
    subroutine counts by its own lines. Before the first entry the axis' ``controller`` is active.

    References
    ----------
    Shahin, ElMaraghy & ElBeheiry, "On nonlinearity control of CNC feed drives", section "Supervisory control", after ElBeheiry, ElMaraghy &
    ElMaraghy, "The structured design of a reconfigurable control process", 14th CIRP Design Seminar (2004).
    """

    kind = "pre-routed"
    reference = "Shahin, ElMaraghy & ElBeheiry, supervisory control"
    reasons: ClassVar[tuple[str, ...]] = ("the program reached a switching place",)
    example = {"by": "arc-length", "places": (0.0, 0.3, 0.9), "lines": (0.0, 1.0, 2.0), "numbers": (1.0, 0.0, 2.0), "dwell_time": 3e-3}
    without_effect = (*Supervisor.without_effect, "lines")  # the example uses arc length
    inputs = (Port("arc_length"), Port("source_line"))
    tables = ("routes",)

    by: str = text_param(default="arc-length", choices=("arc-length", "line"), doc="what selects the controller")
    places: tuple[float, ...] = param(default=(0.0,), unit="m", vector=True, minimum=0.0, display="mm", doc="ascending arc lengths, s_i")
    lines: tuple[float, ...] = param(default=(0.0,), vector=True, minimum=0.0, whole=True, doc="ascending program lines, l_i")
    numbers: tuple[float, ...] = param(vector=True, minimum=0.0, whole=True, doc="controller number from there on, n_i")

    def check_values(self) -> None:
        name = "lines" if self.by == "line" else "places"
        if list(self._route) != sorted(set(self._route)):
            raise ParameterError(name, f"{list(self._route)}", "increasing")
        if len(self.numbers) != len(self._route):
            raise ParameterError("numbers", f"a list of {len(self.numbers)}", f"a list of {len(self._route)}, one for each of the {name}")

    @property
    def _route(self) -> tuple[float, ...]:
        return self.lines if self.by == "line" else self.places

    def table_values(self) -> dict[str, Array]:
        return {"routes": np.array([*self._route, *self.numbers])}

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, by: str, numbers: tuple[float, ...]) -> Any:
        place = inp.source_line if by == "line" else inp.arc_length
        wanted = 0.0
        for i in range(len(numbers)):
            wanted = select(place >= lookup(par.routes, float(i)), lookup(par.routes, float(len(numbers) + i)), wanted)
        return settled(x.active, x.since, wanted, 1.0, par.dwell_time, clock.dt)

    @property
    def n_controller(self) -> int:
        """Number of controllers to choose from."""
        return int(max(self.numbers)) + 1
