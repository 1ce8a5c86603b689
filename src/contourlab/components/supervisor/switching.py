"""Supervisors: they follow a gap observer, a measured error, or the position in the program."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import Component, param, text_param
from contourlab.engine.step import Port
from contourlab.errors import ParameterError
from contourlab.primitives import fabs, lookup, select, sqrt

STEADY = 0.0
"""Reason of a tick without a switch."""


class Supervisor(Component):
    """Base of the supervisors, which switch between controllers.

    Output ``active`` is 0 for the axis' ``controller`` and 1, 2 ... for those of ``others``. Output ``reason`` is `STEADY`; at the tick of
    a switch it is the number of an entry of `reasons`, counted from 1.

    Attributes
    ----------
    reasons : tuple of str
        Texts of the reasons; ``{name}`` becomes the name of the new controller.
    """

    family = "supervisor"
    reasons: ClassVar[tuple[str, ...]] = ()
    states: ClassVar[tuple[Port, ...]] = (Port("active"), Port("since"))

    handover_time: float = param(default=5e-3, unit="s", minimum=0.0, display="ms", doc="time constant of a handover; 0: a jump")
    dwell_time: float = param(default=0.0, unit="s", minimum=0.0, display="ms", doc="shortest time from one switch to the next")
    without_effect: ClassVar[tuple[str, ...]] = ("handover_time",)  # it acts on the hand-over, not in the step


def settled(active: float, since: float, wanted: float, reason: float, dwell_time: float, dt: float) -> tuple[Any, Any]:
    """Return next states and outputs of a supervisor: it switches to `wanted` if `dwell_time` has passed `since` the last switch."""
    switches = select(wanted == active, 0.0, select(since >= dwell_time, 1.0, 0.0)) > 0.5
    now = select(switches, wanted, active)
    return (now, select(switches, 0.0, since) + dt), (now, select(switches, reason, STEADY))


class EstimatorBased(Supervisor):
    """Follow the gap observer: the first of ``others`` is active in the gap, the axis' ``controller`` in contact.

    Below `confidence` the ``controller`` is active: a contact controller also works in the gap, if less well.

    References
    ----------
    Shahin, ElMaraghy & ElBeheiry, "On nonlinearity control of CNC feed drives", section "Supervisory control".
    """

    kind = "estimator-based"
    reference = "Shahin, ElMaraghy & ElBeheiry 2005, supervisory control"
    reasons: ClassVar[tuple[str, ...]] = ("the observer sees the gap", "the observer sees contact", "the observer is not certain enough")
    example = {"confidence": 0.3, "dwell_time": 3e-3}
    inputs = (Port("gap_state"), Port("confidence"))
    n_controller = 2

    confidence: float = param(default=0.5, minimum=0.0, maximum=1.0, doc="observer confidence below which the contact controller is active")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        sure = inp.confidence >= par.confidence
        free = select(sure, select(fabs(inp.gap_state) < 0.5, 1.0, 0.0), 0.0)
        return settled(x.active, x.since, free, select(sure, select(free > 0.5, 1.0, 2.0), 3.0), par.dwell_time, clock.dt)


MEASURES: dict[str, Callable[[Any], Any]] = {
    "motor-load-difference": lambda inp: inp.motor_position - inp.load_position,
    "tracking-error": lambda inp: inp.reference - inp.position,
    "load-error": lambda inp: inp.reference - inp.load_position,
}


class Performance(Supervisor):
    """Choose the active controller by the size of a measured error: each threshold passed selects the next controller.

    ``measure = "motor-load-difference"`` is that of the paper: with half the backlash gap as the only threshold and ``order = "falling"``,
    the axis' ``controller`` is active in contact and the first of ``others`` in the gap. "tracking-error" is the reference minus the
    position that the controller sees, "load-error" the reference minus the load position. `averaging_time` makes the measure a root mean
    square over about that time. `hysteresis` widens each threshold in both directions. The next switch comes after `dwell_time` at the
    earliest.

    References
    ----------
    Shahin, ElMaraghy & ElBeheiry, "On nonlinearity control of CNC feed drives", section "Supervisory control"; hysteresis and dwell time:
    Hespanha & Morse, "Stability of switched systems with average dwell-time", Proc. 38th IEEE CDC (1999).
    """

    kind = "performance"
    reference = "Shahin, ElMaraghy & ElBeheiry 2005, supervisory control; Hespanha & Morse 1999"
    reasons: ClassVar[tuple[str, ...]] = ("the measure rose past a threshold", "the measure fell below a threshold")
    example = {
        "measure": "tracking-error",
        "thresholds": (0.3, 0.9),
        "hysteresis": 0.05,
        "averaging_time": 2e-3,
        "dwell_time": 3e-3,
        "order": "rising",
    }
    states: ClassVar[tuple[Port, ...]] = (*Supervisor.states, Port("square"))
    inputs = (Port("reference"), Port("position"), Port("motor_position"), Port("load_position"))
    derived = ("weight",)

    measure: str = text_param(default="motor-load-difference", choices=tuple(MEASURES), doc="what is monitored")
    thresholds: tuple[float, ...] = param(unit="m", vector=True, minimum=0.0, display="um", doc="of the measure's magnitude, ascending")
    order: str = text_param(default="falling", choices=("falling", "rising"), doc="falling: the last controller is for small measures")
    hysteresis: float = param(default=0.0, unit="m", minimum=0.0, display="um", doc="margin by which a threshold must be passed")
    averaging_time: float = param(default=0.0, unit="s", minimum=0.0, display="ms", doc="of the root mean square; 0: magnitude itself")

    def check_values(self) -> None:
        if list(self.thresholds) != sorted(set(self.thresholds)):
            raise ParameterError("thresholds", f"{list(self.thresholds)} m", "increasing")
        if not self.hysteresis < self.thresholds[0]:
            raise ParameterError("hysteresis", f"{self.hysteresis:g}", f"< {self.thresholds[0]:g}, the first threshold", "m")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        time = par.averaging_time
        return (np.where(time > 0.0, -np.expm1(-dt / np.where(time > 0.0, time, 1.0)), 1.0),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, measure: str, thresholds: tuple[float, ...], order: str) -> Any:
        now, count = MEASURES[measure](inp), float(len(thresholds))
        square = x.square + par.weight * (now * now - x.square)
        seen = sqrt(square) if par.weight < 1.0 else fabs(now)
        level, rank = 0.0, count - x.active if order == "falling" else x.active
        for i in range(len(thresholds)):
            # Hysteresis lowers the thresholds below the active rank and raises the others.
            level = level + select(seen > thresholds[i] + select(rank > float(i), -par.hysteresis, par.hysteresis), 1.0, 0.0)
        wanted = count - level if order == "falling" else level
        (active, since), out = settled(x.active, x.since, wanted, select(level > rank, 1.0, 2.0), par.dwell_time, clock.dt)
        return (active, since, square), out

    @property
    def n_controller(self) -> int:
        """Number of controllers to choose from."""
        return len(self.thresholds) + 1


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
    reference = "Shahin, ElMaraghy & ElBeheiry 2005, supervisory control"
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

    @property
    def n_place(self) -> int:
        """Number of places at which the controller changes."""
        return len(self.numbers)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, by: str, n_place: int) -> Any:
        place = inp.source_line if by == "line" else inp.arc_length
        wanted = 0.0
        for i in range(n_place):
            wanted = select(place >= lookup(par.routes, float(i)), lookup(par.routes, float(n_place + i)), wanted)
        return settled(x.active, x.since, wanted, 1.0, par.dwell_time, clock.dt)

    @property
    def n_controller(self) -> int:
        """Number of controllers to choose from."""
        return int(max(self.numbers)) + 1
