"""What supervisors have in common: how a wish to switch becomes a switch."""

from __future__ import annotations

from typing import Any, ClassVar

from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.primitives import select

STEADY = 0.0
"""Reason of a tick without a switch."""


class Supervisor(Component):
    """Base of the supervisors: the number of the controller that is active, and why it was made so.

    Output ``active`` is 0 for the axis' ``controller`` and 1, 2 ... for those of ``others``; ``reason`` is `STEADY`, or at the tick of a
    switch the number of one of `reasons`, which stand from 1.

    Attributes
    ----------
    reasons : tuple of str
        In words; ``{name}`` stands for the controller that takes over.
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
