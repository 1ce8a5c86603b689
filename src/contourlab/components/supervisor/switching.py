"""The base of supervisors, which switch between controllers, and the one that follows a gap observer."""

from __future__ import annotations

from typing import Any, ClassVar

from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.primitives import fabs, select

STEADY = 0.0
"""Reason of a tick without a switch."""


class Supervisor(Component):
    """Base of the supervisors: the number of the controller that is active, and why it was made so.

    Output ``active`` is 0 for the axis' ``controller`` and 1, 2 ... for those of ``others``; ``reason`` is `STEADY`, or at the tick of a
    switch the number of one of `reasons`, counted from 1.

    Attributes
    ----------
    reasons : tuple of str
        In words; ``{name}`` becomes the controller that takes over.
    """

    family = "supervisor"
    reasons: ClassVar[tuple[str, ...]] = ()
    states: ClassVar[tuple[Port, ...]] = (Port("active"), Port("since"))
    outputs = (Port("active"), Port("reason"))

    handover_time: float = param(default=5e-3, unit="s", minimum=0.0, display="ms", doc="time constant of a hand-over; 0: a jump")
    dwell_time: float = param(default=0.0, unit="s", minimum=0.0, display="ms", doc="shortest time from one switch to the next")
    without_effect: ClassVar[tuple[str, ...]] = ("handover_time",)  # it acts where commands are handed over


def settled(active: float, since: float, wanted: float, reason: float, dwell_time: float, dt: float) -> tuple[Any, Any]:
    """Return the states and outputs of a supervisor that wants a controller for a reason, `since` a time after its last switch."""
    switches = select(wanted == active, 0.0, select(since >= dwell_time, 1.0, 0.0)) > 0.5
    now = select(switches, wanted, active)
    return (now, select(switches, 0.0, since) + dt), (now, select(switches, reason, STEADY))


class EstimatorBased(Supervisor):
    """The first of ``others`` is active while the gap observer sees the motor in the gap, the axis' ``controller`` in contact.

    Where the observer is less sure than `confidence`, the ``controller`` is kept active: what holds in contact also holds, if less well, in
    the gap.

    References
    ----------
    Shahin, ElMaraghy & ElBeheiry, "On nonlinearity control of CNC feed drives", section "Supervisory control".
    """

    kind = "estimator-based"
    reference = "Shahin, ElMaraghy & ElBeheiry, supervisory control"
    reasons: ClassVar[tuple[str, ...]] = ("the observer sees the gap", "the observer sees contact", "the observer is not sure enough")
    example = {"confidence": 0.3, "dwell_time": 3e-3}
    inputs = (Port("gap_state"), Port("confidence"))

    confidence: float = param(default=0.5, minimum=0.0, maximum=1.0, doc="of the observer, below which the controller for contact is kept")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        sure = inp.confidence >= par.confidence
        free = select(sure, select(fabs(inp.gap_state) < 0.5, 1.0, 0.0), 0.0)
        reason = select(sure, select(free > 0.5, 1.0, 2.0), 3.0)
        return settled(x.active, x.since, free, reason, par.dwell_time, clock.dt)

    @property
    def n_controller(self) -> int:
        """How many controllers it chooses from."""
        return 2
