"""Execute blocks: update the modal state, and make moves.

RS274/NGC fixes the order of execution in a block, independent of the order of the words: feed mode, feedrate, spindle, tool, coolant,
overrides, dwell, plane, units, tool length, work coordinate system, path control, distance modes, return level, offsets and home positions,
motion, pause or end of program. So with G20 or G21 on its line, F uses the old units, but X, Y and Z the new ones. G94 clears an earlier
feedrate, but not the F on its own line.
"""

from __future__ import annotations

import math
from dataclasses import replace

from contourlab.program.block import Block, Code, Word
from contourlab.program.coordinates import LARGEST_TOOL
from contourlab.program.curves import add_control_point, bezier, close_curve, make_arc
from contourlab.program.cycles import LONGEST_DWELL, drill
from contourlab.program.moves import Mode, Move
from contourlab.program.offsets import go_home, machine_target, select_system, set_data, set_shift, set_tool_length, show_tool
from contourlab.program.state import ModalState
from contourlab.program.vocabulary import ARCS, AXIS_WORDS, CYCLES, SPLINES, USERS, BlockError, g_name

LEAST_TIMED_RATE = 0.1
"""Slowest inverse-time move, in program units per minute, as in LinuxCNC."""

_NO_MOTION = 800
_PLAIN_LETTERS = frozenset("XYZF@^ST")
_SETTINGS: dict[int, tuple[str, object]] = {
    170: ("plane", "XY"), 180: ("plane", "ZX"), 190: ("plane", "YZ"),
    200: ("millimetres", False), 210: ("millimetres", True), 70: ("diameter", True), 80: ("diameter", False),
    900: ("absolute", True), 910: ("absolute", False), 901: ("absolute_centre", True), 911: ("absolute_centre", False),
    930: ("feed_mode", "inverse_time"), 940: ("feed_mode", "per_minute"), 950: ("feed_mode", "per_turn"),
    980: ("back_to_clearance", False), 990: ("back_to_clearance", True),
}  # fmt: skip
"""Attributes of `ModalState` that codes set."""
_MODES = ("plane", "units", "diameter", "tool_length", "system", "control", "distance", "arc_distance", "return")
"""Groups that set the state, in the order of execution. The feed mode is not among them: it is set before the feedrate."""
_G_GROUPS = frozenset((*_MODES, "other", "motion", "feed_mode", "cutter", "spindle_mode"))
_EVENTS = ("output", "tool", "spindle", "coolant", "overrides")
_LETTER_OF_VALUE = dict.fromkeys((50, 51, 52, 53, 62, 63, 64, 65, 19), "P") | dict.fromkeys((61, 67, 68), "Q")
_NEEDED = (61, 62, 63, 64, 65, 67, 68)
_SENSES = {3: 1, 4: -1, 5: 0}
_PAUSES = (0, 1, 60)


def execute(block: Block, state: ModalState, line: int) -> list[Move]:
    """Execute one block.

    Parameters
    ----------
    state : ModalState
        Changed in place; events are added.
    line : int
        Source line of the block, for its moves.

    Raises
    ------
    BlockError
        If the block is invalid in this state.
    """
    codes, words = block
    moves: list[Move] = []
    if state.plane != "XY" and ("@" in words or "^" in words):
        raise BlockError("polar coordinates need the XY plane: write G17 on an earlier line", (words.get("@") or words["^"]).column)
    motion = _motion_to_be(block, state)
    _check_letters(block, motion)
    if motion not in (0, 10) and "other" in codes and codes["other"].number == 530:
        raise BlockError("G53 needs G0 or G1: write one of them, and X, Y or Z, on the same line", codes["other"].column)
    if "feed_mode" in codes:
        setattr(state, *_SETTINGS[codes["feed_mode"].number])
        if state.feed_mode != "inverse_time":
            state.feedrate = 0.0
    if "F" in words and state.feed_mode != "inverse_time":
        _set_feedrate(block, state)
    _execute_events(block, state, line)
    if codes:
        moves += _set_modes(block, state, line)
    if motion is not None:
        before, state.motion = state.motion, motion
        if motion not in CYCLES:
            state.cycle.level = None
        if motion != _NO_MOTION:
            moves += _motion(block, state, line, before)
    stop = block.codes.get("stop")
    if stop is not None and stop.number in _PAUSES:
        state.tell(f"M{stop.number}", None, line)
    return moves


