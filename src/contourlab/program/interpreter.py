"""Executes blocks: what a line does to the modal state, and the moves that it makes.

Within a block RS274/NGC fixes the order, whatever the order of the words: feed mode, feedrate, spindle, tool, coolant, overrides, dwell,
plane, units, distance modes, motion, pause or end of program. So F is read in the units that were in force before a G20 or G21 on its line,
while X, Y and Z are read in the new ones; and G94 clears an earlier feedrate, but not the F on its own line.
"""

from __future__ import annotations

import math

from contourlab.program.arcs import make_arc
from contourlab.program.block import Block
from contourlab.program.events import OVERRIDES_WITH_P, events_before_motion, pause
from contourlab.program.fault import BlockError
from contourlab.program.moves import Dwell, Event, Feed, Move, Traverse
from contourlab.program.state import SETTERS, ModalState

__all__ = ["SHORTEST_MOVE", "execute"]

SHORTEST_MOVE = 1e-12
"""Straight moves of at most this length [m] are rounding, and no moves."""
LARGEST_FEEDRATE = 1e3
"""Feedrates beyond this [m/s] are a slip."""
LONGEST_DWELL = 86_400.0
"""Dwells beyond this [s] are a slip."""

_ARCS = (20, 30)
_ARC_LETTERS = frozenset("IJKRP")


def execute(block: Block, state: ModalState, line: int, events: list[Event]) -> list[Move]:
    """Execute one block.

    Parameters
    ----------
    block : Block
    state : ModalState
        Changed in place.
    line : int
        Source line of the block, for its moves.
    events : list of Event
        What the block asks for besides motion is added to it.

    Returns
    -------
    list of Move
        None, one, or a dwell and a move.

    Raises
    ------
    BlockError
        If the block makes no sense in this state.
    """
    codes, words = block
    moves: list[Move] = []
    if state.plane != "XY" and ("@" in words or "^" in words):
        raise BlockError("polar coordinates lie in the XY plane: write G17 on a line before", (words.get("@") or words["^"]).column)
    if "feed_mode" in codes:
        state.feedrate = 0.0
    if "F" in words:
        _set_feedrate(block, state)
    events += events_before_motion(block, line)
    if "dwell" in codes:
        moves += _dwell(block, line)
    if codes:
        for group, setter in SETTERS.items():
            if group in codes:
                setter(state, codes[group].number)
    if "motion" in codes:
        state.motion = codes["motion"].number
    elif "cycle_end" in codes:
        state.motion = None
    _check_letters(block, state)
    if _moves(block, state):
        moves += _motion(block, state, line)
    events += pause(block, line)
    return moves


def _set_feedrate(block: Block, state: ModalState) -> None:
    word = block.words["F"]
    feedrate = state.length(word.value) / 60.0
    if feedrate < 0.0:
        raise BlockError(f"F{word.value:g}: a feedrate cannot be negative", word.column)
    if feedrate > LARGEST_FEEDRATE:
        raise BlockError(f"F{word.value:g} is {feedrate:g} m/s: too fast; F is length per minute", word.column)
    state.feedrate = feedrate


def _dwell(block: Block, line: int) -> list[Move]:
    word = block.words.get("P")
    if word is None:
        raise BlockError("G4 has no time: write for example G4 P0.5 for half a second", block.codes["dwell"].column)
    if not 0.0 <= word.value <= LONGEST_DWELL:
        raise BlockError(f"G4 P{word.value:g}: P is in seconds and lies between 0 and {LONGEST_DWELL:g}", word.column)
    return [Dwell(word.value, line)] if word.value > 0.0 else []


def _moves(block: Block, state: ModalState) -> bool:
    """Tell whether the block makes a motion, explicit or modal."""
    words = block.words
    if "X" in words or "Y" in words or "Z" in words or "@" in words or "^" in words:
        return True
    if state.motion in _ARCS:
        # Unlike G0 and G1, which may stand alone, an arc asked for by name must come whole.
        return "motion" in block.codes or "I" in words or "J" in words or "K" in words
    return False


def _check_letters(block: Block, state: ModalState) -> None:
    """Refuse words that no code of the block uses."""
    motion = state.motion in _ARCS and _moves(block, state)
    for letter, word in block.words.items():
        if letter not in _ARC_LETTERS:
            continue
        if letter == "P" and "overrides" in block.codes and block.codes["overrides"].number in OVERRIDES_WITH_P:
            if motion or "dwell" in block.codes:
                raise BlockError("two codes of one block would share P: write each on a line of its own", word.column)
        elif letter == "P" and "dwell" in block.codes:
            if motion:
                raise BlockError("G4 and an arc in one block would share P: write G4 on a line of its own", word.column)
        elif not motion:
            user = "G4, G2 or G3" if letter == "P" else "G2 or G3"
            raise BlockError(f"{letter} has no {user} to use it: delete it, or write the code before it", word.column)


def _motion(block: Block, state: ModalState, line: int) -> list[Move]:
    if state.motion is None:
        word = next(block.words[letter] for letter in "XYZ@^" if letter in block.words)
        raise BlockError(f"{word.letter} without a motion: write G0, G1, G2 or G3 before it", word.column)
    end = state.target(block.words)
    if state.motion != 0 and state.feedrate == 0.0:
        at = block.codes.get("motion") or next(iter(block.words.values()))
        cure = "write F (length per minute) on its line or before it; G94 clears an earlier one"
        raise BlockError(f"G{state.motion // 10} without a feedrate: {cure}", at.column)
    moves: list[Move] = []
    if state.motion in _ARCS:
        moves.append(make_arc(block, state, end, line))
    elif math.dist(state.reached, end) > SHORTEST_MOVE:
        if state.motion == 0:
            moves.append(Traverse(state.reached, end, line))
        else:
            moves.append(Feed(state.reached, end, state.feedrate, line))
    state.position = end
    if moves:
        state.reached = end
    return moves
