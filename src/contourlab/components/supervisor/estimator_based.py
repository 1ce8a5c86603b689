"""Supervision by what an observer makes of the gap."""

from __future__ import annotations

from typing import Any, ClassVar

from contourlab.components.contract import param
from contourlab.components.supervisor.switching import Supervisor, settled
from contourlab.engine.step import Port
from contourlab.primitives import fabs, select


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
