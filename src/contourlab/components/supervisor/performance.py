"""Supervision by a measured error."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np

from contourlab.components.contract import param, text_param
from contourlab.components.supervisor.switching import Supervisor, settled
from contourlab.engine.step import Port
from contourlab.errors import ParameterError
from contourlab.primitives import fabs, select, sqrt

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
    reference = "Shahin, ElMaraghy & ElBeheiry, supervisory control"
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
        time = np.asarray(par.averaging_time, dtype=float)
        return (np.where(time > 0.0, -np.expm1(-dt / np.where(time > 0.0, time, 1.0)), 1.0),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, measure: str, thresholds: tuple[float, ...], order: str) -> Any:
        now, count = MEASURES[measure](inp), float(len(thresholds))
        square = x.square + par.weight * (now * now - x.square)
        seen = sqrt(square) if par.weight < 1.0 else fabs(now)
        level, rank = 0.0, count - x.active if order == "falling" else x.active
        for i in range(len(thresholds)):
            # Hysteresis lowers the thresholds below the active rank and raises the others.
            edge = thresholds[i] + select(rank > float(i), -par.hysteresis, par.hysteresis)
            level = level + select(seen > edge, 1.0, 0.0)
        wanted = count - level if order == "falling" else level
        (active, since), out = settled(x.active, x.since, wanted, select(level > rank, 1.0, 2.0), par.dwell_time, clock.dt)
        return (active, since, square), out

    @property
    def n_controller(self) -> int:
        """Number of controllers to choose from."""
        return len(self.thresholds) + 1
