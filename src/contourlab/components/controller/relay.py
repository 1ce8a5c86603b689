"""The relay of a relay experiment."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import param
from contourlab.components.controller.law import ControlLaw
from contourlab.engine.step import Port, ports
from contourlab.primitives import select


class Relay(ControlLaw):
    """Relay with hysteresis on the position error: u = +-d + u_ff - d_hat.

    It changes to +d where r - p > h and to -d where r - p < -h, and begins with +d. The loop oscillates near its ultimate period.

    References
    ----------
    Astrom & Hagglund, "Automatic tuning of simple regulators with specifications on phase and amplitude margins", Automatica 20 (1984).
    """

    kind = "relay"
    reference = "Astrom & Hagglund 1984"
    example = {"amplitude": 3.0, "hysteresis": 1e-6}
    states = (Port("side"),)
    inputs = ports("reference", "position", "disturbance_estimate", "feedforward")

    amplitude: float = param(unit="{command}", minimum=0.0, exclusive=True, doc="level of the command, d")
    hysteresis: float = param(default=0.0, unit="m", minimum=0.0, display="um", doc="error at which it changes, h; above noise and count")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        error = inp.reference - inp.position
        held = select(x.side < 0.0, -1.0, 1.0)
        side = select(error > par.hysteresis, 1.0, select(error < -par.hysteresis, -1.0, held))
        return (side,), (par.amplitude * side + inp.feedforward - inp.disturbance_estimate,)
