"""Commands as a person types them."""

from __future__ import annotations

import os
import shlex
from collections.abc import Iterable, Sequence
from itertools import pairwise

_SPECIAL = set('"$`!') | (set() if os.name == "nt" else {"\\"})


def as_typed(words: Iterable[str]) -> str:
    """Join the words of a command for any shell; `shlex.split` takes them apart again.

    Double quotes where they do: the Windows prompt knows no others.

    >>> print(as_typed(["contourlab", "run", "my part.ngc", "--tolerance", "20 um", "--scheme", "$5"]))
    contourlab run "my part.ngc" --tolerance "20 um" --scheme '$5'
    """
    return " ".join(_quoted(word) for word in words)


def chosen_options(words: Sequence[str], *names: str) -> list[str]:
    """Return some of the options of a command with their values, in the order typed.

    >>> chosen_options(["--plugin", "a.py", "--out", "here"], "--plugin")
    ['--plugin', 'a.py']
    """
    return [word for name, value in pairwise(words) if name in names for word in (name, value)]


def without_options(options: Sequence[str], *names: str) -> list[str]:
    """Return the options of a command without some that have a value."""
    starts = [i for i, word in enumerate(options) if word in names]
    return [word for i, word in enumerate(options) if i not in starts and i - 1 not in starts]


def _quoted(word: str) -> str:
    quoted = shlex.quote(word)
    return quoted if quoted == word or _SPECIAL & set(word) else f'"{word}"'
