"""Execute blocks: update the modal state, and make moves.

RS274/NGC fixes the order of execution in a block, independent of the order of the words: feed mode, feedrate, spindle, tool, coolant,
overrides, dwell, plane, units, tool length, work coordinate system, path control, distance modes, return level, offsets and home positions,
motion, pause or end of program. So with G20 or G21 on its line, F uses the old units, but X, Y and Z the new ones. G94 clears an earlier
feedrate, but not the F on its own line.
"""

from __future__ import annotations

import math
from dataclasses import replace

from contourlab.errors import refuse
from contourlab.program.block import SELECTED_SYSTEM, Block, Code, Word
from contourlab.program.motions import LONGEST_DWELL, add_control_point, bezier, close_curve, drill, make_arc
from contourlab.program.moves import Mode, Move, Point
from contourlab.program.state import (
    LARGEST_TOOL,
    ORIGIN,
    SHIFT_APPLIED,
    ModalState,
    add,
    less,
    origin_of,
    store_origin,
    store_shift,
    turn,
    updated,
)
from contourlab.program.vocabulary import ARCS, AXIS_WORDS, CYCLES, SPLINES, SYSTEMS, USERS, BlockError, g_name

_HOMES = {280: 5161, 281: 5161, 300: 5181, 301: 5181}
_TOOL_LEVELS = (1, 10, 11)
_FIXTURE = 9


def select_system(state: ModalState, code: int) -> None:
    """Select a work coordinate system (G54 to G59.3); a system already selected is not reloaded."""
    system, frame = SYSTEMS.index(code) + 1, state.frame
    if system == frame.system:
        return
    axes = state.axes
    frame.system = system
    frame.origin, frame.rotation = origin_of(state.parameters, system)
    state.parameters.write(SELECTED_SYSTEM, float(system))
    state.see_from(axes)


def set_tool_length(block: Block, state: ModalState, code: int) -> None:
    """Set the tool offset: G43 from the table, G43.1 from the axis words; G43.2 adds to it, G49 clears it."""
    frame, words = state.frame, block.words
    axes, height = state.axes, words.get("H")
    if code == 490:
        frame.tool = ORIGIN
    elif code == 430:
        number = state.tools.current if height is None else height.whole(0, LARGEST_TOOL, "the tool number")
        state.tools.check(number, (height or block.codes["tool_length"]).column)
        frame.tool = state.tools.offset(number)
    elif code == 431:
        frame.tool = updated(frame.tool, state.given(words))
    else:
        given = state.given(words)
        if (height is None) == all(value is None for value in given):
            raise BlockError(
                "CL813 G43.2 needs a tool, as in H3, or lengths, as in Z5: write one of the two", block.codes["tool_length"].column
            )
        if height is not None:
            frame.tool = add(frame.tool, state.tools.offset(height.whole(0, LARGEST_TOOL, "the tool number")))
        else:
            frame.tool = add(frame.tool, updated(ORIGIN, given))
    state.see_from(axes)


def set_shift(block: Block, state: ModalState, code: Code) -> None:
    """Shift the coordinates: G92 gives new coordinates of the current point, G52 the shift; G92.1 to G92.3 clear or restore it."""
    frame, parameters, axes = state.frame, state.parameters, state.axes
    if code.number in (520, 920):
        given = state.given(block.words)
        if all(value is None for value in given):
            name = "G52" if code.number == 520 else "G92"
            raise BlockError(f"CL813 {name} has no axis: write for example {name} X0 Y0", code.column)
        shift = list(frame.shift)
        for axis, value in enumerate(given):
            if value is not None:
                shift[axis] = value if code.number == 520 else state.position[axis] + shift[axis] - value
        frame.shift = (shift[0], shift[1], shift[2])
        store_shift(parameters, frame.shift, applied=True)
    elif code.number == 923:
        frame.shift = parameters.point(SHIFT_APPLIED + 1)
        store_shift(parameters, frame.shift, applied=True)
    else:
        frame.shift = ORIGIN
        store_shift(parameters, ORIGIN if code.number == 921 else parameters.point(SHIFT_APPLIED + 1), applied=False)
    state.see_from(axes)


