"""Offset and pulses together: what a numerical control does about backlash and friction at a reversal."""

from __future__ import annotations

from functools import cache
from typing import Any

from contourlab.components.compensation.backlash_offset import BacklashOffset, offset_after
from contourlab.components.compensation.quadrant_pulses import QuadrantPulses, check_characteristic, pulse_states, pulses_of, slopes
from contourlab.components.compensation.reversal import pushed_side
from contourlab.components.contract import Component
from contourlab.engine.step import Port


class CncBacklash(Component):
    """Backlash offset and two-stage quadrant pulses on one reversal of the command.

    Shift and command are those of `backlash-offset` and `quadrant-pulses` with the same parameters, the shifts added up: an axis has one
    slot for its compensation, and a control has both. The gap is made good by the offset, what friction does behind it by the pulses.

    References
    ----------
    Those of `backlash-offset` and `quadrant-pulses`.
    """

    family = "compensation"
    kind = "cnc-backlash"
    reference = "numerical controls: backlash offset with quadrant error compensation"
    example = {**QuadrantPulses.example, **BacklashOffset.example}
    parameters = {**BacklashOffset.parameters, **QuadrantPulses.parameters}
    states = (*QuadrantPulses.states, Port("offset"), Port("offset_speed"))
    inputs = QuadrantPulses.inputs
    outputs = QuadrantPulses.outputs
    derived = QuadrantPulses.derived

    def __init__(self, **values: Any) -> None:
        super().__init__(**values)
        check_characteristic(self)

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return slopes(par)

    def step_function(self) -> Any:
        return _make(str(self.values()["shape"]))


@cache
def _make(shape: str) -> Any:
    pulses = pulses_of(shape)

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        side = pushed_side(inp.reference_velocity, par.reversal_velocity, x.side)
        offset, speed = offset_after(par, x, side, clock)
        moment, size = pulse_states(par, x, side, inp.reference_acceleration, clock)
        command, shift = pulses(par, side, moment, size, clock)
        return (side, moment, size, offset, speed), (offset + shift, command)

    return step