def _motion_to_be(block: Block, state: ModalState) -> int | None:
    """Return the motion of the block: its own, or the modal one if its words need it."""
    codes, words = block
    own, other = codes.get("motion"), codes.get("other")
    takes_axes = other is not None and other.number in AXIS_WORDS
    axes = "X" in words or "Y" in words or "Z" in words or "@" in words or "^" in words
    if own is not None:
        if own.number != _NO_MOTION and takes_axes and other is not None:
            names = f"{g_name(other.number)} and {g_name(own.number)}"
            raise BlockError(f"{names} both use the axis words: write each on its own line", own.column)
        if own.number == _NO_MOTION and axes and not takes_axes:
            word = next(words[letter] for letter in "XYZ@^" if letter in words)
            raise BlockError(f"{word.letter} has no effect with G80, which ends all motion: delete it, or write G0 or G1 too", word.column)
        _check_axes_given(own, words, axes)
        return own.number
    if takes_axes:
        return None
    if axes:
        if "tool_length" in codes and codes["tool_length"].number in (431, 432):
            return None
        if state.motion is None or state.motion == _NO_MOTION:
            word = next(words[letter] for letter in "XYZ@^" if letter in words)
            raise BlockError(f"{word.letter} has no motion code: write G0, G1, G2 or G3 before it", word.column)
        return state.motion
    if state.motion in ARCS and ("I" in words or "J" in words or "K" in words):
        return state.motion
    return None


def _check_axes_given(own: Code, words: dict[str, Word], axes: bool) -> None:
    # G0 and G1 need no axes; full circles and the first line of a NURBS need no end point.
    if not axes and own.number not in (0, 10, *ARCS, 52, _NO_MOTION):
        raise BlockError(f"{g_name(own.number)} has no axis: write X, Y or Z", own.column)


def _check_letters(block: Block, motion: int | None) -> None:
    """Refuse words that no code of the block uses."""
    if block.words.keys() <= _PLAIN_LETTERS:
        return
    active: set[int | str] = {code.number if group in _G_GROUPS else f"M{code.number}" for group, code in block.codes.items()}
    if motion is not None:
        active.add(motion)
    if "P" in block.words and 40 in active and len(active & USERS["P"][0]) > 1:
        raise BlockError("G4 and another code of the block both use P: write G4 on its own line", block.words["P"].column)
    for letter, word in block.words.items():
        if letter in USERS and not USERS[letter][0] & active:
            raise BlockError(f"no active code uses {letter}: delete it, or write {USERS[letter][1]}", word.column)


def _set_feedrate(block: Block, state: ModalState) -> None:
    word = block.words["F"]
    feedrate = state.length(word.value)
    if state.feed_mode == "per_minute":
        feedrate /= 60.0
    if feedrate < 0.0:
        raise BlockError(f"F{word.value:g}: a feedrate cannot be negative", word.column)
    state.feedrate = feedrate


def _dwell(block: Block, state: ModalState, line: int) -> list[Move]:
    word = block.words.get("P")
    if word is None:
        raise BlockError("G4 has no time: write for example G4 P0.5 for half a second", block.codes["other"].column)
    if not 0.0 <= word.value <= LONGEST_DWELL:
        raise BlockError(f"G4 P{word.value:g}: write P in seconds, from 0 to {LONGEST_DWELL:g}", word.column)
    return state.wait(word.value, line)


def _set_modes(block: Block, state: ModalState, line: int) -> list[Move]:
    """Execute the codes of a block other than its motion, in their order."""
    codes = block.codes
    moves: list[Move] = []
    other = codes.get("other")
    if other is not None and other.number == 40:
        moves += _dwell(block, state, line)
    for group in _MODES:
        if group in codes:
            _set_mode(block, state, group, codes[group].number)
    if other is None:
        return moves
    if other.number == 100:
        set_data(block, state)
    elif other.number in (280, 281, 300, 301):
        moves += go_home(block, state, other.number, line)
    elif other.number in (520, 920, 921, 922, 923):
        set_shift(block, state, other)
    elif other.number == 53:
        moves += close_curve(block, state, line)
    return moves


def _set_control(block: Block, state: ModalState, code: int) -> None:
    if code != 640:
        state.mode = Mode("exact_path" if code == 610 else "exact_stop", None, None, state.mode.tool)
        return
    lengths: list[float | None] = []
    for letter in "PQ":
        word = block.words.get(letter)
        if word is not None and word.value < 0.0:
            raise BlockError(f"{letter}{word.value:g}: a tolerance of G64 cannot be negative", word.column)
        lengths.append(None if word is None else state.length(word.value))
    tolerance, merge = lengths
    state.mode = Mode("blend", tolerance, tolerance if merge is None else merge, state.mode.tool)


