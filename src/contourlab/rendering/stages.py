"""Progress of a command on standard error: a bar on a terminal, else a line every two seconds with share and time left."""

from __future__ import annotations

import math
import os
import sys
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from time import monotonic
from typing import TYPE_CHECKING

from contourlab.rendering.table import page_width

if TYPE_CHECKING:
    from rich.console import Console
    from rich.progress import Progress, TaskID

INTERVAL = 2.0
"""Longest silence of a command [s]."""
KNOWN = 0.02
"""Share of the work below which the time left is a guess: the first steps compile."""


class Stages:
    """The stages of a command, one after another: a bar shows them, or a line every two seconds.

    Attributes
    ----------
    command : str
        Empty outside the command line.
    stage : str
        Empty for a command without stages.
    waits_for : str
        What the work cannot go on without; empty while it goes on.
    is_asking : bool
        Whether a question stands in the last line; then no progress is shown.
    """

    def __init__(self, command: str = "") -> None:
        self.command, self.stage, self.waits_for, self.is_asking = command, "", "", False
        self._bar: Progress | None = None
        self._task: TaskID | None = None
        self._began = self._stage_began = monotonic()
        self._in_stage = self._share = self._reached = 0.0
        self._work: list[tuple[str, float]] = []
        self._at = -1
        self._window = (0.0, 1.0)
        self._ended = threading.Event()

    def expect(self, stages: int | Sequence[tuple[str, float]]) -> None:
        """Take the stages that follow: their number if about equally long, or first word and relative work of each."""
        self._work, self._at = [("", 1.0)] * stages if isinstance(stages, int) else list(stages), -1
        if self._window == (0.0, 1.0):
            self._began, self._share, self._reached = monotonic(), 0.0, 0.0

    def take_part(self, start: float, stop: float) -> None:
        """Take the shares of the command between which the stages that follow lie."""
        self._window = (start, stop)

    def begin(self, words: str) -> None:
        """End the previous stage, and begin a new one; those expected before it are left out."""
        self.stage, self._in_stage, self._stage_began = words, 0.0, monotonic()
        following = range(self._at + 1, len(self._work))
        self._at = next((i for i in following if words.startswith(self._work[i][0])), self._at)
        if self._bar is not None:
            if self._task is None:
                self._task = self._bar.add_task(words, total=None, left="")
            self._show()
            self._bar.refresh()  # else a short stage would not be seen

    def advance(self, done: int, total: int) -> None:
        """Take the progress of the stage; runs side by side may report it out of order."""
        self._in_stage = max(self._in_stage, done / total if total else 0.0)
        self._show()

    def show_on(self, bar: Progress | None) -> None:
        """Show the stages on a bar from now on; None for lines."""
        self._bar, self._task = bar, None

    def _show(self) -> None:
        """Update the bar, if there is one; without a known share it pulses instead of being empty."""
        bar, task = self._bar, self._task  # the bar may end at any time
        if bar is not None and task is not None and not self.is_asking:
            share, left = self.progress()
            words = f"{left:.0f} s left" if share >= KNOWN else ""
            bar.update(task, completed=share, total=1.0 if share else None, left=words, description=self.doing())

    def progress(self) -> tuple[float, float]:
        """Return share and time left [s] of the command, or of the stage where no stages are expected; a share never shrinks."""
        if not self._work:
            share = self._in_stage
            return share, (monotonic() - self._stage_began) * (1.0 - share) / share if share else 0.0
        spent = monotonic() - self._began
        share = self._share_at(self._in_stage)
        if share > self._share:
            self._share, self._reached = share, spent
        if not self._share:
            return 0.0, 0.0
        # While a stage tells no progress, the time counts down to what the stages after it need.
        speed = self._share / self._reached if self._reached else math.inf
        return self._share, max((1.0 - self._share) / speed - (spent - self._reached), (1.0 - self._share_at(1.0)) / speed)

    def _share_at(self, in_stage: float) -> float:
        """Return the share of the command at a share of the present stage."""
        work, at = [part for _, part in self._work], max(self._at, 0)
        start, stop = self._window
        return start + (stop - start) * (sum(work[:at]) + in_stage * work[at]) / sum(work)

    def doing(self) -> str:
        """Return what the command waits for, or its stage."""
        return f"waiting for {self.waits_for}" if self.waits_for else self.stage

    def line(self) -> str:
        """Return command, stage, share and time left, or the time since the command began; the stage is cut where it does not fit."""
        share, left = self.progress()
        end = f", {monotonic() - self._began:.0f} s"
        if 0.0 < share < 1.0:
            end = f", {left:.0f} s left" if share >= KNOWN else end
            end = f", {100.0 * share:.0f} %{'' if self._work else ' of this step'}{end}"
        words, room = ": ".join(filter(None, (self.command, self.doing()))), page_width() - len(end)
        return (words if len(words) <= room else f"{words[: room - 3]}...") + end

    def beat(self) -> None:
        """Print lines until `end`."""
        while not self._ended.wait(INTERVAL):
            with suppress(OSError, ValueError):  # its reader is gone
                if self._bar is not None or self.is_asking:
                    self._show()
                else:
                    sys.stderr.write(self.line() + "\n")
                    sys.stderr.flush()

    def end(self) -> None:
        """Print no further line."""
        self._ended.set()


