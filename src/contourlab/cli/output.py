"""What the commands print: text and JSON on standard output, never half of both."""

from __future__ import annotations

import json
import os
import sys
from typing import TYPE_CHECKING, Any, Protocol

from contourlab.app.json_values import json_values

if TYPE_CHECKING:
    from contourlab.features.run.command import RunOutcome


class HasText(Protocol):
    """A result of a command."""

    @property
    def text(self) -> str:
        """What the terminal shows."""


def silence() -> None:
    """Send what is still to come on standard output nowhere: its reader has gone."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nowhere, sys.stdout.fileno())
    finally:
        os.close(nowhere)


def say(text: str) -> None:
    """Print text and a newline; a reader that has gone (``| head``) is no error, so the command's own exit code stands.

    Raises
    ------
    OSError
        If standard output cannot be written, such as a full disk.
    """
    try:
        sys.stdout.write(text + "\n")
        sys.stdout.flush()
    except BrokenPipeError:
        silence()


def emit_json(value: Any) -> None:
    """Print one JSON document, strict: readers without an extension for nan can read it."""
    say(json.dumps(json_values(value), indent=2, allow_nan=False))


def show_result(result: HasText, as_json: bool) -> None:
    """Print a result as JSON or as text."""
    if as_json:
        emit_json(result)
    else:
        say(result.text)


def conclude(outcome: RunOutcome, as_json: bool) -> int:
    """Print what a command found, and return its exit code: 0, or 1 where a verdict is not passed.

    Raises
    ------
    DivergenceError
        After the printing, if a scheme ran away.
    """
    if as_json:
        emit_json(outcome.summary)
    else:
        say(outcome.table)
    if outcome.runaway is not None:
        raise outcome.runaway
    return 0 if outcome.passed else 1


def wants_progress(as_json: bool) -> bool:
    """Tell whether a progress line has a reader: a terminal on standard error, and nobody who parses the output."""
    return sys.stderr.isatty() and not as_json
