"""What single controls refuse, or read in their own way: their lines before they are read, their blocks before they are executed."""

from __future__ import annotations

import re
from collections.abc import Callable

from contourlab.errors import refuse
from contourlab.program.block import Block
from contourlab.program.moves import Notice
from contourlab.program.state import ModalState
from contourlab.program.vocabulary import AXIS_WORDS, BlockError, g_name

_COMMENT = re.compile(r"\([^()]*\)|;.*")
_AXIS = re.compile(r"[XYZxyz]")
_MOTION = re.compile(r"[Gg][ \t]*0*(?:[0-3](?:\.0*)?|38\.[2-5]|28|30|92|10|43\.1|80)(?![0-9.])")
_MACRO = re.compile(r"[#\[]|\bGOTO", re.IGNORECASE)
_LONGEST_LINE = 79
"""Most characters of a line of grbl 1.1, without blanks and comments."""


def _grbl_line(line: str, number: int, notices: list[Notice], state: ModalState) -> str:
    """Convert a line of grbl 1.1 to LinuxCNC; add a notice of each deviation."""
    plain = line.strip()
    if plain.startswith("$") or plain in ("!", "~", "?", "%"):
        what = "a line with only %" if plain == "%" else f"{plain[:20]} is a command to the controller, not a part program"
        notices.append(Notice(f"{what}: ignored", number, 1))
        return ""
    blank = _without_comments(line)
    opened = blank.find("(")
    if opened >= 0 and ")" not in blank[opened:]:
        notices.append(Notice("the comment has no ')': the rest of the line is read as comment", number, opened + 1))
        line, blank = line[:opened], blank[:opened]
    if state.motion is None and (axis := _AXIS.search(blank)) and not _MOTION.search(blank):
        notices.append(Notice("a move before any motion code: read as G0, the default of grbl", number, axis.start() + 1))
        state.motion = 0
    return line


def _plain_grbl_line(line: str, number: int, notices: list[Notice], state: ModalState) -> str:
    """Convert a line of grbl 1.1 as it is built by default; it has no expressions, and a small buffer."""
    line = _grbl_line(line, number, notices, state)
    blank = _without_comments(line)
    _refuse_macros(blank, "grbl 1.1")
    if len("".join(blank.split())) > _LONGEST_LINE:
        raise BlockError(f"CL805 the line has more than {_LONGEST_LINE} characters, which grbl 1.1 cannot hold (error:11): divide it", 1)
    return line


def _fanuc_line(line: str, number: int, notices: list[Notice], state: ModalState) -> str:
    """Return a line of Fanuc, which has macros of its own and reads numbers by whether they have a decimal point."""
    blank = _without_comments(line)
    _refuse_macros(blank, "a Fanuc")
    if point := re.search(r"P\s*[0-9]*\.", blank, re.IGNORECASE):
        raise BlockError(
            f"CL806 {point[0]} has a decimal point: a Fanuc takes P in ms, without one; write G4 X for seconds", point.start() + 1
        )
    whole = re.search(r"[XYZIJKRQ]\s*[+-]?\s*0*[1-9][0-9]*(?![0-9.])", blank, re.IGNORECASE)
    if whole and not any("decimal point" in notice.message for notice in notices):
        words = f"{whole[0]} has no decimal point: read as written, but with parameter 3401 (DPI) = 0 a Fanuc takes a thousandth"
        notices.append(Notice(words, number, whole.start() + 1))
    return line


def _without_comments(line: str) -> str:
    """Return a line with blanks in place of comments, which keep the columns."""
    return _COMMENT.sub(lambda comment: " " * len(comment[0]), line)


def _refuse_macros(blank: str, title: str) -> None:
    if macro := _MACRO.search(blank):
        raise BlockError(
            f"CL808 parameters, expressions and jumps of {title} are not read: write numbers and plain moves", macro.start() + 1
        )


def _check_grbl(block: Block, state: ModalState) -> None:
    """Refuse what grbl 1.1 refuses, and words that it ignores; the numbers are its own."""
    codes, words = block
    own, other, length = codes.get("motion"), codes.get("other"), codes.get("tool_length")
    axes = [words[letter] for letter in "XYZ" if letter in words]
    takes_axes = other is not None and other.number in AXIS_WORDS
    motion = state.motion if own is None else own.number
    if length is not None:
        if takes_axes or (own is not None and motion != 800):
            raise BlockError(
                f"CL812 {g_name(length.number)} cannot share a line with a motion (error:24): write it on its own", length.column
            )
        wanted = "Z" if length.number == 431 else ""
        if "".join(axis.letter for axis in axes) != wanted:
            raise BlockError(f"CL811 {g_name(length.number)} takes {wanted or 'no axis'} alone (error:37): correct it", length.column)
    if motion == 800 and axes:
        raise BlockError(f"CL811 {axes[0].letter} has no effect after G80 (error:31): write G0 or G1 before it", axes[0].column)
    if other is not None and other.number == 100:
        refuse(not axes, BlockError, "CL813 G10 has no axis (error:26): write X, Y or Z", other.column)
        _check_g10(block, (2, 20))
    if "T" in words and words["T"].value > 255:
        raise BlockError(f"CL806 T{words['T'].value:g}: the largest tool number of grbl is 255 (error:38)", words["T"].column)
    if state.feed_mode == "inverse_time" and "F" in words and "feed_mode" in codes and not state.millimetres:
        raise BlockError("CL815 after G93 grbl reads an F beside G94 in mm/min: write G94 on the line before", words["F"].column)


def _check_g10(block: Block, levels: tuple[int, ...]) -> None:
    """Refuse what G10 sets otherwise than LinuxCNC."""
    words, code = block.words, block.codes["other"]
    if "R" in words or ("L" in words and words["L"].value not in levels) or ("P" in words and not 0 <= words["P"].value <= 6):
        shown = " or ".join(f"L{level}" for level in levels)
        raise BlockError(f"CL813 G10 is read with {shown}, P up to 6 and no R in this dialect: write it so", code.column)


def _check_fanuc(block: Block, state: ModalState) -> None:
    other = block.codes.get("other")
    if other is None:
        return
    if other.number == 40 and len(block.words.keys() & set("XYZP")) > 1:
        raise BlockError("CL811 G4 takes P or X alone: write other words on the next line", other.column)
    if other.number in (280, 300) and not block.words.keys() & set("XYZ"):
        raise BlockError(f"CL813 {g_name(other.number)} has no axis: write those that go home, such as Z0", other.column)
    if other.number == 100:
        _check_g10(block, (2,))
        if not state.absolute or ("P" in block.words and block.words["P"].value == 0):
            raise BlockError("CL816 G10 L2 is read in G90 and with P1 to P6 in this dialect: write it so", other.column)


def _check_mach3(block: Block, state: ModalState) -> None:
    if "other" in block.codes and block.codes["other"].number == 100:
        _check_g10(block, (2,))


PREPARE: dict[str, Callable[[str, int, list[Notice], ModalState], str]] = {
    "grbl": _plain_grbl_line,
    "grblhal": _grbl_line,
    "fanuc": _fanuc_line,
}
"""Change a line of a dialect, with its number, before it is read; add notices."""
CHECKS: dict[str, Callable[[Block, ModalState], None]] = {"grbl": _check_grbl, "fanuc": _check_fanuc, "mach3": _check_mach3}
"""Refuse blocks of a dialect that its control refuses, or would execute otherwise."""
