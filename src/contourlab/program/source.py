"""Text of part programs: from files, in UTF-8 or else in Latin-1, and into lines."""

from __future__ import annotations

import re
from pathlib import Path

from contourlab.errors import ProgramError

_LINE_BREAK = re.compile(r"\r\n|\n|\r")


def unreadable(file: str | Path, error: OSError | ValueError) -> ProgramError:
    """Return the error of a file that cannot be read."""
    reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
    return ProgramError(f"the part program cannot be read: {reason}", file=file)


def read_text(path: Path) -> str:
    """Return the text of a file.

    Raises
    ------
    ProgramError
        If it cannot be read.
    """
    try:
        content = path.read_bytes()
    except (OSError, ValueError) as error:
        raise unreadable(path, error) from error
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("latin-1")


def is_utf8(line: bytes) -> bool:
    """Tell whether bytes are text in UTF-8."""
    try:
        line.decode("utf-8")
    except UnicodeDecodeError:
        return False
    return True


def split_lines(text: str) -> list[str]:
    """Return the lines of a text, without their breaks."""
    # Not splitlines(): its other separators (form feed, U+2028 ...) would shift the line numbers of editors.
    lines = _LINE_BREAK.split(text)
    return lines[:-1] if lines and not lines[-1] else lines
