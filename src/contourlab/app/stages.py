"""Progress of a long run on a terminal: a bar if the total is known, else a clock."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console
    from rich.progress import Progress, TaskID


class Stages:
    """The stages of a run, one after another; without a bar nothing is shown.

    Parameters
    ----------
    bar : rich.progress.Progress, optional
        Shows the stages.
    """

    def __init__(self, bar: Progress | None = None) -> None:
        self._bar = bar
        self._task: TaskID | None = None

    def begin(self, words: str) -> None:
        """End the previous stage, and show a new one with its elapsed time."""
        if self._bar is None:
            return
        if self._task is not None:
            self._bar.remove_task(self._task)
        # Without a total the bar pulses instead of being empty.
        self._task = self._bar.add_task(words, total=None)

    def advance(self, done: int, total: int) -> None:
        """Show the progress of the stage."""
        if self._bar is not None and self._task is not None:
            self._bar.update(self._task, completed=done, total=total)


@contextmanager
def shown(wanted: bool, console: Console | None = None) -> Iterator[Stages]:
    """Show stages on standard error while the block runs, and leave nothing behind.

    Parameters
    ----------
    wanted : bool
        Whether to show anything.
    console : rich.console.Console, optional
        By default standard error.
    """
    if not wanted:
        yield Stages()
        return
    from rich.console import Console as Terminal
    from rich.progress import BarColumn, Progress, SpinnerColumn, TaskProgressColumn, TextColumn, TimeElapsedColumn

    # Brackets in names of schemes are text, not markup.
    columns = (SpinnerColumn(), TextColumn("{task.description}", markup=False), BarColumn(), TaskProgressColumn(), TimeElapsedColumn())
    with Progress(*columns, console=console or Terminal(stderr=True), transient=True) as bar:
        yield Stages(bar)
