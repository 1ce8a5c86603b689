"""Backlash compensation of numerical controls: a position offset that changes sign at a reversal."""

from __future__ import annotations

from typing import Any

from contourlab.components.compensation.reversal import limited_ramp, pushed_side
from contourlab.components.contract import Component, param
from contourlab.engine.step import Port


def offset_after(par: Any, x: Any, side: float, clock: Any) -> tuple[float, float]:
    """Return offset and its speed after one tick towards half the gap on `side`."""
    rise = par.backlash_acceleration * clock.dt
    return limited_ramp(x.offset, x.offset_speed, 0.5 * par.backlash_gap * side, par.backlash_velocity, rise, clock.dt)


class BacklashOffset(Component):
    """Offset of +b/2 or -b/2 on the commanded position by its direction, changed with limited velocity and acceleration.

    The direction is the sign of the reference velocity; standstill keeps it, and nothing is measured. Before the first motion the offset is
    zero, as after switch-on. The change from one side to the other takes b/v + v/a if the velocity v is reached (b >= v^2/a), else
    2 sqrt(b/a), to within one or two servo periods.

    LinuxCNC gives the offset half of the axis limits and leaves the other half for the motion.

    References
    ----------
    LinuxCNC, src/emc/motion/control.c, compute_screw_comp: backlash_corr and its trapezoidal filter (parameter BACKLASH of a joint).
    Beckhoff TwinCAT CNC, P-AXIS-00103 (size of backlash) and P-AXIS-00243 (its distribution over control cycles).
    """

    family = "compensation"
    kind = "backlash-offset"
    reference = "LinuxCNC, compute_screw_comp; numerical controls in general"
    example = {"backlash_gap": 0.02, "backlash_velocity": 0.3, "backlash_acceleration": 30.0, "reversal_velocity": 5e-4}
    states = (Port("side"), Port("offset"), Port("offset_speed"))
    inputs = (Port("reference_velocity"),)
    outputs = (Port("reference_shift"),)

    backlash_gap: float = param(unit="m", minimum=0.0, maximum=0.1, display="um", doc="total gap between motor and load, b")
    backlash_velocity: float = param(default=0.01, unit="m/s", minimum=0.0, exclusive=True, display="mm/s", doc="top speed of the offset")
    backlash_acceleration: float = param(default=2.0, unit="m/s^2", minimum=0.0, exclusive=True, doc="top acceleration of the offset, a")
    reversal_velocity: float = param(default=0.0, unit="m/s", minimum=0.0, display="mm/s", doc="speed below which the side is kept")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        side = pushed_side(inp.reference_velocity, par.reversal_velocity, x.side)
        offset, speed = offset_after(par, x, side, clock)
        return (side, offset, speed), (offset,)