def _set_mode(block: Block, state: ModalState, group: str, code: int) -> None:
    if group == "tool_length":
        set_tool_length(block, state, code)
    elif group == "system":
        select_system(state, code)
    elif group == "control":
        _set_control(block, state, code)
    else:
        setattr(state, *_SETTINGS[code])


def _motion(block: Block, state: ModalState, line: int, before: int | None) -> list[Move]:
    """Make the motion of a block; `before` is the previous modal motion."""
    motion = state.motion
    if motion != 52 and state.curve.points:
        raise BlockError("the NURBS begun with G5.2 is not closed: write G5.3 before the next motion", block.column)
    if motion in CYCLES:
        return drill(block, state, line, again=before == motion)
    if motion in SPLINES:
        if state.feed_mode == "inverse_time":
            raise BlockError("splines cannot use inverse-time feed (G93): write G94 and F", block.column)
        if motion == 52:
            add_control_point(block, state)
            return []
        moves = bezier(block, state, line)
        state.motion = before  # G5 and G5.1 hold for their own block only
        return moves
    state.tangent = None
    other = block.codes.get("other")
    in_machine = other is not None and other.number == 530
    end = machine_target(block, state) if in_machine else state.target(block.words)
    if motion == 0:
        return state.straight(end, line)
    if motion == 10:
        timed = state.feed_mode == "inverse_time"
        return state.straight(end, line, _feedrate(block, state, math.dist(state.position, end) if timed else 0.0))
    arc = make_arc(block, state, end, line)
    if state.feed_mode == "inverse_time":
        rise = end[arc.axes[2]] - state.position[arc.axes[2]]
        arc = replace(arc, feedrate=_feedrate(block, state, math.hypot(arc.sweep * arc.radius, rise)))
    state.position, state.reached = end, arc.end
    state.made += 1
    return [arc]


def _feedrate(block: Block, state: ModalState, length: float) -> float:
    """Return the feedrate [m/s] of a move of a length [m]; with G93, F is 1 over its time in minutes."""
    assert state.motion is not None  # the motion in progress
    column, name = block.column, f"G{state.motion // 10}"
    if state.feed_mode != "inverse_time":
        return state.path_feedrate(column, name)
    word = block.words.get("F")
    if word is None:
        raise BlockError(f"{name} with G93 has no F: write F on each move, as 1 / (time in minutes)", column)
    if word.value <= 0.0:
        raise BlockError(f"F{word.value:g}: with G93, F is 1 / (time in minutes) and must be greater than 0", word.column)
    state.feedrate = max(length * word.value, state.length(LEAST_TIMED_RATE)) / 60.0
    return state.feedrate


def _execute_events(block: Block, state: ModalState, line: int) -> None:
    """Record speed, tool number, outputs, tool change, spindle, coolant and overrides, in the order of RS274/NGC."""
    codes, words = block
    speed, tool = words.get("S"), words.get("T")
    if speed is not None:
        if speed.value < 0.0:
            raise BlockError(f"S{speed.value:g}: a spindle speed cannot be negative; M4 turns it the other way", speed.column)
        state.speed = speed.value
        state.tell("S", speed.value, line)
    if tool is not None:
        state.tools.selected = _tool_number(tool)
        state.tools.check(state.tools.selected, tool.column)
        state.tell("T", tool.value, line)
    for group in _EVENTS:
        if group in codes:
            _execute_event(block, state, line, codes[group].number, codes[group].column)


def _execute_event(block: Block, state: ModalState, line: int, code: int, column: int) -> None:
    letter = _LETTER_OF_VALUE.get(code)
    word = block.words.get(letter) if letter else None
    if word is None and code in _NEEDED:
        raise BlockError(f"M{code} has no {letter}: write for example {letter}1", column)
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
        raise BlockError(f"R{turn.value:g}: M19 needs an angle from 0 to 360 degrees", turn.column)
    if way is not None and way.value not in (0.0, 1.0, 2.0):
        raise BlockError(f"P{way.value:g}: M19 needs P0 (shorter way), P1 (clockwise) or P2 (counterclockwise)", way.column)


def _tool_number(word: Word) -> int:
    return word.whole(0, LARGEST_TOOL, "the tool number", 0.0)
