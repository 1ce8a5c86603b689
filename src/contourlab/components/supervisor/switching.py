"""Base of the supervisors, and the supervisor that follows a gap observer."""

from __future__ import annotations

from typing import Any, ClassVar

from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.primitives import fabs, select

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
    reference = "Shahin, ElMaraghy & ElBeheiry, supervisory control"
    reasons: ClassVar[tuple[str, ...]] = ("the observer sees the gap", "the observer sees contact", "the observer is not certain enough")
    example = {"confidence": 0.3, "dwell_time": 3e-3}
    inputs = (Port("gap_state"), Port("confidence"))

    confidence: float = param(default=0.5, minimum=0.0, maximum=1.0, doc="observer confidence below which the contact controller is active")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        sure = inp.confidence >= par.confidence
        free = select(sure, select(fabs(inp.gap_state) < 0.5, 1.0, 0.0), 0.0)
        reason = select(sure, select(free > 0.5, 1.0, 2.0), 3.0)
        return settled(x.active, x.since, free, reason, par.dwell_time, clock.dt)

    @property
    def n_controller(self) -> int:
        """Number of controllers to choose from."""
        return 2
