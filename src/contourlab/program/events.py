"""The words of a block that concern spindle, tool, coolant, outputs and overrides: checked and kept, in the order of execution."""

from __future__ import annotations

from contourlab.program.block import Block
from contourlab.program.fault import BlockError
from contourlab.program.lexer import Word
from contourlab.program.offsets import show_tool
from contourlab.program.state import ModalState
from contourlab.program.tools import LARGEST_TOOL

_GROUPS = ("output", "tool", "spindle", "coolant", "overrides")
_LETTER_OF_VALUE = dict.fromkeys((50, 51, 52, 53, 62, 63, 64, 65, 19), "P") | dict.fromkeys((61, 67, 68), "Q")
_NEEDED = (61, 62, 63, 64, 65, 67, 68)
_SENSES = {3: 1, 4: -1, 5: 0}
_PAUSES = (0, 1, 60)


def execute_events(block: Block, state: ModalState, line: int) -> None:
    """Keep speed, tool number, outputs, tool change, spindle, coolant and overrides, as RS274/NGC orders them.

    Raises
    ------
    BlockError
        If a speed is negative, a tool's number no whole number from 0, or a code lacks its number.
    """
    codes, words = block
    speed, tool = words.get("S"), words.get("T")
    if speed is not None:
        if speed.value < 0.0:
            raise BlockError(f"S{speed.value:g}: a spindle speed is not negative, M4 turns it the other way", speed.column)
        state.speed = speed.value
        state.tell("S", speed.value, line)
    if tool is not None:
        state.tools.selected = _tool_number(tool)
        state.tools.check(state.tools.selected, tool.column)
        state.tell("T", tool.value, line)
    if not codes:
        return
    for group in _GROUPS:
        if group in codes:
            _execute(block, state, line, codes[group].number, codes[group].column)


def _execute(block: Block, state: ModalState, line: int, code: int, column: int) -> None:
    letter = _LETTER_OF_VALUE.get(code)
    word = block.words.get(letter) if letter else None
    if word is None and code in _NEEDED:
        raise BlockError(f"M{code} has no {letter}: write its number", column)
    index = block.words.get("E") if code in (67, 68) else None
    if index is None and code in (67, 68):
        raise BlockError(f"M{code} has no E: write the number of the output", column)
    if code == 19:
        _check_orientation(block)
    if code in (6, 61):
        state.tools.current = state.tools.selected if code == 6 or word is None else _tool_number(word)
        show_tool(state)
    if code in _SENSES:
        state.turning = _SENSES[code]
    state.tell(f"M{code}", None if word is None else word.value, line, None if index is None else index.value)


def _check_orientation(block: Block) -> None:
    turn, way = block.words.get("R"), block.words.get("P")
    if turn is not None and not 0.0 <= turn.value <= 360.0:
        raise BlockError(f"R{turn.value:g}: M19 turns the spindle to 0 to 360 degrees, correct it", turn.column)
    if way is not None and way.value not in (0.0, 1.0, 2.0):
        raise BlockError(f"P{way.value:g}: the P of M19 is 0 (shorter way), 1 (clockwise) or 2 (counterclockwise)", way.column)


def _tool_number(word: Word) -> int:
    if word.value != round(word.value) or not 0 <= word.value <= LARGEST_TOOL:
        raise BlockError(f"{word.letter}{word.value:g}: a tool has a whole number from 0 to {LARGEST_TOOL}", word.column)
    return int(word.value)


def pause(block: Block, state: ModalState, line: int) -> None:
    """Keep M0, M1 and M60, which come after the motion of their block."""
    code = block.codes.get("stop")
    if code is not None and code.number in _PAUSES:
        state.tell(f"M{code.number}", None, line)
