"""Limits on what it may cost to read a log: a small file must not fill the memory."""

from __future__ import annotations

import math
import os
from pathlib import Path

from contourlab.errors import LogError, ParameterError

SETTING = "CONTOURLAB_LOG_LIMIT"
"""Environment variable with a factor on all limits."""
COLUMNS = 10_000
LINE = 1_000_000
"""Characters of a line of text."""
NUMBERS = 50_000_000
"""Numbers of a log in a compressed or sparse format."""
MEMORY = 850_000_000
"""Memory of the process that reads a binary format [byte]."""
TIME = 60.0
"""Time of that process [s]."""


def factor() -> float:
    """Return the factor on all limits.

    Raises
    ------
    ParameterError
        If the setting is not a positive number.
    """
    text = os.environ.get(SETTING, "1")
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0.0 < value < math.inf:
        raise ParameterError(SETTING, repr(text), "a factor > 0, such as 4")
    return value


def check_limit(count: int, most: int, what: str, file: Path, line: int = 0) -> None:
    """Raise `LogError` if a log has more than `most` columns, characters or numbers, times the factor."""
    if count > most * factor():
        # Rounded up, so that the value in the message is enough.
        raise LogError(f"has {count} {what}, too many: set {SETTING}={math.ceil(count / most)} to read it", file=file, line=line)


def raised() -> str:
    """Return what to write if memory or time are not enough."""
    return f"if the file is sound, set {SETTING}={math.ceil(2.0 * factor())}"