_running: Stages | None = None


@contextmanager
def _current(stages: Stages) -> Iterator[Stages]:
    """Let stages be those of the command while the block runs."""
    global _running
    before, _running = _running, stages
    try:
        yield stages
    finally:
        _running = before


@contextmanager
def heartbeat(command: str) -> Iterator[None]:
    """Print a line on standard error every two seconds while the block runs, unless ``CONTOURLAB_PROGRESS=0``."""
    if os.environ.get("CONTOURLAB_PROGRESS") == "0":
        yield
        return
    with _current(Stages(command)) as stages:
        thread = threading.Thread(target=stages.beat, daemon=True)
        thread.start()
        try:
            yield
        finally:
            stages.end()
            thread.join()


@contextmanager
def part_of_command(start: float, stop: float) -> Iterator[None]:
    """Count the stages of the block as the shares from `start` to `stop` of the command."""
    if _running is not None:
        _running.take_part(start, stop)
    yield


def begin_stage(words: str) -> None:
    """Show a new stage of the command, if it shows any."""
    if _running is not None:
        _running.begin(words)


def wait_for(what: str) -> None:
    """Show what the work of the command waits for; nothing, if empty."""
    if _running is not None:
        _running.waits_for = what


def told(text: str) -> None:
    """Print a line beside the progress of the command."""
    if _running is not None and _running.command:
        sys.stderr.write(f"{_running.command}: {text}\n")
        sys.stderr.flush()


def asked(question: str) -> bool:
    """Ask at a terminal; return whether the answer is yes. Elsewhere it is no."""
    if not (sys.stdin is not None and sys.stdin.isatty() and sys.stderr.isatty()):
        return False
    stages = _running or Stages()
    stages.is_asking = True
    sys.stderr.write(f"{question} [y/N] ")
    sys.stderr.flush()
    answer = sys.stdin.readline()
    stages.is_asking = False
    return answer.strip().lower() in ("y", "yes")


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
    with _current(_running or Stages()) as stages:
        if not wanted:
            yield stages
            return
        from rich.console import Console as Terminal
        from rich.progress import BarColumn, Progress, SpinnerColumn, TaskProgressColumn, TextColumn, TimeElapsedColumn

        # Brackets in names of schemes are text, not markup.
        text, left = TextColumn("{task.description}", markup=False), TextColumn("{task.fields[left]}", markup=False)
        columns = (SpinnerColumn(), text, BarColumn(), TaskProgressColumn(), TimeElapsedColumn(), left)
        with Progress(*columns, console=console or Terminal(stderr=True), transient=True) as bar:
            stages.show_on(bar)
            try:
                yield stages
            finally:
                stages.show_on(None)
