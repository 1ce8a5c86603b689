"""The words of a block that concern spindle, tool, coolant and overrides: checked and kept, in the order of execution."""

from __future__ import annotations

from contourlab.program.block import Block
from contourlab.program.fault import BlockError
from contourlab.program.moves import Event

__all__ = ["OVERRIDES_WITH_P", "events_before_motion", "pause"]

LARGEST_TOOL = 99_999
OVERRIDES_WITH_P = frozenset((50, 51, 52, 53))
_GROUPS = ("tool", "spindle", "coolant", "overrides")
_PAUSES = (0, 1)


def events_before_motion(block: Block, line: int) -> list[Event]:
    """Return speed, tool number, tool change, spindle, coolant and overrides, as RS274/NGC orders them.

    Raises
    ------
    BlockError
        If a speed is negative, or a tool's number no whole number from 0.
    """
    found: list[Event] = []
    speed, tool = block.words.get("S"), block.words.get("T")
    if speed is not None:
        if speed.value < 0.0:
            raise BlockError(f"S{speed.value:g}: a spindle speed is not negative, M4 turns it the other way", speed.column)
        found.append(Event("S", speed.value, line))
    if tool is not None:
        if tool.value != round(tool.value) or not 0 <= tool.value <= LARGEST_TOOL:
            raise BlockError(f"T{tool.value:g}: a tool has a whole number from 0 to {LARGEST_TOOL}", tool.column)
        found.append(Event("T", tool.value, line))
    for group in _GROUPS:
        if group in block.codes:
            code = block.codes[group].number
            p = block.words.get("P") if code in OVERRIDES_WITH_P else None
            found.append(Event(f"M{code}", None if p is None else p.value, line))
    return found


def pause(block: Block, line: int) -> list[Event]:
    """Return M0 or M1, which come after the motion of their block."""
    code = block.codes.get("stop")
    return [Event(f"M{code.number}", None, line)] if code is not None and code.number in _PAUSES else []
