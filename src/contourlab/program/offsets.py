"""Codes that set the coordinate system: G10, G28 and G30, G43 and G49, G52, G53, G54 to G59.3, G92."""

from __future__ import annotations

from contourlab.program.block import Block, Code, Word
from contourlab.program.coordinates import LARGEST_TOOL, ORIGIN, add, less, load_shift, origin_of, store_origin, store_shift, turn, updated
from contourlab.program.expressions import SELECTED_SYSTEM
from contourlab.program.moves import Move, Point
from contourlab.program.state import ModalState
from contourlab.program.vocabulary import SYSTEMS, BlockError

_HOMES = {280: 5161, 281: 5161, 300: 5181, 301: 5181}
_TOOL_LEVELS = (1, 10, 11)
_FIXTURE = 9


def select_system(state: ModalState, code: int) -> None:
    """Select a work coordinate system (G54 to G59.3); a system already selected is not reloaded."""
    system = SYSTEMS.index(code) + 1
    frame = state.frame
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
            raise BlockError("G43.2 needs a tool, as in H3, or lengths, as in Z5: write one of the two", block.codes["tool_length"].column)
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
            raise BlockError(f"{name} has no axis: write for example {name} X0 Y0", code.column)
        shift = list(frame.shift)
        for axis, value in enumerate(given):
            if value is not None:
                shift[axis] = value if code.number == 520 else state.position[axis] + shift[axis] - value
        frame.shift = (shift[0], shift[1], shift[2])
        store_shift(parameters, frame.shift, applied=True)
    elif code.number == 923:
        frame.shift = load_shift(parameters)
        store_shift(parameters, frame.shift, applied=True)
    else:
        frame.shift = ORIGIN
        store_shift(parameters, ORIGIN if code.number == 921 else load_shift(parameters), applied=False)
    state.see_from(axes)


def set_data(block: Block, state: ModalState) -> None:
    """Execute G10: L2 and L20 set the origin of a work coordinate system, L1, L10 and L11 the offset of a tool."""
    words, code = block.words, block.codes["other"]
    level = None if "L" not in words else words["L"].whole(0, 10**9, "L of G10")
    if level not in (2, 20, *_TOOL_LEVELS):
        raise BlockError("G10 takes L2 or L20 (work coordinate system), L1, L10 or L11 (tool): write for example G10 L2 P1 X0", code.column)
    if "P" not in words:
        what = "tool" if level in _TOOL_LEVELS else "system, 1 for G54"
        raise BlockError(f"G10 L{level} has no P: write the number of the {what}", code.column)
    number = words["P"].whole(0, LARGEST_TOOL, "P of G10")
    if level in _TOOL_LEVELS:
        _set_tool(words, state, level, number)
        return
    if number > len(SYSTEMS):
        raise BlockError(f"P{number}: write 1 (G54) to 9 (G59.3), or 0 for the selected work coordinate system", words["P"].column)
    for letter in "IJ":
        if letter in words:
            raise BlockError(f"{letter} has no meaning with G10 L{level}: delete it", words[letter].column)
    if level == 20 and "R" in words:
        raise BlockError("G10 L20 does not take R (rotation): set it with G10 L2 on its own line", words["R"].column)
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
        tip = less(state.axes, frame.tool)
        here = less(turn(less(tip, origin), -rotation), frame.shift)
        origin = add(origin, turn(less(here, updated(here, given)), rotation))
    store_origin(state.parameters, system, origin, rotation)
    if system == frame.system:
        frame.origin, frame.rotation = origin, rotation
        state.see_from(axes)


def _set_tool(words: dict[str, Word], state: ModalState, level: int, number: int) -> None:
    if number < 1:
        raise BlockError(f"P{number}: G10 L{level} needs a tool number, 1 or more", words["P"].column)
    given = state.given(words)
    if all(value is None for value in given) and "R" not in words:
        raise BlockError(f"G10 L{level} sets nothing: write the tool's offset, as in Z25", words["P"].column)
    old = state.tools.offset(number)
    if level == 1:
        state.tools.offsets[number] = updated(old, given)
    else:
        state.tools.offsets[number] = _touched_off(state, given, old, level)
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
    kept = turn(old, -rotation)
    x, y, z = (before if new is None else point - new for before, point, new in zip(kept, seen, given, strict=True))
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
    moves = state.straight(state.target(words), line)
    home = state.frame.point(state.parameters.point(first))
    named = [letter in words for letter in "XYZ"]
    x, y, z = (h if chosen or not any(named) else p for h, p, chosen in zip(home, state.position, named, strict=True))
    return moves + state.straight((x, y, z), line)


def machine_target(block: Block, state: ModalState) -> Point:
    """Return the point of the program [m] at the machine coordinates of a G53 block.

    Raises
    ------
    BlockError
        If the block is incremental or polar.
    """
    words, column = block.words, block.codes["other"].column
    if not state.absolute:
        raise BlockError("G53 (machine coordinates) needs absolute mode: write G90", column)
    if "@" in words or "^" in words:
        raise BlockError("G53 does not take polar coordinates: write X, Y and Z", column)
    point = state.frame.point(updated(state.axes, state.given(words)))
    state.check_reach(point, words)
    return point