def set_data(block: Block, state: ModalState) -> None:
    """Execute G10: L2 and L20 set the origin of a work coordinate system, L1, L10 and L11 the offset of a tool."""
    words, code = block.words, block.codes["other"]
    level = None if "L" not in words else words["L"].whole(0, 10**9, "L of G10")
    if level not in (2, 20, *_TOOL_LEVELS):
        raise BlockError(
            "CL813 G10 takes L2 or L20 (work coordinate system), L1, L10 or L11 (tool): write for example G10 L2 P1 X0", code.column
        )
    if "P" not in words:
        what = "tool" if level in _TOOL_LEVELS else "system, 1 for G54"
        raise BlockError(f"CL813 G10 L{level} has no P: write the number of the {what}", code.column)
    number = words["P"].whole(0, LARGEST_TOOL, "P of G10")
    if level in _TOOL_LEVELS:
        _set_tool(words, state, level, number)
        return
    if number > len(SYSTEMS):
        raise BlockError(f"CL806 P{number}: write 1 (G54) to 9 (G59.3), or 0 for the selected work coordinate system", words["P"].column)
    for letter in "IJ":
        if letter in words:
            raise BlockError(f"CL811 {letter} has no meaning with G10 L{level}: delete it", words[letter].column)
    if level == 20 and "R" in words:
        raise BlockError("CL811 G10 L20 does not take R (rotation): set it with G10 L2 on its own line", words["R"].column)
    _set_origin(words, state, level, number or state.frame.system)


def _set_origin(words: dict[str, Word], state: ModalState, level: int, system: int) -> None:
    frame, given, axes = state.frame, state.given(words), state.axes
    origin, rotation = origin_of(state.parameters, system)
    if "R" in words:
        rotation = words["R"].value
    if level == 2:
        origin = updated(origin, given)
    else:
        # `here` is the tool tip in this system; the origin moves by the difference to the given point.
        here = less(turn(less(less(state.axes, frame.tool), origin), -rotation), frame.shift)
        origin = add(origin, turn(less(here, updated(here, given)), rotation))
    store_origin(state.parameters, system, origin, rotation)
    if system == frame.system:
        frame.origin, frame.rotation = origin, rotation
        state.see_from(axes)


def _set_tool(words: dict[str, Word], state: ModalState, level: int, number: int) -> None:
    refuse(number < 1, BlockError, f"CL806 P{number}: G10 L{level} needs a tool number, 1 or more", words["P"].column)
    given = state.given(words)
    if all(value is None for value in given) and "R" not in words:
        raise BlockError(f"CL813 G10 L{level} sets nothing: write the tool's offset, as in Z25", words["P"].column)
    old = state.tools.offset(number)
    state.tools.offsets[number] = updated(old, given) if level == 1 else _touched_off(state, given, old, level)
    if "R" in words:
        state.tools.diameters[number] = 2.0 * state.length(words["R"].value)
    if number == state.tools.current:
        show_tool(state)


def _touched_off(state: ModalState, given: list[float | None], old: Point, level: int) -> Point:
    """Return the tool offset for the given coordinates of the current point, in the selected system (L10) or in G59.3 without G92 (L11)."""
    system = _FIXTURE if level == 11 else state.frame.system
    origin, rotation = origin_of(state.parameters, system)
    shift = ORIGIN if level == 11 else state.frame.shift
    seen = less(turn(less(state.axes, origin), -rotation), shift)
    x, y, z = (before if new is None else point - new for before, point, new in zip(turn(old, -rotation), seen, given, strict=True))
    return turn((x, y, z), rotation)


def show_tool(state: ModalState) -> None:
    """Store number and offset of the tool in the spindle in #5400 to #5403."""
    tools, write = state.tools, state.parameters.write
    write(5400, float(tools.current))
    state.parameters.write_point(5401, tools.offset(tools.current))
    write(5410, tools.diameters.get(tools.current, 0.0) * 1000.0)


def go_home(block: Block, state: ModalState, code: int, line: int) -> list[Move]:
    """Execute G28, G30 (through the given point to the home position) and G28.1, G30.1 (store the current point as home)."""
    first = _HOMES[code]
    if code in (281, 301):
        state.parameters.write_point(first, state.axes)
        return []
    words = block.words
    state.machine_points.append((line, (math.nan, math.nan, math.nan)))
    moves = state.straight(state.target(words), line)
    home = state.frame.point(state.parameters.point(first))
    named = [letter in words for letter in "XYZ"]
    x, y, z = (h if chosen or not any(named) else p for h, p, chosen in zip(home, state.position, named, strict=True))
    return moves + state.straight((x, y, z), line)


def machine_target(block: Block, state: ModalState, line: int) -> Point:
    """Return the point of the program [m] at the machine coordinates of a G53 block.

    Raises
    ------
    BlockError
        If the block is incremental or polar.
    """
    words, column = block.words, block.codes["other"].column
    absolute = state.absolute or state.rules.incremental_g53
    refuse(not absolute, BlockError, "CL816 G53 (machine coordinates) needs absolute mode: write G90", column)
    refuse("@" in words or "^" in words, BlockError, "CL816 G53 does not take polar coordinates: write X, Y and Z", column)
    given = state.given(words)
    state.machine_points.append((line, updated((math.nan, math.nan, math.nan), given)))
    point = state.frame.point(updated(state.axes, given))
    state.check_reach(point, words)
    return point


