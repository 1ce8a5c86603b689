"""Output of the commands: either text or JSON on standard output."""

from __future__ import annotations

import os
import sys

from contourlab.app.command_line import as_typed

TYPED: list[str] = []
"""The words of the command, after the name of the program."""


def silence() -> None:
    """Discard further standard output, because its reader is gone."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nowhere, sys.stdout.fileno())
    finally:
        os.close(nowhere)


def say(text: str) -> None:
    """Print text and a newline. A closed pipe (``| head``) is not an error, so the command keeps its exit code.

    Raises
    ------
    OSError
        If standard output cannot be written, for example to a full disk.
    """
    try:
        sys.stdout.write(text + "\n")
        sys.stdout.flush()
    except BrokenPipeError:
        silence()


def suggest(as_json: bool, *words: object) -> None:
    """Print the next command to type; words that are None are left out with the option before them."""
    if as_json:
        return
    typed: list[str] = []
    for word in words:
        if word is None:
            typed.pop()
        else:
            typed.append(str(word))
    say(f"\nnext: {as_typed(['contourlab', *typed])}")


def wants_progress(as_json: bool) -> bool:
    """Tell whether to show progress: standard error is a terminal, and no JSON is wanted."""
    return sys.stderr.isatty() and not as_json
