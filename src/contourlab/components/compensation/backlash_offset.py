"""Backlash compensation of numerical controls: a position offset that changes sign at a reversal.

The pushed side, and the moves of a shift from one side of the gap to the other, serve the other compensations too.
"""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.primitives import clip, copysign, fabs, floor, maximum, minimum, select, sqrt


def pushed_side(speed: float, band: float, before: float) -> float:
    """Return the side on which the load is pushed: +1 or -1, and `before` inside the speed band.

    Standstill keeps the side: a motor that stops keeps its contact.
    """
    return select(speed > band, 1.0, select(speed < -band, -1.0, before))


def limited_jump(now: float, target: float, most: float) -> float:
    """Return `now` moved towards the target by `most` at most; the last move lands on it exactly."""
    left = target - now
    return select(fabs(left) <= most, target, now + clip(left, -most, most))


def limited_ramp(now: float, speed: float, target: float, most_speed: float, most_rise: float, dt: float) -> tuple[float, float]:
    """Return offset and speed after one tick towards a target, with limits of speed and acceleration.

    `most_rise` is the largest change of speed in a tick, a dt. In units of a dt and a dt^2, an offset with speed v that brakes by 1 per
    tick stops after n ticks and a distance v + (v - 1) + ... = n v - n (n - 1)/2, where n - 1 < v <= n. Solved for v, with the least n for
    which n (n + 1)/2 is at least the distance left, this is the highest speed from which it can stop at the target.
    """
    left = target - now
    ticks = fabs(left) / (most_rise * dt)
    n = maximum(-floor(0.5 - sqrt(0.25 + 2.0 * ticks)), 1.0)
    stopping = most_rise * (ticks / n + 0.5 * (n - 1.0))
    wanted = copysign(minimum(most_speed, stopping), left)
    after = clip(wanted, speed - most_rise, speed + most_rise)
    moved = now + after * dt
    # Rounding must not keep it from the target.
    return select(fabs(target - moved) <= 1e-9 * most_rise * dt, target, moved), after


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