LEAST_TIMED_RATE = 0.1
"""Slowest inverse-time move, in program units per minute, as in LinuxCNC."""

_NO_MOTION = 800
_PATHS = (0, 10, *ARCS)
_PLAIN_LETTERS = frozenset("XYZF@^ST")
_SETTINGS: dict[int, tuple[str, object]] = {
    170: ("plane", "XY"), 180: ("plane", "ZX"), 190: ("plane", "YZ"),
    200: ("millimetres", False), 210: ("millimetres", True), 700: ("millimetres", False), 710: ("millimetres", True),
    70: ("diameter", True), 80: ("diameter", False),
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
    rules = state.rules
    if state.plane != "XY" and ("@" in words or "^" in words):
        raise BlockError("CL816 polar coordinates need the XY plane: write G17 on an earlier line", (words.get("@") or words["^"]).column)
    motion = _motion_to_be(block, state)
    _check_letters(block, state, motion)
    if motion not in rules.g53_motions and "other" in codes and codes["other"].number == 530:
        names = " or ".join(map(g_name, rules.g53_motions))
        raise BlockError(f"CL813 G53 needs {names}: write one of them, and X, Y or Z, on the same line", codes["other"].column)
    if "feed_mode" in codes:
        before_it = state.feed_mode
        setattr(state, *_SETTINGS[codes["feed_mode"].number])
        if state.feed_mode != "inverse_time" and not (rules.keeps_feedrate and state.feed_mode == before_it):
            state.feedrate = 0.0
    if "F" in words and state.feed_mode != "inverse_time":
        if words["F"].value < 0.0:
            raise BlockError(f"CL806 F{words['F'].value:g}: a feedrate cannot be negative", words["F"].column)
        if rules.new_units and "units" in codes:
            setattr(state, *_SETTINGS[codes["units"].number])
        state.feedrate = state.length(words["F"].value) / (60.0 if state.feed_mode == "per_minute" else 1.0)
    _execute_events(block, state, line)
    if codes:
        moves += _set_modes(block, state, line)
    if motion is not None:
        before, state.motion = state.motion, motion
        state.resumed = motion if motion in _PATHS else state.resumed
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
    takes_axes = other is not None and (other.number in AXIS_WORDS or (other.number == 40 and state.rules.dwell_x))
    if own is not None and state.rules.paths_apart:
        homes = other is not None and other.number in _HOMES and own.number in _PATHS
        if homes or own.number == _NO_MOTION:
            state.motion = state.resumed = own.number if homes else state.resumed
            state.cycle.level = own = None
    axes = "X" in words or "Y" in words or "Z" in words or "@" in words or "^" in words
    if own is not None:
        if own.number != _NO_MOTION and takes_axes and other is not None:
            names = f"{g_name(other.number)} and {g_name(own.number)}"
            raise BlockError(f"CL812 {names} both use the axis words: write each on its own line", own.column)
        if own.number == _NO_MOTION and axes and not takes_axes:
            word = next(words[letter] for letter in "XYZ@^" if letter in words)
            raise BlockError(
                f"CL811 {word.letter} has no effect with G80, which ends all motion: delete it, or write G0 or G1 too", word.column
            )
        # G0 and G1 need no axes; full circles and the first line of a NURBS need no end point.
        if not axes and own.number not in (0, 10, *ARCS, 52, _NO_MOTION):
            raise BlockError(f"CL813 {g_name(own.number)} has no axis: write X, Y or Z", own.column)
        return own.number
    if takes_axes:
        return None
    if axes:
        if "tool_length" in codes and codes["tool_length"].number in (431, 432):
            return None
        if state.motion is None or state.motion == _NO_MOTION:
            word = next(words[letter] for letter in "XYZ@^" if letter in words)
            raise BlockError(f"CL814 {word.letter} has no motion code: write G0, G1, G2 or G3 before it", word.column)
        return state.motion
    return state.motion if state.motion in ARCS and ("I" in words or "J" in words or "K" in words) else None


def _check_letters(block: Block, state: ModalState, motion: int | None) -> None:
    """Refuse words that no code of the block uses."""
    if block.words.keys() <= _PLAIN_LETTERS:
        return
    active: set[int | str] = {code.number if group in _G_GROUPS else f"M{code.number}" for group, code in block.codes.items()}
    if motion is not None:
        active.add(motion)
    if "P" in block.words and 40 in active and len(active & USERS["P"][0]) > 1:
        raise BlockError("CL812 G4 and another code of the block both use P: write G4 on its own line", block.words["P"].column)
    for letter, word in block.words.items():
        if letter in "PQKL" and state.rules.own_cycles and motion in CYCLES:
            continue
        if letter in USERS and not USERS[letter][0] & active:
            raise BlockError(f"CL811 no active code uses {letter}: delete it, or write {USERS[letter][1]}", word.column)


def _dwell(block: Block, state: ModalState, line: int) -> list[Move]:
    rules = state.rules
    word = block.words.get("P") or (block.words.get("X") if rules.dwell_x else None)
    if word is None:
        raise BlockError(
            f"CL813 G4 has no time: write for example G4 P{0.5 / rules.dwell:g} for half a second", block.codes["other"].column
        )
    seconds = word.value * (rules.dwell if word.letter == "P" else 1.0)
    if not 0.0 <= seconds <= LONGEST_DWELL:
        raise BlockError(f"CL806 G4 {word.letter}{word.value:g}: write a time from 0 to {LONGEST_DWELL:g} s", word.column)
    return state.wait(seconds, line)


def _set_modes(block: Block, state: ModalState, line: int) -> list[Move]:
    """Execute the codes of a block other than its motion, in their order."""
    codes = block.codes
    moves: list[Move] = []
    other = codes.get("other")
    if other is not None and other.number == 40:
        moves += _dwell(block, state, line)
    for group in _MODES:
        if group in codes:
            code = codes[group].number
            if group == "tool_length":
                set_tool_length(block, state, code)
            elif group == "system":
                select_system(state, code)
            elif group == "control":
                _set_control(block, state, code)
            else:
                setattr(state, *_SETTINGS[code])
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
        state.mode = Mode("exact_path" if code == 610 and not state.rules.stops_at_g61 else "exact_stop", None, None, state.mode.tool)
        return
    lengths: list[float | None] = []
    for letter in "PQ":
        word = block.words.get(letter)
        if word is not None and word.value < 0.0:
            raise BlockError(f"CL806 {letter}{word.value:g}: a tolerance of G64 cannot be negative", word.column)
        lengths.append(None if word is None else state.length(word.value))
    tolerance, merge = lengths
    state.mode = Mode("blend", tolerance, tolerance if merge is None else merge, state.mode.tool)


def _motion(block: Block, state: ModalState, line: int, before: int | None) -> list[Move]:
    """Make the motion of a block; `before` is the previous modal motion."""
    motion = state.motion
    if motion != 52 and state.curve.points:
        raise BlockError("CL826 the NURBS begun with G5.2 is not closed: write G5.3 before the next motion", block.column)
    if motion in CYCLES:
        return drill(block, state, line, again=before == motion)
    if motion in SPLINES:
        refuse(
            state.feed_mode == "inverse_time", BlockError, "CL816 splines cannot use inverse-time feed (G93): write G94 and F", block.column
        )
        if motion == 52:
            add_control_point(block, state)
            return []
        moves = bezier(block, state, line)
        state.motion = before  # G5 and G5.1 hold for their own block only
        return moves
    state.tangent = None
    other = block.codes.get("other")
    end = machine_target(block, state, line) if other is not None and other.number == 530 else state.target(block.words)
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
        raise BlockError(f"CL815 {name} with G93 has no F: write F on each move, as 1 / (time in minutes)", column)
    if word.value <= 0.0:
        raise BlockError(f"CL806 F{word.value:g}: with G93, F is 1 / (time in minutes) and must be greater than 0", word.column)
    state.feedrate = max(length * word.value, state.length(LEAST_TIMED_RATE)) / 60.0
    return state.feedrate


def _execute_events(block: Block, state: ModalState, line: int) -> None:
    """Record speed, tool number, outputs, tool change, spindle, coolant and overrides, in the order of RS274/NGC."""
    codes, words = block
    speed, tool = words.get("S"), words.get("T")
    if speed is not None:
        if speed.value < 0.0:
            raise BlockError(f"CL806 S{speed.value:g}: a spindle speed cannot be negative; M4 turns it the other way", speed.column)
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
    refuse(word is None and code in _NEEDED, BlockError, f"CL813 M{code} has no {letter}: write for example {letter}1", column)
    index = block.words.get("E") if code in (67, 68) else None
    refuse(index is None and code in (67, 68), BlockError, f"CL813 M{code} has no E: write the number of the output", column)
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
        raise BlockError(f"CL806 R{turn.value:g}: M19 needs an angle from 0 to 360 degrees", turn.column)
    if way is not None and way.value not in (0.0, 1.0, 2.0):
        raise BlockError(f"CL806 P{way.value:g}: M19 needs P0 (shorter way), P1 (clockwise) or P2 (counterclockwise)", way.column)


def _tool_number(word: Word) -> int:
    return word.whole(0, LARGEST_TOOL, "the tool number", 0.0)
