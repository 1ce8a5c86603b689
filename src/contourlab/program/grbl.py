"""The grbl dialect: what grbl 1.1 lets pass and LinuxCNC does not, each told in a notice."""

from __future__ import annotations

import re

from contourlab.program.moves import Notice
from contourlab.program.state import ModalState

_COMMENT = re.compile(r"\([^()]*\)|;.*")
_AXIS = re.compile(r"[XYZxyz]")
_MOTION = re.compile(r"[Gg][ \t]*0*(?:[0-3](?:\.0*)?|38\.[2-5]|28|30|92|10|53|43\.1|80)(?![0-9.])")


def tolerated(line: str, number: int, notices: list[Notice], state: ModalState) -> str:
    """Return a line as LinuxCNC would want it, and note what was let pass.

    Parameters
    ----------
    line : str
    number : int
        Of the line, from 1.
    notices : list of Notice
        Added to.
    state : ModalState
        A motion that nobody has given is G0, as after grbl's start.
    """
    plain = line.strip()
    if plain.startswith("$") or plain in ("!", "~", "?"):
        notices.append(Notice(f"{plain[:20]} is for the controller itself and was passed over", number, 1))
        return ""
    if plain == "%":
        notices.append(Notice("a line of % was passed over", number, 1))
        return ""
    blank = _without_comments(line)
    opened = blank.find("(")
    if opened >= 0 and ")" not in blank[opened:]:
        notices.append(Notice("the comment has no end: the rest of the line was taken for it", number, opened + 1))
        line = line[:opened]
        blank = blank[:opened]
    if state.motion is None and (axis := _AXIS.search(blank)) and not _MOTION.search(blank):
        notices.append(Notice("a move before any motion code: taken for G0, as after grbl's start", number, axis.start() + 1))
        state.motion = 0
    return line


def _without_comments(line: str) -> str:
    """Return a line with blanks for its comments, so that the columns stay; a comment without an end is left."""
    return _COMMENT.sub(lambda comment: " " * len(comment[0]), line)
