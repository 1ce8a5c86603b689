"""Progress of a command on standard error: a bar on a terminal, else a line every two seconds with share and time left."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from time import monotonic
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console
    from rich.progress import Progress, TaskID

INTERVAL = 2.0
"""Longest silence of a command [s]."""


class Heartbeat:
    """Prints what a command is doing, every two seconds, unless a bar shows it.

    Attributes
    ----------
    command : str
    stage : str
        Empty for a command without stages.
    has_bar : bool
        Whether a bar shows the progress.
    """

    def __init__(self, command: str) -> None:
        self.command, self.stage, self.has_bar = command, "", False
        self._began = self._stage_began = monotonic()
        self._share, self._step, self._steps = 0.0, 0, 0
        self._ended = threading.Event()

    def expect(self, steps: int) -> None:
        """Take the number of stages that follow, so that shares are those of all of them."""
        self._steps, self._step, self._began = steps, 0, monotonic()

    def reach(self, step: int) -> None:
        """Take the number of stages that have ended, where some were left out."""
        self._step = step

    def begin(self, words: str) -> None:
        """Begin a stage."""
        self.stage, self._share, self._stage_began = words, 0.0, monotonic()
        self._step += 1

    def advance(self, done: int, total: int) -> None:
        """Take the progress of the stage; runs side by side may report it out of order."""
        self._share = max(self._share, done / total if total else 0.0)

    def line(self) -> str:
        """Return command, stage, share and time left, or the time since the command began."""
        words = f"{self.command}: {self.stage}" if self.stage else self.command
        share, spent, of = self._share, monotonic() - self._stage_began, " of this step"
        if self._steps:
            share, spent, of = (self._step - 1 + self._share) / self._steps, monotonic() - self._began, ""
        if 0.0 < share < 1.0:
            return f"{words}, {100.0 * share:.0f} %{of}, {spent * (1.0 - share) / share:.0f} s left"
        return f"{words}, {monotonic() - self._began:.0f} s"

    def beat(self) -> None:
        """Print lines until `end`."""
        while not self._ended.wait(INTERVAL):
            with suppress(OSError, ValueError):  # its reader is gone
                sys.stderr.write("" if self.has_bar else self.line() + "\n")
                sys.stderr.flush()

    def end(self) -> None:
        """Print no further line."""
        self._ended.set()


_running: Heartbeat | None = None


@contextmanager
def heartbeat(command: str) -> Iterator[None]:
    """Print a line on standard error every two seconds while the block runs, unless ``CONTOURLAB_PROGRESS=0``."""
    global _running
    if os.environ.get("CONTOURLAB_PROGRESS") == "0":
        yield
        return
    _running = Heartbeat(command)
    thread = threading.Thread(target=_running.beat, daemon=True)
    thread.start()
    try:
        yield
    finally:
        _running.end()
        thread.join()
        _running = None


class Stages:
    """The stages of a run, one after another.

    Parameters
    ----------
    bar : rich.progress.Progress, optional
        Shows the stages; without it the heartbeat of the command does, if there is one.
    """

    def __init__(self, bar: Progress | None = None) -> None:
        self._bar = bar
        self._task: TaskID | None = None

    def expect(self, steps: int) -> None:
        """Take the number of stages, about equally long: lines then show share and time left of the whole command."""
        if _running is not None:
            _running.expect(steps)

    def reach(self, step: int) -> None:
        """Take the number of stages that have ended, where some were left out."""
        if _running is not None:
            _running.reach(step)

    def begin(self, words: str) -> None:
        """End the previous stage, and show a new one with its elapsed time."""
        if _running is not None:
            _running.begin(words)
        if self._bar is None:
            return
        if self._task is not None:
            self._bar.remove_task(self._task)
        # Without a total the bar pulses instead of being empty.
        self._task = self._bar.add_task(words, total=None)

    def advance(self, done: int, total: int) -> None:
        """Show the progress of the stage."""
        if _running is not None:
            _running.advance(done, total)
        if self._bar is not None and self._task is not None:
            self._bar.update(self._task, completed=done, total=total)


@contextmanager
def shown(wanted: bool, console: Console | None = None) -> Iterator[Stages]:
    """Show stages on standard error while the block runs, and leave no bar behind.

    Parameters
    ----------
    wanted : bool
        Whether to show a bar.
    console : rich.console.Console, optional
        By default standard error.
    """
    if not wanted:
        yield Stages()
        return
    from rich.console import Console as Terminal
    from rich.progress import BarColumn, Progress, SpinnerColumn, TaskProgressColumn, TextColumn, TimeRemainingColumn

    # Brackets in names of schemes are text, not markup.
    text, left = TextColumn("{task.description}", markup=False), TimeRemainingColumn(elapsed_when_finished=True)
    terminal = console or Terminal(stderr=True)
    with Progress(SpinnerColumn(), text, BarColumn(), TaskProgressColumn(), left, console=terminal, transient=True) as bar:
        if _running is not None:
            _running.has_bar = True
        try:
            yield Stages(bar)
        finally:
            if _running is not None:
                _running.has_bar = False
