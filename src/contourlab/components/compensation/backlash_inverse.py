"""The inverse of backlash: the position of the motor that puts the load where it is asked for."""

from __future__ import annotations

from typing import Any

from contourlab.components.compensation.reversal import limited_jump, pushed_side
from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.primitives import select


class BacklashInverse(Component):
    """Shift of the reference by half the gap in the direction of motion: +b/2 forwards, -b/2 backwards, b the total gap.

    It is for an axis whose motor side is positioned: the load stands half the gap behind the motor on the side that is pushed, so that
    r + b/2 or r - b/2 asked of the motor puts the load at r. Fed back from the load side it would be counted twice.

    The shift keeps its sign at standstill. At a reversal it goes to the other side with `jump_velocity`, because no motor follows a jump:
    it takes b/jump_velocity, in which the load stays where it turned. It is nil at the first tick, and comes in over the same ramp when the
    axis first moves, or at once where `initial_direction` says on which side the load lies.

    Which side is pushed is told by the reference: the speed v + T a, T = `load_time_constant`, has the sign of the force which a load of
    mass m and viscous friction c asks for, c v + m a, with T = m/c. T = 0, the default, is for friction that outweighs inertia: there the
    direction of motion decides. Within `dead_band` the side is held, so that noise at standstill does nothing.

    A gap observed while running takes the place of `backlash_gap` as soon as it is above zero.

    References
    ----------
    G. Tao & P. V. Kokotovic, "Adaptive control of systems with backlash", Automatica 29(2), 1993, 323-335: the backlash inverse, here of
    slope 1 and with its jump led over a ramp.
    """

    family = "compensation"
    kind = "backlash-inverse"
    reference = "Tao & Kokotovic 1993, backlash inverse"
    example = {
        "backlash_gap": 0.02,
        "jump_velocity": 0.5,
        "dead_band": 5e-4,
        "load_time_constant": 0.3,
        "initial_direction": -1.0,
    }
    states = (Port("side"), Port("shift"))
    inputs = (Port("reference_velocity"), Port("reference_acceleration"), Port("gap_estimate"))
    outputs = (Port("reference_shift"),)

    backlash_gap: float = param(unit="m", minimum=0.0, maximum=0.1, display="um", doc="total free travel between motor and load, b")
    jump_velocity: float = param(
        default=0.01, unit="m/s", minimum=0.0, exclusive=True, display="mm/s", doc="speed of the shift across the gap"
    )
    dead_band: float = param(default=1e-6, unit="m/s", minimum=0.0, display="mm/s", doc="speed below which the side pushed is held")
    load_time_constant: float = param(
        default=0.0, unit="s", minimum=0.0, display="ms", doc="mass of the load over its viscous friction; 0 where friction rules"
    )
    initial_direction: float = param(
        default=0.0, minimum=-1.0, maximum=1.0, whole=True, doc="side pushed before the first motion: 1 forwards, -1 backwards, 0 not known"
    )

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        before = select(x.side == 0.0, par.initial_direction, x.side)
        speed = inp.reference_velocity + par.load_time_constant * inp.reference_acceleration
        side = pushed_side(speed, par.dead_band, before)
        gap = select(inp.gap_estimate > 0.0, inp.gap_estimate, par.backlash_gap)
        shift = limited_jump(x.shift, 0.5 * gap * side, par.jump_velocity * clock.dt)
        return (side, shift), (shift,)
